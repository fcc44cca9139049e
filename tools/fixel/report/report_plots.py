# SPDX-License-Identifier: MIT
"""The report's plots: SVG that stands inside a page, and one picture for the README."""

import io
import math
import re

import matplotlib
from matplotlib.figure import Figure

COLOURS = {"naive": "#c2416b", "float32": "#c77700", "fixel": "#0f6cbd"}
NAMES = {"naive": "16.16, plain port", "float32": "float32", "fixel": "Fixel"}
ORDER = ("naive", "float32", "fixel")       # Fixel last, on top
INK, SOFT, GRID, PAPER = "#1c2430", "#5b6675", "#dfe4ea", "#ffffff"
STYLE = {"font.family": "sans-serif", "font.size": 9, "svg.fonttype": "none",
         "axes.edgecolor": "#aab2bd", "axes.labelcolor": "#3c4654", "xtick.color": "#3c4654",
         "ytick.color": "#3c4654", "axes.spines.top": False, "axes.spines.right": False,
         "axes.axisbelow": True, "axes.grid": True, "grid.color": GRID, "grid.linewidth": 0.6,
         "legend.frameon": False, "figure.constrained_layout.use": True,
         "xtick.minor.visible": False, "ytick.minor.visible": False}
PIXEL = 65536           # units
LOWEST = 2.0 ** -6      # a histogram's first bin holds everything up to this
SHARE_FLOOR = 0.6       # of one sample
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")   # matplotlib's own formulas take half of the time of a page
UNITS = {"2^-30": "2⁻³⁰"}
# Of a sweep's errors: what a line marks, and the least that is told from 0.
MARKS = {"1/65536 pixel": (PIXEL, "1 pixel", 0.1), "texels": (1, "1 texel", 1e-4), "levels": (1, "1 level", 1e-4),
         "1/65536 of the distance": (PIXEL / 100, "1 % of the distance", 1e-3)}
TICK_GAP = 1 / 12       # of a plot's width, between two labels


def as_svg(figure, name):
    """A figure as an SVG element; name keeps its ids apart from those of other plots."""
    block = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": name}):
        figure.savefig(block, format="svg", transparent=True, metadata={"Date": None})
    text = block.getvalue()
    text = text[text.index("<svg"):]
    # Without width and height the page's layout decides; viewBox keeps the shape.
    head, rest = text.split(">", 1)
    head = re.sub(r'\s(width|height)="[^"]*"', "", head)
    ids = re.compile(r'(\bid="|href="#|url\(#)')
    return head + f' role="img" aria-label="{name}">' + ids.sub(rf"\g<1>{name}-", rest)


def in_words(value, unit="1/65536 pixel"):
    """An error for people: in pixels where it is a sizeable part of one."""
    if unit == "1/65536 pixel" and value >= PIXEL / 20:
        pixels = value / PIXEL
        number = f"{pixels:,.0f}" if pixels >= 100 else f"{pixels:.3g}"
        return f"{number} pixel" if number == "1" else f"{number} pixels"
    return f"{value:,.0f}" if value >= 1000 else f"{value:.3g}"


def _lumped(entry, lowest):
    """{upper power: share} of a histogram."""
    total, shares = sum(each["count"] for each in entry["histogram"]), {}
    for each in entry["histogram"]:
        power = round(math.log2(max(each["upto"], lowest)))
        shares[power] = shares.get(power, 0) + each["count"] / total
    return shares


def _steps(shares, floor):
    """Corners of a histogram's outline."""
    powers = sorted(shares)
    xs, ys = [powers[0] - 1], [floor]
    for power in range(powers[0], powers[-1] + 1):
        height = max(shares.get(power, floor), floor)
        xs += [power - 1, power]
        ys += [height, height]
    return [*xs, powers[-1]], [*ys, floor]


