# SPDX-License-Identifier: MIT
"""The report as one self-contained page."""

import base64
import pathlib

import jinja2
from PIL import Image

from fixel.base import picture
from fixel.report import report_claims, report_plots

TEMPLATES = pathlib.Path(__file__).resolve().parents[2] / "templates"
TITLES = {"matrix": "Camera matrix", "vertex": "Vertex: transform and project", "clip": "Clip",
          "fill": "Fill", "near": "Near plane", "depth": "Depth", "fov": "Field of view",
          "coordinates": "Size of the coordinates", "edge_length": "Length of a clipped edge",
          "plane_angle": "Angle to the clip plane", "texel": "Texel, divided at each pixel",
          "texel_16": "Texel, divided every 16 pixels", "texel_8": "Texel, divided every 8 pixels",
          "affine": "Texel without perspective", "light": "Level of light",
          "depth_buffer_16": "Depth buffer of 16 bits", "depth_buffer_32": "Depth buffer of 32 bits",
          "texel_depth": "Texel by depth", "texel_size": "Texel by size of the coordinates",
          "texel_face": "Texel by size of the face", "light_depth": "Level of light by depth",
          "distance_16": "Resolution of 16 bits by distance", "distance_32": "Resolution of 32 bits by distance"}
NOTES = {
    "near": "Vertices at any depth from the near plane on. The worst lies near the plane or very far.",
    "depth": "The plain port is inexact near the eye because of its 16 fractional bits, and far away because of "
             "its reciprocal. Float32 is inexact near the eye because the coordinates are large. Fixel keeps "
             "exact sums and rounds once, on the screen.",
    "fov": "Depths from 1 to 256. A narrow view magnifies the error of the earlier steps.",
    "coordinates": "Depths from 1/4 to 1, with the camera ever farther from the origin. Beyond 256 units a "
                   "float has fewer than 16 fractional bits.",
    "edge_length": "Intersections at depths from 1 to 4. The longer the edge, the less exact is float32's "
                   "fraction.",
    "plane_angle": "If the edge is nearly parallel to the plane, the intersection moves along the edge, not "
                   "off it.",
    "texel_depth": "Coordinates up to 256 texels, faces up to twice as long as their pixel is deep, around a texture of "
                   "128 texels: so 63.5 is any texel.",
    "texel_size": "Depths from 1 to 16. Fixel keeps 30 bits of what a face's texture is on the screen, so its error "
                  "grows with the coordinates, as docs/accuracy.md, section 5.1, states.",
    "texel_face": "Divided every 16 pixels, coordinates up to 256 texels. The others interpolate between divisions "
                  "that may lie off the face. Fixel divides more often where half a texel could be lost.",
    "light_depth": "A sun, a lamp and fog, at corners up to twice as far from each other as their pixel is deep.",
    "distance_16": "The near plane is at 1/4, the far plane at 2,048. The others keep near/z, of which little is left far "
                   "away. Fixel keeps it with an exponent: its resolution is a share of the distance.",
    "distance_32": "The same planes. The plain port keeps 1/z in 16.16, float32 keeps it as a float.",
}


def _grouped(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(row[key], []).append(row)
    return groups


def _ordered(rows):
    return sorted(rows, key=lambda row: report_plots.ORDER.index(row["design"]))


def stage_blocks(report):
    """A table, a histogram and the worst inputs of each stage."""
    return [{"id": stage, "title": TITLES.get(stage, stage), "measure": rows[0].get("measure", ""),
             "unit": rows[0]["unit"], "rows": _ordered(rows),
             "svg": report_plots.histogram(stage, rows, f"stage-{stage}")}
            for stage, rows in _grouped(report["stages"], "stage").items()]


def sweep_blocks(report):
    """A plot of each parameter."""
    return [{"title": TITLES.get(name, name), "note": NOTES.get(name, ""),
             "svg": report_plots.sweep(rows, f"sweep-{name}")}
            for name, rows in _grouped(report["sweeps"], "parameter").items()]


def _embedded(colours, caption):
    return {"caption": caption,
            "png": base64.b64encode(picture.png_bytes(Image.fromarray(colours))).decode()}


def frame_block(shown):
    """A frame: fixed, double, difference; whole, and enlarged where it differs."""
    differs = shown.fixed != shown.double
    fixed = picture.as_rgb(shown.fixed, shown.palette)
    double = picture.as_rgb(shown.double, shown.palette)
    ringed = picture.difference_panel(fixed, differs, picture.RING_DISTANCE)
    panels = [[_embedded(fixed, "Fixel"), _embedded(double, "double precision"),
               _embedded(ringed, "difference")]]
    if differs.any():
        y0, y1, x0, x1 = picture.differing_region(differs)
        where = f"columns {x0}–{x1 - 1}, rows {y0}–{y1 - 1}, enlarged"
        panels.append([_embedded(colours[y0:y1, x0:x1], caption) for colours, caption in
                       ((fixed, f"Fixel: {where}"), (double, "double precision, enlarged"),
                        (picture.difference_panel(fixed, differs), "difference, enlarged"))])
    return {"scene": shown.scene, "frame": shown.frame, "differing": shown.differing, "panels": panels}


def scene_rows(report):
    """The frames added up by scene."""
    rows = []
    for scene, frames in _grouped(report["frames"], "scene").items():
        distances = [frame["max_edge_distance_px"] for frame in frames
                     if frame["max_edge_distance_px"] is not None]
        tied = [frame["pixels_tied"] for frame in frames]
        rows.append({"scene": scene, "frames": len(frames),
                     "differing": sum(frame["pixels_differing"] for frame in frames),
                     "unexplained": sum(frame["pixels_unexplained"] for frame in frames),
                     "tied": None if None in tied else sum(tied),
                     "distance": max(distances) * report_plots.PIXEL if distances else None})
    return rows


def tiles(report):
    """The figures that matter most: (design, what, value in words)."""
    worst = {row["design"]: row for row in report["stages"] if row["stage"] == "vertex"}
    return [(design, report_plots.NAMES[design],
             report_plots.in_words(worst[design]["max"]) if design != "fixel"
             else f"{worst[design]['max']:.2f}/65536 pixel") for design in report_plots.ORDER]


def render(report, shown):
    """The page as text; shown are the frames to look at."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters["figure"] = figure
    environment.filters["unit"] = lambda unit: unit.replace("2^-30", "2⁻³⁰")
    words = {claim.id: claim.words for claim in report_claims.CLAIMS}
    return environment.get_template("report.html").render(
        report=report, words=words, tiles=tiles(report), claims=report["claims"],
        complaints=report_claims.complaints(report) + report_claims.complaints_of_stages(report["twins"]),
        shortfall=report_claims.shortfall(report), twins=report["twins"], stages=stage_blocks(report),
        sweeps=sweep_blocks(report), scenes=scene_rows(report), scales=report["scales"],
        scale_board=report["board"], third=report["third_judge"], names=report_plots.NAMES,
        frame_claim=next(claim for claim in report["claims"] if claim["id"] == "frame"),
        per_frame_svg=report_plots.per_frame(report["frames"], "per-frame"),
        shown=[frame_block(each) for each in shown])


def figure(value):
    """A number in a table."""
    if value is None:
        return "–"
    if isinstance(value, int) or float(value).is_integer():
        return f"{int(value):,}"
    return f"{value:,.0f}" if abs(value) >= 9999.5 else f"{value:.4g}"
