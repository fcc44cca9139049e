# SPDX-License-Identifier: MIT
"""Scene files into scene images or C headers, and scene images explained.

    fixel build SCENE -o OUT.fxls [--frames N] [--screen WxH] [--tree LAYERS]
        SCENE is a .toml or a model (.obj, .gltf, .glb, .stl); LAYERS: 5, or 2,4,5, or all, or most (that of most faces),
        or none; without --tree, what the scene's key "tree" says
    fixel export --c SCENE -o OUT.h [--name NAME] [--frames N] [--screen WxH] [--tree LAYERS]
        SCENE is a .toml, a model or a .fxls; --frames N exports the path too, as N poses
    fixel texture IMAGE -o OUT.h [--name NAME] [--size WxH] [--levels N] [--clamp]
        an image as a texture of a program's RGB565 frames
    fixel info OUT.fxls [--json]

tools/scene.py is the same without set-up's fixel: scene.py build ..."""

import argparse
import json
import os
import re

from fixel.image import image, image_header, image_lens, image_surface
from fixel.scene import making, path, texture, toml_scene
from fixel.base import bounded
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted


def whole(text):
    """A number of frames from the command line, as argparse wants it."""
    if not re.fullmatch("[+-]?[0-9]{1,19}", text):
        raise argparse.ArgumentTypeError(f"{quoted(text)} is not a whole number")
    return int(text)


def make_texture(arguments):
    """Writes an image as a texture in C."""
    sides = re.fullmatch(r"([0-9]{1,3})x([0-9]{1,3})", arguments.size) if arguments.size else None
    size = tuple(map(int, sides.groups())) if sides else None
    if arguments.size and (size is None or not all(map(texture.is_side, size))):
        raise ToolError(f"--size is {quoted(arguments.size)}; it must be like 64x32, both powers of two from 1 to "
                        f"{texture.SIDE_MAX}")
    if not 1 <= arguments.levels <= image_surface.LEVELS_MAX:
        raise ToolError(f"--levels is {arguments.levels}; it must be from 1 to {image_surface.LEVELS_MAX}")
    name = arguments.name or os.path.splitext(os.path.basename(arguments.image))[0]
    texels = making.texture(arguments.image, arguments.out, name, size, arguments.levels, arguments.clamp,
                            bounded.limits_of(arguments))
    print(f"{one_line(arguments.out)}: {name}_texture, {2 * texels:,} bytes of texels")


def summary(scene):
    """What is in an image, as plain data."""
    kinds = [scene.models[item.model].kind for item in scene.objects]
    used = {face.colour for model in scene.models for face in model.faces}
    layers = sorted({item.layer for item in scene.objects})
    return {
        "bytes": scene.size, "crc32": f"{scene.crc:08x}",
        "width": scene.width, "height": scene.height,
        "fov_degrees": round(scene.fov * 360 / 2 ** 32, 6),
        "focal_pixels": round(image_lens.focal_pixels(scene.width, scene.fov), 6),
        "centre": [value / 65536 for value in scene.centre or image_lens.middle(scene.width, scene.height)],
        "near": scene.near / 65536, "far": scene.far / 65536, "inset": scene.inset / 65536,
        "objects": len(scene.objects), "convex_objects": kinds.count(image.CONVEX),
        "sorted_objects": kinds.count(image.SORTED), "layers": layers,
        "models": len(scene.models),
        "vertices": sum(len(model.vertices) for model in scene.models),
        "faces": sum(len(model.faces) for model in scene.models),
        "faces_placed": sum(len(scene.models[item.model].faces) for item in scene.objects),
        "clusters": sum(len(model.clusters) for model in scene.models),
        "turned_objects": len(scene.turns), "moving_objects": len(scene.motions),
        "motion_keys": sum(len(motion.keys) for motion in scene.motions),
        "textures": len(scene.surfaces.textures) if scene.surfaces else 0,
        "texel_bytes": sum(image_surface.texel_bytes(one) for one in scene.surfaces.textures) if scene.surfaces else 0,
        "faces_with_surfaces": sum(face.mapped is not None for model in scene.models for face in model.faces),
        "billboards": len(scene.billboards.boards) if scene.billboards else 0,
        "sprite_bytes": sum(len(one.pixels) + len(one.colours) for one in scene.billboards.boards) if scene.billboards else 0,
        "light_levels": len(scene.light.ramp) if scene.light else 0,
        "point_lights": len(scene.light.points) if scene.light else 0,
        "tree_nodes": len(scene.tree.nodes) if scene.tree else 0,
        "tree_object": scene.tree.object if scene.tree else None, "colours": len(used), "frames": scene.frames,
        "visibility": toml_scene.VISIBILITIES[scene.visibility],
        "path": "poses" if scene.path_kind == image.POSES else "strides",
        "start": path.describe(scene.start),
    }


