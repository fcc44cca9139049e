# SPDX-License-Identifier: MIT
"""What the plots of reports show: which bar and point stands where, and what is written beside it."""

import types

import pytest

from fixel.bench import bench_plots, clippers_page
from fixel.report import report_plots

BUILT_PROGRAMS = ()
PIXEL = report_plots.PIXEL


@pytest.fixture
def figures(monkeypatch):
    """Plots stay matplotlib's figures, which a test can ask."""
    for module in (report_plots, clippers_page):
        monkeypatch.setattr(module, "as_svg", lambda figure, name: figure)


def bars(axes):
    """[(middle, height)] of a label, by label."""
    return {group.get_label(): [(round(bar.get_x() + bar.get_width() / 2, 6), bar.get_height()) for bar in group]
            for group in axes.containers}


def ticks(axes):
    return [label.get_text() for label in axes.get_xticklabels()]


def lines(axes):
    """[[(x, y)]] of the lines of the plot."""
    return [list(zip(line.get_xdata(), line.get_ydata())) for line in axes.get_lines()]


def spans(axes):
    """[(x, from, to)] of vertical lines."""
    return [(round(line[0][0], 6), line[0][1], line[1][1])
            for group in axes.collections for line in group.get_segments()]


# --- make bench ---------------------------------------------------------------------

def bench_row(workload, renderer, core, mean, most):
    return {"workload": workload, "renderer": renderer, "core": core, "frame": {"min": 1, "mean": mean, "max": most}}


def test_a_frame_of_each_workload_is_a_bar_beside_those_of_other_renderers():
    plan = types.SimpleNamespace(workloads={"w1": 0, "w2": 0}, renderers=("fixel", "listing-float"))
    rows = [bench_row("w1", "fixel", "m3", 10, 11), bench_row("w2", "fixel", "m3", 20, 25),
            bench_row("w2", "listing-float", "m3", 80, 90), bench_row("w1", "fixel", "m0", 30, 31),
            bench_row("w1", "fixel", "m55", 40, 40), {**bench_row("w1", "memset", "m3", 1, 1), "frame": None}]
    figure = bench_plots.frames(plan, {"cores": ["m0", "m3", "m55"], "extra_cores": [], "rows": rows})
    assert figure.get_size_inches()[1] == pytest.approx(2 * 3.3)       # two rows of two cores
    panels = figure.axes
    assert len(panels) == 4 and [axes.axison for axes in panels] == [True, True, True, False]
    assert bars(panels[1]) == {"Fixel": [(-0.2, 10), (0.8, 20)], "the listing, float": [(1.2, 80)]}
    assert spans(panels[1]) == [(-0.2, 10, 11), (0.8, 20, 25), (1.2, 80, 90)]
    assert bars(panels[0])["Fixel"] == [(-0.2, 30)] and bars(panels[2])["Fixel"] == [(-0.2, 40)]
    assert ticks(panels[1]) == ["w1", "w2"] and panels[1].get_yscale() == "log"
    assert [axes.get_title("left") for axes in panels[:3]] == [bench_plots.NAMES[core] for core in ("m0", "m3", "m55")]
    assert [axes.get_ylabel() for axes in panels[:3]] == ["instructions a frame", "", "instructions a frame"]


def growth_row(axis, place, instructions):
    return {"axis": axis, "objects": place, "faces": place, "pixels": place, "instructions": instructions}


def test_growth_has_a_panel_for_each_axis_and_a_line_through_its_first_two_points():
    rows = [growth_row("cubes seen", 100, 1e6), growth_row("cubes seen", 200, 3e6), growth_row("cubes seen", 400, 8e6),
            growth_row("pixels", 10, 2e6), growth_row("pixels", 20, 2e6)]
    first, second, unused = bench_plots.growth({"growth": rows}).axes
    assert lines(first) == [[(100, 1), (400, 7)], [(100, 1), (200, 3), (400, 8)]]
    assert lines(second) == [[(10, 2), (20, 2)], [(10, 2), (20, 2)]]
    assert [axes.get_xlabel() for axes in (first, second)] == ["cubes, all in sight", "pixels of the screen"]
    assert ticks(first) == ["100", "200", "400"] and not unused.axison
    assert first.get_xlim() == (0, 400 * 1.08) and first.get_ylim() == (0, pytest.approx(8 * 1.1))


def test_a_label_that_is_too_near_to_the_next_is_left_out():
    assert bench_plots._labels([100, 3000, 4000, 7000]) == ["100", "3,000", "4,000", "7,000"]
    assert bench_plots._labels([100, 3000, 3999, 7000]) == ["100", "", "3,999", "7,000"]
    assert bench_plots._labels([6500, 6900, 7000]) == ["", "", "7,000"]


