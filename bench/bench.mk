# SPDX-License-Identifier: MIT
# What make bench and make profile run. Wants firmware/firmware.mk included
# first. A board.mk that sets BOARD_BENCH says which of the bench's cores its
# board stands for; a core that no board stands for is left out, aloud.
#
# Makes $(BENCH_COUNTER), the counting plugin, and for each core, under
# build/bench/<core>/, the programs of BENCH_PROGRAMS_OF.

BENCH_OUT := $(BUILD)/bench
BENCH_CORES := m0 m3 m4f m55
# Of a board whose tools make test does not install: make bench has it where they are, make profile and make equality too.
BENCH_EXTRA := rv32
$(foreach board,$(BOARDS),$(foreach core,$(BOARD_BENCH.$(board)),$(eval BENCH_BOARD.$(core) := $(board))))
BENCH_CORES_HERE := $(foreach core,$(BENCH_CORES) $(BENCH_EXTRA),$(if $(BENCH_BOARD.$(core)),$(core)))

# What is measured is compiled for a core as its users would: with all that it
# has, but for misaligned access, which the boards trap. No emulated board with
# an M0 has the memory, but any other runs Armv6-M.
BENCH_FLAGS.m0 := -mcpu=cortex-m0 -mthumb -mfloat-abi=soft
BENCH_FLAGS.m3 := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BENCH_FLAGS.m4f := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 -mno-unaligned-access
BENCH_FLAGS.m55 := -mcpu=cortex-m55 -mthumb -mfloat-abi=hard -mno-unaligned-access
BENCH_FLAGS.rv32 := $(BOARD_CORE.rv32)
BENCH_CROSS = $(call CROSS_OF,$(BENCH_BOARD.$(1)))

# Their board has the memory for a larger screen.
BENCH_SCREEN.m0 := "-DDRAW_PIXELS_MAX=(480u * 320u)"
BENCH_SCREEN.m3 := $(BENCH_SCREEN.m0)
BENCH_SCREEN.rv32 := $(BENCH_SCREEN.m0)
# 512 KiB of RAM: scenes of at most 8,191 faces a model.
BENCH_ORDER.m55 := -DORDER_ENTRIES=8192u

BENCH_OPTIMISE := -O2
BENCH_SMALL := -Os -DFXL_SMALL
BENCH_CFLAGS := $(WARNINGS) -Wdouble-promotion -g -ffunction-sections -fdata-sections -fstack-usage \
    -Ilib/include -Ilib -Iboards -Ifirmware/walk -Ibench/firmware -Ibench/listing -MMD -MP

# --- the plugin ------------------------------------------------------------------

BENCH_COUNTER := $(BUILD)/host/bench_counter.so

