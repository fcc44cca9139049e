# SPDX-License-Identifier: MIT
# The library: for the host's programs, and for somebody's own firmware.

LIB_SOURCES := $(wildcard lib/src/*.c)
LIB_HEADERS := $(wildcard lib/include/*.h lib/include/fixel/*.h)
LIB_CFLAGS := $(WARNINGS) -ffreestanding -Ilib/include -MMD -MP

# --- build/host/libfixel.a, for the host's programs ---------------------------

LIB_HOST_OBJECTS := $(LIB_SOURCES:lib/src/%.c=$(BUILD)/host/objects/lib/%.o)

$(BUILD)/host/objects/lib/%.o: lib/src/%.c lib/lib.mk
	@mkdir -p $(@D)
	$(HOSTCC) $(LIB_CFLAGS) -O2 -g -c $< -o $@

$(BUILD)/host/libfixel.a: $(LIB_HOST_OBJECTS)
	@rm -f $@
	ar rcs $@ $^

# --- make lib CORE=: build/lib/CORE/{libfixel.a,include/} ---------------------

# CORE is a name that gcc's -mcpu knows, or "host". LIB_FLAGS adds to the flags,
# for firmware with an ABI of its own (say -mfloat-abi=hard -mfpu=fpv4-sp-d16).
LIB_OUT := $(BUILD)/lib/$(CORE)
LIB_FLAGS ?=
LIB_CORE_FLAGS := $(if $(filter host,$(CORE)),,-mcpu=$(CORE) -mthumb)
LIB_CC := $(if $(filter host,$(CORE)),$(HOSTCC),$(CROSS)gcc)
LIB_AR := $(if $(filter host,$(CORE)),ar,$(CROSS)ar)
LIB_OBJECTS := $(LIB_SOURCES:lib/src/%.c=$(LIB_OUT)/objects/%.o)

.PHONY: lib
lib: $(LIB_OUT)/libfixel.a $(LIB_HEADERS:lib/include/%=$(LIB_OUT)/include/%)
	@printf '  %s and %s\n' '$(LIB_OUT)/libfixel.a' '$(LIB_OUT)/include/fixel.h'

# Flags are part of what was built: another choice builds anew.
$(LIB_OUT)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(LIB_CC) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' | cmp -s - $@ || \
	    echo '$(LIB_CC) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' > $@

$(LIB_OUT)/objects/%.o: lib/src/%.c $(LIB_OUT)/flags lib/lib.mk
	@mkdir -p $(@D)
	@printf '  %-4s %s\n' CC $@
	@$(LIB_CC) $(LIB_CFLAGS) -O2 $(LIB_CORE_FLAGS) $(LIB_FLAGS) -ffunction-sections -fdata-sections \
	    -fstack-usage -c $< -o $@

$(LIB_OUT)/libfixel.a: $(LIB_OBJECTS)
	@rm -f $@
	@$(LIB_AR) rcs $@ $^

$(LIB_OUT)/include/%.h: lib/include/%.h
	@mkdir -p $(@D)
	@cp $< $@

-include $(LIB_HOST_OBJECTS:.o=.d) $(LIB_OBJECTS:.o=.d)
