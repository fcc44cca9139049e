# SPDX-License-Identifier: MIT
"""make api-check on a scratch repository with a tag: what breaks a program fails, and what does not passes."""

import shutil
import subprocess

import pytest

from conftest import CHECKOUT
from fixel.package import api_check
from outside import need

HEADERS = "lib/include/fixel"
# What a change is: {pattern of files: (a text of theirs, what it becomes)}, and what the command says of it.
BREAKS = {
    "an enum value moved": ({f"{HEADERS}/types.h": (" FXL_E_ORDER,", " FXL_E_EXTRA, FXL_E_ORDER,")}, "'fxl_status::FXL_E_ORDER' from value"),
    "a value without a type moved": ({f"{HEADERS}/pick.h": (" FXL_POINT_BEYOND ", " FXL_POINT_BEYOND = 9 ")},
                                     "FXL_POINT_BEYOND' from value '3' to '9'"),
    "a type changed": ({f"{HEADERS}/scene.h": ("    uint8_t recolour;", "    int8_t recolour;")}, "uint8_t recolour"),
    "a member removed": ({f"{HEADERS}/collide.h": ("    uint32_t contacts;", "    //"), "lib/game/slide.c": ("slide->contacts += 1;", "")},
                         "uint32_t contacts"),
    "a macro removed": ({f"{HEADERS}/crc.h": ("#define FXL_CRC_START ", "#define FXL_CRC_BEGIN "),
                         "lib/*/*.c": ("FXL_CRC_START", "FXL_CRC_BEGIN")}, "macro FXL_CRC_START: removed"),
    "a function removed": ({f"{HEADERS}/crc.h": ("uint32_t fxl_crc(", "uint32_t fxl_sum("), "lib/*/*.c": ("fxl_crc(", "fxl_sum(")},
                           "fxl_crc"),
}
# A value at the end of an enumeration, one more enumeration before the others, a macro and a function.
NEW = {f"{HEADERS}/scene.h": ("enum {\n    FXL_MODEL_CONVEX = 0, /* faces drawn by number */\n    FXL_MODEL_SORTED = 1 ",
                              "enum { FXL_NEW_A, FXL_NEW_B };\nenum {\n    FXL_MODEL_CONVEX = 0,\n    FXL_MODEL_SORTED = 1, FXL_MODEL_OTHER = 2 "),
       f"{HEADERS}/crc.h": ("#define FXL_CRC_START ", "#define FXL_NEW 1\nint fxl_new(void);\n#define FXL_CRC_START "),
       "lib/scene/crc.c": ("\nuint32_t fxl_crc(", "\nint fxl_new(void) { return 1; }\nuint32_t fxl_crc(")}


def git(folder, *words):
    subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", *words], cwd=folder, check=True, capture_output=True)


@pytest.fixture(scope="module", name="origin")
def fixture_origin(tmp_path_factory):
    """A repository of what fixel one-file reads, with a tag of the version."""
    need("abidiff", "gcc", "git")
    root = tmp_path_factory.mktemp("api") / "fixel"
    for name in api_check.READ:
        shutil.copytree(CHECKOUT / name, root / name, ignore=shutil.ignore_patterns("__pycache__"))
    (root / ".venv").symlink_to(CHECKOUT / ".venv")
    git(root.parent, "init", "--quiet", "fixel")
    git(root, "add", "lib", "tools")
    git(root, "commit", "--quiet", "-m", "All")
    git(root, "tag", "v0.9.0")
    return root


@pytest.fixture(name="clone")
def fixture_clone(origin, tmp_path):
    """Changes the library of a clone; its folder."""
    root = tmp_path / "clone"
    git(origin.parent, "clone", "--quiet", str(origin), str(root))
    (root / ".venv").symlink_to(CHECKOUT / ".venv")

    def change(edits):
        for pattern, (before, after) in edits.items():
            found = [file for file in root.glob(pattern) if before in file.read_text(encoding="utf-8")]
            assert found, f"{pattern} has no {before!r}"
            for file in found:
                file.write_text(file.read_text(encoding="utf-8").replace(before, after), encoding="utf-8")
        return root
    return change


def checked(root, capsys):
    capsys.readouterr()
    return api_check.check(root), capsys.readouterr().out


def test_an_unchanged_clone_passes(clone, capsys):
    code, said = checked(clone({}), capsys)
    assert (code, said) == (0, "api: what v0.9.0 has is there, unchanged\n"), said


@pytest.mark.parametrize("what", BREAKS)
def test_what_breaks_a_program_fails(clone, capsys, what):
    edits, word = BREAKS[what]
    code, said = checked(clone(edits), capsys)
    assert code == 1 and word in said and "raise FXL_VERSION_MINOR" in said, said


def test_a_greater_version_may_break_a_program(clone, capsys):
    edits, word = BREAKS["a type changed"]
    code, said = checked(clone(edits | {f"{HEADERS}/version.h": ("VERSION_MINOR 9", "VERSION_MINOR 10")}), capsys)
    assert code == 0 and word in said and "as version 0.10.0 may be" in said


def test_what_is_new_passes(clone, capsys):
    code, said = checked(clone(NEW), capsys)
    assert (code, said) == (0, "api: what v0.9.0 has is there, unchanged\n"), said
