# SPDX-License-Identifier: MIT
"""The tables of make bench: for a terminal, for its report (bench.md), for docs/performance.md and docs/faces.md."""

import pathlib
import re

from fixel.bench import bench_faces, bench_goals, bench_rgb565, cycles, places
from fixel.bench.bench_plan import NAMES
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table
from fixel.check import equality

SMALL = 0.005   # of a frame: a function with less is among the others
TEMPLATE = pathlib.Path(__file__).resolve().parents[2] / "templates" / "bench.md"
MARK = "<!-- bench: {} -->"


def _rows(result, **wanted):
    return [row for row in result["rows"] if all(row[key] == value for key, value in wanted.items())]


def _one(result, **wanted):
    found = _rows(result, **wanted)
    return found[0] if found else None


def _number(value, digits=None):
    if value is None:
        return "-"
    if isinstance(value, int):
        return f"{value:,}"
    if digits is None:
        digits = 0 if value >= 1000 else 1 if value >= 10 else 2 if value >= 1 else 3
    return f"{value:,.{digits}f}"


def markdown_table(header, rows, left=(0,)):
    """The columns of `left` left, of numbers right."""
    ruler = ["---" if place in left else "---:" for place in range(len(header))]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, ruler, *rows])


def terminal(plan, result):
    """What make bench prints."""
    header = ["workload", "renderer", "core", "a frame", "least", "most", "per unit", "unit", "of double",
              "of limit", "flash", "RAM", "stack"]
    frames = [[row["workload"], row["renderer"], row["core"], row["frame"]["mean"], row["frame"]["min"],
               row["frame"]["max"], _short(row["per_unit"]), row["unit"], row["ratio_to_listing_double"],
               row["ratio_to_limit"], row["text_bytes"], row["ram_bytes"], row["stack_bytes"]]
              for row in result["rows"] if row["frame"]]
    cores = result["cores"]
    return "\n\n".join([table(frames, header),
                        table([[name, unit, *map(_short, figures)] for name, unit, *figures in _kernel_cells(plan, result)],
                              ["kernel", "unit", *cores]),
                        table(_growth_cells(result), ["growth", "times", "instances", "faces", "pixels",
                                                      "a frame", "times"])
                        if result["growth"] else "",
                        table(bench_rgb565.cells(result), bench_rgb565.HEADER) if result["rgb565"] else "",
                        goals_terminal(result)]).rstrip()


MET = {True: ("met", "green"), False: ("NOT MET", "red"), None: ("not measured", "yellow")}


def goals_terminal(result):
    """Each goal beside its figure, and how many are met."""
    goals = result["goals"]
    text = table([[goal["goal"], _goal_number(goal["figure"]), _goal_number(goal["most"]), MET[goal["met"]][0],
                   goal["note"] or ""] for goal in goals], ["goal", "measured", "at most", "", ""])
    for word, colour in MET.values():
        text = text.replace(f"  {word}", f"  {coloured(word, colour)}")
    return f"{text}\n{sum(goal['met'] is True for goal in goals)} of {len(goals)} goals met"


def _goal_number(value):
    """A figure of a goal: counts whole, ratios to three places."""
    if value is None or isinstance(value, int):
        return _number(value)
    return f"{value:,.0f}" if value >= 1000 else f"{value:.1f}" if value >= 10 else f"{value:.3f}"


def goals_markdown(_, result):
    """Each goal beside its figure; what is not met is accounted for."""
    rows = [[goal["goal"], _goal_number(goal["most"]), f"**{_goal_number(goal['figure'])}**", MET[goal["met"]][0].lower(),
             goal["note"] or "", goal["beside"] or ""] for goal in result["goals"]]
    text = markdown_table(["goal", "at most", "measured", "", "", "others"], rows, left=(0, 3, 4, 5))
    accounts = [f"- {goal['goal']}: {goal['account']}" for goal in result["goals"]
                if goal["met"] is False and goal["account"]]
    return "\n\n".join([text, "\n".join(accounts)]).rstrip()


def _short(value):
    """A figure for the terminal: whole where it is large."""
    return round(value) if value >= 1000 else round(value, 3 if value < 10 else 1)