$(BENCH_COUNTER): $(wildcard bench/plugin/*.[ch])
	$(MAKE_FOLDER)
	$(SAY)
	$(HOSTCC) $(WARNINGS) -O2 -fPIC -shared -fvisibility=hidden $(filter %.c,$^) -o $@

# --- programs --------------------------------------------------------------------

# The program's own objects, beside those of program.c, which all have. A program
# has the memory functions that firmware has, compiled for its core as all that
# is measured, or those of the C library.
# The tool of make bench names them. A core has those that are measured on it: the listing and kernels on the four cores; what the library
# is built as otherwise, and whole frames as pixels of RGB565, where the board has the memory.
BENCH_PROGRAMS := calibration fixel fixel-bands fixel-target listing-double listing-float memset kernels
BENCH_PROGRAMS_WIDE := fixel-rgb565 fixel-native fixel-arduino fixel-one-file fixel-native-arduino fixel-native-one-file
BENCH_PROGRAMS_OF = $(if $(filter $(BENCH_EXTRA),$(1)),fixel fixel-target,$(BENCH_PROGRAMS)) \
    $(if $(BENCH_SCREEN.$(1)),$(BENCH_PROGRAMS_WIDE) $(if $(filter $(BENCH_EXTRA),$(1)),,fixel-os fixel-small fixel-rgb565-bands fixel-native-bands)) \
    $(if $(filter m0 m3,$(1)),fixel-native-without-tiny) $(if $(filter m3,$(1)),fixel-cleared)
BENCH_NEEDED := $(call LIB_NEEDED,$(wildcard bench/firmware/*.c bench/listing/*.c) $(addprefix firmware/walk/,path.c plan.c) \
    $(foreach core,$(BENCH_CORES_HERE),$(BOARD_SOURCES.$(BENCH_BOARD.$(core)))))
BENCH_LIB := $(BENCH_NEEDED:%=lib/%)
BENCH_FRAMES := frames path $(BENCH_LIB)
# What draws frames alone takes of it: the library built otherwise is no more than that.
BENCH_DRAWN := $(call LIB_NEEDED,$(addprefix bench/firmware/,draw_fixel.c frames.c program.c) $(addprefix firmware/walk/,path.c plan.c) \
    $(foreach core,$(BENCH_CORES_HERE),$(BOARD_SOURCES.$(BENCH_BOARD.$(core)))))
BENCH_OBJECTS.calibration := calibration
BENCH_OBJECTS.fixel := draw_fixel plan $(BENCH_FRAMES)
# The library by -Os; for few bytes, as make lib SIZE=1 makes it; as Arduino compiles its package; as one file; in bands, with the memory of a
# small board; with each frame converted.
BENCH_OBJECTS.fixel-os := draw_fixel plan frames path $(BENCH_DRAWN:%=os/lib/%)
BENCH_OBJECTS.fixel-small := draw_fixel plan frames path $(BENCH_DRAWN:%=small/lib/%)
BENCH_OBJECTS.fixel-arduino := draw_fixel plan frames path $(BENCH_DRAWN:%=arduino/lib/%)
BENCH_OBJECTS.fixel-one-file := draw_fixel plan frames path one-file/fixel
BENCH_OBJECTS.fixel-native-arduino := $(BENCH_OBJECTS.fixel-arduino:draw_fixel=native/draw_fixel)
BENCH_OBJECTS.fixel-native-one-file := $(BENCH_OBJECTS.fixel-one-file:draw_fixel=native/draw_fixel)
# Without the way of tiny faces, beside which rows of the bench set it: the target that they are drawn to, compiled by itself.
BENCH_TINY_TARGET := draw/target_rgb565_depth_16
BENCH_OBJECTS.fixel-native-without-tiny := native/draw_fixel plan frames path without_tiny $(patsubst %,lib/%,$(filter-out $(BENCH_TINY_TARGET),$(BENCH_DRAWN)))
BENCH_OBJECTS.fixel-bands := draw_bands $(BENCH_FRAMES)
BENCH_OBJECTS.fixel-rgb565 := draw_rgb565 plan $(BENCH_FRAMES)
# Into RGB565 itself: the scene's image must ask for 16 bits a pixel.
BENCH_OBJECTS.fixel-native := native/draw_fixel plan $(BENCH_FRAMES)
# Both in bands of eight rows, as a board draws that sends one band while it draws the next.
BENCH_OBJECTS.fixel-rgb565-bands := bands/draw_rgb565 plan $(BENCH_FRAMES)
BENCH_OBJECTS.fixel-native-bands := native-bands/draw_fixel plan $(BENCH_FRAMES)
BENCH_BANDS := -DDRAW_BAND_ROWS=8u -DDRAW_LIST_WORDS=8192u
BENCH_DRAWS.native := -DDRAW_RGB565
# With the clear, or the horizon in its place.
BENCH_OBJECTS.fixel-cleared := cleared/draw_fixel plan $(BENCH_FRAMES)
BENCH_DRAWS.cleared := -DDRAW_CLEARED
BENCH_DRAWS.bands := $(BENCH_BANDS)
BENCH_DRAWS.native-bands := -DDRAW_RGB565 $(BENCH_BANDS)
# As PIXELS=, ORDER= and DEPTH= ask for: a program of make costs with what 512 KiB of RAM hold. Its band is the frame, and
# a depth buffer holds some 100 rows of it.
BENCH_OBJECTS.fixel-target = target/draw_costs $(COSTS_WALK) frames $(COSTS_LIB)
# What the table of docs/extras/combinations.md has, on each core: host_tests/judges/test_combinations.py runs it, and
# no bench does. Two more have the library for few bytes.
CELLS_OF = cells target/draw_costs $(COSTS_WALK)
BENCH_OBJECTS.cells = $(CELLS_OF) $(COSTS_LIB)
BENCH_OBJECTS.cells-small = $(CELLS_OF) $(COSTS_LIB:%=small/%)
CELLS_KINDS := $(foreach core,m0 m3 m55,$(filter $(core),$(BENCH_CORES_HERE))/cells) \
    $(foreach core,m0 m3,$(filter $(core),$(BENCH_CORES_HERE))/cells-small)
CELLS_PROGRAMS := $(patsubst %,$(BENCH_OUT)/%.elf,$(filter-out /%,$(CELLS_KINDS)))
BENCH_OBJECTS.listing-double := double/draw_listing double/listing $(BENCH_FRAMES)
BENCH_OBJECTS.listing-float := float/draw_listing float/listing $(BENCH_FRAMES)
BENCH_OBJECTS.memset := draw_memset $(BENCH_FRAMES)
BENCH_OBJECTS.kernels := kernels kernel_inputs kernel_list kernel_depth kernel_surfaces limit_list $(BENCH_LIB)
BENCH_C_LIBRARY := listing-double listing-float memset

# What programs have of the walk that draw any target, and of the library.
COSTS_WALK := path plan methods targets
COSTS_LIB := $(patsubst %,lib/%,$(call LIB_NEEDED,$(wildcard bench/firmware/*.c) $(COSTS_WALK:%=firmware/walk/%.c) \
    $(foreach core,$(BENCH_CORES_HERE),$(BOARD_SOURCES.$(BENCH_BOARD.$(core))))))

# Where the library of a core is: that of the boards with the same flags, if there are any, is the
# same library. $(1): the core, $(2): a folder of the bench, with a slash, or nothing.
BENCH_CHOICE_OF.os/ := -Os
BENCH_CHOICE_OF.small/ := $(BENCH_SMALL)
BENCH_CHOICE_OF.small-lto/ := $(BENCH_SMALL)
BENCH_CHOICE_OF.arduino/ := -Os -DFXL_COMPACT=0
BENCH_LIB_OUT = $(or $(addprefix $(CORE_OUT)/,$(filter $(call CORE_NAME_OF_FLAGS,$(BENCH_FLAGS.$(1)) $(if $(2),$(BENCH_CHOICE_OF.$(2)))),\
    $(CORES_SHARED))),$(BENCH_OUT)/$(1)$(2:%/=/%))/lib
# $(1): the core, $(2): names of objects.
BENCH_PLACES = $(patsubst $(BENCH_OUT)/$(1)/small/lib/%,$(call BENCH_LIB_OUT,$(1),small/)/%,\
    $(patsubst $(BENCH_OUT)/$(1)/arduino/lib/%,$(call BENCH_LIB_OUT,$(1),arduino/)/%,$(patsubst $(BENCH_OUT)/$(1)/os/lib/%,$(call BENCH_LIB_OUT,$(1),os/)/%,\
    $(patsubst $(BENCH_OUT)/$(1)/lib/%,$(call BENCH_LIB_OUT,$(1))/%,$(patsubst %,$(BENCH_OUT)/$(1)/%.o,$(filter-out $(call BENCH_EMPTY,$(1),$(2)),$(2)))))))
# Those of the library that have no contents for a core, in each folder of which there are names in $(2).
BENCH_EMPTY = $(foreach lib,lib $(patsubst %,%lib,os/ small/ small-lto/ arduino/),$(if $(filter $(lib)/%,$(2)),\
    $(addprefix $(lib)/,$(call LIB_EMPTY,bench-$(1)-$(lib),$(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(BENCH_OPTIMISE) $(BENCH_CHOICE_OF.$(lib:lib=)),\
    $(call LIB_TUNE,$(BENCH_FLAGS.$(1)))))))
# $(1): the core, $(2): the program.
BENCH_OBJECTS_OF = $(call BENCH_PLACES,$(1),program $(BENCH_OBJECTS.$(2)) \
    $(if $(filter $(2),$(BENCH_C_LIBRARY)),,memory_functions))
# The board's parts, which only start and end the program, are compiled for the
# board; for hard float anew, since the linker mixes no calling conventions.
BENCH_PARTS_OF = $(filter-out %/memory_functions.o,$(if $(findstring =hard,$(BENCH_FLAGS.$(1))),\
    $(BOARD_SOURCES.$(BENCH_BOARD.$(1)):%.c=$(BENCH_OUT)/$(1)/parts/%.o),\
    $(call BOARD_PARTS_OF,$(BENCH_BOARD.$(1)))))
BENCH_LIBRARIES_OF = $(if $(filter $(2),$(BENCH_C_LIBRARY)),-lm -lc) -lgcc
BENCH_LINK = $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) -nostartfiles -nostdlib \
    $(call BOARD_MEMORY_LINK,$(BENCH_BOARD.$(1))) \
    -Wl,--gc-sections,--fatal-warnings,--no-warn-rwx-segments,-Map,$(@:.elf=.map)

define BENCH_PROGRAM_RULES
$(BENCH_OUT)/$(1)/$(2).elf: $(call BENCH_OBJECTS_OF,$(1),$(2)) $(call BENCH_PARTS_OF,$(1),$(2)) \
        $(call BOARD_LINK_SCRIPTS,$(BENCH_BOARD.$(1))) bench/bench.mk
	$$(call FIRMWARE_LINK,$$(call BENCH_LINK,$(1)) $$(filter %.o,$$^) $(call BENCH_LIBRARIES_OF,$(1),$(2)))
endef

$(BENCH_OUT)/one-file/fixel.c: $(LIB_SOURCES) $(wildcard lib/*/*.h) $(LIB_HEADERS) $(wildcard tools/fixel/package/one_file.py tools/fixel/package/private_names.py)
	$(MAKE_FOLDER)
	$(SAY)
	@$(TOOL) one-file --out $(@D) >/dev/null

