# SPDX-License-Identifier: MIT
"""Prints the places of a recipe of CONTRIBUTING.md, and what changes at each.

    fixel places [WORD] [--json FILE]

WORD is the recipe's: light, driver, pixel-format. Without it the recipes are listed, each with its number of places. The places are
the tags of the recipe in the text of the files, and what stands below "beside" in host_tests/build/recipes.toml. Exit: 0.

A recipe is an entry of host_tests/build/recipes.toml, by its word, and a section of CONTRIBUTING.md, which tells how the change
goes. A place has a tag, a comment alone on a line above what changes, in the form of its language:

    in C: /* place light: the brightness of a place */
    in Python and TOML: # place ...
    in pages: <!-- place ... -->

Each file that a recipe's patterns find has a tag of its word, or a line below "no_comment" where it cannot have one, or stands
among its "not places" with a reason. The patterns do not look at tags. "beside" has places that no pattern finds, or in files of "never".
"""

import argparse
import dataclasses
import fnmatch
import os
import pathlib
import re
import tomllib

from fixel.base import children, output
from fixel.base.errors import ToolError
from fixel.base.nearest import question
from fixel.base.table import table
from fixel.package import repository

KINDS = ("code", "tests", "documents")
ROOT = pathlib.Path(__file__).resolve().parents[3]
RECORD = "host_tests/build/recipes.toml"
OPENS = r"^[[:space:]]*(/\*|//|#|<!--) place [a-z-]+: "      # for git grep: a line that is a tag
CLAUSE = r"^[[:space:]]*(/\*|#) [A-Za-z0-9_]+ [0-9]+\.[-0-9a-zA-Z_., ]*(\*/)?[[:space:]]*$"     # and one that names clauses: their page's name is no place
TAG = re.compile(r"^\s*(?:/\* place ([a-z-]+): (.+) \*/|(?://|#) place ([a-z-]+): (.+)|<!-- place ([a-z-]+): (.+) -->)\s*$")
COMMENTS = {"/* {} */": (".c", ".h", ".S", ".ld"), "// {}": (".rs", ".mjs"), "<!-- {} -->": (".md",), "# {}": (".py", ".toml", ".mk", ".txt", "Makefile")}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("word", nargs="?", default="", metavar="WORD", help="the recipe's word; without it all recipes are listed")
    made.add_argument("--json", help="write the places as JSON")
    return made


def main(argv):
    """The command."""
    options = parser().parse_args(argv)
    repository.require(ROOT)
    known, _ = load()
    if options.word and options.word not in known:
        raise ToolError(f"there is no recipe '{options.word}'{question(options.word, list(known))}; there are: {', '.join(known)}")
    words = [options.word] if options.word else list(known)
    places = [tag for tag in tags(known) if tag.word in words] + \
        [Tag(word, file, 0, what) for word in words for file, what in known[word].beside.items()]
    if options.json:
        output.write_json(options.json, [{"recipe": tag.word, "file": tag.file, "line": tag.line, "what": tag.what} for tag in places])
    if not options.word:
        print(table([[word, len({tag.file for tag in places if tag.word == word}), recipe.title] for word, recipe in known.items()],
                    ["recipe", "places", "change"]))
        return 0
    for name in KINDS:
        for tag in places:
            if kind(tag.file) == name:
                print(f"{name}: {tag.file}{f':{tag.line}' if tag.line else ''}: {tag.what}")
    return 0


@dataclasses.dataclass(frozen=True)
class Tag:
    """A place of a recipe: the line of its tag, 0 where the file has none, and what changes there."""
    word: str
    file: str
    line: int
    what: str


@dataclasses.dataclass(frozen=True)
class Recipe:
    """finds: [(pattern, paths)]; no_comment, beside: {file: what changes there}; not_places: {pattern of files: reason}."""
    word: str
    title: str
    finds: tuple
    no_comment: dict
    beside: dict
    not_places: dict


def listed(*arguments, folder=ROOT):
    """The lines that a git command prints. Exit code 1 of git grep means that it found none."""
    done = children.run(["git", *arguments], cwd=folder, text=True)
    if done.returncode not in (0, 1) or done.stderr:
        raise ToolError(f"git {arguments[0]}: {done.stderr.strip()}")
    return done.stdout.splitlines()


def _grep(recipe, how, folder, files=()):
    return [line for pattern, paths in recipe.finds
            for line in listed("grep", "--untracked", how, "-e", pattern, "--and", "--not", "(", "-e", OPENS, "--or", "-e", CLAUSE, ")", "--", *(files or paths), folder=folder)]


