# SPDX-License-Identifier: MIT
# build/host/frames: a scene's frames by any clipper and any visibility method, as a dump.

FRAMES_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/frames/*.c)) \
    $(BUILD)/host/objects/judges/frames/path.o
HOST_TOOLS += $(BUILD)/host/frames

FRAMES_CC = $(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -Ifirmware/walk -MMD -MP -c

$(BUILD)/host/objects/judges/frames/%.o: host_tests/judges/frames/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(FRAMES_CC) $< -o $@

$(BUILD)/host/objects/judges/frames/path.o: firmware/walk/path.c
	$(MAKE_FOLDER)
	$(SAY)
	$(FRAMES_CC) $< -o $@

$(BUILD)/host/frames: $(FRAMES_OBJECTS) $(BUILD)/host/libreference.a $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $^ -lm -o $@