define BENCH_CORE_RULES
BENCH_CC.$(1) := $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(BENCH_OPTIMISE) $(BENCH_CFLAGS)
# Until bench_start has turned it on, nothing may touch the floating-point unit.
$(if $(findstring =hard,$(BENCH_FLAGS.$(1))),$(BENCH_OUT)/$(1)/parts/%.o \
    $(patsubst %,$(BENCH_OUT)/$(1)/%.o,program frames kernels calibration): \
    FLAGS_OF_FILE := -mgeneral-regs-only)
$(BENCH_OUT)/$(1)/one-file/fixel.o: $(BENCH_OUT)/one-file/fixel.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(BENCH_OPTIMISE) -std=c11 -g -ffunction-sections -fdata-sections -ffreestanding)
$(BENCH_OUT)/$(1)/without_tiny.o: lib/$(BENCH_TINY_TARGET).c bench/bench.mk
	$$(MAKE_FOLDER)
	@printf '#include "%s"\n' raster/scan.h >$$(@:.o=.c)
	@printf '#undef FXL_HAS_TINY\n#define FXL_HAS_TINY 0\n#include "%s"\n' $(BENCH_TINY_TARGET).c >>$$(@:.o=.c)
	$$(SAY)
	$$(BENCH_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -ffreestanding -c $$(@:.o=.c) -o $$@
BENCH_PROGRAMS.$(1) := $(patsubst %,$(BENCH_OUT)/$(1)/%.elf,$(call BENCH_PROGRAMS_OF,$(1)))

$(BENCH_OUT)/$(1)/parts/%.o: %.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) -ffreestanding $$(FLAGS_OF_FILE) $$(call BOARD_DEFINES,$(BENCH_BOARD.$(1))))
$(foreach part,path plan methods targets,
$(BENCH_OUT)/$(1)/$(part).o: firmware/walk/$(part).c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) -ffreestanding)
)
$(BENCH_OUT)/$(1)/memory_functions.o: boards/parts/memory_functions.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) -ffreestanding -fno-tree-loop-distribute-patterns)
$(BENCH_OUT)/$(1)/%.o: bench/firmware/%.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -ffreestanding $(BENCH_SCREEN.$(1)) $(BENCH_ORDER.$(1)) $$(FLAGS_OF_FILE))
$(BENCH_OUT)/$(1)/target/draw_costs.o: bench/firmware/draw_costs.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -ffreestanding $$(call COSTS_FLAGS,TARGET) -DDRAW_ORDER_ENTRIES=3072u -DDRAW_ROOM_BYTES=196608u)
$(foreach way,native cleared bands native-bands,
$(BENCH_OUT)/$(1)/$(way)/%.o: bench/firmware/%.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -ffreestanding $(BENCH_SCREEN.$(1)) $(BENCH_ORDER.$(1)) $(BENCH_DRAWS.$(way)))
)
$(foreach real,double float,
$(BENCH_OUT)/$(1)/$(real)/%.o: bench/listing/%.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) -DLISTING_$(real)=1)
)
$(if $(WIDE_GOALS),$(foreach program,$(call BENCH_PROGRAMS_OF,$(1)),$(call BENCH_PROGRAM_RULES,$(1),$(program))$(newline)$(newline)))
endef

