# SPDX-License-Identifier: MIT
"""What make bench, bench-diff and bench-baseline make of results: rows, goals, the page, what became worse. Nothing is measured here."""

import copy
import json
import re
import subprocess
import types

import numpy
import pytest

from conftest import CHECKOUT, assert_one_sentence, run_cli
from fixel.base.errors import ToolError
from fixel.bench import bench, bench_goals, bench_page, bench_plan, bench_plots, bench_rows, linked_size

BUILT_PROGRAMS = ()
BASELINE, DOCUMENT = CHECKOUT / "bench/baseline.json", CHECKOUT / "docs/performance.md"


@pytest.fixture(scope="module")
def plan():
    return bench_plan.Plan(CHECKOUT / "build")


@pytest.fixture(scope="module")
def baseline():
    return json.loads(BASELINE.read_text(encoding="utf-8"))


def test_a_row_and_its_ratios_by_hand():
    workload = {"name": "w", "unit": "face", "limit": "limit-x", "limit_units": 2}
    some_plan = types.SimpleNamespace(workloads={"w": workload}, kernels={})
    drawn = types.SimpleNamespace(instructions=[10, 20, 31], memory=7, stack=8)
    slow = types.SimpleNamespace(instructions=[100, 100, 44], memory=0, stack=0)
    rows = [bench_rows.frame_row("m3", workload, "fixel", drawn, 5),
            bench_rows.frame_row("m3", workload, "listing-double", slow, 5),
            bench_rows.frame_row("m0", workload, "fixel", drawn, 5)]
    bench_rows.add_ratios(some_plan, rows, [{"core": "m3", "name": "limit-x", "per_unit": 0.5}])
    assert rows[0] == {"workload": "w", "renderer": "fixel", "core": "m3", "instructions": 61,
                       "frame": {"min": 10, "mean": 20, "max": 31}, "per_unit": 4.0667, "unit": "face",
                       "ratio_to_listing_double": 0.25, "ratio_to_limit": 4.0667, "text_bytes": None,
                       "ram_bytes": 7, "stack_bytes": 8}
    assert rows[2]["ratio_to_listing_double"] is None and rows[2]["ratio_to_limit"] is None


def test_a_renderer_that_draws_something_else_is_refused():
    plan = types.SimpleNamespace(workloads={"w1": {}, "f32": {"judged": "covered"}})
    row = {"core": "m3", "workload": "w1", "renderer": "listing-float", "pixels": 1000, "differing": 2, "uncovered": 2}
    bench.check_pictures(plan, [row, {**row, "workload": "f32", "differing": 1000}])
    for wrong in ({**row, "differing": 3}, {**row, "workload": "f32", "uncovered": 3}):
        with pytest.raises(ToolError, match="3 of 1,000 pixels") as refused:
            bench.check_pictures(plan, [wrong])
        assert refused.value.exit_code == 1


def test_which_pixels_differ_and_which_only_one_draws():
    def drawn(*pixels):
        return types.SimpleNamespace(pixels=numpy.array(pixels, dtype=numpy.uint8))
    (row,) = bench_rows.pictures({("m3", "w1", "fixel"): drawn(0, 0, 5, 5, 5),
                                  ("m3", "w1", "listing-float"): drawn(0, 5, 0, 6, 5)})
    assert row == {"core": "m3", "workload": "w1", "renderer": "listing-float", "pixels": 5, "differing": 3,
                   "uncovered": 2}


def test_a_variant_that_draws_something_else_is_refused():
    frames = numpy.zeros((1, 2, 3), dtype=numpy.uint8)
    drawn = {("m3", "w1", "fixel"): types.SimpleNamespace(instructions=[200, 200], pixels=frames)}
    other = types.SimpleNamespace(instructions=[300, 301], pixels=frames.copy(), memory=7, stack=8)
    others = {("m3", "w1", "bands"): other}
    bench.check_variants(drawn, others)
    assert bench_rows.variants(drawn, others) == [{"variant": "bands", "workload": "w1", "core": "m3", "frame": 300,
                                                   "fixel": 200, "by_fixel": 1.5025, "ram_bytes": 7, "stack_bytes": 8}]
    other.pixels[0, 1, 1] = 1
    with pytest.raises(ToolError, match="fixel-bands on m3 draws w1 unlike fixel: 1 pixels") as refused:
        bench.check_variants(drawn, others)
    assert refused.value.exit_code == 1


