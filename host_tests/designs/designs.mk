# SPDX-License-Identifier: MIT
# build/host/designs: naive 16.16, Fixel and float32 side by side.

DESIGNS_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/designs/*.c))
HOST_TOOLS += $(BUILD)/host/designs

# Contraction and excess precision would make float32 what it is not.
$(BUILD)/host/objects/designs/%.o: host_tests/designs/%.c
	$(MAKE_FOLDER)
	$(HOST_SAY)
	$(HOSTCC) $(WARNINGS) -O2 -ffp-contract=off -Ihost_tests -Ilib/include -MMD -MP -c $< -o $@

$(BUILD)/host/designs: $(DESIGNS_OBJECTS) $(BUILD)/host/libfixel.a
	$(HOST_SAY)
	$(HOSTCC) $^ -lm -o $@