# $(1): the core, $(2): what its flags are called here, $(3): a folder.
define BENCH_LIB_RULES
$(2)_FAMILY.$(1) = $$(call LIB_TUNE,$(BENCH_FLAGS.$(1)))
$(call LIB_RULES,$(BENCH_OUT)/$(1)/$(3)lib,$$(call FIRMWARE_COMPILE,$$($(2).$(1)) $$($(2)_FAMILY.$(1)) -ffreestanding),bench/bench.mk)
endef

$(foreach core,$(BENCH_CORES_HERE),$(eval $(call BENCH_CORE_RULES,$(core)))\
    $(if $(WIDE_GOALS),$(eval $(call BENCH_LIB_RULES,$(core),BENCH_CC,))\
    $(eval $(call BENCH_LIB_RULES,$(core),BENCH_CC_OS,os/))\
    $(eval $(call BENCH_LIB_RULES,$(core),BENCH_CC_ARDUINO,arduino/))\
    $(eval $(call BENCH_LIB_RULES,$(core),BENCH_CC_SMALL,small/))\
    $(eval $(call BENCH_LIB_RULES,$(core),BENCH_CC_SMALL_LTO,small-lto/))))

# --- sizes -----------------------------------------------------------------------

# A renderer linked with what it calls and nothing else, as measured and by -Os; what counts is the
# linker's map. The library is linked in two more ways: small, by -Os -DFXL_SMALL, and small-flto,
# by -flto too. With -flto the map has no files of the library, but one of the compiler's for all of
# them. There is no firmware in these programs, so all of that file is the library's. The memory
# functions are compiled without -flto and stand in the map by themselves.
# Cores with more are compiled to the same code but for a few bytes: of these -O2 alone. tools/fixel/bench/bench_rows.py names them too.
BENCH_SIZED_CORES := m0 m3
BENCH_SIZED := fixel listing-double listing-float memset
BENCH_ROOTS.fixel := fxl_renderer_init_with_for_polygons_of_32 fxl_frame_begin fxl_frame_draw fxl_fill_band
BENCH_ROOTS.listing-double := listing_draw
BENCH_ROOTS.listing-float := listing_draw
BENCH_ROOTS.memset := memset
BENCH_SIZED_LIB := $(patsubst %,lib/%,$(call LIB_NEEDED,bench/firmware/draw_bands.c bench/firmware/draw_fixel.c))
BENCH_SIZED_OF.fixel := $(BENCH_SIZED_LIB) memory_functions
BENCH_SIZED_OF.listing-double := double/listing
BENCH_SIZED_OF.listing-float := float/listing
BENCH_SIZED_OF.memset :=

