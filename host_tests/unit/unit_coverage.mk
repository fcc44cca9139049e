# SPDX-License-Identifier: MIT
# make coverage: the library as it ships, with counters of lines, branches and conditions, under the unit tests
# and the replay of the fuzzer's corpus. Conditions (MC/DC) need Clang 18 or later; plain clang is 14 on Debian 12.

COVERAGE_CLANG := clang-19
COVERAGE_OUT := $(BUILD)/host/coverage
COVERAGE_CFLAGS := $(filter-out $(WARNINGS) -g -f%,$(UNIT_CFLAGS)) -w -fPIC
COVERAGE_COUNTERS := -O1 -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc
COVERAGE_LIBRARY := $(COVERAGE_OUT)/libfixel-coverage.so
COVERAGE_TESTS := $(UNIT_PROGRAMS:$(UNIT_OUT)/%=$(COVERAGE_OUT)/%)
COVERAGE_HELPERS := $(UNIT_HELPER_OBJECTS:$(UNIT_OUT)/%=$(COVERAGE_OUT)/%) $(UNIT_PART_OBJECTS:$(UNIT_OUT)/%=$(COVERAGE_OUT)/%)

$(eval $(call LIB_RULES,$(COVERAGE_OUT)/lib,\
    $$(COVERAGE_CLANG) $$(COVERAGE_CFLAGS) $$(COVERAGE_COUNTERS) -c $$< -o $$@,host_tests/unit/unit_coverage.mk,$$(SAY)))

# One shared library, so that each of its functions is counted once, whichever program calls it.
$(COVERAGE_LIBRARY): $(LIB_HOST_NAMES:%=$(COVERAGE_OUT)/lib/%.o)
	$(SAY)
	$(COVERAGE_CLANG) -shared -fprofile-instr-generate $^ -o $@

define COVERAGE_OBJECTS
$(COVERAGE_OUT)/$(1): $(2)
	$$(MAKE_FOLDER)
	$$(SAY)
	$$(COVERAGE_CLANG) $$(COVERAGE_CFLAGS) $(3) -c $$< -o $$@
endef
$(eval $(call COVERAGE_OBJECTS,parts/%.o,boards/parts/%.c))
$(eval $(call COVERAGE_OBJECTS,assert.o,host_tests/fuzz/assert.c))
$(eval $(call COVERAGE_OBJECTS,fuzz/%.o,host_tests/fuzz/%.c))
$(eval $(call COVERAGE_OBJECTS,%_main.o,$(CORE_OUT)/runners/%_runner.c,-Dunittest_run=main))
$(eval $(call COVERAGE_OBJECTS,unity.o,$(UNITY_DIR)/src/unity.c))
$(eval $(call COVERAGE_OBJECTS,%.o,host_tests/unit/%.c))

$(COVERAGE_OUT)/libhelpers.a: $(COVERAGE_HELPERS)
	@rm -f $@
	ar rcs $@ $^

# The tests find the library beside themselves.
COVERAGE_LINK = $(COVERAGE_CLANG) $^ -Wl,-rpath,'$$ORIGIN' -o $@ -lm

# One test alone, for make coverage ONLY=: with a library of the sources that it links, and no others. $(1): its name.
COVERAGE_OBJECTS_OF = $(patsubst $(UNIT_OUT)/%,$(COVERAGE_OUT)/%,$(call UNIT_OBJECTS_OF,$(1)))
define COVERAGE_ONLY
$(COVERAGE_OUT)/only/$(1)/$(notdir $(COVERAGE_LIBRARY)): $(filter $(COVERAGE_OUT)/lib/%,$(call COVERAGE_OBJECTS_OF,$(1)))
	$$(MAKE_FOLDER)
	$$(SAY)
	$(COVERAGE_CLANG) -shared -fprofile-instr-generate $$^ -o $$@

$(COVERAGE_OUT)/only/$(1)/$(1): $(filter-out $(COVERAGE_OUT)/lib/%,$(call COVERAGE_OBJECTS_OF,$(1))) \
        $(UNIT_PART_OBJECTS:$(UNIT_OUT)/%=$(COVERAGE_OUT)/%) $(COVERAGE_OUT)/only/$(1)/$(notdir $(COVERAGE_LIBRARY))
	$$(SAY)
	$$(COVERAGE_LINK)
endef
$(foreach test,$(filter $(COVERAGE_OUT)/only/%,$(MAKECMDGOALS)),$(eval $(call COVERAGE_ONLY,$(notdir $(test)))))

$(COVERAGE_TESTS): $(COVERAGE_OUT)/test_%: $(COVERAGE_OUT)/test_%.o $(COVERAGE_OUT)/test_%_main.o \
        $(COVERAGE_OUT)/unity.o $(COVERAGE_OUT)/assert.o $(COVERAGE_OUT)/libhelpers.a $(COVERAGE_LIBRARY)
	$(SAY)
	$(COVERAGE_LINK)

define COVERAGE_REPLAY
$(COVERAGE_OUT)/replay_$(1): $(patsubst %,$(COVERAGE_OUT)/fuzz/%.o,replay $(filter-out mutate_scene,$(FUZZ_PARTS_$(1)))) \
        $(COVERAGE_LIBRARY)
	$$(SAY)
	$$(COVERAGE_LINK)
endef
$(foreach target,$(FUZZ_TARGETS),$(eval $(call COVERAGE_REPLAY,$(target))))
