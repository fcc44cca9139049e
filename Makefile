# SPDX-License-Identifier: MIT
# Fixel: every command. Each installs what it lacks (tools/setup.sh) and says so.

BUILD    := build
HOSTCC   ?= gcc
CROSS    ?= arm-none-eabi-
PY       := .venv/bin/python
WARNINGS := -std=c11 -Wall -Wextra -Wconversion -Wshadow -Wpedantic -Werror

BOARD ?= mps2-an385
SCENE ?= scenes/plaza.toml
CORE  ?= cortex-m3
OUT   ?= $(BUILD)/run

HOST_TOOLS :=
UNITY_TESTS :=
export CROSS HOSTCC

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:

# Quiet unless V=1: of a recipe for the host only the file that it makes is named.
ifndef V
.SILENT:
SHELL = $(if $(filter-out $(MADE),$(filter $(BUILD)/host/%,$@)),$(eval MADE := $@)$(info $()  HOST $@))/bin/sh
endif

# --- boards ------------------------------------------------------------------

BOARDS := $(sort $(patsubst boards/%/board.mk,%,$(wildcard boards/*/board.mk)))
ifeq ($(filter $(BOARD),$(BOARDS)),)
$(error there is no board "$(BOARD)"; the boards are: $(BOARDS))
endif

# --- set-up ------------------------------------------------------------------

# What the goals of this command line need. It runs while make reads this, so
# that set-up is over before the first compiler starts, also under -j. Where
# nothing is missing it takes a few hundredths of a second.
NEEDS_run    := run view flash boot size screen bench profile equality
NEEDS_report := report wire all clippers
NEEDS_test   := test boards seeded-bugs pictures
NEEDS_lib    := lib
NEEDS_format := format
NEEDS_fuzz   := fuzz
NEEDS_tools  := compare bench-diff bench-baseline clippers-accept
NEEDS_gdb    := gdb
NEEDS_probe  := $(if $(PROBE),$(if $(DRY_RUN),,flash))
SETUP := $(strip $(foreach what,run report test lib format fuzz tools gdb probe,\
    $(if $(filter $(NEEDS_$(what)),$(MAKECMDGOALS)),$(what))))

# Once: not again in a make that this one started.
ifeq ($(FIXEL_SETUP),)
ifneq ($(SETUP),)
ifneq ($(shell tools/setup.sh $(SETUP) >&2 && echo done),done)
$(error set-up is not complete; see above)
endif
export FIXEL_SETUP := $(SETUP)
endif
endif

# --- the parts ---------------------------------------------------------------

include $(wildcard lib/lib.mk)
include $(wildcard firmware/firmware.mk)
include $(wildcard host_tests/*/*.mk)
include bench/bench.mk
include bench/clippers.mk
include firmware/equality/equality.mk

HOST_WALK := $(BOARD_WALK.host)
WALK      := $(BOARD_WALK.$(BOARD))
IMAGE     := $(BUILD)/flash/$(BOARD).bin
# A scene image is its own.
FXLS := $(if $(filter %.fxls,$(SCENE)),$(SCENE),$(BUILD)/scenes/$(basename $(notdir $(SCENE))).fxls)
FRAMES_OPTION := $(if $(FRAMES),--frames $(FRAMES))
SCREEN_OPTION := $(if $(SCREEN),--screen '$(SCREEN)')

# --- commands ----------------------------------------------------------------

.PHONY: FORCE help all run view flash boot gdb compare report screen pictures wire lib test boards bench \
    clippers clippers-accept bench-diff bench-baseline profile equality fuzz seeded-bugs size format clean

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1@\2/p' Makefile | \
	    while IFS=@ read -r name what; do printf '  %-14s %s\n' "$$name" "$$what"; done
	@echo "Boards: $(BOARDS)"

all: $(WALK) $(HOST_WALK) $(HOST_TOOLS) ## build everything and run nothing

run: $(WALK) $(HOST_WALK) $(BUILD)/host/judge ## walk a scene on a board and compare with double [BOARD= SCENE= SCREEN= FRAMES= OUT=]
	@$(PY) tools/run.py --board '$(BOARD)' --scene '$(SCENE)' --out '$(OUT)' --build $(BUILD) $(FRAMES_OPTION) $(SCREEN_OPTION)

view: $(WALK) $(BUILD)/host/live ## watch a board live on a web page of this machine, and walk [BOARD= SCENE= SCREEN= PORT= OPEN=1]
	@$(PY) tools/view.py --board '$(BOARD)' --scene '$(SCENE)' --build $(BUILD) \
	    $(SCREEN_OPTION) $(if $(PORT),--port '$(PORT)') $(if $(OPEN),--open)

flash: $(WALK) ## write firmware and scene to the board's flash image, or to the real board [BOARD= SCENE= SCREEN= PROBE=openocd DRY_RUN=1]
ifeq ($(filter %.fxls,$(SCENE)),)
	@mkdir -p $(BUILD)/scenes
	@$(PY) tools/scene.py build '$(SCENE)' -o '$(FXLS)' $(FRAMES_OPTION) $(SCREEN_OPTION)
else ifneq ($(SCREEN),)
	@echo "error: $(SCENE) is a scene image, which has its screen already: give the .toml or .obj" >&2; exit 2
endif
	@$(PY) tools/flash.py --board '$(BOARD)' --elf $(WALK) --scene '$(FXLS)' --image $(IMAGE) \
	    $(if $(PROBE),--probe '$(PROBE)') $(if $(DRY_RUN),--dry-run)

boot: $(WALK) ## power a board on from its flash image [BOARD=]
	@$(PY) tools/boot.py --board '$(BOARD)' --image $(IMAGE) --elf $(WALK) \
	    --dump $(BUILD)/boot/$(BOARD).fxld $(FRAMES_OPTION)

gdb: $(WALK) ## a debugger on the walk, from the board's flash image, stopped at main [BOARD= FRAMES= GDB_COMMANDS=file]
	@$(PY) tools/gdb.py --board '$(BOARD)' --image $(IMAGE) --elf $(WALK) $(FRAMES_OPTION) \
	    $(if $(GDB_COMMANDS),--commands '$(GDB_COMMANDS)')

compare: ## compare two PNGs, folders of PNGs or frame dumps [A= B= TOLERANCE=0 OUT=]
ifneq ($(filter compare,$(MAKECMDGOALS)),)
include tools/compare.mk
endif

report: $(HOST_WALK) $(WALK) $(HOST_TOOLS) ## every claim measured, naive 16.16 and float beside: an HTML page, JSON [SAMPLES= SCENE= SEED=]
	@$(PY) tools/report.py --out $(BUILD)/report --build $(BUILD) --board '$(BOARD)' \
	    $(if $(SAMPLES),--samples '$(SAMPLES)') $(if $(SEED),--seed '$(SEED)') \
	    $(if $(filter command environment,$(origin SCENE)),--scene '$(SCENE)')

wire: $(BUILD)/host/wire ## a scene's path as wireframes, drawn here and compared with double [SCENE= SCREEN= FRAMES= OUT=]
	@$(PY) tools/wire.py --scene '$(SCENE)' --build $(BUILD) $(FRAMES_OPTION) $(SCREEN_OPTION) \
	    --out '$(if $(filter file,$(origin OUT)),$(BUILD)/wire,$(OUT))'

PICTURE ?= $(BUILD)/screen/$(BOARD).png

screen: $(WALK) ## what a board's screen shows after the last frame [BOARD= SCENE= SCREEN= FRAMES= DEVICE= PICTURE=]
	@$(PY) tools/screen.py --board '$(BOARD)' --scene '$(SCENE)' --out '$(PICTURE)' --build $(BUILD) \
	    $(FRAMES_OPTION) $(SCREEN_OPTION) $(if $(DEVICE),--device '$(DEVICE)')

pictures: $(WALK) $(BUILD)/host/live ## the README's pictures anew, from make run, make report and make view
	@$(PY) tools/pictures.py --run $(BUILD)/run --out docs/plaza.png
	@$(MAKE) --no-print-directory screen BOARD=lm3s6965evb SCENE=scenes/plaza.toml SCREEN=128x64 FRAMES=31 \
	    PICTURE=docs/oled.png
	@$(PY) tools/report.py --out $(BUILD)/report --picture docs/precision.png
	@$(MAKE) --no-print-directory run SCENE=scenes/beam.toml OUT=$(BUILD)/beam
	@$(PY) tools/pictures.py --run $(BUILD)/beam --frames 20,66,92 --out docs/beam.png
	@$(MAKE) --no-print-directory wire SCENE=scenes/plaza.toml FRAMES=106 OUT=$(BUILD)/wire
	@$(PY) tools/pictures.py --run $(BUILD)/wire --frames 30,45,105 --out docs/wire.png
	@$(PY) tools/record.py --board '$(BOARD)' --scene scenes/plaza.toml --build $(BUILD) --out docs/window.gif

lib: ## the library and its headers for your own firmware [CORE=cortex-m3 SIZE=1]

SIZE_CORES := cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33
SIZE_LIBRARIES := $(foreach core,$(SIZE_CORES),--library $(core)=$(BUILD)/lib/$(core)/libfixel.a)

size: $(WALK) ## flash, RAM and worst stack; proof that the library has no float and no heap
	@for core in $(SIZE_CORES); do echo "  LIB  $$core" && \
	    $(MAKE) --no-print-directory lib CORE=$$core >/dev/null || exit; done
	@$(PY) tools/size.py --board '$(BOARD)' $(if $(filter %.elf,$(WALK)),--elf $(WALK) \
	    --usage $(dir $(WALK)) $(call BOARD_CORE_OUT,$(BOARD))/lib) \
	    $(SIZE_LIBRARIES) --cross $(CROSS) --out $(BUILD)/size.json

# BOARD= on the command line: what runs on that board and nothing else.
TEST_BOARD := $(if $(filter command environment,$(origin BOARD)),$(BOARD))
TEST_BOARDS := $(filter $(or $(TEST_BOARD),%),$(TARGET_BOARDS))
# What the tests of the bench run.
BENCH_TESTED := $(BENCH_COUNTER) $(foreach core,$(BENCH_CORES_HERE),$(BENCH_OUT)/$(core)/calibration.elf) $(BENCH_PROGRAMS.m3) $(BENCH_SIZES.m3)
TEST_PROGRAMS := $(foreach board,$(TEST_BOARDS),$(BOARD_UNITS.$(board))) \
    $(if $(filter-out host,$(TEST_BOARD)),,$(UNITY_TESTS)) \
    $(if $(TEST_BOARD),,$(HOST_TOOLS) $(BENCH_TESTED) $(CLIPPERS_TESTED) $(EQUALITY_PROGRAMS) \
    $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_FAULTS.$(board))))
