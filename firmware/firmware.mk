# SPDX-License-Identifier: MIT
# Programs for every board of BOARDS. Wants BUILD, WARNINGS (with -std=c11),
# CROSS and HOSTCC. boards/<board>/board.mk sets
#   BOARD_CPU               the core, for people and for the report
#   BOARD_CORE              compiler flags that choose the core; -DFXL_SMALL among them, the small library
#   BOARD_QEMU              what QEMU is told to be this board
#   BOARD_BAND_BYTES        memory for a band of pixels
#   BOARD_ORDER_ENTRIES     entries for the order of drawing
#   BOARD_LIST_BYTES        memory for a frame's list of polygons
#   BOARD_CACHE_ENTRIES     entries for vertices that faces share, 40 bytes each: 0 or a power of two
#   BOARD_PARTS             what the board is made of: names of boards/parts without .c, EMULATED_PARTS or CORTEXM_PARTS among them
#   BOARD_MEMORY            its memory map: NAME=VALUE for the symbols fxl_NAME that linker/sections.ld asks for
# and where it is wanted
#   BOARD_SOURCES           files of its own, board.c among them
#   BOARD_MEMORY_FOR_SURFACES  what is otherwise in the program of VISIBILITY=surfaces
#   BOARD_SECTORS           COUNT,BYTES of each run of equal sectors, where the sectors of its flash differ
#   BOARD_POLYGON_CAPACITY  vertices of a polygon at most (the library's own choice without)
#   BOARD_SETTINGS          NAME=VALUE for parts that ask for it: macros for all of the board's own objects
#   BOARD_OWN_FLAGS         compiler flags for the board's own objects, not for the library
#   BOARD_CROSS             the prefix of the compiler and its tools (CROSS without)
#   BOARD_SETUP             what tools/setup.sh installs for it: then make test leaves it out, unless BOARD= names it
#   BOARD_LIBC              flags that choose its C library, for unit tests (--specs=nano.specs without)
#   BOARD_CLOCK             MHz at most, or that its own code sets: what make predict's rate is of
#   BOARD_OPENOCD           OpenOCD's configuration for the real board
#   BOARD_NOTE              more of key=value for the tools, separated by blanks
#   BOARD_HOSTED            "yes" where the host itself is the board
#   BOARD_PROGRAM_OMIT      programs of PROGRAM= that do not fit it
#   BOARD_VISIBILITY_OMIT   values of VISIBILITY= whose programs do not fit it
#   BOARD_WIRES             what a driver of DRIVER= sends by, without .c, where a display hangs on the board; otherwise the wires are recorded
#   BOARD_UNITS_APART       "yes" where unit tests take so long that make boards leaves them to make test BOARD=
#   BOARD_ALONE             the function that takes text where there is no debugger: make flash DRIVER= then writes a program that needs none
#   BOARD_DRIVER_ROWS       rows that a driver of DRIVER= sends at a time, and behind a blank those of 480 pixels (8 4 without); 0: there is no room for one
#   BOARD_BENCH             cores of the bench that it stands for: bench/bench.mk
#
# Makes, for each board:
#   $(BOARD_WALK.<board>)    the walk
#   $(call WALK_OF,<board>)  the program of PROGRAM=, with the methods of CLIPPER= and VISIBILITY=
#   $(BOARD_FAULTS.<board>)  a program that fails in a way that it is told (not on the host)
#   $(BOARD_UNITS.<board>)   its unit tests: firmware/unittest/unittest.mk
#
# What depends on the core alone is built once for all boards with that core,
# under build/core/<flags>/; what knows the board, under build/boards/<board>/.
# One make knows every file, so none is made twice at a time.

# V=1 shows the commands.
FIRMWARE_QUIET := $(if $(V),,@)
FIRMWARE_OUT := $(BUILD)/boards
CORE_OUT := $(BUILD)/core

# --- settings ------------------------------------------------------------------

# Drivers that DRIVER= may name, which a board's memory may look at, and modules, which it may name too: from their lines in
# lib/include/fixel/display.h. A driver's line gives its facts: the longer side of its glass, and the bits of a pixel that it is sent.
DRIVER_FACTS := $(shell sed -nE 's|^extern const fxl_display_driver fxl_([a-z0-9]*); */. ([0-9]+) x ([0-9]+) of [^,]*, (.*) \*/$$|\1 \2 \3 \4|p' lib/include/fixel/display.h | \
    awk '{ print $$1 ":" ($$2 > $$3 ? $$2 : $$3) ":" (/RGB565/ ? 16 : /three bytes/ ? 24 : /greys/ ? 4 : 1) ":" $$4 }')
DISPLAY_MODULES := $(shell sed -n 's/^extern const fxl_display_module fxl_module_\([a-z0-9_]*\);.*/\1/p' lib/include/fixel/display.h)
# Of a word of DRIVER_FACTS: its name, and those of its modules.
DRIVER_NAMES_OF = $(foreach fact,$(1),$(firstword $(subst :, ,$(fact))) $(filter $(firstword $(subst :, ,$(fact)))_%,$(DISPLAY_MODULES)))
DRIVERS_OF_PAGES := $(call DRIVER_NAMES_OF,$(filter %:pages,$(DRIVER_FACTS)))
DRIVERS_OF_ROWS := $(call DRIVER_NAMES_OF,$(filter-out %:pages,$(DRIVER_FACTS)))

