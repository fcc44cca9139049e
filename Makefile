# SPDX-License-Identifier: MIT
# The commands. Each command first calls tools/setup.sh, which installs what the command lacks and
# says so. Then a sub-make builds the files that the command needs. Then a tool runs.

.DEFAULT_GOAL := help

# --- words -------------------------------------------------------------------

empty :=
space := $(empty) $(empty)
, := ,
define newline


endef

# $(1) if it is, character for character, one of the words $(2). $(filter) would take a pattern or a list of words.
ONE_OF = $(strip $(foreach word,$(2),$(if $(and $(findstring |$(1)|,|$(word)|),$(findstring |$(word)|,|$(1)|)),$(word))))

# --- the user's variables ----------------------------------------------------

# The commands, and other targets of the command line that are no files.
COMMANDS := all run view flash boot gdb compare report screen showcase pictures wire lib test test-anywhere test-site test-campaigns boards benchmark bench clippers \
    clippers-accept bench-diff bench-baseline profile equality fuzz corpus changed kills seeded-bugs trace prove coverage coverage-builds rules mutants breaks size size-of-tree \
    predict costs one-file packages site docs release api-check format clean
TARGETS := help $(COMMANDS) all-boards boards-programs bench-programs bench-test-programs test-programs
# The variables of the commands, as COMMAND/NAME: those in the brackets at the end of a command's line of help. Other settings.
TAKEN := $(shell awk '/^[a-z-]*:.* \[[A-Z].*\]$$/ {command = $$0; sub(/:.*/, "", command); sub(/.* \[/, ""); gsub(/[^A-Z_=]+/, " "); \
    for (i = 1; i <= NF; i++) if (sub(/=.*/, "", $$i)) print command "/" $$i}' Makefile)
VARIABLES := $(sort $(notdir $(TAKEN)))
SETTINGS := V HOSTCC HOSTAR CROSS CMOCK_DIR UNITY_DIR
SETTINGS_OF_TESTS := BUILD PY MAKE

# A value is text and never runs. make would expand a $(shell ...) in it at each use, and once more when it exports the
# variable; a recipe would hand its quotes to the shell. So each variable that the user gives is taken literally and
# exported, and no recipe names one: tools/fixel/base/make.py makes a tool's options of them. What the tests
# set is not exported, nor read from the environment.
OF_COMMAND_LINE := $(foreach name,$(VARIABLES),$(if $(filter command,$(firstword $(origin $(name)))),$(name)))
GIVEN := $(foreach name,$(VARIABLES) $(SETTINGS),$(if $(filter command environment,$(firstword $(origin $(name)))),$(name)))
$(foreach name,$(GIVEN),$(eval override $(name) := $$(value $(name)))$(eval export $(name)))
GIVEN_BY_TESTS := $(foreach name,BUILD PY MAKE,$(if $(filter command,$(firstword $(origin $(name)))),$(name)))
$(foreach name,$(GIVEN_BY_TESTS),$(eval override $(name) := $$(value $(name))))

