# SPDX-License-Identifier: MIT
# The commands. Each command first calls tools/setup.sh, which installs what the command lacks and
# says so. Then a sub-make builds the files that the command needs. Then a tool runs.

BUILD    := build
HOSTCC   ?= gcc
CROSS    ?= arm-none-eabi-
PY       := .venv/bin/python
WARNINGS := -std=c11 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror

BOARD ?= mps2-an385
SCENE ?= $(if $(filter game,$(PROGRAM)),examples/game/game.toml,scenes/plaza.toml)
CORE  ?= cortex-m3
OUT   ?= $(BUILD)/run

HOST_TOOLS :=
UNITY_TESTS :=
export CROSS HOSTCC

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:

# Quiet unless V=1: a recipe for the host names the file that it makes. There are thousands of
# recipes, so make itself names the file, and looks whether its folder is there: no process starts.
ifndef V
.SILENT:
endif
HOST_SAY = $(info $(space) HOST $@)
MAKE_FOLDER = $(if $(wildcard $(@D)/.),,@mkdir -p $(@D))
MAKEFLAGS += --no-print-directory
# As many jobs as there are processors; -j1 on the command line is heeded. A sub-make shares the jobs of the first.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc)
endif

# --- boards ------------------------------------------------------------------

BOARDS := $(sort $(patsubst boards/%/board.mk,%,$(wildcard boards/*/board.mk)))
ifeq ($(filter $(BOARD),$(BOARDS)),)
$(error there is no board "$(BOARD)"; the boards are: $(BOARDS))
endif

# --- set-up ------------------------------------------------------------------

# The commands. Those of one command line run one after the other, so that no two makes build the
# same file at a time. What a command builds is built in parallel, after its set-up. lib
# calls no make of its own.
COMMANDS := all run view flash boot gdb compare report screen pictures wire lib test boards bench clippers \
    clippers-accept bench-diff bench-baseline profile equality fuzz kills seeded-bugs coverage mutants size predict costs format clean
ifneq ($(filter-out lib,$(filter $(COMMANDS),$(MAKECMDGOALS))),)
.NOTPARALLEL:
endif

# --- the parts ---------------------------------------------------------------

include $(wildcard lib/lib.mk)
include $(wildcard firmware/firmware.mk)
include $(wildcard host_tests/*/*.mk)
include bench/bench.mk
include bench/clippers.mk
include firmware/equality/equality.mk

# On which headers the objects depend, as the compilers wrote it: thousands of files, a second to
# read. A command has its files built by a sub-make, so a make of commands alone reads none of
# them. Programs of boards and of the host, and the library, depend on no object of the tests or of
# the bench, two thirds of all. seeded_bugs holds whole copies of the project.
APART := $(addprefix $(BUILD)/,host/unit host/fuzz host/coverage core/*/unit boards/*/unit bench equality)
ifeq ($(filter-out $(BUILD)/host/ $(BOARDS:%=$(BUILD)/boards/%/),$(dir $(filter-out lib,$(MAKECMDGOALS)))),)
UNREAD := $(foreach folder,$(APART),-path '$(folder)' -prune -o)
endif
ifneq ($(filter-out help $(filter-out lib,$(COMMANDS)),$(MAKECMDGOALS)),)
-include $(shell find $(BUILD) -name seeded_bugs -prune -o $(UNREAD) -name '*.d' -print 2>/dev/null)
endif

HOST_WALK := $(call WALK_OF,host)
WALK      := $(call WALK_OF,$(BOARD))
IMAGE     := $(BUILD)/flash/$(BOARD).bin
# A scene image is its own.
FXLS := $(if $(filter %.fxls,$(SCENE)),$(SCENE),$(BUILD)/scenes/$(basename $(notdir $(SCENE))).fxls)
FRAMES_OPTION := $(if $(FRAMES),--frames $(FRAMES))
SCREEN_OPTION := $(if $(SCREEN),--screen '$(SCREEN)')
FRESH_OPTION := $(if $(FRESH),--fresh)
METHODS_OPTIONS := --program '$(PROGRAM)' $(if $(VISIBILITY),--visibility '$(VISIBILITY)') $(if $(CLIPPER),--clipper '$(CLIPPER)') $(if $(ROWS),--rows '$(ROWS)')

# The record of a display's wires is what run reads.
ifneq ($(and $(DRIVER),$(filter view flash boot gdb screen,$(MAKECMDGOALS))),)
$(error DRIVER= is for make run alone, which reads what the driver of the display sends)
endif

# --- commands ----------------------------------------------------------------

.PHONY: FORCE help test-programs boards-programs set-up-lib $(COMMANDS)

help: ## print this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1@\2/p' Makefile | \
	    while IFS=@ read -r name what; do printf '  %-20s %s\n' "$$name" "$$what"; done
	@echo "Boards: $(BOARDS)"

all: ## build everything, run nothing
	@tools/setup.sh report
	@$(MAKE) $(WALK) $(HOST_WALK) $(HOST_TOOLS)

run: ## draw a scene's path on a board, compare it with double [BOARD= PROGRAM=walk SCENE= SCREEN= FRAMES= VISIBILITY= CLIPPER= ROWS= DRIVER= OUT= FRESH=1]
	@tools/setup.sh run
	@$(MAKE) $(WALK) $(HOST_WALK) $(BUILD)/host/judge $(BUILD)/host/raycast
	@$(PY) tools/run.py --board '$(BOARD)' --scene '$(SCENE)' --out '$(OUT)' --build $(BUILD) \
	    $(FRAMES_OPTION) $(SCREEN_OPTION) $(METHODS_OPTIONS) $(if $(DRIVER),--driver '$(DRIVER)') $(FRESH_OPTION)

view: ## show a board live on a web page of this machine, moved by keys [BOARD= PROGRAM=walk SCENE= SCREEN= VISIBILITY= CLIPPER= ROWS= PORT= OPEN=1]
	@tools/setup.sh view
	@$(MAKE) $(WALK) $(BUILD)/host/live
	@$(PY) tools/view.py --board '$(BOARD)' --scene '$(SCENE)' --build $(BUILD) \
	    $(SCREEN_OPTION) $(METHODS_OPTIONS) $(if $(PORT),--port '$(PORT)') $(if $(OPEN),--open)

flash: ## write program and scene to the board's flash image, or to the real board [BOARD= PROGRAM=walk SCENE= SCREEN= VISIBILITY= CLIPPER= ROWS= PROBE=openocd DRY_RUN=1]
	@tools/setup.sh $(if $(PROBE),$(if $(DRY_RUN),run,probe),run)
	@$(MAKE) $(WALK)
ifeq ($(filter %.fxls,$(SCENE)),)
	@mkdir -p $(BUILD)/scenes
	@$(PY) tools/scene.py build '$(SCENE)' -o '$(FXLS)' $(FRAMES_OPTION) $(SCREEN_OPTION)
else ifneq ($(SCREEN),)
	@echo "error: $(SCENE) is a scene image, which has its screen already: give the .toml or the model" >&2; exit 2
endif
	@$(PY) tools/flash.py --board '$(BOARD)' --elf $(WALK) --scene '$(FXLS)' --image $(IMAGE) \
	    $(if $(PROBE),--probe '$(PROBE)') $(if $(DRY_RUN),--dry-run)

boot: ## boot a board from its flash image [BOARD= FRAMES=; VISIBILITY= CLIPPER= as for flash]
	@tools/setup.sh run
	@$(MAKE) $(WALK)
	@$(PY) tools/boot.py --board '$(BOARD)' --image $(IMAGE) --elf $(WALK) \
	    --dump $(BUILD)/boot/$(BOARD).fxld $(FRAMES_OPTION)

gdb: ## open a debugger on a board, booted from its flash image, stopped at main [BOARD= FRAMES= GDB_COMMANDS=file]
	@tools/setup.sh gdb
	@$(MAKE) $(WALK)
	@$(PY) tools/gdb.py --board '$(BOARD)' --image $(IMAGE) --elf $(WALK) $(FRAMES_OPTION) \
	    $(if $(GDB_COMMANDS),--commands '$(GDB_COMMANDS)')

compare: ## compare two PNGs, folders of PNGs, or frame dumps [A= B= TOLERANCE=0 OUT=]
ifneq ($(filter compare,$(MAKECMDGOALS)),)
include tools/compare.mk
endif

report: ## measure every claim about accuracy, beside plain 16.16 and float32: an HTML page, JSON [SAMPLES= SCENE= SEED= ONLY= FRESH=1]
	@tools/setup.sh report
	@$(MAKE) $(if $(ONLY),$(BUILD)/host/oracle,$(BOARD_WALK.host) $(BOARD_WALK.$(BOARD)) $(HOST_TOOLS))
	@$(PY) tools/report.py --out $(BUILD)/report --build $(BUILD) --board '$(BOARD)' \
	    $(if $(SAMPLES),--samples '$(SAMPLES)') $(if $(SEED),--seed '$(SEED)') $(if $(ONLY),--only '$(ONLY)') $(FRESH_OPTION) \
	    $(if $(filter command environment,$(origin SCENE)),--scene '$(SCENE)')

wire: ## draw a scene's path as wireframes on this machine, compare it with double [SCENE= SCREEN= FRAMES= OUT= FRESH=1]
	@tools/setup.sh run
	@$(MAKE) $(BUILD)/host/wire
	@$(PY) tools/wire.py --scene '$(SCENE)' --build $(BUILD) $(FRAMES_OPTION) $(SCREEN_OPTION) $(FRESH_OPTION) \
	    --out '$(if $(filter file,$(origin OUT)),$(BUILD)/wire,$(OUT))'

PICTURE ?= $(BUILD)/screen/$(BOARD).png

screen: ## save what a board's screen shows after the last frame [BOARD= PROGRAM=walk SCENE= SCREEN= FRAMES= VISIBILITY= CLIPPER= ROWS= DEVICE= PICTURE=]
	@tools/setup.sh run
	@$(MAKE) $(WALK)
	@$(PY) tools/screen.py --board '$(BOARD)' --scene '$(SCENE)' --out '$(PICTURE)' --build $(BUILD) \
	    $(FRAMES_OPTION) $(SCREEN_OPTION) $(METHODS_OPTIONS) $(if $(DEVICE),--device '$(DEVICE)')

pictures: ## renew the pictures of the documents (needs make run and make report)
	@tools/setup.sh test
	@$(MAKE) $(BOARD_WALK.$(BOARD)) $(BUILD)/host/live $(BUILD)/host/frames $(BUILD)/host/libfixel.a
	@$(PY) tools/pictures.py --run $(BUILD)/run --out docs/plaza.png
	@$(PY) tools/first_program.py --library $(BUILD)/host/libfixel.a --out docs/cube.png
	@$(PY) tools/first_program.py --hud --library $(BUILD)/host/libfixel.a --out docs/hud.png
	@$(PY) tools/first_program.py --library $(BUILD)/host/libfixel.a --crowd --out docs/world.png
	@$(PY) tools/first_program.py --library $(BUILD)/host/libfixel.a --crate --out docs/crate.png
	@$(PY) tools/first_program.py --library $(BUILD)/host/libfixel.a --neon --out docs/neon.png
	@$(MAKE) screen BOARD=lm3s6965evb SCENE=scenes/plaza.toml SCREEN=128x64 FRAMES=31 \
	    PICTURE=docs/oled.png
	@$(PY) tools/report.py --out $(BUILD)/report --picture docs/precision.png
	@$(MAKE) run SCENE=scenes/beam.toml OUT=$(BUILD)/beam
	@$(PY) tools/pictures.py --run $(BUILD)/beam --frames 20,66,92 --out docs/beam.png
	@$(MAKE) run SCENE=scenes/room.toml SCREEN=320x240 OUT=$(BUILD)/room
	@$(PY) tools/pictures.py --run $(BUILD)/room --frames 4,18,31 --out docs/room.png
	@$(MAKE) run SCENE=scenes/grove.toml SCREEN=320x240 OUT=$(BUILD)/grove
	@$(PY) tools/pictures.py --run $(BUILD)/grove --frames 4,22,44 --out docs/grove.png
	@$(MAKE) run SCENE=scenes/spin.toml OUT=$(BUILD)/spin
	@$(PY) tools/pictures.py --run $(BUILD)/spin --frames 5,25,70 --out docs/spin.png
	@$(MAKE) run PROGRAM=game OUT=$(BUILD)/game
	@$(PY) tools/pictures.py --run $(BUILD)/game --frames 60,120,200 --out docs/game.png
	@$(MAKE) wire SCENE=scenes/plaza.toml FRAMES=106 OUT=$(BUILD)/wire
	@$(PY) tools/pictures.py --run $(BUILD)/wire --frames 30,45,105 --out docs/wire.png
	@$(PY) tools/scene.py build scenes/plaza.toml -o $(BUILD)/lit.fxls
	@for light in day lamps dusk; do $(BUILD)/host/frames $(BUILD)/lit.fxls $(BUILD)/$$light.fxld --light $$light || exit 1; done
	@$(PY) tools/pictures.py --dumps $(BUILD)/day.fxld $(BUILD)/lamps.fxld $(BUILD)/dusk.fxld --frames 40,40,20 --out docs/light.png
	@for scene in landscape gallery car; do $(PY) tools/scene.py build scenes/$$scene.toml --screen 320x240 -o $(BUILD)/$$scene.fxls && \
	    $(BUILD)/host/frames $(BUILD)/$$scene.fxls $(BUILD)/$$scene.fxld || exit 1; done
	@$(PY) tools/pictures.py --dumps $(BUILD)/landscape.fxld $(BUILD)/gallery.fxld $(BUILD)/car.fxld --frames 70,6,63 --out docs/scenes.png
	@$(PY) tools/record.py --board '$(BOARD)' --scene scenes/plaza.toml --build $(BUILD) --out docs/window.gif

# lib/lib.mk has the recipe. Each of its objects depends on the file of the flags, and so on set-up.
lib: ## build the library and its headers for your firmware [CORE=cortex-m3 SIZE=1 LIB_FLAGS=]
$(BUILD)/lib/$(CORE)/flags: | set-up-lib
set-up-lib:
	@tools/setup.sh lib

SIZE_CORES := cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33
SIZE_LIBRARIES := $(foreach core,$(SIZE_CORES),--library $(core)=$(BUILD)/lib/$(core)/libfixel.a)

size: ## print flash, RAM and stack; check that the library has no float and no heap
	@tools/setup.sh run
	@$(MAKE) $(WALK)
	@for core in $(SIZE_CORES); do echo "  LIB  $$core" && \
	    $(MAKE) lib CORE=$$core >/dev/null || exit; done
	@$(PY) tools/size.py --board '$(BOARD)' $(if $(filter %.elf,$(WALK)),--elf $(WALK) \
	    --usage $(dir $(WALK)) $(call BOARD_CORE_OUT,$(BOARD))/lib) \
	    $(SIZE_LIBRARIES) --cross $(CROSS) --out $(BUILD)/size.json

# What make predict has costs of: bench/costs.json.
COSTS_BOARDS := microbit mps2-an385 lm3s6965evb stm32vldiscovery netduinoplus2 mps2-an386 mps2-an500 mps3-an547
LIST_MOST_OF = $(or $(patsubst WALK_LIST_MOST=%,%,$(filter WALK_LIST_MOST=%,$(BOARD_SETTINGS.$(1)))),0)

predict: ## predict flash, RAM, stack and instructions a frame before anything is built for the board [BOARD= SCENE= SCREEN= FRAMES= JSON=]
	@tools/setup.sh predict
	@$(MAKE) $(BUILD)/host/predict
	@$(PY) tools/predict.py --board '$(BOARD)' --core '$(BOARD_CORE.$(BOARD))' --scene '$(SCENE)' --build $(BUILD) \
	    --band $(BOARD_BAND_BYTES.$(BOARD)) --order $(BOARD_ORDER_ENTRIES.$(BOARD)) --list $(BOARD_LIST_BYTES.$(BOARD)) \
	    --cache $(BOARD_CACHE_ENTRIES.$(BOARD)) --list-most $(call LIST_MOST_OF,$(BOARD)) \
	    $(if $(filter WALK_WITHOUT_SURFACES,$(BOARD_SETTINGS.$(BOARD))),--without-surfaces) \
	    $(FRAMES_OPTION) $(SCREEN_OPTION) $(if $(JSON),--json '$(JSON)')

costs: ## renew bench/costs.json, from which make predict predicts [COSTS_CORES= of the bench's cores, COSTS_BOARDS=]
	@tools/setup.sh report
	@$(MAKE) $(BUILD)/host/predict $(BENCH_COUNTER) $(COSTS_PROGRAMS) $(foreach board,$(COSTS_BOARDS),$(BOARD_WALK.$(board)))
	@$(PY) tools/costs.py --cores $(COSTS_CORES) --sizes $(COSTS_SETTINGS) --boards $(COSTS_BOARDS) --build $(BUILD)

# BOARD= on the command line: what runs on that board and nothing else.
TEST_BOARD := $(if $(filter command environment,$(origin BOARD)),$(BOARD))
# Without it, the unit tests run on a board for each build of the library, on the one with the most memory for a band of
# pixels; make boards runs them on every board.
TEST_BOARDS_OF = $(foreach board,$(TARGET_BOARDS),$(if $(filter $(1),$(call CORE_SHARED,$(call CORE_NAME,$(board)))),$(board)))
TEST_BOARD_OF = $(lastword $(shell printf '%s\n' $(foreach board,$(1),$(BOARD_BAND_BYTES.$(board)):$(board)) | sort -n | tr ':\n' '  '))
TEST_BOARDS := $(if $(TEST_BOARD),$(filter $(TEST_BOARD),$(TARGET_BOARDS)),\
    $(foreach core,$(CORES_SHARED),$(call TEST_BOARD_OF,$(call TEST_BOARDS_OF,$(core)))))
# What the tests of the bench run.
BENCH_TESTED := $(BENCH_COUNTER) $(foreach core,$(BENCH_CORES_HERE),$(BENCH_OUT)/$(core)/calibration.elf) $(BENCH_PROGRAMS.m3) $(BENCH_SIZES.m3)
TEST_UNITS := $(foreach board,$(TEST_BOARDS),$(BOARD_UNITS.$(board))) $(if $(filter-out host,$(TEST_BOARD)),,$(UNITY_TESTS))
# What the tests of the tools run, and all that make boards links.
TEST_PROGRAMS := $(if $(TEST_BOARD),,$(HOST_TOOLS) $(BENCH_TESTED) $(CLIPPERS_TESTED) $(EQUALITY_PROGRAMS) \
    $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_FAULTS.$(board)) $(BOARD_UNITS.$(board))))
