# SPDX-License-Identifier: MIT
# build/host/wire: a scene's frames as wireframes, against the reference renderer's.

WIRE_OBJECTS := $(BUILD)/host/objects/judges/wire/main.o $(BUILD)/host/objects/judges/frames/dump.o \
    $(BUILD)/host/objects/judges/frames/path.o $(BUILD)/host/objects/judges/frames/session.o $(BUILD)/host/objects/judges/frames/read_file.o \
    $(BUILD)/host/objects/judges/frames/moving_reference.o
HOST_TOOLS += $(BUILD)/host/wire

$(BUILD)/host/objects/judges/wire/%.o: host_tests/judges/wire/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -Ifirmware/walk -MMD -MP -c $< -o $@

$(BUILD)/host/wire: $(WIRE_OBJECTS) $(BUILD)/host/libreference.a \
    $(call LIB_HOST_NEEDED,$(addprefix host_tests/judges/,wire/main.c frames/session.c frames/moving_reference.c) firmware/walk/path.c)
	$(SAY)
	$(HOSTCC) $^ -lm -o $@
