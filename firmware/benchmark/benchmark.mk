# SPDX-License-Identifier: MIT
# The benchmark for real boards, on each board that has a main here: firmware/benchmark/<board>.c.
#   $(BENCHMARK_OF.<board>)  the program

BENCHMARK_OUT := $(BUILD)/benchmark
BENCHMARK_MAINS := $(patsubst firmware/benchmark/%.c,%,$(filter-out %/benchmark.c,$(wildcard firmware/benchmark/*.c)))
BENCHMARK_BOARDS := $(filter $(BOARDS),$(BENCHMARK_MAINS))
BENCHMARK_SCENE.cube := examples/cube/cube.obj --palette
BENCHMARK_SCENE.spin := scenes/spin.toml
BENCHMARK_SCENE.plaza := scenes/plaza.toml
BENCHMARK_HEADERS := $(foreach scene,cube spin plaza,$(BENCHMARK_OUT)/$(scene)_scene.h)
BENCHMARK_OF = $(FIRMWARE_OUT)/$(1)/benchmark$(if $(BOARD_HOSTED.$(1)),,.elf)
BENCHMARK_OBJECTS_OF = $(addprefix $(FIRMWARE_OUT)/$(1)/firmware/benchmark/,benchmark.o $(1).o)

$(BENCHMARK_HEADERS): $(BENCHMARK_OUT)/%_scene.h: firmware/benchmark/benchmark.mk $(wildcard tools/fixel/image/*.py)
	$(MAKE_FOLDER)
	$(SAY)
	$(FIRMWARE_QUIET)$(FIXEL) export --c --frames 8 --screen 320x240 $(BENCHMARK_SCENE.$*) -o $@ >/dev/null 2>&1

define BENCHMARK_RULES
$(call BENCHMARK_OBJECTS_OF,$(1)): FLAGS_OF_FILE := -I$(BENCHMARK_OUT) -Ifirmware/benchmark
$(call BENCHMARK_OBJECTS_OF,$(1)): $(BENCHMARK_HEADERS)
$(call BENCHMARK_OF,$(1)): $(call BENCHMARK_OBJECTS_OF,$(1)) $(if $(BOARD_HOSTED.$(1)),$(BUILD)/host/libfixel.a,\
    $(call BOARD_PARTS_OF,$(1)) $(call LIB_OBJECTS_OF,$(1),firmware/benchmark/benchmark.c fxl_turned_instances) $(call BOARD_LINK_SCRIPTS,$(1)))
	$$(call FIRMWARE_LINK,$(if $(BOARD_HOSTED.$(1)),$(HOSTCC),$$(call BOARD_LINK,$(1)) $$(BOARD_LINK_MAP) -nostdlib) $$(filter %.o,$$^) $$(filter %.a,$$^) $(if $(BOARD_HOSTED.$(1)),,-lgcc))
endef
$(if $(BUILT_GOALS),$(foreach board,$(BENCHMARK_BOARDS),$(eval $(call BENCHMARK_RULES,$(board)))))
