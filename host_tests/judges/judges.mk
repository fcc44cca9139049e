# SPDX-License-Identifier: MIT
# The judges: programs of the host that draw, compare and count frames, and what they share.

HOSTAR ?= ar
HOST_TOOLS += $(addprefix $(BUILD)/host/,frames judge live loader oracle predict raycast hidden wire)
JUDGES := $(BUILD)/host/objects/judges
# $(1): a folder of host_tests/judges.
JUDGES_OBJECTS = $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/$(1)/*.c))
# What of the library sources need. $(1): those of host_tests/judges, also by patterns, $(2): others.
JUDGES_LIBRARY = $(call LIB_HOST_NEEDED,$(wildcard $(addprefix host_tests/judges/,$(1))) $(2))

# Contraction would make a product and its sum round once or twice as the compiler likes.
JUDGES_CC = $(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off
JUDGES_SEE = -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -Ifirmware/walk -Ihost_tests/unit

$(JUDGES)/%.o: host_tests/judges/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(JUDGES_CC) $(JUDGES_SEE) -MMD -MP -c $< -o $@

# The reference and the rays see nothing of the library.
$(JUDGES)/reference/%.o $(JUDGES)/raycast/%.o: JUDGES_SEE := -Ihost_tests/judges
# POSIX: threads, and whether stderr is a terminal.
$(JUDGES)/judge/%.o: JUDGES_SEE += -D_POSIX_C_SOURCE=200809L -pthread

# Of other folders: a board's walk along a path, spans that count their pixels, and rotations in long double.
JUDGES_PATH := $(JUDGES)/frames/path.o
$(JUDGES_PATH): firmware/walk/path.c
$(JUDGES)/visibility/painters.o: host_tests/unit/painters.c
$(BUILD)/host/objects/unit/exact_placement.o: host_tests/unit/exact_placement.c
$(JUDGES_PATH) $(JUDGES)/visibility/painters.o $(BUILD)/host/objects/unit/exact_placement.o:
	$(MAKE_FOLDER)
	$(SAY)
	$(JUDGES_CC) $(JUDGES_SEE) -MMD -MP -c $< -o $@

# --- the reference renderer in double, an archive ----------------------------------------------------------------------

REFERENCE_LIBRARY := $(BUILD)/host/libreference.a
$(REFERENCE_LIBRARY): $(call JUDGES_OBJECTS,reference)
	rm -f $@
	$(SAY)
	$(HOSTAR) rcs $@ $^

# --- frames as a dump, by any clipper and any visibility method --------------------------------------------------------

$(BUILD)/host/frames: $(call JUDGES_OBJECTS,frames) $(JUDGES_PATH) $(REFERENCE_LIBRARY) $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $^ -lm -o $@

# A session of drawing as a board has it: of a program that walks a path.
JUDGES_SESSION := $(JUDGES)/frames/session.o $(JUDGES)/frames/input.o $(JUDGES_PATH)
# Instances that move, as the reference has them.
JUDGES_MOVING := $(JUDGES)/frames/moving_reference.o

# --- frames by every visibility method, against each other -------------------------------------------------------------

$(BUILD)/host/hidden: $(call JUDGES_OBJECTS,visibility) $(JUDGES)/visibility/painters.o $(JUDGES_SESSION) $(HOST_LIBRARIES)
	$(SAY)
	$(HOSTCC) $^ -o $@

# --- a board's frames against the reference's --------------------------------------------------------------------------

$(BUILD)/host/judge: $(call JUDGES_OBJECTS,judge) $(JUDGES)/frames/input.o $(JUDGES_MOVING) $(REFERENCE_LIBRARY) \
        $(BUILD)/host/liboracle.a \
        $(call JUDGES_LIBRARY,judge/*.c oracle/tie.c frames/moving_reference.c)
	$(SAY)
	$(HOSTCC) -pthread $^ -lm -o $@

# The same pose by pose, for the live window.
LIVE_JUDGE := judge/explain judge/beneath
$(BUILD)/host/live: $(call JUDGES_OBJECTS,live) $(JUDGES)/frames/input.o $(JUDGES_MOVING) $(LIVE_JUDGE:%=$(JUDGES)/%.o) \
        $(REFERENCE_LIBRARY) $(call JUDGES_LIBRARY,live/*.c frames/moving_reference.c $(LIVE_JUDGE:%=%.c))
	$(SAY)
	$(HOSTCC) $^ -lm -o $@

# Wireframes of a path.
$(BUILD)/host/wire: $(call JUDGES_OBJECTS,wire) $(JUDGES)/frames/dump.o $(JUDGES_SESSION) $(JUDGES_MOVING) $(REFERENCE_LIBRARY) \
        $(call JUDGES_LIBRARY,wire/main.c frames/session.c frames/moving_reference.c,firmware/walk/path.c)
	$(SAY)
	$(HOSTCC) $^ -lm -o $@

# --- how often the library does what, on a path ------------------------------------------------------------------------

# The functions and records that the files wraps*.c put their own in the place of.
PREDICT_WRAPPED = $(shell sed -n 's/^WRAPPED[_A-Z]*.[a-z0-9_ *]*, \(fxl_[a-z0-9_]*\)[^a-z0-9_].*/\1/p' host_tests/judges/predict/wraps*.c)

