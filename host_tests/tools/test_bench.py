# SPDX-License-Identifier: MIT
"""make bench, bench-diff and bench-baseline: what they write, that it repeats, and what they judge."""

import copy
import json
import re
import subprocess
import types

import numpy
import pytest
from elftools.elf.elffile import ELFFile

from fixel.bench import bench
from conftest import CHECKOUT, assert_one_sentence, run_cli
from fixel.bench import bench_budgets, bench_changes, bench_goals, bench_page, bench_plan, bench_plots, bench_rgb565, bench_rows, bench_run, linked_size
from fixel.board import dump
from fixel.image import image
from fixel.base.errors import ToolError

pytestmark = pytest.mark.usefixtures("bench_programs")
BASELINE, DOCUMENT = CHECKOUT / "bench/baseline.json", CHECKOUT / "docs/performance.md"
ROW = {"workload", "renderer", "core", "instructions", "frame", "per_unit", "unit", "ratio_to_listing_double",
       "ratio_to_limit", "text_bytes", "ram_bytes", "stack_bytes"}
RENDERERS = {"fixel", "listing-double", "listing-float", "memset"}
VARIANTS = {"os", "small", "arduino", "one-file", "bands", "rgb565"}
DRAWN = ("w1", "w2", "w3", "g2000")     # of the scenes, by a test: the others take as long as all these together


@pytest.fixture(scope="module")
def plan():
    return bench_plan.Plan(CHECKOUT / "build")