def _kernel_cells(plan, result):
    cells = []
    for name, entry in plan.kernels.items():
        figures = [row["per_unit"] for core in result["cores"]
                   for row in [*_rows(result, workload=name, core=core),
                               *[limit for limit in result["limits"]
                                 if limit["name"] == name and limit["core"] == core]]]
        cells.append([name, entry["unit"], *figures])
    return cells


def _growth_cells(result):
    cells, first = [], {}
    for row in result["growth"]:
        first.setdefault(row["axis"], row["instructions"])
        cells.append([row["axis"], row["factor"], row["objects"], row["faces"], row["pixels"],
                      row["instructions"], round(row["instructions"] / first[row["axis"]], 2)])
    return cells


def frames_markdown(plan, result):
    """Instructions a frame, mean (worst)."""
    cores = [*result["cores"], *result["extra_cores"]]
    header = ["scene", "renderer", *[NAMES[core] for core in cores]]
    rows = []
    for workload in plan.workloads:
        for renderer in plan.renderers:
            found = [_one(result, workload=workload, renderer=renderer, core=core) for core in cores]
            if any(found):
                rows.append([workload, renderer, *[_frame_cell(row) for row in found]])
    return markdown_table(header, rows, left=(0, 1))


def _frame_cell(row):
    if row is None:
        return "-"
    frame = row["frame"]
    worst = f" ({frame['max']:,})" if frame["max"] != frame["min"] else ""
    return f"{frame['mean']:,}{worst}"


def ratios_markdown(plan, result):
    """Fixel's instructions for a unit, and divided by those of the listing."""
    header = ["scene", "unit", *[f"{NAMES[core]}: a unit, by double, by float" for core in result["cores"]]]
    rows = []
    for workload, entry in plan.workloads.items():
        if "by" in entry:
            continue
        cells = []
        for core in result["cores"]:
            ours = _one(result, workload=workload, renderer="fixel", core=core)
            single = _one(result, workload=workload, renderer="listing-float", core=core)
            cells.append(f"{_number(ours['per_unit'])}, {_number(ours['ratio_to_listing_double'], 2)}, "
                         f"{_number(ours['instructions'] / single['instructions'], 2)}")
        rows.append([workload, entry["unit"], *cells])
    return markdown_table(header, rows)


def range_markdown(plan, result):
    """How many times Fixel's instructions the listing takes: the least and the most of all scenes."""
    rows = []
    for renderer in plan.renderers:
        cells = [_times(result, renderer, core, plan.workloads) for core in result["cores"]]
        if renderer not in ("fixel", "memset") and any(cells):
            rows.append([renderer, *[_range_cell(times) for times in cells]])
    return markdown_table(["times Fixel's instructions", *[NAMES[core] for core in result["cores"]]], rows)


def _times(result, renderer, core, workloads):
    """{workload: times} of what both draw."""
    found = {}
    for workload in workloads:
        ours, other = (_one(result, workload=workload, renderer=each, core=core) for each in ("fixel", renderer))
        if ours and other:
            found[workload] = other["instructions"] / ours["instructions"]
    return found


def _range_cell(times):
    if not times:
        return "-"
    least, most = min(times, key=times.get), max(times, key=times.get)
    return f"{_times_text(times[least])} ({least}) to {_times_text(times[most])} ({most})"


def _times_text(times):
    """To the hundredth where it tells which of two is faster."""
    return f"{times:.2f}" if times < 2 else f"{times:.1f}"


def peers_markdown(plan, result):
    """Other renderers' frames, and how many times Fixel's they are."""
    return _peers(plan, result, [peer for peer in result["peers"] if "variant" not in peer], "Fixel")


def smallpeers_markdown(plan, result):
    """The same beside the small library."""
    return _peers(plan, result, [peer for peer in result["peers"] if peer.get("variant") == "small"],
                  "Fixel, -Os -DFXL_SMALL")


def _peers(plan, result, peers, name):
    ours = [bench_goals.peer_frames(result, peer) for peer in peers]
    times = [{each: peer["frames"][each] / frames[each] for each in frames if each in peer["frames"]}
             for peer, frames in zip(peers, ours)]
    rows = [[each, _number(ours[0].get(each)),
             *[f"{peer['frames'][each]:,} ({_times_text(by[each])})" if each in by else "-" for peer, by in zip(peers, times)]]
            for each in plan.workloads if any(each in by for by in times)]
    rows.append(["times Fixel's", "", *map(_range_cell, times)])
    header = ["a frame", f"{name}, {NAMES[peers[0]['core']]}",
              *[f"{peer['name']}, {NAMES[peer['core']]}" for peer in peers]]
    return markdown_table(header, rows)


