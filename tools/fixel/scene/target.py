# SPDX-License-Identifier: MIT
"""What a command asks a scene to be drawn as, in the place of what its [view] says: PIXELS=, ORDER=, DEPTH=."""

from dataclasses import dataclass

from fixel.base.errors import ToolError
from fixel.base.reading import quoted

# place pixel-format: the values of PIXELS= and of pixels
VALUES = {"pixels": ("palette", "rgb565"), "order": ("distance", "tree"), "depth": ("0", "16", "32")}
HELP = {"pixels": "what a pixel is", "order": "the order in which faces are drawn", "depth": "bits of a pixel's depth; 0: no depth buffer"}


@dataclass(frozen=True)
class Target:
    """What is asked for; None: what the scene says."""
    pixels: str = None
    order: str = None
    depth: str = None

    def __bool__(self):
        return any((self.pixels, self.order, self.depth))

    @property
    def text(self):
        """As it is typed."""
        return " ".join(f"{name.upper()}={value}" for name, value in vars(self).items() if value)


def add_options(parser):
    """--pixels, --order and --depth; of_options reads them."""
    for name, values in VALUES.items():
        parser.add_argument(f"--{name}", metavar="|".join(values), help=f"{HELP[name]} (default: what the scene says)")


def of_options(options):
    """The Target of a command line."""
    asked = Target(*(getattr(options, name, None) for name in VALUES))
    for name, values in VALUES.items():
        value = getattr(asked, name)
        if value is not None and value not in values:
            raise ToolError(f"{name.upper()} is {quoted(value)}; it must be {', '.join(values[:-1])} or {values[-1]}")
    if asked.order == "tree" and asked.depth not in (None, "0"):
        raise ToolError(f"ORDER=tree draws without a depth buffer: leave it out, or leave out DEPTH={asked.depth}")
    return asked


def apply(scene, has_tree, asked, name):
    """Gives a SceneImage what is asked for. has_tree: whether it has one, or gets one. name: the scene's, for messages."""
    if asked.pixels:
        scene.pixel_bits = 16 if asked.pixels == "rgb565" else 8
    if asked.depth:
        scene.depth_bits = int(asked.depth)
    if asked.order:
        scene.by_distance = asked.order == "distance"
    if asked.order == "tree" and not has_tree:
        raise ToolError(f'ORDER=tree needs a tree, and {name} has none: give tree = "all" at the top of a scene file, or build an '
                        "image with --tree all")
    if asked and has_tree and scene.depth_bits and not scene.by_distance:
        more = "DEPTH=0" if asked.order else "ORDER=distance"
        raise ToolError(f"{asked.text}: a tree and a depth buffer do not go together, and {name} asks for "
                        f"{'a depth buffer' if asked.order else 'the order by its tree'}: give {more} too")


def _of_rgb565(scene):
    """What of a SceneImage only frames of RGB565 can show, and what to do about it in a scene file; None without."""
    from fixel.image import image_surface       # as in rewritten
    surfaces = scene.surfaces
    for number, one in enumerate(surfaces.textures if surfaces else ()):
        if one.format == image_surface.RGB565:
            name = surfaces.texture_names[number] if number < len(surfaces.texture_names) else number
            return f"texels of RGB565 (texture {quoted(name)})", "bits = 8 in the texture"
    if any(one.flags & image_surface.ADDED for one in (surfaces.surfaces if surfaces else ())):
        return 'faces with blend = "add"', "blend = true in the object"
    if has_colours(scene):
        return "colours at corners", "vertex_colours = false in the object"
    return None


def has_colours(scene):
    """Whether a SceneImage has a surface with colours at its corners."""
    from fixel.image import image_surface       # as in rewritten
    return any(one.flags & image_surface.COLOURS for one in (scene.surfaces.surfaces if scene.surfaces else ()))


def check(scene, asked, name):
    """Refuses a SceneImage of which some parts do not go together. asked: the Target that it has got, or None."""
    found = _of_rgb565(scene)
    if found and scene.pixel_bits == 8:
        what, instead = found
        if asked and asked.pixels:
            raise ToolError(f"PIXELS=palette: frames of a palette cannot show {what}, which {name} has: leave PIXELS= out, or give "
                            f"PIXELS=rgb565 or {instead}")
        raise ToolError(f'{name}: frames of a palette cannot show {what}: give pixels = "rgb565" under [view], or {instead}')
    if found and scene.beams and found[0].startswith("texels"):
        raise ToolError(f"{name}: beams cannot light {found[0]}: leave the beams out, or give {found[1]}")
    if scene.beams and has_colours(scene):
        raise ToolError(f"{name}: beams cannot light colours at corners: leave the beams out, or give vertex_colours = false in the object")


# place field: a field of the header: who uses it in the tools
def rewritten(blob, asked, name):
    """The bytes of a scene image, with what is asked for."""
    from fixel.image import image, image_header     # they need a package, and whoever reads options needs none
    scene = image.unpack(blob)
    apply(scene, scene.tree is not None, asked, name)
    check(scene, asked, name)
    return image_header.retargeted(blob, scene)
