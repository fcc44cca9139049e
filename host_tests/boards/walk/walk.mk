# SPDX-License-Identifier: MIT
# The walk on the host, with a stub by CMock for every board function; and the frame
# dump that boards share.

CMOCK_DIR ?= /usr/share/cmock
WALK_TEST := $(BUILD)/host/walk
WALK_TEST_UNITY := $(CMOCK_DIR)/vendor/unity
WALK_TEST_CONTRACT := $(wildcard boards/contract/*.h)
WALK_TEST_MOCKS := $(WALK_TEST_CONTRACT:boards/contract/%.h=$(WALK_TEST)/mock_%.c)
# Small, so that a small scene takes several bands and can want too much.
WALK_TEST_CFLAGS := $(WARNINGS) -g1 $(RELATIVE_PATHS) -O1 -fsanitize=undefined -fno-sanitize-recover \
    -Ilib/include -Ilib -Iboards -Iboards/contract -Ifirmware/walk -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ihost_tests/boards/walk -I$(WALK_TEST) \
    -I$(CMOCK_DIR)/src -I$(WALK_TEST_UNITY)/src -DWALK_BAND_BYTES=1024 -DWALK_ORDER_ENTRIES=4 -DWALK_LIST_BYTES=100 \
    -DWALK_CACHE_ENTRIES=8
WALK_TEST_OBJECTS := $(addprefix $(WALK_TEST)/,test_walk.o test_path.o test_dump.o test_walk_display.o test_window.o board_double.o scene_bytes.o \
    walk.o plan.o methods.o targets.o act_path.o path.o)

UNITY_TESTS += $(addprefix $(WALK_TEST)/,test_walk test_path test_dump test_walk_display test_window)

$(WALK_TEST)/mock_%.c $(WALK_TEST)/mock_%.h: boards/contract/%.h host_tests/boards/walk/cmock.yml
	$(MAKE_FOLDER)
	$(SAY)
	ruby -W0 $(CMOCK_DIR)/lib/cmock.rb -ohost_tests/boards/walk/cmock.yml --mock_path=$(WALK_TEST) $<

$(WALK_TEST)/%_runner.c: host_tests/boards/walk/%.c
	$(MAKE_FOLDER)
	$(SAY)
	ruby -W0 $(WALK_TEST_UNITY)/auto/generate_test_runner.rb $< $@

$(WALK_TEST_OBJECTS): $(WALK_TEST_MOCKS:.c=.h) host_tests/boards/walk/walk.mk

$(WALK_TEST)/%.o: host_tests/boards/walk/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -MMD -MP -c $< -o $@

$(WALK_TEST)/%.o: firmware/walk/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -MMD -MP -c $< -o $@

$(WALK_TEST)/%.o: boards/parts/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -MMD -MP -c $< -o $@

# Generated code, and others': not by our warnings.
$(WALK_TEST)/mock_%.o: $(WALK_TEST)/mock_%.c
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -w -c $< -o $@

$(WALK_TEST)/%_runner.o: $(WALK_TEST)/%_runner.c $(WALK_TEST_MOCKS:.c=.h)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -w -c $< -o $@

$(WALK_TEST)/unity.o: $(WALK_TEST_UNITY)/src/unity.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -w -c $< -o $@

$(WALK_TEST)/cmock.o: $(CMOCK_DIR)/src/cmock.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -w -c $< -o $@

$(WALK_TEST)/test_walk: $(addprefix $(WALK_TEST)/,test_walk.o test_walk_runner.o board_double.o \
        scene_bytes.o walk.o plan.o methods.o targets.o act_path.o path.o unity.o cmock.o) $(WALK_TEST_MOCKS:.c=.o) $(HOST_LIBRARIES) \
        $(BUILD)/host/libreference.a
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) $^ -Wl,--wrap=fxl_frame_draw -lm -o $@

$(WALK_TEST)/test_path: $(addprefix $(WALK_TEST)/,test_path.o test_path_runner.o scene_bytes.o path.o unity.o) \
        $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) $^ -o $@

$(WALK_TEST)/test_dump: $(addprefix $(WALK_TEST)/,test_dump.o test_dump_runner.o display.o dump.o unity.o) $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) $^ -o $@

$(WALK_TEST)/test_walk_display: $(addprefix $(WALK_TEST)/,test_walk_display.o test_walk_display_runner.o display.o mock_panel.o \
        unity.o cmock.o)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) $^ -o $@

# As BOARD_MEMORY of a board.mk: of this symbol the address is the size.
$(WALK_TEST)/test_window: $(addprefix $(WALK_TEST)/,test_window.o test_window_runner.o window.o mock_system.o \
        unity.o cmock.o)
	$(SAY)
	$(HOSTCC) $(WALK_TEST_CFLAGS) -no-pie -Wl,--defsym=fxl_window_size=65536 $^ -o $@

.PRECIOUS: $(WALK_TEST)/mock_%.c $(WALK_TEST)/mock_%.h $(WALK_TEST)/%_runner.c
