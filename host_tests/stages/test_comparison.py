# SPDX-License-Identifier: MIT
"""make clippers: a sample of it as a user runs it, its plan, and that it sees what is wrong."""

import copy
import json
import re
import subprocess
import types

import pytest

from fixel.bench import clippers as clippers_tool, clippers_page, clippers_plan, clippers_run
from conftest import CHECKOUT, assert_one_sentence, clipper_names, run_cli
from fixel.scene import making
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("bench/*", "host/comparison/*")
pytestmark = pytest.mark.usefixtures("bench_programs")
ROW = {"clipper", "hidden", "scene", "board", "instructions", "text_bytes", "ram_bytes", "max_error_units",
       "pixels_differing", "pixels_unexplained"}
SAMPLE = "view triangles sorted spans w1 adversarial m3"


@pytest.fixture(scope="module", name="sample")
def fixture_sample(build, tmp_path_factory):
    """(folder, clippers.json, what was printed) of a run over a few frames."""
    out = tmp_path_factory.mktemp("clippers") / "out"
    done = run_cli("clippers", "--build", build, "--out", out, "--frames", 3, "--only", SAMPLE)
    assert done.returncode == 0, done.stdout + done.stderr
    return out, json.loads((out / "clippers.json").read_text(encoding="utf-8")), done.stdout


@pytest.fixture(scope="module", name="plan")
def fixture_plan():
    return clippers_plan.Plan("build")


def records(pattern):
    """Names of the library's constant records of a kind."""
    text = "\n".join(file.read_text(encoding="utf-8") for file in (CHECKOUT / "lib").rglob("*.c"))
    return set(re.findall(rf"^const {pattern} (\w+) =", text, re.MULTILINE))


# --- the sample ---------------------------------------------------------------------

def test_a_row_for_every_combination_scene_and_core(sample):
    rows = sample[1]["rows"]
    keys = {(row["clipper"], row["hidden"], row["scene"], row["board"]) for row in rows}
    assert keys == {(clipper, hidden, scene, "m3") for clipper in ("view", "triangles")
                    for hidden in ("sorted", "spans") for scene in ("w1", "adversarial")}
    assert len(rows) == len(keys)
    for row in rows:
        assert ROW <= set(row)
        least, median, most = (row["instructions"][key] for key in ("min", "median", "max"))
        assert 10_000 < least <= median <= most and row["frames"] == 3 == len(row["crcs"])
        assert 5_000 < row["text_bytes"] < 60_000 and 3_000 < row["ram_bytes"] < 200_000


def test_all_is_explained_and_equal(sample):
    for row in sample[1]["rows"]:
        assert row["pixels_unexplained"] == 0 and row["missed"] == 0 and row["refused"] == 0
        assert row["equal_to_host"] is True
        assert 0.4 < row["max_error_units"] < (1.25 if row["clipper"] == "view" else 64)
    assert sample[1]["complaints"] == []


def test_any_order_gives_the_same_picture(sample):
    """Front to back into a span buffer, or back to front: bit for bit."""
    crcs = {}
    for row in sample[1]["rows"]:
        crcs.setdefault((row["clipper"], row["scene"]), []).append(row["crcs"])
    assert all(one == first for first, *others in crcs.values() for one in others)


def test_operations_are_counted(sample):
    """Each polygon that is cut has a division for each intersection, and one for each vertex that is projected."""
    rows = sample[1]["operations"]
    assert {(row["clipper"], row["scene"], row["board"]) for row in rows} == {
        (clipper, scene, "m3") for clipper in ("view", "triangles") for scene in ("w1", "adversarial")}
    for row in rows:
        assert row["crossing"] > 10 and row["polygons"] > 10
        assert row["intersections"] > row["crossing"]
        assert row["divisions"] > row["intersections"] + 2 * row["polygons"]
        assert row["instructions"] > row["multiplications"] > row["divisions"]