def histogram(stage, entries, name):
    """Share of the samples by size of error, for each design; both axes logarithmic."""
    unit = entries[0]["unit"]
    whole = unit == "pixels"
    lowest = 0.5 if whole else LOWEST
    floor = SHARE_FLOOR / max(entry["samples"] for entry in entries)
    by_design = {entry["design"]: _lumped(entry, lowest) for entry in entries}
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(5.2, 2.7))
        axes = figure.subplots()
        for design in ORDER:
            xs, ys = _steps(by_design[design], floor)
            axes.fill_between(xs, ys, floor, color=COLOURS[design], alpha=0.16, linewidth=0)
            axes.plot(xs, ys, color=COLOURS[design], linewidth=1.5, label=NAMES[design])
        _make_logarithmic(axes)
        axes.set_ylim(floor, 3)
        axes.set_ylabel("share of samples")
        plural = whole or unit in ("texels", "levels")
        axes.set_xlabel(f"error, in {unit if plural else 'units of ' + UNITS.get(unit, unit)}")
        _power_ticks(axes, by_design.values(), lowest, whole)
        if unit == "1/65536 pixel":
            _mark_pixel(axes, 16, "1 pixel")
        _legend(axes)
        return as_svg(figure, name)


def _power_ticks(axes, shares, lowest, whole):
    powers = [power for each in shares for power in each]
    low, high = min(min(powers), round(math.log2(lowest))) - 1, max(powers)
    axes.set_xlim(low, high + 0.5)
    every = max(1, (high - low) // 8)
    ticks = list(range(low + 1, high + 1, every))
    axes.set_xticks(ticks, [_power_label(tick, lowest, whole) for tick in ticks])
    axes.grid(axis="x", visible=False)


def _power_label(power, lowest, whole):
    if 2.0 ** power <= lowest:
        return "0" if whole else f"≤ {_raised(2, power)}"
    return f"{2 ** power:,}" if 0 <= power <= 10 else _raised(2, power)


def _raised(base, power):
    """A power as text."""
    return f"{base}{str(power).translate(RAISED)}"


def _make_logarithmic(axes):
    """The vertical axis, labelled by powers of ten."""
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(lambda value, _: _raised(10, round(math.log10(value))))


def _mark_pixel(axes, at, text):
    low, high = axes.get_xlim()
    if low < at < high:
        axes.axvline(at, color=SOFT, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate(text, (at, 1), xycoords=("data", "axes fraction"), xytext=(3, -2),
                      textcoords="offset points", va="top", fontsize=8, color=SOFT)


def _legend(axes):
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1.0), ncols=3, borderaxespad=0.2, handlelength=1.4,
                columnspacing=1.4, fontsize=8.5)


def sweep(entries, name):
    """Largest and mean error over one parameter, for each design."""
    unit = entries[0]["unit"]
    mark, words, least = MARKS[unit]
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(5.2, 2.9))
        axes = figure.subplots()
        for entry in sorted(entries, key=lambda each: ORDER.index(each["design"])):
            values = [point["value"] for point in entry["points"]]
            colour = COLOURS[entry["design"]]
            axes.plot(values, [max(least, point["max"]) for point in entry["points"]], color=colour, linewidth=1.7,
                      marker="o", markersize=3.2, label=NAMES[entry["design"]])
            axes.plot(values, [max(least, point["mean"]) for point in entry["points"]], color=colour, linewidth=1,
                      linestyle=(0, (2, 2)), alpha=0.75)
        if entries[0]["parameter"] != "fov":
            axes.set_xscale("log")
            axes.set_xticks(*_value_ticks(values))
        _make_logarithmic(axes)
        axes.minorticks_off()
        axes.set_xlabel(entries[0]["label"])
        axes.set_ylabel(f"error, {unit}")
        axes.set_ylim(bottom=least, top=max(4 * mark, 2 * axes.get_ylim()[1]))
        axes.axhline(mark, color=SOFT, linewidth=0.9, linestyle=(0, (4, 3)))
        axes.annotate(words, (1, mark), xycoords=("axes fraction", "data"), xytext=(0, 2),
                      textcoords="offset points", ha="right", fontsize=8, color=SOFT)
        _legend(axes)
        return as_svg(figure, name)


def _value_ticks(values):
    """Values far enough apart for their labels not to touch."""
    gap = math.log(values[-1] / values[0]) * TICK_GAP
    ticks = [values[0]]
    for value in values[1:]:
        if math.log(value / ticks[-1]) > gap:
            ticks.append(value)
    return ticks, [_value_label(value) for value in ticks]


def _value_label(value):
    if value <= 0.25 and math.log2(value).is_integer():
        return f"1/{round(1 / value)}"
    return f"{value:,g}" if value < 1000 else f"{value:,.0f}"


