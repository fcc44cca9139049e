# SPDX-License-Identifier: MIT
"""Programs that run: emulated boards and the host, their flash, displays, dumps, debuggers and probes.

Programs that run, for `fixel run`, `screen`, `flash`, `boot`, `gdb`, `boards`, `benchmark` and `crc`. The command has the module of its
name; `judged_run.py` (`own_run.py` for a program of the user's own), `crc_lines.py`, `screenshot.py`, `flashing.py` and `all_boards.py` do the work of the larger ones. `emulator.py`
runs an emulated board by `qemu.py`, or by `rp2040.py` and the programs of Node beside it, and `programs.py` runs the host's programs. `flash_memory.py` writes flash images,
`dump.py` reads frames, `wires.py` reads what a display was sent, and `debugger.py` and `probe.py` start GDB and OpenOCD. `model_look.py` chooses how a board draws a model without a scene file.
"""
