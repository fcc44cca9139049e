# SPDX-License-Identifier: MIT
"""The recipes: each place of a change has its tag (fixel.check.places), and CONTRIBUTING.md tells each change."""

import json
import re

import pytest

from conftest import CHECKOUT, run_cli, write_files
from fixel.base.errors import ToolError
from fixel.check import places as recipes

CONTRIBUTING = (CHECKOUT / "CONTRIBUTING.md").read_text(encoding="utf-8")
BUILT_PROGRAMS = ()
KNOWN, NEVER = recipes.load()
LIGHT = '[light]\ntitle = "Light"\nfinds = [{ pattern = "tint_of" }, { pattern = "[0-9] lamps", paths = ["*.md"] }]\n'
HEAD = '[never]\n"the recipes" = ["host_tests/build/*"]\n' + LIGHT


def tag(word, what, comment="/* {} */"):
    return comment.format(f"place {word}: {what}") + "\n"


def checkout(folder, record, texts):
    """A checkout with these recipes and files."""
    write_files(folder, {recipes.RECORD: record, **texts})
    recipes.listed("init", "--quiet", folder=folder)
    known, never = recipes.load(folder)
    return known, never, lambda: recipes.wrong(known["light"], recipes.tags(known, folder), never, folder)


@pytest.fixture(scope="module")
def tags():
    return recipes.tags(KNOWN)


@pytest.mark.parametrize("word", KNOWN)
def test_each_place_has_its_tag_and_each_tag_a_place(word, tags):
    assert "\n".join(recipes.wrong(KNOWN[word], tags, NEVER)) == ""


@pytest.mark.parametrize("word", KNOWN)
def test_a_recipe_without_its_tags_fails_for_each_place(word, tags):
    """The control: without tags each file that is a place is named, with the tag that it needs; but for those that no recipe must tag."""
    places = {each.file for each in tags if each.word == word and not recipes.is_one_of(each.file, NEVER)}
    said = recipes.wrong(KNOWN[word], [], NEVER)
    assert len(places) > 3 and len([words for words in said if f"the recipe '{word}'" in words]) == len(places)


@pytest.mark.parametrize("word", KNOWN)
def test_each_pattern_finds_files(word):
    for pattern in KNOWN[word].finds:
        assert len(recipes.found_by(recipes.dataclasses.replace(KNOWN[word], finds=(pattern,)))) > 1, pattern


def test_a_new_file_that_a_pattern_finds_is_told_which_tag_to_write_and_where(tmp_path):
    texts = {"lib/a.c": "int a;\nint tint_of(int a);\n", "tools/b.py": "tint_of = 1\n", "docs/c.md": "Text.\n\nIt has 2 lamps.\n", "d.json": '"tint_of"\n'}
    *_, wrong = checkout(tmp_path, HEAD, texts)
    said = wrong()
    assert [words.split(" ")[0] for words in said] == ["d.json:1", "docs/c.md:3", "lib/a.c:2", "tools/b.py:1"]
    for words, needed in zip(said, ["[light.no_comment]", "'<!-- place light: ", "'/* place light: ", "'# place light: "]):
        assert needed in words and "[light.not_places] of host_tests/build/recipes.toml" in words
    write_files(tmp_path, {"lib/a.c": tag("light", "its sign") + texts["lib/a.c"], "tools/b.py": tag("light", "the sum", "# {}") + texts["tools/b.py"],
                           "docs/c.md": tag("light", "how many", "<!-- {} -->") + texts["docs/c.md"],
                           recipes.RECORD: HEAD + '[light.no_comment]\n"the figure" = ["d.json"]\n'})
    *_, wrong = checkout(tmp_path, (tmp_path / recipes.RECORD).read_text(encoding="utf-8"), {})
    assert wrong() == []


def test_a_tag_that_no_pattern_finds_fails_also_where_only_a_tag_has_the_words(tmp_path):
    *_, wrong = checkout(tmp_path, HEAD, {"lib/a.c": "int a;\n" + tag("light", "tint_of"), "lib/b.c": "tint_of\n" + tag("light", "b")})
    assert [words.split(" ")[0] for words in wrong()] == ["lib/a.c:2:"]


def test_the_name_of_a_clause_is_no_place(tmp_path):
    texts = {"lib/a.c": "/* tint_of 3.6a, SPEC 9.6j */\nint a;\n", "lib/b.c": "/* tint_of */\n", "lib/c.c": "/* tint_of 3.6a */ tint_of();\n"}
    *_, wrong = checkout(tmp_path, HEAD, texts)
    assert [words.split(" ")[0] for words in wrong()] == ["lib/b.c:1", "lib/c.c:1"]


