# SPDX-License-Identifier: MIT
# What make clippers runs. Wants bench/bench.mk included first. For each combination of a
# clipper and what hides what (bench/clippers.toml) it makes
#   $(BENCH_OUT)/<core>/clippers/<clipper>-<hidden>.elf       draws a scene, measured
#   $(BENCH_OUT)/<core>/clippers/size/<clipper>-<hidden>.elf  the library with these and nothing else
#   $(BENCH_OUT)/<core>/clippers/operations/<clipper>.elf     draws it, and counts what cutting a polygon takes
#   $(BUILD)/host/comparison/<clipper>-<hidden>               draws it on the host, and measures outlines

CLIPPERS_PLAN := bench/clippers.toml
CLIPPERS_CORES := $(filter m0 m3,$(BENCH_CORES_HERE))
# name:record of each clipper, name:order:target:room of each method: a program for each pair, even for
# those that the plan does not compare.
CLIPPERS_READ = $(shell awk -v kind='[[$(1)]]' '/^\[/ {here = $$0 == kind} \
    here && $$1 == "name" {name = $$3} here && ($$1 == "record" || $$1 == "order") {record = $$3} \
    here && $$1 == "target" {record = record ":" $$3} \
    here && $$1 == "$(2)" {print name ":" record ($$1 == "record" ? "" : ":" $$3)}' $(CLIPPERS_PLAN) | tr -d '"')
CLIPPERS_CLIPPERS = $(eval CLIPPERS_CLIPPERS := $$(call CLIPPERS_READ,clippers,record))$(CLIPPERS_CLIPPERS)
CLIPPERS_HIDDEN = $(eval CLIPPERS_HIDDEN := $$(call CLIPPERS_READ,hidden,room))$(CLIPPERS_HIDDEN)
CLIPPERS_PART = $(word $(2),$(subst :, ,$(1)))
CLIPPERS_NAME = $(call CLIPPERS_PART,$(1),1)-$(call CLIPPERS_PART,$(2),1)
# $(1): a clipper, $(2): what hides what.
CLIPPERS_DEFINES = -DCOMBINATION_CLIPPER=$(call CLIPPERS_PART,$(1),2) \
    -DCOMBINATION_ORDER=$(call CLIPPERS_PART,$(2),2) -DCOMBINATION_TARGET=$(call CLIPPERS_PART,$(2),3) \
    -DCOMBINATION_ROOM=$(call CLIPPERS_PART,$(2),4)u

# What a method wants beside its room: $(1): the core, $(2): what hides what.
CLIPPERS_PREPARE = $(if $(filter tree%,$(call CLIPPERS_PART,$(2),1)),$(BENCH_OUT)/$(1)/prepare_tree.o)

# The plan names the clippers and what hides what.
CLIPPERS_LIB := $(LIB_NAMES:%=lib/%)
CLIPPERS_OBJECTS_OF = $(call BENCH_PLACES,$(1),program memory_functions draw_combination frames path $(CLIPPERS_LIB))
CLIPPERS_ROOTS := combination_chosen fxl_renderer_init_bare_for_polygons_of_32 fxl_renderer_set_clipper fxl_renderer_choose \
    fxl_frame_begin fxl_frame_draw fxl_fill_band
CLIPPERS_SIZED_OF = $(call BENCH_PLACES,$(1),$(CLIPPERS_LIB) memory_functions)
# Found once for all programs of a core: the beginning of each, its parts, and what the linker reads beside.
define CLIPPERS_CORE
CLIPPERS_OBJECTS.$(1) := $(call CLIPPERS_OBJECTS_OF,$(1)) $(call BENCH_PARTS_OF,$(1),fixel) $(call BOARD_LINK_SCRIPTS,$(BENCH_BOARD.$(1)))
CLIPPERS_SIZED.$(1) := $(call CLIPPERS_SIZED_OF,$(1))
endef
$(if $(WIDE_GOALS),$(foreach core,$(CLIPPERS_CORES),$(eval $(call CLIPPERS_CORE,$(core)))))
CLIPPERS_SIZE_LINK = $(CROSS)gcc $(BENCH_FLAGS.$(1)) -nostartfiles -nostdlib \
    -Wl,--gc-sections,--no-warn-rwx-segments,-Map,$(@:.elf=.map),-e,fxl_frame_draw $(CLIPPERS_ROOTS:%=-Wl,-u,%)

# $(1): the core, $(2): a clipper, $(3): what hides what.
define CLIPPERS_PROGRAM_RULES
$(BENCH_OUT)/$(1)/clippers/$(call CLIPPERS_NAME,$(2),$(3)).o: bench/firmware/combination.c $(CLIPPERS_PLAN) bench/clippers.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) $$(BENCH_FAMILY_CFLAGS.$(1)) -ffreestanding $(call CLIPPERS_DEFINES,$(2),$(3)))
$(BENCH_OUT)/$(1)/clippers/$(call CLIPPERS_NAME,$(2),$(3)).elf: $(BENCH_OUT)/$(1)/clippers/$(call CLIPPERS_NAME,$(2),$(3)).o \
        $(call CLIPPERS_PREPARE,$(1),$(3)) $(CLIPPERS_OBJECTS.$(1))
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(1)) $$(filter %.o,$$^) -lgcc)
$(BENCH_OUT)/$(1)/clippers/size/$(call CLIPPERS_NAME,$(2),$(3)).elf: \
        $(BENCH_OUT)/$(1)/clippers/$(call CLIPPERS_NAME,$(2),$(3)).o $(CLIPPERS_SIZED.$(1))
	$$(call FIRMWARE_LINK,$$(call CLIPPERS_SIZE_LINK,$(1)) $$(filter %.o,$$^) -lgcc)

