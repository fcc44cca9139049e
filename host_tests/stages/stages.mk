# SPDX-License-Identifier: MIT
# build/host/stage_errors: the library and its twin, stage by stage.

STAGES_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/stages/*.c))
HOST_TOOLS += $(BUILD)/host/stage_errors

$(BUILD)/host/objects/stages/%.o: host_tests/stages/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib \
	    -MMD -MP -c $< -o $@

$(BUILD)/host/stage_errors: $(STAGES_OBJECTS) $(BUILD)/host/libreference.a $(call LIB_HOST_NEEDED,$(wildcard host_tests/stages/*.c))
	$(SAY)
	$(HOSTCC) $^ -lm -o $@
