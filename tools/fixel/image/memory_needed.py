# SPDX-License-Identifier: MIT
"""How much memory fxl_renderer_init is given for a scene: the library's division of the block, in Python.

The block holds, in this order: the order of drawing; the vertex cache, in at most a quarter of the
rest; the display list, in all that is left. host_tests/tools/test_export_setup.py compares the figures
with what the library made of a block."""

from fixel.image import image_surface
from fixel.image.image_tree import SORTED

ORDER_ENTRY = 12        # bytes of an fxl_draw_entry
CACHED_VERTEX = 40      # bytes of an fxl_cached_vertex
WORD = 4                # bytes of a word of the display list
CLIP_PLANES = 6         # each adds at most one vertex to a convex polygon
RENDERER = 2576         # bytes of an fxl_renderer on a core of 32 bits, with FXL_POLYGON_CAPACITY 32
UNIT = 8                # the block is an array of uint64_t
MODERATE = 10240        # bytes beside the order: a cache of 64 vertices, and 7,680 bytes of display list


def draw_list_needed(scene):
    """Entries of the order of drawing: the instances, and the faces of the largest sorted model."""
    sorted_faces = [len(model.faces) for model in scene.models if model.kind == SORTED]
    return len(scene.objects) + max(sorted_faces, default=0)


def display_list_words(vertices):
    """FXL_DISPLAY_LIST_WORDS: of a polygon with so many vertices."""
    return 2 + 2 * vertices


def _up(size, unit):
    return -(-size // unit) * unit


def cache_entries(vertices):
    """Entries of a cache that holds so many vertices: a power of two."""
    return 1 << (vertices - 1).bit_length()


def words_beside(scene, face):
    """Words of a face's polygon beside its outline: with a surface the gradients of 1/z and, per attribute, of u, v and light;
    with a depth buffer that of the depth (lib/draw/surface_polygon.c)."""
    depth = 8 if scene.depth_bits else 0
    if face.mapped is None:
        return 2 + depth if depth else 0
    surface = scene.surfaces.surfaces[face.mapped.surface]
    attributes = (2 if surface.texture else 0) + (1 if surface.flags & image_surface.LIT else 0)
    return 4 + 6 * (1 + attributes) + depth


def most_words(scene):
    """Words of a display list that holds every polygon of any frame: each face of each instance is
    turned to the eye and cut by every plane."""
    of_model = [sum(display_list_words(len(face.corners) + CLIP_PLANES) + words_beside(scene, face) for face in model.faces)
                for model in scene.models]
    return sum(of_model[item.model] for item in scene.objects)


def least(scene):
    """The uint64_t without which fxl_renderer_init answers FXL_E_CAPACITY: the order of drawing alone."""
    return _up(ORDER_ENTRY * draw_list_needed(scene), UNIT) // UNIT


def moderate(scene):
    """The uint64_t that the tools propose: never more than most, and at most MODERATE bytes beside the order."""
    return min(most(scene), least(scene) + MODERATE // UNIT)


def divided(scene, units):
    """(entries of the cache, words of the display list) that the library makes of a block of so many uint64_t."""
    rest = (units - least(scene)) * UNIT
    entries = cache_entries(max(len(model.vertices) for model in scene.models))
    while entries > rest // 4 // CACHED_VERTEX:
        entries //= 2
    return entries, (rest - entries * CACHED_VERTEX) // WORD


def of_program(scene):
    """Bytes of RAM that a program of the user's gives the library for a scene, beside its pixels: without a display list,
    as NAME_MEMORY of an exported header, and with a list that holds every polygon."""
    cache = CACHED_VERTEX * min(64, cache_entries(max(len(model.vertices) for model in scene.models)))
    return {"without_list": RENDERER + UNIT * least(scene) + cache, "moderate": RENDERER + UNIT * moderate(scene),
            "with_list": RENDERER + UNIT * most(scene)}


def most(scene):
    """The uint64_t beyond which no frame becomes quicker: all polygons fit the display list, and all
    vertices of the largest model the cache."""
    cache = CACHED_VERTEX * cache_entries(max(len(model.vertices) for model in scene.models))
    rest = max(4 * cache, cache + WORD * most_words(scene))
    return least(scene) + _up(rest, UNIT) // UNIT


# By the ending of the constant in an exported header.
SIZES = {"_FAST": most, "": moderate, "_LEAST": least}
