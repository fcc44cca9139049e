# SPDX-License-Identifier: MIT
"""Predicts flash, RAM, stack, instructions and cycles a frame of a scene on a board, before anything is built for the board.

Exit: 0 the board has room for the scene, 1 it has not, 2 there is no prediction.
"""

import argparse
import json
import os
import pathlib
import shlex
import sys

from fixel.base import bounded, children, output, scratch
from fixel.base.arguments import number
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted
from fixel.base.table import coloured, count_of, table
from fixel.board import room as rooms
from fixel.commands import late
from fixel.image import memory_needed
from fixel.model import suffixes
from fixel.scene import look, scene_options

badge, frame_costs, stage_costs = late("fixel.bench", "badge frame_costs stage_costs")
model_look, sent_bytes = late("fixel.board", "model_look sent_bytes")
image = late("fixel.image", "image")
making = late("fixel.scene", "making")

ROOT = pathlib.Path(__file__).resolve().parents[3]
COSTS = ROOT / "bench" / "costs.json"
SETTINGS_KEPT = ROOT / "bench" / "settings"     # a wheel has for each board what make says (tools/wheel)
# What make knows of a board, and what it is.
SETTINGS = {"band": "bytes of a band", "order": "entries of the order", "list": "bytes of the display list", "cache": "entries of the vertex cache"}
BAND_ROWS = 16          # of a program that export --c --program writes

# place pixel-format: what is counted (wide_...), and what it costs
# What a board's program may leave out: WALK_WITHOUT_... of its settings.
NOT_DRAWN = {"surfaces": "surfaces (VISIBILITY=surfaces builds a program that draws them)",
             "depth": "with a depth buffer (VISIBILITY=sorted builds a program that draws by distance)",
             "depth_32": "with a depth buffer of 32 bits (depth = 16 asks for one of 16)",
             "rgb565": "in RGB565",
             "billboards": "billboards", "orthographic": "with an orthographic lens",
             "lines": "edges, lines and points", "horizon": "a horizon"}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--core", default="", help="the compiler's flags for the board's core")
    scene_options.add(made, targets=False)
    for name, what in SETTINGS.items():
        made.add_argument(f"--{name}", type=int, help=f"{what} (default: the board's)")
    made.add_argument("--list-most", type=int, default=0, help="bytes that limit the display list alone")
    made.add_argument("--without", default="", metavar="NAME,...",
                      help="what the board's program leaves out: surfaces, depth, billboards")
    made.add_argument("--clock", type=number("CLOCK", 1, 10_000), metavar="MHZ", help="of the core (default: the board's)")
    made.add_argument("--badge", type=pathlib.Path, metavar="FILE", help="write the rate of drawing alone, or the instructions where no cycles are known, as a picture too (SVG)")
    made.add_argument("--json", help="write the prediction to this file too; - for the terminal, and nothing else")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def refuse_board(board):
    """Refuses a board of which there are no costs."""
    known = json.loads(COSTS.read_text(encoding="utf-8"))["boards"]
    if board not in known:
        raise ToolError(f"nothing can be predicted for board {board}: {COSTS.name} has no costs of its core, flags and program; "
                        f"the boards are: {', '.join(known)}. make run BOARD={board} draws there and says what it took")


def before(_):
    """Refuses the board of make."""
    refuse_board(os.environ.get("BOARD", scene_options.BOARD))


def complete(options):
    """Options that were not given are those of the board, as make hands them on."""
    lacking = [name for name in SETTINGS if getattr(options, name) is None]
    if not lacking:
        return
    refuse_board(options.board)
    kept = SETTINGS_KEPT / options.board
    said = kept.read_bytes() if kept.exists() else children.run(["make", "-n", "MAKE=:", "predict", f"BOARD={options.board}"], cwd=ROOT).stdout
    words = shlex.split(next((line for line in said.decode().replace("\\\n", " ").splitlines() if " make predict --board " in line), ""))
    if not words:
        raise ToolError(f"the settings of {options.board} are needed, which make knows in a checkout alone: give "
                        f"{', '.join(f'--{name} ({SETTINGS[name]})' for name in lacking)}, or run make predict BOARD={options.board} SCENE=...")
    known = parser().parse_args(words[words.index("predict") + 1:])
    for name in lacking:
        setattr(options, name, getattr(known, name))
    options.core = options.core or known.core
    options.clock = options.clock or known.clock
    options.list_most = options.list_most or known.list_most
    options.without = options.without or known.without


