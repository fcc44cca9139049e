# SPDX-License-Identifier: MIT
# build/host/frames: a scene's frames by any clipper and any visibility method, as a dump.

FRAMES_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/frames/*.c)) \
    $(BUILD)/host/objects/frames/path.o
HOST_TOOLS += $(BUILD)/host/frames

FRAMES_CC = $(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ihost_tests -Ilib/include -Ifirmware/walk -MMD -MP -c

$(BUILD)/host/objects/frames/%.o: host_tests/frames/%.c
	$(MAKE_FOLDER)
	$(HOST_SAY)
	$(FRAMES_CC) $< -o $@

$(BUILD)/host/objects/frames/path.o: firmware/walk/path.c
	$(MAKE_FOLDER)
	$(HOST_SAY)
	$(FRAMES_CC) $< -o $@

$(BUILD)/host/frames: $(FRAMES_OBJECTS) $(BUILD)/host/libfixel.a
	$(HOST_SAY)
	$(HOSTCC) $^ -o $@
