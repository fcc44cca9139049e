# SPDX-License-Identifier: MIT
"""Three recipes, followed to the letter in a copy of the checkout: a converter RGB444, a driver ILI9342, a stipple of lines.

The files of a change are the places of its recipe. The tests that the recipe names pass, and so do those of all recipes and of the table of proofs."""

import re
import shutil
import subprocess

import pytest

from conftest import CHECKOUT, environment
from fixel.check import places as recipes
from example_changes import CHANGES


class Copy:
    """A checkout of its own, without what make has built."""

    def __init__(self, root):
        self.root = root
        for name in recipes.listed("ls-files", "--cached", "--others", "--exclude-standard", folder=CHECKOUT):
            if (CHECKOUT / name).exists():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(CHECKOUT / name, root / name)
        recipes.listed("init", "--quiet", folder=root)
        for folder in (".venv", ".node"):
            if (CHECKOUT / folder).exists():
                (root / folder).symlink_to(CHECKOUT / folder)
        # Set-up would make .venv anew, which is a link, because its path is another.
        (root / "tools/setup.sh").write_text("#!/bin/sh\n", encoding="utf-8")

    def change(self, file, edits):
        """A text for a new file, or [(old, new)] of one that is there; (name, a number): what `name = ` says is so much more."""
        path = self.root / file
        text = edits
        if not isinstance(edits, str):
            text = path.read_text(encoding="utf-8")
            for old, new in edits:
                if isinstance(new, int):
                    number, = re.findall(rf"^{old} = (\d+)$", text, re.MULTILINE)
                    old, new = f"\n{old} = {number}\n", f"\n{old} = {int(number) + new}\n"
                assert text.count(old) == 1, f"{file}: not once: {old}"
                text = text.replace(old, new)
        path.write_text(text, encoding="utf-8")

    def run(self, *command):
        """What a command in the copy printed, and whether it ended with 0."""
        done = subprocess.run(list(command), cwd=self.root, env=environment(CI="true"), stdin=subprocess.DEVNULL, text=True,
                              capture_output=True, check=False)
        return done.stdout + done.stderr, done.returncode == 0


@pytest.fixture(scope="module", params=CHANGES, ids=lambda change: change.word)
def changed(request, tmp_path_factory):
    """(a copy in which the example is made, the example)."""
    copy = Copy(tmp_path_factory.mktemp(request.param.word) / "fixel")
    for file, edits in request.param.edits.items():
        copy.change(file, edits)
    if request.param.renewed:
        said, passed = copy.run(str(CHECKOUT / ".venv/bin/fixel"), "prove", "--numbers", "--root", str(copy.root))
        assert passed, said
    return copy, request.param


def test_the_change_is_made_at_the_places_of_its_recipe(changed):
    _, change = changed
    known, _ = recipes.load()
    places = {tag.file for tag in recipes.tags(known) if tag.word == change.word and re.search(change.places, tag.what)}
    assert set(change.edits) - change.new - set(known[change.word].beside) == places


def test_the_tests_that_the_recipe_names_pass(changed):
    copy, change = changed
    said, passed = copy.run("make", "test", f"ONLY={' '.join(['build/test_recipes', 'build/test_proofs', *change.only])}")
    assert passed and re.search(r"\b0 failed", said), said
    for command in change.commands:
        said, passed = copy.run("make", *command.split())
        assert passed, said