def test_the_map_tells_helpers_from_memory_functions(tmp_path):
    file = tmp_path / "x.map"
    file.write_text("Discarded\n .text.gone 0x0 0x100 a.o\nLinker script and memory map\n"
                    " .text.f        0x00000100       0x20 a.o\n .rodata.t       0x00000120        0x8 a.o\n"
                    " .text.fxl_a_long_name\n                0x00000128        0x4 b.o\n .bss           0x20000000       0x10 b.o\n"
                    " .text          0x00000130       0x30 /usr/lib/gcc/libgcc.a(_udivmoddi4.o)\n"
                    " .text          0x00000130        0x0 /usr/lib/gcc/libgcc.a(_empty.o)\n"
                    " .text.memset   0x00000160       0x10 build/memory_functions.o\n")
    assert linked_size.sizes_of_map(file) == {"code": 0x24, "constants": 8, "run_time": 0x40, "ram": 0x10,
                                      "helpers": ["_udivmoddi4"], "files": {"a": 0x28, "b": 4}}
    file.write_text("nothing")
    with pytest.raises(ToolError, match="not a linker's map"):
        linked_size.sizes_of_map(file)


def figures(result):
    return {goal["goal"]: (goal["figure"], goal["met"]) for goal in bench_goals.measure(result)}


def test_goals_of_the_baseline_are_those_of_its_rows(baseline):
    assert baseline["goals"] == bench_goals.measure(baseline)
    assert all(goal["met"] is not None for goal in baseline["goals"])


def goal_result():
    """As much of a result as the goals read, of round numbers."""
    def row(workload, core, mean, renderer="fixel", **more):
        return {"workload": workload, "renderer": renderer, "core": core, "per_unit": 10.0, "stack_bytes": 572,
                "ram_bytes": 4048, "frame": {"min": 1, "mean": mean, "max": mean * 1.45}, **more}

    def size(flags, code, constants):
        return {"core": "m3", "renderer": "fixel", "flags": flags, "code": code, "constants": constants,
                "run_time": 140, "helpers": []}

    def variant(name, workload, frame):
        return {"variant": name, "workload": workload, "core": "m3", "frame": frame, "by_fixel": 1.5}
    return {
        "rows": [row("w1", "m3", 130_000), row("w1-turning", "m3", 141_700, stack_bytes=800), row("w2", "m3", 16_000, stack_bytes=573), row("g2000", "m3", 1_850_001),
                 row("plaza", "m3", 540_000), row("rgb565-noise", "m3", 0, frame=None, stack_bytes=None, per_unit=3.31),
                 row("w1", "m4f", 130_000), row("sine", "m3", 0, frame=None, stack_bytes=None),
                 row("sine", "m55", 0, frame=None, stack_bytes=None, per_unit=10.1),
                 row("w1", "m4f", 260_000, "listing-float"), row("g2000", "m4f", 1_850_001, "listing-float"),
                 row("w1", "m3", 10, "listing-float")],
        "sizes": [size("-Os", 10_400, 200), size("-Os -DFXL_SMALL", 7801, 200)],
        "variants": [variant("bands", "plaza", 4_000_001), variant("os", "w1", 185_000), variant("small", "w1", 400_000),
                     variant("rgb565", "plaza", 540_000 + 3 * 38_400), variant("small", "w3", 727_000), variant("small", "g2000", 4_500_000),
                     {**variant("arduino", "w1", 1), "by_fixel": 1.02}, {**variant("arduino", "crates", 1), "by_fixel": 1.0501}],
        "peers": [{"name": "small3dlib, -Os", "variant": "small", "core": "m3",
                   "frames": {"w3": 1_454_000, "f32": 1, "g2000": 2_250_000}}],
        "growth": [{"axis": axis, "objects": objects, "faces": faces, "pixels": 5, "instructions": instructions}
                   for axis, points in {"cubes seen": ((100, 7, 1000), (400, 7, 1300), (1600, 7, 2500)),
                                        "faces, one model": ((1, 500, 1000), (1, 1000, 1500), (1, 2000, 2800))}.items()
                   for objects, faces, instructions in points],
        "renderer_bytes": {"m3": 2528},
        "budgets": {"a point light, a face": 120.5},
        "faces": [{"kind": "flat", "radius": radius, "core": "m3", "frame": frame, "without": without}
                  for radius, frame, without in ((0.6, 90, 100), (5, 101, 100), (8, 300, None))],
        "programs": {"cube, -Os": {"flash": 12_000, "of_other_pixels": []},
                     "crate, -Os": {"flash": 29_697, "of_other_pixels": ["fxl_draw_outline_rgb565"]}},
        "cycles_estimate": [{"workload": "w1", "core": "m3", "model": "cortex-m3", "cycles": [250_001, 1]}],
        "rgb565": [{"workload": workload, "core": "m3", "way": way, "frame": frame, "cycles": {"cortex-m3": [7, 9], "cortex-m4": [5, 6]}}
                   for workload, way, frame in (("tqp", "a", 800_001), ("tqp", "b", 800_000), ("crates, levels", "a", 687_500),
                                                ("crates, 480x320", "a", 1_380_000), ("crates, 240x135", "a", 550_000))] +
        [{"workload": "c500-depth", "core": "rv32", "way": "RGB565", "frame": 1_600_000, "cycles": {}}]}


