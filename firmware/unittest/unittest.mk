# SPDX-License-Identifier: MIT
# Unity tests on boards. Each host_tests/unit/test_X.c becomes an object of each core. A board's tests are
# programs $(BOARD_UNITS_FOLDER.<board>)/units-NN.elf, of many files each; programs.py
# finds which files fit the board, and $(BOARD_UNITS.<board>) says it: units.json.
#
# fixel test runs each by fixel.board.unit_tests. On a board a failing TEST_ASSERT ends one test;
# a fault, or a failed assertion of the library, ends the program and counts as one test failed;
# then the program runs once more, from the next file on.

CMOCK_DIR ?= /usr/share/cmock
UNITY_DIR ?= $(CMOCK_DIR)/vendor/unity

# Parts of boards that need no board: tested on all of them, and on the host.
UNIT_PARTS := boards/parts/keys.c

BOARD_TESTS := $(patsubst host_tests/unit/%.c,%,$(wildcard host_tests/unit/test_*.c))
BOARD_TEST_HELPERS := $(filter-out host_tests/unit/test_%,$(wildcard host_tests/unit/*.c))

# Unity asks for setjmp, and tests may print: these programs have a C library. The library in them
# is optimised as a program's; of the tests themselves more is compiled than ever runs, and to
# compile them so, or for a debugger, would take twice the time.
BOARD_TEST_CC = $(filter-out -ffreestanding -O2 -g,$(CORE_CC.$(1))) $(if $(filter -Os,$(CORE_CC.$(1))),,-O1) $(CORE_LIBC.$(1)) -fno-data-sections -Ilib/include -Ilib -Iboards \
    -I$(UNITY_DIR)/src -Ihost_tests/unit -Ifirmware/unittest -DUNITY_INCLUDE_CONFIG_H
# All RAM that is left is their stack (linker/sections.ld).
BOARD_TEST_LINK = $(or $(BOARD_LIBC.$(1)),--specs=nano.specs) -Wl,--defsym=fxl_stack_is_rest=1

# Others' code: not by our warnings.
BOARD_TEST_FOREIGN_CC = $(filter-out -W%,$(BOARD_TEST_CC)) -w

# A runner for each file of tests, for the host too: one Ruby makes all of them.
UNIT_RUNNERS := $(CORE_OUT)/runners
$(UNIT_RUNNERS)/made: $(BOARD_TESTS:%=host_tests/unit/%.c) firmware/unittest/runners.rb
	$(MAKE_FOLDER)
	$(SAY)
	$(FIRMWARE_QUIET)ruby -W0 -I$(UNITY_DIR)/auto firmware/unittest/runners.rb $(@D) $(filter %.c,$^)
	@touch $@
$(BOARD_TESTS:%=$(UNIT_RUNNERS)/%_runner.c): $(UNIT_RUNNERS)/made ;

# The boards of this core have the library with its assertions on, as the host has; those of the
# others have the library that ships.
UNIT_ASSERT_CORE := $(firstword $(filter cpu-cortex-m4%,$(CORES_SHARED)))
# A Cortex-M4 and a Cortex-M55 execute a Cortex-M3's code, and the library's headers ask nothing in which they differ
# (host_tests/build/test_unit_tests.py): their boards link the tests as compiled for the M3, with the library of their own core. $(1): a core's name.
UNIT_CORE = $(subst cortex-m55,cortex-m3,$(subst cortex-m4,cortex-m3,$(1)))
BOARD_UNIT_OUT = $(CORE_OUT)/$(call UNIT_CORE,$(notdir $(BOARD_CORE_OUT)))/unit
# $(1): a core's name.
BOARD_TEST_LIB = $(if $(filter $(UNIT_ASSERT_CORE),$(1)),$(CORE_OUT)/$(1)/unit/lib,$(CORE_OUT)/$(1)/lib)

# main.c sets the memory of tests and helpers anew for each file of tests (linker/sections.ld). Of each
# test file one name is left, so files with the same names share a program.
UNIT_OBJCOPY.libhelpers.a := --rename-section .data=.data.unit --rename-section .bss=.bss.unit
UNIT_OBJCOPY.libtests.a := $(UNIT_OBJCOPY.libhelpers.a) --wildcard --keep-global-symbol='unittest_entry_*'

define CORE_TEST_RULES
$(CORE_OUT)/$(1)/unit/libhelpers.a: $(BOARD_TEST_HELPERS:%.c=$(CORE_OUT)/$(1)/unit/%.o)
$(CORE_OUT)/$(1)/unit/libfixel.a: $(patsubst %,$(BOARD_TEST_LIB)/%.o,$(call CORE_LIB_NAMES,$(1)))
$(CORE_OUT)/$(1)/unit/libtests.a: $(BOARD_TESTS:%=$(CORE_OUT)/$(1)/unit/%.o)
$(addprefix $(CORE_OUT)/$(1)/unit/,libtests.a libhelpers.a libfixel.a):
	$$(MAKE_FOLDER)
	$(FIRMWARE_QUIET)rm -f $$@
	$(FIRMWARE_QUIET)$(CORE_CROSS.$(1))ar rcs $$@ $$^
	$(FIRMWARE_QUIET)$$(if $$(UNIT_OBJCOPY.$$(@F)),$(CORE_CROSS.$(1))objcopy $$(UNIT_OBJCOPY.$$(@F)) $$@)

$(CORE_OUT)/$(1)/unit/%.o: %.c firmware/unittest/unittest.mk
	$$(call FIRMWARE_COMPILE,$$(call BOARD_TEST_CC,$(1)))

$(BOARD_TESTS:%=$(CORE_OUT)/$(1)/unit/%.o): $(CORE_OUT)/$(1)/unit/%.o: firmware/unittest/unit.c host_tests/unit/%.c $(UNIT_RUNNERS)/%_runner.c \
        firmware/unittest/unittest.mk
	$$(call FIRMWARE_COMPILE,$$(call BOARD_TEST_CC,$(1)) -DUNIT_ENTRY=unittest_entry_$$* -DUNIT_NAME='"$$*"' \
	    -DUNIT_TEST='"host_tests/unit/$$*.c"' -DUNIT_RUNNER='"$(UNIT_RUNNERS)/$$*_runner.c"' -iquote .)

$(CORE_OUT)/$(1)/unit/unity.o: $(UNITY_DIR)/src/unity.c firmware/unittest/unittest.mk
	$$(call FIRMWARE_COMPILE,$$(call BOARD_TEST_FOREIGN_CC,$(1)))
endef
$(if $(WIDE_GOALS),$(foreach core,$(CORES_SHARED),$(eval $(call CORE_TEST_RULES,$(core)))))
$(foreach core,$(UNIT_ASSERT_CORE),$(eval $(call LIB_RULES,$(CORE_OUT)/$(core)/unit/lib,\
    $$(call FIRMWARE_COMPILE,$$(filter-out -g,$$(CORE_CC.$(core))) -Ilib/include $$(CORE_TUNE.$(core)) -DFXL_ASSERT_HOOK),firmware/firmware.mk)))

# Of those, what the board is not made of anyway.
BOARD_TEST_PARTS = $(patsubst %.c,$(FIRMWARE_OUT)/$(1)/%.o,$(filter-out $(BOARD_SOURCES.$(1)),$(UNIT_PARTS)))

# What every program links beside the tests. The helpers and the library are archives: to read all
# of their objects for each program would take most of the linker's time.
BOARD_TEST_OBJECTS = $(patsubst %.c,$(BOARD_UNIT_OUT)/%.o,firmware/unittest/main.c firmware/unittest/c_library.c) \
    $(BOARD_UNIT_OUT)/unity.o $(BOARD_PARTS_OF) $(BOARD_TEST_PARTS)
BOARD_TEST_ARCHIVES = $(BOARD_UNIT_OUT)/libhelpers.a $(BOARD_CORE_OUT)/unit/libfixel.a

# $(1): a board, $(2): its archive of tests, $(3): the archives of helpers and library.
BOARD_TEST_PROGRAMS = $(FIRMWARE_QUIET)$(PY) firmware/unittest/programs.py --folder $(@D) --cross $(call CROSS_OF,$(1)) --tests $(2) --archives $(3) \
    -- $(BOARD_LINK) $(BOARD_TEST_LINK) $(filter %.o,$(BOARD_TEST_OBJECTS)) $(2) $(3) -lm -lc -lgcc

# With make test ONLY=, of the files of tests that are chosen alone (UNITS_CHOSEN): their objects, and what they need of the rest.
UNITS_CHOSEN_SOURCES = $(UNITS_CHOSEN:%=host_tests/unit/%.c) $(UNITS_CHOSEN_HELPERS)
UNITS_CHOSEN_HELPERS = $(sort $(foreach test,$(UNITS_CHOSEN),$(UNIT_HELPERS.host_tests/unit/$(test).c:%=host_tests/unit/%.c)))
UNITS_CHOSEN_LIBRARY = $(filter $(call CORE_LIB_NAMES,$(notdir $(BOARD_CORE_OUT))),$(call LIB_NEEDED,$(UNITS_CHOSEN_SOURCES)))

define BOARD_TEST_RULES
BOARD_UNITS_FOLDER.$(1) := $(FIRMWARE_OUT)/$(1)/unit
BOARD_UNITS.$(1) := $(FIRMWARE_OUT)/$(1)/unit/units.json
BOARD_UNITS_CHOSEN.$(1) := $(FIRMWARE_OUT)/$(1)/unit/chosen/units.json

$$(BOARD_UNITS.$(1)): $(BOARD_UNIT_OUT)/libtests.a $(BOARD_TEST_OBJECTS) $(BOARD_TEST_ARCHIVES) $(BOARD_LINK_SCRIPTS) firmware/unittest/programs.py
	$$(MAKE_FOLDER)
	$$(SAY)
	$$(call BOARD_TEST_PROGRAMS,$(1),$$<,$(BOARD_TEST_ARCHIVES))
endef
$(foreach board,$(TARGET_BOARDS),$(eval $(call BOARD_TEST_RULES,$(board))))

# $(1): a board.
CHOSEN_TESTS_OF = $(UNITS_CHOSEN:%=$(BOARD_UNIT_OUT)/%.o)
CHOSEN_HELPERS_OF = $(UNITS_CHOSEN_HELPERS:%.c=$(BOARD_UNIT_OUT)/%.o)
CHOSEN_LIBRARY_OF = $(patsubst %,$(call BOARD_TEST_LIB,$(notdir $(BOARD_CORE_OUT)))/%.o,$(UNITS_CHOSEN_LIBRARY))
# The archives are those of the whole, with fewer members. $(1): a board, $(2): the archive, $(3): its members.
define CHOSEN_ARCHIVE
	$(FIRMWARE_QUIET)$(call CROSS_OF,$(1))ar rcs $$(@D)/$(2) $(3)
	$(if $(UNIT_OBJCOPY.$(2)),$(FIRMWARE_QUIET)$(call CROSS_OF,$(1))objcopy $(UNIT_OBJCOPY.$(2)) $$(@D)/$(2))
endef

define BOARD_CHOSEN_RULES
$(BOARD_UNITS_CHOSEN.$(1)): $(CHOSEN_TESTS_OF) $(CHOSEN_HELPERS_OF) $(CHOSEN_LIBRARY_OF) $(BOARD_TEST_OBJECTS) $(BOARD_LINK_SCRIPTS) FORCE
	$$(MAKE_FOLDER)
	$$(SAY)
	$(FIRMWARE_QUIET)rm -f $$(@D)/*.a
$(call CHOSEN_ARCHIVE,$(1),libtests.a,$(CHOSEN_TESTS_OF))
$(call CHOSEN_ARCHIVE,$(1),libhelpers.a,$(CHOSEN_HELPERS_OF))
$(call CHOSEN_ARCHIVE,$(1),libfixel.a,$(CHOSEN_LIBRARY_OF))
	$$(call BOARD_TEST_PROGRAMS,$(1),$$(@D)/libtests.a,$$(@D)/libhelpers.a $$(@D)/libfixel.a)
endef

# Where no unit test is chosen.
define BOARD_NONE_CHOSEN_RULES
$(BOARD_UNITS_CHOSEN.$(1)): FORCE
	$$(MAKE_FOLDER)
	@echo '{"programs": {}, "left_out": {}}' > $$@
endef