def per_frame(frames, name):
    """Differing pixels of every frame, walk after walk."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(10.6, 2.5))
        axes = figure.subplots()
        differing = [frame["pixels_differing"] for frame in frames]
        unexplained = [frame["pixels_unexplained"] for frame in frames]
        axes.bar(range(len(frames)), differing, width=1, color=COLOURS["fixel"], label="explained")
        if any(unexplained):
            axes.bar(range(len(frames)), unexplained, width=1, color=COLOURS["naive"], label="unexplained")
            axes.legend(loc="upper right")
        axes.set_xlim(-0.6, len(frames) - 0.4)
        axes.set_ylim(0, max(2, max(differing) * 1.15))
        axes.set_ylabel("pixels that differ")
        axes.yaxis.get_major_locator().set_params(integer=True)
        axes.grid(axis="x", visible=False)
        _scene_ticks(axes, frames)
        return as_svg(figure, name)


def _scene_ticks(axes, frames):
    """A scene's name under both of its walks."""
    names = [frame["scene"].split(",")[0] for frame in frames]
    starts = [place for place, name in enumerate(names) if place == 0 or name != names[place - 1]]
    ends = [*starts[1:], len(frames)]
    for start in starts[1:]:
        axes.axvline(start - 0.5, color="#aab2bd", linewidth=0.8)
    axes.set_xticks([(start + end - 1) / 2 for start, end in zip(starts, ends)],
                    [names[start] for start in starts])
    axes.tick_params(axis="x", length=0)


def picture_bytes(entries):
    """The README's picture: largest error of a vertex by its depth, as a PNG; of the samples of the stage, so that
    its largest figures are those of the table."""
    style = {**STYLE, "font.size": 12, "font.family": "DejaVu Sans"}
    with matplotlib.rc_context(style):
        figure = Figure(figsize=(9.6, 4.7), dpi=125, facecolor=PAPER)
        axes = figure.subplots()
        for entry in sorted(entries, key=lambda each: ORDER.index(each["design"])):
            values = [point["value"] for point in entry["points"]]
            axes.plot(values, [point["max"] / PIXEL for point in entry["points"]], linewidth=3.2,
                      color=COLOURS[entry["design"]], solid_capstyle="round", marker="o", markersize=5)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.minorticks_off()
        axes.set_xticks(*_value_ticks(values))
        levels = (100, 1, 0.01, 1e-4, 1 / PIXEL)
        axes.set_yticks(levels, ["100 pixels", "1 pixel", "1/100", "1/10,000", "1/65,536"])
        axes.set_ylim(2.0 ** -18.3, 1200)
        axes.set_xlim(values[0] / 1.6, values[-1] * 1.6)
        axes.set_xlabel("depth of the vertex, world units: from here to twice as deep")
        axes.axhline(1, color=INK, linewidth=1, linestyle=(0, (5, 4)))
        axes.set_title("How far a vertex lands from where it should: worst case", loc="left", fontsize=15,
                       fontweight="bold", color=INK, pad=12)
        _label_lines(axes, {entry["design"]: entry["points"] for entry in entries})
        block = io.BytesIO()
        figure.savefig(block, format="png", metadata={"Software": None})
        return block.getvalue()


def _label_lines(axes, points):
    """Names beside the lines, so that no legend need be looked up."""
    def near(design, value):
        return min(points[design], key=lambda point: abs(math.log(point["value"] / value)))

    def label(design, value, text, offset, ha):
        point = near(design, value)
        axes.annotate(text, (point["value"], point["max"] / PIXEL), xytext=offset, ha=ha,
                      textcoords="offset points", color=COLOURS[design], fontsize=13, fontweight="bold")

    worst = {design: max(point["max"] for point in rows) / PIXEL for design, rows in points.items()}
    label("naive", 1024, f"16.16, plain port: up to {worst['naive']:.3g} pixels", (-12, 12), "right")
    label("float32", 1 / 64, f"float32: up to {worst['float32']:.3g} pixels", (12, 8), "left")
    label("fixel", 1, f"Fixel: {worst['fixel'] * PIXEL:.2f} of 1/65,536 pixel, at every depth", (0, 10),
          "center")
