# SPDX-License-Identifier: MIT
"""The comparison of clippers: for a terminal, as a page of its own with its plots, and as Markdown for docs/clipping.md."""

import pathlib

import jinja2
import matplotlib
from matplotlib.figure import Figure

from fixel.base.table import table
from fixel.bench import bench_page, clippers_run
from fixel.bench.bench_plan import NAMES
from fixel.report import report_page
from fixel.report.report_plots import as_svg, PIXEL, SOFT, STYLE

TEMPLATES = pathlib.Path(__file__).resolve().parents[2] / "templates"
DIFFERENCES = 8         # pictures of them in the page, at most
MILLION = 1_000_000
COLOURS = ("#0f6cbd", "#c77700", "#18794e", "#c2416b", "#6b4fbb", "#0e8a8a", "#8a6d1d", "#6b7785", "#b3123f")


def _first(rows, **wanted):
    for row in rows:
        if all(row[key] == value for key, value in wanted.items()):
            return row
    return None


def _kinds(rows):
    """[(clipper, hidden)] in the order of the rows."""
    return list(dict.fromkeys((row["clipper"], row["hidden"]) for row in rows))


def _values(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


def cost_cells(rows, core):
    """[[clipper, hidden, median of each scene.., most of all, flash, RAM in the first scene, stack]] of a core."""
    cells, scenes = [], _values(rows, "scene")
    for clipper, hidden in _kinds(rows):
        found = [_first(rows, clipper=clipper, hidden=hidden, scene=scene, board=core) for scene in scenes]
        there = [row for row in found if row]
        if there:
            cells.append([clipper, hidden, *[row and row["instructions"]["median"] for row in found],
                          max(row["instructions"]["max"] for row in there), there[0]["text_bytes"],
                          there[0]["ram_bytes"], max(row["stack_bytes"] for row in there)])
    return cells


def exact_cells(rows):
    """[[clipper, hidden, largest error, nearly parallel too, pixels that differ, of a million, farthest from an edge,
    unexplained, farthest on the screen, most vertices]] over all scenes, of one core."""
    cells, core = [], rows[0]["board"] if rows else None
    for clipper, hidden in _kinds(rows):
        found = [row for row in rows if (row["clipper"], row["hidden"], row["board"]) == (clipper, hidden, core)]
        differing = sum(row["pixels_differing"] for row in found)
        distances = [row["max_edge_distance_px"] for row in found if row["max_edge_distance_px"] is not None]
        cells.append([clipper, hidden, max(row["max_error_units"] for row in found),
                      max(row["max_error_units_at_all"] for row in found), differing,
                      MILLION * differing / sum(row["pixels"] for row in found),
                      max(distances) * PIXEL if distances else None,
                      sum(row["pixels_unexplained"] for row in found), max(row["screen_px"] for row in found),
                      max(row["vertices"] for row in found)])
    return cells


EXACT_HEADER = ["clipper", "visibility", "error", "error, nearly parallel", "pixels that differ", "in a million",
                "from an edge", "unexplained", "farthest px", "vertices"]


OPERATIONS_HEADER = ["clipper", "polygons cut, % of those that cross", "intersections", "distances", "instructions",
                     "multiplications", "divisions"]


def operation_cells(result, core):
    """[[clipper, polygons cut of a hundred that the frustum crosses; intersections and distances of one that it
    crosses; instructions, multiplications, divisions of one that was cut]], over all scenes."""
    cells, rows = [], [row for row in result["operations"] if row["board"] == core]
    for clipper in _values(rows, "clipper"):
        total = {key: sum(row[key] for row in rows if row["clipper"] == clipper) for key in
                 ("crossing", "polygons", "intersections", "distances", "instructions", "multiplications", "divisions")}
        if total["crossing"] and total["polygons"]:
            cells.append([clipper, round(100 * total["polygons"] / total["crossing"]),
                          *[round(total[key] / total["crossing"], 2) for key in ("intersections", "distances")],
                          round(total["instructions"] / total["polygons"]),
                          *[round(total[key] / total["polygons"], 1) for key in ("multiplications", "divisions")]])
    return cells


def terminal(plan, result):
    """What make clippers prints."""
    rows, parts = result["rows"], []
    for core in _values(rows, "board"):
        scenes = _values(rows, "scene")
        header = ["clipper", "visibility", *[f"{scene}, median" for scene in scenes], "worst", "flash", f"RAM, {scenes[0]}",
                  "stack"]
        parts.append(f"{NAMES[core]}, instructions a frame\n" + table(cost_cells(rows, core), header))
    if rows:
        parts.append("error in 1/65536 pixel\n" + table(exact_cells(rows), EXACT_HEADER))
    for core in _values(result["operations"], "board"):
        parts.append(f"{NAMES[core]}, clipping a polygon\n" + table(operation_cells(result, core), OPERATIONS_HEADER))
    return "\n\n".join(parts)


# --- the page ------------------------------------------------------------------------

def scene_pictures(plan, result, hosts):
    """A picture of each scene: its middle frame, by the first combination."""
    pictures = []
    for scene, frames in result["frames"].items():
        key = next((key for key in hosts if key[2] == scene), None)
        if key:
            shown = clippers_run.shown(scene, hosts[key], frames // 2)
            block = report_page.frame_block(shown)["panels"][0][0]
            pictures.append({"scene": scene, "what": plan.scenes[scene]["what"], "frames": frames, "png": block["png"]})
    return pictures


def difference_blocks(hosts):
    """The frames that differ most from double, each of another clipper and scene."""
    worst = {}
    for key, host in hosts.items():
        shown = clippers_run.shown(key[2], host, host["differing"].index(max(host["differing"])))
        pair = (key[0], key[2])
        if shown.differing and (pair not in worst or worst[pair][1].differing < shown.differing):
            worst[pair] = (key, shown)
    most = sorted(worst.values(), key=lambda each: -each[1].differing)[:DIFFERENCES]
    return [{"key": key, **report_page.frame_block(shown)} for key, shown in most]


def plots(plan, result):
    """[(title, SVG)] of the page."""
    rows = result["rows"]
    cores, hidden = _values(rows, "board"), _values(rows, "hidden")
    made = [(f"What each clipper costs, {NAMES[core]}, {hidden[0]}", costs(plan, rows, core, hidden[0]))
            for core in cores]
    if len(hidden) > 1:
        made += [(f"What each visibility method costs, {NAMES[core]}, {rows[0]['clipper']}",
                  methods(plan, rows, core, rows[0]["clipper"])) for core in cores]
    made.append(("The largest error of an outline", errors(plan, rows, hidden[0])))
    made.append(("Flash: the renderer with this clipper and no other",
                 sizes(plan, rows, cores, hidden[0])))
    return made


def render(plan, result, hosts):
    """The page as text; hosts: what the host drew, by clipper, method, scene."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    environment.filters["figure"] = report_page.figure
    rows = result["rows"]
    return environment.get_template("clippers.html").render(
        result=result, plan=plan, names=NAMES, scenes=_values(rows, "scene"), cores=_values(rows, "board"),
        costs={core: cost_cells(rows, core) for core in _values(rows, "board")}, exact=exact_cells(rows),
        operations={core: operation_cells(result, core) for core in _values(result["operations"], "board")},
        operations_header=OPERATIONS_HEADER, pictures=scene_pictures(plan, result, hosts),
        differences=difference_blocks(hosts), plots=plots(plan, result))


# --- docs/clipping.md ----------------------------------------------------------------

def _cells(values):
    return [value if isinstance(value, str) else report_page.figure(value) for value in values]


def _markdown(header, rows, left=2):
    return bench_page.markdown_table(header, [_cells(row) for row in rows], left=range(left))


def clippers_markdown(plan, _):
    """The clippers, and what they do."""
    return _markdown(["clipper", "what it does", "system of the sources"], [[f"**{name}**", each["what"], each["systems"]]
                                                  for name, each in plan.clippers.items()], 3)


def hidden_markdown(plan, _):
    """The visibility methods, and what they do."""
    return _markdown(["method", "what it does", "system of the sources"], [[f"**{name}**", each["what"], each["systems"]]
                                                 for name, each in plan.hidden.items()], 3)


def scenes_markdown(plan, result):
    """The scenes, and how much of them was drawn."""
    return _markdown(["scene", "what it is", "frames"], [[f"**{name}**", plan.scenes[name]["what"], frames]
                                               for name, frames in result["frames"].items()])


def _costs_markdown(rows, core):
    scenes = _values(rows, "scene")
    header = [NAMES[core], "visibility", *scenes, "worst frame"]
    return _markdown(header, [cells[:2 + len(scenes) + 1] for cells in cost_cells(rows, core)])


def costs_markdown(_, result):
    """Median instructions a frame of each clipper, with the first method and those for some clippers only."""
    rows = [row for row in result["rows"] if row["hidden"] in ("sorted", "box")]
    return "\n\n".join(_costs_markdown(rows, core) for core in _values(rows, "board"))


def methods_markdown(_, result):
    """The same of each method, with the first clipper."""
    rows = [row for row in result["rows"] if row["clipper"] == result["rows"][0]["clipper"]]
    return "\n\n".join(_costs_markdown(rows, core) for core in _values(rows, "board"))


def memory_markdown(_, result):
    """Bytes of flash, RAM and stack: each clipper with the first method, then each method with the first clipper."""
    rows, cores = result["rows"], _values(result["rows"], "board")
    first = rows[0]
    wanted = [kind for kind in _kinds(rows) if first["hidden"] == kind[1] or first["clipper"] == kind[0]]
    table_rows = []
    for clipper, hidden in wanted:
        cells = [clipper, hidden]
        for core in cores:
            found = [row for row in rows if (row["clipper"], row["hidden"], row["board"]) == (clipper, hidden, core)]
            cells += [found[0]["text_bytes"], max(row["stack_bytes"] for row in found)]
        table_rows.append([*cells, _first(rows, clipper=clipper, hidden=hidden, scene=first["scene"])["ram_bytes"]])
    return _markdown(["clipper", "visibility", *[f"{NAMES[core]}: {what}" for core in cores for what in ("flash", "stack")],
                      f"RAM, {first['scene']}"], table_rows)


def exact_markdown(_, result):
    """How exact each combination is, over all scenes."""
    header = ["clipper", "visibility", "largest error", "largest error, nearly parallel", "pixels that differ", "in a million",
              "farthest from an edge", "unexplained", "farthest on the screen, pixels", "most vertices"]
    return _markdown(header, exact_cells(result["rows"]))


def operations_markdown(_, result):
    """What clipping a polygon takes."""
    return "\n\n".join(_markdown([NAMES[core], *OPERATIONS_HEADER[1:]], operation_cells(result, core), 1)
                       for core in _values(result["operations"], "board"))


def all_markdown(_, result):
    """Every combination: median instructions a frame in every scene."""
    return "\n\n".join(_costs_markdown(result["rows"], core) for core in _values(result["rows"], "board"))


def summary_markdown(_, result):
    """How many frames were drawn and compared."""
    rows = result["rows"]
    return (f"{len(_kinds(rows))} combinations in {len(result['frames'])} scenes "
            f"on {len(_values(rows, 'board'))} cores: "
            f"{sum(row['frames'] for row in rows):,} frames, {sum(row['pixels'] for row in rows):,} pixels. Different "
            f"from double: {sum(row['pixels_differing'] for row in rows):,}; unexplained: "
            f"{sum(row['pixels_unexplained'] for row in rows):,}. Frames of an emulated core unlike the host's: "
            f"{sum(not row['equal_to_host'] for row in rows)}.")


SECTIONS = {"summary": summary_markdown, "clippers": clippers_markdown, "hidden": hidden_markdown,
            "scenes": scenes_markdown, "costs": costs_markdown, "methods": methods_markdown,
            "operations": operations_markdown, "memory": memory_markdown, "exact": exact_markdown, "all": all_markdown}


def replace_tables(text, plan, result):
    """docs/clipping.md with its tables made anew."""
    return bench_page.replace_tables(text, plan, result, SECTIONS)


def _bars(axes, groups, series, figure_of):
    """Bars of figures (height, from, to): a group of one bar for each of the series; nothing for None."""
    width = 0.84 / len(series)
    for number, one in enumerate(series):
        found = [(place + (number - (len(series) - 1) / 2) * width, figure_of(group, one))
                 for place, group in enumerate(groups)]
        found = [(place, figure) for place, figure in found if figure is not None]
        places = [place for place, _ in found]
        axes.bar(places, [figure[0] for _, figure in found], width, label=one, color=COLOURS[number % len(COLOURS)])
        axes.vlines(places, [figure[1] for _, figure in found], [figure[2] for _, figure in found], color=SOFT,
                    linewidth=1)
    axes.set_xticks(range(len(groups)), groups)
    axes.grid(axis="x", visible=False)


def _instructions(rows):
    """{(scene, clipper, hidden): (median, least, most)}, in millions."""
    return {(row["scene"], row["clipper"], row["hidden"]):
            tuple(row["instructions"][key] / 1e6 for key in ("median", "min", "max")) for row in rows}


def _plot(name, draw, size=(9.6, 3.4)):
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=size)
        axes = figure.subplots()
        draw(axes)
        handles, labels = axes.get_legend_handles_labels()
        if handles:
            figure.legend(handles, labels, loc="outside upper left", ncols=min(9, len(labels)), fontsize=8.5)
        return as_svg(figure, name)


def costs(plan, rows, core, hidden):
    """Instructions a frame, clippers side by side; the line is from the least frame to the most."""
    found = _instructions(row for row in rows if row["board"] == core and row["hidden"] == hidden)

    def draw(axes):
        _bars(axes, _in_order(plan.scenes, rows, "scene"), _in_order(plan.clippers, rows, "clipper"),
              lambda scene, clipper: found.get((scene, clipper, hidden)))
        axes.set_ylabel(f"million instructions a frame, {NAMES[core]}")
    return _plot(f"costs-{core}-{hidden}", draw)


def methods(plan, rows, core, clipper):
    """Instructions a frame, what hides what side by side."""
    rows = [row for row in rows if row["board"] == core and row["clipper"] == clipper]
    found = _instructions(rows)

    def draw(axes):
        _bars(axes, _in_order(plan.scenes, rows, "scene"), _in_order(plan.hidden, rows, "hidden"),
              lambda scene, hidden: found.get((scene, clipper, hidden)))
        axes.set_ylabel(f"million instructions a frame, {NAMES[core]}")
    return _plot(f"methods-{core}-{clipper}", draw)


def errors(plan, rows, hidden):
    """The largest error of each clipper in each scene, on a logarithmic axis."""
    clippers, scenes = (_in_order(plan.clippers, rows, "clipper"), _in_order(plan.scenes, rows, "scene"))
    found = {(row["clipper"], row["scene"]): row["max_error_units_at_all"] for row in rows if row["hidden"] == hidden}

    def draw(axes):
        for number, scene in enumerate(scenes):
            points = [(place, found[clipper, scene]) for place, clipper in enumerate(clippers)
                      if found.get((clipper, scene))]
            axes.plot([x for x, _ in points], [y for _, y in points], linestyle="none", marker="o", markersize=5,
                      color=COLOURS[number % len(COLOURS)], label=scene, alpha=0.85)
        axes.set_yscale("log")
        axes.set_xlim(-0.5, len(clippers) - 0.5)
        axes.set_ylim(0.3, max(2 * PIXEL, 2 * max(found.values(), default=1)))
        axes.axhline(PIXEL, color=SOFT, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate("1 pixel", (1, PIXEL), xycoords=("axes fraction", "data"), xytext=(0, 2),
                      textcoords="offset points", ha="right", fontsize=8, color=SOFT)
        axes.set_xticks(range(len(clippers)), clippers)
        axes.set_ylabel("largest error, 1/65536 pixel")
    return _plot("errors", draw)


def sizes(plan, rows, cores, hidden):
    """Bytes of code of the renderer with each clipper alone."""
    found = {(row["clipper"], row["board"]): row["text_bytes"] for row in rows if row["hidden"] == hidden}

    def draw(axes):
        _bars(axes, _in_order(plan.clippers, rows, "clipper"), cores,
              lambda clipper, core: (found[clipper, core],) * 3 if (clipper, core) in found else None)
        axes.set_ylabel("bytes of flash")
    return _plot("sizes", draw, (9.6, 2.8))


def _in_order(names, rows, key):
    """Those of the plan's names that rows are about."""
    there = {row[key] for row in rows}
    return [name for name in names if name in there]
