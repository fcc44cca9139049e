# SPDX-License-Identifier: MIT
"""Names of a scene's instances and models for a C program: enumerations."""

import re

from fixel.c_text import comment

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


def text(scene, name):
    """The enumerations of a scene, [] if none of its objects has a name."""
    places = {}
    for number, own in enumerate(scene.names):
        if own:
            places.setdefault(own, []).append(number)
    words, prefix = _distinct(places), name.upper()
    instances, models = [], []
    for own, word in words.items():
        numbers = places[own]
        instances.append((f"{prefix}_INSTANCE_{word}", numbers[0]))
        if len(numbers) > 1 and numbers == list(range(numbers[0], numbers[0] + len(numbers))):
            instances.append((f"{prefix}_INSTANCES_OF_{word}", len(numbers)))
        models.append((f"{prefix}_MODEL_{word}", scene.objects[numbers[0]].model))
    if not instances:
        return []
    return ["\n".join(comment("Numbers of the instances whose objects have names. Of several copies, the first, and how many "
                              "there are.")), _enumeration(instances),
            "\n".join(comment("Their models; of copies with several models, the first one's.")), _enumeration(models)]
