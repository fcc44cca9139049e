# SPDX-License-Identifier: MIT
# build/host/loader: what the loader says of many images, for the test of the checker in Python.

LOADER_OBJECTS := $(BUILD)/host/objects/loader/main.o $(BUILD)/host/objects/frames/read_file.o
HOST_TOOLS += $(BUILD)/host/loader

$(BUILD)/host/objects/loader/%.o: host_tests/loader/%.c
	$(MAKE_FOLDER)
	$(HOST_SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ihost_tests -Ilib/include -MMD -MP -c $< -o $@

$(BUILD)/host/loader: $(LOADER_OBJECTS) $(BUILD)/host/libfixel.a
	$(HOST_SAY)
	$(HOSTCC) $^ -o $@
