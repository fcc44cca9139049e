# SPDX-License-Identifier: MIT
"""The plots of the comparison of clippers: SVG that stands inside a page."""

import matplotlib
from matplotlib.figure import Figure

from fixel.bench.bench_plan import NAMES
from fixel.report.report_plots import PIXEL, SOFT, STYLE, as_svg

COLOURS = ("#0f6cbd", "#c77700", "#18794e", "#c2416b", "#6b4fbb", "#0e8a8a", "#8a6d1d", "#6b7785", "#b3123f")


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
