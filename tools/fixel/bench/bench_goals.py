# SPDX-License-Identifier: MIT
"""The project's goals (bench/goals.toml) beside what was measured."""

import pathlib
import tomllib

from fixel.bench import bench_rgb565, cycles
from fixel.base.errors import ToolError

GOALS = pathlib.Path(__file__).resolve().parents[3] / "bench" / "goals.toml"
OURS = "fixel"
SCREEN = 320 * 240   # pixels of each workload
CORES = {"rv32": "RV32IMC"}  # what is not its name in capitals


def _row(result, goal, renderer=OURS, core=None):
    """The row of a goal's workload; None where it was not measured."""
    for row in result["rows"]:
        if (row["workload"], row["renderer"], row["core"]) == (goal["workload"], renderer, core or goal["core"]):
            return row
    return None


def _frame(result, goal):
    row = _row(result, goal)
    return row and (row["frame"]["mean"], None)


def _variant(result, goal):
    """A mean frame of the library built otherwise, or with other memory."""
    for row in result["variants"]:
        if all(row[key] == goal[key] for key in ("variant", "workload", "core")):
            return row["frame"], f"{row['by_fixel']:.2f} times -O2 in one band"
    return None


def _worst_variant(result, goal):
    """The largest share that a variant takes of the library's frame as measured, of all scenes, and which it is."""
    return _worst_of({row["workload"]: row["by_fixel"] for row in result["variants"] if all(row[key] == goal[key] for key in ("variant", "core"))})


def _conversion(result, goal):
    """What a variant adds to a frame, for each pixel of the screen."""
    row, shown = _row(result, goal), _variant(result, goal)
    return row and shown and ((shown[0] - row["frame"]["mean"]) / SCREEN, None)


def _by_workload(result, goal):
    """A mean frame by that of another workload on the same core."""
    row, other = _row(result, goal), _row(result, {**goal, "workload": goal["other"]})
    return row and other and (row["frame"]["mean"] / other["frame"]["mean"],
                              f"{row['frame']['mean']:,} of {other['frame']['mean']:,}")


def _worst(result, goal):
    row = _row(result, goal)
    return row and (row["frame"]["max"] / row["frame"]["mean"], f"{row['frame']['max']:,} at worst")


def _share(result, goal):
    row, other = _row(result, goal), _row(result, goal, goal["renderer"], goal["renderer_core"])
    return row and other and (row["frame"]["mean"] / other["frame"]["mean"],
                              f"{row['frame']['mean']:,} of {other['frame']['mean']:,}")


def _worst_share(result, goal):
    """The largest share of another renderer's mean frame, of all scenes that both draw, and which it is."""
    rows = [row for row in result["rows"] if row["frame"]]
    others = {row["workload"]: row["frame"]["mean"] for row in rows
              if (row["renderer"], row["core"]) == (goal["renderer"], goal["renderer_core"])}
    shares = {row["workload"]: row["frame"]["mean"] / others[row["workload"]] for row in rows
              if (row["renderer"], row["core"]) == (OURS, goal["core"]) and row["workload"] in others}
    return _worst_of(shares)


def peer_frames(result, peer):
    """{workload: mean frame} of what stands beside a peer of the plan: a variant, or the library as measured."""
    if "variant" in peer:
        return {row["workload"]: row["frame"] for row in result["variants"]
                if (row["variant"], row["core"]) == (peer["variant"], peer["core"])}
    return {row["workload"]: row["frame"]["mean"] for row in result["rows"]
            if row["frame"] and (row["renderer"], row["core"]) == (OURS, peer["core"])}


def _worst_by_peer(result, goal):
    """The largest share of a peer's frame, of all scenes that both draw, and which it is."""
    (peer,) = [peer for peer in result["peers"] if peer["name"] == goal["peer"]]
    return _worst_of({name: frame / peer["frames"][name] for name, frame in peer_frames(result, peer).items()
                      if name in peer["frames"]})