# What a board.mk must set; what it may set; what it may leave empty.
BOARD_MUST := CPU BAND_BYTES ORDER_ENTRIES LIST_BYTES CACHE_ENTRIES PARTS
BOARD_MAY := SOURCES MEMORY MEMORY_FOR_SURFACES SECTORS CORE QEMU NOTE POLYGON_CAPACITY SETTINGS OWN_FLAGS CROSS SETUP LIBC CLOCK OPENOCD HOSTED BENCH PROGRAM_OMIT VISIBILITY_OMIT WIRES UNITS_APART DRIVER_ROWS ALONE

# Parts of every emulated board, and of every board with a Cortex-M.
EMULATED_PARTS := stack semihosting semihosting_system display dump defaults memory_functions board_note
CORTEXM_PARTS := cortexm_start cortexm_fault cortexm_protect thumb systick $(EMULATED_PARTS)

# Reads a board.mk; what it sets as BOARD_X is then BOARD_X.<board>, and BOARD_SOURCES has the parts too.
define BOARD_READ
$(foreach setting,$(BOARD_MUST) $(BOARD_MAY),undefine BOARD_$(setting)$(newline))
include boards/$(1)/board.mk
$(foreach setting,$(BOARD_MUST),$$(if $$(BOARD_$(setting)),,$$(error boards/$(1)/board.mk does not set BOARD_$(setting)))$(newline))
$$(if $$(BOARD_HOSTED)$$(BOARD_MEMORY),,$$(error boards/$(1)/board.mk does not set BOARD_MEMORY))
$(foreach setting,$(BOARD_MUST) $(BOARD_MAY),BOARD_$(setting).$(1) := $$(BOARD_$(setting))$(newline))
BOARD_SOURCES.$(1) += $$(BOARD_PARTS:%=boards/parts/%.c)
endef
$(foreach board,$(BOARDS),$(eval $(call BOARD_READ,$(board))))

CROSS_OF = $(or $(BOARD_CROSS.$(1)),$(CROSS))

# --- cores ---------------------------------------------------------------------

# Flags that every object of a core and capacity is compiled with, and a name of them.
CORE_CHOICE = $(if $(BOARD_HOSTED.$(1)),,$(BOARD_CORE.$(1)) -ffreestanding) \
    $(BOARD_POLYGON_CAPACITY.$(1):%=-DFXL_POLYGON_CAPACITY=%)
CORE_NAME = $(or $(call CORE_NAME_OF_FLAGS,$(CORE_CHOICE)),host)
CORE_NAME_OF_FLAGS = $(subst =,-,$(subst $(space),_,$(strip $(patsubst -%,%,$(patsubst -m%,%,\
    $(filter-out -ffreestanding -mthumb,$(1)))))))
# A Cortex-M7 has the instructions of a Cortex-M4, and LIB_TUNE has both scheduled as one core, so
# the library's objects are equal byte for byte (host_tests/build/test_unit_tests.py). They are compiled
# once, for the M4. $(1): flags or a name of them.
CORE_SHARED = $(subst cortex-m7,cortex-m4,$(1))
# Where a board's objects of its core are.
BOARD_CORE_OUT = $(CORE_OUT)/$(call CORE_SHARED,$(call CORE_NAME,$(1)))

FIRMWARE_CFLAGS := $(WARNINGS) -O2 -g -ffunction-sections -fdata-sections -fstack-usage -MMD -MP
# What a board's program links of the library. The host's own library is compiled for its tools anyway (lib/lib.mk).
# lib/draw/offsets.c is no part of a program: it asserts what kernels in assembly assume.
# $(1): a board, $(2): the program's sources, and records of the library that it names by a macro.
LIB_OBJECTS_OF = $(if $(filter host,$(call CORE_NAME,$(1))),$(call LIB_HOST_NEEDED,$(BOARD_SOURCES.$(1)) $(2)),\
    $(patsubst %,$(BOARD_CORE_OUT)/lib/%.o,$(filter-out $(call CORE_EMPTY,$(notdir $(BOARD_CORE_OUT))),draw/offsets $(call LIB_NEEDED,$(BOARD_SOURCES.$(1)) $(2)))))
# $(1): the name of a core.
CORE_EMPTY = $(call LIB_EMPTY,$(1),$(CORE_CC.$(1)),$(CORE_TUNE.$(1)))
CORE_LIB_NAMES = $(filter-out $(call CORE_EMPTY,$(1)),$(LIB_NAMES))

# No object names the folder of the checkout: what it says of its source is relative to that folder.
# For assembly the compiler does not pass that on.
FIRMWARE_RELATIVE = $(RELATIVE_PATHS) $(if $(filter %.S,$<),-Wa$(,)--debug-prefix-map=$(CURDIR)=.)

# $(1): how to call the compiler, without the files.
define FIRMWARE_COMPILE
$(MAKE_FOLDER)
$(SAY)
$(FIRMWARE_QUIET)$(1) $(FIRMWARE_RELATIVE) -c $< -o $@
endef

# $(1): the first board with this core, $(2): the name of the core, $(3): its flags.
define CORE_RULES
CORE_TUNE.$(2) = $$(call LIB_TUNE,$(3))
CORE_CROSS.$(2) := $(call CROSS_OF,$(1))
CORE_LIBC.$(2) := $(BOARD_LIBC.$(1))
CORE_CC.$(2) := $(if $(BOARD_HOSTED.$(1)),$(HOSTCC),$(call CROSS_OF,$(1))gcc $(if $(BOARD_CROSS.$(1)),,-masm-syntax-unified)) $(FIRMWARE_CFLAGS) $(3)
endef

