# SPDX-License-Identifier: MIT
"""The error report: how far fixed point lies from double, stage by stage and pixel by pixel.

Writes report.json and report.html (one self-contained page). Exit: 0 if every
pixel that differs is explained, the third judge agrees and no stage leaves its
bound; 1 if not; 2 if the report could not be made.
"""

import argparse
import base64
import pathlib
import sys
import tempfile

import jinja2
from PIL import Image

import run as run_tool
from fixel import dump, firmware, output, picture, plots
from fixel.errors import run_main
from fixel.programs import HostPrograms
from fixel.progress import Progress
from fixel.table import coloured, table

PATTERNS = ["report.html", "report.json"]
TEMPLATES = pathlib.Path(__file__).resolve().parent / "templates"
STAGES = ("clip", "transform", "project", "fill")
SAMPLES = 200_000       # of random input
SEED = 1
RAY_FRAMES = 12         # about how many frames the third judge looks at


def gather(options, work):
    """Everything measured: the report as a dictionary, and the two dumps."""
    programs = HostPrograms(options.build)
    image = run_tool.make_scene_image(options.scene, work, options.frames)
    file, _ = run_tool.walk(firmware.HOST, options.build, image, work, options.frames)
    with Progress("judging against double"):
        verdict = programs.judge(image, file, work / "judge.json", work / "double.fxld")
    drawn, twin = dump.read_dump(file), dump.read_dump(work / "double.fxld")
    run_tool.check_verdict(verdict, drawn, twin)
    every = options.every or max(1, len(drawn.frames) // RAY_FRAMES)
    with Progress(f"casting rays for every {every}. frame" if every > 1 else "casting rays"):
        third = programs.raycast(image, work / "double.fxld", work / "rays.json", every)
    with Progress(f"measuring stages on {options.samples:,} random samples and the scene"):
        stages = programs.stage_errors(image, options.samples, SEED)
    report = {"scene": options.scene, "board": firmware.HOST,
              "width": drawn.width, "height": drawn.height,
              "distance": verdict["distance"], "pixels": verdict["pixels"],
              "pixels_differing": verdict["pixels_differing"],
              "pixels_unexplained": verdict["pixels_unexplained"],
              "max_edge_distance_px": verdict["max_edge_distance_px"],
              "seed": SEED, "stages": stages, "frames": verdict["frames"],
              "walk": verdict["walk"], "third_judge": third}
    return report, drawn, twin


def stage_rows(stages):
    """The stages in the order of a frame, scene before random; with what left its bound."""
    order = {name: number for number, name in enumerate(STAGES)}
    rows = sorted(stages, key=lambda row: (order.get(row["stage"], len(order)), row["input"] != "scene"))
    return [{**row, "outside": row.get("beyond_bound", 0) + row.get("mismatched", 0)} for row in rows]


def histogram_plots(rows):
    """One plot a stage with both inputs."""
    result = []
    for stage in dict.fromkeys(row["stage"] for row in rows):
        both = [row for row in rows if row["stage"] == stage]
        caption = "; ".join(f"{word}: {both[0][key]}" for word, key in
                            (("measured", "measure"), ("allowed", "bound")) if key in both[0])
        result.append({"stage": stage, "caption": caption,
                       "svg": plots.histogram(stage, both, both[0]["unit"], f"errors-{stage}")})
    return result


def _embedded(colours, caption):
    return {"caption": caption,
            "png": base64.b64encode(picture.png_bytes(Image.fromarray(colours))).decode()}


def worst_frame(report, drawn, twin):
    """The frame that differs most: fixed, double, difference; whole and enlarged."""
    worst = max(report["frames"], key=lambda frame: (frame["pixels_differing"], -frame["frame"]))
    frame, other = drawn.frames[worst["frame"]], twin.frames[worst["frame"]]
    differs = frame.pixels != other.pixels
    fixed = picture.as_rgb(frame.pixels, drawn.palette)
    double = picture.as_rgb(other.pixels, twin.palette)
    shown = [(fixed, "fixed point, 16.16"), (double, "double"),
             (picture.difference_panel(fixed, differs), "difference")]
    ringed = picture.difference_panel(fixed, differs, picture.RING_DISTANCE)
    panels = [[_embedded(colours, caption) for colours, caption in (*shown[:2], (ringed, "difference"))]]
    y0, y1, x0, x1 = picture.differing_region(differs)
    if differs.any():
        panels.append([_embedded(colours[y0:y1, x0:x1], f"{caption}, enlarged")
                       for colours, caption in shown])
    return {"frame": worst["frame"], "differing": worst["pixels_differing"], "panels": panels,
            "columns": f"{x0} to {x1 - 1}", "rows": f"{y0} to {y1 - 1}"}


def distance_text(distance):
    """1/64 rather than 0.015625."""
    return f"1/{round(1 / distance)}" if distance and (1 / distance).is_integer() else f"{distance:g}"


def render(report, drawn, twin):
    """The page."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True)
    rows = stage_rows(report["stages"])
    walk = {**{key: report[key] for key in ("width", "height", "pixels", "pixels_differing",
                                            "pixels_unexplained", "max_edge_distance_px")},
            "frames": len(report["frames"]), "distance": distance_text(report["distance"]),
            "one_in": report["pixels"] // report["pixels_differing"] if report["pixels_differing"] else 0}
    return environment.get_template("report.html").render(
        scene=report["scene"], walk=walk, stages=rows, third=report["third_judge"],
        project_max=max((row["max"] for row in rows if row["stage"] == "project"), default=0.0),
        histograms=histogram_plots(rows), per_frame_svg=plots.per_frame(report["frames"], "per-frame"),
        worst=worst_frame(report, drawn, twin))


def complaints(report):
    """What is not as it should be, in sentences."""
    found = []
    if report["pixels_unexplained"]:
        found.append(f"{report['pixels_unexplained']} pixels differ from double without an edge near")
    if report["third_judge"]["pixels_unexplained"]:
        found.append(f"the third judge disagrees with the twin on "
                     f"{report['third_judge']['pixels_unexplained']} pixels")
    found += [f"{row['stage']} on {row['input']} input leaves its bound {row['outside']} times"
              for row in stage_rows(report["stages"]) if row["outside"]]
    return found


def print_report(report, out):
    """For people."""
    print(table([[row["stage"], row["input"], row["samples"], float(row["mean"]), float(row["max"]),
                  row["unit"]] for row in stage_rows(report["stages"])],
                ["stage", "input", "samples", "mean", "largest", "unit"]))
    third = report["third_judge"]
    print(f"{report['pixels_differing']:,} of {report['pixels']:,} pixels differ from double, "
          f"{report['pixels_unexplained']:,} unexplained; third judge: {third['frames_judged']} frames, "
          f"{third['pixels_unexplained']:,} unexplained")
    for sentence in complaints(report):
        print(f"{coloured('FAIL', 'red')}: {sentence}")
    print(f"report: {out}/report.html")


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scene", required=True, help="a .toml, an .obj, or a scene image (.fxls)")
    parser.add_argument("--frames", help="how many frames; the whole path without")
    parser.add_argument("--samples", type=int, default=SAMPLES, help="random samples a stage")
    parser.add_argument("--every", type=int, default=0, help="rays for every so-manieth frame")
    parser.add_argument("--out", default="build/report")
    parser.add_argument("--build", default="build", help="where make builds")
    options = parser.parse_args(argv)
    options.frames = run_tool.frame_count(options.frames) if options.frames is not None else None
    with output.replaced_folder(options.out, PATTERNS) as folder, \
            tempfile.TemporaryDirectory(prefix=".report-", dir=options.build) as work:
        report, drawn, twin = gather(options, pathlib.Path(work))
        print("writing the page", file=sys.stderr)
        output.write_json(folder / "report.json", report)
        output.write_file(folder / "report.html", render(report, drawn, twin))
    print_report(report, options.out)
    return 1 if complaints(report) else 0


if __name__ == "__main__":
    run_main(main)
