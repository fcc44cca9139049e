# SPDX-License-Identifier: MIT
"""The error report's plots, as SVG to stand inside a page."""

import io
import math
import re

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot  # noqa: E402  (the backend comes first)

SCENE, RANDOM = "#0f6cbd", "#d97706"
BAD = "#c2185b"
GRID = "#d9dee5"
STYLE = {"font.family": "sans-serif", "font.size": 9, "svg.fonttype": "none",
         "axes.edgecolor": "#8a94a3", "axes.labelcolor": "#3c4654", "xtick.color": "#3c4654",
         "ytick.color": "#3c4654", "axes.spines.top": False, "axes.spines.right": False,
         "axes.axisbelow": True, "axes.grid": True, "grid.color": GRID, "grid.linewidth": 0.6,
         "legend.frameon": False, "figure.constrained_layout.use": True}


def _svg(figure, name):
    """A figure as an SVG element; name keeps its ids apart from those of other plots."""
    block = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": name}):
        figure.savefig(block, format="svg", transparent=True, metadata={"Date": None})
    pyplot.close(figure)
    text = block.getvalue()
    text = text[text.index("<svg"):]
    # Without width and height the page's layout decides; viewBox keeps the shape.
    head, rest = text.split(">", 1)
    head = re.sub(r'\s(width|height)="[^"]*"', "", head)
    ids = re.compile(r'(\bid="|href="#|url\(#)')
    return head + f' role="img" aria-label="{name}">' + ids.sub(rf"\g<1>{name}-", rest)


def _bar_edges(bins):
    """Lower and upper power of two of each bin of a histogram."""
    uppers = [math.log2(entry["upto"]) for entry in bins]
    return [(upper - 1, upper) for upper in uppers]


def histogram(stage, by_input, unit, name):
    """Share of the samples by size of the difference, both axes logarithmic."""
    with matplotlib.rc_context(STYLE):
        figure, axes = pyplot.subplots(figsize=(4.6, 2.5))
        if not any(entry["max"] for entry in by_input):
            return _all_equal(figure, axes, sum(entry["samples"] for entry in by_input), name)
        powers = []
        for entry, colour, shift in zip(by_input, (SCENE, RANDOM), (0.02, 0.5)):
            bins = entry.get("histogram", [])
            total = sum(each["count"] for each in bins)
            edges = _bar_edges(bins)
            shares = [each["count"] / total for each in bins] if total else []
            powers += [power for edge in edges for power in edge]
            axes.bar([low + shift for low, _ in edges], shares, width=0.46, align="edge",
                     color=colour, label=f"{entry['input']} ({entry['samples']:,})")
        axes.set_yscale("log")
        axes.set_ylim(top=2)
        axes.set_ylabel("share of samples")
        axes.set_xlabel(f"difference at most, {unit}")
        _power_ticks(axes, powers)
        axes.legend(loc="upper left", bbox_to_anchor=(0, 1.16), ncols=2, borderaxespad=0,
                    handlelength=1, fontsize=8)
        return _svg(figure, name)


def _all_equal(figure, axes, samples, name):
    """In place of a histogram of nothing."""
    axes.set_axis_off()
    axes.text(0.5, 0.5, f"none of {samples:,} samples differs", ha="center", va="center", fontsize=11,
              color="#18794e", transform=axes.transAxes)
    return _svg(figure, name)


def _power_ticks(axes, powers):
    """Ticks at powers of two, few enough to read; the lowest bin also holds what does not differ."""
    if not powers:
        axes.set_xticks([])
        return
    low, high = int(min(powers)), int(max(powers))
    if high - low <= 1:
        # One bin: everything in it.
        low, high = high - 2, high + 1
        axes.set_xlim(low, high)
    every = max(1, (high - low + 7) // 8)
    ticks = list(range(high, low - 1, -every))
    axes.set_xticks(ticks, [f"{2.0 ** tick:g}" if low >= -6 and high <= 10 else f"$2^{{{tick}}}$"
                            for tick in ticks])
    axes.grid(axis="x", visible=False)


def per_frame(frames, name):
    """Differing pixels of every frame; unexplained ones stand out."""
    with matplotlib.rc_context(STYLE):
        figure, axes = pyplot.subplots(figsize=(9.6, 2.3))
        numbers = [frame["frame"] for frame in frames]
        differing = [frame["pixels_differing"] for frame in frames]
        unexplained = [frame["pixels_unexplained"] for frame in frames]
        axes.bar(numbers, differing, width=0.9, color=SCENE, label="explained")
        if any(unexplained):
            axes.bar(numbers, unexplained, width=0.9, color=BAD, label="unexplained")
            axes.legend(loc="upper left", bbox_to_anchor=(0, 1.16), ncols=2, borderaxespad=0)
        axes.set_xlabel("frame")
        axes.set_ylabel("pixels that differ")
        axes.set_xlim(min(numbers) - 0.6, max(numbers) + 0.6)
        axes.set_ylim(0, max(max(differing) * 1.1, 1))
        axes.yaxis.get_major_locator().set_params(integer=True)
        axes.xaxis.get_major_locator().set_params(integer=True)
        axes.grid(axis="x", visible=False)
        return _svg(figure, name)