def load(folder=ROOT):
    """{word: recipe}, and {pattern of files that are a place of no recipe: reason}."""
    table = tomllib.loads((folder / RECORD).read_text(encoding="utf-8"))
    never = _files(table.pop("never", {}))
    return {word: Recipe(word, entry["title"], tuple((each["pattern"], each.get("paths", ())) for each in entry["finds"]),
                         _files(entry.get("no_comment", {})), _files(entry.get("beside", {})), _files(entry.get("not_places", {})))
            for word, entry in table.items()}, never


def _files(rows):
    """{file: words} of {words: files}."""
    return {file: words for words, files in rows.items() for file in files}


def is_one_of(file, patterns):
    """Whether one of the patterns is the file's."""
    return any(fnmatch.fnmatchcase(file, pattern) for pattern in patterns)


def tags(recipes, folder=ROOT):
    """All tags, sorted by file and line, and what stands for them where a file has no comments."""
    found = [Tag(recipe.word, file, 0, what) for recipe in recipes.values() for file, what in recipe.no_comment.items()]
    for line in listed("grep", "--untracked", "-nE", OPENS, folder=folder):
        file, number, text = line.split(":", 2)
        parts = TAG.match(text)
        word, what = [part for part in parts.groups() if part] if parts else ("", "")
        if word not in recipes:
            raise ToolError(f"{file}:{number}: this is a tag of no recipe: {text.strip()}; the words of recipes are {', '.join(recipes)}, "
                            f"and a tag is '{form(file, 'WORD')}'")
        found.append(Tag(word, file, int(number), what))
    return sorted(found, key=lambda tag: (tag.file, tag.line, tag.word))


def form(file, word, what="WHAT CHANGES HERE"):
    """A tag as it is written in a file; "" where it has no comments."""
    words = f"place {word}: {what}"
    return next((comment.format(words) for comment, suffixes in COMMENTS.items() if file.endswith(suffixes)), "")


def found_by(recipe, folder=ROOT):
    """The files in which a recipe's patterns find something, also among new ones."""
    return sorted(set(_grep(recipe, "-lE", folder)))


def wrong(recipe, places, never, folder=ROOT):
    """Sentences on files without a tag, on tags that have no reason, and on names that are no file's. places: all tags."""
    found = found_by(recipe, folder)
    tagged = {tag.file: tag for tag in places if tag.word == recipe.word}
    said = [_untagged(recipe, file, folder) for file in found if file not in tagged and not is_one_of(file, (*recipe.not_places, *never))]
    return said + _needless(recipe, tagged, found) + _missing(recipe, [file for file in found if not is_one_of(file, never)], found, folder)


def _untagged(recipe, file, folder):
    line = next(iter(_grep(recipe, "-nIE", folder, [file])), f"{file}:1:").split(":")[1]
    tag = form(file, recipe.word)
    way = f"write the line '{tag}' above it" if tag else f'write \'"WHAT CHANGES HERE" = ["{file}"]\' below [{recipe.word}.no_comment] of {RECORD}'
    return (f"{file}:{line} is found by the recipe '{recipe.word}' and has no tag of it. If the change has a place here, {way}; "
            f"if it has none, name the file with its reason below [{recipe.word}.not_places] of {RECORD}")


def _needless(recipe, tagged, found):
    said = []
    for file, tag in tagged.items():
        if file not in found:
            said.append(f"{file}:{tag.line}: the tag 'place {recipe.word}' stands in a file that the patterns of [{recipe.word}] in {RECORD} do not "
                        "find: take the tag out, or move it to the file where the place is now")
        elif is_one_of(file, recipe.not_places):
            said.append(f"{file}:{tag.line}: has the tag 'place {recipe.word}', and {RECORD} names it among the not places: take out one of the two")
    return said


def _missing(recipe, taggable, found, folder):
    """taggable: those that are found and are not named below [never]: the others may stand beside."""
    files = listed("ls-files", "--cached", "--others", "--exclude-standard", folder=folder)
    said = [f"{RECORD}: '{pattern}' of [{recipe.word}.not_places] is no file that the recipe finds: take it out"
            for pattern in recipe.not_places if not fnmatch.filter(found, pattern)]
    said += [f"{RECORD}: '{name}' of [{recipe.word}.beside] is no file: name the file that it is now, or take it out"
             for name in recipe.beside if not fnmatch.filter(files, name)]
    return said + [f"{RECORD}: '{name}' of [{recipe.word}.beside] is found by the recipe's patterns: write '{form(name, recipe.word)}' in it instead"
                   for name in recipe.beside if name in taggable]


def kind(file):
    """Whether a place is of the code, the tests or the documents."""
    if os.path.splitext(file)[1] == ".md":
        return "documents"
    return "tests" if file.startswith(("host_tests/", "bench/", "firmware/equality/")) else "code"
