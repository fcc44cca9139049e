# SPDX-License-Identifier: MIT
# The library: for the host's programs, and for somebody's own firmware.

LIB_HEADERS := $(wildcard lib/include/*.h lib/include/fixel/*.h lib/include/fixel/*/*.h lib/include/fixel/*/*/*.h)

# Every source file, for any core: the files of a kernel ask the compiler which core it is
# for (lib/math/family.h), and of each kernel exactly one has contents. An object is named
# by its source's path below lib/; a makefile has a rule for .c and one for .S. No two sources
# share a name, so another build may put all objects into one folder.
# Those of the study make an archive of their own, libfixel_study.a.
LIB_SOURCES := $(sort $(wildcard lib/*/*.c lib/*/*.S))
LIB_NAMES := $(basename $(LIB_SOURCES:lib/%=%))

# Those that have no contents for a core: the compiler says which, once for a state of the sources. $(1): a name of the core's
# library, under which the answer is kept behind the question, $(2): the compiler and its flags, $(3): flags of C alone. Without
# a whole answer, which has the names of both files, all are compiled. A copy of the project in which a header was changed on
# purpose leaves the conditions as they are, and asks anew.
LIB_CONDITIONS := $(BUILD)/lib_conditions
LIB_EMPTY = $(if $(LIB_EMPTY.$(1)),,$(call LIB_FIND_EMPTY,$(1),$(strip $(2)),$(strip $(3)),$(LIB_CONDITIONS)-$(subst /,-,$(1))))$(LIB_EMPTY.$(1))
LIB_FIND_EMPTY = $(eval LIB_ANSWER := $(if $(LIB_CHANGED),,$(and $(wildcard $(4)),$(file <$(4)))))\
    $(if $(and $(findstring |$(2) $(3)|,$(LIB_ANSWER)),$(call LIB_IS_WHOLE,$(LIB_ANSWER))),,\
    $(eval LIB_ANSWER := |$(2) $(3)| $(call LIB_READ,$(2) $(3),.c) $(call LIB_READ,$(2),.S))\
    $(if $(LIB_CHANGED),,$(if $(call LIB_IS_WHOLE,$(LIB_ANSWER)),$(file >$(4),$(LIB_ANSWER)))))\
    $(eval LIB_EMPTY.$(1) := none $(if $(call LIB_IS_WHOLE,$(LIB_ANSWER)),$(filter-out $(LIB_ANSWER),$(LIB_CONDITIONAL))))
LIB_CHANGED = $(eval LIB_CHANGED := $$(shell find lib -name '*.h' -newer $(LIB_CONDITIONS).mk -print -quit 2>/dev/null))$(LIB_CHANGED)
LIB_IS_WHOLE = $(filter 2,$(words $(filter $(notdir $(LIB_CONDITIONS)).%,$(1))))
LIB_READ = $(if $(wildcard $(LIB_CONDITIONS)$(2)),$(shell $(filter-out -MMD -MP,$(1)) -w -I. -Ilib/include -E -P $(LIB_CONDITIONS)$(2) 2>/dev/null | sed -n 's/^fxl_text_of //p'))
LIB_NAMES_FOR = $(filter-out $(LIB_EMPTY),$(LIB_NAMES))

# Which of them a program needs: lib/needs.py finds it in the sources, once for a state of them. $(1): sources of the
# program, or names of records of the library.
LIB_NEEDED = $(filter $(sort $(foreach source,$(1),$(LIB_NEEDS.$(source)))),$(LIB_NAMES))
LIB_USERS := $(wildcard boards/*/*.c firmware/*/*.c examples/*/*.c bench/firmware/*.c bench/listing/*.c \
    host_tests/judges/*/*.c host_tests/stages/*.c host_tests/stages/*/*.c host_tests/unit/*.c)
$(BUILD)/lib_needs.mk: lib/needs.py $(LIB_SOURCES) $(wildcard lib/*/*.h) $(LIB_HEADERS) $(LIB_USERS)
	$(MAKE_FOLDER)
	@python3 $< $(LIB_SOURCES) -- $(LIB_USERS) > $@.$$$$ && mv $@.$$$$ $@