# For tools: a board, its unit tests; a board, the unit tests that it has no room for.
UNIT_OPTIONS = $(foreach board,$(1),--board-unit $(board) $(BOARD_UNITS.$(board)) \
    $(if $(BOARD_UNIT_OMIT.$(board)),--left-out $(board) $(BOARD_UNIT_OMIT.$(board))))

test: $(TEST_PROGRAMS) ## every test: units on host and boards, mocks, tools [BOARD= of one board ONLY=]
	@$(PY) tools/test.py --host-unit $(UNITY_TESTS) $(call UNIT_OPTIONS,$(TEST_BOARDS)) \
	    $(TEST_BOARD:%=--board %) $(if $(ONLY),--only '$(ONLY)')

boards: $(foreach board,$(BOARDS),$(BOARD_WALK.$(board)) $(BOARD_UNITS.$(board))) ## every board: memory, stack, speed, frames equal to the host's, unit tests
	@$(PY) tools/boards.py --boards $(TARGET_BOARDS) --scene scenes/tiny.toml scenes/plaza.toml \
	    $(call UNIT_OPTIONS,$(TARGET_BOARDS)) --build $(BUILD) --out $(BUILD)/boards.json

bench: $(BENCH_BUILT) ## executed instructions of the workloads and kernels on four cores, the chapter's listing beside
	@$(PY) tools/bench.py --cores $(BENCH_CORES_HERE) $(if $(BENCH_LEFT_OUT),--left-out $(BENCH_LEFT_OUT)) \
	    --out $(BENCH_OUT) --build $(BUILD)

