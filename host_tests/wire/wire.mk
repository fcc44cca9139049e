# SPDX-License-Identifier: MIT
# build/host/wire: a scene's frames as wireframes, against the reference renderer's.

WIRE_OBJECTS := $(BUILD)/host/objects/wire/main.o $(BUILD)/host/objects/frames/dump.o \
    $(BUILD)/host/objects/frames/path.o $(BUILD)/host/objects/frames/session.o $(BUILD)/host/objects/frames/read_file.o \
    $(BUILD)/host/objects/frames/moving_reference.o
HOST_TOOLS += $(BUILD)/host/wire

$(BUILD)/host/objects/wire/%.o: host_tests/wire/%.c
	$(MAKE_FOLDER)
	$(HOST_SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ilib/include -Ifirmware/walk -MMD -MP -c $< -o $@

$(BUILD)/host/wire: $(WIRE_OBJECTS) $(BUILD)/host/libfixel.a $(BUILD)/host/libreference.a
	$(HOST_SAY)
	$(HOSTCC) $^ -lm -o $@