@pytest.mark.parametrize("goal, figure, met", [
    ("W1, a frame, M3", 130_000, True),
    ("a flat program links, bytes, -Os, M3", 12_000, True),
    ("a textured and lit program links, bytes, -Os, M3", 29_697, False),
    ("a flat program to RGB565 links, bytes, -Os, M3", None, None),
    ("programs that link kernels of pixels that they do not draw, M3", 1, False),
    ("g2000, a frame, M3", 1_850_001, False),
    ("W1 with every cube turning, by W1, M3", 1.09, False),
    ("W1, worst frame by the mean, M3", 1.45, True),
    ("W1 on M3, by the listing in hard float on M4F", 0.5, False),
    ("M3 by the listing in hard float on M4F, the worst scene", 1.0, False),
    ("M4F by M3, the slowest of all workloads and kernels", 1.0, True),
    ("M55 by M3, the slowest of all workloads and kernels", 1.01, False),
    ("plaza, a frame in bands of three rows, M3", 4_000_001, False),
    ("W3, a frame in bands of three rows, M3", None, None),
    ("plaza to RGB565, a pixel, M3", 1.5, True),
    ("plaza to RGB565, a pixel, M0", None, None),
    ("noise to RGB565, a pixel, M3", 3.31, False),
    ("growth with cubes in sight", 1.0, True),
    ("growth with faces of one model", 1.3, False),
    ("growth with faces in patches", None, None),
    ("code and constants, bytes, -Os, M3", 10_600, True),
    ("W1, a frame, -Os, M3", 185_000, True),
    ("code and constants, bytes, -Os -DFXL_SMALL, M3", 8001, False),
    ("W1, a frame, -Os -DFXL_SMALL, M3", 400_000, False),
    ("-Os -DFXL_SMALL by small3dlib -Os, the worst of five scenes, M3", 2.0, False),
    ("functions of the compiler's arithmetic that are linked, M3", 0, True),
    ("stack, bytes, the deepest of all workloads without placements and textures, M3", 573, False),
    ("a renderer, bytes of RAM, M3", 2528, True),
    ("tqp to RGB565, a frame, M3", 800_000, True),
    ("tqp to RGB565, a frame, M0", None, None),
    ("c500-depth to RGB565, a frame, RV32IMC", 1_600_000, True),
    ("W1, a frame, RV32IMC", None, None),
    ("flat faces of 0.6 to 8 pixels, the worst by itself without the way of tiny faces, M3", 1.01, False),
    ("flat faces of 0.6 to 8 pixels, the worst by itself without the way of tiny faces, M0", None, None),
    ("the packages by Arduino's -Os, the worst scene by make lib, M3", 1.0501, False),
    ("one file, the worst scene by make lib, M0", None, None),
    ("tqp to RGB565, ESTIMATE of cycles, M4", 5, True),
    ("w1, ESTIMATE of cycles, M3", 250_001, False),
    ("a point light, a face", 120.5, False),
    ("a point light, a face turned away from it", None, None),
    ("textures of other sizes, levels, clamp, moved frames, other screens and bands, by the goal", 1.2545, False),
])
def test_goals_by_hand(goal, figure, met):
    assert figures(goal_result())[goal] == (figure, met)


def test_a_goal_says_which_scenes_are_worst():
    notes = {goal["goal"]: goal["note"] for goal in bench_goals.measure(goal_result())}
    assert notes["M3 by the listing in hard float on M4F, the worst scene"] == "g2000 1.000, w1 0.500"
    assert notes["plaza, a frame in bands of three rows, M3"] == "1.50 times -O2 in one band"
    assert notes["tqp to RGB565, a frame, M3"] == "b; 7 cycles without wait states; 9 cycles at 72 MHz with two wait states"
    assert notes["textures of other sizes, levels, clamp, moved frames, other screens and bands, by the goal"] == \
        "crates, 480x320 1.255, crates, levels 1.250, crates, 240x135 1.000"
    assert "textures of 4 bits, with a key, stippled, by the goal" not in notes     # it has no variants of these