@pytest.fixture(scope="module")
def baseline():
    return json.loads(BASELINE.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    """bench.json of a run on the M3 without most of the scenes, its folder, and what it printed."""
    folder = tmp_path_factory.mktemp("bench") / "out"
    done = run_cli("bench", "--cores", "m3", "--left-out", "m0", "m4f", "m55", "--workloads", *DRAWN, "--out", folder)
    assert done.returncode == 0, done.stderr
    return (folder / "bench.json").read_text(), folder, done.stdout


# --- turned instances ---------------------------------------------------------------

def test_placements_that_turn_nothing_draw_the_same(plan, tmp_path):
    drawn = {name: bench_run.draw(plan, "m3", "fixel", bench_plan.compile_scene(plan.workloads[name], tmp_path)[0], 3)
             for name in ("w1", "w1-still", "w1-turning")}
    assert (drawn["w1"].pixels == drawn["w1-still"].pixels).all()
    frames = drawn["w1-turning"].pixels
    assert (frames != drawn["w1"].pixels).any() and sum(drawn["w1-still"].instructions) > sum(drawn["w1"].instructions)


def test_each_cube_turns_in_its_own_place(plan, tmp_path):
    file, turning = bench_plan.compile_scene(plan.workloads["w1-turning"], tmp_path)
    read = image.load(file)
    assert [motion.keys[0].centre for motion in read.motions] == [item.centre for item in turning.objects]
    assert len(read.placements) == len(read.objects) == 100
    assert len({(motion.steps, motion.keys[0].angles) for motion in read.motions}) == 100


# --- a run --------------------------------------------------------------------------

def test_a_second_run_counts_the_same(measured, plan, tmp_path):
    """Of one workload by each renderer that draws it, and of all kernels."""
    result = json.loads(measured[0])
    workload = plan.workloads["w1"]
    image, scene = bench_plan.compile_scene(workload, tmp_path)
    again = [bench_rows.frame_row("m3", workload, renderer, bench_run.draw(plan, "m3", renderer, image),
                                  bench_plan.units_of(workload, scene))
             for core, name, renderer in plan.runs(["m3"]) if name == "w1"]
    kernels, limits = bench_rows.split_kernels(plan, "m3", bench_run.kernels(plan, "m3"))
    counted = ("core", "workload", "renderer", "instructions", "frame", "per_unit", "unit")
    figures = [[row[key] for key in counted] for row in result["rows"]]
    assert len(again) >= 2 and len(kernels) >= 10
    assert all([row[key] for key in counted] in figures for row in [*again, *kernels])
    assert limits == result["limits"]


def test_a_run_writes_tables_and_plots_and_prints_the_goals(measured):
    text, folder, printed = measured
    assert {path.name for path in folder.iterdir()} == set(bench.PATTERNS)
    assert (folder / "bench.png").read_bytes()[:4] == b"\x89PNG"
    goals = json.loads(text)["goals"]
    for goal in goals:
        assert goal["goal"] in printed
    assert f"{sum(goal['met'] is True for goal in goals)} of {len(goals)} goals met" in printed
    # Of other cores than the M3 nothing was measured, nor of the scenes that were left out, and that is what is said.
    budgets = {entry["name"] for entry in bench_plan.Plan(CHECKOUT / "build").budgets}
    unknown = [goal for goal in goals if goal["goal"] in budgets or
               re.search("M0|M4F|M55|plaza|W3b|c500|e300|f32|every cube|program|to RGB565, (a frame|ESTIMATE)", goal["goal"])]
    assert [goal["figure"] for goal in unknown] == [None] * len(unknown) and len(unknown) > 10
    assert all(goal["figure"] is not None for goal in goals if goal not in unknown)


def check_rows(rows, plan, cores, drawn):
    """Rows as they are promised: every key, null where it means nothing, every workload and kernel."""
    keys = [(row["core"], row["workload"], row["renderer"]) for row in rows]
    assert len(keys) == len(set(keys))
    kernels = [name for name in plan.kernels if not name.startswith(bench_rows.LIMIT)]
    runs = [run for run in plan.runs(cores) if run[1] in drawn]
    assert set(keys) == {*runs, *[(core, name, "fixel") for core in cores for name in kernels]}
    for row in rows:
        assert set(row) == ROW
        assert row["renderer"] in RENDERERS and row["core"] in bench_plan.CORES
        assert isinstance(row["instructions"], int) and row["instructions"] > 0 and row["per_unit"] > 0
        for name in ("ratio_to_listing_double", "ratio_to_limit"):
            assert row[name] is None or row[name] > 0
        if row["workload"] in plan.workloads:
            frame = row["frame"]
            assert set(frame) == {"min", "mean", "max"} and 0 < frame["min"] <= frame["mean"] <= frame["max"]
            assert (row["ratio_to_listing_double"] is None) == ("by" in plan.workloads[row["workload"]])
            assert row["text_bytes"] > 0 and row["stack_bytes"] > 0 and row["ram_bytes"] >= 0
        else:
            assert [row[name] for name in ("frame", "ratio_to_listing_double", "text_bytes", "ram_bytes",
                                           "stack_bytes")] == [None] * 5
    doubles = [row["ratio_to_listing_double"] for row in rows if row["renderer"] == "listing-double"]
    assert doubles and set(doubles) == {1.0}


def test_rows_of_a_run(measured, plan):
    result = json.loads(measured[0])
    check_rows(result["rows"], plan, ["m3"], DRAWN)
    assert result["left_out"] == ["m0", "m4f", "m55"]


def test_rows_of_the_baseline(baseline, plan):
    check_rows(baseline["rows"], plan, bench_plan.CORES, plan.workloads)
    assert baseline["left_out"] == []


def test_the_stages_and_functions_add_up_to_the_frames(measured, plan):
    result = json.loads(measured[0])
    for workload in set(plan.stages["workloads"]) & set(DRAWN):
        stages = [row for row in result["stages"] if row["workload"] == workload]
        (row,) = [row for row in result["rows"] if row["workload"] == workload and row["renderer"] == "fixel"]
        assert sum(stage["instructions"] for stage in stages) == row["instructions"] + stages[0]["frames"]
        assert all(sum(stage["functions"].values()) == stage["instructions"] for stage in stages)


def test_the_plan_has_all_workloads_and_kernels(plan):
    assert list(plan.workloads) == ["w1", "w1-still", "w1-turning", "w2", "w3", "w3b", "plaza", "plaza-turned",
                                    "plaza-textured", "c500", "e300", "f32", "f32p", "g2000"]
    assert set(plan.renderers) == RENDERERS and set(plan.variants) == VARIANTS
    assert {"multiply", "divide", "reciprocal", "root", "sine", "transform", "outcode", "project", "clip",
            "edge-setup", "span-1", "span-320", "rgb565-noise"} <= set(plan.kernels)


def test_workloads_drawn_as_something_else(tmp_path):
    """Beside what their scenes ask for, and no report, which the baseline could be taken of."""
    done = run_cli("bench", "--cores", "m3", "--workloads", "w2", "--pixels", "rgb565", "--depth", "16", "--out", tmp_path)
    assert done.returncode == 0, done.stderr
    found = json.loads((tmp_path / "target.json").read_text(encoding="utf-8"))
    assert (found["pixels"], found["order"], found["depth"]) == ("rgb565", None, "16")
    row, = found["rows"]
    assert row["workload"] == "w2" and row["asked"] > row["scene"] > 320 * 240 / 8
    assert "PIXELS=rgb565 DEPTH=16" in done.stdout and [file.name for file in tmp_path.iterdir()] == ["target.json"]
    done = run_cli("bench", "--cores", "m3", "--workloads", "w2", "--order", "tree", "--out", tmp_path)
    assert_one_sentence(done, "ORDER=tree needs a tree, and scenes/w2.toml has none")


def test_an_unknown_workload_is_one_sentence():
    assert_one_sentence(run_cli("bench", "--cores", "m3", "--workloads", "w1", "w9"), "no workload 'w9'", "g2000")


# --- rows by hand -------------------------------------------------------------------

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
                                                   "by_fixel": 1.5025, "ram_bytes": 7, "stack_bytes": 8}]
    other.pixels[0, 1, 1] = 1
    with pytest.raises(ToolError, match="fixel-bands on m3 draws w1 unlike fixel: 1 pixels") as refused:
        bench.check_variants(drawn, others)
    assert refused.value.exit_code == 1