$(LIB_CONDITIONS).mk: lib/needs.py $(LIB_SOURCES) $(wildcard lib/*/*.h) $(LIB_HEADERS)
	$(MAKE_FOLDER)
	@rm -f $(LIB_CONDITIONS)-*
	@python3 $< --conditions $(@:.mk=) $(LIB_SOURCES)
ifneq ($(filter-out help $(COMMANDS),$(MAKECMDGOALS)),)
include $(LIB_CONDITIONS).mk
include $(BUILD)/lib_needs.mk
endif

# No flag here is needed for a correct library; they save instructions. A kernel's own loop
# must not become a call of memset. No code touches a register for floating point: nothing
# here has floats, and what a compiler keeps there costs more than the stack. So a Cortex-M4
# gets the very code of a Cortex-M3, as which it is scheduled.
LIB_TUNED := cortex-m4 cortex-m7 cortex-m33 cortex-m35p cortex-m55 cortex-m85
# $(1): the compiler's flags that choose the core.
LIB_TUNE = -fno-tree-loop-distribute-patterns \
    $(if $(filter $(LIB_TUNED:%=-mcpu=%) $(LIB_TUNED:%=-mcpu=%+%),$(1)),-mtune=cortex-m3 $(LIB_GENERAL_REGS))
# With this flag the compiler no longer says that a core has vectors, which kernels in assembly ask.
LIB_GENERAL_REGS := -mgeneral-regs-only
%_armv6m.o %_armv7m.o %_mve.o: LIB_GENERAL_REGS :=

LIB_CFLAGS := $(WARNINGS) -ffreestanding -Ilib/include -MMD -MP

# $(1): where the objects go, $(2): the command that compiles, $(3): what they depend on too,
# $(4): what is said before. The source is $<, the object $@.
define LIB_RULES
$(foreach suffix,c S,
$(1)/%.o: lib/%.$(suffix) $(3) lib/lib.mk
	$(4)
	$$(MAKE_FOLDER)
	$(2)
)
endef

# --- build/host/{libfixel.a,libfixel_study.a}, for the host's programs ----------

LIB_HOST_NAMES := $(call LIB_NAMES_FOR,host,$(HOSTCC) -O2)
HOST_LIBRARIES := $(BUILD)/host/libfixel_study.a $(BUILD)/host/libfixel.a

$(eval $(call LIB_RULES,$(BUILD)/host/objects/lib,$$(HOSTCC) $$(LIB_CFLAGS) $$(call LIB_TUNE) -O2 -g1 $$(RELATIVE_PATHS) -c $$< -o $$@,,$$(SAY)))

# What a program of the host links of it. $(1): the sources of the program.
LIB_HOST_NEEDED = $(patsubst %,$(BUILD)/host/objects/lib/%.o,$(filter $(LIB_HOST_NAMES),$(call LIB_NEEDED,$(1))))

$(BUILD)/host/libfixel.a: $(patsubst %,$(BUILD)/host/objects/lib/%.o,$(filter-out study/%,$(LIB_HOST_NAMES)))
$(BUILD)/host/libfixel_study.a: $(patsubst %,$(BUILD)/host/objects/lib/%.o,$(filter study/%,$(LIB_HOST_NAMES)))
$(HOST_LIBRARIES):
	@rm -f $@
	ar rcs $@ $^

# --- make lib CORE=: build/lib/CORE/{libfixel.a,libfixel_study.a,include/} -------

# CORE is one of LIB_CORES; "cortex-" may be left out. It may also be a chip, whose flags are those with which its
# maker's libraries are compiled. LIB_FLAGS adds to the flags,
# for firmware with an ABI of its own (say -mfloat-abi=hard -mfpu=fpv4-sp-d16).
# SIZE=1 asks for few bytes instead of few instructions.
LIB_FLAGS_OF.rp2040    := -mcpu=cortex-m0plus -mthumb
LIB_FLAGS_OF.rp2350    := -mcpu=cortex-m33 -mthumb -mfloat-abi=softfp -mfpu=fpv5-sp-d16
LIB_FLAGS_OF.stm32f103 := -mcpu=cortex-m3 -mthumb
LIB_FLAGS_OF.stm32f4   := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
LIB_FLAGS_OF.nrf52840  := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
LIB_FLAGS_OF.esp32c3   := -march=rv32imc -mabi=ilp32
# The RISC-V cores of an RP2350; docs/packages.md says why without zbs.
LIB_FLAGS_OF.rv32imc_zba_zbb := -march=rv32imc_zba_zbb -mabi=ilp32
LIB_CHIPS := rp2040 rp2350 stm32f103 stm32f4 nrf52840 esp32c3 rv32imc_zba_zbb
LIB_CORES := cortex-m0 cortex-m0plus cortex-m1 cortex-m23 cortex-m3 $(LIB_TUNED) host $(LIB_CHIPS)
LIB_CORE := $(or $(call ONE_OF,$(CORE),$(LIB_CORES)),$(call ONE_OF,cortex-$(CORE),$(LIB_CORES)),unknown)
LIB_OUT := $(BUILD)/lib/$(LIB_CORE)
LIB_FLAGS ?=
LIB_CORE_FLAGS := $(if $(filter host,$(LIB_CORE)),,$(or $(LIB_FLAGS_OF.$(LIB_CORE)),-mcpu=$(LIB_CORE) -mthumb))
# The set-up of its compiler; CROSS names another one.
LIB_SETUP := $(if $(filter -march=rv%,$(LIB_CORE_FLAGS)),lib-riscv,lib)
LIB_CROSS := $(if $(filter lib-riscv,$(LIB_SETUP)),$(or $(filter-out arm-none-eabi-,$(CROSS)),riscv64-unknown-elf-),$(CROSS))
LIB_CC := $(if $(filter host,$(LIB_CORE)),$(HOSTCC),$(LIB_CROSS)gcc)
LIB_AR := $(if $(filter host,$(LIB_CORE)),ar,$(LIB_CROSS)ar)
LIB_OPTIMISE := $(if $(SIZE),-Os -DFXL_SMALL,-O2)

ifneq ($(and $(filter unknown,$(LIB_CORE)),$(filter lib,$(MAKECMDGOALS))),)
$(error CORE=$(CORE) is unknown; the cores are: $(LIB_CORES))
endif
LIB_MADE := $(LIB_OUT)/libfixel.a $(LIB_OUT)/libfixel_study.a $(LIB_HEADERS:lib/include/%=$(LIB_OUT)/include/%)

# Flags are part of what was built: another choice builds anew.
$(LIB_OUT)/flags: FORCE
	$(MAKE_FOLDER)
	@echo '$(LIB_CC) $(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' | cmp -s - $@ || \
	    echo '$(LIB_CC) $(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)' > $@

# Whether the library is compact (fixel/config.h), by the last -O of the flags: C and assembly are told alike.
LIB_COMPACT = -DFXL_COMPACT=$(if $(filter -Os -Oz,$(lastword $(filter -O%,$(1)))),1,0)
LIB_CHOSEN = $(call LIB_COMPACT,$(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)) $(LIB_OPTIMISE) $(LIB_CORE_FLAGS) $(LIB_FLAGS)
LIB_COMPILE = $(LIB_CC) $(LIB_CFLAGS) $(LIB_CHOSEN) $(call LIB_TUNE,$(LIB_CORE_FLAGS)) \
    -ffunction-sections -fdata-sections -fstack-usage -c

$(eval $(call LIB_RULES,$(LIB_OUT)/objects,$$(LIB_COMPILE) $$< -o $$@,$(LIB_OUT)/flags,$$(SAY)))

LIB_OBJECTS := $(if $(filter $(LIB_OUT)/%,$(MAKECMDGOALS)),$(patsubst %,$(LIB_OUT)/objects/%.o,\
    $(call LIB_NAMES_FOR,lib,$(LIB_CC) $(LIB_CHOSEN),$(call LIB_TUNE,$(LIB_CORE_FLAGS)))))
$(LIB_OUT)/libfixel.a: $(filter-out $(LIB_OUT)/objects/study/%,$(LIB_OBJECTS))
$(LIB_OUT)/libfixel_study.a: $(filter $(LIB_OUT)/objects/study/%,$(LIB_OBJECTS))
$(LIB_OUT)/libfixel.a $(LIB_OUT)/libfixel_study.a:
	@rm -f $@
	@$(LIB_AR) rcs $@ $^

$(LIB_OUT)/include/%.h: lib/include/%.h
	$(MAKE_FOLDER)
	@cp $< $@
