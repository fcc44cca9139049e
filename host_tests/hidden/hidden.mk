# SPDX-License-Identifier: MIT
# build/host/hidden: a scene's frames by the methods for hidden surfaces, one against the other.

HIDDEN_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/hidden/*.c)) \
    $(BUILD)/host/objects/hidden/counted_spans.o $(BUILD)/host/objects/hidden/path.o
HOST_TOOLS += $(BUILD)/host/hidden

HIDDEN_CC = $(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ilib/include $(call LIB_FAMILY_CFLAGS,portable) -Ihost_tests/unit \
    -Ifirmware/walk -MMD -MP -c

$(BUILD)/host/objects/hidden/%.o: host_tests/hidden/%.c
	@mkdir -p $(@D)
	$(HOST_SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/objects/hidden/%.o: host_tests/unit/%.c
	@mkdir -p $(@D)
	$(HOST_SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/objects/hidden/%.o: firmware/walk/%.c
	@mkdir -p $(@D)
	$(HOST_SAY)
	$(HIDDEN_CC) $< -o $@

$(BUILD)/host/hidden: $(HIDDEN_OBJECTS) $(BUILD)/host/libfixel.a
	$(HOST_SAY)
	$(HOSTCC) $^ -o $@

-include $(HIDDEN_OBJECTS:.o=.d)
