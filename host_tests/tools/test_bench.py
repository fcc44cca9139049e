# SPDX-License-Identifier: MIT
"""make bench: what it draws and counts, that it repeats, and what it writes."""

import json
import re
import subprocess

import pytest
from elftools.elf.elffile import ELFFile

from fixel.base import kept
from fixel.bench import bench
from conftest import CHECKOUT, assert_one_sentence, run_cli
from fixel.bench import bench_budgets, bench_changes, bench_faces, bench_plan, bench_rgb565, bench_rows, bench_run, linked_size
from fixel.board import dump
from fixel.image import image
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("bench/*", "host/bench_counter.so", "host/frames")
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
    assert {path.name for path in folder.iterdir()} == set(bench.PATTERNS) - {"faces.svg", "faces.png"}     # faces were not named
    assert (folder / "bench.png").read_bytes()[:4] == b"\x89PNG"
    goals = json.loads(text)["goals"]
    for goal in goals:
        assert goal["goal"] in printed
    assert f"{sum(goal['met'] is True for goal in goals)} of {len(goals)} goals met" in printed
    # Of other cores than the M3 nothing was measured, nor of the scenes that were left out, and that is what is said.
    budgets = {entry["name"] for entry in bench_plan.Plan(CHECKOUT / "build").budgets}
    unknown = [goal for goal in goals if goal["goal"] in budgets or
               re.search("M0|M4F|M55|RV32|plaza|W3b|c500|e300|f32|every cube|program|flat faces|to RGB565, (a frame|ESTIMATE)", goal["goal"])]
    assert [goal["figure"] for goal in unknown] == [None] * len(unknown) and len(unknown) > 10
    assert all(goal["figure"] is not None for goal in goals if goal not in unknown)


def check_rows(rows, plan, cores, drawn):
    """Rows as they are promised: every key, null where it means nothing, every workload and kernel."""
    keys = [(row["core"], row["workload"], row["renderer"]) for row in rows]
    assert len(keys) == len(set(keys))
    kernels = [name for name in plan.kernels if not name.startswith(bench_rows.LIMIT)]
    runs = [run for run in plan.runs(cores) if run[1] in drawn]
    full = [core for core in cores if core in bench_plan.CORES]
    assert set(keys) == {*runs, *[(core, name, "fixel") for core in full for name in kernels]}
    for row in rows:
        assert set(row) == ROW
        assert row["renderer"] in RENDERERS and row["core"] in cores
        assert isinstance(row["instructions"], int) and row["instructions"] > 0 and row["per_unit"] > 0
        for name in ("ratio_to_listing_double", "ratio_to_limit"):
            assert row[name] is None or row[name] > 0
        if row["workload"] in plan.workloads:
            frame = row["frame"]
            assert set(frame) == {"min", "mean", "max"} and 0 < frame["min"] <= frame["mean"] <= frame["max"]
            assert (row["ratio_to_listing_double"] is None) == ("by" in plan.workloads[row["workload"]] or row["core"] not in full)
            assert row["stack_bytes"] > 0 and row["ram_bytes"] >= 0 and (row["text_bytes"] > 0 if row["core"] in full else row["text_bytes"] is None)
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
    check_rows(baseline["rows"], plan, [*bench_plan.CORES, *bench_plan.EXTRA_CORES], plan.workloads)
    assert baseline["left_out"] == [] and baseline["extra_cores"] == list(bench_plan.EXTRA_CORES)
    assert {(row["kind"], row["radius"], row["core"]) for row in baseline["faces"]} == \
        {(kind["name"], radius, core) for kind in plan.faces["kinds"] for radius in plan.faces["radii"] for core in plan.faces["cores"]}
    packaged = {(row["variant"], row["workload"], row["core"]) for row in baseline["variants"]}
    assert {(variant, workload, core) for variant in ("arduino", "one-file") for workload in ("w1", "w3", "crates", "cratesd")
            for core in ("m0", "m3", "rv32")} <= packaged


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


def test_a_whole_program_links_the_library_and_no_kernels_of_other_pixels(plan):
    entry = next(each for each in plan.programs if each["source"] == "README.md" and each["bits"] == 8)
    found = linked_size._measure_program(plan, entry)
    assert 5_000 < found["flash"] < 20_000 and found["of_other_pixels"] == []


def test_by_flto_the_library_is_one_file_and_the_memory_functions_stay_outside():
    apart, together = (linked_size.sizes_of_map(CHECKOUT / "build/bench/m3/size" / flags / "fixel.map")
                       for flags in ("small", "small-flto"))
    assert list(together["files"]) == ["ltrans0"]       # not the linker's name of it, which is new with each link
    assert together["run_time"] == apart["run_time"] > 0
    assert together["code"] + together["constants"] < apart["code"] + apart["constants"]


