# SPDX-License-Identifier: MIT
"""What a frame costs on a core: bench/costs.json, how it is fitted, and what it says of a scene.

build/host/predict walks a scene's path as a board would, and counts what the library does (host_tests/judges/predict). The
instructions of a frame are a sum of these counts, each times a cost. The costs are fitted by least squares of the
relative errors; none is negative."""

import json
import pathlib

import numpy as np

from fixel.base import limits
from fixel.base.errors import ToolError
from fixel.base.reading import shortened
from fixel.bench.predict import COSTS

FILE = COSTS
WALK_CPU = 600.0        # seconds of CPU time for a walk on the host
SWEEPS = 20_000
RIDGE = 1e-9            # keeps counts that always go together from taking turns

# place pixel-format: what is counted (wide_...), and what it costs
# What each count of host_tests/judges/predict/counts.h is, for people.
NAMES = {
    "frames": "a frame", "instances": "an instance of the scene", "instances_seen": "an instance in sight",
    "instances_viewed": "an instance's model view", "instances_passed": "an instance that a band looks at, beside the list",
    "turned_checked": "a turned instance whose rotation is checked", "turned_viewed": "the model view of a turned instance",
    "faces_tested": "a face of a convex instance", "faces_facing": "a face of a sorted instance",
    "faces_sorted": "a face that is sorted", "faces_clipped": "a face that the clipper gets",
    "faces_outside": "a face that the clipper finds outside", "faces_between": "a face that covers no pixel",
    "corners": "a corner that the clipper gets", "vertices": "a vertex that is transformed",
    "projections": "a vertex that is projected", "assembled": "a face that planes may cut", "cut_edges": "an edge that is cut",
    "parallel_instances": "an instance in sight of an orthographic lens", "parallel_sorted": "a face that is sorted for such a lens",
    "parallel_vertices": "a vertex that such a lens projects", "parallel_clipped": "a face that its clipper gets",
    "parallel_corners": "a corner that its clipper gets", "parallel_flat": "a vertex of its faces with surfaces",
    "parallel_depths": "a face whose depth is found for it",
    "list_polygons": "a polygon for the display list", "list_words": "a word for the display list",
    "list_reads": "a polygon that a band draws from the list", "list_scanned": "a word of the list that a band passes",
    "spilled_faces": "a face that a band looks at, beside the list", "row_searches": "a polygon whose rows are found",
    "polygons": "a polygon that is scanned", "polygons_drawn": "a polygon with rows in the band", "trapezoids": "a trapezoid",
    "edges": "an edge of a polygon", "rows": "a row of a polygon", "pixels": "a pixel of a polygon", "bands": "a band",
    "cleared": "a pixel that is cleared", "horizon_rows": "a row of a horizon",
    "horizon_changes": "a place in such a row at which the level changes",
    "horizon_searched": "such a place in the first row of a band",
    "lines": "a line or point of an instance in sight", "lines_placed": "a line or point whose ends are found",
    "lines_cut": "a line that planes may cut", "lines_painted": "a line or point that reaches the band",
    "lines_with_depth": "such a one with a depth of its own", "line_faces": "a face on which such a one lies",
    "line_places": "a place along a line, and of each of its pixels across with a depth buffer",
    "line_pixels": "a pixel of a line", "line_depth_pixels": "a pixel of a line with a depth of its own",
    "line_face_pixels": "a pixel of a line on a face, for each face", "brightnesses": "the light of a face or of a corner",
    "lamps": "a lamp that reaches a face or a corner", "lamps_behind": "a lamp behind a face or a corner",
    "lamps_beyond": "a lamp before a face or a corner that is out of its range", "in_fog": "a face or corner within the fog",
    "surfaces_found": "a face whose surface is found", "attributes_found": "an attribute of a surface that is found",
    "corners_on_screen": "a vertex that a small face is found by", "small_faces": "a small face",
    "small_surfaces": "a small face whose surface is found", "small_attributes": "an attribute of a small face",
    "small_weights": "a small face whose weight is not constant", "small_divided": "an attribute of such a face",
    "small_depths": "a small face whose depth is found", "small_linear": "a small lit triangle whose planes are words",
    "surfaces_listed": "a polygon with a surface for the display list",
    "surfaces_read": "a polygon with a surface that a band draws from the list",
    "surfaces_painted": "a polygon with a surface that is painted", "painted_edges": "an edge of a polygon with a surface",
    "painted_rows": "a row of a polygon with a surface", "segment_rows": "a row of a surface by the kernel",
    "segments": "16, 8 or 4 columns of a texture", "segment_divided": "a pixel between them that is divided",
    "segment_pixels": "a pixel of a texture",
    "line_segments": "16 columns of a texture where the weight is constant",
    "lit_segments": "16, 8 or 4 columns of a lit texture", "lit_segment_pixels": "a pixel of a lit texture",
    "slow_rows": "a row of a surface not all by the kernel", "slow_segments": "16, 8 or 4 columns of a surface beside the kernel",
    "slow_attributes": "an attribute at the end of such columns", "slow_pixels": "a pixel of a surface beside kernel and loops",
    "loop_pixels": "a pixel of a texture by a loop of C", "level_pixels": "a pixel of a lit colour by a loop of C",
    "level_rows": "a row of a small face of a lit colour",
    "divided_pixels": "a pixel that is divided by itself beside the kernel", "each_rows": "a row of pixels that are each divided, by the kernel",
    "each_segments": "16 columns of it", "each_pixels": "a pixel of it", "depth_planes": "a face whose depth is found",
    "depth_hidden_runs": "a run of hidden pixels of a surface that is not listed", "depth_hidden": "a hidden pixel of it",
    "listed_polygons": "a surface whose visible runs are listed, near to far", "listed_trapezoids": "a trapezoid of such a surface",
    "listed_rows": "a row of such a surface", "listed_runs": "a run of its visible or hidden pixels",
    "listed_kept": "a visible pixel of such a surface", "listed_hidden": "a hidden pixel of such a surface",
    "listed_kernel_runs": "a run of such a surface that the kernel paints",
    "depth_each": "a pixel whose depth is compared, far to near", "depth_each_rows": "a row of a polygon, far to near",
    "depth_each_unkept": "a pixel of a surface that is blended or has holes, far to near",
    "depth_holes": "a pixel with a depth of a surface that has holes, over either background",
    "depth_outlines": "a polygon of one colour, near to far", "depth_outline_edges": "an edge of such a polygon",
    "depth_outline_trapezoids": "a trapezoid of such a polygon", "depth_outline_rows": "a row of such a polygon",
    "depth_outline_runs": "a run of its visible or hidden pixels", "depth_outline_kept": "a visible pixel of such a polygon",
    "depth_outline_hidden": "a hidden pixel of such a polygon",
    "smooth_outlines": "a smooth polygon of one octave, near to far", "smooth_edges": "an edge of such a polygon",
    "smooth_trapezoids": "a trapezoid of such a polygon", "smooth_rows": "a row of such a polygon",
    "smooth_kept": "a visible pixel of such a polygon", "smooth_hidden": "a hidden pixel of such a polygon",
    "points_transformed": "a billboard that is placed", "billboards": "a billboard that is painted",
    "billboard_rows": "a row of a billboard", "billboard_texels": "a pixel of a billboard",
    "billboard_repeated": "a pixel of a row of a billboard that shows the texels of the row above",
    "billboard_drawn": "a pixel of a billboard that is drawn",
    "billboard_tested": "a pixel of a billboard, with a depth buffer",
    "billboard_compared": "a pixel of a billboard whose depth is compared",
    "instances_in_beams": "an instance and a beam that may reach it", "plane_distances": "a corner and a plane of a beam",
    "lit_pieces": "a piece of a face that beams split", "lit_corners": "a corner of a piece",
    "lit_cuts": "an edge that a beam cuts", "lit_searched": "a corner that is looked through for a cut",
    "turned_normals": "a turned face whose normal is turned into the world",
    "tree_nodes": "a node of the tree", "tree_spheres": "a node whose sphere is tested", "tree_faces": "a face of a node",
    "tree_leaves": "a leaf that is looked at for what moves",
    "tree_pieces": "a piece of a face that the tree cuts", "tree_vertices": "a vertex of such a piece",
    "wide_polygons": "a polygon of RGB565 that is scanned", "wide_edges": "an edge of such a polygon",
    "wide_outline_rows": "a row of such a polygon", "wide_outline_pixels": "a pixel of such a polygon",
    "wide_rows": "a row of RGB565 that is filled", "wide_pixels": "a pixel of RGB565 that is filled",
    "wide_texture_rows": "a row of a surface in RGB565", "wide_segments": "16, 8 or 4 columns of a surface in RGB565",
    "wide_kernel_rows": "a row of a texture in RGB565 by the kernel", "wide_kernel_segments": "16, 8 or 4 columns of it",
    "wide_kernel_divided": "a pixel between them that is divided",
    "wide_kernel_pixels": "a pixel of it", "wide_line_segments": "16 columns of it where the weight is constant",
    "wide_painted": "a pixel of a surface in RGB565", "wide_divided": "such a pixel that is divided by itself",
    "wide_values": "an attribute of such a pixel", "wide_texels": "a texel in RGB565", "wide_lit": "a lit pixel of RGB565",
    "wide_lit_texels": "a pixel of lit texels of a palette in RGB565",
    "wide_evenly_lit": "a pixel of texels in RGB565 that are lit evenly",
    "wide_levels": "a pixel of a lit colour in RGB565",
    "wide_repeated": "a pixel of opaque texels of RGB565", "wide_repeated_lit": "a lit one of them",
    "wide_blended": "a blended pixel of RGB565", "wide_colours_found": "a face with colours at its corners, a lit one twice",
    "wide_colour_rows": "a row of such a face", "wide_colour_runs": "a run of its pixels by the kernel", "wide_colour_pixels": "a pixel of such a run",
    "wide_colour_shown": "a pixel of it that is no part of a run", "wide_billboard_drawn": "a pixel of a billboard in RGB565"}