def by_depth(scene):
    """Whether a scene asks for a depth buffer."""
    return scene.depth_bits != 0


def has_looks(scene):
    """Whether a scene has more than flat colours by distance: then the stack goes deeper."""
    return bool(scene.surfaces or scene.light or scene.beams or scene.billboards or by_depth(scene) or scene.tree
                or scene.pixel_bits == 16)


def lines_of(scene):
    """How many lines and points the models of a scene have."""
    return sum(len(model.lines) for model in scene.models)


def board_of(options, known):
    """The board's entry of bench/costs.json, and the core whose costs it has."""
    core = frame_costs.core_of(options.core)
    if core is None or options.board not in known["boards"]:
        raise ToolError(f"{options.board}: {frame_costs.FILE.name} has no costs of its core and flags "
                        f"({' '.join(options.core.split()) or 'none'}); the boards are: {', '.join(known['boards'])}")
    return known["boards"][options.board], core


def count(options, scene, size, board, file):
    """frame_costs.count with the board's settings; NoRoom says what the board has no room for."""
    needed = memory_needed.draw_list_needed(scene)
    if size > board["scene_room"]:
        raise frame_costs.NoRoom(f"the scene image has {size:,} bytes, the board's scene partition {board['scene_room']:,}")
    if needed > options.order:
        raise frame_costs.NoRoom(f"the scene needs {needed:,} order entries, the board has {options.order:,}")
    wanted = {"surfaces": scene.surfaces, "depth": by_depth(scene), "depth_32": scene.depth_bits == 32,
              "rgb565": scene.pixel_bits == 16, "billboards": scene.billboards, "orthographic": scene.scale,
              "lines": lines_of(scene), "horizon": scene.horizon}
    for name in options.without.lower().split(","):
        if wanted.get(name):
            raise frame_costs.NoRoom(f"the board has no room to draw {NOT_DRAWN[name]}")
    return frame_costs.count(options.build, file, options.band, options.order, options.list, options.cache, options.list_most,
                       options.frames or 0, options.scene)


def parts(names, counts, table_of):
    """[(what, how many a frame, instructions a frame)], the most first."""
    means = counts.mean(axis=0)
    found = [(frame_costs.NAMES.get(name, name), mean, mean * table_of[name]) for name, mean in zip(names, means)]
    return sorted((each for each in found if each[2] > 0), key=lambda each: -each[2])


def timed(options, core, names, counts):
    """Instructions of each part of a mean frame, and cycles and rate where the board's core has a model of cycles, as plain data."""
    parts, model = stage_costs.instructions(core, names, counts), stage_costs.model_of(options.core)
    if parts is None:
        return {"stages": None, "cycles": None}
    found = {"stages": rounded(parts.mean(axis=0)), "cycles": None}
    if model:
        spent = parts * stage_costs.paces_of(model)
        total = spent.sum(axis=1)
        found["cycles"] = {"core": model, "min": round(total.min()), "mean": round(total.mean()), "max": round(total.max()), "stages": rounded(spent.mean(axis=0)),
                           "clock": options.clock, "frames_per_second": round(options.clock * 1e6 / total.mean(), 2) if options.clock else None}
    return found


def rounded(parts):
    """{part of a frame: a whole number}."""
    return {name: round(float(each)) for name, each in zip(stage_costs.PARTS, parts)}


