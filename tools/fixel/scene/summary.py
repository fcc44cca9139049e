# SPDX-License-Identifier: MIT
"""What is in a scene image, for people or as JSON."""

import json

from fixel.base.errors import one_line
# place field: a field of the header: who uses it in the tools
from fixel.image import image, image_header, image_surface
from fixel.scene import path


# place pixel-format: what fixel info prints
PIXELS = {"palette": "entries of the palette", "rgb565": "RGB565"}


def summary(scene):
    """What is in an image, as plain data."""
    kinds = [scene.models[item.model].kind for item in scene.objects]
    used = {face.colour for model in scene.models for face in model.faces}
    layers = sorted({item.layer for item in scene.objects})
    return {
        "bytes": scene.size, "crc32": f"{scene.crc:08x}",
        "width": scene.width, "height": scene.height,
        "fov_degrees": round(scene.fov * 360 / 2 ** 32, 6),
        "focal_pixels": round(image_header.focal_pixels(scene.width, scene.fov), 6),
        "centre": [value / 65536 for value in scene.centre or image_header.middle(scene.width, scene.height)],
        "scale": scene.scale / 65536 or None,
        "near": scene.near / 65536, "far": scene.far / 65536, "inset": scene.inset / 65536,
        "objects": len(scene.objects), "convex_objects": kinds.count(image.CONVEX),
        "sorted_objects": kinds.count(image.SORTED), "layers": layers,
        "models": len(scene.models),
        "vertices": sum(len(model.vertices) for model in scene.models),
        "faces": sum(len(model.faces) for model in scene.models),
        "faces_placed": sum(len(scene.models[item.model].faces) for item in scene.objects),
        "clusters": sum(len(model.clusters) for model in scene.models),
        "turned_objects": len(scene.placements), "moving_objects": len(scene.motions),
        "motion_keys": sum(len(motion.keys) for motion in scene.motions),
        "textures": len(scene.surfaces.textures) if scene.surfaces else 0,
        "rgb565_textures": sum(one.format == image_surface.RGB565 for one in scene.surfaces.textures) if scene.surfaces else 0,
        "texel_bytes": sum(image_surface.texel_bytes(one) for one in scene.surfaces.textures) if scene.surfaces else 0,
        "added_surfaces": sum(bool(one.flags & image_surface.ADDED) for one in scene.surfaces.surfaces) if scene.surfaces else 0,
        "faces_with_surfaces": sum(face.mapped is not None for model in scene.models for face in model.faces),
        "billboards": len(scene.billboards.boards) if scene.billboards else 0,
        "sprite_bytes": sum(len(one.pixels) + len(one.colours) for one in scene.billboards.boards) if scene.billboards else 0,
        "light_levels": len(scene.light.ramp) if scene.light else 0,
        "point_lights": len(scene.light.points) if scene.light else 0,
        "tree_nodes": len(scene.tree.nodes) if scene.tree else 0,
        "tree_object": scene.tree.object if scene.tree else None, "colours": len(used), "frames": scene.frames,
        "pixels": "rgb565" if scene.pixel_bits == 16 else "palette", "depth_bits": scene.depth_bits,
        "order": "tree" if scene.tree and not scene.by_distance else "distance",
        "path": "poses" if scene.path_kind == image.POSES else "strides",
        "start": path.describe(scene.start), "unknown_sections": scene.unknown,
    }


def info(file, as_json, name=None):
    """Prints what is in a scene image. name: what it is called, if it was made of another file."""
    data = summary(image.load(file))
    if as_json:
        print(json.dumps(data, indent=1))
        return
    print(f"{one_line(name or file)}: {data['bytes']:,} bytes, CRC-32 {data['crc32']}")
    seen = (f"{data['scale']:g} pixels a world unit: the lens is orthographic" if data["scale"] else
            f"field of view {data['fov_degrees']:g} degrees (focal {data['focal_pixels']:g} pixels)")
    print(f"  screen   {data['width']}x{data['height']}, {seen}")
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
              + (f"{data['rgb565_textures']} of them of RGB565, " if data["rgb565_textures"] else "")
              + f"{data['texel_bytes']:,} bytes of texels")
    if data["added_surfaces"]:
        print(f"  added    to what is beneath: {data['added_surfaces']} surfaces")
    if data["billboards"]:
        print(f"  billboards {data['billboards']}, {data['sprite_bytes']:,} bytes of pixels and colours")
    if data["light_levels"]:
        print(f"  light    at run time, in {data['light_levels']} levels; {data['point_lights']} point lights")
    if data["clusters"]:
        print(f"  clusters {data['clusters']:,} of faces")
    if data["tree_nodes"]:
        print(f"  tree     {data['tree_nodes']:,} nodes, over object {data['tree_object']}")
    depth = f"a depth buffer of {data['depth_bits']} bits" if data["depth_bits"] else "no depth buffer"
    print(f"  drawn    by {data['order']}, in {PIXELS[data['pixels']]}, with {depth}")
    if data["unknown_sections"]:
        print(f"  unknown  sections of kind {', '.join(map(str, data['unknown_sections']))}: a newer Fixel made the image; it is "
              "drawn without them")
    print(f"  path     {data['frames']} frames as {data['path']}, from {data['start']}")
