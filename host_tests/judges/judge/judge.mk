# SPDX-License-Identifier: MIT
# build/host/judge: a board's frames against the reference renderer's.

JUDGE_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/judge/*.c))
HOST_TOOLS += $(BUILD)/host/judge

# POSIX: threads, and whether stderr is a terminal.
$(BUILD)/host/objects/judges/judge/%.o: host_tests/judges/judge/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -D_POSIX_C_SOURCE=200809L -O2 -ffp-contract=off -pthread \
	    -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -MMD -MP -c $< -o $@

$(BUILD)/host/judge: $(JUDGE_OBJECTS) $(BUILD)/host/objects/judges/frames/read_file.o \
        $(BUILD)/host/objects/judges/frames/moving_reference.o $(BUILD)/host/libreference.a \
        $(BUILD)/host/liboracle.a \
        $(call LIB_HOST_NEEDED,$(wildcard host_tests/judges/judge/*.c) $(addprefix host_tests/judges/,oracle/tie.c frames/moving_reference.c))
	$(SAY)
	$(HOSTCC) -pthread $^ -lm -o $@
