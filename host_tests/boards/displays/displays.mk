# SPDX-License-Identifier: MIT
# The boards' display drivers on the host, each with a controller at the other
# end of its wires that the test plays.

CMOCK_DIR ?= /usr/share/cmock
DISPLAY_TEST := $(BUILD)/host/displays
DISPLAY_TEST_UNITY := $(CMOCK_DIR)/vendor/unity
DISPLAY_TEST_CFLAGS := $(WARNINGS) -g1 $(RELATIVE_PATHS) -O1 -fsanitize=address,undefined -fno-sanitize-recover=all \
    -Ilib/include -Iboards -I$(DISPLAY_TEST_UNITY)/src

UNITY_TESTS += $(addprefix $(DISPLAY_TEST)/,test_ssd0323 test_ssd0303 test_ports)

$(DISPLAY_TEST)/%_runner.c: host_tests/boards/displays/%.c
	$(MAKE_FOLDER)
	$(SAY)
	ruby -W0 $(DISPLAY_TEST_UNITY)/auto/generate_test_runner.rb $< $@

$(DISPLAY_TEST)/%.o: host_tests/boards/displays/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(DISPLAY_TEST_CFLAGS) -MMD -MP -c $< -o $@

$(DISPLAY_TEST)/%.o: boards/parts/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(DISPLAY_TEST_CFLAGS) -MMD -MP -c $< -o $@

# Generated code, and others': not by our warnings.
$(DISPLAY_TEST)/%_runner.o: $(DISPLAY_TEST)/%_runner.c
	$(SAY)
	$(HOSTCC) $(DISPLAY_TEST_CFLAGS) -w -c $< -o $@

$(DISPLAY_TEST)/unity.o: $(DISPLAY_TEST_UNITY)/src/unity.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(DISPLAY_TEST_CFLAGS) -w -c $< -o $@

$(DISPLAY_TEST)/test_ssd0323: $(addprefix $(DISPLAY_TEST)/,ssd0323.o) $(BUILD)/host/unit/libfixel.a
$(DISPLAY_TEST)/test_ssd0303: $(addprefix $(DISPLAY_TEST)/,ssd0303.o) $(BUILD)/host/unit/libfixel.a
$(DISPLAY_TEST)/test_ports: $(addprefix $(DISPLAY_TEST)/,pl022.o sbcon.o)
$(DISPLAY_TEST)/test_%: $(DISPLAY_TEST)/test_%.o $(DISPLAY_TEST)/test_%_runner.o $(DISPLAY_TEST)/unity.o
	$(SAY)
	$(HOSTCC) $(DISPLAY_TEST_CFLAGS) $^ -o $@

.PRECIOUS: $(DISPLAY_TEST)/%_runner.c $(DISPLAY_TEST)/%.o