@pytest.mark.parametrize("flags", ["Os", "small", "small-flto"])
def test_bytes_of_the_map_are_those_of_the_program(flags):
    folder = CHECKOUT / "build/bench/m3/size" / flags
    found = linked_size.sizes_of_map(folder / "fixel.map")
    with (folder / "fixel.elf").open("rb") as file:
        elf = ELFFile(file)
        sections = [section for section in elf.iter_sections() if section["sh_flags"] & 2]
        names = {symbol.name for symbol in elf.get_section_by_name(".symtab").iter_symbols()}
    whole = sum(section["sh_size"] for section in sections if section["sh_type"] != "SHT_NOBITS")
    parts = found["code"] + found["constants"] + found["run_time"]
    assert parts <= whole <= parts + 64         # the linker fills up to words' ends
    assert {"fxl_frame_begin", "fxl_frame_draw"} <= names
    assert bool(found["helpers"]) == bool({name for name in names if re.match(r"__(aeabi_u?l?(div|idiv|mul)|clz|u?div|mul)", name)})


def test_by_flto_the_library_is_one_file_and_the_memory_functions_stay_outside():
    apart, together = (linked_size.sizes_of_map(CHECKOUT / "build/bench/m3/size" / flags / "fixel.map")
                       for flags in ("small", "small-flto"))
    assert list(together["files"]) == ["ltrans0"]       # not the linker's name of it, which is new with each link
    assert together["run_time"] == apart["run_time"] > 0
    assert together["code"] + together["constants"] < apart["code"] + apart["constants"]


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


# --- frames as pixels of RGB565, and steps ------------------------------------------

def test_the_generated_head_is_closed_and_has_968_triangles(tmp_path):
    bench_changes.write_head(tmp_path)
    rows = [line.split() for line in (tmp_path / bench_changes.HEAD).read_text().splitlines()]
    faces = [[int(word) for word in words[1:]] for words in rows if words[0] == "f"]
    edges = {(face[i], face[(i + 1) % 3]) for face in faces for i in range(3)}
    assert len(faces) == 968 and len(edges) == 3 * 968
    assert {(b, a) for a, b in edges} == edges
    assert {corner for face in faces for corner in face} == set(range(1, 1 + sum(words[0] == "v" for words in rows)))


def test_the_head_s_frames_have_the_counts_that_its_scene_states(plan, tmp_path):
    """272 faces turned to the eye, 88 drawn, 2,000 pixels, to within a tenth."""
    image, _ = bench_plan.compile_scene({"name": "head", **plan.rgb565["head"], "with": []}, tmp_path)
    dumped = tmp_path / "head.fxld"
    subprocess.run([CHECKOUT / "build/host/frames", image, dumped], check=True, capture_output=True)
    frames = dump.read_dump(dumped).frames
    mean = {name: sum(frame.counters[name] for frame in frames) / len(frames) for name in frames[0].counters}
    assert len(frames) == 12
    assert abs(mean["in"] - mean["backfacing"] - 272) <= 27 and abs(mean["drawn"] - 88) <= 8.8
    assert abs(sum(int((frame.pixels != 0).sum()) for frame in frames) / 12 - 2000) <= 200


@pytest.mark.parametrize("change", [name for name in bench_changes.CHANGES if name != "textured"])
def test_a_change_changes_the_scene(tmp_path, change):
    if change in ("smooth", *bench_changes.POINTS):
        path, before = "bench/scenes/egg.toml", []
    else:
        path, before = "bench/scenes/tqp.toml", ["rgb565"] if change == "16 bits" else []
    made = [image.pack(bench_changes.compile_file(CHECKOUT / path, names, tmp_path)) for names in (before, [*before, change])]
    assert made[0] != made[1]