# For tools: a board, and what says which unit tests it has.
UNIT_OPTIONS = $(foreach board,$(1),--units $(board) $(BOARD_UNITS.$(board)))
# A folder and the names in it, not a path for each: Linux gives one command 128 KiB.
HOST_UNIT_OPTIONS = $(foreach folder,$(sort $(dir $(UNITY_TESTS))),--host-units $(folder) $(notdir $(filter $(folder)%,$(UNITY_TESTS))))

test-programs: $(TEST_UNITS) $(TEST_PROGRAMS)

test: ## run the tests, on the host and on a board for each build of the library [BOARD= of one board, ONLY=, WHOLE=1: all of what is otherwise sampled]
	@tools/setup.sh test
	@$(MAKE) test-programs
	@FIXEL_BUILT='$(TEST_PROGRAMS)' $(if $(WHOLE),FIXEL_WHOLE=1) $(PY) tools/test.py $(HOST_UNIT_OPTIONS) $(call UNIT_OPTIONS,$(TEST_BOARDS)) \
	    $(TEST_BOARD:%=--board %) $(if $(ONLY),--only '$(ONLY)')

boards-programs: $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_UNITS.$(board)))

boards: ## compare all boards: memory, stack, speed, frames equal to the host's, unit tests
	@tools/setup.sh units
	@$(MAKE) boards-programs
	@$(PY) tools/boards.py --boards $(TARGET_BOARDS) --scene scenes/tiny.toml scenes/plaza.toml \
	    $(call UNIT_OPTIONS,$(TARGET_BOARDS)) --build $(BUILD) --out $(BUILD)/boards.json

