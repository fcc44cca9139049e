# SPDX-License-Identifier: MIT
"""Compares the public headers and functions with those of the last tag: what a program relies on must stay, or the version must say so.

Exit: 0 nothing is gone, or the version allows it, or there is no tag; 1 something is gone or changed; 2 a tool is missing.
"""

import argparse
import io
import os
import pathlib
import re
import shutil
import sys
import tarfile

from fixel.base import children, scratch, version
from fixel.base.errors import ToolError
from fixel.package import repository

ROOT = pathlib.Path(__file__).resolve().parents[3]
# What fixel one-file reads.
READ = ("lib", "tools")
COMPARED = ("--drop-private-types", "--non-reachable-types", "--no-added-syms")
UNUSABLE = 3        # bits of abidiff's exit code: it failed, or did not understand its options
# Macros that change with each version, and guards of headers.
OTHERS = re.compile(r"FXL_VERSION\w*|\w+_H")
SUMMARY = re.compile(r"summary: (\d+) removed, (\d+) changed", re.IGNORECASE)
NAMELESS = re.compile(r"^enum \{(?=(?:\s|/\*.*?\*/)*(\w+))", re.MULTILINE | re.DOTALL)


def parser():
    """The options of the command: none."""
    return argparse.ArgumentParser(description=__doc__.splitlines()[0])


def numbers(text):
    return tuple(map(int, text.split(".")))


def may_break(before, now):
    """Whether a version may break a program for another one: its first number is greater, or the second while the first is 0."""
    before, now = numbers(before), numbers(now)
    return now[:2] > before[:2] if now[0] == before[0] == 0 else now[0] > before[0]


def tree_of(root, tag, folder):
    """What a tag has, in a folder."""
    archive = repository.git(root, "archive", "--format=tar", tag, *READ)
    with tarfile.open(fileobj=io.BytesIO(archive)) as file:
        file.extractall(folder)
    (folder / ".venv").symlink_to(sys.prefix)
    return folder


def run(*command):
    """Runs a command that must pass; what it printed."""
    done = children.run(command, text=True)
    if done.returncode:
        raise ToolError(f"{pathlib.Path(command[0]).name}: failed", words=done.stdout + done.stderr)
    return done.stdout


def with_names(header):
    """A header in which each enumeration without a name has one: that of its first member. abidiff numbers the others, so that a
    new one would look like a change of all that follow it."""
    return NAMELESS.sub(lambda found: f"enum of_{found[1]} {{", header)


def built(tree, folder):
    """(a shared object, the folder of its header, its macros) of a tree, as its own fixel one-file writes it."""
    headers, made = folder / "headers", folder / "made"
    headers.mkdir(parents=True)
    run(sys.executable, tree / "tools" / "fixel" / "launcher.py", "one-file", "--out", made)
    header = made / "fixel.h"
    (headers / "fixel.h").write_text(with_names(header.read_text(encoding="utf-8")), encoding="utf-8")
    header.unlink()
    compiler = (os.environ.get("HOSTCC") or "gcc").split()
    run(*compiler, "-std=c11", "-g", "-O0", "-fPIC", "-shared", "-fno-eliminate-unused-debug-types", f"-I{headers}", made / "fixel.c",
        "-o", folder / "libfixel.so")
    defined = run(*compiler, "-std=c11", "-dM", "-E", "-x", "c", headers / "fixel.h")
    names = {name for name in re.findall(r"^#define (FXL_\w+)", defined, re.MULTILINE) if not OTHERS.fullmatch(name)}
    return folder / "libfixel.so", headers, names


def changes(before, now):
    """What a program may rely on and is gone or changed, as text; "" if nothing is. before, now: what built() answered."""
    command = ["abidiff", *COMPARED, "--headers-dir1", before[1], "--headers-dir2", now[1], before[0], now[0]]
    done = children.run(command, text=True)
    if done.returncode & UNUSABLE or done.returncode < 0:
        raise ToolError("abidiff: failed", words=done.stdout + done.stderr)
    found = [f"macro {name}: removed" for name in sorted(before[2] - now[2])]
    return "\n".join([done.stdout.strip()] * (done.returncode != 0 and not is_all_new(done.stdout)) + found)


def is_all_new(said):
    """Whether abidiff told only of what is new, as it does of a type that no function takes: all counts of its summaries are 0."""
    counts = SUMMARY.findall(said)
    return bool(counts) and not any(int(count) for pair in counts for count in pair)


def compared(root, tag):
    """(the version of a tag, what has changed since it)."""
    if shutil.which("abidiff") is None:
        raise ToolError("not run: needs abidiff, of the Debian package abigail-tools")
    with scratch.folder("api") as folder:
        folder = pathlib.Path(folder)
        (folder / "tree").mkdir()
        tree = tree_of(root, tag, folder / "tree")
        found = changes(built(tree, folder / "before"), built(root, folder / "now"))
        return version.version(tree / "lib" / "include" / "fixel" / "version.h"), found


def check(root):
    """Compares a checkout with its last tag; the exit code."""
    repository.require(root)
    tag = repository.last_tag(root)
    if tag is None:
        print("api: no tag to compare")
        return 0
    before, found = compared(root, tag)
    now = version.version(root / "lib" / "include" / "fixel" / "version.h")
    if not found:
        print(f"api: what {tag} has is there, unchanged")
        return 0
    print(found)
    if may_break(before, now):
        print(f"api: changed since {tag}, as version {now} may be")
        return 0
    part = "MINOR" if numbers(now)[0] == 0 else "MAJOR"
    print(f"api: a program for {tag} may break: take the change back, or raise FXL_VERSION_{part} of lib/include/fixel/version.h")
    return 1


def main(argv):
    """The command; its exit code."""
    parser().parse_args(argv)
    return check(ROOT)