def test_tables_are_printed(sample):
    assert "Cortex-M3, instructions a frame" in sample[2] and "pass:" in sample[2]
    assert re.search(r"^triangles +spans +[\d,]+", sample[2], re.MULTILINE)


def test_the_page_needs_nothing_else(sample):
    text = (sample[0] / "clippers.html").read_text(encoding="utf-8")
    references = re.findall(r'(?:src|href)="([^"]*)"', text)
    assert references and all(one.startswith(("data:", "#")) for one in references)
    assert text.count("<svg") == 4 and text.count("data:image/png") >= 2
    ids = re.findall(r'\bid="([^"]+)"', text)
    assert len(ids) == len(set(ids))


def test_the_page_in_a_browser(sample, chromium):
    page = chromium.new_page()
    said = []
    page.on("console", lambda message: said.append(message.text))
    page.goto((sample[0] / "clippers.html").as_uri())
    assert page.locator("h1").inner_text() == "Which clipper?"
    assert page.locator(".verdict.good").count() == 1
    for picture in page.locator("img").all():
        assert picture.evaluate("image => image.naturalWidth") > 0
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    assert said == []


def test_the_measure_sees_what_rounding_in_the_world_costs(build, tmp_path):
    """W1 cut in 16.16: a hundred times what exact sums give."""
    scene = tmp_path / "w1.fxls"
    making.build(str(CHECKOUT / "scenes" / "w1.toml"), scene)

    def measured(clipper, sides):
        program = build / "host" / "comparison" / f"{clipper}-sorted"
        done = subprocess.run([program, sides, scene, tmp_path / "out.fxld", "20"],
                              capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)
    world, view, askew = measured("world", "lens"), measured("view", "lens"), measured("view", "guard")
    assert world["faces"] == view["faces"] and world["crossing"] == view["crossing"] > 100
    assert world["max_error_units"] > 20 > 1 > view["max_error_units"]
    assert world["missed"] == view["missed"] == 0 and view["beyond"] == 0 < world["beyond"]
    assert askew["max_error_units"] > 65536     # what the sides cut is said to be there still


# --- the plan -----------------------------------------------------------------------

def test_every_clipper_and_method_of_the_library_is_compared(plan):
    # An orthographic lens has clippers of its own, which nobody chooses.
    assert {each["record"] for each in plan.clippers.values()} == {name for name in records("fxl_clipper") if not name.startswith("fxl_orthographic_")}
    # With a depth buffer, RGB565 or outlines another picture is drawn. The span buffer with the other scan is nothing new.
    assert {each["target"] for each in plan.hidden.values()} == {"fxl_palette", "fxl_palette_box", "fxl_palette_spans"}
    assert records("fxl_target") == {"fxl_palette_box", "fxl_palette_spans", "fxl_palette_spans_box"}
    assert {each["order"] for each in plan.hidden.values()} == {"fxl_by_distance", "fxl_by_tree"}


def test_the_plan_names_what_is_to_be_compared(plan):
    assert set(plan.clippers) == set(clipper_names())
    assert {"sorted", "spans", "box"} <= set(plan.hidden)
    assert {"plaza", "w1", "w3", "spot", "adversarial"} <= set(plan.scenes)
    assert clippers_plan.Combination("near", "box") in plan.combinations()
    assert clippers_plan.Combination("view", "box") not in plan.combinations()


def test_only():
    plan = clippers_plan.Plan("build", "near,left w3 m0")
    assert (list(plan.clippers), list(plan.scenes), list(plan.cores)) == (["near", "left"], ["w3"], ["m0"])
    assert len(plan.hidden) > 1
    with pytest.raises(ToolError, match="ONLY names 'nearest'"):
        clippers_plan.Plan("build", "nearest")


def test_frames_are_spread_over_the_walk():
    assert clippers_plan.spread(120, 4) == [0, 30, 60, 90]
    assert clippers_plan.spread(3, 12) == [0, 1, 2]
    assert clippers_plan.spread(5, 1) == [0]


