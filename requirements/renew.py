#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the hashes of the packages that requirements/*.txt pin: of the wheels for Debian 12 (Python 3.11) and Debian 13
(Python 3.13), on x86-64 and 64-bit Arm. It asks pip's own package index. Change a pin, then run this, then make test.

usage: requirements/renew.py [FILE.txt ...]     all of the folder without"""

import json
import pathlib
import re
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
PYTHONS = ("3.11", "3.13")
MACHINES = ("x86_64", "aarch64")
# glibc of the wheels, up to the 2.36 of Debian 12.
PLATFORMS = (*(f"manylinux_2_{minor}" for minor in range(36, 16, -1)), "manylinux2014", "manylinux2010", "manylinux1")
PIN = re.compile(r"([A-Za-z0-9_.-]+)==[0-9A-Za-z.]+")


def hashes(pins, python, machine):
    """{name in small letters: hash of the wheel that pip takes}."""
    platforms = [word for platform in PLATFORMS for word in ("--platform", f"{platform}_{machine}")]
    done = subprocess.run([sys.executable, "-m", "pip", "install", "--disable-pip-version-check", "--quiet", "--dry-run",
                           "--ignore-installed", "--no-deps", "--only-binary", ":all:", "--target", "unused",
                           "--python-version", python, *platforms, "--report", "-", *pins],
                          stdout=subprocess.PIPE, text=True, check=True)
    return {item["metadata"]["name"].lower().replace("_", "-"): item["download_info"]["archive_info"]["hashes"]["sha256"]
            for item in json.loads(done.stdout)["install"]}


def renew(file):
    """Puts the hashes of a file's pins behind them."""
    lines = [line.removesuffix(" \\") for line in file.read_text(encoding="utf-8").splitlines()
             if not line.startswith("    --hash")]
    pins = [line for line in lines if PIN.fullmatch(line)]
    found = [hashes(pins, python, machine) for python in PYTHONS for machine in MACHINES]
    made = []
    for line in lines:
        name = PIN.fullmatch(line)
        own = sorted({each[name[1].lower().replace("_", "-")] for each in found}) if name else []
        made.append(" \\\n".join([line, *(f"    --hash=sha256:{digest}" for digest in own)]))
    file.write_text("\n".join(made) + "\n", encoding="utf-8")


if __name__ == "__main__":
    for path in map(pathlib.Path, sys.argv[1:]) if sys.argv[1:] else sorted(FOLDER.glob("*.txt")):
        renew(path)
