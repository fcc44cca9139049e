# SPDX-License-Identifier: MIT
# ST's STM32VLDISCOVERY: an STM32F100, a Cortex-M3 without FPU, 128 KiB of
# flash, 8 KiB of RAM.

BOARD_CPU := cortex-m3
BOARD_CORE := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -mno-unaligned-access
BOARD_QEMU := -M stm32vldiscovery
BOARD_OPENOCD := -f board/stm32vldiscovery.cfg

# How 8192 bytes are shared out: 1280 for the program's stack and 320 for the
# handlers' (memory.ld), 2536 for the renderer, 152 that are free, and these: eight rows of 128, or one
# of the widest screen; the 174 objects of the plaza, or what scenes/landscape.toml sorts; a list of
# 15 polygons of four vertices, in which every frame of scenes/tiny.toml fits; no vertices are kept.
# A program with surfaces has a stack of 2024 bytes and fewer entries. What else the walk is made of
# knows nothing of the entries, so only its own object differs.
BOARD_BAND_BYTES := 1024
BOARD_ORDER_ENTRIES := $(if $(filter surfaces,$(VISIBILITY)),128,178)
BOARD_LIST_BYTES := 600
BOARD_CACHE_ENTRIES := 0

# The game would take 6 KiB of flash more than there is.
BOARD_PROGRAM_OMIT := game
# The driver of a display would take 2 KiB of each that there are not.
BOARD_DRIVER_ROWS := 0

# They take 8 to 30 KiB of memory and stack, test_scene a little less; the last a megabyte.
BOARD_UNIT_OMIT := test_clipper_hashes test_scene_hashes test_depth test_depth_surfaces test_depth_hashes test_surface_hashes test_billboards test_pick test_pick_methods test_off_centre_frames test_hud test_outlined test_first_program test_display test_pump test_reach test_world test_world_rules test_world_bsp test_light test_order_model test_clusters test_culling test_visibility test_pieces test_clip_view_bounds test_watertight test_render test_clipper test_clip_once \
    test_half_space test_normalised test_triangle test_clippers test_clippers_work test_clippers_frames test_watertight_clippers test_bsp \
    test_bsp_pieces test_bsp_order test_bsp_spheres test_lit_pieces test_beam_light test_workspace test_workspace_parts test_clip_capacity test_clip_rejects test_scene test_scene_tables test_scene_placed test_turned_frames test_turned_world test_turned_clusters \
    test_surfaces test_surface_light test_surface_levels test_rgb565 test_rgb565_colours test_rgb565_hashes test_billboards_methods \
    test_release test_release_methods test_world_motion

# Speed is the library's: the program is small so that it fits into its 64 KiB.
BOARD_OWN_FLAGS := -Os

# A BSP tree would take 4 KiB of flash more than the program has, and of stack more than there is. Surfaces take
# 16 KiB of flash: the program of VISIBILITY=surfaces has them, and scenes have 16 KiB less (memory.ld). Billboards
# would take 4 KiB.
BOARD_SETTINGS := BOARD_SYSTICK_HZ=24000000u WALK_WITHOUT_BSP WALK_WITHOUT_SURFACES WALK_WITHOUT_BILLBOARDS WALK_WITHOUT_DEPTH

BOARD_SOURCES := boards/stm32vldiscovery/board.c \
    $(addprefix boards/parts/,cortexm_start.c cortexm_fault.c thumb.c armv7m_fault.c armv7m_protect.c stack.c \
        systick.c systick_clock.c systick_watchdog.c semihosting.c semihosting_system.c semihosting_sink.c \
        semihosting_keys.c display.c dump.c partition_store.c memory_functions.c board_note.c)