# --- frames as pixels of RGB565, and steps ------------------------------------------

@pytest.mark.parametrize(("model", "count"), [(bench_changes.HEAD, 968), ("ball.obj", 5120)])
def test_a_generated_model_is_closed_and_has_its_triangles(tmp_path, model, count):
    bench_changes.MODELS[model](tmp_path)
    rows = [line.split() for line in (tmp_path / model).read_text().splitlines()]
    faces = [[int(word) for word in words[1:]] for words in rows if words[0] == "f"]
    edges = {(face[i], face[(i + 1) % 3]) for face in faces for i in range(3)}
    assert len(faces) == count and len(edges) == 3 * count
    assert {(b, a) for a, b in edges} == edges
    assert {corner for face in faces for corner in face} == set(range(1, 1 + sum(words[0] == "v" for words in rows)))


@pytest.mark.parametrize(("name", "faces", "things", "frames"), [
    ("q2000", 2000, 1, 1), ("h90d", 16_200, 1, 1), ("t64td", 8192, 1, 12), ("t64tld", 8192, 1, 12), ("sm4ld", 5120, 1, 8),
    ("bx300d", 1800, 300, 16), ("padd", 464, 401, 8), ("billd", 364, 301, 16)])
def test_small_scenes_have_what_their_workloads_say(plan, tmp_path, name, faces, things, frames):
    _, scene = bench_plan.compile_scene({**plan.rgb565[name], "with": []}, tmp_path)
    assert (bench_plan.faces_of(scene), len(scene.objects), len(scene.path)) == (faces, things, frames)
    assert (scene.depth_bits, scene.pixel_bits) == (16, 16)


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


def test_the_coloured_sphere_is_closed_and_has_a_colour_at_each_vertex(tmp_path):
    """Its rings end at the poles, where all vertices of a ring are one place."""
    bench_changes.write_sphere(tmp_path)
    rows = [line.split() for line in (tmp_path / bench_changes.SPHERE).read_text().splitlines()]
    places = [tuple(map(float, words[1:4])) for words in rows if words[0] == "v"]
    faces = [tuple(places[int(number) - 1] for number in words[1:]) for words in rows if words[0] == "f"]
    edges = {(face[i], face[(i + 1) % 3]) for face in faces for i in range(3)}
    assert len(faces) == 720 and len(edges) == 3 * 720 and {(b, a) for a, b in edges} == edges
    assert {len(words) for words in rows if words[0] == "v"} == {7}


def test_a_scene_of_rgb565_is_drawn_to_nothing_else(plan):
    ways = [(entry["name"], way) for _, entry, _, way in bench_rgb565._jobs(plan, ["m3"])]
    assert ("vcold", "RGB565") in ways and ("vcold", "palette, converted") not in ways and ("tqa", "palette, converted") in ways


@pytest.mark.parametrize("change", [name for name in bench_changes.CHANGES if name != "textured"])
def test_a_change_changes_the_scene(tmp_path, change):
    if change in ("smooth", *bench_changes.POINTS):
        path, before = "bench/scenes/egg.toml", []
    elif change == "without lines":
        path, before = "bench/scenes/lines.toml", []
    else:
        path, before = "bench/scenes/tqp.toml", ["rgb565"] if change in ("16 bits", "added") else []
    made = [image.pack(bench_changes.compile_file({"scene": CHECKOUT / path}, names, tmp_path)) for names in (before, [*before, change])]
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
    assert plan.has_faces and not named.has_faces
    named.keep(["faces"])
    assert named.has_faces and not named.workloads and not named.rgb565
    assert {core for core, entry, _, _ in jobs if entry["name"] == "tqpl"} == {"m3"}


def test_rows_and_pixels_are_slopes(monkeypatch):
    """A frame of 1,000 instructions, 50 more a row and 6 more a pixel."""
    monkeypatch.setattr(bench_budgets._Frames, "on", lambda self, screen: 1000 + 50 * screen[1] + 6 * screen[0] * screen[1])
    frames = bench_budgets._Frames(None, {}, None)
    assert bench_budgets.KINDS["pixel"](frames) == 6 and bench_budgets.KINDS["row"](frames) == 50


def test_what_a_scene_has_more_is_what_it_takes_without_a_change(monkeypatch):
    monkeypatch.setattr(bench_budgets._Frames, "mean", lambda self, *changes: 600 if changes == ("without lines",) else 1000)
    assert bench_budgets.KINDS["taken"](bench_budgets._Frames(None, {"less": "without lines", "per": 4}, None)) == 100