clippers: $(CLIPPERS_BUILT) $(HOST_WALK) ## every clipper times every hidden-surface method, measured and judged: an HTML page, JSON [FRAMES= ONLY=]
	@$(PY) tools/clippers.py --out $(BUILD)/clippers --build $(BUILD) --cores $(CLIPPERS_CORES) \
	    $(FRAMES_OPTION) $(if $(ONLY),--only '$(ONLY)')

clippers-accept: ## the last make clippers into docs/clipping.md and bench/clippers.json
	@$(PY) tools/clippers.py --out $(BUILD)/clippers --build $(BUILD) --accept

bench-diff: ## the last make bench against bench/baseline.json: what got slower, by how much [THRESHOLD=0.5]
	@$(PY) tools/bench_diff.py --current $(BENCH_OUT)/bench.json $(if $(THRESHOLD),--threshold '$(THRESHOLD)')

bench-baseline: ## the last make bench as the new baseline, and the tables of docs/performance.md anew
	@$(PY) tools/bench_diff.py --current $(BENCH_OUT)/bench.json --accept

# CORE here is one of the bench's; the default of the other commands is none.
PROFILE_CORE := $(if $(filter file,$(origin CORE)),m3,$(CORE))
PROFILE_RENDERER := $(or $(RENDERER),fixel)
profile: $(BENCH_COUNTER) $(filter %/$(PROFILE_RENDERER).elf,$(BENCH_PROGRAMS.$(PROFILE_CORE))) ## where a workload's instructions go: functions, lines, flame graph [WORKLOAD=w1 CORE=m3 RENDERER= FRAMES=]
	@$(PY) tools/profile_frame.py --workload '$(or $(WORKLOAD),w1)' --core '$(PROFILE_CORE)' \
	    --renderer '$(PROFILE_RENDERER)' --build $(BUILD) $(FRAMES_OPTION)

equality: $(EQUALITY_PROGRAMS) ## every kernel of every core against the portable one, on the emulated core [THOUSANDS=10000 JOBS= KEEP=bench/equality.json]
	@$(PY) tools/equality.py $(EQUALITY_PROGRAMS) $(if $(THOUSANDS),--thousands '$(THOUSANDS)') $(if $(JOBS),--jobs '$(JOBS)') \
	    $(if $(KEEP),--keep '$(KEEP)')

fuzz: $(FUZZ_PROGRAMS) ## libFuzzer over the scene loader and the whole pipeline, and the branches reached [SECONDS=60]
	@$(PY) tools/fuzz.py --seconds $(or $(SECONDS),60) --build $(BUILD) --clang '$(FUZZ_CLANG)'

seeded-bugs: ## break the library on purpose, one place at a time: the tests must see each
	@$(PY) tools/seeded_bugs.py --build $(BUILD)

format: ## lay out the C sources with clang-format
	@find lib boards firmware host_tests bench -name '*.[ch]' -exec clang-format -i {} +

clean: ## remove what was built (keeps .venv)
	@rm -rf $(BUILD)
