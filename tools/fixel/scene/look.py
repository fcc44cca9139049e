# SPDX-License-Identifier: MIT
"""How a model without a scene file is drawn: as its author made it, or as options such as --palette, --flat and
--no-textures say. A scene file says it itself."""

import argparse
import re
import shlex
from dataclasses import dataclass, field, fields, replace

from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model.creases import LIMIT

SIDES = tuple(1 << bits for bits in range(9))   # of a texture
FACES_MAX = 1 << 20             # of a file
NO_ANIMATION = "none"       # as the name of an animation
TEXELS = (256, 128, 64, 32, 16)     # of a texture's side: the most first


@dataclass(frozen=True)
class Look:
    """pixels: "rgb565" or "palette". depth: bits of a depth buffer, 0 without one. texels: the most of a texture's side,
    0 without textures; is_fixed: they have so many even where the path shows fewer. smooth: degrees up to which an edge
    does not show, 0 for flat faces. keep: patterns of the names of nodes or groups that become objects of their own, with commas between.
    animation: a pattern of the name of the one that is played; "": the first, NO_ANIMATION: none. camera: a pattern of the name of the one that
    makes the path; "": a circle. whole: whether the model is one object, and nothing of it moves. simplify: how many faces it
    has at most, None for its own. baked: whether the tool computes the light. normals: whether those of the file and
    its smoothing groups make smooth light where it has some, and its shape where it has none. colours: whether those of its faces and vertices show."""
    pixels: str = "rgb565"
    depth: int = 16
    texels: int = TEXELS[0]
    smooth: int = LIMIT
    is_fixed: bool = False
    keep: str = ""
    animation: str = ""
    camera: str = ""
    whole: bool = False
    simplify: int = None
    baked: bool = False
    normals: bool = True
    colours: bool = True

    @property
    def bits(self):
        """Of a texel."""
        return 16 if self.pixels == "rgb565" else 8


PLAIN = Look("palette", 0, 0, 0, whole=True)


@dataclass(frozen=True)
class Asked:
    """What a command line asks for. write: a scene file to write, or None."""
    palette: bool = False
    flat: bool = False
    no_textures: bool = False
    no_colours: bool = False
    texture: int = None
    sorted: bool = False
    smooth: int = None
    keep: str = ""
    animation: str = ""
    camera: str = ""
    simplify: int = None
    bake_light: bool = False
    write: str = None
    verbose: bool = field(default=False, compare=False)     # of a scene file too

    def __bool__(self):
        return self != Asked()

    @property
    def text(self):
        """The first option that is given."""
        name = next(each.name for each in fields(self) if each.compare and getattr(self, each.name) != each.default)
        return f"--{name.replace('_', '-')}"


def _degrees(text):
    if not re.fullmatch("[0-9]{1,3}", text) or int(text) > 180:
        raise argparse.ArgumentTypeError(f"{quoted(text)} is not a whole number of degrees from 0 to 180")
    return int(text)


def _side(text):
    if not re.fullmatch("[0-9]{1,3}", text) or int(text) not in SIDES:
        raise argparse.ArgumentTypeError(f"{quoted(text)} is not a power of two from 1 to {SIDES[-1]}")
    return int(text)


def _faces(text):
    if not re.fullmatch("[0-9]{1,7}", text) or not 4 <= int(text) <= FACES_MAX:
        raise argparse.ArgumentTypeError(f"{quoted(text)} is not a whole number of faces from 4 to {FACES_MAX:,}")
    return int(text)


def _add(group):
    group.add_argument("--palette", action="store_true", help="draw in a palette instead of RGB565")
    group.add_argument("--flat", action="store_true", help="light each face as a whole, also where normals are smooth")
    group.add_argument("--no-textures", action="store_true", help="give each face its image's mean colour")
    group.add_argument("--no-colours", action="store_true", help="leave out the colours that faces and vertices have in the file")
    group.add_argument("--texture", type=_side, metavar="TEXELS", help="the most texels of a texture's side, a power of two up to "
                       f"{SIDES[-1]} (default: what the path shows)")
    group.add_argument("--sorted", action="store_true", help="draw by distance, without a depth buffer")
    group.add_argument("--smooth", type=_degrees, metavar="DEGREES", help="edges that bend less do not show, whatever "
                       "normals and smoothing groups the file has (default: these; without them its shape decides)")
    group.add_argument("--keep", metavar="NAMES", default="", help="nodes of a glTF file, or o and g of an OBJ file, that stay objects of their own, such as "
                       "'wheel*,door'")
    group.add_argument("--animation", metavar="NAME", default="", help="the animation of a glTF file that is played (default: the first), or "
                       f"{NO_ANIMATION}: nothing moves")
    group.add_argument("--camera", metavar="NAME", default="", help="the camera of a glTF file that the path follows (default: a circle)")
    group.add_argument("--simplify", type=_faces, metavar="FACES", help="make a model of at most so many triangles of it first")
    group.add_argument("--bake-light", action="store_true", help="light faces and their textures when the scene is compiled, not at run "
                       "time")
    group.add_argument("-v", "--verbose", action="store_true", help="tell too what is the same for every file; of a scene file likewise")
    group.add_argument("--write", metavar="SCENE.toml", help="write the scene file that gives the same frames")