# --- make clippers ------------------------------------------------------------------

def clipper_row(scene, clipper, hidden, median, board="m3"):
    return {"scene": scene, "clipper": clipper, "hidden": hidden, "board": board, "text_bytes": int(median),
            "max_error_units_at_all": median / 10, "instructions": {"median": median * 1e6, "min": 1e6, "max": 9e6}}


CLIPPER_ROWS = [clipper_row("w1", "near", "sorted", 2), clipper_row("w3", "near", "sorted", 3),
                clipper_row("w1", "view", "sorted", 4), clipper_row("w1", "near", "spans", 5),
                clipper_row("w1", "near", "sorted", 6, "m0")]
CLIPPER_PLAN = types.SimpleNamespace(scenes=["w0", "w1", "w3"], clippers=["view", "near"], hidden=["sorted", "spans"])


def test_clippers_stand_side_by_side_in_each_scene(figures):
    (axes,) = clippers_page.costs(CLIPPER_PLAN, CLIPPER_ROWS, "m3", "sorted").axes
    assert bars(axes) == {"view": [(-0.21, 4)], "near": [(0.21, 2), (1.21, 3)]}
    assert spans(axes) == [(-0.21, 1, 9), (0.21, 1, 9), (1.21, 1, 9)]
    assert ticks(axes) == ["w1", "w3"] and bench_plots.NAMES["m3"] in axes.get_ylabel()


def test_methods_stand_side_by_side_in_each_scene(figures):
    (axes,) = clippers_page.methods(CLIPPER_PLAN, CLIPPER_ROWS, "m3", "near").axes
    assert bars(axes) == {"sorted": [(-0.21, 2), (0.79, 3)], "spans": [(0.21, 5)]}


def test_errors_of_clippers_are_points_and_a_pixel_is_marked(figures):
    (axes,) = clippers_page.errors(CLIPPER_PLAN, CLIPPER_ROWS[:3], "sorted").axes
    assert lines(axes) == [[(0, 0.4), (1, 0.2)], [(1, 0.3)], [(0, PIXEL), (1, PIXEL)]]
    assert ticks(axes) == ["view", "near"]
    assert axes.get_xlim() == (-0.5, 1.5) and axes.get_ylim() == (0.3, 2 * PIXEL)
    rows = [{**CLIPPER_ROWS[0], "max_error_units_at_all": 3 * PIXEL}]
    assert clippers_page.errors(CLIPPER_PLAN, rows, "sorted").axes[0].get_ylim() == (0.3, 6 * PIXEL)


def test_sizes_of_clippers_stand_side_by_side_for_each_core(figures):
    (axes,) = clippers_page.sizes(CLIPPER_PLAN, [CLIPPER_ROWS[0], CLIPPER_ROWS[2], CLIPPER_ROWS[4]], ["m0", "m3"], "sorted").axes
    assert bars(axes) == {"m0": [(0.79, 6)], "m3": [(0.21, 4), (1.21, 2)]}


# --- make report --------------------------------------------------------------------

def frame(scene, differing, unexplained=0):
    return {"scene": scene, "pixels_differing": differing, "pixels_unexplained": unexplained}


def test_pixels_that_differ_are_a_bar_for_each_frame(figures):
    frames = [frame("w1", 2), frame("w1, rolled", 0), frame("w3", 10), frame("w3", 5), frame("w3", 0)]
    (axes,) = report_plots.per_frame(frames, "frames").axes
    assert bars(axes) == {"explained": [(0, 2), (1, 0), (2, 10), (3, 5), (4, 0)]}
    assert ticks(axes) == ["w1", "w3"] and list(axes.get_xticks()) == [0.5, 3]
    assert [list(line.get_xdata()) for line in axes.get_lines()] == [[1.5, 1.5]]
    assert axes.get_xlim() == (-0.6, 4.6) and axes.get_ylim() == (0, 11.5) and axes.get_legend() is None
    (axes,) = report_plots.per_frame([frame("w1", 1), frame("w1", 1, 1)], "frames").axes
    assert bars(axes) == {"explained": [(0, 1), (1, 1)], "unexplained": [(0, 0), (1, 1)]}
    assert {bar.get_width() for group in axes.containers for bar in group} == {1} and axes.get_ylim() == (0, 2)
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["explained", "unexplained"]


def design(name, points, **more):
    return {"design": name, "points": [{"value": value, "mean": mean, "max": most} for value, mean, most in points],
            "unit": "1/65536 pixel", "parameter": "depth", "label": "depth", **more}


