# SPDX-License-Identifier: MIT
"""Draws a scene's path on a board, and compares the frames with the host's and with double.

Exit: 0 the board's frames equal the host's byte for byte, and every pixel that differs from double is
explained; 1 not; 2 the run could not be made; 124 the program hung; 134 the core locked up; else the code
of the program that failed (boards/contract/system.h).
"""

import argparse
import pathlib
import shutil
import sys

from fixel.base import kept, output, scratch, spent
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import Progress, steps
from fixel.base.table import coloured, count_of, table
from fixel.board import counted, crc, methods
from fixel.commands import late
from fixel.scene import scene_options

picture = late("fixel.base", "picture")
frame_costs = late("fixel.bench", "frame_costs")
drawing, dump, emulator, firmware, host_programs = late("fixel.board", "drawing dump emulator firmware programs")
model_look, order_check, own_run, sent_bytes, spilled, wires = late("fixel.board", "model_look order_check own_run sent_bytes spilled wires")
image_header, scene_image = late("fixel.image", "image_header image")
close_faces = late("fixel.model", "close_faces")
numpy = late("numpy")

# The files of a result; the last one comes last and goes first, so that a folder with it is whole.
PATTERNS = [*output.numbered("frame_", ".png"), *output.numbered("diff_", ".png"), "walk.gif", "board.fxld", "double.fxld",
            "summary.json"]
