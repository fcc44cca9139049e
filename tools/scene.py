#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fixel build, export, texture and info, by the name that documents and programs know: tools/fixel/scene/command.py."""
from fixel.base import interpreter; interpreter.choose()
from fixel.base.errors import run_main; from fixel.scene.command import main
if __name__ == "__main__": run_main(main)