def kernels_markdown(plan, result):
    """Instructions of one unit of each kernel."""
    header = ["kernel", "what it computes", "unit", *[NAMES[core] for core in result["cores"]]]
    rows = [[name, plan.kernels[name]["what"], unit, *map(_number, figures)]
            for name, unit, *figures in _kernel_cells(plan, result)]
    return markdown_table(header, rows, left=(0, 1, 2))


def sizes_markdown(plan, result):
    """Bytes of flash, stack and RAM of each renderer."""
    header = ["renderer", "bytes", "flags", *[NAMES[core] for core in result["cores"]]]
    rows = []
    for renderer in plan.renderers:
        for flags in dict.fromkeys(size["flags"] for size in result["sizes"]):
            sizes = {size["core"]: f"{size['code']:,} + {size['constants']:,} + {size['run_time']:,}" for size in result["sizes"]
                     if size["renderer"] == renderer and size["flags"] == flags}
            if sizes:
                rows.append([renderer, "flash", flags, *[sizes.get(core, "-") for core in result["cores"]]])
    for renderer in plan.renderers:
        drawn = [_one(result, workload="w1" if renderer != "memset" else "w2", renderer=renderer, core=core)
                 for core in result["cores"]]
        if not drawn or None in drawn:
            continue
        rows.append([renderer, f"stack, {drawn[0]['workload']}", "-O2", *[_number(row["stack_bytes"]) for row in drawn]])
        rows.append([renderer, f"RAM, {drawn[0]['workload']}", "-O2", *[_number(row["ram_bytes"]) for row in drawn]])
        if renderer == "fixel":
            rows.append([renderer, "RAM, a renderer alone", "-O2",
                         *[_number(result["renderer_bytes"][core]) for core in result["cores"]]])
    return markdown_table(header, rows, left=(0, 1, 2))


def files_markdown(_, result):
    """Bytes of the library's files as the linker took them, by -Os -DFXL_SMALL."""
    sizes = {size["core"]: size["files"] for size in result["sizes"]
             if (size["renderer"], size["flags"]) == ("fixel", "-Os -DFXL_SMALL")}
    names = sorted({name for files in sizes.values() for name in files},
                   key=lambda name: (-max(files.get(name, 0) for files in sizes.values()), name))
    rows = [[name, *[_number(files.get(name, 0)) for files in sizes.values()]] for name in names]
    rows.append(["all", *[_number(sum(files.values())) for files in sizes.values()]])
    return markdown_table(["bytes, -Os -DFXL_SMALL", *[NAMES[core] for core in sizes]], rows)


def variants_markdown(plan, result):
    """Instructions a frame of the library built otherwise, or in bands, and the factor to what is measured above."""
    found = {(row["core"], row["workload"], row["variant"]): row for row in result["variants"]}
    cores = list(dict.fromkeys(core for core, _, _ in found))
    header = ["scene", "core", "`-O2`", *[entry["what"] for entry in plan.variants.values()]]
    as_measured = {(row["core"], row["workload"]): row["fixel"] for row in result["variants"]}
    rows = [[workload, NAMES[core], _number(as_measured[core, workload]),
             *[_variant_cell(found.get((core, workload, name))) for name in plan.variants]]
            for core in cores for workload in (*plan.workloads, *plan.rgb565) if (core, workload) in as_measured]
    return markdown_table(header, rows, left=(0, 1)) if rows else "Not measured."


def _variant_cell(row):
    return f"{row['frame']:,} ({row['by_fixel']:.2f})" if row else "-"


def stages_markdown(_, result):
    """Where the instructions of a mean frame go."""
    pipeline = places.Stages()
    columns = list(dict.fromkeys((row["core"], row["workload"]) for row in result["stages"]))
    shares = {(row["core"], row["workload"], row["stage"]): row["instructions"] / row["frames"]
              for row in result["stages"]}
    whole = {column: sum(number for (core, workload, _), number in shares.items() if (core, workload) == column)
             for column in columns}
    names = places.in_order(pipeline, {row["stage"] for row in result["stages"]})
    rows = [[name, pipeline.what.get(name, ""),
             *[_share(shares.get((*column, name), 0), whole[column]) for column in columns]] for name in names]
    rows.append(["a frame", "", *[f"{round(whole[column]):,}" for column in columns]])
    return markdown_table(["stage", "what", *[f"{workload}, {NAMES[core]}" for core, workload in columns]], rows,
                           left=(0, 1))


