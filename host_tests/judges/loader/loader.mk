# SPDX-License-Identifier: MIT
# build/host/loader: what the loader says of many images, for the test of the checker in Python.

# place field: images that all refuse alike
LOADER_OBJECTS := $(addprefix $(BUILD)/host/objects/judges/,loader/main.o loader/rays.o frames/read_file.o raycast/scene_sections.o \
    raycast/file.o)
HOST_TOOLS += $(BUILD)/host/loader

$(BUILD)/host/objects/judges/loader/%.o: host_tests/judges/loader/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -MMD -MP -c $< -o $@

$(BUILD)/host/loader: $(LOADER_OBJECTS) $(BUILD)/host/libfixel.a $(BUILD)/host/libreference.a
	$(SAY)
	$(HOSTCC) $^ -Wl,--wrap=unusable -lm -o $@