bench: ## count the instructions of frames and kernels on four cores, beside the chapter's listing: a report, JSON
	@tools/setup.sh report
	@$(MAKE) bench-programs
	@$(PY) tools/bench.py --cores $(BENCH_CORES_HERE) $(if $(BENCH_LEFT_OUT),--left-out $(BENCH_LEFT_OUT)) \
	    --out $(BENCH_OUT) --build $(BUILD)

clippers: ## compare every clipper with every visibility method: an HTML page, JSON [FRAMES= ONLY=]
	@tools/setup.sh report
	@$(MAKE) $(CLIPPERS_BUILT) $(BOARD_WALK.host)
	@$(PY) tools/clippers.py --out $(BUILD)/clippers --build $(BUILD) --cores $(CLIPPERS_CORES) \
	    $(FRAMES_OPTION) $(if $(ONLY),--only '$(ONLY)')

clippers-accept: ## take the last make clippers into docs/clipping.md and bench/clippers.json
	@tools/setup.sh report
	@$(PY) tools/clippers.py --out $(BUILD)/clippers --build $(BUILD) --accept

bench-diff: ## compare the last make bench with bench/baseline.json [THRESHOLD=0.5]
	@tools/setup.sh tools
	@$(PY) tools/bench_diff.py --current $(BENCH_OUT)/bench.json $(if $(THRESHOLD),--threshold '$(THRESHOLD)')