def test_tables_of_estimates_and_of_growth_by_hand():
    estimate = {"workload": "w1", "core": "m3", "title": "a board", "cycles": [1000, 2000]}
    assert bench_page.estimates_markdown(None, {"cycles_estimate": [estimate]}).splitlines() == [
        "| a frame | on | ESTIMATE of cycles, without wait states | ESTIMATE of cycles, at 72 MHz with two wait states |",
        "| --- | --- | ---: | ---: |", f"| w1, code for {bench_plan.NAMES['m3']} | a board | 1,000 | 2,000 |"]
    growth = [{"axis": axis, "factor": factor, "objects": 1, "faces": 500 * factor, "pixels": 76800, "instructions": instructions}
              for axis, factor, instructions in (("faces", 1, 1000), ("faces", 3, 2500), ("cubes", 1, 400), ("cubes", 2, 1000))]
    assert bench_page.growth_markdown(None, {"growth": growth}).splitlines()[1:] == [
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
        "| faces | 1 | 1 | 500 | 76,800 | 1,000 | 1.00 |", "| faces | 3 | 1 | 1,500 | 76,800 | 2,500 | 2.50 |",
        "| cubes | 1 | 1 | 500 | 76,800 | 400 | 1.00 |", "| cubes | 2 | 1 | 1,000 | 76,800 | 1,000 | 2.50 |"]
    assert bench_page.growth_markdown(None, {"growth": []}).startswith("Not measured")


def compare(folder, before, after, *options):
    """bench-diff of two results."""
    for name, data in (("before.json", before), ("after.json", after)):
        (folder / name).write_text(json.dumps(data))
    return run_cli("bench-diff", "--baseline", folder / "before.json", "--current", folder / "after.json", *options)


def changed(baseline, factor, renderer="fixel", measure="instructions"):
    """The baseline with one row other, and that row's words."""
    result = copy.deepcopy(baseline)
    row = next(row for row in result["rows"] if (row["workload"], row["renderer"], row["core"]) == ("w1", renderer, "m3"))
    row[measure] = round(row[measure] * factor)
    return result


def test_nothing_changed(tmp_path, baseline):
    done = compare(tmp_path, baseline, baseline)
    assert done.returncode == 0 and "nothing changed" in done.stdout


@pytest.mark.parametrize("factor, measure, renderer, code, words", [
    (1.02, "instructions", "fixel", 1, "WORSE: w1 fixel m3: slower by 2.00 %"),
    (0.98, "instructions", "fixel", 0, "faster"),
    (1.004, "instructions", "fixel", 0, "slower, hardly"),
    (1.5, "instructions", "listing-double", 0, "slower"),
    (1.25, "stack_bytes", "fixel", 1, "WORSE: w1 fixel m3: deeper by 25.00 %"),
    (1.25, "text_bytes", "fixel", 1, "WORSE: all fixel m3: larger by 25.0"),
])
def test_what_became_worse_and_by_how_much(tmp_path, baseline, factor, measure, renderer, code, words):
    done = compare(tmp_path, baseline, changed(baseline, factor, renderer, measure))
    assert done.returncode == code and words in done.stdout


def test_the_threshold(tmp_path, baseline):
    assert compare(tmp_path, baseline, changed(baseline, 1.02), "--threshold", 3).returncode == 0


def test_what_is_missing_and_what_is_new(tmp_path, baseline):
    less = {**baseline, "rows": baseline["rows"][1:]}
    done = compare(tmp_path, baseline, less)
    assert done.returncode == 1 and "WORSE: w1 fixel m0: not measured any more" in done.stdout
    others = {**baseline, "left_out": ["rv32"], "rows": [row for row in baseline["rows"] if row["core"] != "rv32"]}
    done = compare(tmp_path, baseline, others)
    assert done.returncode == 0 and "not compared, because no board has the core: rv32" in done.stdout
    assert compare(tmp_path, baseline, {**others, "left_out": []}).returncode == 1
    done = compare(tmp_path, less, {**baseline, "compiler": "another one"})
    assert done.returncode == 0 and "new: w1 fixel m0" in done.stdout and "note: another compiler" in done.stderr


