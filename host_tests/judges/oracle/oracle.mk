# SPDX-License-Identifier: MIT
# build/host/oracle: exact rational arithmetic that judges the library and its
# twin. build/host/liboracle.a: its tie test, for others. Needs GMP.

ORACLE_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/oracle/*.c))
ORACLE_LIBRARY := $(BUILD)/host/liboracle.a
# The library's records as the twin's; clippers by their names.
ORACLE_BRIDGE := $(BUILD)/host/objects/stages/bridge.o $(BUILD)/host/objects/judges/frames/methods.o
HOST_TOOLS += $(BUILD)/host/oracle

$(BUILD)/host/objects/judges/oracle/%.o: host_tests/judges/oracle/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib -Ilib/include \
	    -MMD -MP -c $< -o $@

$(ORACLE_LIBRARY): $(BUILD)/host/objects/judges/oracle/tie.o
	@rm -f $@
	ar rcs $@ $^

# Rotations in long double, as the unit tests have them.
ORACLE_PLACEMENTS := $(BUILD)/host/objects/unit/exact_placement.o
ORACLE_OBJECTS += $(ORACLE_PLACEMENTS)

$(ORACLE_PLACEMENTS): $(BUILD)/host/objects/%.o: host_tests/%.c
	@mkdir -p $(@D)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ilib/include -Ilib -MMD -MP -c $< -o $@

$(BUILD)/host/oracle: $(ORACLE_OBJECTS) $(ORACLE_BRIDGE) \
        $(BUILD)/host/libreference.a $(call LIB_HOST_NEEDED,$(wildcard host_tests/judges/oracle/*.c) $(ORACLE_BRIDGE:$(BUILD)/host/objects/%.o=host_tests/%.c))
	$(SAY)
	$(HOSTCC) $^ -lgmp -lm -o $@

# --- the oracle's own tests ----------------------------------------------------

ORACLE_UNIT := $(BUILD)/host/oracle_unit
ORACLE_UNIT_UNITY := $(or $(CMOCK_DIR),/usr/share/cmock)/vendor/unity
UNITY_TESTS += $(ORACLE_UNIT)/test_tie $(ORACLE_UNIT)/test_exact

$(ORACLE_UNIT)/unity.o: $(ORACLE_UNIT_UNITY)/src/unity.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) -std=c11 -O1 -w -c $< -o $@

$(ORACLE_UNIT)/test_%.o: host_tests/judges/oracle/unit/test_%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O1 -g1 $(RELATIVE_PATHS) -fsanitize=undefined -fno-sanitize-recover=all -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages \
	    -Ilib/include -Ilib -I$(ORACLE_UNIT_UNITY)/src -MMD -MP -c $< -o $@

$(ORACLE_UNIT)/test_%: $(ORACLE_UNIT)/test_%.o $(ORACLE_UNIT)/unity.o \
        $(filter-out %/main.o,$(ORACLE_OBJECTS)) $(ORACLE_BRIDGE) $(HOST_LIBRARIES) \
        $(BUILD)/host/libreference.a
	$(SAY)
	$(HOSTCC) -fsanitize=undefined $^ -lgmp -lm -o $@

.PRECIOUS: $(ORACLE_UNIT)/test_%.o
