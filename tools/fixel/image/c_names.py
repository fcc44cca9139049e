# SPDX-License-Identifier: MIT
"""Names of a scene's instances, models, surfaces and textures for a C program: enumerations."""

import re

from fixel.image.c_text import comment

NAME_MAX = 40       # letters of an object's name that are taken


def _word(name):
    """A name as a part of a C name; empty if nothing is left."""
    return re.sub("[^A-Z0-9]+", "_", name.upper()).strip("_")[:NAME_MAX].rstrip("_")


def _distinct(names):
    """Words of names, each once: a second one of the same word gets a number."""
    taken, result = set(), {}
    for name in names:
        word, number = _word(name), 2
        tried = word
        while tried in taken:
            tried, number = f"{word}_{number}", number + 1
        if word:
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
    for own, word in _distinct(places).items():
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
    models = [(f"{prefix}_MODEL_{word}", scene.objects[places[own][0]].model) for own, word in _distinct(places).items()]
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