def functions_markdown(plan, result):
    """Every function's part of a mean frame of the first workload, by stage; small ones together."""
    core, workload = plan.stages["cores"][0], plan.stages["workloads"][0]
    stages = [row for row in result["stages"] if (row["core"], row["workload"]) == (core, workload)]
    whole = sum(row["instructions"] for row in stages)
    rows = []
    for row in stages:
        parts = [(name, number) for name, number in row["functions"].items() if number >= SMALL * whole]
        rest = row["instructions"] - sum(number for _, number in parts)
        parts += [("others", rest)] if rest else []
        rows += [[row["stage"] if not place else "", name, *_parts(number, whole, row["frames"])]
                 for place, (name, number) in enumerate(parts)]
    rows.append(["a frame", "", *_parts(whole, whole, stages[0]["frames"] if stages else 1)])
    return markdown_table(["stage", f"function, {workload}, {NAMES[core]}", "instructions a frame", "share"], rows,
                           left=(0, 1))


def _parts(number, whole, frames):
    return f"{number / frames:,.0f}", f"{100 * number / whole:.1f} %" if whole else "-"


def _share(part, whole):
    return f"{round(part):,} ({100 * part / whole:.1f} %)"


def estimates_markdown(_, result):
    """An ESTIMATE of cycles of a mean frame."""
    rows = [[f"{row['workload']}, code for {NAMES[row['core']]}", row["title"], *map(_number, row["cycles"])]
            for row in result["cycles_estimate"]]
    return markdown_table(["a frame", "on", *(f"ESTIMATE of cycles, {name}" for name in cycles.FIGURES)], rows, left=(0, 1))


def costs_markdown(_, __):
    """What an instruction costs in the ESTIMATE."""
    titles, kinds = cycles.costs()
    return markdown_table(["instruction", *titles],
                           [[kind, *map(_cost, costs)] for kind, costs in kinds.items()])


def _cost(cost):
    if cost is None:
        return "-"
    return f"{cost[0]} + {cost[1]} a register" if isinstance(cost, list) else f"{cost}"


def rgb565_markdown(_, result):
    """Whole frames as pixels of RGB565."""
    return markdown_table(bench_rgb565.HEADER, [[NAMES.get(cell, cell) if isinstance(cell, str) else _number(cell) for cell in row]
                                                for row in bench_rgb565.cells(result)], left=(0, 1, 2))


def faces_markdown(plan, result):
    """What a face of a size costs, beside its floor, and beside itself without the way of tiny faces on the cores that take that way."""
    if not result["faces"]:
        return "Not measured."
    first, *others = cores = list(dict.fromkeys(row["core"] for row in result["faces"]))
    header = ["a face", "radius", "pixels", NAMES[first], "floor", "times the floor",
              *[word for core in others for word in (NAMES[core], f"times {NAMES[first]}'s")],
              *[f"{NAMES[core]} without the tiny way" for core in _tiny_cores(result, cores)], *plan.faces["beside"]]
    return markdown_table(header, [_face_cells(plan, result, kind, radius, cores) for kind in plan.faces["kinds"] for radius in plan.faces["radii"]])


def _tiny_cores(result, cores):
    """The cores that draw tiny faces in a way of their own: without it a frame takes something else."""
    return [core for core in cores if any(row["core"] == core and row["without"] not in (None, row["frame"]) for row in result["faces"])]


