# SPDX-License-Identifier: MIT
# build/host/clipper_errors: the family of clippers against the twin.

CLIPPERS_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/stages/clippers/*.c))
HOST_TOOLS += $(BUILD)/host/clipper_errors

$(BUILD)/host/objects/stages/clippers/%.o: host_tests/stages/clippers/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib \
	    -MMD -MP -c $< -o $@

$(BUILD)/host/clipper_errors: $(CLIPPERS_OBJECTS) \
        $(addprefix $(BUILD)/host/objects/stages/,bridge.o random.o tally.o) \
        $(HOST_LIBRARIES) $(BUILD)/host/libreference.a
	$(SAY)
	$(HOSTCC) $^ -lm -o $@
