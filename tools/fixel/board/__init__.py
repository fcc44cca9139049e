# SPDX-License-Identifier: MIT
"""Programs that run: emulated boards and the host, their flash, displays, dumps, debuggers and probes.

The commands `fixel run`, `screen`, `flash`, `boot`, `gdb`, `boards`, `benchmark` and `crc` have the modules of their names;
`own_run.py` runs a program of the user's own for `run`. `emulator.py` runs an emulated board by `qemu.py`, or by `rp2040.py`
and the programs of Node beside it, and `programs.py` runs the host's programs. `flash_memory.py` writes flash images, `dump.py`
reads frames, `wires.py` reads what a display was sent, and `gdb.py` and `probe.py` start GDB and OpenOCD. `sent_bytes.py` says what a
display is sent. `model_look.py` chooses how a board draws a model without a scene file.
"""