BENCH_SIZE_LINK = $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) -nostartfiles -nostdlib \
    -Wl,--gc-sections,--fatal-warnings,--no-warn-rwx-segments,-Map,$(@:.elf=.map),-e,$(firstword $(BENCH_ROOTS.$(2))) \
    $(BENCH_ROOTS.$(2):%=-Wl,-u,%)

# The objects of a program. By -flto the linker calls the compiler, which wants its flags again.
BENCH_SIZE_OBJECTS.O2 = $(call BENCH_PLACES,$(1),$(BENCH_SIZED_OF.$(2)))
BENCH_SIZE_OBJECTS.Os = $(call BENCH_PLACES,$(1),$(BENCH_SIZED_OF.$(2):%=os/%))
BENCH_SIZE_OBJECTS.small = $(call BENCH_PLACES,$(1),$(BENCH_SIZED_LIB:%=small/%) os/memory_functions)
BENCH_SIZE_OBJECTS.small-flto = $(call BENCH_PLACES,$(1),$(BENCH_SIZED_LIB:%=small-lto/%) os/memory_functions)
BENCH_SIZE_FLAGS.small-flto := $(BENCH_SMALL) -flto -ffunction-sections -fdata-sections

# $(1): the core, $(2): the renderer, $(3): O2, Os, small or small-flto.
define BENCH_SIZE_RULES
$(BENCH_OUT)/$(1)/size/$(3)/$(2).elf: $(call BENCH_SIZE_OBJECTS.$(3),$(1),$(2)) bench/bench.mk
	$$(call FIRMWARE_LINK,$$(call BENCH_SIZE_LINK,$(1),$(2)) $(BENCH_SIZE_FLAGS.$(3)) $$(filter %.o,$$^) $(if $(filter fixel,$(2)),,-lm -lc) -lgcc)