CORES_READ :=
$(foreach board,$(BOARDS),$(if $(filter $(call CORE_NAME,$(board)),$(CORES_READ)),,\
    $(eval CORES_READ += $(call CORE_NAME,$(board)))\
    $(eval $(call CORE_RULES,$(board),$(call CORE_NAME,$(board)),$(call CORE_CHOICE,$(board))))\
    $(eval $(call CORE_RULES,$(board),$(call CORE_SHARED,$(call CORE_NAME,$(board))),$(call CORE_SHARED,$(call CORE_CHOICE,$(board)))))))
# The cores for which something is compiled. The bench measures the same objects (bench/bench.mk),
# and its cores have an FPU: no float may become a double there.
CORES_SHARED := $(filter-out host,$(sort $(call CORE_SHARED,$(CORES_READ))))
$(if $(BUILT_GOALS),$(foreach core,$(CORES_SHARED),$(eval $(call LIB_RULES,$(CORE_OUT)/$(core)/lib,\
    $$(call FIRMWARE_COMPILE,$$(CORE_CC.$(core)) -Wdouble-promotion -Ilib/include $$(CORE_TUNE.$(core))),firmware/firmware.mk))))

# --- boards --------------------------------------------------------------------

BOARD_DEFINES = -DWALK_BAND_BYTES=$(BOARD_BAND_BYTES.$(1)) -DWALK_ORDER_ENTRIES=$(BOARD_ORDER_ENTRIES.$(1)) \
    -DWALK_LIST_BYTES=$(BOARD_LIST_BYTES.$(1)) -DWALK_CACHE_ENTRIES=$(BOARD_CACHE_ENTRIES.$(1)) \
    -DBOARD_NAME='"$(1)"' -DBOARD_CPU='"$(BOARD_CPU.$(1))"' -DBOARD_QEMU='"$(BOARD_QEMU.$(1))"' \
    -DBOARD_OPENOCD='"$(BOARD_OPENOCD.$(1))"' \
    -DBOARD_NOTE='"$(subst $(space),,$(BOARD_NOTE.$(1):%=%\n))$(if $(filter -O% -DFXL_%,$(BOARD_CORE.$(1))),code=own\n)"' \
    $(if $(filter window,$(BOARD_PARTS.$(1))),-DBOARD_HAS_WINDOW) $(if $(BOARD_SECTORS.$(1)),-DBOARD_SECTORS=$(subst $(space),$(,),$(BOARD_SECTORS.$(1)))) \
    $(BOARD_SETTINGS.$(1):%=-D%) $(BOARD_OWN_FLAGS.$(1))