$(BUILD)/host/predict: $(call JUDGES_OBJECTS,predict) $(JUDGES_SESSION) \
        $(call JUDGES_LIBRARY,predict/*.c frames/session.c,firmware/walk/path.c)
	$(SAY)
	$(HOSTCC) $^ $(PREDICT_WRAPPED:%=-Wl,--wrap=%) -lm -o $@

# --- rays in double, and what the loaders say of an image --------------------------------------------------------------

# An edge must give neighbours opposite answers, bit for bit, which contraction would break too.
RAYCAST_SOURCES := $(wildcard host_tests/judges/raycast/*.c)
$(BUILD)/host/raycast: $(RAYCAST_SOURCES) $(wildcard host_tests/judges/raycast/*.h)
	$(MAKE_FOLDER)
	$(SAY)
	$(JUDGES_CC) $(RAYCAST_SOURCES) -o $@ -lm

# place field: images that all refuse alike
$(BUILD)/host/loader: $(call JUDGES_OBJECTS,loader) $(JUDGES)/frames/input.o $(JUDGES)/raycast/scene_sections.o \
        $(JUDGES)/raycast/file.o $(BUILD)/host/libfixel.a $(REFERENCE_LIBRARY)
	$(SAY)
	$(HOSTCC) $^ -Wl,--wrap=unusable -lm -o $@

# --- exact rational arithmetic, which judges the library and the reference. Needs GMP -----------------------------------

# Its test of a tie, for others.
$(BUILD)/host/liboracle.a: $(JUDGES)/oracle/tie.o
	@rm -f $@
	$(HOSTAR) rcs $@ $^

# The library's records as the reference's; clippers by their names.
ORACLE_BRIDGE := stages/bridge judges/frames/methods
ORACLE_OBJECTS := $(call JUDGES_OBJECTS,oracle) $(BUILD)/host/objects/unit/exact_placement.o \
    $(ORACLE_BRIDGE:%=$(BUILD)/host/objects/%.o)
$(BUILD)/host/oracle: $(ORACLE_OBJECTS) $(REFERENCE_LIBRARY) $(call JUDGES_LIBRARY,oracle/*.c,$(ORACLE_BRIDGE:%=host_tests/%.c))
	$(SAY)
	$(HOSTCC) $^ -lgmp -lm -o $@

# Its own tests.
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
	$(HOSTCC) $(WARNINGS) -O1 -g1 $(RELATIVE_PATHS) -fsanitize=undefined -fno-sanitize-recover=all $(JUDGES_SEE) \
	    -I$(ORACLE_UNIT_UNITY)/src -MMD -MP -c $< -o $@

$(ORACLE_UNIT)/test_%: $(ORACLE_UNIT)/test_%.o $(ORACLE_UNIT)/unity.o $(filter-out %/main.o,$(ORACLE_OBJECTS)) \
        $(HOST_LIBRARIES) $(REFERENCE_LIBRARY)
	$(SAY)
	$(HOSTCC) -fsanitize=undefined $^ -lgmp -lm -o $@

.PRECIOUS: $(ORACLE_UNIT)/test_%.o