endef

# What [[programs]] of bench.toml link: all of the library that the bench's programs need.
BENCH_PROGRAM_LIBRARIES := $(foreach flag,o2 os small,$(BENCH_OUT)/m3/programs/$(flag)/libfixel.a)
define BENCH_PROGRAM_LIBRARY_RULES
$(BENCH_OUT)/m3/programs/$(1)/libfixel.a: $(call BENCH_PLACES,m3,$(BENCH_NEEDED:%=$(if $(filter-out o2,$(1)),$(1)/)lib/%))
	@mkdir -p $$(@D)
	@rm -f $$@
	@$(CROSS)ar rcs $$@ $$^
endef
$(if $(WIDE_GOALS),$(foreach flag,o2 os small,$(eval $(call BENCH_PROGRAM_LIBRARY_RULES,$(flag)))))

define BENCH_CORE_SIZE_RULES
BENCH_CC_OS.$(1) := $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) -Os $(BENCH_CFLAGS)
BENCH_CC_ARDUINO.$(1) := $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(BENCH_CHOICE_OF.arduino/) $(BENCH_CFLAGS)
BENCH_CC_SMALL.$(1) := $(call BENCH_CROSS,$(1))gcc $(BENCH_FLAGS.$(1)) $(BENCH_SMALL) $(BENCH_CFLAGS)
BENCH_CC_SMALL_LTO.$(1) := $$(filter-out -g,$$(BENCH_CC_SMALL.$(1))) -flto
BENCH_SIZES.$(1) := $(if $(filter m3,$(1)),$(BENCH_PROGRAM_LIBRARIES)) $(BENCH_SIZED:%=$(BENCH_OUT)/$(1)/size/O2/%.elf) \
    $(if $(filter $(BENCH_SIZED_CORES),$(1)),$(BENCH_SIZED:%=$(BENCH_OUT)/$(1)/size/Os/%.elf) $(patsubst %,$(BENCH_OUT)/$(1)/size/%/fixel.elf,small small-flto))

$(BENCH_OUT)/$(1)/os/memory_functions.o: boards/parts/memory_functions.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC_OS.$(1)) -ffreestanding -fno-tree-loop-distribute-patterns)
$(foreach real,double float,
$(BENCH_OUT)/$(1)/os/$(real)/%.o: bench/listing/%.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC_OS.$(1)) -DLISTING_$(real)=1)
)
$(if $(WIDE_GOALS),$(foreach flag,O2 Os,$(foreach renderer,$(BENCH_SIZED),$(call BENCH_SIZE_RULES,$(1),$(renderer),$(flag))$(newline)$(newline)))
$(call BENCH_SIZE_RULES,$(1),fixel,small)
$(call BENCH_SIZE_RULES,$(1),fixel,small-flto))
endef
$(foreach core,$(BENCH_CORES_HERE),$(eval $(call BENCH_CORE_SIZE_RULES,$(core))))

