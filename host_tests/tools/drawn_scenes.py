# SPDX-License-Identifier: MIT
"""Scene files that tests write: their head, and scenes by chance, each with some of what a scene may ask for. test_predict.py
compares what is predicted with what those take."""

import random

COUNT = 30
# place pixel-format: scenes that are drawn at random
FEATURES = ("surfaces", "light", "depth", "rgb565", "billboards", "tree")
SOLIDS = {"box": "", "octahedron": "", "dodecahedron": "", "tetrahedron": "", "prism": "sides = {sides}\n",
          "cone": "sides = {sides}\n", "sphere": "sides = {sides}\nrings = 5\n"}
PATTERNS = ("checker", "bricks", "planks", "crate", "stones", "grille")
COLOURS = ("crimson", "gold", "teal", "olive", "slateblue", "darkorange", "seagreen", "orchid", "tan", "steelblue")


def head(width, height, view=(), textures=()):
    """[screen], [view] and [[textures]]. view: lines. textures: (name, pattern, side in texels, more lines).

    Keys of the top of the file may stand before it."""
    lines = ["[screen]", f"width = {width}", f"height = {height}"]
    if view:
        lines += ["[view]", *view]
    for name, pattern, side, *more in textures:
        lines += ["[[textures]]", f'name = "{name}"', f'pattern = "{pattern}"', f"size = [{side}, {side}]", *more]
    return "\n" + "\n".join(lines) + "\n"


def features_of(number, chance):
    """What scene `number` has: each feature is that of every sixth scene, and of others by chance. A tree goes without a
    depth buffer."""
    own = FEATURES[number % len(FEATURES)]
    found = {own, *(feature for feature in FEATURES if chance.random() < 0.3)}
    if {"tree", "depth"} <= found:
        found -= {"depth"} if own != "depth" else {"tree"}
    return found


def _head(features, chance):
    """All but the objects."""
    width, height = chance.choice([(96, 64), (128, 96), (160, 120), (200, 140), (240, 160)])
    view = [f"fov = {chance.randint(55, 85)}", "near = 0.25", "far = 48", 'inset = "4/65536"']
    view += ['pixels = "rgb565"'] * ("rgb565" in features) + ["depth = 16"] * ("depth" in features)
    text = 'background = "#1c2834"\n' + 'tree = "all"\n' * ("tree" in features)
    textures = [(pattern, pattern, 32) for pattern in PATTERNS] if "surfaces" in features else ()
    text += head(width, height, view, textures)
    text += "\n[light]\ndirection = [0.5, -0.8, 0.6]\nambient = 0.3\n"
    if "light" in features:
        text += f'levels = {chance.choice([8, 16])}\nstrength = 0.6\ndark = "#141828"\n'
        if chance.random() < 0.5:
            text += f"points = [{{ position = [{chance.randint(-4, 4)}, 3, {chance.randint(-4, 4)}], range = 10, strength = 1 }}]\n"
        if chance.random() < 0.4:
            text += "fog = { near = 4, far = 30 }\n"
    if "billboards" in features:
        text += ('\n[[billboards]]\nname = "fern"\npattern = "tree"\n'
                 f"pixels = [{chance.randint(20, 48)}, {chance.randint(24, 48)}]\nsize = [1.4, 1.8]\nbits = {chance.choice([4, 8])}\n")
    return text


def thing(features, chance, number, place):
    """An object: its table's text."""
    solid = chance.choice(list(SOLIDS))
    text = f'\n[[objects]]\nsolid = "{solid}"\n' + SOLIDS[solid].format(sides=chance.randint(5, 14))
    text += f"scale = {chance.uniform(0.8, 2.4):.2f}\nposition = [{place[0]:.2f}, {chance.uniform(0.4, 2.5):.2f}, {place[1]:.2f}]\n"
    if chance.random() < 0.3:
        text += f"spin = {{ axis = [1, 2, 0], degrees = {chance.randint(2, 9)} }}\n"
    else:
        text += f"rotation = [{chance.randint(0, 80)}, {chance.randint(0, 80)}, 0]\n"
    if "surfaces" in features and chance.random() < 0.6:
        text += f'texture = "{chance.choice(PATTERNS)}"\ntexels_per_unit = {chance.choice([8, 16, 24])}\n'
    else:
        text += f'colour = "{chance.choice(COLOURS)}"\n'
        if "light" in features and "tree" not in features and solid == "sphere":
            text += "smooth = true\n"
    return text + f"layer = {1 + number % 2 if 'tree' not in features else 1}\n"


def scene(number, seed):
    """(features, text) of a scene file."""
    chance = random.Random(f"{seed} {number}")
    features = features_of(number, chance)
    text = _head(features, chance)
    if chance.random() < 0.7:
        text += ('\n[[objects]]\nsolid = "tile"\nscale = [18, 1, 18]\nlayer = 0\n' if "tree" not in features else
                 '\n[[objects]]\nsolid = "tile"\nscale = [18, 1, 18]\nlayer = 1\n')
        text += 'texture = "stones"\ntexels_per_unit = 8\n' if "surfaces" in features else 'colour = "#587050"\n'
    places = [(x, z) for x in (-5, -2.5, 0, 2.5, 5) for z in (-5, -2.5, 0, 2.5, 5)]
    for index, place in enumerate(chance.sample(places, chance.randint(4, 18))):
        text += thing(features, chance, index, place)
    if "billboards" in features:
        text += (f'\n[[objects]]\nbillboard = "fern"\nring = {{ count = {chance.randint(4, 12)}, radius = {chance.randint(3, 6)} }}\n'
                 "position = [0, 0.9, 0]\nlayer = 1\n")
    return features, text + (f"\n[path]\norbit = {{ centre = [0, 1, 0], radius = {chance.uniform(5, 9):.1f}, "
                             f"height = {chance.uniform(1, 4):.1f}, frames = 4 }}\n")


def scenes(seed):
    """[(features, text)] of a seed."""
    return [scene(number, seed) for number in range(COUNT)]