class NoRoom(ToolError):
    """A board has no room for a scene."""


def load():
    """bench/costs.json."""
    try:
        return json.loads(FILE.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{FILE}: cannot be read ({shortened(str(error))}); make costs renews it") from error


def core_of(flags):
    """The core of bench/costs.json that has the code of one with these compiler's flags, or None. A Cortex-M4, M7, M33,
    and an M55 that passes no floats in registers have the code of an M3 (lib/math/family.h)."""
    words = flags.split()
    if any(word.startswith(("-O", "-DFXL_")) for word in words):
        return None
    cores = {"-mcpu=cortex-m0": "m0", "-mcpu=cortex-m0plus": "m0", "-mcpu=cortex-m3": "m3", "-mcpu=cortex-m4": "m3",
             "-mcpu=cortex-m7": "m3", "-mcpu=cortex-m33": "m3", "-mcpu=cortex-m55": "m3", "-march=rv32imc": "rv32"}
    if "-mcpu=cortex-m55" in words and "-mfloat-abi=soft" not in words:
        return None     # its vectors take other instructions
    return next((cores[word] for word in words if word in cores), None)


def count(*words, **more):
    """counted without the bytes of the display list."""
    return counted(*words, **more)[:2]


def counted(*words, **more):
    """(names, array of a row for each frame) of what the library does, and the bytes of its display list. band, words: bytes of a
    band and of the display list with what else takes of it; order, cache: entries; most: bytes that limit the list; name: the
    user's file, for messages."""
    data = _walked(*words, **more)
    return data["names"], np.array(data["frames"], dtype=float), data["list_bytes"]


BESIDE = 1 << 20        # bytes for what a scene has beside its faces, which have memory of their own in a program of the user's


def boxes(build, file, scene, frames=0, steps=(1, 1)):
    """Of each frame of a path the boxes in which it differs from the one before, as [first column, columns, first row, rows].
    scene: that of the image file; steps: columns and rows that boxes begin and end with, 0 columns for whole rows."""
    row, beside = scene.width * scene.pixel_bits // 8, 2 * scene.width * scene.height * scene.depth_bits // 8
    return _walked(build, file, scene.height * row, 0, BESIDE + beside + 1, 1, 1, frames, steps=steps)["boxes"]


def _walked(build, image, band, order, words, cache, most=0, frames=0, name=None, steps=(1, 1)):
    """What build/host/predict says of a scene image."""
    program = pathlib.Path(build) / "host" / "predict"
    if not program.exists():
        raise ToolError(f"{program} is not built: make predict builds it")
    done = limits.run([program, str(image), *map(str, (band, order, words, cache, most, frames, *steps))], WALK_CPU, text=True)
    if done.returncode:
        said = done.stderr.strip().removeprefix("error: ").replace(str(image), str(name or image))
        raise (NoRoom if done.returncode == 1 else ToolError)(said or f"{program} ended with {done.returncode}")
    return json.loads(done.stdout)


def fit(rows, wanted, weights, known=None):
    """Costs, none below 0, with the least sum of weights times squares of relative errors: coordinate descent. known: costs
    that stay; NaN where one is to be found."""
    known = np.full(rows.shape[1], np.nan) if known is None else known
    free, stays = np.isnan(known), np.nan_to_num(known)
    scaled = rows / wanted[:, None] * np.sqrt(weights)[:, None]
    sizes = np.sqrt((scaled ** 2).sum(axis=0))
    used = (sizes > 0) & free
    target = np.sqrt(weights) - scaled @ stays
    scaled = scaled[:, used] / sizes[used]
    matrix = scaled.T @ scaled + RIDGE * np.eye(used.sum())
    target = scaled.T @ target
    found = np.zeros(used.sum())
    for _ in range(SWEEPS):
        before = found.copy()
        for i in range(len(found)):
            found[i] = max(0.0, found[i] + (target[i] - matrix[i] @ found) / matrix[i, i])
        if np.abs(found - before).max() < 1e-12:
            break
    costs = stays.copy()
    costs[used] = found / sizes[used]
    return costs


def instructions(costs, names, counts):
    """Instructions of each frame, as an array. costs: those of a core, by name."""
    missing = [name for name in names if name not in costs]
    if missing:
        raise ToolError(f"{FILE}: it has no cost of {', '.join(missing)}: make costs renews it")
    return counts @ np.array([costs[name] for name in names])


# --- the three that are not instructions ----------------------------------------------

def memory(board, image_bytes, has_looks=False):
    """Bytes of flash and RAM on a board of bench/costs.json: what the program and a scene image take, and what there
    is. The stack is a part of the RAM; seen is the deepest that the fit's scenes went: with light or surfaces, has_looks,
    or without."""
    return {"flash": {"program": board["flash_bytes"], "scene": image_bytes, "scene_room": board["scene_room"],
                      "of": board["flash_size"]},
            "ram": {"program": board["ram_bytes"], "of": board["ram_size"]},
            "stack": {"seen": board["stack_seen_looks" if has_looks else "stack_seen"], "reserved": board["stack_reserved"]}}
