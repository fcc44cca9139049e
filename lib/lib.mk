# SPDX-License-Identifier: MIT
# The library: for the host's programs, and for somebody's own firmware.

LIB_HEADERS := $(wildcard lib/include/*.h lib/include/fixel/*.h)

# Kernels: one contract, a folder for each family of cores. A file there stands
# in for the portable one of the same name; what a family lacks is taken from
# the families that it builds on, and in the end from the portable ones.
LIB_FAMILIES := armv6m:cortex-m0,cortex-m0plus,cortex-m1,cortex-m23 armv7m:cortex-m3 \
    armv7em:cortex-m4,cortex-m7,cortex-m33,cortex-m35p armv81m:cortex-m55,cortex-m85
LIB_BASES.armv7em := armv7m
LIB_BASES.armv81m := armv7em armv7m
comma := ,
LIB_HAS_MVE = $(and $(filter -mfloat-abi=hard -mfloat-abi=softfp,$(1)),$(filter -mcpu=cortex-m55 -mcpu=cortex-m85,$(1)))
# A compiler's flags -> the family of the core that -mcpu names; portable for any other. With an ABI
# that has vectors in registers, which the program then turns on, it is mve+FAMILY where there are any.
LIB_FAMILY = $(if $(call LIB_HAS_MVE,$(1)),mve+)$(or $(strip $(foreach core,$(firstword $(subst +, ,$(patsubst -mcpu=%,%,$(filter -mcpu=%,$(1))))),\
    $(foreach family,$(LIB_FAMILIES),$(if $(findstring $(comma)$(core)$(comma),\
    $(comma)$(lastword $(subst :, ,$(family)))$(comma)),$(firstword $(subst :, ,$(family))))))),portable)

# Every object of the library, whatever the family; its source is the first of
# LIB_PATTERNS that there is: a makefile has a rule for each, in this order. Its
# arguments are a family and a compiler's flags: kernels in assembly are quick and take many
# bytes, so with -DFXL_SMALL (fixel/config.h) there are none.
LIB_NAMES := $(sort $(basename $(notdir $(wildcard lib/src/*.c lib/kernels/portable/*.c))))
LIB_FOLDERS = $(patsubst %,lib/kernels/%,$(foreach family,$(filter-out portable,$(subst +, ,$(1))),\
    $(family) $(LIB_BASES.$(family))) portable) lib/src
LIB_PATTERNS = $(foreach folder,$(call LIB_FOLDERS,$(1)),$(addprefix $(folder)/%,$(sort \
    $(suffix $(wildcard $(folder)/*.c $(if $(filter -DFXL_SMALL,$(2)),,$(folder)/*.S))))))
# The kernels' own loops must not become calls of memset. No code touches a register for
# floating point: nothing here has floats, and what a compiler keeps there costs more than
# the stack. So a Cortex-M4 gets the very code of a Cortex-M3, as which it is scheduled.
# A Cortex-M55's is of more instructions in the larger part of the stages, whatever it is
# scheduled for, so that it gets the Cortex-M3's too. These come after what says the core.
LIB_FAMILY_CFLAGS = $(patsubst %,-I%,$(call LIB_FOLDERS,$(1))) -fno-tree-loop-distribute-patterns \
    $(if $(filter armv7em,$(subst +, ,$(1))),-mtune=cortex-m3 -mgeneral-regs-only) \
    $(if $(filter armv81m,$(subst +, ,$(1))),-mcpu=cortex-m3 -mfpu=fpv4-sp-d16 -mgeneral-regs-only)

LIB_CFLAGS := $(WARNINGS) -ffreestanding -Ilib/include -MMD -MP

# --- build/host/libfixel.a, for the host's programs ---------------------------

LIB_HOST_OBJECTS := $(LIB_NAMES:%=$(BUILD)/host/objects/lib/%.o)

define LIB_HOST_RULE
$(BUILD)/host/objects/lib/%.o: $(1) lib/lib.mk
	@mkdir -p $$(@D)
	$$(HOSTCC) $$(LIB_CFLAGS) $(call LIB_FAMILY_CFLAGS,portable) -O2 -g -c $$< -o $$@
endef
$(foreach pattern,$(call LIB_PATTERNS,portable),$(eval $(call LIB_HOST_RULE,$(pattern))))

$(BUILD)/host/libfixel.a: $(LIB_HOST_OBJECTS)
	@rm -f $@
	ar rcs $@ $^

# --- make lib CORE=: build/lib/CORE/{libfixel.a,include/} ---------------------

# CORE is a name that gcc's -mcpu knows, or "host". LIB_FLAGS adds to the flags,
# for firmware with an ABI of its own (say -mfloat-abi=hard -mfpu=fpv4-sp-d16).
# SIZE=1 asks for few bytes instead of few instructions.
LIB_OUT := $(BUILD)/lib/$(CORE)
LIB_FLAGS ?=
LIB_CORE_FLAGS := $(if $(filter host,$(CORE)),,-mcpu=$(CORE) -mthumb)
LIB_CC := $(if $(filter host,$(CORE)),$(HOSTCC),$(CROSS)gcc)
LIB_AR := $(if $(filter host,$(CORE)),ar,$(CROSS)ar)
LIB_OPTIMISE := $(if $(SIZE),-Os -DFXL_SMALL,-O2)
LIB_KERNELS := $(call LIB_FAMILY,$(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS))
LIB_OBJECTS := $(LIB_NAMES:%=$(LIB_OUT)/objects/%.o)

.PHONY: lib
lib: $(LIB_OUT)/libfixel.a $(LIB_HEADERS:lib/include/%=$(LIB_OUT)/include/%)
	@printf '  %s and %s\n' '$(LIB_OUT)/libfixel.a' '$(LIB_OUT)/include/fixel.h'

# Flags are part of what was built: another choice builds anew.
$(LIB_OUT)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(LIB_CC) $(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' | cmp -s - $@ || \
	    echo '$(LIB_CC) $(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' > $@

define LIB_RULE
$(LIB_OUT)/objects/%.o: $(1) $(LIB_OUT)/flags lib/lib.mk
	@mkdir -p $$(@D)
	@printf '  %-4s %s\n' CC $$@
	@$$(LIB_CC) $$(LIB_CFLAGS) $$(LIB_OPTIMISE) $$(LIB_CORE_FLAGS) $$(LIB_FLAGS) $(call LIB_FAMILY_CFLAGS,$(LIB_KERNELS)) \
	    -ffunction-sections -fdata-sections -fstack-usage -c $$< -o $$@
endef
$(foreach pattern,$(call LIB_PATTERNS,$(LIB_KERNELS),$(LIB_OPTIMISE) $(LIB_FLAGS)),$(eval $(call LIB_RULE,$(pattern))))

$(LIB_OUT)/libfixel.a: $(LIB_OBJECTS)
	@rm -f $@
	@$(LIB_AR) rcs $@ $^

$(LIB_OUT)/include/%.h: lib/include/%.h
	@mkdir -p $(@D)
	@cp $< $@

-include $(LIB_HOST_OBJECTS:.o=.d) $(LIB_OBJECTS:.o=.d)