BOARD_PARTS_OF = $(BOARD_SOURCES.$(1):%.c=$(FIRMWARE_OUT)/$(1)/%.o)
BOARD_FAULTS_OBJECTS_OF = $(patsubst %.c,$(FIRMWARE_OUT)/$(1)/%.o,$(wildcard firmware/faults/*.c))

# The programs that draw, PROGRAM=: the walk, and others that differ from it in their act
# (firmware/walk/act.h).
PROGRAMS := walk game
PROGRAM ?= walk
# Or a C file of the user's own, or a folder of C files, with a main: firmware/own. Recipes name the path, so it has no
# character that means something to the shell or to make.
OWN_REFUSED := $(SHELL_CHARACTERS) % : , = * ? [ ] ~ @ + !
OWN_SOURCES := $(strip $(if $(or $(call ONE_OF,$(PROGRAM),$(PROGRAMS)),$(findstring $(space),$(PROGRAM)),$(findstring $(newline),$(PROGRAM)),\
    $(filter -%,$(PROGRAM)),$(strip $(foreach character,$(OWN_REFUSED),$(findstring $(character),$(PROGRAM))))),,\
    $(if $(filter %.c,$(PROGRAM)),$(wildcard $(PROGRAM)),$(sort $(wildcard $(PROGRAM:/=)/*.c)))))
ifeq ($(call ONE_OF,$(PROGRAM),$(PROGRAMS))$(OWN_SOURCES),)
$(error there is no PROGRAM "$(PROGRAM)"; the programs are: $(PROGRAMS), and a C file or a folder of C files of your own)
endif
# The names of the files in it are the user's too.
OWN_WRONG := $(strip $(foreach source,$(OWN_SOURCES),$(if $(strip $(foreach character,$(OWN_REFUSED),$(findstring $(character),$(source))))$(filter-out $(wildcard $(source)),$(source)),$(source))))
ifneq ($(OWN_WRONG),)
$(error the folder "$(PROGRAM)" has a C file whose name has a blank or a character that means something to the shell or to make: rename it)
endif
# A name of its path without a folder, which no other path has: / and . become _ and -, which stand behind a point where the path has them
# itself (name_of in tools/fixel/board/own_run.py). No path has @ or +.
OWN_NAME_OF = $(subst +,.-,$(subst @,._,$(subst /,_,$(subst .,-,$(subst _,@,$(subst -,+,$(1)))))))
OWN_PATH := $(if $(OWN_SOURCES),$(PROGRAM:/=))
OWN := $(if $(OWN_PATH),own-$(call OWN_NAME_OF,$(OWN_PATH)))
PROGRAM_NAME := $(or $(OWN),$(PROGRAM))
# A board without the memory for a program: make says so before anything is built.
ifneq ($(filter $(PROGRAM),$(BOARD_PROGRAM_OMIT.$(BOARD_CHOSEN))),)
$(error PROGRAM=$(PROGRAM) needs more memory than BOARD=$(BOARD) has; the boards that it fits are: $(foreach board,$(BOARDS),$(if $(filter $(PROGRAM),$(BOARD_PROGRAM_OMIT.$(board))),,$(board))))
endif
PROGRAM_SOURCES.walk := $(wildcard firmware/walk/*.c)
PROGRAM_SOURCES.game := $(filter-out %/act_path.c %/targets.c,$(PROGRAM_SOURCES.walk)) $(wildcard firmware/game/*.c) examples/game/game.c
# $(1): a board, $(2): a program
PROGRAM_OBJECTS_OF = $(PROGRAM_SOURCES.$(2):%.c=$(FIRMWARE_OUT)/$(1)/%.o)
PROGRAM_FILE_OF = $(FIRMWARE_OUT)/$(1)/$(2)$(if $(BOARD_HOSTED.$(1)),,.elf)

# place clipper: CLIPPERS: the names that CLIPPER= takes
# What a program draws with, where CLIPPER= or VISIBILITY= is given: then it is another program,
# walk-<visibility>-<clipper>, that differs in three objects: board.mk may set memory by VISIBILITY.
CLIPPERS := view world normalised once half-spaces triangles near left
VISIBILITY_ROWS := $(shell awk '!/^\#/ && NF {print $$1 "|" $$2 "|" $$3 "|" $$4 "|" $$5}' firmware/visibility.txt)
VISIBILITIES := $(foreach row,$(VISIBILITY_ROWS),$(firstword $(subst |, ,$(row))))
ifeq ($(if $(CLIPPER),$(call ONE_OF,$(CLIPPER),$(CLIPPERS)),none),)
$(error there is no CLIPPER "$(CLIPPER)"; the clippers are: $(CLIPPERS))
endif
ifeq ($(if $(VISIBILITY),$(call ONE_OF,$(VISIBILITY),$(VISIBILITIES)),none),)
$(error there is no VISIBILITY "$(VISIBILITY)"; the visibility methods are: $(VISIBILITIES))
endif
ifneq ($(filter $(VISIBILITY),$(BOARD_VISIBILITY_OMIT.$(BOARD_CHOSEN))),)
$(error VISIBILITY=$(VISIBILITY) needs more memory than BOARD=$(BOARD) has; the boards that it fits are: $(strip $(foreach board,$(BOARDS),$(if $(filter $(VISIBILITY),$(BOARD_VISIBILITY_OMIT.$(board))),,$(board)))))
endif
WALK_METHODS := $(if $(CLIPPER)$(VISIBILITY),-$(or $(VISIBILITY),unasked)-$(or $(CLIPPER),view))
WALK_CLIPPER := $(if $(CLIPPER),fxl_clipper_$(subst -,_,$(CLIPPER)))
# Order, depth, faces and target of VISIBILITY=, by which firmware/walk/targets.c and methods.c choose.
WALK_ROW := $(if $(VISIBILITY),$(wordlist 2,5,$(subst |, ,$(filter $(VISIBILITY)|%,$(VISIBILITY_ROWS)))))
WALK_TARGET := $(filter fxl_%,$(WALK_ROW))
WALK_METHODS_DEFINES := $(WALK_CLIPPER:%=-DWALK_CLIPPER=%) $(WALK_TARGET:%=-DWALK_TARGET=%) $(if $(VISIBILITY),\
    -DWALK_BY_$(if $(filter tree,$(WALK_ROW)),TREE,DISTANCE) -DWALK_DEPTH_BITS=$(word 2,$(WALK_ROW)) $(if $(filter flat,$(WALK_ROW)),-DWALK_FLAT,-DWALK_SURFACES))
WALK_METHODS_FILES := methods plan targets
# A program with surfaces is larger. $(1): a board.
WALK_METHODS_LINK = $(if $(filter surfaces,$(VISIBILITY)),$(BOARD_MEMORY_FOR_SURFACES.$(1):%=-Wl$(,)--defsym=fxl_%))

# place pixel-format: PIXELS_KNOWN; the checks against VISIBILITY=, PROGRAM=, CHECK_ROOM
# What a scene is drawn as, in the place of what its [view] says: tools/fixel/scene/target.py.
PIXELS_KNOWN := palette rgb565
ORDERS_KNOWN := distance tree
DEPTHS_KNOWN := 0 16 32
# $(1): a variable, $(2): its values
define CHECK_ONE_OF
ifeq ($$(if $$($(1)),$$(call ONE_OF,$$($(1)),$(2)),none),)
$$(error $(1) is "$$($(1))"; it must be one of: $(2))
endif
endef
$(eval $(call CHECK_ONE_OF,PIXELS,$(PIXELS_KNOWN)))
$(eval $(call CHECK_ONE_OF,ORDER,$(ORDERS_KNOWN)))
$(eval $(call CHECK_ONE_OF,DEPTH,$(DEPTHS_KNOWN)))
DEPTH_GIVEN := $(filter-out 0,$(DEPTH))
ifneq ($(and $(VISIBILITY),$(ORDER)$(DEPTH)),)
$(error VISIBILITY=$(VISIBILITY) stands for an order and a depth: leave it out, or leave out $(strip $(ORDER:%=ORDER=%) $(DEPTH:%=DEPTH=%)))
endif
ifneq ($(and $(WALK_TARGET),$(filter rgb565,$(PIXELS))),)
$(error VISIBILITY=$(VISIBILITY) draws palette indices alone: leave it out, or leave out PIXELS=rgb565)
endif
ifneq ($(and $(filter tree,$(ORDER)),$(DEPTH_GIVEN)),)
$(error ORDER=tree draws without a depth buffer: leave it out, or leave out DEPTH=$(DEPTH))
endif
# $(1): what was asked for, $(2): settings of boards that cannot have it.
define CHECK_ROOM
ifneq ($$(filter $(2),$$(BOARD_SETTINGS.$$(BOARD_CHOSEN))),)
$$(error $(1) needs more memory than BOARD=$$(BOARD) has; the boards that it fits are: $$(strip $$(foreach board,$$(BOARDS),$$(if $$(filter $(2),$$(BOARD_SETTINGS.$$(board))),,$$(board)))))
endif
endef
$(if $(filter tree,$(ORDER)),$(eval $(call CHECK_ROOM,ORDER=tree,WALK_WITHOUT_BSP)))
$(if $(filter rgb565,$(PIXELS)),$(eval $(call CHECK_ROOM,PIXELS=rgb565,WALK_WITHOUT_RGB565)))
$(if $(and $(filter game,$(PROGRAM)),$(filter rgb565,$(PIXELS)),$(DEPTH_GIVEN)),$(eval $(call CHECK_ROOM,PROGRAM=game in PIXELS=rgb565 with DEPTH=$(DEPTH),GAME_WITHOUT_RGB565_DEPTH)))
$(if $(DEPTH_GIVEN),$(eval $(call CHECK_ROOM,DEPTH=$(DEPTH),WALK_WITHOUT_DEPTH $(if $(filter 32,$(DEPTH)),WALK_WITHOUT_DEPTH_32))))

# With ROWS=, its bands have so many rows at most: another program too.
ifneq ($(ROWS),)
ifeq ($(call ONE_OF,$(ROWS),$(shell seq 1024)),)
$(error ROWS=$(ROWS) is no number of rows from 1 to 1024)
endif
endif
# With DRIVER=, its frames go through that driver of the library too, and what it sends is recorded:
# boards/parts/driver_panel.c. Where ROWS= is not given, in bands of eight rows; with real wires of up to 40.
ifeq ($(if $(DRIVER),$(call ONE_OF,$(DRIVER),$(DRIVERS_OF_ROWS) $(DRIVERS_OF_PAGES)),none),)
$(error there is no DRIVER "$(DRIVER)"; the drivers are: $(sort $(DRIVERS_OF_ROWS) $(DRIVERS_OF_PAGES)))
endif
ifneq ($(if $(filter $(DRIVERS_OF_PAGES),$(DRIVER)),$(filter-out $(shell seq 8 8 1024),$(ROWS))),)
$(error DRIVER=$(DRIVER) takes pages of eight rows: ROWS=$(ROWS) must be a multiple of 8)
endif
# The facts of the driver, or of that of the module: its name, the longer side, bits. Rows of more than 320 pixels are too long for
# boards that send one of 320 at a time.
DRIVER_FACT := $(subst :, ,$(filter $(firstword $(subst _, ,$(DRIVER))):%,$(DRIVER_FACTS)))
DRIVER_SIDE := $(word 2,$(DRIVER_FACT))
DRIVER_IS_WIDE := $(filter-out $(shell seq 320),$(DRIVER_SIDE))
DRIVER_TOO_FEW_ROWS := 0 $(if $(DRIVER_IS_WIDE),1)
ifneq ($(if $(DRIVER),$(filter $(DRIVER_TOO_FEW_ROWS),$(BOARD_DRIVER_ROWS.$(BOARD_CHOSEN)))),)
$(error DRIVER=$(DRIVER) needs more memory than BOARD=$(BOARD) has; the boards that it fits are: $(strip $(foreach board,$(BOARDS),$(if $(filter $(DRIVER_TOO_FEW_ROWS),$(BOARD_DRIVER_ROWS.$(board))),,$(board)))))
endif
# With a driver, its loop and the panel are compiled for few bytes: boards of little flash have room for both then.
WALK_LOOP_FLAGS := $(if $(DRIVER),-Os)
WALK_ROWS_MAX := $(or $(ROWS),$(if $(DRIVER),$(if $(BOARD_WIRES.$(BOARD_CHOSEN)),40,8)))
WALK_CHOICE := $(WALK_METHODS)$(ROWS:%=-rows-%)$(DRIVER:%=-on-%)

# What was chosen, as the library calls it.
DRIVER_RECORD = $(if $(filter $(DRIVER),$(DISPLAY_MODULES)),fxl_module_,fxl_)$(DRIVER)
WALK_RECORDS := $(WALK_CLIPPER) $(WALK_TARGET) $(if $(DRIVER),$(DRIVER_RECORD))

# The program of a board with what was chosen.
WALK_OF = $(call PROGRAM_FILE_OF,$(1),$(PROGRAM_NAME)$(WALK_CHOICE))
PROGRAM_FILES_OF = $(sort $(foreach program,$(PROGRAMS),$(call PROGRAM_FILE_OF,$(1),$(program))) $(call WALK_OF,$(1))) $(if $(BOARD_HOSTED.$(1)),$(FIRMWARE_OUT)/$(1)/walk-whole)
# The same without semihosting, of the board that is chosen, if it has one: make flash DRIVER=.
ALONE := $(if $(and $(DRIVER),$(BOARD_ALONE.$(BOARD_CHOSEN))),$(BOARD_CHOSEN))
ALONE_PROGRAM := $(call PROGRAM_FILE_OF,$(ALONE),$(PROGRAM_NAME)$(WALK_CHOICE)-alone)

# A board's memory map. Of two values of a symbol the last one counts.
BOARD_MEMORY_LINK = $(BOARD_MEMORY.$(1):%=-Wl,--defsym=fxl_%) -T linker/sections.ld
# How a board's programs are linked, and what it takes beside the objects.
BOARD_LINK = $(call CROSS_OF,$(1))gcc $(BOARD_CORE.$(1)) -nostartfiles $(BOARD_MEMORY_LINK) \
    -Wl,--gc-sections,--fatal-warnings,--no-warn-rwx-segments $(LINK_OF_FILE)
# With a map beside the program.
BOARD_LINK_MAP = -Wl,-Map,$(@:.elf=.map)
BOARD_LINK_SCRIPTS = boards/$(1)/board.mk linker/sections.ld

define FIRMWARE_LINK
$(MAKE_FOLDER)
$(SAY)
$(FIRMWARE_QUIET)$(1) -o $@
endef

# The same for a board, whose linker may say that the program is too large. $(1): the board. Of a user's program the tables and arrays
# alone may be: CHECK_OF_FILE looks before that.
define TARGET_LINK
$(MAKE_FOLDER)
$(CHECK_OF_FILE)
$(SAY)
$(FIRMWARE_QUIET)code=0; $(2) -o $@ 2>$@.said || code=$$?; \
    if [ $$code = 0 ]; then cat $@.said >&2; else python3 tools/fixel/board/room.py $(1) $@ $@.said || true; fi; rm -f $@.said; exit $$code
endef

# What a program of the user's own links beside its objects: own.c, which hands out its pictures, and any of the library. Its
# code may have warnings, and GNU's C. An exported scene is kept whole, so that the tools find its palette.
OWN_WRAPPED := main fxl_frame_begin fxl_frame_fill fxl_frame_draw fxl_frame_draw_line fxl_render fxl_changed_find
OWN_CC = $(filter-out -std=% -W% -fdata-sections,$(CORE_CC.$(call CORE_NAME,$(1)))) -std=gnu11 -Wall
OWN_LIB_OF = $(if $(BOARD_HOSTED.$(1)),$(BUILD)/host/objects/lib,$(BOARD_CORE_OUT)/lib)
OWN_LIB_NAMES_OF = $(filter-out study/% draw/offsets,$(if $(BOARD_HOSTED.$(1)),$(LIB_HOST_NAMES),$(call CORE_LIB_NAMES,$(notdir $(BOARD_CORE_OUT)))))
OWN_OBJECT_OF = $(FIRMWARE_OUT)/$(1)/own/$(call OWN_NAME_OF,$(2)).o

OWN_REST_OF = $(FIRMWARE_OUT)/$(1)/firmware/own/colours.o $(patsubst %,$(OWN_LIB_OF)/%.o,$(OWN_LIB_NAMES_OF)) $(FIRMWARE_OUT)/$(1)/libown.a

define OWN_RULES
$(call OWN_OBJECT_OF,$(1),$(2)): $(2) firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(call OWN_CC,$(1)) -Ilib/include -Iboards)

$(call WALK_OF,$(1)): $(call OWN_OBJECT_OF,$(1),$(2))
endef

define OWN_PROGRAM_RULES
$(FIRMWARE_OUT)/$(1)/libown.a: $(foreach each,show show_rows keys_held no_wires,$(FIRMWARE_OUT)/$(1)/firmware/own/$(each).o)
	@rm -f $$@
	@$(if $(BOARD_HOSTED.$(1)),ar,$(call CROSS_OF,$(1))ar) rcs $$@ $$^

$(call WALK_OF,$(1)): $(filter-out %.c,$(OWN_PATH))
$(call WALK_OF,$(1)): $(FIRMWARE_OUT)/$(1)/firmware/own/own.o $(if $(BOARD_HOSTED.$(1)),$(FIRMWARE_OUT)/$(1)/firmware/own/watched.o) $(OWN_REST_OF)
$(call WALK_OF,$(1)): LINK_OF_FILE := $(OWN_WRAPPED:%=-Wl$(,)--wrap=%)
$(call WALK_OF,$(1)): CHECK_OF_FILE = $$(FIRMWARE_QUIET)$(call CROSS_OF,$(1))size -A $$(filter $(FIRMWARE_OUT)/$(1)/own/%.o,$$^) >$$@.said; \
    python3 tools/fixel/board/room.py $(1) $$@ --sizes $$@.said; code=$$$$?; rm -f $$@.said; exit $$$$code
endef

define BOARD_RULES
$(FIRMWARE_OUT)/$(1)/%.o: %.c firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(CORE_CC.$(call CORE_NAME,$(1))) $$(FLAGS_OF_FILE) -Ilib/include -Ilib -Iboards -Ifirmware/walk -Iexamples $$(call BOARD_DEFINES,$(1)))

# Its loops must not become calls of themselves.
$(FIRMWARE_OUT)/$(1)/boards/parts/memory_functions.o: FLAGS_OF_FILE := -fno-tree-loop-distribute-patterns
endef

define PROGRAM_RULES
$(call PROGRAM_FILE_OF,$(1),$(2)): $(call PROGRAM_OBJECTS_OF,$(1),$(2)) $(call LIB_OBJECTS_OF,$(1),$(PROGRAM_SOURCES.$(2)))
endef

# The objects that differ stand in place of the program's own: the walk's loop, the driver's panel, and those of the methods.
CHOICE_REST_OF = $(filter-out %/walk/walk.o $(if $(WALK_METHODS),%/game/targets_game.o $(addprefix %/walk/,$(WALK_METHODS_FILES:%=%.o))),$(call PROGRAM_OBJECTS_OF,$(1),$(PROGRAM))) \
    $(if $(WALK_METHODS),$(addprefix $(FIRMWARE_OUT)/$(1)/,$(addsuffix $(WALK_METHODS).o,$(WALK_METHODS_FILES)))) \
    $(if $(DRIVER),$(patsubst %,$(FIRMWARE_OUT)/$(1)/%.o,$(call BOARD_WIRES_OF,$(1)))) \
    $(call LIB_OBJECTS_OF,$(1),$(PROGRAM_SOURCES.$(PROGRAM)) $(WALK_RECORDS) $(if $(DRIVER),boards/parts/driver_panel.c $(addsuffix .c,$(call BOARD_WIRES_OF,$(1)))))
define CHOICE_RULES
$(call WALK_OF,$(1)): $(call CHOICE_REST_OF,$(1)) $(if $(OWN),,$(FIRMWARE_OUT)/$(1)/walk$(WALK_CHOICE).o) $(if $(DRIVER),$(FIRMWARE_OUT)/$(1)/driver_panel-on-$(DRIVER).o)
$(call WALK_OF,$(1)): LINK_OF_FILE := $(WALK_METHODS_LINK) $(if $(DRIVER),-Wl$(,)--wrap=board_panels) $(if $(OWN),$(OWN_WRAPPED:%=-Wl$(,)--wrap=%))

$(FIRMWARE_OUT)/$(1)/walk$(WALK_CHOICE).o: firmware/walk/walk.c firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(CORE_CC.$(call CORE_NAME,$(1))) $(WALK_LOOP_FLAGS) $(WALK_ROWS_MAX:%=-DWALK_ROWS_MAX=%) -Ilib/include -Iboards -Ifirmware/walk $$(call BOARD_DEFINES,$(1)))
endef

# The driver's panel stands beside those of the board: the linker sends who asks for board_panels to
# driver_panel.c, which asks the board.
BOARD_WIRES_OF = $(or $(BOARD_WIRES.$(1)),boards/parts/recorded_wires)
DRIVER_ROWS_OF = $(or $(if $(DRIVER_IS_WIDE),$(word 2,$(BOARD_DRIVER_ROWS.$(1)))),$(firstword $(BOARD_DRIVER_ROWS.$(1))),$(if $(DRIVER_IS_WIDE),4,8))
DRIVER_DEFINES = -DDRIVER_NAME=$(DRIVER_RECORD) $(if $(filter $(DRIVER),$(DISPLAY_MODULES)),-DDRIVER_IS_MODULE) -DDRIVER_BITS=$(word 3,$(DRIVER_FACT)) -DDRIVER_SIDE=$(DRIVER_SIDE)

define DRIVER_RULES
$(FIRMWARE_OUT)/$(1)/driver_panel-on-$(DRIVER).o: boards/parts/driver_panel.c firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(CORE_CC.$(call CORE_NAME,$(1))) -Os $(DRIVER_DEFINES) -DDRIVER_ROWS=$(call DRIVER_ROWS_OF,$(1)) -Ilib/include -Iboards $(BOARD_OWN_FLAGS.$(1)))
endef

define METHODS_RULES
$(addprefix $(FIRMWARE_OUT)/$(1)/,$(addsuffix $(WALK_METHODS).o,$(WALK_METHODS_FILES))): $(FIRMWARE_OUT)/$(1)/%$(WALK_METHODS).o: firmware/walk/%.c firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(CORE_CC.$(call CORE_NAME,$(1))) $(WALK_METHODS_DEFINES) -Ilib/include -Ilib $(BOARD_SETTINGS.$(1):%=-D%) $(BOARD_OWN_FLAGS.$(1)))
endef

# On a host the narrow bands are for what boards are compared with: make run BOARD=host draws whole frames of any size.
WHOLE_DEFINES := -UWALK_LIST_MOST -UWALK_BAND_BYTES -DWALK_BAND_BYTES=0x200000 -UWALK_LIST_BYTES -DWALK_LIST_BYTES=0x800000

define HOSTED_RULES
BOARD_WALK.$(1) := $(FIRMWARE_OUT)/$(1)/walk

$(FIRMWARE_OUT)/$(1)/walk-whole: $(if $(BUILT_GOALS),$(filter-out %/walk/walk.o,$(call PROGRAM_OBJECTS_OF,$(1),walk)) $(FIRMWARE_OUT)/$(1)/walk-whole.o $(call LIB_OBJECTS_OF,$(1),$(PROGRAM_SOURCES.walk)))

$(FIRMWARE_OUT)/$(1)/walk-whole.o: firmware/walk/walk.c firmware/firmware.mk boards/$(1)/board.mk
	$$(call FIRMWARE_COMPILE,$$(CORE_CC.$(call CORE_NAME,$(1))) -Ilib/include -Iboards -Ifirmware/walk $$(call BOARD_DEFINES,$(1)) $(WHOLE_DEFINES))

$(call PROGRAM_FILES_OF,$(1)): $(BOARD_PARTS_OF)
	$$(call FIRMWARE_LINK,$(HOSTCC) $$(LINK_OF_FILE) $$(filter %.o,$$^) $$(filter %.a,$$^))
endef

define TARGET_RULES
BOARD_WALK.$(1) := $(FIRMWARE_OUT)/$(1)/walk.elf
BOARD_FAULTS.$(1) := $(FIRMWARE_OUT)/$(1)/faults.elf

$(call PROGRAM_FILES_OF,$(1)): $(BOARD_PARTS_OF) $(BOARD_LINK_SCRIPTS)
	$$(call TARGET_LINK,$(1),$$(call BOARD_LINK,$(1)) $$(BOARD_LINK_MAP) -nostdlib $$(filter %.o,$$^) $$(filter %.a,$$^) -lgcc)

$$(BOARD_FAULTS.$(1)): $(BOARD_FAULTS_OBJECTS_OF) $(BOARD_PARTS_OF) $(BOARD_LINK_SCRIPTS)
	$$(call FIRMWARE_LINK,$$(call BOARD_LINK,$(1)) $$(BOARD_LINK_MAP) -nostdlib $$(filter %.o,$$^) -lgcc)
endef

TARGET_BOARDS := $(foreach board,$(BOARDS),$(if $(BOARD_HOSTED.$(board)),,$(board)))
$(foreach board,$(BOARDS),$(eval $(call BOARD_RULES,$(board)))\
    $(eval $(call $(if $(BOARD_HOSTED.$(board)),HOSTED,TARGET)_RULES,$(board))))

$(if $(BUILT_GOALS),$(foreach board,$(BOARDS),$(foreach program,$(PROGRAMS),$(eval $(call PROGRAM_RULES,$(board),$(program))))))
$(if $(and $(BUILT_GOALS),$(OWN)),$(foreach board,$(BOARDS),$(eval $(call OWN_PROGRAM_RULES,$(board)))\
    $(foreach source,$(OWN_SOURCES),$(eval $(call OWN_RULES,$(board),$(source))))))
$(if $(and $(BUILT_GOALS),$(WALK_CHOICE)),$(foreach board,$(BOARDS),$(eval $(call CHOICE_RULES,$(board)))))
$(if $(and $(BUILT_GOALS),$(WALK_METHODS)),$(foreach board,$(BOARDS),$(eval $(call METHODS_RULES,$(board)))))
$(if $(and $(BUILT_GOALS),$(DRIVER)),$(foreach board,$(BOARDS),$(eval $(call DRIVER_RULES,$(board)))))

# The program without semihosting: the objects that ask a debugger are built anew, and a program of the user's own has its memory
# apart, to begin again (linker/sections.ld), and the palette of its exported scene, if it has one.
ifneq ($(and $(BUILT_GOALS),$(ALONE)),)
ALONE_OUT := $(FIRMWARE_OUT)/$(ALONE)/alone$(WALK_CHOICE)
ALONE_ANEW := $(addprefix boards/parts/,semihosting semihosting_system driver_panel) $(if $(OWN),firmware/own/own,firmware/walk/walk)
ALONE_DEFINES := -DSEMIHOSTING_ALONE=$(BOARD_ALONE.$(ALONE)) -DBOARD_WATCHDOG_MILLISECONDS=60000u -DDRIVER_ALONE -DWALK_REPEATS -DOWN_REPEATS \
    -DWALK_ROWS_MAX=$(WALK_ROWS_MAX) $(DRIVER_DEFINES) -DDRIVER_ROWS=$(call DRIVER_ROWS_OF,$(ALONE))
ALONE_OWN := $(foreach source,$(OWN_SOURCES),$(ALONE_OUT)/own/$(call OWN_NAME_OF,$(source)).o)
ALONE_PALETTE := $(if $(OWN),$$($(call CROSS_OF,$(ALONE))nm -S $(ALONE_OWN) | \
    awk '$$2 == "00000300" && $$4 ~ /_palette$$/ {print "-Wl$(,)--defsym=own_colours=" $$4; exit}'))

$(ALONE_OUT)/%.o: %.c firmware/firmware.mk boards/$(ALONE)/board.mk
	$(call FIRMWARE_COMPILE,$(CORE_CC.$(call CORE_NAME,$(ALONE))) $(ALONE_DEFINES) -Ilib/include -Ilib -Iboards -Ifirmware/walk $(call BOARD_DEFINES,$(ALONE)))

$(ALONE_OWN): $(ALONE_OUT)/own/%.o: $(FIRMWARE_OUT)/$(ALONE)/own/%.o
	$(MAKE_FOLDER)
	$(FIRMWARE_QUIET)$(call CROSS_OF,$(ALONE))objcopy $(UNIT_OBJCOPY.libhelpers.a) $< $@

$(ALONE_PROGRAM): LINK_OF_FILE := $(call WALK_METHODS_LINK,$(ALONE)) -Wl,--wrap=board_panels $(if $(OWN),$(OWN_WRAPPED:%=-Wl$(,)--wrap=%))
$(ALONE_PROGRAM): $(ALONE_ANEW:%=$(ALONE_OUT)/%.o) $(filter-out %/semihosting.o %/semihosting_system.o,$(call BOARD_PARTS_OF,$(ALONE))) \
        $(if $(OWN),$(ALONE_OWN) $(BOARD_WIRES.$(ALONE):%=$(FIRMWARE_OUT)/$(ALONE)/%.o) $(call OWN_REST_OF,$(ALONE)),$(call CHOICE_REST_OF,$(ALONE))) \
        $(call BOARD_LINK_SCRIPTS,$(ALONE))
	$(call TARGET_LINK,$(ALONE),$(call BOARD_LINK,$(ALONE)) $(BOARD_LINK_MAP) -nostdlib $(ALONE_PALETTE) $(filter %.o,$^) $(filter %.a,$^) -lgcc)
endif

include firmware/unittest/unittest.mk
include firmware/benchmark/benchmark.mk
include firmware/web/web.mk

.PHONY: all-boards
all-boards: $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_FAULTS.$(board)) $(BOARD_UNITS.$(board)))