# --- goals --------------------------------------------------------------------------


# --- growth with faces --------------------------------------------------------------

# --- faces of all sizes -------------------------------------------------------------

def test_faces_have_their_size_and_turn_alike(plan, tmp_path):
    """As many pixels as triangles with equal sides have. An image looks along the other z, which turns the sign of an area."""
    for radius in (0.6, 8):
        scene = bench_faces.scene_of(plan.faces, plan.faces["kinds"][0], radius, tmp_path)
        model, = scene.models
        assert len(model.faces) == bench_faces.COUNT and len(model.vertices) == 3 * bench_faces.COUNT and scene.depth_bits == 16
        areas = []
        for face in model.faces:
            (x0, y0), (x1, y1), (x2, y2) = [(160 * x / -z, 160 * y / -z) for x, y, z in (model.vertices[corner] for corner in face.corners)]
            areas.append(((x2 - x0) * (y1 - y0) - (x1 - x0) * (y2 - y0)) / 2)
        assert min(areas) > 0.95 * bench_faces.pixels_of(radius) and max(areas) < 1.05 * bench_faces.pixels_of(radius)


def test_faces_are_drawn_in_each_way_alike(plan, tmp_path):
    rows = bench_faces._draw(plan, plan.faces["kinds"][0], 1.2, ["m3"])
    (row,) = rows
    assert {"kind": "flat", "radius": 1.2, "core": "m3"}.items() <= row.items()
    assert row["frame"] == row["without"]   # an M3 has a kernel for small triangles: the way of tiny ones is not tried
    coloured, = bench_faces._draw(plan, plan.faces["kinds"][-1], 1.2, ["m3"])
    assert coloured["without"] is None and coloured["frame"] > row["frame"]
    assert bench_faces.of({"faces": rows}, "flat", 1.2, "m3") is row and bench_faces.of({"faces": rows}, "flat", 5, "m3") is None


def test_the_floor_of_a_face_by_hand():
    """1.654 rows and 1.299 pixels a face of radius 1; a face of less than a row has none after the first."""
    kind = {"floor": {"face": 400, "row": 50, "pixel": 10}}
    assert bench_faces.floor_of(kind, 1) == pytest.approx(400 + 0.654 * 50 + 12.99, abs=0.05)
    assert bench_faces.floor_of(kind, 0.5) == pytest.approx(400 + 3.248, abs=0.05)


# --- what was counted is kept -------------------------------------------------------

def test_a_run_that_was_interrupted_goes_on_where_it_ended(plan, tmp_path, monkeypatch):
    """The same program and scene are not drawn again; others are, and all of them by FRESH=1."""
    monkeypatch.setenv("FIXEL_KEPT", "yes")
    monkeypatch.setenv("CI", "")
    kept_plan, ran, run = bench_plan.Plan(CHECKOUT / "build"), [], bench_run.counter.run
    monkeypatch.setattr(bench_run.counter, "run", lambda elf, *words: ran.append(elf.name) or run(elf, *words))
    kept_plan.store = kept.Kept(tmp_path, folder=bench.COUNTED)
    file = bench_plan.compile_scene(plan.workloads["w1"], tmp_path)[0]
    first = [bench_run.draw(kept_plan, "m3", "fixel", file, 3), bench_run.profile(kept_plan, "m3", "fixel", file, 3), bench_run.kernels(kept_plan, "m3")]
    assert ran == ["fixel.elf", "fixel.elf", "kernels.elf"]
    again = [bench_run.draw(kept_plan, "m3", "fixel", file, 3), bench_run.profile(kept_plan, "m3", "fixel", file, 3), bench_run.kernels(kept_plan, "m3")]
    assert len(ran) == 3 and again[2] == first[2] and again[1][0].stages == first[1][0].stages
    assert (again[0].instructions, again[0].stack) == (first[0].instructions, first[0].stack) and (again[0].pixels == first[0].pixels).all()
    bench_run.draw(kept_plan, "m3", "fixel", file, 2)
    bench_run.draw(kept_plan, "m3", "fixel-os", file, 3)
    bench_run.draw(kept_plan, "m3", "fixel", bench_plan.compile_scene(plan.workloads["w2"], tmp_path)[0], 3)
    assert ran[3:] == ["fixel.elf", "fixel-os.elf", "fixel.elf"]
    kept_plan.store = kept.Kept(tmp_path, True, bench.COUNTED)
    bench_run.draw(kept_plan, "m3", "fixel", file, 3)
    assert len(ran) == 7


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


# --- comparing ----------------------------------------------------------------------
