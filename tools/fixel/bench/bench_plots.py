# SPDX-License-Identifier: MIT
"""The bench's plots: a frame of each workload, and how costs grow."""

import io

import matplotlib
from matplotlib.figure import Figure

from fixel.bench import bench_faces
from fixel.bench.bench_goals import place_of
from fixel.bench.bench_plan import NAMES
from fixel.report.report_plots import INK, PAPER, SOFT, STYLE

COLOURS = {"fixel": "#0f6cbd", "listing-float": "#c77700", "listing-double": "#c2416b", "memset": "#6b7785"}
LABELS = {"fixel": "Fixel", "listing-float": "the listing, float", "listing-double": "the listing, double",
          "memset": "newlib's memset"}
AXES = {"cubes culled": "cubes, all but the first hundred out of sight", "cubes seen": "cubes, all in sight",
        "pixels": "pixels of the screen", "faces, one model": "faces of one model, all in sight",
        "faces, patches": "faces in patches of 50, all in sight"}

KINDS = ("#0f6cbd", "#c77700", "#2a8f4e", "#c2416b", "#6b4fb3")    # lines of faces

LABEL_GAP = 1 / 7   # of a plot's width, between two labels


def _files(name, figure):
    """{file name: bytes} of a figure as SVG and PNG; the same figure gives the same bytes."""
    files = {}
    with matplotlib.rc_context({"svg.hashsalt": name}):
        for kind, extra in (("svg", {"metadata": {"Date": None}}), ("png", {"dpi": 130, "metadata": {"Software": None}})):
            block = io.BytesIO()
            figure.savefig(block, format=kind, facecolor=PAPER, **extra)
            files[f"{name}.{kind}"] = block.getvalue()
    return files


def frames(plan, result):
    """Instructions a frame by workload, a panel for each core; the line is the way to the worst frame."""
    cores = [*result["cores"], *result["extra_cores"]]
    with matplotlib.rc_context({**STYLE, "font.size": 10}):
        figure = Figure(figsize=(12.4, 3.3 * -(-len(cores) // 2)))
        panels = list(figure.subplots(-(-len(cores) // 2), 2, sharey=True, squeeze=False).flat)
        for axes in panels[len(cores):]:
            axes.set_axis_off()
        for axes, core in zip(panels, cores):
            _core(axes, plan, [row for row in result["rows"] if row["core"] == core and row["frame"]])
            axes.set_title(NAMES[core], loc="left", fontweight="bold", color=INK)
        for axes in panels[::2]:
            axes.set_ylabel("instructions a frame")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=len(labels))
        return figure


def _core(axes, plan, rows):
    workloads, renderers = list(plan.workloads), list(plan.renderers)
    width = 0.8 / len(renderers)
    for number, renderer in enumerate(renderers):
        drawn = [row for row in rows if row["renderer"] == renderer]
        places = [workloads.index(row["workload"]) + (number - (len(renderers) - 1) / 2) * width for row in drawn]
        axes.bar(places, [row["frame"]["mean"] for row in drawn], width, color=COLOURS[renderer],
                 label=LABELS[renderer])
        axes.vlines(places, [row["frame"]["mean"] for row in drawn], [row["frame"]["max"] for row in drawn],
                    color=SOFT, linewidth=1)
    axes.set_yscale("log")
    axes.set_xticks(range(len(workloads)), workloads)
    axes.grid(axis="x", visible=False)


def growth(result):
    """How a frame grows with cubes, pixels and faces; straight through the first two points is linear."""
    axes_of = [axis for axis in AXES if any(row["axis"] == axis for row in result["growth"])]
    with matplotlib.rc_context({**STYLE, "font.size": 10}):
        figure = Figure(figsize=(10.8, 3.3 * -(-len(axes_of) // 3)))
        panels = list(figure.subplots(-(-len(axes_of) // 3), 3, squeeze=False).flat)
        for axes in panels[len(axes_of):]:
            axes.set_axis_off()
        for axes, name in zip(panels, axes_of):
            rows = [row for row in result["growth"] if row["axis"] == name]
            places = [row[place_of(name)] for row in rows]
            counts = [row["instructions"] / 1e6 for row in rows]
            line = _line(places, counts)
            axes.plot([places[0], places[-1]], line, color=SOFT, linewidth=1,
                      linestyle=(0, (4, 3)), label="straight through the first two")
            axes.plot(places, counts, color=COLOURS["fixel"], marker="o", label="measured")
            axes.set_xlabel(AXES[name])
            axes.set_xticks(places, _labels(places))
            axes.set_xlim(0, places[-1] * 1.08)
            axes.set_ylim(0, max([*counts, *line]) * 1.1)
            axes.set_ylabel("million instructions a frame")
        figure.axes[0].legend(loc="upper left")
        return figure


def _labels(places):
    """A label for each place that is far enough from the next that has one."""
    labels, last = [], float("inf")
    for place in reversed(places):
        labels.append(f"{place:,}" if last - place >= LABEL_GAP * places[-1] else "")
        last = place if labels[-1] else last
    return labels[::-1]


def _line(places, counts):
    """The straight line through the first two points, at the first and the last."""
    slope = (counts[1] - counts[0]) / (places[1] - places[0])
    return [counts[0], counts[0] + slope * (places[-1] - places[0])]


def faces(plan, result):
    """Instructions of a face by its pixels, a line for each kind, a panel for each core; with the floor where it is known."""
    cores = list(dict.fromkeys(row["core"] for row in result["faces"]))
    pixels = [bench_faces.pixels_of(radius) for radius in plan.faces["radii"]]
    with matplotlib.rc_context({**STYLE, "font.size": 10}):
        figure = Figure(figsize=(10.8, 4.4))
        for axes, core in zip(figure.subplots(1, len(cores), squeeze=False).flat, cores):
            for kind, colour in zip(plan.faces["kinds"], KINDS):
                rows = [bench_faces.of(result, kind["name"], radius, core) for radius in plan.faces["radii"]]
                axes.plot(pixels, [row["frame"] / bench_faces.COUNT for row in rows], color=colour, marker="o", label=kind["name"])
                if core == cores[0]:
                    axes.plot(pixels, [bench_faces.floor_of(kind, radius) for radius in plan.faces["radii"]], color=colour,
                              linewidth=1, linestyle=(0, (4, 3)))
            axes.set_title(NAMES[core] + (", dashed: the floor" if core == cores[0] else ""), loc="left", fontweight="bold", color=INK)
            axes.set_xscale("log")
            axes.set_xticks(pixels, [f"{each:.1f}" if each < 10 else f"{each:.0f}" for each in pixels])
            axes.minorticks_off()
            axes.set_xlabel("pixels of a face")
            axes.set_ylim(0)
            axes.set_ylabel("instructions a face")
        figure.axes[0].legend(loc="upper left")
        return figure


def files(plan, result):
    """{file name: bytes} of all plots."""
    made = _files("bench", frames(plan, result))
    if result["growth"]:
        made.update(_files("growth", growth(result)))
    if result["faces"]:
        made.update(_files("faces", faces(plan, result)))
    return made
