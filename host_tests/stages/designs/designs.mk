# SPDX-License-Identifier: MIT
# build/host/designs: naive 16.16, Fixel and float32 side by side.

DESIGNS_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/stages/designs/*.c))
HOST_TOOLS += $(BUILD)/host/designs

# Contraction and excess precision would make float32 what it is not.
$(BUILD)/host/objects/stages/designs/%.o: host_tests/stages/designs/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -MMD -MP -c $< -o $@

# Triangles with surfaces, and what is exact of them.
DESIGNS_ORACLE := $(addprefix $(BUILD)/host/objects/,$(addprefix judges/oracle/,random.o setup.o triangle.o \
    surface_sample.o depth.o) stages/bridge.o)

$(BUILD)/host/designs: $(DESIGNS_OBJECTS) $(DESIGNS_ORACLE) $(BUILD)/host/libreference.a \
        $(call LIB_HOST_NEEDED,$(wildcard host_tests/stages/designs/*.c) $(DESIGNS_ORACLE:$(BUILD)/host/objects/%.o=host_tests/%.c))
	$(SAY)
	$(HOSTCC) $^ -lgmp -lm -o $@