def _worst_of(shares):
    if not shares:
        return None
    ordered = sorted(shares, key=shares.get, reverse=True)
    return shares[ordered[0]], ", ".join(f"{name} {shares[name]:.3f}" for name in ordered[:4])


def _unit(result, goal):
    row = _row(result, goal)
    return row and (row["per_unit"], None)


def _against(result, goal):
    """The largest ratio of a core's figure to another's, and whose it is."""
    ours = {(row["core"], row["workload"]): row["per_unit"] for row in result["rows"] if row["renderer"] == OURS}
    ratios = [(number / ours[goal["other"], workload], workload) for (core, workload), number in ours.items()
              if core == goal["core"] and (goal["other"], workload) in ours]
    if not ratios:
        return None
    slower = sorted((pair for pair in ratios if pair[0] > goal["most"]), reverse=True)
    return max(ratios)[0], ", ".join(f"{name} {ratio:.3f}" for ratio, name in slower[:4]) or max(ratios)[1]


def place_of(axis):
    """What grows along an axis: the key of a row."""
    return next((key for key in ("pixels", "faces") if axis.startswith(key)), "objects")


def _growth(result, goal):
    """The slope of the last step by that of the first: 1 is a straight line, less grows more slowly."""
    places = place_of(goal["axis"])
    points = [(row[places], row["instructions"]) for row in result["growth"] if row["axis"] == goal["axis"]]
    if len(points) < 3:
        return None
    slopes = [(new[1] - old[1]) / (new[0] - old[0]) for old, new in zip(points, points[1:])]
    return slopes[-1] / slopes[0], f"{slopes[0]:,.2f}, then {slopes[-1]:,.2f} for each {places[:-1]} more"


def _with_cycles(row, model):
    """How a frame was made, and an ESTIMATE of its cycles on a model, if its core has one."""
    return "; ".join([row["way"], *[f"{each:,} cycles {name}" for each, name in zip(row["cycles"].get(model, ()), cycles.FIGURES)]])


def _rgb565(result, goal):
    """A whole frame in the way that takes the fewest instructions."""
    row = bench_rgb565.best(result, goal["workload"], goal["core"])
    return row and (row["frame"], _with_cycles(row, next(iter(row["cycles"]), None)))


def _rgb565_cycles(result, goal):
    """Cycles of the same frame without wait states."""
    row = bench_rgb565.best(result, goal["workload"], goal["core"])
    return row and (row["cycles"][goal["model"]][0], _with_cycles(row, goal["model"]))


def _cycles(result, goal):
    """Cycles of a frame of palette indices without wait states."""
    for row in result["cycles_estimate"]:
        if all(row[key] == goal[key] for key in ("workload", "core", "model")):
            return row["cycles"][0], f"{row['cycles'][1]:,} {cycles.FIGURES[1]}"
    return None


def _budget(result, goal):
    """What a step costs; the goal has the budget's name."""
    figure = result["budgets"].get(goal["name"])
    return None if figure is None else (figure, None)


def _program(result, goal):
    """Bytes of the library that a program links."""
    size = result.get("programs", {}).get(goal["program"])
    return size and (size["flash"], None)


def _other_kernels(result, _):
    """How many programs link kernels of pixels that they do not draw, and which."""
    found = [f"{name}: {', '.join(size['of_other_pixels'])}" for name, size in result.get("programs", {}).items() if size["of_other_pixels"]]
    return (len(found), "; ".join(found) or None) if result.get("programs") else None


def _faces(result, goal):
    """The largest share that faces of a size take of what they take without the way of tiny faces, and which it is."""
    return _worst_of({f"{row['radius']:g}": row["frame"] / row["without"] for row in result["faces"] if row["core"] == goal["core"] and row["without"]})


