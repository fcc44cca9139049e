# SPDX-License-Identifier: MIT
# The double-precision twin: a host library of its own. It includes nothing of lib/.

HOSTAR ?= ar
REFERENCE_SOURCES := $(wildcard host_tests/judges/reference/*.c)
REFERENCE_OBJECTS := $(REFERENCE_SOURCES:host_tests/%.c=$(BUILD)/host/objects/%.o)
REFERENCE_LIBRARY := $(BUILD)/host/libreference.a
# Contraction would make a product and its sum round once or twice as the compiler likes.
REFERENCE_CFLAGS := -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages

$(BUILD)/host/objects/judges/reference/%.o: host_tests/judges/reference/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) $(REFERENCE_CFLAGS) -MMD -MP -c $< -o $@

$(REFERENCE_LIBRARY): $(REFERENCE_OBJECTS)
	rm -f $@
	$(SAY)
	$(HOSTAR) rcs $@ $^