def add_options(parser):
    """The options of a bare model; of_options reads them."""
    group = parser.add_argument_group("a model without a scene file")
    _add(group)
    group.add_argument("--look", dest="look_words", metavar="OPTIONS", help="these options as one word, such as "
                       "\"--palette --flat\": make passes LOOK= on so")


class _Words(argparse.ArgumentParser):
    """Reads the options in one word; what is wrong is one sentence."""

    def error(self, message):
        raise ToolError(f"LOOK: {quoted(message)}; it has options such as --palette --flat")


def _spelled_out(words):
    """The options in one word, as argparse has them."""
    parser = _Words(add_help=False, allow_abbrev=False)
    _add(parser)
    try:
        return parser.parse_args(shlex.split(words))
    except ValueError:
        raise ToolError(f"LOOK is {quoted(words)}: a quote is not closed") from None


def of_options(options):
    """The Asked of a command line."""
    more = _spelled_out(options.look_words) if getattr(options, "look_words", None) else None
    asked = Asked(**{each.name: getattr(more, each.name, each.default) if getattr(more, each.name, each.default) != each.default
                     else getattr(options, each.name, each.default) for each in fields(Asked)})
    if asked.flat and asked.smooth is not None:
        raise ToolError("--flat and --smooth exclude each other: leave one out")
    if asked.bake_light and asked.smooth is not None:
        raise ToolError("--bake-light and --smooth exclude each other: baked light is that of whole faces")
    if asked.no_textures and asked.texture is not None:
        raise ToolError("--no-textures and --texture exclude each other: leave one out")
    return asked


def check(asked, scene, is_model):
    """Refuses options of a bare model for anything else."""
    if asked and not is_model:
        raise ToolError(f"{asked.text} is for a model without a scene file; {scene} says itself how it is drawn")


def targets(asked, target, has_tree):
    """[(pixels, depth)] that may be, the best first. target: a target.Target."""
    pixels = ["palette"] if asked.palette else [target.pixels] if target.pixels else ["rgb565", "palette"]
    if asked.palette and target.pixels == "rgb565":
        raise ToolError("--palette and PIXELS=rgb565 exclude each other: leave one out")
    if asked.sorted and target.depth not in (None, "0"):
        raise ToolError(f"--sorted and DEPTH={target.depth} exclude each other: leave one out")
    if asked.sorted or has_tree or target.order == "tree":
        depths = [0]
    else:
        depths = [int(target.depth)] if target.depth else [16, 0]
    found = [(each, depth) for depth in depths for each in pixels]
    # RGB565 in a wrong order is no better than a palette in it.
    return [each for each in found if each != ("rgb565", 0)] if len(pixels) > 1 and len(depths) > 1 else found


def of(asked, pixels, depth, texels=TEXELS[0], smooth=True):
    """The Look of a target, with so many texels and with smooth light or without, if nothing else is asked for."""
    crease = LIMIT if asked.smooth is None else asked.smooth
    return Look(pixels, depth, 0 if asked.no_textures else texels, crease if smooth and not asked.flat and not asked.bake_light else 0,
                asked.texture is not None and texels == asked.texture, asked.keep, asked.animation,
                asked.camera, simplify=asked.simplify, normals=asked.smooth is None, baked=asked.bake_light,
                colours=not asked.no_colours)


def best(asked, target, has_tree):
    """The Look where there is room for all."""
    return smaller(asked, *targets(asked, target, has_tree)[0])[0]


def smaller(asked, pixels, depth):
    """The Looks of a target, each with a smaller image than the one before."""
    sides = TEXELS if asked.texture is None else (asked.texture, *(side for side in TEXELS if side < asked.texture))
    found = [of(asked, pixels, depth, texels) for texels in (*sides, 0)] + [of(asked, pixels, depth, 0, False)]
    found += [] if asked.animation else [replace(found[-1], animation=NO_ANIMATION)]
    return list(dict.fromkeys(found))


def after(wanted, compiled):
    """The Looks behind the first one that make a smaller image. compiled: the SceneImage of the first one."""
    has_textures = compiled.surfaces is not None and bool(compiled.surfaces.textures)
    return [each for each in wanted[1:] if (compiled.motions if each.animation == NO_ANIMATION != wanted[0].animation else
                                            has_textures or (each.texels == 0 and each.smooth != wanted[0].smooth))]


def smaller_text(name, chosen):
    """What there is to say of a Look that was not the first of those."""
    what = f"textures of at most {chosen.texels} texels a side" if chosen.texels else \
        "no textures" if chosen.smooth else "no textures, no smooth light and no animation" if chosen.animation == NO_ANIMATION else \
        "no textures and no smooth light"
    return f"{name}: a scene image holds no more than {what} of this model; give it fewer faces (--simplify) to have all"
