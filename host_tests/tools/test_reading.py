# SPDX-License-Identifier: MIT
"""What messages quote of an input: short, on one line, and escaped."""

import pytest
from hypothesis import given, settings, strategies as st

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.scene import compiler

MOST = 80
TEXTS = st.one_of(st.text(max_size=200), st.text(alphabet="\x1b\n\"\\\u202ea", max_size=200),
                  st.integers(0, 10 ** 6).map(lambda count: "x" * count))
VALUES = st.recursive(st.one_of(TEXTS, st.integers(), st.floats(), st.booleans(), st.integers(1, 40000).map(lambda bits: 1 << bits)),
                      lambda inner: st.one_of(st.lists(inner, max_size=9), st.dictionaries(TEXTS, inner, max_size=9)),
                      max_leaves=20)
fixed = settings(max_examples=300, deadline=None, database=None, derandomize=True)


@fixed
@given(VALUES)
def test_a_value_is_quoted_short(value):
    text = reading.quoted(value)
    assert text.isprintable() and 0 < len(text) <= MOST + 2 * isinstance(value, str), text   # and two quotes


@fixed
@given(TEXTS)
def test_words_of_others_are_shortened(words):
    text = reading.shortened(words)
    assert text.isprintable() and len(text) <= MOST, text


def test_what_is_short_is_told_whole():
    assert reading.quoted("x" * MOST) == '"' + "x" * MOST + '"'
    assert reading.quoted("x" * (MOST + 1)) == '"' + "x" * (MOST - 3) + '..."'
    assert reading.shortened("y" * MOST) == "y" * MOST
    assert reading.shortened("y" * MOST + "z") == "y" * 40 + "..." + "y" * 36 + "z"
    assert (reading.quoted('a"\\\n\x1b'), reading.quoted(5), reading.quoted([1, "b"])) == (
        '"a\\"\\\\\\n\\x1b"', "5", "[1, 'b']")


@pytest.mark.parametrize("table, row, use", [
    ("textures", 'pattern = "crate"\nsize = [4, 4]\n', 'solid = "box"\ntexture = "none"'),
    ("billboards", 'pattern = "tree"\npixels = [8, 8]\nsize = [1, 1]\n', 'billboard = "none"')])
def test_the_names_that_there_are(tmp_path, table, row, use):
    """A list of all of them would be as long as the file, and could hold what a terminal obeys."""
    file, name = tmp_path / "scene.toml", "\\u001b[31m" + "x" * 500
    file.write_text(f'[[{table}]]\nname = "{name}"\n{row}[[objects]]\n{use}\n')
    with pytest.raises(ToolError, match='there is no .* "none"') as refused:
        compiler.compile_scene(str(file))
    there = str(refused.value).split(f"the scene's {table}: ")[1]
    assert there.isprintable() and len(there) <= MOST, there


def test_files_outside_the_folder_of_a_name_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(reading, "_confined", None)
    for name in ("here/x.toml", "here/below/y", "z"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    (tmp_path / "here/in").symlink_to("below/y")
    (tmp_path / "here/out").symlink_to("../z")
    for folder, named, before in ((tmp_path / "here", "x.toml", ""), (tmp_path, "here/x.toml", "here/")):
        monkeypatch.chdir(folder)
        reading.confine(named)
        for name in ("x.toml", "below/y", "in", "below/../x.toml"):
            with reading.open_file(before + name) as file:
                assert file.read()
        for name in ("../z", "out"):
            with pytest.raises(ToolError, match=f"is outside {'here' if before else '.'}, the folder of {named}"):
                reading.open_file(before + name)
    # What the user named may itself be a link.
    reading.confine("here/out")
    with reading.open_file("here/out") as file:
        assert file.read() == b"z"