# Commands, flags and folders that recipes do name: words without a character that means something to the shell.
hash := \#
SHELL_CHARACTERS := ; & | < > ( ) $$ ` " ' \ $(hash)
WORDS := $(filter HOSTCC HOSTAR CROSS CMOCK_DIR UNITY_DIR LIB_FLAGS,$(GIVEN)) $(GIVEN_BY_TESTS)
$(foreach name,$(WORDS),$(foreach character,$(SHELL_CHARACTERS),\
    $(if $(findstring $(character),$(subst $(newline),;,$($(name)))),\
        $(error $(name) is "$($(name))"; it takes words on one line without any of $(SHELL_CHARACTERS)))))
ifneq ($(filter-out -%,$(firstword $(LIB_FLAGS))),)
$(error LIB_FLAGS is "$(LIB_FLAGS)"; it takes options of the compiler, such as -Os or -DFXL_POLYGON_CAPACITY=12)
endif
ifneq ($(filter-out 1,$(value SIZE)),)
$(error SIZE is "$(SIZE)"; it must be 1, or be left out)
endif
ifneq ($(and $(filter BUILD,$(GIVEN_BY_TESTS)),$(or $(findstring $(space),$(BUILD)),$(findstring %,$(BUILD)),$(findstring :,$(BUILD)))),)
$(error BUILD is "$(BUILD)"; it must be a folder without a blank, % or : in its name)
endif

# "; did you mean ...?", or nothing. $(1): a name, $(2): what stands after each word, $(3): the words.
DID_YOU_MEAN = $(shell python3 tools/fixel/base/nearest.py '$(subst ','\'',$(1))' '$(2)' $(3) 2>/dev/null)
UNKNOWN := $(firstword $(filter-out $(SETTINGS_OF_TESTS),\
    $(foreach name,$(.VARIABLES),$(if $(filter command,$(firstword $(origin $(name)))),$(name)))))
ifneq ($(UNKNOWN),)
$(error no command has a variable $(UNKNOWN)=$(call DID_YOU_MEAN,$(UNKNOWN),=,$(VARIABLES)) (see make help))
endif
UNKNOWN := $(firstword $(foreach goal,$(filter-out $(TARGETS),$(MAKECMDGOALS)),$(if $(findstring /,$(goal)),,$(goal))))
ifneq ($(UNKNOWN),)
$(error there is no command "$(UNKNOWN)"$(call DID_YOU_MEAN,$(UNKNOWN),,help $(COMMANDS)) (see make help))
endif
# A variable of the command line must belong to one of its commands. What the environment has may be meant for others, and a
# make that is called has the variables of the one that called it, which has looked.
ASKED := $(or $(MAKECMDGOALS),help)
STRAY := $(if $(filter-out 0,$(MAKELEVEL))$(filter-out help $(COMMANDS),$(ASKED)),,$(firstword \
    $(foreach name,$(OF_COMMAND_LINE),$(if $(filter $(ASKED:%=%/$(name)),$(TAKEN)),,$(name)))))
ifneq ($(STRAY),)
$(error $(STRAY)= is no variable of make $(ASKED); the commands that have it are: $(patsubst %/$(STRAY),%,$(filter %/$(STRAY),$(TAKEN))))
endif

# --- settings ----------------------------------------------------------------

BUILD    := build
HOSTCC   ?= gcc
CROSS    ?= arm-none-eabi-
PY       := .venv/bin/python
WARNINGS := -std=c11 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror
# The tools; a command of make, with the options that the user's variables become.
FIXEL     = $(PY) tools/fixel/launcher.py
TOOL      = $(FIXEL) make
# For what is compiled with -g.
RELATIVE_PATHS := -ffile-prefix-map=$(CURDIR)=.

BOARD ?= mps2-an385
CORE  ?= cortex-m3

HOST_TOOLS :=
UNITY_TESTS :=
export CROSS HOSTCC

.DELETE_ON_ERROR:
.SUFFIXES:

# Quiet unless V=1, which shows the commands: a terminal has one line that changes, "120 of 285"; elsewhere there is a
# line each 10 seconds. There are thousands of recipes, so make itself counts, and looks whether a folder is there. How
# many there are, make -n says once something is built; it is asked in a make that a command called, and by make lib,
# but for the commands of tests, whose words nobody reads meanwhile (FIXEL_SET_UP).
ifndef V
.SILENT:
SAY = $(if $(FIXEL_COUNTING),$(info +),$(eval BUILT += +)$(if $(TOTAL),,$(COUNT_ALL))$(if $(MAKE_TERMERR),$(TELL_TERMINAL),$(TELL_NOW_AND_THEN)))
endif
COUNT_ALL = $(eval TOTAL := $(if $(or $(filter-out 0,$(MAKELEVEL)),$(filter lib,$(MAKECMDGOALS))),$(if $(FIXEL_SET_UP),?,\
    $(shell FIXEL_COUNTING=1 MAKEFLAGS='$(subst ','\'',$(MAKEFLAGS))' $(MAKE) -n $(MAKECMDGOALS) 2>/dev/null | grep -c '^+$$')),?))
TELL = $(words $(BUILT)) of $(TOTAL)
TELL_TERMINAL = $(shell printf '  %s\r' '$(TELL)' >&2)
# The time is asked for at each tenth file. The first one begins the 10 seconds.
TELL_NOW_AND_THEN = $(if $(filter-out %0,$(words $(BUILT))),,$(call TELL_LATE,$(shell date +%s)))
TELL_LATE = $(if $(TOLD),$(if $(filter 1,$(shell expr $(1) - $(TOLD) '>=' 10)),$(eval TOLD := $(1))$(info $(space) building: $(TELL))),$(eval TOLD := $(1)))

MAKE_FOLDER = $(if $(wildcard $(@D)/.),,@mkdir -p $(@D))
MAKEFLAGS += --no-print-directory
# As many jobs as there are processors; -j1 on the command line is heeded. A sub-make shares the jobs of the first.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc)
endif

# --- boards ------------------------------------------------------------------

ALL_BOARDS := $(sort $(patsubst boards/%/board.mk,%,$(wildcard boards/*/board.mk)))
# The board that the commands are for: BOARD=, which is exactly one of them.
BOARD_CHOSEN := $(call ONE_OF,$(BOARD),$(ALL_BOARDS))
ifeq ($(BOARD_CHOSEN),)
$(error there is no board "$(BOARD)"; the boards are: $(ALL_BOARDS))
endif
# Boards whose tools make test does not install (BOARD_SETUP). A command has them if BOARD= names one, and make boards and
# make equality, coverage-builds, bench, costs and trace RELEASE=1 if their tools are there; they say to the make that they call which ones. make profile and make bench
# have the one whose core CORE= names.
EXTRA_BOARDS := $(patsubst boards/%/board.mk,%,$(shell grep -l '^BOARD_SETUP' boards/*/board.mk))
SETUP_OF = $(shell sed -n 's/^BOARD_SETUP := //p' boards/$(1)/board.mk)
SETUP_OF_BOARD := $(if $(filter $(EXTRA_BOARDS),$(BOARD_CHOSEN)),$(call SETUP_OF,$(BOARD_CHOSEN)))
ifneq ($(and $(filter boards equality coverage-builds bench costs $(if $(value RELEASE),trace),$(MAKECMDGOALS)),$(EXTRA_BOARDS)),)
$(foreach board,$(EXTRA_BOARDS),$(eval LACKS.$(board) := $(shell tools/setup.sh --missing $(call SETUP_OF,$(board)))))
FIXEL_EXTRA_BOARDS := $(foreach board,$(EXTRA_BOARDS),$(if $(LACKS.$(board)),,$(board)))
export FIXEL_EXTRA_BOARDS
endif
EXTRA_CORE := $(if $(filter profile bench,$(MAKECMDGOALS)),$(call ONE_OF,$(CORE),rv32))
ifneq ($(EXTRA_CORE),)
FIXEL_EXTRA_BOARDS := $(EXTRA_CORE)
export FIXEL_EXTRA_BOARDS
endif
BOARDS := $(filter-out $(filter-out $(BOARD_CHOSEN) $(FIXEL_EXTRA_BOARDS),$(EXTRA_BOARDS)),$(ALL_BOARDS))

# --- set-up ------------------------------------------------------------------

# Before a command's set-up its variables are looked at: what its tool would refuse is refused before anything is installed or
# built. The tests that give PY ask what reaches a tool. A python3 of PATH may first look for the real one.
LOOK_AT = $(if $(filter PY,$(GIVEN_BY_TESTS)),,$(or $(wildcard $(PY)),python3) -S tools/fixel/base/before.py $(1) &&)
SET_UP = $(call LOOK_AT,$@) tools/setup.sh

# The commands. Those of one command line run one after the other, so that no two makes build the
# same file at a time. What a command builds is built in parallel, after its set-up. lib
# calls no make of its own.
ifneq ($(filter-out lib,$(filter $(COMMANDS),$(MAKECMDGOALS))),)
.NOTPARALLEL:
endif

# --- the parts ---------------------------------------------------------------

# What is built, where something is. A command alone builds nothing itself, but calls a make for that: it needs no rules of
# programs, which take make most of the time that it reads.
BUILT_GOALS := $(filter-out help $(COMMANDS),$(MAKECMDGOALS))
# Those that are no program of a board or of the host: they may need the rules of tests and of the bench, two thirds of all.
WIDE_GOALS := $(strip $(foreach goal,$(BUILT_GOALS),$(if $(filter $(BUILD)/host/ $(BOARDS:%=$(BUILD)/boards/%/),$(dir $(goal))),,$(goal))))

include $(wildcard lib/lib.mk)
include $(wildcard firmware/firmware.mk)
include $(wildcard host_tests/*/*.mk host_tests/*/*/*.mk)
include bench/bench.mk
include bench/clippers.mk
include firmware/equality/equality.mk

# On which headers the objects depend, as the compilers wrote it: thousands of files, a second to
# read. A command has its files built by a sub-make, so a make of commands alone reads none of
# them. Programs of boards and of the host, and the library, depend on no object of the tests or of
# the bench, nor of another core, four fifths of all. seeded_bugs holds whole copies of the project, and prove the files of packages, of which a
# folder ends in .d.
APART := $(addprefix $(BUILD)/,host/unit host/fuzz host/coverage boards/*/unit)
GOAL_FOLDERS := $(dir $(BUILT_GOALS))
READ_FROM := $(BUILD)
ifeq ($(WIDE_GOALS),)
UNREAD := $(foreach folder,$(APART),-path '$(folder)' -prune -o)
READ_FROM := $(if $(filter lib,$(MAKECMDGOALS)),$(LIB_OUT)) $(if $(filter $(BUILD)/host/ $(BUILD)/boards/host/,$(GOAL_FOLDERS)),$(BUILD)/host $(BUILD)/boards/host) \
    $(foreach board,$(BOARDS),$(if $(filter $(BUILD)/boards/$(board)/,$(GOAL_FOLDERS)),$(BUILD)/boards/$(board) $(call BOARD_CORE_OUT,$(board))/lib))
endif
ifneq ($(BUILT_GOALS)$(filter lib,$(MAKECMDGOALS)),)
-include $(sort $(shell find $(READ_FROM) -name seeded_bugs -prune -o -path $(BUILD)/prove -prune -o $(UNREAD) -name '*.d' -type f -print 2>/dev/null))
endif

HOST_WALK := $(call WALK_OF,host)
WALK      := $(call WALK_OF,$(BOARD_CHOSEN))
# What make run draws with on the host, where nothing else was chosen.
WHOLE_FRAMES := $(if $(OWN)$(WALK_CHOICE)$(filter game,$(PROGRAM)),,$(if $(BOARD_HOSTED.$(BOARD_CHOSEN)),$(HOST_WALK)-whole))
IMAGE     := $(BUILD)/flash/$(BOARD_CHOSEN).bin
SCENE_OF_PROGRAM := $(if $(OWN),scenes/tiny.toml,$(if $(filter game,$(PROGRAM)),examples/game/game.toml,scenes/plaza.toml))
# These have been compared with the names that there are: firmware/firmware.mk.
METHODS_OPTIONS := --program $(PROGRAM_NAME) $(VISIBILITY:%=--visibility %) $(CLIPPER:%=--clipper %) $(ROWS:%=--rows %) $(DRIVER:%=--driver %)
# What is told of polygons that the display list of a board in bands has no room for is predicted.
PREDICTS_BANDS := $(if $(filter-out 1048576,$(BOARD_BAND_BYTES.$(BOARD_CHOSEN)))$(ROWS)$(DRIVER),$(if $(WHOLE_FRAMES)$(OWN),,$(BUILD)/host/predict))
# How a model without a scene file is drawn depends on what its frames are predicted to take.
PREDICTS := $(if $(filter $(addprefix %.,obj gltf glb stl ply OBJ GLTF GLB STL PLY),$(value SCENE)),$(addprefix $(BUILD)/host/,predict judge raycast) $(HOST_WALK))
DRAW_OPTIONS := --board $(BOARD_CHOSEN) --scene $(SCENE_OF_PROGRAM) --build $(BUILD) $(METHODS_OPTIONS)
# A program of the user's own runs on this machine, and the tool builds it: each time that it has changed.
VIEW_OPTIONS := $(if $(OWN),--board host --build $(BUILD) --program $(OWN) --source $(OWN_PATH),$(DRAW_OPTIONS))
# With DRIVER= a program that runs without a debugger, and an image of its own.
FLASHED := $(if $(ALONE),$(ALONE_PROGRAM),$(WALK))
FLASH_OPTIONS := --board $(BOARD_CHOSEN) --elf $(FLASHED) --program $(PROGRAM_NAME) $(DRIVER:%=--driver %) \
    --scene $(SCENE_OF_PROGRAM) --scenes $(BUILD)/scenes --image $(IMAGE:.bin=$(DRIVER:%=-%)$(OWN:%=-%).bin)
FLASH_SETUP := $(if $(PROBE),$(if $(DRY_RUN),run,probe),run)$(SETUP_OF_BOARD:%= %)

# A program of the user's own chooses what it draws, and with what.
ifneq ($(and $(OWN),$(filter $(if $(DRIVER),,flash) boot gdb screen size,$(MAKECMDGOALS))),)
$(error PROGRAM=FILE is for make run and make view, which show the pictures that it draws, and for make flash DRIVER=, of which a display shows them)
endif
VIEW_REFUSED := $(if $(and $(OWN),$(filter view,$(MAKECMDGOALS))),$(firstword $(filter SCENE SCREEN $(if $(filter-out host,$(BOARD)),BOARD),$(GIVEN))))
ifneq ($(VIEW_REFUSED),)
$(error PROGRAM=$(PROGRAM) with $(VIEW_REFUSED)=$(value $(VIEW_REFUSED)): make view runs a program of your own on this machine, with its own scene and screen: leave out $(VIEW_REFUSED)=, or PROGRAM=)
endif
ifneq ($(and $(OWN),$(CLIPPER)$(VISIBILITY)$(ROWS)$(if $(filter-out run flash,$(filter $(COMMANDS),$(MAKECMDGOALS))),$(DRIVER))$(PIXELS)$(ORDER)$(DEPTH)$(value LOOK)),)
$(error PROGRAM=$(PROGRAM) chooses itself what it draws: leave out CLIPPER, VISIBILITY, ROWS, PIXELS, ORDER, DEPTH and LOOK, and DRIVER but for make run and make flash)
endif

# What a board cannot do, which the tools would say only after it is built.
ifneq ($(and $(filter view gdb screen,$(MAKECMDGOALS)),$(filter emulator=rp2040js,$(BOARD_NOTE.$(BOARD_CHOSEN)))),)
$(error BOARD=$(BOARD) is emulated by rp2040js, which only runs a program to its end: name a board of QEMU)
endif
ifneq ($(and $(filter gdb screen,$(MAKECMDGOALS)),$(BOARD_HOSTED.$(BOARD_CHOSEN))),)
$(error BOARD=$(BOARD) is this machine, which has no emulator: name an emulated board)
endif
# place board: COSTS_BOARDS, without which make predict refuses it; then make costs
ifneq ($(and $(filter flash,$(MAKECMDGOALS)),$(filter openocd,$(value PROBE)),$(if $(BOARD_OPENOCD.$(BOARD_CHOSEN)),,none)),)
$(error PROBE=openocd: BOARD=$(BOARD) has no configuration of OpenOCD; the boards that have one are: $(strip $(foreach board,$(BOARDS),$(if $(BOARD_OPENOCD.$(board)),$(board)))))
endif

BOARDS_ALONE = $(patsubst boards/%/board.mk,%,$(shell grep -l '^BOARD_ALONE' boards/*/board.mk))
ifneq ($(and $(filter flash,$(MAKECMDGOALS)),$(DRIVER),$(if $(ALONE),,none)),)
$(error DRIVER=$(DRIVER): BOARD=$(BOARD) has no program for a display of a real board; the boards that have one are: $(BOARDS_ALONE))
endif

# --- commands ----------------------------------------------------------------

.PHONY: FORCE help test-programs bench-test-programs boards-programs $(COMMANDS)

help: ## print this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1@\2/p' Makefile | \
	    while IFS=@ read -r name what; do printf '  %-20s %s\n' "$$name" "$$what"; done
	@echo "Boards: $(ALL_BOARDS)"

all: ## build everything, run nothing [BOARD= PROGRAM=walk VISIBILITY= CLIPPER= ROWS= DRIVER=]
	@$(SET_UP) report
	@$(MAKE) $(WALK) $(HOST_WALK) $(HOST_TOOLS)

run: ## draw a scene's path on a board, compare it with double; or run a program of your own there [BOARD= PROGRAM=walk SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= FRAMES= PIXELS= ORDER= DEPTH= LOOK= VISIBILITY= CLIPPER= ROWS= DRIVER= OUT= FRESH=1]
	@$(SET_UP) run$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK) $(HOST_WALK) $(WHOLE_FRAMES) $(BUILD)/host/judge $(BUILD)/host/raycast $(sort $(PREDICTS) $(PREDICTS_BANDS))
	@$(TOOL) run $(DRAW_OPTIONS) $(if $(WHOLE_FRAMES),--whole-frames) $(WALK_ROWS_MAX:%=--band-rows %) --out $(BUILD)/run

view: ## show a board, or a program of your own, live on a web page of this machine, moved by keys [BOARD= PROGRAM=walk SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= PIXELS= ORDER= DEPTH= LOOK= VISIBILITY= CLIPPER= ROWS= PORT= OPEN=1]
	@$(SET_UP) view$(SETUP_OF_BOARD:%= %)
	@$(if $(OWN),,$(MAKE) $(WALK) $(BUILD)/host/live $(PREDICTS))
	@$(TOOL) view $(VIEW_OPTIONS)

flash: ## write program and scene to the board's flash image, or to the real board [BOARD= PROGRAM=walk SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= FRAMES= PIXELS= ORDER= DEPTH= LOOK= VISIBILITY= CLIPPER= ROWS= DRIVER= PROBE=openocd DRY_RUN=1]
	@$(SET_UP) $(FLASH_SETUP)
	@$(MAKE) $(FLASHED) $(PREDICTS)
	@$(TOOL) flash $(FLASH_OPTIONS)

boot: ## boot a board from its flash image [BOARD= FRAMES= PIXELS= ORDER= DEPTH=; PROGRAM= VISIBILITY= CLIPPER= ROWS= as for flash]
	@$(SET_UP) run$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK)
	@$(TOOL) boot --board $(BOARD_CHOSEN) --image $(IMAGE) --elf $(WALK) --dump $(BUILD)/boot/$(BOARD_CHOSEN).fxld

gdb: ## open a debugger on a board, booted from its flash image, stopped at main [BOARD= FRAMES= GDB_COMMANDS=file; PROGRAM= VISIBILITY= CLIPPER= ROWS= as for flash]
	@$(SET_UP) gdb$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK)
	@$(TOOL) gdb --board $(BOARD_CHOSEN) --image $(IMAGE) --elf $(WALK)

compare: ## compare two PNGs, folders of PNGs, or frame dumps [A= B= TOLERANCE=0 OUT= JSON=1]
ifneq ($(filter compare,$(MAKECMDGOALS)),)
include tools/fixel/report/compare.mk
endif

REPORT_TOOLS := $(addprefix $(BUILD)/host/,oracle designs judge raycast stage_errors)
REPORT_PROGRAMS = $(if $(ONLY),$(BUILD)/host/oracle,$(BOARD_WALK.host) $(BOARD_WALK.$(BOARD_CHOSEN)) $(REPORT_TOOLS))

report: ## measure every claim about accuracy, beside plain 16.16 and float32: an HTML page, JSON [BOARD= SAMPLES= SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SEED= ONLY= MINUTES=20 JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) report
	@$(MAKE) $(REPORT_PROGRAMS)
	@$(TOOL) report --out $(BUILD)/report --build $(BUILD) --board $(BOARD_CHOSEN)

wire: ## draw a scene's path as wireframes on this machine, compare it with double [PROGRAM=walk SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= FRAMES= OUT= FRESH=1]
	@$(SET_UP) run
	@$(MAKE) $(BUILD)/host/wire
	@$(TOOL) wire --scene $(SCENE_OF_PROGRAM) --build $(BUILD) --out $(BUILD)/wire

showcase: ## make 24 models as people have them, draw each by its first command, and write a page [BOARD= ONLY= OUT= FRESH=1]
	@$(SET_UP) run simplify$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK) $(HOST_WALK) $(BUILD)/host/judge $(BUILD)/host/raycast $(BUILD)/host/predict
	@$(TOOL) showcase --board $(BOARD_CHOSEN) --build $(BUILD)

screen: ## save what a board's screen shows after the last frame [BOARD= PROGRAM=walk SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= FRAMES= PIXELS= ORDER= DEPTH= LOOK= VISIBILITY= CLIPPER= ROWS= DEVICE= PICTURE=]
	@$(SET_UP) run$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK) $(PREDICTS)
	@$(TOOL) screen $(DRAW_OPTIONS) --out $(BUILD)/screen/$(BOARD_CHOSEN).png

# What make pictures makes, a name each: PICTURE.NAME is the steps.
define PICTURE.plaza
@$(MAKE) run SCENE=scenes/plaza.toml FRAMES=106 OUT=$(BUILD)/plaza
@$(FIXEL) pictures --run $(BUILD)/plaza --out docs/plaza.png
endef
PICTURE_OF_PROGRAM = @$(FIXEL) first-program --library $(BUILD)/host/libfixel.a $(1) --out docs/$(2).png
PICTURE.cube = $(call PICTURE_OF_PROGRAM,,cube)
PICTURE.hud = $(call PICTURE_OF_PROGRAM,--hud,hud)
PICTURE.world = $(call PICTURE_OF_PROGRAM,--example crowd,world)
PICTURE.crate = $(call PICTURE_OF_PROGRAM,--example crate,crate)
PICTURE.neon = $(call PICTURE_OF_PROGRAM,--example neon,neon)
PICTURE.looks = $(foreach each,$(notdir $(basename $(wildcard docs/looks/*.png))),$(call PICTURE_OF_PROGRAM,--look $(each),looks/$(each))$(newline))
PICTURE.examples = $(foreach each,$(notdir $(basename $(wildcard docs/examples/*.png))),$(call PICTURE_OF_PROGRAM,--example $(each),examples/$(each))$(newline))
define PICTURE.oled
@$(MAKE) screen BOARD=lm3s6965evb SCENE=scenes/plaza.toml SCREEN=128x64 FRAMES=31 PICTURE=docs/oled.png
endef
define PICTURE.precision
@$(FIXEL) report --out $(BUILD)/report --picture docs/precision.png
endef
# $(1): its name, $(2): settings of make run, $(3): numbers of frames.
define PICTURE_OF_RUN
@$(MAKE) run $(2) OUT=$(BUILD)/$(1)
@$(FIXEL) pictures --run $(BUILD)/$(1) --frames $(3) --out docs/$(1).png
endef
PICTURE.beam = $(call PICTURE_OF_RUN,beam,SCENE=scenes/beam.toml,20$(,)66$(,)92)
PICTURE.room = $(call PICTURE_OF_RUN,room,SCENE=scenes/room.toml SCREEN=320x240,4$(,)18$(,)31)
PICTURE.grove = $(call PICTURE_OF_RUN,grove,SCENE=scenes/grove.toml SCREEN=320x240,4$(,)22$(,)44)
PICTURE.spin = $(call PICTURE_OF_RUN,spin,SCENE=scenes/spin.toml,5$(,)25$(,)70)
PICTURE.game = $(call PICTURE_OF_RUN,game,PROGRAM=game,60$(,)120$(,)200)
define PICTURE.wire
@$(MAKE) wire SCENE=scenes/plaza.toml FRAMES=106 OUT=$(BUILD)/wire
@$(FIXEL) pictures --run $(BUILD)/wire --frames 30,45,105 --out docs/wire.png
endef
define PICTURE.light
@$(FIXEL) build scenes/plaza.toml -o $(BUILD)/lit.fxls
@for light in day lamps dusk; do $(BUILD)/host/frames $(BUILD)/lit.fxls $(BUILD)/$$light.fxld --light $$light || exit 1; done
@$(FIXEL) pictures --dumps $(BUILD)/day.fxld $(BUILD)/lamps.fxld $(BUILD)/dusk.fxld --frames 40,40,20 --out docs/light.png
endef
define PICTURE.scenes
@for scene in landscape gallery car; do $(FIXEL) build scenes/$$scene.toml --screen 320x240 -o $(BUILD)/$$scene.fxls && \
    $(BUILD)/host/frames $(BUILD)/$$scene.fxls $(BUILD)/$$scene.fxld || exit 1; done
@$(FIXEL) pictures --dumps $(BUILD)/landscape.fxld $(BUILD)/gallery.fxld $(BUILD)/car.fxld --frames 70,6,63 --out docs/scenes.png
endef
define PICTURE.window
@$(FIXEL) record --board $(BOARD_CHOSEN) --scene scenes/plaza.toml --build $(BUILD) --out docs/window.webp
endef
PICTURES = $(patsubst PICTURE.%,%,$(filter PICTURE.%,$(.VARIABLES)))
PICTURES_ASKED := $(strip $(if $(filter pictures,$(MAKECMDGOALS)),$(if $(value ONLY),$(foreach name,$(subst $(,), ,$(ONLY)),\
    $(or $(call ONE_OF,$(name),$(PICTURES)),$(error ONLY: there is no picture "$(name)"; the pictures are: $(sort $(PICTURES))))),$(PICTURES))))

pictures: ## renew the pictures of the documents (needs make report) [BOARD= ONLY=]
	@$(SET_UP) test
	@$(MAKE) $(BOARD_WALK.$(BOARD_CHOSEN)) $(BUILD)/host/live $(BUILD)/host/frames $(BUILD)/host/libfixel.a
	$(foreach name,$(PICTURES_ASKED),$(PICTURE.$(name))$(newline))

lib: ## build the library and its headers for your firmware: for a core, or a chip such as rp2040 [CORE=cortex-m3 SIZE=1 LIB_FLAGS=]
	@tools/setup.sh $(LIB_SETUP)
	@$(MAKE) $(LIB_MADE)
	@printf '  %s\n' '$(LIB_CORE) means $(strip $(LIB_CC) $(LIB_CORE_FLAGS) $(LIB_OPTIMISE) $(LIB_FLAGS))'
	@printf '  %s and %s\n' '$(LIB_OUT)/libfixel.a' '$(LIB_OUT)/include/fixel.h'

one-file: ## write the library as fixel.h and fixel.c into build/one-file [OUT=]
	@$(SET_UP) tools
	@$(TOOL) one-file

packages: ## write packages for Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust into build/packages [ONLY= OUT=]
	@$(SET_UP) tools
	@$(TOOL) packages

# The programs of the emulated board in the site, as make flash BOARD=pico DRIVER=st7789 has them.
SITE_PICO := $(addprefix $(BUILD)/boards/pico/,walk-on-st7789-alone.elf game-on-st7789-alone.elf)
SITE_GAME := $(BUILD)/boards/host/game
site: ## write the site: a page that draws, and all documents, into build/site [OUT=]
	@$(SET_UP) site
	@$(MAKE) $(WEB_MODULE) $(WEB_JUDGE) $(WEB_COUNTER) $(WEB_OWN) $(BUILD)/host/predict $(BUILD)/host/frames
	@$(MAKE) $(firstword $(SITE_PICO)) BOARD=pico DRIVER=st7789
	@$(MAKE) $(lastword $(SITE_PICO)) BOARD=pico DRIVER=st7789 PROGRAM=game
	@$(MAKE) $(SITE_GAME) BOARD=host PROGRAM=game
	@$(TOOL) site --module $(WEB_MODULE) --judge $(WEB_JUDGE) --counter $(WEB_COUNTER) --own $(dir $(WEB_OWN)) --pico $(firstword $(SITE_PICO)) --game $(lastword $(SITE_PICO)) \
	    --game-here $(SITE_GAME) --build $(BUILD)

docs: ## write all documents, and the reference of all public functions and types, as pages into build/docs [OUT=]
	@$(SET_UP) docs
	@$(TOOL) docs

release: ## build every artefact of a version into dist, with hashes and an SPDX list: the same bytes for the same commit [OUT=]
	@$(SET_UP) tools
	@$(TOOL) release

# Before the first tag there is nothing to compare, and nothing to install for it.
api-check: ## compare the public headers and functions with those of the last tag; fails where a program may break
	@$(SET_UP) tools$(if $(shell git tag --list 'v[0-9]*'), api)
	@$(TOOL) api-check

SIZE_CORES_ALL := cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33
SIZE_CORES := $(if $(call ONE_OF,$(CORE),all),$(SIZE_CORES_ALL),$(or $(call ONE_OF,$(CORE),$(SIZE_CORES_ALL)),$(call ONE_OF,cortex-$(CORE),$(SIZE_CORES_ALL))))
ifneq ($(and $(filter size,$(MAKECMDGOALS)),$(if $(SIZE_CORES),,none)),)
$(error CORE=$(CORE) has no size here; the cores are: $(SIZE_CORES_ALL), or all of them: all)
endif
# A Cortex-M7's library is that of a Cortex-M4, instruction for instruction (CORE_SHARED): it is compiled once.
SIZE_LIBRARIES := $(foreach core,$(SIZE_CORES),--library $(core)=$(BUILD)/lib/$(call CORE_SHARED,$(core))/libfixel.a)

size: ## print flash, RAM and stack; check that the library of a core, or of all, has no float and no heap [CORE=cortex-m3 SIZE=1 LIB_FLAGS= BOARD= PROGRAM=walk VISIBILITY= CLIPPER= ROWS= DRIVER=]
	@$(SET_UP) run$(SETUP_OF_BOARD:%= %)
	@$(MAKE) $(WALK)
	@for core in $(sort $(call CORE_SHARED,$(SIZE_CORES))); do echo "  LIB  $$core" && \
	    $(MAKE) CORE=$$core $(BUILD)/lib/$$core/libfixel.a >/dev/null || exit; done
	@$(FIXEL) size --board $(BOARD_CHOSEN) $(if $(filter %.elf,$(WALK)),--elf $(WALK) \
	    --usage $(dir $(WALK)) $(call BOARD_CORE_OUT,$(BOARD_CHOSEN))/lib) \
	    $(SIZE_LIBRARIES) --cross $(CROSS) --out $(BUILD)/size.json

# What make predict has costs of: bench/costs.json.
COSTS_BOARDS := microbit mps2-an385 lm3s6965evb stm32vldiscovery netduinoplus2 mps2-an386 mps2-an500 mps3-an547 $(filter rv32 pico,$(BOARDS))
LIST_MOST_OF = $(or $(patsubst WALK_LIST_MOST=%,%,$(filter WALK_LIST_MOST=%,$(BOARD_SETTINGS.$(1)))),0)
# What the program of a board leaves out, as SURFACES,DEPTH.
LEFT_OUT_OF = $(subst $(space),$(,),$(patsubst WALK_WITHOUT_%,%,$(filter WALK_WITHOUT_%,$(BOARD_SETTINGS.$(1)))))

predict: ## predict flash, RAM, stack, instructions and cycles a frame before anything is built for the board [BOARD= SCENE= ALLOW_OUTSIDE=1 CPU_LIMIT= MEMORY_LIMIT= SCREEN= FRAMES= LOOK= CLOCK= BADGE= JSON=]
	@$(SET_UP) predict
	@$(MAKE) $(sort $(BUILD)/host/predict $(PREDICTS))
	@$(TOOL) predict --board $(BOARD_CHOSEN) --core '$(BOARD_CORE.$(BOARD_CHOSEN))' --scene $(SCENE_OF_PROGRAM) --build $(BUILD) \
	    --band $(BOARD_BAND_BYTES.$(BOARD_CHOSEN)) --order $(BOARD_ORDER_ENTRIES.$(BOARD_CHOSEN)) --list $(BOARD_LIST_BYTES.$(BOARD_CHOSEN)) \
	    --cache $(BOARD_CACHE_ENTRIES.$(BOARD_CHOSEN)) --list-most $(call LIST_MOST_OF,$(BOARD_CHOSEN)) $(addprefix --without ,$(call LEFT_OUT_OF,$(BOARD_CHOSEN))) $(addprefix --clock ,$(BOARD_CLOCK.$(BOARD_CHOSEN)))

COSTED_BOARDS := $(foreach board,$(COSTS_BOARDS),$(or $(call ONE_OF,$(board),$(BOARDS)),$(error COSTS_BOARDS: there is no board "$(board)"; the boards are: $(BOARDS))))
costs: ## renew bench/costs.json, from which make predict predicts [COSTS_CORES= of the bench's cores, COSTS_BOARDS=, FRAMES=30 of each scene at most]
	@$(SET_UP) report
	@$(MAKE) $(BUILD)/host/predict $(BENCH_COUNTER) $(COSTS_PROGRAMS) $(foreach board,$(COSTED_BOARDS),$(BOARD_WALK.$(board)))
	@$(TOOL) costs --cores $(COSTED_CORES) --sizes $(COSTS_SETTINGS) --boards $(COSTED_BOARDS) --build $(BUILD)

# BOARD= on the command line: what runs on that board and nothing else.
TEST_BOARD := $(if $(filter BOARD,$(GIVEN)),$(BOARD_CHOSEN))
# Without it, the unit tests run on a board for each build of the library, on the one with the most memory for a band of
# pixels, and with ONLY= on the default board; make boards runs them on every board. Not by -Os alone: that library has the
# assembly of another build and the C of -O2, and make boards alone builds and runs its tests.
TEST_CORES = $(filter-out %_Os,$(CORES_SHARED))
TEST_BOARDS_OF = $(foreach board,$(TARGET_BOARDS),$(if $(filter $(1),$(call CORE_SHARED,$(call CORE_NAME,$(board)))),$(board)))
TEST_BOARD_OF = $(lastword $(shell printf '%s\n' $(foreach board,$(1),$(BOARD_BAND_BYTES.$(board)):$(board)) | sort -n | tr ':\n' '  '))
TEST_BOARDS = $(eval TEST_BOARDS := $$(TEST_BOARDS_FOUND))$(TEST_BOARDS)
TEST_BOARDS_FOUND = $(if $(or $(TEST_BOARD),$(value ONLY)),$(filter $(BOARD_CHOSEN),$(TARGET_BOARDS)),\
    $(foreach core,$(TEST_CORES),$(call TEST_BOARD_OF,$(call TEST_BOARDS_OF,$(core)))))
# What the tests of the bench run, which they have built themselves (host_tests/conftest.py).
BENCH_TESTED := $(BENCH_COUNTER) $(foreach core,$(filter $(BENCH_CORES),$(BENCH_CORES_HERE)),$(BENCH_OUT)/$(core)/calibration.elf) $(BENCH_PROGRAMS.m3) $(BENCH_SIZES.m3)
bench-test-programs: $(BENCH_TESTED) $(CLIPPERS_TESTED)
TEST_UNITS = $(foreach board,$(TEST_BOARDS),$(BOARD_UNITS.$(board))) $(if $(filter-out host,$(TEST_BOARD)),,$(UNITY_TESTS))
# What the tests of the tools run, and of what make boards links the programs of all tested cores.
TEST_PROGRAMS = $(if $(TEST_BOARD),,$(HOST_TOOLS) $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_FAULTS.$(board))) \
    $(foreach core,$(TEST_CORES),$(foreach board,$(call TEST_BOARDS_OF,$(core)),$(BOARD_UNITS.$(board)))))
# For tools: a board, and what says which unit tests it has.
UNIT_OPTIONS = $(foreach board,$(1),--units $(board) $(BOARD_UNITS.$(board)))
TEST_UNIT_OPTIONS = $(if $(value ONLY),$(foreach board,$(TEST_BOARDS),--units $(board) $(BOARD_UNITS_CHOSEN.$(board))),$(call UNIT_OPTIONS,$(TEST_BOARDS)))
# A folder and the names in it, not a path for each: Linux gives one command 128 KiB.
HOST_UNIT_OPTIONS = $(foreach folder,$(sort $(dir $(UNITY_TESTS))),--host-units $(folder) $(notdir $(filter $(folder)%,$(UNITY_TESTS))))

TEST_OPTIONS = --json $(BUILD)/tests.json $(HOST_UNIT_OPTIONS) $(TEST_UNIT_OPTIONS) $(TEST_BOARD:%=--board %)

# With ONLY= the tests that it names say what they need: "unit:" and a file of tests for boards; files to make.
TEST_NEEDS := $(if $(and $(filter test-programs,$(MAKECMDGOALS)),$(value ONLY)),$(shell $(TOOL) test --needs $(TEST_OPTIONS)))
UNITS_CHOSEN := $(patsubst unit:%,%,$(filter unit:%,$(TEST_NEEDS)))
TEST_BUILT = $(if $(value ONLY),$(filter-out unit:%,$(TEST_NEEDS)) $(foreach board,$(TEST_BOARDS),$(BOARD_UNITS_CHOSEN.$(board))),\
    $(TEST_UNITS) $(TEST_PROGRAMS))
$(if $(filter test-programs,$(MAKECMDGOALS)),$(eval test-programs: $(TEST_BUILT))\
    $(if $(value ONLY),$(foreach board,$(TEST_BOARDS),$(eval $(call BOARD_$(if $(UNITS_CHOSEN),,NONE_)CHOSEN_RULES,$(board))))))

test: ## run the tests, on the host and on a board for each build of the library [BOARD= of one board, ONLY=, WHOLE=1: all of what is otherwise sampled]
	@$(SET_UP) test$(SETUP_OF_BOARD:%= %)
	@$(MAKE) test-programs
	@FIXEL_BUILT='$(if $(value ONLY),,$(TEST_PROGRAMS))' $(TOOL) test $(TEST_OPTIONS)

test-anywhere: ## run the tests of packages and of what make test has no tools for; says what was not run, and why [ONLY=]
	@$(SET_UP) test
	@$(MAKE) $(HOST_WALK) $(HOST_TOOLS) $(BUILD)/host/libfixel.a
	@$(TOOL) test-anywhere --json $(BUILD)/anywhere.json

test-site: ## open the site of make site in Chromium: its frames, links, documents
	@$(SET_UP) test site
	@$(MAKE) $(BUILD)/host/frames
	@$(TOOL) test-anywhere --only site --json $(BUILD)/site.json

test-campaigns: ## run a campaign on a cluster of three workers of which one is killed: the bytes must be those of one process and of eight; and fuzz by one and by eight
	@$(SET_UP) cluster
	@$(MAKE) $(BUILD)/host/oracle
	@test -n "$$(tools/setup.sh --missing fuzz)" || $(MAKE) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/fuzz_%)
	@$(PY) -m pytest -q -p no:cacheprovider host_tests/anywhere/campaigns

boards-programs: $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_UNITS.$(board)))

COMPARED_BOARDS = $(if $(filter host,$(TEST_BOARD)),$(error BOARD=host: all boards are compared with the host; name another),$(or $(TEST_BOARD),$(TARGET_BOARDS)))
NOT_RUN_OPTIONS = $(if $(TEST_BOARD),,$(foreach board,$(EXTRA_BOARDS),$(if $(LACKS.$(board)),--not-run $(board) $(LACKS.$(board)))))
COMPARED_UNITS = $(foreach board,$(COMPARED_BOARDS),$(if $(and $(BOARD_UNITS_APART.$(board)),$(if $(TEST_BOARD),,yes)),,$(board)))
COMPARED_PROGRAMS = $(foreach board,host $(COMPARED_BOARDS),$(BOARD_WALK.$(board))) $(foreach board,host $(COMPARED_UNITS),$(BOARD_UNITS.$(board)))
boards: ## compare all boards: memory, stack, speed, frames equal to the host's, unit tests [BOARD= of one board, PIXELS= ORDER= DEPTH=]
	@$(SET_UP) units $(foreach board,$(filter $(EXTRA_BOARDS),$(COMPARED_BOARDS)),$(call SETUP_OF,$(board)))
	@$(MAKE) $(COMPARED_PROGRAMS)
	@$(TOOL) boards --boards $(COMPARED_BOARDS) --scene scenes/tiny.toml scenes/plaza.toml \
	    $(call UNIT_OPTIONS,$(COMPARED_UNITS)) $(NOT_RUN_OPTIONS) --build $(BUILD) --out $(BUILD)/boards.json

# Boards with a main of their own in firmware/benchmark.
BENCHMARK_BOARD := $(call ONE_OF,$(if $(filter BOARD,$(GIVEN)),$(BOARD_CHOSEN),host),$(BENCHMARK_BOARDS))
benchmark: ## run the benchmark for real boards, on the host or emulated, and write its UF2 file (docs/results.md) [BOARD=host]
	@$(SET_UP) run$(SETUP_OF_BOARD:%= %)
	$(if $(BENCHMARK_BOARD),,$(error that board has no main in firmware/benchmark; these have one: $(BENCHMARK_MAINS)))
	@$(MAKE) $(call BENCHMARK_OF,$(BENCHMARK_BOARD))
	@$(FIXEL) benchmark --board $(BENCHMARK_BOARD) --elf $(call BENCHMARK_OF,$(BENCHMARK_BOARD)) --uf2 $(BUILD)/flash/benchmark-$(BENCHMARK_BOARD).uf2

# CORE here is one of the bench's; the default of the other commands is none.
BENCH_CORES_ASKED = $(if $(filter CORE,$(GIVEN)),$(or $(call ONE_OF,$(CORE),$(BENCH_CORES_HERE)),\
    $(error there is no core "$(CORE)" in the bench; its cores are: $(BENCH_CORES_HERE))),$(BENCH_CORES_HERE))
bench: ## count the instructions of frames and kernels on five cores, beside the chapter's listing: a report, JSON [CORE= of one core, WORKLOAD= of one workload, PIXELS= ORDER= DEPTH= FRESH=1]
	@$(SET_UP) report$(EXTRA_CORE:%= riscv)
	@$(MAKE) $(call BENCH_BUILT_OF,$(BENCH_CORES_ASKED))
	@$(TOOL) bench --cores $(BENCH_CORES_ASKED) $(if $(BENCH_LEFT_OUT),--left-out $(BENCH_LEFT_OUT)) \
	    --out $(BENCH_OUT) --build $(BUILD)

clippers: ## compare every clipper with every visibility method: an HTML page, JSON [FRAMES= ONLY= JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) report
	@$(MAKE) $(CLIPPERS_BUILT) $(BOARD_WALK.host)
	@$(TOOL) clippers --out $(BUILD)/clippers --build $(BUILD) --cores $(CLIPPERS_CORES)

clippers-accept: ## take the last make clippers into docs/clipping.md and bench/clippers.json
	@$(SET_UP) report
	@$(FIXEL) clippers --out $(BUILD)/clippers --build $(BUILD) --accept

bench-diff: ## compare the last make bench with bench/baseline.json [THRESHOLD=0.5]
	@$(SET_UP) tools
	@$(TOOL) bench-diff --current $(BENCH_OUT)/bench.json

bench-baseline: ## take the last make bench as the baseline, and renew the tables of docs/performance.md and docs/faces.md
	@$(SET_UP) tools
	@$(FIXEL) bench-diff --current $(BENCH_OUT)/bench.json --accept

PROFILE_CORE := $(if $(filter CORE,$(GIVEN)),$(call ONE_OF,$(CORE),$(BENCH_CORES) $(BENCH_EXTRA)),m3)
PROFILE_NAMES := $(or $(call ONE_OF,$(RENDERER),$(call BENCH_PROGRAMS_OF,$(PROFILE_CORE))),fixel fixel-native)
ifneq ($(and $(filter profile,$(MAKECMDGOALS)),$(RENDERER),$(if $(call ONE_OF,$(RENDERER),$(call BENCH_PROGRAMS_OF,$(PROFILE_CORE))),,unknown)),)
$(error there is no RENDERER "$(RENDERER)"; the programs are: $(call BENCH_PROGRAMS_OF,$(PROFILE_CORE)))
endif
PROFILE_PROGRAM := $(filter $(PROFILE_NAMES:%=$(BENCH_OUT)/$(PROFILE_CORE)/%.elf),$(BENCH_PROGRAMS.$(PROFILE_CORE)))
profile: ## show where a workload's instructions go: functions, lines, flame graph [WORKLOAD=w1 CORE=m3 RENDERER= FRAMES=]
	@$(SET_UP) run$(EXTRA_CORE:%= riscv)
	@$(MAKE) $(BENCH_COUNTER) $(PROFILE_PROGRAM)
	@$(TOOL) profile --workload w1 --core m3 --build $(BUILD)

equality: ## compare every kernel of every core with the portable one, on the emulated core [THOUSANDS=10000 ONLY= KEEP=firmware/equality/record.txt JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) run
	@$(MAKE) $(EQUALITY_PROGRAMS)
	@$(TOOL) equality $(EQUALITY_KINDS) --build $(BUILD)

fuzz: ## fuzz the scene loader, the whole pipeline and the tools' input, print the branches reached [RUNS=10000 EXAMPLES=1500 JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) fuzz
	@$(MAKE) $(FUZZ_PROGRAMS) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%)
	@$(TOOL) fuzz --examples $(FUZZ_TOOLS_EXAMPLES) --build $(BUILD)

CORPUS_PROGRAMS = $(if $(ADD),$(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%))
corpus: ## list the fuzzer's corpus, or add a file to that of a harness, with what the library answers [HARNESS= ADD=]
	@$(SET_UP) units
	@$(if $(CORPUS_PROGRAMS),$(MAKE) $(CORPUS_PROGRAMS))
	@$(TOOL) corpus --build $(BUILD)

changed: ## follow random worlds with everything attached, build each picture up from what changed, compare it with the whole frame [STEPS=100000 SEED=1]
	@$(SET_UP) units
	@$(MAKE) $(UNIT_OUT)/test_changed
	@$(TOOL) changed --units $(UNIT_OUT)

kills: ## kill run, flash, boot, view and report at random moments: nothing may be left [BOARD= KILLS=200 SEED=1]
	@$(SET_UP) test
	@$(MAKE) $(BOARD_WALK.host) $(BOARD_WALK.$(BOARD_CHOSEN)) $(BOARD_WALK.lm3s6965evb) $(REPORT_TOOLS) $(BUILD)/host/live
	@$(TOOL) kills --board $(BOARD_CHOSEN) --streaming lm3s6965evb --build $(BUILD)

seeded-bugs: ## break the library on purpose, one place at a time; the tests must fail each time [ONLY=]
	@$(SET_UP) units
	@$(TOOL) seeded-bugs --build $(BUILD)

trace: ## join each clause of the specification with its code and its tests; BREAK=1: the tests must fail when it is broken; RELEASE=1: each kernel has its inputs on record [BREAK=1 RELEASE=1 ONLY= SAMPLE= ACCEPT=1 JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) $(if $(value BREAK),units,$(if $(value RELEASE),run,tools))
	@$(if $(value BREAK),$(MAKE) $(UNIT_PROGRAMS) $(UNIT_ARCHIVES))
	@$(if $(value RELEASE),$(MAKE) $(EQUALITY_PROGRAMS))
	@$(TOOL) trace --cores $(EQUALITY_KINDS) --build $(BUILD) --units $(UNIT_OUT) --cc '$(HOSTCC) $(UNIT_CFLAGS) -DFXL_ASSERT_HOOK'

prove: ## prove properties of the library's text for every input, and say of each function what shows it; JSON [ONLY= BUGS=1 JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) predict
	@$(TOOL) prove --build $(BUILD)

# ONLY here is the name of one unit test; without it, all.
COVERED_TEST = $(or $(call ONE_OF,$(ONLY),$(notdir $(COVERAGE_TESTS))),$(error ONLY: there is no unit test "$(ONLY)"; host_tests/unit has them))
COVERED_TESTS = $(if $(ONLY),$(COVERAGE_OUT)/only/$(COVERED_TEST)/$(COVERED_TEST),$(COVERAGE_TESTS))
COVERED_LIBRARY = $(if $(ONLY),$(dir $(COVERED_TESTS))$(notdir $(COVERAGE_LIBRARY)),$(COVERAGE_LIBRARY))
COVERED_REPLAYS = $(if $(ONLY),,$(FUZZ_TARGETS))
coverage: ## print which lines, branches and conditions of lib/ the unit tests and the fuzzer's corpus reach; the rest must have a reason [ONLY= of one unit test, such as test_scan, and the sources that it links]
	@$(SET_UP) coverage
	@$(MAKE) $(COVERED_TESTS) $(COVERED_REPLAYS:%=$(COVERAGE_OUT)/replay_%)
	@$(TOOL) coverage --library $(COVERED_LIBRARY) --tests $(COVERED_TESTS) --out $(BUILD)/coverage/coverage.json \
	    $(foreach target,$(COVERED_REPLAYS),--replay $(COVERAGE_OUT)/replay_$(target) host_tests/fuzz/corpus/$(target).zip) $(if $(value ONLY),,--reasons host_tests/unit/uncovered.toml)

# A build of the library: the board whose unit tests have it, and the program of make equality that does. ONLY here is the name of one.
OTHER_UNITS.m0 := microbit
OTHER_UNITS.m3 := mps2-an385
OTHER_UNITS.m55 := mps3-an547
OTHER_UNITS.m33-small := mps2-an505
OTHER_UNITS.rv32 := rv32
OTHER_BUILDS := m33-small $(EQUALITY_KINDS)
OTHER_CHOSEN = $(if $(ONLY),$(or $(call ONE_OF,$(ONLY),$(OTHER_BUILDS)),$(error ONLY: there is no build "$(ONLY)"; the builds are: $(OTHER_BUILDS))),$(OTHER_BUILDS))
OTHER_PROGRAMS = $(BOARD_UNITS.$(OTHER_UNITS.$(1))) $(filter $(EQUALITY_OUT)/$(1).elf,$(EQUALITY_PROGRAMS))
coverage-builds: ## print which instructions of assembly, and lines of C in each other build of lib/, the unit tests of boards and make equality's programs execute [ONLY= of one build, such as m3-small]
	@$(SET_UP) units
	@$(MAKE) $(BENCH_COUNTER) $(foreach build,$(OTHER_CHOSEN),$(call OTHER_PROGRAMS,$(build)))
	@$(TOOL) coverage-builds --plugin $(BENCH_COUNTER) --out $(BUILD)/coverage/builds.json \
	    $(foreach build,$(OTHER_CHOSEN),--of $(build) $(call OTHER_PROGRAMS,$(build)))

rules: ## check lib/ by the rules of MISRA C:2012 that cppcheck 2.10 knows: the lines of each rule may only become fewer [RENEW=1]
	@$(SET_UP) rules
	@$(TOOL) rules --json $(BUILD)/rules.json

# What only the other part needs is not built.
MUTANTS_PART := $(call ONE_OF,$(PART),lib tools)
MUTANTS_LIB := $(if $(filter tools,$(MUTANTS_PART)),,$(UNIT_PROGRAMS) $(UNIT_ARCHIVES) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%))
MUTANTS_TOOLS := $(if $(filter lib,$(MUTANTS_PART)),,all $(BENCH_TESTED) $(CLIPPERS_TESTED))
mutants: ## put random small mistakes into the library and the tools; a test must fail for most of them [SEED=1 COUNT=100 PART= ONLY= JOBS= CLUSTER= FRESH=1]
	@$(SET_UP) $(if $(MUTANTS_LIB),units) $(if $(MUTANTS_TOOLS),test)
	@$(MAKE) $(MUTANTS_LIB) $(MUTANTS_TOOLS)
	@$(TOOL) mutants --seed 1 --count 100 --build $(BUILD) --cc '$(HOSTCC) $(UNIT_CFLAGS) -DFXL_ASSERT_HOOK' --units $(UNIT_OUT) \
	    $(foreach target,$(FUZZ_TARGETS),--replay $(FUZZ_OUT)/replay_$(target) host_tests/fuzz/record/$(target).txt \
	    host_tests/fuzz/corpus/$(target).zip $(FUZZ_REPLAY_OBJECTS_$(target)))

BREAKS_COVERED = $(COVERAGE_TESTS) $(FUZZ_TARGETS:%=$(COVERAGE_OUT)/replay_%)
breaks: ## break what the project claims, by a list of breaks that nobody wrote for the tests; commands must fail and name them [SEED=1 DRAW=20 ONLY= SAMPLES=]
	@$(SET_UP) units report coverage rules predict
	@$(MAKE) $(UNIT_PROGRAMS) $(UNIT_ARCHIVES) $(BREAKS_COVERED)
	@$(TOOL) breaks --build $(BUILD) --units $(UNIT_OUT) --cc '$(HOSTCC) $(UNIT_CFLAGS) -DFXL_ASSERT_HOOK'

size-of-tree: ## count files, lines of code, public functions, places of recipes and build steps; no count may be above its record [REASON=]
	@$(SET_UP) tools
	@$(TOOL) size-of-tree

format: ## format the C sources with clang-format
	@$(SET_UP) format
	@find lib boards firmware host_tests bench -name '*.[ch]' -exec clang-format -i {} +

clean: ## remove what was built (keeps .venv)
	@rm -rf $(BUILD) dist