def test_every_way_draws_the_same_outline(plan, tmp_path):
    """What is drawn to a palette and what is drawn to RGB565 covers the same pixels."""
    drawn = []
    for program, changes in bench_rgb565.WAYS.values():
        image, _ = bench_plan.compile_scene({**plan.rgb565["head"], "with": [change for change in changes if change == "rgb565"]},
                                            tmp_path)
        drawn.append(bench_run.draw(plan, "m3", program, image, 1).pixels != 0)
    assert drawn[0].any() and all((one == drawn[0]).all() for one in drawn)


def test_named_workloads_are_drawn_with_their_variants_and_others_without(plan):
    named = bench_plan.Plan(CHECKOUT / "build")
    named.keep(["tqp", "w1-flat", "w1"])
    assert list(named.workloads) == ["w1"] and list(named.rgb565) == ["tqp", "w1-flat"]
    shown = {(entry["name"], variant) for _, entry, variant, _ in bench_rgb565._jobs(named, ["m3", "m0"])}
    assert {("tqp", None), ("tqp", "levels"), ("tqp", "bands of 8"), ("w1-flat", "rolled")} <= shown
    assert ("w1-flat", "levels") not in shown
    jobs = list(bench_rgb565._jobs(plan, ["m3", "m0"]))
    assert all(variant is None for _, _, variant, _ in jobs)
    assert {core for core, entry, _, _ in jobs if entry["name"] == "tqp"} == {"m3", "m0"}
    assert {core for core, entry, _, _ in jobs if entry["name"] == "tqpl"} == {"m3"}


def test_rows_and_pixels_are_slopes(monkeypatch):
    """A frame of 1,000 instructions, 50 more a row and 6 more a pixel."""
    monkeypatch.setattr(bench_budgets._Frames, "on", lambda self, screen: 1000 + 50 * screen[1] + 6 * screen[0] * screen[1])
    frames = bench_budgets._Frames(None, {}, None)
    assert bench_budgets.KINDS["pixel"](frames) == 6 and bench_budgets.KINDS["row"](frames) == 50


# --- goals --------------------------------------------------------------------------

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
                     variant("rgb565", "plaza", 540_000 + 3 * 38_400), variant("small", "w3", 727_000), variant("small", "g2000", 4_500_000)],
        "peers": [{"name": "small3dlib, -Os", "variant": "small", "core": "m3",
                   "frames": {"w3": 1_454_000, "f32": 1, "g2000": 2_250_000}}],
        "growth": [{"axis": axis, "objects": objects, "faces": faces, "pixels": 5, "instructions": instructions}
                   for axis, points in {"cubes seen": ((100, 7, 1000), (400, 7, 1300), (1600, 7, 2500)),
                                        "faces, one model": ((1, 500, 1000), (1, 1000, 1500), (1, 2000, 2800))}.items()
                   for objects, faces, instructions in points],
        "renderer_bytes": {"m3": 2528},
        "budgets": {"a point light, a face": 120.5},
        "programs": {"cube, -Os": {"flash": 12_000, "of_other_pixels": []},
                     "crate, -Os": {"flash": 29_697, "of_other_pixels": ["fxl_draw_outline_rgb565"]}},
        "cycles_estimate": [{"workload": "w1", "core": "m3", "model": "cortex-m3", "cycles": [250_001, 1]}],
        "rgb565": [{"workload": workload, "core": "m3", "way": way, "frame": frame, "cycles": {"cortex-m3": [7, 9], "cortex-m4": [5, 6]}}
                   for workload, way, frame in (("tqp", "a", 800_001), ("tqp", "b", 800_000), ("crates, levels", "a", 687_500),
                                                ("crates, 480x320", "a", 1_380_000), ("crates, 240x135", "a", 550_000))]}


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


# --- growth with faces --------------------------------------------------------------

def double_area_from_above(vertices, corners):
    """Twice the area of a triangle that runs clockwise as seen from above, x to the right and z upward."""
    (ax, _, az), (bx, _, bz), (cx, _, cz) = (vertices[corner] for corner in corners)
    return (bz - az) * (cx - ax) - (bx - ax) * (cz - az)


