# SPDX-License-Identifier: MIT
"""Names for a C program: of a header by its file, and of a scene's instances, models, surfaces and textures as
enumerations."""

import os
import re
import unicodedata

from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.image.c_text import comment

FILE_NAME_MAX = 40       # a C compiler need not read more than 63 letters of a name
NAME_MAX = 40       # letters of an object's name that are taken


def name_of_file(path, before="scene"):
    """The name that a header's names begin with where none is given: the file's, or one like it that may be used. before:
    stands before one that may not begin a name."""
    stem = os.path.splitext(os.path.basename(path))[0]
    return stem if not _what_is_wrong(stem) else suggestion(stem, before)


def check_name(name):
    """Refuses a name that no C identifier may begin with."""
    wrong = _what_is_wrong(name)
    if wrong:
        raise ToolError(f"the name {quoted(name)} {wrong}: give another with --name, like --name "
                        f"{suggestion(name)}")


def _what_is_wrong(name):
    """Why a name cannot begin those of a header, or ""."""
    return ("must begin with a letter, and have only letters of English, digits and _"
             if not re.fullmatch("[A-Za-z][A-Za-z0-9_]*", name) else
             f"is longer than {FILE_NAME_MAX} letters" if len(name) > FILE_NAME_MAX else
             "has __, which C++ keeps for itself" if "__" in name else
             "begins with fxl, which the library keeps for itself" if name.lower().startswith("fxl") else "")


def suggestion(name, before="scene"):
    """A name that is like this one and may be used."""
    plain = re.sub("[^A-Za-z0-9]+", "_", name).strip("_")
    if not plain[:1].isalpha() or plain.lower().startswith("fxl"):
        plain = f"{before}_{plain}"
    return plain[:FILE_NAME_MAX].rstrip("_")


def _word(name):
    """A name as a part of a C name: letters without their accents, in capitals, and _ for what is neither a letter of English nor a digit.
    Where nothing is left, the numbers of its characters, as U8F6E."""
    plain = "".join(each for each in unicodedata.normalize("NFKD", name) if not unicodedata.combining(each))
    word = re.sub("[^A-Z0-9]+", "_", plain.upper()).strip("_")
    return (word or "_".join(f"U{ord(each):04X}" for each in name))[:NAME_MAX].rstrip("_")


def distinct(names):
    """Words of names, each once: a second one of the same word gets a number."""
    taken, result, numbers = set(), {}, {}
    for name in names:
        word = tried = _word(name)
        while tried in taken:
            numbers[word] = numbers.get(word, 1) + 1
            tried = f"{word}_{numbers[word]}"
        taken.add(tried)
        result[name] = tried
    return result


def _enumeration(entries):
    return "\n".join(["enum {", ",\n".join(f"    {name} = {value}" for name, value in entries), "};", ""])


def _places(names):
    """{name: its places in a list of names, None being no name}."""
    places = {}
    for number, own in enumerate(names):
        if own:
            places.setdefault(own, []).append(number)
    return places


def _numbered(places, one, several):
    """Entries of an enumeration: of each name the first place, and how many there are if they follow each other."""
    entries = []
    for own, word in distinct(places).items():
        numbers = places[own]
        entries.append((f"{one}_{word}", numbers[0]))
        if len(numbers) > 1 and numbers == list(range(numbers[0], numbers[0] + len(numbers))):
            entries.append((f"{several}_OF_{word}", len(numbers)))
    return entries


def _surfaces_of(scene, places):
    """{name of an object: the numbers of its faces' surfaces}."""
    found = {}
    for own, numbers in places.items():
        faces = (face for number in numbers for face in scene.models[scene.objects[number].model].faces)
        found[own] = sorted({face.mapped.surface for face in faces if face.mapped})
    return {own: numbers for own, numbers in found.items() if numbers}


def text(scene, name):
    """The enumerations of a scene, [] if nothing of it has a name."""
    places, prefix, made = _places(scene.names), name.upper(), []
    models = [(f"{prefix}_MODEL_{word}", scene.objects[places[own][0]].model) for own, word in distinct(places).items()]
    surfaces = _surfaces_of(scene, places) if scene.surfaces else {}
    textures = _places(scene.surfaces.texture_names) if scene.surfaces else {}
    for about, entries in (
            ("Numbers of the instances whose objects have names. Of several copies, the first, and how many there are.",
             _numbered(places, f"{prefix}_INSTANCE", f"{prefix}_INSTANCES")),
            ("Their models; of copies with several models, the first one's.", models),
            ("Their surfaces, in the set's table. Of several, the first, and how many if they follow each other.",
             _numbered(surfaces, f"{prefix}_SURFACE", f"{prefix}_SURFACES")),
            ("Numbers of the textures in the set's table, from 0. Of one with several sets of colours, the first, and how "
             "many if they follow each other.", _numbered(textures, f"{prefix}_TEXTURE", f"{prefix}_TEXTURES"))):
        if entries:
            made += ["\n".join(comment(about)), _enumeration(entries)]
    return made