# --- costs -----------------------------------------------------------------------

# The programs that make costs measures: bands as boards of several sizes have them. $(1): the core.
# The settings of a program: rows of a band, words of the display list, entries of the cache, and
# entries of the order beside those that the scene needs, in which rows of faces are kept.
COSTS_CORES := $(filter m0 m3 rv32,$(BENCH_CORES_HERE))
COSTED_CORES := $(foreach core,$(COSTS_CORES),$(or $(call ONE_OF,$(core),$(BENCH_CORES_HERE)),\
    $(error COSTS_CORES: there is no core "$(core)"; the cores are: $(BENCH_CORES_HERE))))
COSTS_LARGE := 240 65536 1024 0
COSTS_MIDDLE := 25 4096 64 0
COSTS_SMALL := 8 1024 8 0
COSTS_ORDER := 8 128 8 120
COSTS_LEAST := 3 150 0 0
COSTS_TARGET := 240 8192 256 0
COSTS_SIZES := LARGE MIDDLE SMALL ORDER LEAST
COSTS_FLAGS = -DDRAW_BAND_ROWS=$(word 1,$(COSTS_$(1)))u -DDRAW_LIST_WORDS=$(word 2,$(COSTS_$(1)))u \
    -DDRAW_CACHE_ENTRIES=$(word 3,$(COSTS_$(1)))u -DDRAW_ORDER_MORE=$(word 4,$(COSTS_$(1)))u
define COSTS_RULES
BENCH_OBJECTS.costs-$(2) := $(2)/draw_costs $(COSTS_WALK) frames $(COSTS_LIB)
$(BENCH_OUT)/$(1)/$(2)/draw_costs.o: bench/firmware/draw_costs.c bench/bench.mk
	$$(call FIRMWARE_COMPILE,$$(BENCH_CC.$(1)) $$(BENCH_CC_FAMILY.$(1)) -ffreestanding $(call COSTS_FLAGS,$(2)))
endef
$(foreach core,$(COSTED_CORES),$(foreach size,$(COSTS_SIZES),$(eval $(call COSTS_RULES,$(core),$(size)))\
    $(if $(WIDE_GOALS),$(eval $(call BENCH_PROGRAM_RULES,$(core),costs-$(size))))))
COSTS_PROGRAMS := $(foreach core,$(COSTED_CORES),$(COSTS_SIZES:%=$(BENCH_OUT)/$(core)/costs-%.elf))
# What the tool is told: NAME=rows:words:entries:more.
COSTS_SETTINGS := $(foreach size,$(COSTS_SIZES),$(size)=$(subst $(space),:,$(COSTS_$(size))))

$(if $(WIDE_GOALS),$(foreach kind,$(filter-out /%,$(CELLS_KINDS)),$(eval $(call BENCH_PROGRAM_RULES,$(patsubst %/,%,$(dir $(kind))),$(notdir $(kind))))))

# $(1): cores. What draws workloads as PIXELS=, ORDER= and DEPTH= ask for draws nothing else, and nothing else draws them so.
BENCH_ASKED := $(filter PIXELS ORDER DEPTH,$(GIVEN))
BENCH_BUILT_OF = $(BENCH_COUNTER) $(foreach core,$(1),$(if $(BENCH_ASKED),$(filter %/fixel-target.elf,$(BENCH_PROGRAMS.$(core))),\
    $(filter-out %/fixel-target.elf %/calibration.elf,$(BENCH_PROGRAMS.$(core))) $(if $(filter $(BENCH_CORES),$(core)),$(BENCH_SIZES.$(core)))))
BENCH_LEFT_OUT := $(filter-out $(BENCH_CORES_HERE),$(BENCH_CORES) $(BENCH_EXTRA))

.PHONY: bench-programs
bench-programs: $(call BENCH_BUILT_OF,$(BENCH_CORES_HERE))
