# SPDX-License-Identifier: MIT
# Fuzz targets: with libFuzzer and the sanitizers (make fuzz), and as plain
# programs that replay files: once with GCC's sanitizers (make test), and once
# to count the branches (both).

FUZZ_TARGETS := scene pipeline
FUZZ_OUT := $(BUILD)/host/fuzz

# The newest clang there is. Looked for only when something needs it.
FUZZ_CLANG = $(eval FUZZ_CLANG := $$(shell for name in clang-19 clang-18 clang-17 clang-16 clang-15 \
    clang-14 clang; do command -v $$$$name && break; done))$(FUZZ_CLANG)

FUZZ_SANITIZERS := -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=all
FUZZ_CFLAGS := -std=c11 -g1 $(RELATIVE_PATHS) -Ilib/include -Ilib -MMD -MP
# No silent wrap: in the library an unsigned one counts too, but where it is meant.
FUZZ_WRAPS := -fsanitize=unsigned-integer-overflow -fsanitize-ignorelist=host_tests/fuzz/wraps.txt

FUZZ_SHARED := $(filter-out fuzz_scene fuzz_pipeline replay,$(basename $(notdir $(wildcard host_tests/fuzz/*.c))))
FUZZ_PARTS_scene := fuzz_scene $(FUZZ_SHARED)
FUZZ_PARTS_pipeline := fuzz_pipeline $(FUZZ_SHARED)
FUZZ_LIB := $(LIB_HOST_NAMES)

# --- libFuzzer, sanitizers, the library's assertions ---------------------------

$(eval $(call LIB_RULES,$(FUZZ_OUT)/asan/lib,\
    $$(FUZZ_CLANG) $$(FUZZ_CFLAGS) -O1 $$(FUZZ_SANITIZERS) $$(FUZZ_WRAPS) -DFXL_ASSERT_HOOK -c $$< -o $$@,\
    host_tests/fuzz/wraps.txt host_tests/fuzz/fuzz.mk,$$(SAY)))

$(FUZZ_OUT)/asan/%.o: host_tests/fuzz/%.c host_tests/fuzz/fuzz.mk
	$(MAKE_FOLDER)
	$(SAY)
	$(FUZZ_CLANG) $(FUZZ_CFLAGS) -O1 $(FUZZ_SANITIZERS) -c $< -o $@

# --- replay --------------------------------------------------------------------

# With the library of the unit tests, which has the same sanitizers and its assertions on.
FUZZ_REPLAY_CFLAGS := $(WARNINGS) -g1 $(RELATIVE_PATHS) -O1 -fsanitize=address,undefined -fno-sanitize-recover=all \
    -Ilib/include -Ilib -MMD -MP

$(FUZZ_OUT)/replay/%.o: host_tests/fuzz/%.c host_tests/fuzz/fuzz.mk
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(FUZZ_REPLAY_CFLAGS) -c $< -o $@

# --- replay that counts branches, of the library as it is shipped --------------

FUZZ_BRANCHES_CFLAGS := $(WARNINGS) -O0 --coverage -Ilib/include -Ilib -MMD -MP

$(eval $(call LIB_RULES,$(FUZZ_OUT)/branches/lib,\
    $$(HOSTCC) $$(FUZZ_BRANCHES_CFLAGS) -c $$< -o $$@,host_tests/fuzz/fuzz.mk,$$(SAY)))

$(FUZZ_OUT)/branches/%.o: host_tests/fuzz/%.c host_tests/fuzz/fuzz.mk
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O1 -Ilib/include -Ilib -MMD -MP -c $< -o $@

define FUZZ_PROGRAM
$(FUZZ_OUT)/fuzz_$(1): $(FUZZ_PARTS_$(1):%=$(FUZZ_OUT)/asan/%.o) $(FUZZ_LIB:%=$(FUZZ_OUT)/asan/lib/%.o)
	$$(SAY)
	$$(FUZZ_CLANG) -fsanitize=address,undefined,fuzzer $$^ -o $$@

FUZZ_REPLAY_OBJECTS_$(1) := $(patsubst %,$(FUZZ_OUT)/replay/%.o,replay $(FUZZ_PARTS_$(1)))
$(FUZZ_OUT)/replay_$(1): $$(FUZZ_REPLAY_OBJECTS_$(1)) $(BUILD)/host/unit/libfixel.a
	$$(SAY)
	$$(HOSTCC) -fsanitize=address,undefined $$^ -o $$@

$(FUZZ_OUT)/branches_$(1): $(patsubst %,$(FUZZ_OUT)/branches/%.o,replay $(FUZZ_PARTS_$(1))) \
        $(FUZZ_LIB:%=$(FUZZ_OUT)/branches/lib/%.o)
	$$(SAY)
	$$(HOSTCC) --coverage $$^ -o $$@
endef
$(foreach target,$(FUZZ_TARGETS),$(eval $(call FUZZ_PROGRAM,$(target))))

# --- the tools' input ------------------------------------------------------------

# make test has a fixed seed and few examples; here are ten times as many, and another seed with each RUNS=.
FUZZ_TOOLS_EXAMPLES := 1500

FUZZ_PROGRAMS := $(foreach target,$(FUZZ_TARGETS),$(FUZZ_OUT)/fuzz_$(target) $(FUZZ_OUT)/branches_$(target))
HOST_TOOLS += $(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/branches_%)