bench-baseline: ## take the last make bench as the baseline, and renew the tables of docs/performance.md
	@tools/setup.sh tools
	@$(PY) tools/bench_diff.py --current $(BENCH_OUT)/bench.json --accept

# CORE here is one of the bench's; the default of the other commands is none.
PROFILE_CORE := $(if $(filter file,$(origin CORE)),m3,$(CORE))
PROFILE_RENDERER := $(or $(RENDERER),fixel)
profile: ## show where a workload's instructions go: functions, lines, flame graph [WORKLOAD=w1 CORE=m3 RENDERER= FRAMES=]
	@tools/setup.sh run
	@$(MAKE) $(BENCH_COUNTER) $(filter %/$(PROFILE_RENDERER).elf,$(BENCH_PROGRAMS.$(PROFILE_CORE)))
	@$(PY) tools/profile_frame.py --workload '$(or $(WORKLOAD),w1)' --core '$(PROFILE_CORE)' \
	    --renderer '$(PROFILE_RENDERER)' --build $(BUILD) $(FRAMES_OPTION)

equality: ## compare every kernel of every core with the portable one, on the emulated core [THOUSANDS=10000 JOBS= KEEP=bench/equality.json]
	@tools/setup.sh run
	@$(MAKE) $(EQUALITY_PROGRAMS)
	@$(PY) tools/equality.py $(EQUALITY_PROGRAMS) $(if $(THOUSANDS),--thousands '$(THOUSANDS)') $(if $(JOBS),--jobs '$(JOBS)') \
	    $(if $(KEEP),--keep '$(KEEP)')