@pytest.mark.parametrize("faces, patch, models", [(500, None, 1), (8000, None, 1), (500, 5, 10), (8000, 5, 160)])
def test_a_terrain_has_the_faces_and_all_are_turned_up(plan, tmp_path, faces, patch, models):
    _, scene = bench_plan.compile_scene(plan.workloads["w1"], tmp_path)
    made = bench_changes.terrain(scene, faces, patch)
    assert bench_plan.faces_of(made) == faces and len(made.models) == len(made.objects) == models
    # In 2.30: by less than 27 degrees from upright, and no direction from the eye is farther than 53 from it.
    assert all(face.normal[1] > 0.9 * 2 ** 30 for model in made.models for face in model.faces)
    points = {tuple(a + b for a, b in zip(vertex, item.centre))
              for item in made.objects for vertex in made.models[item.model].vertices}
    columns, rows = bench_changes.sides(faces // 2)
    assert len(points) == (columns + 1) * (rows + 1)
    steps = bench_changes.TERRAIN_WIDTH * bench_changes.ONE // columns, bench_changes.TERRAIN_DEPTH * bench_changes.ONE // rows
    assert (min(y for _, y, _ in points), max(y for _, y, _ in points)) == (0, 7 * min(steps) // 32)
    # From above the faces cover the ground once, and each model has its origin in the middle of its patch.
    whole = 2 * bench_changes.TERRAIN_WIDTH * bench_changes.TERRAIN_DEPTH * bench_changes.ONE ** 2
    areas = [double_area_from_above(model.vertices, face.corners) for model in made.models for face in model.faces]
    assert min(areas) > 0 and sum(areas) == whole
    for model in made.models:
        edges = [edge for face in model.faces for edge in zip(face.corners, face.corners[1:] + face.corners[:1])]
        assert len(set(edges)) == len(edges)    # no two faces lie on one side of an edge
        for axis in (0, 2):
            along = [vertex[axis] for vertex in model.vertices]
            assert min(along) < 0 and abs(min(along) + max(along)) <= 1
    assert {face.colour for model in made.models for face in model.faces} == set(range(1, 1 + min(255, faces // models)))
    assert bench_plan.save_scene(made, tmp_path / "terrain.fxls").stat().st_size > 0


def test_the_growth_measured_is_linear_in_faces(measured):
    rows = [row for row in json.loads(measured[0])["growth"] if row["axis"].startswith("faces")]
    assert [row["faces"] for row in rows] == 2 * [500, 1000, 2000, 4000, 8000]
    assert all(500 < row["instructions"] / row["faces"] < 1500 for row in rows)


@pytest.mark.parametrize("asked, cores", [(["m3"], ["m3"]), (None, list(bench_plan.CORES))])
def test_the_cores_that_are_asked_for_are_measured_or_all(monkeypatch, asked, cores):
    def measure(_plan, given, left_out):
        assert (given, left_out) == (cores, ["m0"])
        raise ToolError("nothing is measured here")
    monkeypatch.setattr(bench, "measure", measure)
    with pytest.raises(ToolError, match="nothing is measured here"):
        bench.main(["--build", str(CHECKOUT / "build"), *(["--cores", *asked] if asked else []), "--left-out", "m0"])


# --- the document -------------------------------------------------------------------

def test_the_document_s_tables_are_made_from_the_baseline(baseline, plan):
    text = DOCUMENT.read_text(encoding="utf-8")
    assert bench_page.replace_tables(text, plan, baseline, bench_page.DOCUMENT) == text
    assert set(re.findall("bench: ([a-z0-9]+) ", text)) == {*bench_page.DOCUMENT, "end"}


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


# --- comparing ----------------------------------------------------------------------

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
    done = compare(tmp_path, less, {**baseline, "compiler": "another one"})
    assert done.returncode == 0 and "new: w1 fixel m0" in done.stdout and "note: another compiler" in done.stderr


@pytest.mark.parametrize("text, words", [(None, "run make bench"), ("{}", "is not a result of make bench"),
                                         ("{", "after.json")])
def test_no_result_is_one_sentence(tmp_path, text, words):
    if text is not None:
        (tmp_path / "after.json").write_text(text)
    assert_one_sentence(run_cli("bench-diff", "--current", tmp_path / "after.json"), words)


def test_accepting_renews_baseline_and_document(tmp_path, baseline):
    (tmp_path / "performance.md").write_text(DOCUMENT.read_text(encoding="utf-8"))
    (tmp_path / "now.json").write_text(json.dumps(changed(baseline, 1.0)))
    options = ["--accept", "--baseline", tmp_path / "baseline.json", "--current", tmp_path / "now.json",
               "--document", tmp_path / "performance.md"]
    assert run_cli("bench-diff", *options).returncode == 0
    assert json.loads((tmp_path / "baseline.json").read_text()) == baseline
    assert (tmp_path / "performance.md").read_text() == DOCUMENT.read_text(encoding="utf-8")
    for less, words in (({"left_out": ["m55"]}, "m55"),
                        ({"rows": [row for row in baseline["rows"] if row.get("workload") != "w2"]}, "w2 was not measured"),
                        ({"rows": [row for row in baseline["rows"] if row["core"] != "m0"]}, "m0 was not measured")):
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
