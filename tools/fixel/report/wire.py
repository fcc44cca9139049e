# SPDX-License-Identifier: MIT
"""Draws a scene's path as wireframes on this machine, and compares them with double."""

import argparse

from fixel.base import bounded, kept, output, scratch
from fixel.base.errors import one_line
from fixel.base.progress import Progress, steps
from fixel.commands import late
from fixel.scene import scene_options

picture = late("fixel.base", "picture")
dump, programs = late("fixel.board", "dump programs")
making = late("fixel.scene", "making")

PATTERNS = [*output.numbered("frame_", ".png"), "walk.gif", "summary.json"]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    scene_options.add(made, targets=False, looks=False)
    made.add_argument("--out", default="build/wire", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


def passes(summary):
    """Whether both line clippers and the reference renderer agree, except in explained pixels."""
    return summary["pixels_disagreeing"] == 0 and summary["pixels_unexplained"] == 0


def run(options, folder):
    """Draws and compares; the pictures go into folder. The summary."""
    output.make_folder(options.build)
    with scratch.folder("wire", options.build) as work:
        image = making.make_scene_image(options.scene, work, options.frames, options.screen, bounded.limits_of(options))
        with Progress("drawing wireframes, and judging them against double"):
            store = kept.Kept(options.build, options.fresh)
            found = programs.HostPrograms(options.build, store).wire(image, work / "wire.fxld", work / "wire.json", options.frames)
        drawn = dump.read_dump(work / "wire.fxld")
    for frame in steps("writing pictures", drawn.frames):
        picture.palette_image(frame.pixels, drawn.palette).save(folder / f"frame_{frame.number:04d}.png")
    (folder / "walk.gif").write_bytes(
        picture.animation_bytes([frame.pixels for frame in drawn.frames], drawn.palette))
    return {"scene": options.scene, "kept": store.parts, **found}


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    scene_options.check(options)
    with output.replaced_folder(options.out, PATTERNS) as folder:
        summary = run(options, folder)
        output.write_json(folder / "summary.json", summary)
    print(f"lines drawn            {summary['lines']:,} in {summary['frames']} frames, "
          f"{summary['clipped']:,} of them cut")
    print(f"intersections          {summary['intersections_by_planes']:,} plane by plane, "
          f"{summary['intersections_by_codes']:,} by outcodes")
    print(f"differ from double     {summary['pixels_differing']:,} of {summary['pixels_drawn']:,} pixels drawn")
    print(f"unexplained            {summary['pixels_unexplained']}")
    print(f"{'pass' if passes(summary) else 'FAIL'}: {one_line(options.out)}")
    return 0 if passes(summary) else 1
