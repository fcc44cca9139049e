# SPDX-License-Identifier: MIT
# The machine that builds Fixel, as a board: the scene from a file, the frames
# into a file. Built by HOSTCC; no memory map.

BOARD_CPU := host
BOARD_CORE :=
BOARD_QEMU :=
BOARD_HOSTED := yes

# Narrow bands and a list that is soon full, unlike the emulated boards': frames
# that come out equal also show that a frame does not depend on how it is cut,
# or on what the list holds. The list has 4096 bytes of its memory at most; clippers and visibility
# methods may want the rest. make run BOARD=host draws whole frames (WHOLE_DEFINES of
# firmware/firmware.mk) and compares them with these.
BOARD_BAND_BYTES := 8192
BOARD_ORDER_ENTRIES := 131072
BOARD_LIST_BYTES := 69632
BOARD_CACHE_ENTRIES := 32

BOARD_SETTINGS := WALK_LIST_MOST=4096

BOARD_PARTS := display dump board_note
BOARD_SOURCES := boards/host/board.c
