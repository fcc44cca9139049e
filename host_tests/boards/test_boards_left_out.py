# SPDX-License-Identifier: MIT
"""A board whose tools make test does not install: what make boards says where they are missing, and that make test leaves it out."""

import json
import os
import shutil
import subprocess

from board_programs import ROOT, made
from conftest import run_cli


def test_what_is_missing_is_said(tmp_path):
    """A machine with sh and Python alone."""
    for name in ("sh", "dirname", "python3"):
        (tmp_path / name).symlink_to(shutil.which(name))
    done = subprocess.run([ROOT / "tools/setup.sh", "--missing", "riscv"], env={"PATH": str(tmp_path)}, capture_output=True, text=True,
                          check=True)
    needed = "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf qemu-system-misc"
    assert done.stdout.split() == needed.split()
    made("build/boards/microbit/walk.elf", "BOARD=microbit")
    made("build/boards/host/walk", "BOARD=host")
    done = run_cli("boards", "--boards", "microbit", "--scene", "scenes/tiny.toml", "--out", tmp_path / "boards.json", "--not-run", "rv32",
                   *needed.split())
    assert done.returncode == 0 and f"rv32: not run: needs {needed}\n" in done.stdout
    assert json.loads((tmp_path / "boards.json").read_text())["not_run"] == {"rv32": needed.split()}


def test_make_test_leaves_the_board_out():
    """So a machine needs none of its tools for make test."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("MAKE", "MFLAGS", "FIXEL_EXTRA"))}
    said = subprocess.run(["make", "--dry-run", "test"], cwd=ROOT, env=environment, capture_output=True, text=True, check=True).stdout
    assert "boards/microbit" in said and "rv32" not in said