@pytest.mark.parametrize("text, words", [(None, "run make bench"), ("{}", "is not a result of make bench"),
                                         ("{", "after.json")])
def test_no_result_is_one_sentence(tmp_path, text, words):
    if text is not None:
        (tmp_path / "after.json").write_text(text)
    assert_one_sentence(run_cli("bench-diff", "--current", tmp_path / "after.json"), words)


def test_accepting_renews_baseline_and_document(tmp_path, baseline):
    faces = DOCUMENT.with_name("faces.md")
    for page in (DOCUMENT, faces):
        (tmp_path / page.name).write_text(page.read_text(encoding="utf-8"))
    (tmp_path / "now.json").write_text(json.dumps(changed(baseline, 1.0)))
    options = ["--accept", "--baseline", tmp_path / "baseline.json", "--current", tmp_path / "now.json",
               "--document", tmp_path / "performance.md"]
    assert run_cli("bench-diff", *options).returncode == 0
    assert json.loads((tmp_path / "baseline.json").read_text()) == baseline
    assert all((tmp_path / page.name).read_bytes() == page.read_bytes() for page in (DOCUMENT, faces, faces.with_suffix(".png")))
    for less, words in (({"left_out": ["m55"]}, "m55"),
                        ({"rows": [row for row in baseline["rows"] if row.get("workload") != "w2"]}, "w2 was not measured"),
                        ({"rows": [row for row in baseline["rows"] if row["core"] != "m0"]}, "m0 was not measured"),
                        ({"rows": [row for row in baseline["rows"] if row["core"] != "rv32"]}, "rv32 was not measured")):
        (tmp_path / "now.json").write_text(json.dumps({**baseline, **less}))
        assert_one_sentence(run_cli("bench-diff", *options), words)
        assert json.loads((tmp_path / "baseline.json").read_text()) == baseline


def test_the_make_commands_are_there():
    done = subprocess.run(["make", "help"], cwd=CHECKOUT, capture_output=True, text=True, check=True)
    for command in ("bench", "bench-diff", "bench-baseline", "profile"):
        assert f"make {command} " in done.stdout


@pytest.mark.parametrize("value, text", [
    (None, "-"), (1234567, "1,234,567"), (1234.6, "1,235"), (1000.0, "1,000"), (999.94, "999.9"), (10.0, "10.0"),
    (9.994, "9.99"), (1.0, "1.00"), (0.99949, "0.999")])
def test_a_number_of_a_table_has_three_digits_or_more(value, text):
    header, ruler, row = bench_page.markdown_table(["a", "b"], [["x", bench_page._number(value)]]).splitlines()
    assert (header, ruler, row) == ("| a | b |", "| --- | ---: |", f"| x | {text} |")


def test_the_document_s_tables_are_made_from_the_baseline(baseline, plan):
    text = DOCUMENT.read_text(encoding="utf-8")
    assert bench_page.replace_tables(text, plan, baseline, bench_page.DOCUMENT) == text
    assert set(re.findall("bench: ([a-z0-9]+) ", text)) == {*bench_page.DOCUMENT, "end"}
    faces = DOCUMENT.with_name("faces.md").read_text(encoding="utf-8")
    assert bench_page.replace_tables(faces, plan, baseline, bench_page.FACES_PAGE) == faces


def test_a_document_without_a_table_is_refused(baseline, plan):
    text = DOCUMENT.read_text(encoding="utf-8").replace("bench: kernels", "kernels")
    with pytest.raises(ToolError, match="0 places for the table 'kernels'"):
        bench_page.replace_tables(text, plan, baseline, bench_page.DOCUMENT)


def test_the_report_has_every_table_and_no_mark(baseline, plan):
    text = bench_page.report(plan, baseline)
    for make in bench_page.SECTIONS.values():
        assert make(plan, baseline) in text
    assert "<!--" not in text and text.startswith("# What a frame costs\n")


def test_every_goal_that_is_not_met_is_not_hidden(baseline, plan):
    missed = copy.deepcopy(baseline)
    missed["goals"][0].update(met=False, account="the reason")
    for result in (baseline, missed):
        text = bench_page.report(plan, result)
        assert text.count("| not met |") == sum(goal["met"] is False for goal in result["goals"])
    assert f"- {missed['goals'][0]['goal']}: the reason" in text


def test_plots_are_the_same_twice(baseline, plan):
    assert bench_plots.files(plan, baseline) == bench_plots.files(plan, baseline)
