# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: The Fixel authors
"""Every command of `make help` works: a small form of each, in a copy of the checkout, because some renew its files.

What takes more than its share runs where FIXEL_COMMANDS is set: to "ci", what is no campaign of minutes."""

import os
import pathlib
import re
import shutil
import subprocess
import tomllib

import pytest
from conftest import CHECKOUT, environment, run_make

BUILT_PROGRAMS = ()
TABLE = tomllib.loads(pathlib.Path(__file__).with_name("commands.toml").read_text(encoding="utf-8"))
WANTED = os.environ.get("FIXEL_COMMANDS") or ("all" if os.environ.get("FIXEL_WHOLE") else "")
GDB_COMMANDS = "info functions main\nkill\nquit\n"


def helped():
    """The commands of make help."""
    return re.findall(r"^  make ([a-z-]+) ", run_make("help").stdout, re.MULTILINE)


def needed(name):
    """Whether a command runs here."""
    return TABLE[name].get("always") or WANTED == "ci" and not TABLE[name].get("long") or WANTED not in ("", "ci")


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """A copy of the files that git tracks, with their times, so that make finds what it has built; build is the
    checkout's, and so are the packages of .venv."""
    root = tmp_path_factory.mktemp("commands") / "fixel"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=CHECKOUT, capture_output=True, check=True).stdout
    for name in map(os.fsdecode, filter(None, listed.split(b"\0"))):
        if (CHECKOUT / name).exists():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(CHECKOUT / name, root / name)
    (root / "build").symlink_to(CHECKOUT / "build")
    (root / ".venv").mkdir()
    for each in (CHECKOUT / ".venv").iterdir():
        (root / ".venv" / each.name).symlink_to(each)
    key = subprocess.run(["sh", "-c", "{ python3 -c 'import sys; print(sys.version, sys.executable)'; pwd; } "
                          "| sha256sum | cut -d' ' -f1"], cwd=root, capture_output=True, check=True).stdout
    (root / ".venv/.made").unlink()
    (root / ".venv/.made").write_bytes(key)
    (root / "build/commands.gdb").write_text(GDB_COMMANDS)
    return root


def test_each_command_of_help_has_a_small_form():
    assert sorted(helped()) == sorted(TABLE)


def test_a_command_stands_behind_those_whose_results_it_works_on():
    names = list(TABLE)
    for name, entry in TABLE.items():
        assert all(names.index(before) < names.index(name) for before in entry.get("after", "").split()), name


@pytest.mark.parametrize("name", [name for name, entry in TABLE.items() if "tested" in entry])
def test_a_command_without_a_small_form_is_typed_by_its_own_tests(name):
    (file,) = CHECKOUT.glob(f"host_tests/*/{TABLE[name]['tested']}")
    assert re.search(rf'"make", ("--no-print-directory", )?"{name}"', file.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", [name for name, entry in TABLE.items() if "make" in entry and needed(name)])
def test_a_command_works(name, copy):
    done = subprocess.run(["make", *TABLE[name]["make"].split()], cwd=copy, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=False, env=environment())
    said = done.stdout + done.stderr
    refused = TABLE[name].get("refused", "")
    assert (done.returncode != 0) == bool(refused) and refused in said, said[-4000:]
    assert TABLE[name].get("prints", "") in said
    if "prints_first_of" in TABLE[name]:
        assert (CHECKOUT / TABLE[name]["prints_first_of"]).read_text(encoding="utf-8").split()[0] in said
    assert "Traceback" not in said
