# SPDX-License-Identifier: MIT
# For each core of the bench, a program that compares the core's kernels with the
# portable ones, which it has under other names: build/equality/<core>.elf, and
# build/equality/<core>-small.elf for the library with -Os -DFXL_SMALL, and
# build/equality/m3-os.elf for the library with -Os, which has kernels of its own. Wants
# bench/bench.mk included first; a core runs where the bench runs it.

EQUALITY_OUT := $(BUILD)/equality
# Which core a program is for, and the names of its library's objects and of their flags.
EQUALITY_KINDS := $(BENCH_CORES_HERE) $(patsubst %,%-small,$(filter m0 m3,$(BENCH_CORES_HERE))) \
    $(patsubst %,%-os,$(filter m3,$(BENCH_CORES_HERE)))
EQUALITY_CORE = $(patsubst %-os,%,$(patsubst %-small,%,$(1)))
EQUALITY_LIB = $(EQUALITY_NAMES:%=$(if $(filter %-small,$(1)),small/,$(if $(filter %-os,$(1)),os/))lib/%)
EQUALITY_FLAGS = $(if $(filter %-small,$(1)),BENCH_CC_SMALL,$(if $(filter %-os,$(1)),BENCH_CC_OS,BENCH_CC))

# What of the library the programs name.
EQUALITY_NAMES := $(call LIB_NEEDED,$(wildcard firmware/equality/*.c))

# The program's own.
EQUALITY_OBJECTS := $(patsubst %.c,%.o,$(notdir $(filter-out %/sides.c,$(wildcard firmware/equality/*.c)))) core.o portable.o

# The portable kernels and their callers are compiled three times, not for each program: for the M0,
# for the M3, whose code every other Arm core executes, and for RISC-V. Which arithmetic is right does
# not depend on the core, nor on whether the other side is small.
EQUALITY_PORTABLE_CORES := m0 m3 $(filter rv32,$(BENCH_CORES_HERE))
EQUALITY_PORTABLE = $(EQUALITY_OUT)/portable/$(or $(filter m0 rv32,$(EQUALITY_CORE)),m3).a
# make coverage-builds reads the table of their lines, in which their files have a folder of their own.
EQUALITY_PORTABLE_CFLAGS := -O2 -UFXL_SMALL -DFXL_PORTABLE_KERNELS $(call LIB_TUNE) -g1 -fdebug-prefix-map=lib/=portable/lib/
# An assertion has its number in the file in place of its line's, so that a comment above does not alter a kernel's hash.
EQUALITY_CFLAGS := -Ifirmware/equality -ffreestanding -DFXL_ASSERT_HOOK -DFXL_ASSERT_LINE=__COUNTER__

# All of these once more, with the portable kernels: fxl_X is portable_X there. No function here
# takes a float, so both calling conventions are one; but the linker mixes only objects that do not
# say which they have.
define EQUALITY_PORTABLE_RULES
$(call LIB_RULES,$(EQUALITY_OUT)/portable/$(1),$$(call FIRMWARE_COMPILE,$(call BENCH_CROSS,$(1))gcc $$(BENCH_FLAGS.$(1)) $$(filter-out -g,$$(BENCH_CFLAGS)) $$(EQUALITY_CFLAGS) $$(EQUALITY_PORTABLE_CFLAGS)),firmware/equality/equality.mk)
$(EQUALITY_OUT)/portable/$(1).a: $(patsubst %,$(EQUALITY_OUT)/portable/$(1)/%.o,$(filter-out $(call LIB_EMPTY,portable-$(1),$(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(EQUALITY_PORTABLE_CFLAGS)),$(EQUALITY_NAMES)))
	@rm -f $$@ $$@.fxl
	@$(call BENCH_CROSS,$(1))ar rcs $$@.fxl $$^
	@$(call BENCH_CROSS,$(1))nm -g --defined-only $$@.fxl | sed -n 's/.* \(fxl_\([a-zA-Z0-9_]*\)\)$$$$/\1 portable_\2/p' > $$@.names
	@$(call BENCH_CROSS,$(1))objcopy --redefine-syms=$$@.names --remove-section=.ARM.attributes $$@.fxl $$@
endef
$(if $(WIDE_GOALS),$(foreach core,$(EQUALITY_PORTABLE_CORES),$(eval $(call EQUALITY_PORTABLE_RULES,$(core)))))

define EQUALITY_RULES
EQUALITY_CC.$(1) := $(filter-out -g,$($(EQUALITY_FLAGS).$(EQUALITY_CORE))) $(EQUALITY_CFLAGS) \
    $(BOARD_LIBC.$(BENCH_BOARD.$(EQUALITY_CORE))) $(if $(findstring =hard,$(BENCH_FLAGS.$(EQUALITY_CORE))),-mgeneral-regs-only)

$(EQUALITY_OUT)/$(1)/core.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $($(EQUALITY_FLAGS)_FAMILY.$(EQUALITY_CORE)) -DSIDE=core_)
$(EQUALITY_OUT)/$(1)/portable.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(EQUALITY_PORTABLE_CFLAGS) -DSIDE=portable_)
$(EQUALITY_OUT)/$(1)/%.o: firmware/equality/%.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $($(EQUALITY_FLAGS)_FAMILY.$(EQUALITY_CORE)))

$(EQUALITY_OUT)/$(1).elf: $(EQUALITY_OBJECTS:%=$(EQUALITY_OUT)/$(1)/%) \
        $(call BENCH_PLACES,$(EQUALITY_CORE),program memory_functions $(EQUALITY_LIB)) \
        $(EQUALITY_PORTABLE) $(call BENCH_PARTS_OF,$(EQUALITY_CORE)) \
        $(call BOARD_LINK_SCRIPTS,$(BENCH_BOARD.$(EQUALITY_CORE))) bench/bench.mk
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(EQUALITY_CORE)) $$(filter %.o %.a,$$^) $$(filter %.a,$$^) -lgcc)
endef
$(if $(WIDE_GOALS),$(foreach kind,$(EQUALITY_KINDS),$(eval $(call EQUALITY_RULES,$(kind)))))

EQUALITY_PROGRAMS := $(EQUALITY_KINDS:%=$(EQUALITY_OUT)/%.elf)