RAYS_FRAMES_MAX = 120   # frames through whose pixels rays are cast: of a longer path every second, third ...
ORDER_ADVICE = """\
Where the order of drawing is wrong, a face that lies behind covers one that lies in front: board and double agree,
and the picture is not what one would see. Split large models into convex objects, set "layer", draw with a depth
buffer (DEPTH=16), or give the scene a tree:  tree = "all"  in the scene file, or of a model
tools/scene.py build MODEL -o scene.fxls --tree all; make run SCENE=scene.fxls  (docs/extras/bsp.md)"""


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    scene_options.add_board(made)
    scene_options.add(made)
    methods.add_options(made)
    made.add_argument("--whole-frames", action="store_true", help="with --board host: draw whole frames, not in its narrow bands")
    made.add_argument("--band-rows", type=int, help="the most rows of a band that the program was built with (default: what fits)")
    made.add_argument("--driver", help="a driver of a display, whose wires are recorded and read back")
    made.add_argument("--out", default="build/run", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


def walk(board, options, image, folder, name, record=None, part="board"):
    """The dump that a board leaves after a program has run, and the program. record: where the wires' is to be."""
    elf = methods.elf_of(board, options.build, name)
    program = firmware.load(elf, board)
    with Progress(f"drawing on {board} ({program.cpu})") as progress:
        return drawing.draw(options.kept, part, board, elf, image, folder, options.frames, progress=progress,
                            record=record), program


def frames_equal(a, b):
    """Whether two dumps hold the same pictures of the same poses, byte for byte."""
    return (a.width, a.height, len(a.frames)) == (b.width, b.height, len(b.frames)) \
        and numpy.array_equal(a.palette, b.palette) \
        and all(numpy.array_equal(one.pixels, other.pixels)
                and (one.position, one.angles) == (other.position, other.angles)
                for one, other in zip(a.frames, b.frames))


def polygon_totals(frames):
    """What became of the polygons, over all frames."""
    total = {name: sum(frame.counters[name] for frame in frames) for name in dump.COUNTERS}
    return {"in": total["in"],
            "culled": total["backfacing"] + total["outside"] + total["degenerate"],
            "clipped": total["clipped"], "refused": total["refused"], "drawn": total["drawn"],
            "spilled": total["spilled"]}


def check_verdict(verdict, drawn, twin):
    """The judge's counts against our own: two programs read these dumps."""
    ours = [int((one.pixels != other.pixels).sum()) for one, other in zip(drawn.frames, twin.frames)]
    theirs = [frame["pixels_differing"] for frame in verdict["frames"]]
    if ours != theirs or verdict["pixels_differing"] != sum(ours):
        raise ToolError("the judge counts other differing pixels than this tool does: "
                        f"{verdict['pixels_differing']} and {sum(ours)}; one of them has a bug", 1)


def names_told(options, scene):
    """As order_check.names_of says, of a program that shows surfaces or does not."""
    return order_check.names_of(scene, methods.shows_surfaces(options))


def count_wrong_order(programs, image, folder, frames, names):
    """What rays say of the order of drawing: pixels whose nearest face is another one than the frame shows,
    and of how many. names: as names_told says.

    None where the scene has billboards, which no ray knows.
    """
    if scene_image.load(image).billboards:
        return None, 0
    every = -(-frames // RAYS_FRAMES_MAX)
    verdict = programs.raycast(image, folder / ("names.fxld" if names else "double.fxld"), folder / "rays.json", every,
                               names)
    return verdict["pixels_unexplained"], verdict["pixels"]


def summarise(options, program, drawn, equal):
    """summary.json, but for what is judged."""
    return {"board": options.board, "cpu": program.cpu, "program": options.program, "scene": options.scene,
            "visibility": options.visibility, "clipper": options.clipper,
            "width": drawn.width, "height": drawn.height, "frames": len(drawn.frames),
            "pixels": len(drawn.frames) * drawn.width * drawn.height,
            "polygons": polygon_totals(drawn.frames),
            "frames_empty": sum(frame.counters["drawn"] == 0 for frame in drawn.frames),
            **counted.summary(drawn.frames, program),
            "frame_sha256": [frame.sha256 for frame in drawn.frames],
            "host_frames_equal": equal, "driver": options.driver}


def write_pictures(folder, drawn, twin):
    """Every frame, every difference, and the walk as an animation."""
    for frame, other in steps("writing pictures", list(zip(drawn.frames, twin.frames))):
        image = picture.palette_image(frame.pixels, drawn.palette)
        image.save(folder / f"frame_{frame.number:04d}.png")
        differs = frame.pixels != other.pixels
        if differs.any():
            sheet = picture.side_by_side(picture.as_rgb(frame.pixels, drawn.palette),
                                         picture.as_rgb(other.pixels, twin.palette), differs,
                                         ["16.16", "double"])
            sheet.save(folder / f"diff_{frame.number:04d}.png")
    (folder / "walk.gif").write_bytes(
        picture.animation_bytes([frame.pixels for frame in drawn.frames], drawn.palette))


def judged_rows(summary):
    """What double and rays said."""
    pixels, differing = summary["pixels"], summary["pixels_differing"]
    if differing is None:
        return [["differ from double", f"not judged: the program is {summary['program']}"]]
    distance = summary["max_edge_distance_px"]
    wrong, judged = summary["order_wrong_pixels"], summary["order_judged_pixels"]
    return [["differ from double", f"{differing:,} of {pixels:,} pixels "
                                   f"({100 * differing / pixels:.5f} %), worst frame "
                                   f"{summary['worst_frame_differing']:,}"],
            *([["by another texel", f"{summary['texel_pixels']:,}: of these, they show a texel beside double's, within the bound of "
                                    "texture coordinates"]] if summary["texel_pixels"] else []),
            ["unexplained", f"{summary['pixels_unexplained']:,}: of these, neither near an edge nor by another texel"],
            ["farthest from an edge", "-" if distance is None else f"{distance:.6f} pixel, of the others that differ"],
            ["wrong by the order", "not counted: the scene has billboards" if wrong is None else
             f"{wrong:,} of {judged:,} pixels ({100 * wrong / judged:.3f} %) show a face behind the nearest one"]]


def print_summary(summary, out):
    """A short table for people."""
    polygons = summary["polygons"]
    rows = [["board", f"{summary['board']} ({summary['cpu']})"],
            ["scene", f"{one_line(summary['scene'])}, {summary['width']}x{summary['height']}, "
                      f"{count_of(summary['frames'], 'frame')}"],
            *judged_rows(summary),
            ["polygons", ", ".join(f"{polygons[name]:,} {name}" for name in polygons)],
            counted.row(summary),
            ["equal to host", summary["host_frames_equal"]],
            ["CRC of all frames", crc.both(summary["frame_crc_all"], summary["sent_crc_all"])],
            sent_bytes.row(summary, unknown=summary["boxes_unknown"]),
            *wires.rows(summary),
            *([["kept", f"{', '.join(summary['kept'])}: computed by an earlier command (FRESH=1 computes all)"]]
              if summary["kept"] else [])]
    print(table(rows))
    good = passes(summary)
    empty = summary["frames_empty"]
    said = f" ({empty} of {summary['frames']} frames are empty: nothing was drawn in them)" if empty else ""
    if summary["order_wrong_pixels"]:
        print(ORDER_ADVICE)
    if summary["spilled_note"]:
        print(one_line(summary["spilled_note"]))
    print(f"{coloured('pass', 'green') if good else coloured('FAIL', 'red')}{said}: {one_line(out)}", flush=True)
    spent.tell()
    print(own_run.line_to_open(out))


def passes(summary):
    """Whether the run is what it should be."""
    return summary["host_frames_equal"] and not summary["pixels_unexplained"] \
        and summary["wires_frames_equal"] in (None, summary["frames"])


def judge(options, image, drawn, file, work):
    """What double and rays say of a dump: for summary.json, and the reference renderer's frames."""
    programs = host_programs.HostPrograms(options.build, options.kept)
    names = names_told(options, scene_image.load(image))
    with Progress("judging against double"):
        verdict = programs.judge(image, file, work / "judge.json", work / "double.fxld",
                                 methods.judge_options(options), work / "names.fxld" if names else None)
    twin = dump.read_dump(work / "double.fxld")
    check_verdict(verdict, drawn, twin)
    wrong, judged = count_wrong_order(programs, image, work, len(drawn.frames), names)
    return {"pixels_differing": verdict["pixels_differing"],
            "texel_pixels": verdict["texel_pixels"],
            "pixels_unexplained": verdict["pixels_unexplained"],
            "worst_frame_differing": max(frame["pixels_differing"] for frame in verdict["frames"]),
            "max_edge_distance_px": verdict["max_edge_distance_px"],
            "order_wrong_pixels": wrong, "order_judged_pixels": judged}, twin


# Of a program in which more moves than the eye: the reference renderer does not know what it draws.
UNJUDGED = dict.fromkeys(["pixels_differing", "texel_pixels", "pixels_unexplained", "worst_frame_differing",
                          "max_edge_distance_px", "order_wrong_pixels", "order_judged_pixels"])


def say_what_will_differ(image, options):
    """Notes about faces that a depth buffer cannot tell apart, if one draws, and about what an inset hides."""
    scene = scene_image.load(image)
    bits = methods.depth_bits(options, scene)
    for note in (close_faces.note(scene, bits) if bits else None, image_header.note_of_inset(scene)):
        if note:
            print(f"  {one_line(note)}", file=sys.stderr)


def boxes_of(options, image, drawn):
    """(The boxes of what changes from frame to frame, why they are not known). None and "" where there is nothing to say of them."""
    if options.program != methods.WALK or options.visibility or options.clipper or len(drawn.frames) < 2:
        return None, ""
    if sent_bytes.eye_moves(drawn.frames):
        return [[(0, drawn.width, 0, drawn.height)] for _ in drawn.frames], ""
    scene = scene_image.load(image)
    if not (pathlib.Path(options.build) / "host" / "predict").exists():
        return None, "make predict says what boxes of what changed would take"
    return frame_costs.boxes(options.build, image, scene, len(drawn.frames), sent_bytes.steps_of(options.driver)), ""


def run(options, folder):
    """The whole run; its files go into folder. The summary."""
    output.make_folder(options.build)
    with scratch.folder("run", options.build) as work:
        # QEMU may be missing: say so before the scene takes its time.
        name, elf = methods.program(options), methods.elf_of(options.board, options.build, methods.program_on_board(options))
        if options.board != firmware.HOST:
            emulator.find_qemu(firmware.load(elf, options.board).emulator)
        image = model_look.scene_image(options, elf, work)
        methods.check_scene(options, scene_image.load(image))
        say_what_will_differ(image, options)
        record = work / wires.NAME if options.driver else None
        if options.driver:
            scene = scene_image.load(image)
            wires.check_size(options.driver, scene.width, scene.height)
        file, program = walk(options.board, options, image, work, methods.program_on_board(options), record)
        drawn = dump.read_dump(file)
        if not drawn.frames:
            raise ToolError(f"{options.scene}: the path has no frames")
        twin_folder = work / "twin"
        twin_folder.mkdir()
        hosted, _ = walk(firmware.HOST, options, image, twin_folder, name, part="host") \
            if options.board != firmware.HOST or options.whole_frames else (file, program)
        equal = frames_equal(drawn, dump.read_dump(hosted))
        sent = wires.told(options.driver, record, drawn)
        verdicts, twin = UNJUDGED, drawn
        if options.program == methods.WALK:
            verdicts, twin = judge(options, image, drawn, file, work)
            shutil.move(work / "double.fxld", folder / "double.fxld")
        write_pictures(folder, drawn, twin)
        shutil.move(file, folder / "board.fxld")
        spills = spilled.note(options, elf, image, polygon_totals(drawn.frames)["spilled"])
        boxes, unknown = boxes_of(options, image, drawn)
    return summarise(options, program, drawn, equal) | sent | verdicts | {
        "kept": options.kept.parts, "spilled_note": spills, "boxes_unknown": unknown,
        **sent_bytes.told(options.driver, drawn.width, drawn.height, boxes)}


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    scene_options.check(options)
    methods.check(options)
    if options.whole_frames and (options.board != firmware.HOST or methods.program(options) != options.program):
        raise ToolError("--whole-frames is for --board host, without a choice of rows, driver, visibility method and clipper")
    if own_run.is_own(options):
        return own_run.command(options, PATTERNS)
    options.kept = kept.Kept(options.build, options.fresh)
    with output.replaced_folder(options.out, PATTERNS) as folder:
        summary = run(options, folder)
        output.write_json(folder / "summary.json", summary)
    print_summary(summary, options.out)
    return 0 if passes(summary) else 1
