# SPDX-License-Identifier: MIT
"""Prints the places of a recipe of CONTRIBUTING.md, and what changes at each.

    fixel places [WORD] [--json FILE]

WORD is the recipe's: light, driver, pixel-format. Without it the recipes are listed, each with its number of places. The places are
the tags of the recipe in the text of the files, and what stands below "beside" in host_tests/build/recipes.toml. Exit: 0.
"""

import argparse

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.base.nearest import question
from fixel.base.table import table
from fixel.check import recipes
from fixel.package import repository

KINDS = ("code", "tests", "documents")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("word", nargs="?", default="", metavar="WORD", help="the recipe's word; without it all recipes are listed")
    made.add_argument("--json", help="write the places as JSON")
    return made


def main(argv):
    """The command."""
    options = parser().parse_args(argv)
    repository.require(recipes.ROOT)
    known, _ = recipes.load()
    if options.word and options.word not in known:
        raise ToolError(f"there is no recipe '{options.word}'{question(options.word, list(known))}; there are: {', '.join(known)}")
    words = [options.word] if options.word else list(known)
    places = [tag for tag in recipes.tags(known) if tag.word in words] + \
        [recipes.Tag(word, file, 0, what) for word in words for file, what in known[word].beside.items()]
    if options.json:
        output.write_json(options.json, [{"recipe": tag.word, "file": tag.file, "line": tag.line, "what": tag.what} for tag in places])
    if not options.word:
        print(table([[word, len({tag.file for tag in places if tag.word == word}), recipe.title] for word, recipe in known.items()],
                    ["recipe", "places", "change"]))
        return 0
    for name in KINDS:
        for tag in places:
            if recipes.kind(tag.file) == name:
                print(f"{name}: {tag.file}{f':{tag.line}' if tag.line else ''}: {tag.what}")
    return 0