def of_memory(options, file, costs):
    """What a program of the user's takes with each of the three sizes of an exported header, as plain data: bytes of the block for
    fxl_renderer_init, and instructions of a mean frame by fxl_render and in bands of BAND_ROWS rows."""
    scene, found = image.load(file), []
    row, beside = scene.width * scene.pixel_bits // 8, 2 * scene.width * scene.height * scene.depth_bits // 8
    for ending, size in memory_needed.SIZES.items():
        units = size(scene)
        vertices, words = memory_needed.divided(scene, units)
        ways = {}
        for way, rows, most in (("fxl_render", scene.height, 1), ("bands", BAND_ROWS, memory_needed.WORD * words or 1)):
            names, counts = frame_costs.count(options.build, file, rows * row, 0, frame_costs.BESIDE + beside + most, vertices, most,
                                              options.frames or 0, options.scene)
            ways[way] = round(float(frame_costs.instructions(costs, names, counts).mean()))
        found.append({"size": f"NAME_MEMORY{ending}", "bytes": memory_needed.UNIT * units, **ways})
    return found


def predict(options, file):
    """The prediction for a scene image, as plain data."""
    known = frame_costs.load()
    board, core = board_of(options, known)
    scene, size = image.load(file), pathlib.Path(file).stat().st_size
    result = {"board": options.board, "core": core, "scene": options.scene, "frames": scene.frames,
              "faces": sum(len(model.faces) for model in scene.models),
              "why_not": None, **frame_costs.memory(board, size, has_looks(scene)), "instructions_per_frame": None, "stages": None, "cycles": None,
              "ram_of_your_program": memory_needed.of_program(scene), "your_memory": [], "parts": [],
              **sent_bytes.told("", scene.width, scene.height, None)}
    try:
        names, counts = count(options, scene, size, board, file)
    except frame_costs.NoRoom as error:
        return {**result, "why_not": str(error)}
    taken = frame_costs.instructions(known["cores"][core], names, counts)
    result["frames"] = len(taken)
    result["instructions_per_frame"] = {"min": round(taken.min()), "mean": round(taken.mean()), "max": round(taken.max())}
    result.update(timed(options, core, names, counts))
    result["parts"] = [{"what": what, "times": round(float(times), 1), "instructions": round(float(spent))}
                       for what, times, spent in parts(names, counts, known["cores"][core])]
    result |= sent_bytes.told("", scene.width, scene.height, frame_costs.boxes(options.build, file, scene, options.frames or 0))
    result["your_memory"] = of_memory(options, file, known["cores"][core])
    return result


def cycle_rows(cycles):
    """What is said of the cycles of a frame."""
    if not cycles:
        return []
    rows = [["cycles a frame", f"{cycles['min']:,} to {cycles['max']:,}, mean {cycles['mean']:,}: by a model of a {cycles['core']}; no board was timed"]]
    if cycles["frames_per_second"]:
        rows.append(["", f"at {cycles['clock']} MHz {cycles['frames_per_second']:.1f} frames a second of drawing alone, by the model, code in RAM"])
    return rows


def print_prediction(result):
    """For people."""
    flash, ram, stack, taken = (result[key] for key in ("flash", "ram", "stack", "instructions_per_frame"))
    rows = [["board", f"{result['board']}, costs of core {result['core']}"],
            ["scene", f"{one_line(result['scene'])}, {count_of(result['frames'], 'frame')}"],
            ["flash", f"{flash['program']:,} program + {flash['scene']:,} scene = {flash['program'] + flash['scene']:,} of "
                      f"{flash['of']:,} bytes; the scene's part has {flash['scene_room']:,}, and a face takes "
                      f"{flash['scene'] / result['faces']:.0f}"],
            ["RAM of the walk", f"{ram['program']:,} of {ram['of']:,} bytes, with stacks"],
            ["RAM of your program", "renderer and memory {without_list:,} bytes without a display list; {moderate:,} with NAME_MEMORY "
                                    "of the exported header; {with_list:,} with a list of every polygon; and the pixels".format(
                                        **result["ram_of_your_program"])],
            ["stack", f"{stack['seen']:,} of {stack['reserved']:,} bytes"]]
    if taken:
        rows.append(["instructions a frame", f"{taken['min']:,} to {taken['max']:,}, mean {taken['mean']:,}"])
    rows += cycle_rows(result["cycles"])
    rows.append(sent_bytes.row(result))
    print(table(rows))
    if result["stages"]:
        cycles = result["cycles"]
        print(table([[name, each, *([cycles["stages"][name]] if cycles else [])] for name, each in result["stages"].items()],
                    ["part of a frame", "instructions", *(["cycles, by model"] if cycles else [])]))
    if result["parts"]:
        print(table([[part["what"], round(part["times"], None if part["times"] >= 100 else 1), part["instructions"]]
                     for part in result["parts"][:8]],
                    ["most of them for", "times a frame", "instructions"]))
    if result["your_memory"]:
        print(table([[each["size"], each["bytes"], each["fxl_render"], each["bands"]] for each in result["your_memory"]],
                    ["in a program of your own", "bytes", "instructions by fxl_render", f"in bands of {BAND_ROWS} rows"]))
    if result["why_not"]:
        print(f"{coloured('no room', 'red')}: {one_line(result['why_not'])}")