def _rgb565_variants(result, goal):
    """The largest share of variants of a workload's goal, and whose it is; None where none was drawn."""
    shares = {}
    for workload, most in result["rgb565_goals"].items():
        for variant in goal["variants"]:
            row = bench_rgb565.best(result, bench_rgb565.named(workload, variant), goal["core"])
            if row:
                shares[row["workload"]] = row["frame"] / most / bench_rgb565.pixels_of(variant)
    return _worst_of(shares)


def _size(result, goal):
    for size in result["sizes"]:
        if (size["core"], size["renderer"], size["flags"]) == (goal["core"], OURS, goal["flags"]):
            return size
    return None


def _code(result, goal):
    size = _size(result, goal)
    return size and (size["code"] + size["constants"], f"and {size['run_time']:,} of run-time library")


def _helpers(result, goal):
    size = _size(result, goal)
    return size and (len(size["helpers"]), ", ".join(size["helpers"]) or None)


def _stack(result, goal):
    rows = [(row["stack_bytes"], row["workload"]) for row in result["rows"]
            if row["renderer"] == OURS and row["core"] == goal["core"] and row["stack_bytes"] is not None
            and row["workload"] not in goal["but"]]
    return max(rows) if rows else None


def _ram(result, goal):
    row = _row(result, goal)
    return row and (row["ram_bytes"], None)


def _renderer(result, goal):
    size = result["renderer_bytes"].get(goal["core"])
    return size and (size, None)


FIGURES = {"frame": _frame, "variant": _variant, "worst variant": _worst_variant, "conversion": _conversion, "by workload": _by_workload, "worst": _worst, "share": _share, "worst share": _worst_share,
           "worst by peer": _worst_by_peer, "unit": _unit, "against": _against, "growth": _growth, "rgb565": _rgb565, "rgb565 cycles": _rgb565_cycles, "rgb565 variants": _rgb565_variants, "faces": _faces,
           "cycles": _cycles, "budget": _budget, "program": _program, "other kernels": _other_kernels, "code": _code,
           "helpers": _helpers, "stack": _stack, "ram": _ram, "renderer": _renderer}


def _of_frames(entry):
    """The goals of an entry of [[frames]]: a whole frame, and its cycles on an M4 where the entry has them."""
    frame = {"figure": "rgb565", "core": bench_rgb565.CORE, "model": "cortex-m4", **entry}
    core = CORES.get(frame["core"], frame["core"].upper())
    yield {**frame, "name": f"{frame['workload']} to RGB565, a frame, {core}"}
    if "cycles" in entry:
        yield {**frame, "name": f"{frame['workload']} to RGB565, ESTIMATE of cycles, M4", "figure": "rgb565 cycles", "most": entry["cycles"], "beside": None}


def read(path=GOALS):
    """All goals of a file; those of [[frames]] come last."""
    with open(path, "rb") as file:
        data = tomllib.load(file)
    return [*data["goals"], *(goal for entry in data.get("frames", ()) for goal in _of_frames(entry))]


def measure(result, path=GOALS):
    """[{goal, most, figure, met, note, beside, account}]: figure and met are None where a goal was not
    measured, say for want of a board."""
    goals = read(path)
    result = {**result, "rgb565_goals": {goal["workload"]: goal["most"] for goal in goals
                                         if goal["figure"] == "rgb565" and goal["core"] == bench_rgb565.CORE}}
    rows = []
    for goal in goals:
        if goal["figure"] not in FIGURES:
            raise ToolError(f"{path}: '{goal['figure']}' is no figure; there are: {', '.join(FIGURES)}")
        figure, note = FIGURES[goal["figure"]](result, goal) or (None, None)
        if figure is None and goal["figure"] == "rgb565 variants":
            continue
        rows.append({"goal": goal["name"], "most": goal["most"],
                     "figure": round(figure, 4) if isinstance(figure, float) else figure,
                     "met": None if figure is None else figure <= goal["most"], "note": note,
                     "beside": goal.get("beside"), "account": goal.get("account")})
    return rows
