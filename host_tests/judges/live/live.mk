# SPDX-License-Identifier: MIT
# build/host/live: the reference renderer's frames and what they say of the board's, pose by pose, for the live window.

LIVE_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/live/*.c))
HOST_TOOLS += $(BUILD)/host/live

$(BUILD)/host/objects/judges/live/%.o: host_tests/judges/live/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -MMD -MP -c $< -o $@

$(BUILD)/host/live: $(LIVE_OBJECTS) $(BUILD)/host/objects/judges/frames/read_file.o \
    $(BUILD)/host/objects/judges/frames/moving_reference.o $(BUILD)/host/objects/judges/judge/pixel.o \
    $(BUILD)/host/objects/judges/judge/explain.o $(BUILD)/host/objects/judges/judge/outlined.o \
    $(BUILD)/host/objects/judges/judge/beneath.o $(BUILD)/host/libreference.a \
    $(call LIB_HOST_NEEDED,$(wildcard host_tests/judges/live/*.c) $(addprefix host_tests/judges/,frames/moving_reference.c judge/pixel.c judge/explain.c judge/outlined.c judge/beneath.c))
	$(SAY)
	$(HOSTCC) $^ -lm -o $@