def room_of(options):
    """The room of a board's program, by the settings that it is built with."""
    board, core = board_of(options, frame_costs.load())
    without = set(options.without.lower().split(","))
    targets = {(bits, depth) for bits in (8, 16) for depth in (0, 16, 32)
               if not (bits == 16 and "rgb565" in without or depth and "depth" in without or depth == 32 and "depth_32" in without)}
    return model_look.Room(options.band, options.order, options.list, options.cache, board["scene_room"], options.list_most,
                           "surfaces" not in without, frozenset(targets), core, board["ram_size"])


def drawn_of(board, arguments, screen, asked, wanted):
    """The model_look.Drawn in which make run draws a bare model on a board. arguments: those of the command that names the model, its frames and
    the limits; screen: width and height or None, asked: a target.Target, wanted: a look.Asked."""
    options = parser().parse_args([f"--board={board}"])
    for name in ("scene", "frames", "cpu_limit", "memory_limit", "allow_outside"):
        setattr(options, name, getattr(arguments, name))
    options.screen, options.target, options.look = screen, asked, wanted
    elf = pathlib.Path(options.build) / "boards" / board / "walk.elf"
    if not elf.is_file():   # of a board that nothing was built for, make and bench/costs.json know the room
        _refuse_unknown(board, arguments.scene)
        complete(options)
    with scratch.folder("look") as folder:
        return model_look.drawn_for(options, model_look.room_of(elf) if elf.is_file() else room_of(options), options.build, folder)


def _refuse_unknown(board, scene):
    """Refuses a board of which neither a program nor costs are there."""
    boards = rooms.boards()
    if boards and board not in boards:
        raise ToolError(f"--board: there is no board {quoted(board)}; the boards are: {', '.join(boards)}")
    if boards and board not in frame_costs.load()["boards"]:
        raise ToolError(f"--board {board}: its room is that of its program, which is not built: make run BOARD={board} SCENE={shlex.quote(str(scene))} "
                        "builds it, and shows the model there")


def image_of(options, folder):
    """The scene image of --scene: of a bare model as the board draws it."""
    is_model = suffixes.is_model(options.scene)
    look.check(options.look, options.scene, is_model)
    if is_model:
        return model_look.choose(options, room_of(options), options.build, folder)
    return making.make_scene_image(options.scene, folder, options.frames, options.screen, bounded.limits_of(options))


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    scene_options.check(options)
    complete(options)
    output.make_folder(options.build)
    with scratch.folder("predict", options.build) as folder:
        result = predict(options, image_of(options, folder))
    if options.json == "-":
        print(json.dumps(result, indent=1))
    else:
        print_prediction(result)
        if options.json:
            output.write_json(options.json, result)
            print(f"JSON: {one_line(options.json)}", file=sys.stderr)
    if options.badge:
        output.write_file(options.badge, badge.of_prediction(result))
    return 1 if result["why_not"] else 0