def test_a_file_is_either_a_place_or_none(tmp_path):
    none = '[light.not_places]\n"only use it" = ["lib/*.c", "tools/gone.py"]\n'
    *_, wrong = checkout(tmp_path, HEAD + none, {"lib/a.c": "tint_of\n", "lib/b.c": tag("light", "b") + "tint_of\n"})
    said = wrong()
    assert [words.split(" ")[0] for words in said] == ["lib/b.c:1:", f"{recipes.RECORD}:"] and "tools/gone.py" in said[1]


def test_what_no_pattern_finds_is_there_and_is_found_by_none(tmp_path):
    beside = '[light.beside]\n"the sum" = ["lib/a.c", "lib/b.c", "lib/gone.c"]\n'
    *_, wrong = checkout(tmp_path, HEAD + beside, {"lib/a.c": "tint_of\n" + tag("light", "a"), "lib/b.c": "int b;\n"})
    assert [re.search(r"lib/\w+\.c", words)[0] for words in wrong()] == ["lib/gone.c", "lib/a.c"]
    *_, wrong = checkout(tmp_path, HEAD.replace("host_tests/build", "lib") + beside, {"lib/gone.c": "int c;\n"})
    assert [words for words in wrong() if "beside" in words] == [], "a file that no recipe must tag may stand beside"


@pytest.mark.parametrize("text", [tag("lihgt", "the sum"), "/* place light: open\n"])
def test_a_tag_of_no_recipe_or_of_another_form_is_refused(tmp_path, text):
    known, *_ = checkout(tmp_path, HEAD, {"lib/a.c": "tint_of\n" + text})
    with pytest.raises(ToolError, match=r"lib/a\.c:2: .*WORD"):
        recipes.tags(known, tmp_path)


def test_the_command_prints_each_place_and_what_changes_there(tags, tmp_path):
    done = run_cli("places", "driver", "--json", tmp_path / "places.json")
    assert done.returncode == 0, done.stderr
    places = [each for each in tags if each.word == "driver"]
    for each in places:
        assert f": {each.file}{f':{each.line}' if each.line else ''}: {each.what}\n" in done.stdout
    assert len(done.stdout.splitlines()) == len(places) + len(KNOWN["driver"].beside)
    assert len(json.loads((tmp_path / "places.json").read_text(encoding="utf-8"))) == len(places) + len(KNOWN["driver"].beside)
    every = run_cli("places")
    assert every.returncode == 0 and [line.split()[0] for line in every.stdout.splitlines()[2:]] == list(KNOWN)


def test_the_command_refuses_a_word_that_is_no_recipe():
    done = run_cli("places", "dirver")
    assert done.returncode == 2 and "driver" in done.stderr and "dirver" in done.stderr


@pytest.mark.parametrize("word, header, kind, apart", [
    ("converter", "pixels.h", r"fxl_pixel_format fxl_pixels_(\w+);", set()),
    ("driver", "display.h", r"fxl_display_driver fxl_(\w+);", {"host_tests/unit/controller.c"})])
def test_what_is_declared_stands_at_each_place_of_its_recipe(word, header, kind, apart, tags):
    """A place that a change leaves out: the name of the new record does not stand there. apart: where not all records stand."""
    declared = re.findall(f"extern const {kind}", (CHECKOUT / "lib/include/fixel" / header).read_text(encoding="utf-8"))
    places = {tag.file for tag in tags if tag.word == word and not tag.file.startswith("lib/screen/")}
    assert len(declared) > 5 and len(places) > 3
    for file in places - apart:
        text = (CHECKOUT / file).read_text(encoding="utf-8").lower()
        missing = [name for name in declared if name not in text and not (word == "driver" and name.split("_")[0] in text)]
        assert missing == [], f"{file}: the recipe '{word}' has a place here, and this is not in it: {missing}"


@pytest.mark.parametrize("word", KNOWN)
def test_the_story_of_a_recipe_is_short_and_names_its_commands(word):
    story = re.search(rf"^####? {re.escape(KNOWN[word].title.split(': ')[-1])}\n(.*?)(?=^#|\Z)", CONTRIBUTING, re.MULTILINE | re.DOTALL)[1]
    assert f"`.venv/bin/fixel places {word}`" in story and re.search(r"`make \w+( [A-Z]+=|`)", story)
    assert len([line for line in story.splitlines() if line.strip()]) <= 10
    assert all((CHECKOUT / name).exists() for name in re.findall(r"`((?:[\w-]+/)+[\w.-]+\.\w+)`", story))


def test_contributing_can_be_read_whole():
    assert CONTRIBUTING.count("\n") <= 300
    assert len(re.findall(r"^### ", CONTRIBUTING.split("\n## Recipes\n")[1].split("\n## ")[0], re.MULTILINE)) == 11