def info(file, as_json):
    data = summary(image.load(file))
    if as_json:
        print(json.dumps(data, indent=1))
        return
    print(f"{one_line(file)}: {data['bytes']:,} bytes, CRC-32 {data['crc32']}")
    print(f"  screen   {data['width']}x{data['height']}, field of view {data['fov_degrees']:g} "
          f"degrees (focal {data['focal_pixels']:g} pixels)")
    if data["centre"] != [data["width"] / 2, data["height"] / 2]:
        print(f"  centre   {data['centre'][0]:g}, {data['centre'][1]:g} pixels: the lens is off-centre")
    print(f"  depth    near {data['near']:g}, far {data['far']:g}, inset {data['inset']:g}")
    print(f"  objects  {data['objects']} ({data['convex_objects']} convex, "
          f"{data['sorted_objects']} sorted) on layers {', '.join(map(str, data['layers']))}")
    print(f"  models   {data['models']}: {data['vertices']:,} vertices, {data['faces']:,} faces "
          f"({data['faces_placed']:,} placed), {data['colours']} colours")
    if data["turned_objects"]:
        print(f"  turned   {data['turned_objects']} objects; {data['moving_objects']} of them move, by "
              f"{data['motion_keys']:,} keys")
    if data["faces_with_surfaces"]:
        print(f"  surfaces of {data['faces_with_surfaces']:,} faces; {data['textures']} textures, "
              f"{data['texel_bytes']:,} bytes of texels")
    if data["billboards"]:
        print(f"  billboards {data['billboards']}, {data['sprite_bytes']:,} bytes of pixels and colours")
    if data["light_levels"]:
        print(f"  light    at run time, in {data['light_levels']} levels; {data['point_lights']} point lights")
    if data["clusters"]:
        print(f"  clusters {data['clusters']:,} of faces")
    if data["tree_nodes"]:
        print(f"  tree     {data['tree_nodes']:,} nodes, over object {data['tree_object']}")
    if data["visibility"] != toml_scene.VISIBILITIES[image_header.BY_DEFAULT]:
        print(f"  drawn    by visibility method {data['visibility']}")
    print(f"  path     {data['frames']} frames as {data['path']}, from {data['start']}")


def arguments_of(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    building = commands.add_parser("build", help="compile a .toml or a model into a scene image")
    exporting = commands.add_parser("export", help="write a .toml, a model or a .fxls as a C header")
    exporting.add_argument("--c", action="store_true", required=True, help="as C, the only language there is")
    exporting.add_argument("--name", help="what the header's names begin with; without, the file's name")
    for command in (building, exporting):
        command.add_argument("scene")
        command.add_argument("-o", "--out", required=True)
        command.add_argument("--frames", type=whole, help="frames of the path; export writes no path without it")
        command.add_argument("--screen", help="width and height instead of the scene's, like 128x64")
        command.add_argument("--tree", metavar="LAYERS", help="draw these layers by a tree: 5, or 2,4,5, or all, or most, "
                             "or none, instead of what the scene says")
    drawing = commands.add_parser("texture", help="write an image as a texture of RGB565, in C")
    drawing.add_argument("image")
    drawing.add_argument("-o", "--out", required=True)
    drawing.add_argument("--name", help="what the header's names begin with; without, the file's name")
    drawing.add_argument("--size", help="width and height to scale it to, like 64x64")
    drawing.add_argument("--levels", type=whole, default=1, help="with smaller pictures for what is far, so many in all")
    drawing.add_argument("--clamp", action="store_true", help="beyond its edge it shows the texel of the edge")
    for command in (building, exporting, drawing):
        bounded.add_options(command)
    telling = commands.add_parser("info", help="say what is in a scene image")
    telling.add_argument("image")
    telling.add_argument("--json", action="store_true")
    return parser.parse_args(argv)


def main(argv):
    arguments = arguments_of(argv)
    if arguments.command == "info":
        info(arguments.image, arguments.json)
        return 0
    if arguments.command == "texture":
        make_texture(arguments)
        return 0
    limits, screen = bounded.limits_of(arguments), making.parse_screen(arguments.screen) if arguments.screen else None
    if arguments.command == "export":
        made = making.export(arguments.scene, arguments.out, arguments.name, arguments.frames, screen, arguments.tree, limits)
    else:
        made = making.build(arguments.scene, arguments.out, arguments.frames, screen, arguments.tree, limits)
    making.tell(arguments.out, made)
    return 0

