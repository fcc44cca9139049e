# SPDX-License-Identifier: MIT
"""Every file of the project has a licence and a copyright, as the REUSE specification asks for: an SPDX line of its own, or
an annotation of REUSE.toml. `reuse lint`, which is no part of the set-up, must pass too."""

import fnmatch
import re
import shutil
import subprocess
import tomllib

import pytest

from conftest import CHECKOUT

BUILT_PROGRAMS = ()
HOLDER = "2026 The Fixel authors"
TAG = "SPDX-License-Identifier" ":"      # in two parts, since this file has another licence than it speaks of
LINE = re.compile(TAG.encode() + b" ?([^\n]*)")
NOT_ASKED = ("LICENSE", "REUSE.toml")


def files():
    """What git has, and what it would add."""
    done = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"], cwd=CHECKOUT, text=True,
                          capture_output=True, check=True)
    return [name for name in done.stdout.split("\0") if name and (CHECKOUT / name).is_file()
            and name not in NOT_ASKED and not name.startswith("LICENSES/")]


def annotations(member):
    """The patterns of files for which REUSE.toml has this member; all have one value."""
    data = tomllib.loads((CHECKOUT / "REUSE.toml").read_text(encoding="utf-8"))["annotations"]
    with_member = [each for each in data if member in each]
    assert all(each["precedence"] == "closest" for each in data)
    patterns = [pattern for each in with_member for pattern in ([each["path"]] if isinstance(each["path"], str) else each["path"])]
    return patterns, {each[member] for each in with_member}


def licence_of(name, content, patterns):
    """The licence of a file, or None. In a pattern ** stands for any letters, and the project uses no other wildcard."""
    own = LINE.search(content) if b"\0" not in content else None
    if own:
        return re.sub(r" *(\*/|-->|[#-]*\})? *$", "", own[1].decode("utf-8", "replace"))
    return "MIT" if any(fnmatch.fnmatchcase(name, pattern.replace("**", "*")) for pattern in patterns) else None


def test_every_file_has_a_licence():
    patterns, licences = annotations("SPDX-License-Identifier")
    found = {name: licence_of(name, (CHECKOUT / name).read_bytes(), patterns) for name in files()}
    assert licences == {"MIT"} and len(found) > 1000
    assert {name: licence for name, licence in found.items() if licence != "MIT"} == {}


def test_every_file_has_the_copyright_of_the_authors():
    patterns, holders = annotations("SPDX-FileCopyrightText")
    assert "**" in patterns and holders == {HOLDER}
    for name in ("LICENSE", "LICENSES/MIT.txt"):
        assert f"Copyright (c) {HOLDER}\n" in (CHECKOUT / name).read_text(encoding="utf-8")


def test_a_pattern_of_the_annotations_that_no_file_needs_is_none():
    patterns, _ = annotations("SPDX-License-Identifier")
    without = [name for name in files() if licence_of(name, (CHECKOUT / name).read_bytes(), []) is None]
    assert [pattern for pattern in patterns if not fnmatch.filter(without, pattern.replace("**", "*"))] == []


@pytest.mark.parametrize("name, content, licence", [
    ("tools/new.py", b"import os\n", None), ("lib/math/new.c", f"/* {TAG} GPL-2.0 */\n".encode(), "GPL-2.0"),
    ("lib/math/new.h", f"/* {TAG} MIT */\n".encode(), "MIT"), ("docs/new.png", b"\0", "MIT"),
    ("tools/new.html", f"{{#- {TAG} MIT\n-#}}\n".encode(), "MIT"), ("lib/new.bin", f"\0{TAG} MIT".encode(), None)])
def test_what_the_licence_of_a_file_is(name, content, licence):
    assert licence_of(name, content, annotations("SPDX-License-Identifier")[0]) == licence


def test_reuse_says_so_too():
    """Where it is installed."""
    reuse = shutil.which("reuse")
    done = subprocess.run([reuse, "lint"], cwd=CHECKOUT, text=True, capture_output=True, check=False) if reuse else None
    assert done is None or done.returncode == 0, done.stdout
