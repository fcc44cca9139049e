# SPDX-License-Identifier: MIT
# For each core of the bench, a program that compares the core's kernels with the
# portable ones, which it has under other names: build/equality/<core>.elf. Wants
# bench/bench.mk included first; a core runs where the bench runs it.

EQUALITY_OUT := $(BUILD)/equality
# What is compiled once more, with the portable kernels, and what it gives to the
# linker: fxl_X becomes portable_X.
EQUALITY_PORTABLE := $(wildcard lib/kernels/portable/*.c) lib/src/divide_wide.c
EQUALITY_RENAMED := scan_next_trapezoid clip_by_view front_faces look_at project_inside fill_trapezoid divide_u64 fraction
EQUALITY_OBJECTS := $(patsubst %.c,%.o,$(notdir $(filter-out %/sides.c,$(wildcard firmware/equality/*.c)))) \
    core.o portable.o $(EQUALITY_PORTABLE:%.c=portable/%.o)
EQUALITY_CORES := $(BENCH_CORES_HERE)

define EQUALITY_RULES
EQUALITY_CC.$(1) := $(BENCH_CC.$(1)) -Ifirmware/equality -ffreestanding -DFXL_ASSERT_HOOK \
    $(if $(findstring =hard,$(BENCH_FLAGS.$(1))),-mgeneral-regs-only)
EQUALITY_PORTABLE_CFLAGS.$(1) := $(call LIB_FAMILY_CFLAGS,portable)

$(EQUALITY_OUT)/$(1)/core.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -DSIDE=core_)
$(EQUALITY_OUT)/$(1)/portable.o: firmware/equality/sides.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(EQUALITY_PORTABLE_CFLAGS.$(1)) -DSIDE=portable_)
$(EQUALITY_OUT)/$(1)/portable/%.o: %.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(EQUALITY_PORTABLE_CFLAGS.$(1)) $(foreach name,$(EQUALITY_RENAMED),-Dfxl_$(name)=portable_$(name)))
$(EQUALITY_OUT)/$(1)/%.o: firmware/equality/%.c firmware/equality/equality.mk
	$$(call FIRMWARE_COMPILE,$$(EQUALITY_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)))

$(EQUALITY_OUT)/$(1).elf: $(EQUALITY_OBJECTS:%=$(EQUALITY_OUT)/$(1)/%) \
        $(patsubst %,$(BENCH_OUT)/$(1)/%.o,start text memory_functions $(BENCH_LIB)) $(call BENCH_PARTS_OF,$(1)) \
        $(call BOARD_LINK_SCRIPTS,$(BENCH_BOARD.$(1))) bench/bench.mk
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(1)) $$(filter %.o,$$^) -lgcc)
endef
$(foreach core,$(EQUALITY_CORES),$(eval $(call EQUALITY_RULES,$(core))))

EQUALITY_PROGRAMS := $(EQUALITY_CORES:%=$(EQUALITY_OUT)/%.elf)

-include $(shell find $(EQUALITY_OUT) -name '*.d' 2>/dev/null)