def test_what_explains_a_pixel(plan):
    scene = types.SimpleNamespace(width=320, fov=2 ** 30, near=65536)      # 90 degrees: focal 160
    assert plan.explained("view", scene) == 1 / 8192
    assert plan.explained("world", scene) == pytest.approx(2 * 160 / 65536)
    assert plan.explained("world", types.SimpleNamespace(width=2, fov=2 ** 30, near=65536)) == 1 / 8192


@pytest.mark.parametrize("words, said", [(["--only", "nothing"], "ONLY names 'nothing'")])
def test_wrong_usage_is_said(build, tmp_path, words, said):
    done = run_cli("clippers", "--build", build, "--out", tmp_path / "out", *words)
    assert_one_sentence(done, said)
    assert not (tmp_path / "out").exists()


# --- docs/clipping.md ----------------------------------------------------------------

@pytest.fixture(scope="module", name="kept")
def fixture_kept():
    return json.loads((CHECKOUT / "bench" / "clippers.json").read_text(encoding="utf-8"))


def test_the_document_is_that_of_the_run_that_was_kept(plan, kept):
    text = (CHECKOUT / "docs" / "clipping.md").read_text(encoding="utf-8")
    assert clippers_page.replace_tables(text, plan, kept) == text


def test_the_run_that_was_kept_is_whole_and_sound(plan, kept):
    keys = {(row["clipper"], row["hidden"], row["scene"], row["board"]) for row in kept["rows"]}
    assert keys == {(each.clipper, each.hidden, scene, core) for each in plan.combinations()
                    for scene in plan.scenes for core in plan.cores}
    assert kept["complaints"] == [] == clippers_run.complaints(plan, kept)


def test_a_run_with_gaps_or_complaints_is_not_kept(sample, plan, tmp_path):
    with pytest.raises(ToolError, match="are missing"):
        clippers_tool.accept(plan, sample[0])
    (tmp_path / "clippers.json").write_text(json.dumps({**sample[1], "complaints": ["something"]}), encoding="utf-8")
    with pytest.raises(ToolError, match="something"):
        clippers_tool.accept(plan, tmp_path)


def test_lines_are_the_same_data(sample):
    lines = clippers_run.as_lines(sample[1])
    rows = [{key: value for key, value in row.items() if key != "crcs"} for row in sample[1]["rows"]]
    assert json.loads(lines) == {**sample[1], "rows": rows}
    assert len(lines.splitlines()) > len(rows)


# --- what is wrong is said ----------------------------------------------------------

@pytest.mark.parametrize("change, words", [
    ({"pixels_unexplained": 7}, "7 pixels differ from double without explanation"),
    ({"equal_to_host": False}, "are not those of the host"),
    ({"missed": 1}, "1 faces are drawn or left out unlike"),
    ({"refused": 2}, "2 faces were refused"),
    ({"max_error_units": 1.5, "beyond": 10}, "outlines err by more than 1.25/65536 pixel")])
def test_complaints(sample, plan, change, words):
    result = copy.deepcopy(sample[1])
    result["rows"][0].update(change)
    (sentence,) = clippers_run.complaints(plan, result)
    assert words in sentence and sentence.startswith("view x sorted, w1, m3: ")


def test_a_complaint_is_an_exit_code(monkeypatch, tmp_path, sample):
    result = {**sample[1], "complaints": ["something"]}
    monkeypatch.setattr(clippers_tool, "measure", lambda *_: (result, {}))
    monkeypatch.setattr(clippers_tool.clippers_page, "render", lambda *_: "page")
    monkeypatch.chdir(CHECKOUT)
    assert clippers_tool.main(["--out", str(tmp_path / "out")]) == 1
    monkeypatch.setattr(clippers_tool, "measure", lambda *_: ({**result, "complaints": []}, {}))
    assert clippers_tool.main(["--out", str(tmp_path / "out")]) == 0