def test_a_sweep_has_the_largest_and_the_mean_error_of_each_design(figures):
    points = [(1, 1, 3), (4, 0.01, 8)]
    entries = [design("fixel", points), design("naive", [(1, 10, 30), (4, 20, PIXEL)])]
    (axes,) = report_plots.sweep(entries, "sweep").axes
    assert lines(axes) == [[(1, 30), (4, PIXEL)], [(1, 10), (4, 20)], [(1, 3), (4, 8)], [(1, 1), (4, 0.1)],
                           [(0, PIXEL), (1, PIXEL)]]
    assert ticks(axes) == ["1", "4"] and axes.get_xscale() == "log" and axes.get_yscale() == "log"
    assert axes.get_ylim() == (0.1, 4 * PIXEL)
    (axes,) = report_plots.sweep([design("fixel", [(10, 1, 8 * PIXEL), (20, 1, 3)], parameter="fov")], "sweep").axes
    assert axes.get_xscale() == "linear" and axes.get_ylim()[1] > 16 * PIXEL


def test_ticks_of_values_do_not_touch():
    assert report_plots._value_ticks([1 / 64, 0.2, 1, 1.1, 64, 1024]) == ([1 / 64, 0.2, 1, 64, 1024], ["1/64", "0.2", "1", "64", "1,024"])
    assert [report_plots._value_label(value) for value in (0.25, 0.5, 0.3, 999.5, 12345.6)] == ["1/4", "0.5", "0.3", "999.5", "12,346"]



def test_a_histogram_has_a_step_for_each_power_of_two(figures):
    entries = [{"design": name, "unit": "1/65536 pixel", "samples": 8,
                "histogram": [{"upto": 0.001, "count": 1}, {"upto": 2.0 ** -6, "count": 1}, {"upto": 2, "count": 6}]}
               for name in report_plots.ORDER]
    (axes,) = report_plots.histogram("vertex", entries, "h").axes
    steps = lines(axes)[0]
    floor = 0.6 / 8
    assert steps == [(-7, floor), (-7, 0.25), (-6, 0.25), *[(x, floor) for power in range(-5, 1) for x in (power - 1, power)],
                     (0, 0.75), (1, 0.75), (1, floor)]
    assert axes.get_xlim() == (-7, 1.5) and axes.get_ylim() == (floor, 3)
    assert ticks(axes) == ["≤ 2⁻⁶", "2⁻⁵", "2⁻⁴", "2⁻³", "2⁻²", "2⁻¹", "1", "2"]
    assert axes.get_xlabel() == "error, in units of 1/65536 pixel" and not axes.texts
    for entry in entries:
        entry["histogram"][2]["upto"] = 2 ** 20
    (axes,) = report_plots.histogram("vertex", entries, "h").axes
    assert [text.get_text() for text in axes.texts] == ["1 pixel"] and lines(axes)[-1] == [(16, 0), (16, 1)]
    assert ticks(axes) == ["≤ 2⁻⁶", "2⁻³", "1", "8", "64", "512", "2¹²", "2¹⁵", "2¹⁸"]


def test_a_histogram_of_pixels_has_whole_ones(figures):
    entries = [{"design": name, "unit": "pixels", "samples": 4, "histogram": [{"upto": 0, "count": 3}, {"upto": 1, "count": 1}]}
               for name in report_plots.ORDER]
    (axes,) = report_plots.histogram("fill", entries, "h").axes
    assert ticks(axes) == ["0", "1"] and axes.get_xlabel() == "error, in pixels"


def test_the_picture_has_every_power_of_ten_that_it_names(monkeypatch):
    seen = []
    monkeypatch.setattr(report_plots.Figure, "savefig", lambda figure, *_, **__: seen.append(figure))
    points = [{"value": value, "max": most} for value, most in ((1 / 64, PIXEL), (1, 32), (1024, 64 * PIXEL))]
    report_plots.picture_bytes([{"design": name, "points": points} for name in report_plots.ORDER])
    (axes,) = seen[0].axes
    assert list(axes.get_yticks()) == [100, 1, 0.01, 1e-4, 1 / PIXEL]
    assert [label.get_text() for label in axes.get_yticklabels()] == ["100 pixels", "1 pixel", "1/100", "1/10,000", "1/65,536"]
    assert lines(axes)[:3] == 3 * [[(1 / 64, 1), (1, 32 / PIXEL), (1024, 64)]]
    assert [(text.get_text().partition(":")[0], text.xy) for text in axes.texts] == \
        [("16.16, plain port", (1024, 64)), ("float32", (1 / 64, 1)), ("Fixel", (1, 32 / PIXEL))]
    assert "up to 64 pixels" in axes.texts[0].get_text()
