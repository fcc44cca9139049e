# SPDX-License-Identifier: MIT
# Programs that give the library and its twin the same input: build/host/stage_errors, stage by stage; clipper_errors, the
# family of clippers; designs, the stages in naive 16.16 and in float32 beside the library.

STAGES_OBJECTS = $(patsubst host_tests/%.c,$(BUILD)/host/objects/%.o,$(wildcard host_tests/stages/$(1)*.c))
STAGES_SHARED := $(addprefix $(BUILD)/host/objects/stages/,bridge.o random.o tally.o)
STAGES_PROGRAMS := $(addprefix $(BUILD)/host/,stage_errors clipper_errors designs)
HOST_TOOLS += $(STAGES_PROGRAMS)

# Contraction and excess precision would make float32 what it is not.
$(BUILD)/host/objects/stages/%.o: host_tests/stages/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -std=c11 -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib \
	    -MMD -MP -c $< -o $@

# Triangles with surfaces, and what is exact of them.
DESIGNS_ORACLE := $(addprefix $(BUILD)/host/objects/,$(addprefix judges/oracle/,random.o setup.o triangle.o surface_sample.o depth.o) \
    stages/bridge.o)

$(BUILD)/host/stage_errors: $(call STAGES_OBJECTS) $(call LIB_HOST_NEEDED,$(wildcard host_tests/stages/*.c))
$(BUILD)/host/clipper_errors: $(call STAGES_OBJECTS,clippers/) $(STAGES_SHARED) $(HOST_LIBRARIES)
$(BUILD)/host/designs: $(call STAGES_OBJECTS,designs/) $(DESIGNS_ORACLE) \
    $(call LIB_HOST_NEEDED,$(wildcard host_tests/stages/designs/*.c) $(DESIGNS_ORACLE:$(BUILD)/host/objects/%.o=host_tests/%.c))
$(STAGES_PROGRAMS): $(BUILD)/host/objects/judges/frames/input.o $(BUILD)/host/libreference.a
	$(SAY)
	$(HOSTCC) $(filter %.o,$^) $(filter %.a,$^) -lgmp -lm -o $@