endef
$(if $(WIDE_GOALS),$(foreach core,$(CLIPPERS_CORES),$(foreach clipper,$(CLIPPERS_CLIPPERS),$(foreach hidden,$(CLIPPERS_HIDDEN),\
    $(eval $(call CLIPPERS_PROGRAM_RULES,$(core),$(clipper),$(hidden)))))))

# $(1): the core, $(2): a clipper, with the first of what hides what.
define CLIPPERS_OPERATIONS_RULES
$(BENCH_OUT)/$(1)/clippers/operations/$(call CLIPPERS_PART,$(2),1).elf: $(BENCH_OUT)/$(1)/prepare_operations.o \
        $(BENCH_OUT)/$(1)/clippers/$(call CLIPPERS_NAME,$(2),$(firstword $(CLIPPERS_HIDDEN))).o \
        $(CLIPPERS_OBJECTS.$(1))
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(1)) $$(filter %.o,$$^) -lgcc)

endef
$(if $(WIDE_GOALS),$(foreach core,$(CLIPPERS_CORES),$(foreach clipper,$(CLIPPERS_CLIPPERS),\
    $(eval $(call CLIPPERS_OPERATIONS_RULES,$(core),$(clipper))))))

# --- the host ----------------------------------------------------------------------

COMPARISON_OUT := $(BUILD)/host/comparison
COMPARISON_OBJECTS := $(patsubst host_tests/stages/comparison/%.c,$(COMPARISON_OUT)/%.o,$(wildcard host_tests/stages/comparison/*.c)) \
    $(addprefix $(BUILD)/host/objects/,stages/clippers/case.o stages/bridge.o \
        judges/frames/dump.o judges/frames/path.o judges/frames/input.o judges/frames/session.o)
COMPARISON_CC := $(HOSTCC) $(WARNINGS) -O2 -ffp-contract=off -Ihost_tests -Ihost_tests/judges -Ihost_tests/stages -Ilib/include -Ilib -Iboards -Ibench/firmware \
    -Ifirmware/walk -MMD -MP

$(COMPARISON_OUT)/%.o: host_tests/stages/comparison/%.c
	$(MAKE_FOLDER)
	$(SAY)
	$(COMPARISON_CC) -c $< -o $@

# $(1): a clipper, $(2): what hides what.
define COMPARISON_RULES
$(COMPARISON_OUT)/$(call CLIPPERS_NAME,$(1),$(2)).chosen.o: bench/firmware/combination.c $(CLIPPERS_PLAN)
	$$(MAKE_FOLDER)
	$$(SAY)
	$$(COMPARISON_CC) $(call CLIPPERS_DEFINES,$(1),$(2)) -c $$< -o $$@
$(COMPARISON_OUT)/$(call CLIPPERS_NAME,$(1),$(2)): $(COMPARISON_OUT)/$(call CLIPPERS_NAME,$(1),$(2)).chosen.o \
        $(COMPARISON_OBJECTS) $(HOST_LIBRARIES) $(BUILD)/host/libreference.a
	$$(SAY)
	$$(HOSTCC) $$(filter-out %.mk,$$^) -lm -o $$@

endef
$(if $(WIDE_GOALS),$(foreach clipper,$(CLIPPERS_CLIPPERS),$(foreach hidden,$(CLIPPERS_HIDDEN),\
    $(eval $(call COMPARISON_RULES,$(clipper),$(hidden))))))

# What ONLY= names of the words $(1); all of them if it names none.
CLIPPERS_ONLY = $(or $(strip $(foreach word,$(subst $(,), ,$(ONLY)),$(call ONE_OF,$(word),$(1)))),$(1))
CLIPPERS_NAMED = $(call CLIPPERS_ONLY,$(foreach entry,$(1),$(call CLIPPERS_PART,$(entry),1)))
CLIPPERS_CHOSEN = $(foreach clipper,$(call CLIPPERS_NAMED,$(CLIPPERS_CLIPPERS)),$(foreach hidden,$(call CLIPPERS_NAMED,$(CLIPPERS_HIDDEN)),\
    $(clipper)-$(hidden)))
CLIPPERS_BUILT = $(BENCH_COUNTER) $(CLIPPERS_CHOSEN:%=$(COMPARISON_OUT)/%) $(BUILD)/host/judge $(foreach core,$(call CLIPPERS_ONLY,$(CLIPPERS_CORES)),\
    $(CLIPPERS_CHOSEN:%=$(BENCH_OUT)/$(core)/clippers/%.elf) \
    $(CLIPPERS_CHOSEN:%=$(BENCH_OUT)/$(core)/clippers/size/%.elf) \
    $(patsubst %,$(BENCH_OUT)/$(core)/clippers/operations/%.elf,$(call CLIPPERS_NAMED,$(CLIPPERS_CLIPPERS))))
# What the tests run.
CLIPPERS_SAMPLE := view-sorted view-spans triangles-sorted triangles-spans
CLIPPERS_TESTED := $(CLIPPERS_SAMPLE:%=$(COMPARISON_OUT)/%) $(COMPARISON_OUT)/world-sorted $(if $(filter m3,$(CLIPPERS_CORES)),\
    $(CLIPPERS_SAMPLE:%=$(BENCH_OUT)/m3/clippers/%.elf) $(CLIPPERS_SAMPLE:%=$(BENCH_OUT)/m3/clippers/size/%.elf) \
    $(addprefix $(BENCH_OUT)/m3/clippers/operations/,view.elf triangles.elf))
