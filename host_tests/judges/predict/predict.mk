# SPDX-License-Identifier: MIT
# build/host/predict: walks a scene's path as a board would, and counts what the library does.

PREDICT_OBJECTS := $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/judges/predict/*.c)) \
    $(addprefix $(BUILD)/host/objects/judges/frames/,session.o read_file.o path.o)
HOST_TOOLS += $(BUILD)/host/predict

# The functions and records that the files wraps*.c put their own in the place of.
PREDICT_WRAPPED = $(shell sed -n 's/^WRAPPED[_A-Z]*.[a-z0-9_ *]*, \(fxl_[a-z0-9_]*\)[^a-z0-9_].*/\1/p' host_tests/judges/predict/wraps*.c)

$(BUILD)/host/objects/judges/predict/%.o: host_tests/judges/predict/%.c
	@mkdir -p $(@D)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib -Ilib/include -Ifirmware/walk -MMD -MP -c $< -o $@

$(BUILD)/host/predict: $(PREDICT_OBJECTS) \
    $(call LIB_HOST_NEEDED,$(wildcard host_tests/judges/predict/*.c) host_tests/judges/frames/session.c firmware/walk/path.c)
	$(SAY)
	$(HOSTCC) $^ $(PREDICT_WRAPPED:%=-Wl,--wrap=%) -lm -o $@
