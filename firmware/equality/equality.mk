# SPDX-License-Identifier: MIT
# For each core of the bench, a program that compares the core's kernels with the
# portable ones, which it has under other names: build/equality/<core>.elf, and
# build/equality/<core>-small.elf for the library with -Os -DFXL_SMALL. Wants
# bench/bench.mk included first; a core runs where the bench runs it.

EQUALITY_OUT := $(BUILD)/equality
# Which core a program is for, and where its library and the flags of it are.
EQUALITY_KINDS := $(BENCH_CORES_HERE) $(patsubst %,%-small,$(filter m0 m3,$(BENCH_CORES_HERE)))
EQUALITY_CORE = $(patsubst %-small,%,$(1))
EQUALITY_LIB = $(BENCH_OUT)/$(EQUALITY_CORE)/$(if $(filter %-small,$(1)),os/)
EQUALITY_FLAGS = $(if $(filter %-small,$(1)),BENCH_CC_OS,BENCH_CC)

# The program's own; the list of its tests is another for small.
EQUALITY_OBJECTS := $(patsubst %.c,%.o,$(notdir $(filter-out %/sides.c %/tests.c %/tests_small.c,\
    $(wildcard firmware/equality/*.c)))) core.o portable.o portable.a

define EQUALITY_RULES
EQUALITY_CC.$(1) := $($(EQUALITY_FLAGS).$(EQUALITY_CORE)) -Ifirmware/equality -ffreestanding -DFXL_ASSERT_HOOK \
    $(if $(findstring =hard,$(BENCH_FLAGS.$(EQUALITY_CORE))),-mgeneral-regs-only)
EQUALITY_PORTABLE_CFLAGS.$(1) := -O2 -UFXL_SMALL -DFXL_PORTABLE_KERNELS $(call LIB_TUNE)

$(EQUALITY_OUT)/$(1)/core.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $($(EQUALITY_FLAGS)_FAMILY.$(EQUALITY_CORE)) -DSIDE=core_)
$(EQUALITY_OUT)/$(1)/portable.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(EQUALITY_PORTABLE_CFLAGS.$(1)) -DSIDE=portable_)
$(call LIB_RULES,$(EQUALITY_OUT)/$(1)/portable,$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(EQUALITY_PORTABLE_CFLAGS.$(1))),firmware/equality/equality.mk)
# All of the library once more, with the portable kernels: fxl_X is portable_X there.
$(EQUALITY_OUT)/$(1)/portable.a: $(LIB_NAMES:%=$(EQUALITY_OUT)/$(1)/portable/%.o)
	@rm -f $$@ $$@.fxl
	@$(CROSS)ar rcs $$@.fxl $$^
	@$(CROSS)nm -g --defined-only $$@.fxl | sed -n 's/.* \(fxl_\([a-zA-Z0-9_]*\)\)$$$$/\1 portable_\2/p' > $$@.names
	@$(CROSS)objcopy --redefine-syms=$$@.names $$@.fxl $$@
$(EQUALITY_OUT)/$(1)/%.o: firmware/equality/%.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $($(EQUALITY_FLAGS)_FAMILY.$(EQUALITY_CORE)))

$(EQUALITY_OUT)/$(1).elf: $(EQUALITY_OBJECTS:%=$(EQUALITY_OUT)/$(1)/%) \
        $(EQUALITY_OUT)/$(1)/tests$(if $(filter %-small,$(1)),_small).o \
        $(patsubst %,$(BENCH_OUT)/$(EQUALITY_CORE)/%.o,start text memory_functions) \
        $(LIB_NAMES:%=$(EQUALITY_LIB)lib/%.o) $(call BENCH_PARTS_OF,$(EQUALITY_CORE)) \
        $(call BOARD_LINK_SCRIPTS,$(BENCH_BOARD.$(EQUALITY_CORE))) bench/bench.mk
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(EQUALITY_CORE)) $$(filter %.o %.a,$$^) $$(filter %.a,$$^) -lgcc)
endef
$(foreach kind,$(EQUALITY_KINDS),$(eval $(call EQUALITY_RULES,$(kind))))

EQUALITY_PROGRAMS := $(EQUALITY_KINDS:%=$(EQUALITY_OUT)/%.elf)