fuzz: ## fuzz the scene loader, the whole pipeline and the tools' input, print the branches reached [SECONDS=60]
	@tools/setup.sh fuzz
	@$(MAKE) $(FUZZ_PROGRAMS) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%)
	@$(FUZZ_TOOLS_INPUT)
	@$(PY) tools/fuzz.py --seconds $(or $(SECONDS),60) --build $(BUILD) --clang '$(FUZZ_CLANG)'

kills: ## kill run, flash, boot, view and report at random moments: nothing may be left [KILLS=200 SEED=1]
	@tools/setup.sh test
	@$(MAKE) $(BOARD_WALK.host) $(BOARD_WALK.$(BOARD)) $(BOARD_WALK.lm3s6965evb) $(HOST_TOOLS)
	@$(PY) tools/kills.py --board '$(BOARD)' --streaming lm3s6965evb --build $(BUILD) $(if $(KILLS),--kills '$(KILLS)') $(if $(SEED),--seed '$(SEED)')

seeded-bugs: ## break the library on purpose, one place at a time; the tests must fail each time
	@tools/setup.sh units
	@$(PY) tools/seeded_bugs.py --build $(BUILD)

coverage: ## print which lines, branches and conditions of lib/ the unit tests and the fuzzer's corpus reach
	@tools/setup.sh coverage
	@$(MAKE) $(COVERAGE_TESTS) $(COVERAGE_REPLAYS)
	@$(PY) tools/coverage.py --library $(COVERAGE_LIBRARY) --tests $(COVERAGE_TESTS) --out $(BUILD)/coverage.json \
	    $(foreach target,$(FUZZ_TARGETS),--replay $(COVERAGE_OUT)/replay_$(target) host_tests/fuzz/corpus/$(target))

mutants: ## put random small mistakes into the library; a test must fail for most of them [SEED=1 COUNT=200 ONLY=]
	@tools/setup.sh units
	@$(MAKE) $(UNIT_PROGRAMS) $(FUZZ_TARGETS:%=$(FUZZ_OUT)/replay_%)
	@$(PY) tools/mutants.py --seed '$(or $(SEED),1)' --count '$(or $(COUNT),200)' $(if $(ONLY),--only '$(ONLY)') \
	    --build $(BUILD) --cc '$(HOSTCC) $(UNIT_CFLAGS) -DFXL_ASSERT_HOOK' --tests $(UNIT_PROGRAMS) \
	    $(foreach target,$(FUZZ_TARGETS),--replay $(FUZZ_OUT)/replay_$(target) host_tests/fuzz/record/$(target).txt \
	    host_tests/fuzz/corpus/$(target) $(FUZZ_REPLAY_OBJECTS_$(target)))

format: ## format the C sources with clang-format
	@tools/setup.sh format
	@find lib boards firmware host_tests bench -name '*.[ch]' -exec clang-format -i {} +

clean: ## remove what was built (keeps .venv)
	@rm -rf $(BUILD)