def _face_cells(plan, result, kind, radius, cores):
    """Instructions of a face, of a frame of bench_faces.COUNT."""
    def a_face(frame):
        return frame / bench_faces.COUNT if frame else None
    rows = [bench_faces.of(result, kind["name"], radius, core) for core in cores]
    first, *others = [a_face(row["frame"]) for row in rows]
    without = [a_face(row["without"]) for row in rows if row["core"] in _tiny_cores(result, cores)]
    floor, place = bench_faces.floor_of(kind, radius), plan.faces["radii"].index(radius)
    beside = [a_face(frames[place]) if kind.get("tiny") else None for frames in plan.faces["beside"].values()]
    return [kind["name"], f"{radius:g}", _number(bench_faces.pixels_of(radius), 1), *(_number(each, 0) for each in (first, floor)),
            f"{first / floor:.2f}", *[word for each in others for word in (_number(each, 0), f"{each / first:.2f}")],
            *(_number(each, 0) for each in (*without, *beside))]


def growth_markdown(_, result):
    """How a frame grows."""
    if not result["growth"]:
        return "Not measured: no board stands for the core."
    header = ["", "times", "instances", "faces", "pixels", "instructions a frame", "times the first"]
    return markdown_table(header, [[row[0], *map(_number, row[1:])] for row in _growth_cells(result)])


def pictures_markdown(plan, result):
    """Pixels in which the listing differs from the library, in a million, and those that only one of both draws."""
    header = ["scene", "renderer", *[NAMES[core] for core in result["cores"]]]
    rows = []
    for workload in plan.workloads:
        for renderer in plan.renderers:
            found = [row for row in result["pictures"]
                     if row["workload"] == workload and row["renderer"] == renderer]
            if found:
                rows.append([workload, renderer,
                             *[f"{1e6 * row['differing'] / row['pixels']:,.1f} ({1e6 * row['uncovered'] / row['pixels']:,.1f})"
                               for row in found]])
    return markdown_table(header, rows, left=(0, 1))


def equality_markdown(_, __):
    """Random inputs on record for which each kernel on each core gave the same bits."""
    found = {key[:2]: inputs for key, inputs in equality.recorded(equality.RECORD).items()}
    cores = sorted({core for core, _ in found})
    cells = [[kernel, *[f"{found[core, kernel]:,}" if (core, kernel) in found else "" for core in cores]]
             for kernel in sorted({kernel for _, kernel in found})]
    return f"{markdown_table(['random inputs', *cores], cells)}\n\n{sum(found.values()):,} random inputs, of which none differs."


def tools_markdown(_, result):
    """Which tools gave these figures."""
    left = f" Left out, because no board has the core: {', '.join(result['left_out'])}." \
        if result["left_out"] else ""
    return f"Measured with `{result['compiler']}` and `{result['emulator']}`.{left}"


# What docs/performance.md and docs/faces.md have; the report has all.
FACES_PAGE = {"faces": faces_markdown}
DOCUMENT = {"tools": tools_markdown, "frames": frames_markdown, "range": range_markdown, "peers": peers_markdown,
            "smallpeers": smallpeers_markdown, "variants": variants_markdown, "rgb565": rgb565_markdown, "kernels": kernels_markdown, "sizes": sizes_markdown}
SECTIONS = {"tools": tools_markdown, "goals": goals_markdown, "frames": frames_markdown, "ratios": ratios_markdown,
            "range": range_markdown, "peers": peers_markdown, "smallpeers": smallpeers_markdown, "stages": stages_markdown, "functions": functions_markdown, "kernels": kernels_markdown,
            "sizes": sizes_markdown, "files": files_markdown, "variants": variants_markdown, "rgb565": rgb565_markdown,
            **FACES_PAGE, "equality": equality_markdown, "growth": growth_markdown,
            "pictures": pictures_markdown, "estimates": estimates_markdown, "costs": costs_markdown}


def report(plan, result):
    """The report of make bench: the template with all tables, without the marks."""
    text = replace_tables(TEMPLATE.read_text(encoding="utf-8"), plan, result, SECTIONS)
    return re.sub(f"{re.escape(MARK.split('{}', maxsplit=1)[0])}.*? -->\n", "", text)


def replace_tables(text, plan, result, sections):
    """A document with new tables: each section's function gives the text between the section's two marks."""
    for name, make in sections.items():
        begin, end = re.escape(MARK.format(name)), re.escape(MARK.format("end"))
        block = f"{MARK.format(name)}\n{make(plan, result)}\n{MARK.format('end')}"
        text, found = re.subn(f"{begin}\n.*?{end}", lambda _, new=block: new, text, flags=re.DOTALL)
        if found != 1:
            raise ToolError(f"the document has {found} places for the table '{name}'; it needs one")
    return text
