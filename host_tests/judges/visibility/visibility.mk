# SPDX-License-Identifier: MIT
# build/host/hidden: a scene's frames by every visibility method, compared with each other.

HIDDEN_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/visibility/*.c)) \
    $(BUILD)/host/objects/judges/visibility/counted_spans.o $(BUILD)/host/objects/judges/visibility/path.o \
    $(BUILD)/host/objects/judges/frames/session.o $(BUILD)/host/objects/judges/frames/read_file.o
HOST_TOOLS += $(BUILD)/host/hidden

HIDDEN_CC = $(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ilib/include -Ilib -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ihost_tests/unit \
    -Ifirmware/walk -MMD -MP -c

$(BUILD)/host/objects/judges/visibility/%.o: host_tests/judges/visibility/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/objects/judges/visibility/%.o: host_tests/unit/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/objects/judges/visibility/%.o: firmware/walk/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/hidden: $(HIDDEN_OBJECTS) $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $^ -o $@
