# SPDX-License-Identifier: MIT
"""make report: the same seed gives the same report, a claim that fails fails it, and the page opens."""

import dataclasses
import html.parser
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import types
from fractions import Fraction

import pytest
from conftest import CHECKOUT, assert_one_sentence, run_cli

from fixel.report import report_claims, report_frames, report_page, report_plots, report_shards
from fixel.image import image
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/designs", "host/judge", "host/oracle", "host/raycast",
                  "host/stage_errors")
SAMPLES = 4000
CHROMIUM = pathlib.Path("/usr/bin/chromium")
STAGES = ("matrix", "vertex", "clip", "fill", "texel", "texel_16", "texel_8", "affine", "light", "depth_buffer_16",
          "depth_buffer_32")
PARAMETERS = ("near", "depth", "fov", "coordinates", "edge_length", "plane_angle", "texel_depth", "texel_size", "texel_face",
              "light_depth", "distance_16", "distance_32")
DESIGNS = ("naive", "fixel", "float32")
# An oracle whose every claim but those named in it holds exactly.
ORACLE = """#!/usr/bin/env python3
import json, sys
words = dict(zip(sys.argv[2::2], sys.argv[3::2]))
count, off = int(words["--samples"]), 9.0 if sys.argv[1] in %r else 0.0
print(json.dumps({"id": sys.argv[1], "samples": count, "max": off, "mean": off, "rms": off, "unit": "u",
                  "worst_input": words["--shard"], "histogram": [{"upto": 1, "count": count}]}))
"""


class Page(html.parser.HTMLParser):
    """Every attribute that could fetch something, and whether the tags nest."""

    VOID = {"meta", "img", "link", "br", "path", "use"}

    def __init__(self, text):
        super().__init__()
        self.references, self.ids, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.references += [value for name, value in attrs if name in ("src", "href", "xlink:href")]
        self.ids += [value for name, value in attrs if name == "id"]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.references += [value for name, value in attrs if name in ("src", "href", "xlink:href")]
        self.ids += [value for name, value in attrs if name == "id"]

    def handle_endtag(self, tag):
        if tag not in self.VOID:
            assert self.open.pop() == tag


def build_with_oracle(folder, *wrong):
    """A build folder with the real programs and an oracle that finds these claims wrong."""
    (folder / "host").mkdir(parents=True)
    for name in ("designs", "judge", "raycast", "stage_errors"):
        (folder / "host" / name).symlink_to(CHECKOUT / "build/host" / name)
    (folder / "boards").symlink_to(CHECKOUT / "build/boards")
    oracle = folder / "host" / "oracle"
    oracle.write_text(ORACLE % (wrong,))
    oracle.chmod(0o755)
    return folder


def run_report(build, out, *more, samples=SAMPLES):
    return run_cli("report", "--build", build, "--out", out, "--samples", samples, *more)


@pytest.fixture(scope="module")
def built(build):
    """The report's own programs are there, too."""
    assert (build / "host/designs").exists(), "make all builds it"
    return build


@pytest.fixture(scope="module")
def result(built, tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    build = build_with_oracle(folder / "build")
    done = run_report(build, folder / "out", "--jobs", 3)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder, json.loads((folder / "out/report.json").read_text()), done


# place claim: test_every_claim_is_measured: the list
def test_every_claim_is_measured(result):
    """accuracy 3.1."""
    _, report, done = result
    assert [claim["id"] for claim in report["claims"]] == [
        "matrix_entry", "matrix_entry_instance", "orientation_angles", "orientation_axis", "orientation_look_at",
        "orientation_product", "orientation_quaternion", "quaternion", "orientation_parents", "sine_cosine", "vertex_unclipped", "vertex_turned",
        "outline_clipped", "coverage", "watertight", "texel_divided", "texel_every_16", "texel_every_8", "texel_affine",
        "light_level", "corner_colour", "depth_16", "depth_32", "horizon", "orthographic_vertex", "orthographic_texel", "orthographic_depth",
        "frame", "scale"]
    for claim in report["claims"]:
        assert claim["holds"] is True and claim["samples"] > 0 and claim["unit"]
        assert claim["measured"] <= claim["bound"]
        assert claim["id"] in done.stdout


def test_every_stage_by_three_designs(result):
    _, report, _ = result
    assert [(row["stage"], row["design"]) for row in report["stages"]] == \
        [(stage, design) for stage in STAGES for design in DESIGNS]
    for row in report["stages"]:
        assert 0 <= row["mean"] <= row["rms"] <= row["max"]
        assert sum(entry["count"] for entry in row["histogram"]) == row["samples"] > 0


def test_fixel_is_the_most_precise(result):
    _, report, _ = result
    worst = {(row["stage"], row["design"]): row["max"] for row in report["stages"]}
    for stage in STAGES:
        assert worst[stage, "fixel"] <= min(worst[stage, "naive"], worst[stage, "float32"])
    assert worst["vertex", "fixel"] < 0.55 and worst["fill", "fixel"] == 0
    assert worst["vertex", "naive"] > 65536     # more than a pixel


def test_sweeps(result):
    _, report, _ = result
    assert [(row["parameter"], row["design"]) for row in report["sweeps"]] == \
        [(parameter, design) for parameter in PARAMETERS for design in DESIGNS]
    for row in report["sweeps"]:
        values = [point["value"] for point in row["points"]]
        assert values == sorted(set(values)) and len(values) >= 8
        assert all(0 <= point["mean"] <= point["max"] for point in row["points"])


def test_the_picture_and_the_table_have_one_sampling(result):
    """Errors by depth are those of the stage's own samples: neither has a worst that the other lacks."""
    _, report, _ = result
    whole = {row["design"]: row for row in report["stages"] if row["stage"] == "vertex"}
    assert {row["design"] for row in report["depths"]} == set(DESIGNS)
    for row in report["depths"]:
        values = [point["value"] for point in row["points"]]
        assert values == sorted(set(values)) and len(values) >= 15
        assert max(point["max"] for point in row["points"]) == whole[row["design"]]["max"]
        assert sum(point["samples"] for point in row["points"]) == whole[row["design"]]["samples"]


def test_frames(result):
    _, report, _ = result
    scenes = {frame["scene"] for frame in report["frames"]}
    assert {"plaza", "w1", "w3", "tiny", "cube", "plaza, rolled"} <= scenes
    for frame in report["frames"]:
        assert set(frame) == {"scene", "frame", "pixels_differing", "pixels_unexplained", "pixels_tied",
                              "max_edge_distance_px"}
        assert frame["pixels_unexplained"] == 0


@dataclasses.dataclass
class Model:
    vertices: list


@dataclasses.dataclass
class Placed:
    centre: tuple
    layer: int = 7


@dataclasses.dataclass
class Scene:
    """As much of a scene as has a length."""
    near: int = 2
    far: int = 3
    inset: int = 5
    models: tuple = (Model([(1, 2, 3), (4, 5, 6)]),)
    objects: tuple = (Placed((7, 8, 9)),)
    path_kind: int = image.POSES
    path: tuple = ((1, 2, 3, 4, 5, 6),)
    start: tuple = (10, 11, 12, 13, 14, 15)
    gait: tuple = (16, 17, 18, 19)


def test_a_scene_of_another_scale_has_other_lengths_and_the_same_angles():
    assert report_frames.scaled(Scene(), 4) == Scene(
        8, 12, 20, [Model([(4, 8, 12), (16, 20, 24)])], [Placed((28, 32, 36))], image.POSES, [(4, 8, 12, 4, 5, 6)],
        (40, 44, 48, 13, 14, 15), (64, 68, 72, 19))
    strides = Scene(path_kind=image.STRIDES, path=((1, 3),))
    assert report_frames.scaled(strides, 4).path == ((1, 3),)


def test_a_board_that_does_not_count_is_no_division_by_zero(monkeypatch, tmp_path):
    frame = types.SimpleNamespace(instructions=0, pixels=None, number=0)
    monkeypatch.setattr(report_frames, "_draw", lambda *_: types.SimpleNamespace(frames=[frame], width=1, height=1))
    with pytest.raises(ToolError, match="did not count the instructions"):
        report_frames.measure(None, "mps2-an385", types.SimpleNamespace(frames=1), tmp_path)


def test_scales_change_nothing(result):
    _, report, _ = result
    assert [row["scale"] for row in report["scales"]] == [1, 4, 16, 64]
    assert all(row["pixels_differing"] == 0 and row["instructions_percent"] <= 10
               and row["instructions_per_frame"] > 1000 for row in report["scales"])


def test_a_worst_input_runs_again(result):
    """The command printed gives the error printed."""
    _, report, _ = result
    for row in report["stages"]:
        done = subprocess.run(shlex.split(row["command"]), cwd=CHECKOUT, capture_output=True, text=True,
                              check=True)
        line = next(line for line in done.stdout.splitlines() if line.startswith(row["design"]))
        found = float(re.search(r"off by ([0-9.e+]+)", line)[1])
        assert found == pytest.approx(row["max"], rel=1e-5)


def vertex_of(numbers, at):
    """A vertex in the view in units of 2^-46, whole."""
    eye, rows = numbers[6:9], [numbers[9 + 3 * row:12 + 3 * row] for row in range(3)]
    return [sum(r * (c - e) for r, c, e in zip(row, numbers[at:at + 3], eye)) for row in rows]


def positions_of(command):
    """Where each design puts the vertex, in pixels."""
    done = subprocess.run(shlex.split(command), cwd=CHECKOUT, capture_output=True, text=True, check=True)
    return {line.split()[0]: [float(each) for each in re.findall(r"\b[xy] +(-?[0-9.]+)", line)]
            for line in done.stdout.splitlines() if line.split()[0] in DESIGNS}


def test_vertex_errors_by_fractions(result):
    """The measure itself, computed here once more in another way."""
    for row in (row for row in result[1]["stages"] if row["stage"] == "vertex"):
        numbers = [int(word) for word in row["worst_input"].split()]
        x, y, z = vertex_of(numbers, 18)
        exact = (Fraction(numbers[0], 2) + Fraction(numbers[2] * x, 65536 * z),
                 Fraction(numbers[1], 2) - Fraction(numbers[2] * y, 65536 * z))
        found = positions_of(row["command"])[row["design"]]
        error = max(abs(Fraction(one) - other) for one, other in zip(found, exact, strict=True)) * 65536
        assert float(error) == pytest.approx(row["max"], rel=1e-4)


def test_clip_errors_by_fractions(result):
    for row in (row for row in result[1]["stages"] if row["stage"] == "clip"):
        numbers = [int(word) for word in row["worst_input"].split()]
        a, b = vertex_of(numbers, 19), vertex_of(numbers, 22)
        normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        x, y = positions_of(row["command"])[row["design"]]
        ray = (Fraction(x) - Fraction(numbers[0], 2), Fraction(numbers[1], 2) - Fraction(y),
               Fraction(numbers[2], 65536))
        distance = abs(sum(n * r for n, r in zip(normal, ray))) / Fraction(math.hypot(*normal[:2]))
        assert float(distance) * 65536 == pytest.approx(row["max"], rel=1e-3)


def test_same_seed_same_report(result, tmp_path):
    folder, _, _ = result
    done = run_report(folder / "build", tmp_path / "one", "--jobs", 1)
    assert done.returncode == 0, done.stderr
    for name in ("report.json", "report.html"):
        assert (tmp_path / "one" / name).read_bytes() == (folder / "out" / name).read_bytes()


def test_another_seed_another_report(built):
    command = [built / "host/designs", "vertex", "--samples", "100", "--seed"]
    one, same, other = (subprocess.check_output([*command, seed]) for seed in ("1", "1", "2"))
    assert one == same != other


def test_shards_depend_on_samples_alone():
    kind = report_shards.STAGES[1]
    for total in (1, 1000, 999_999, report_shards.SAMPLES):
        shards = report_shards.shards_of(kind, total)
        assert [number for number, _ in shards] == list(range(len(shards)))
        assert sum(samples for _, samples in shards) == kind.samples(total)
        assert all(0 < samples <= kind.shard for _, samples in shards)
        assert all(samples == kind.shard for _, samples in shards[:-1])


def test_default_samples_suffice():
    """What the project promises of a default report."""
    drawn = {kind.what: kind.samples(report_shards.SAMPLES) for kind in report_shards.CLAIMS}
    assert drawn["vertex_unclipped"] >= 10_000_000
    assert drawn["outline_clipped"] >= 1_000_000 and drawn["coverage"] >= 1_000_000


def test_default_frames_suffice(tmp_path, monkeypatch):
    monkeypatch.chdir(CHECKOUT)
    found = report_frames.walks(report_frames.SCENES, tmp_path)
    assert sum(walk.scene.frames for walk in found) >= 500


def test_merging():
    parts = [{"samples": 1, "max": 3.0, "mean": 3.0, "rms": 3.0, "worst_input": "a",
              "histogram": [{"upto": 4, "count": 1}]},
             {"samples": 3, "max": 5.0, "mean": 1.0, "rms": 2.0, "worst_input": "b",
              "histogram": [{"upto": 4, "count": 1}, {"upto": 8, "count": 2}]}]
    merged = report_shards.merge(parts)
    assert merged == {"max": 5.0, "mean": 1.5, "rms": (21 / 4) ** 0.5, "samples": 4, "worst_input": "b",
                      "histogram": [{"upto": 4, "count": 2}, {"upto": 8, "count": 2}]}


def test_false_claims_fail(built, tmp_path):
    """accuracy 3.1."""
    false = ["vertex_unclipped", "coverage"]
    build = build_with_oracle(tmp_path / "build", *false)
    done = run_report(build, tmp_path / "out", "--scene", "scenes/tiny.toml", samples=100)
    assert done.returncode == 1, done.stderr
    report = json.loads((tmp_path / "out/report.json").read_text())
    assert [each["id"] for each in report["claims"] if not each["holds"]] == false
    for claim in false:
        assert f"FAIL: {claim}" in done.stdout and f"oracle {claim} --input" in done.stdout
    assert "Not every claim holds" in (tmp_path / "out/report.html").read_text()


def test_some_claims_alone(tmp_path):
    build = build_with_oracle(tmp_path / "build", "orientation_axis")
    done = run_report(build, tmp_path / "out", "--only", "orientation_axis depth_16", samples=100_000)
    assert done.returncode == 1 and "FAIL: orientation_axis" in done.stdout and "depth_16 " in done.stdout
    report = json.loads((tmp_path / "out/claims.json").read_text())
    assert [(each["id"], each["samples"], each["holds"]) for each in report["claims"]] == \
        [("orientation_axis", 100_000, False), ("depth_16", 20_000, True)]
    done = run_report(build, tmp_path / "out", "--only", "depth_16", samples=100_000)
    assert done.returncode == 0 and "fewer samples than the claims are about" in done.stdout
    assert_one_sentence(run_report(build, tmp_path / "out", "--only", "depth"), "'depth'", "depth_16")


def test_too_few_samples_are_a_failure_unless_asked_for():
    tally = {"max": 0.0, "sum": 0.0, "sum_of_squares": 0.0, "worst_input": "", "histogram": []}
    shards = {kind.what: [{**tally, "samples": kind.samples(report_shards.SAMPLES)}] for kind in report_shards.CLAIMS}
    frame = {"pixels_differing": 0, "pixels_unexplained": 0, "pixels_tied": None, "max_edge_distance_px": None}
    scale = {"pixels_differing": 0, "pixels": 100, "frames": 1, "instructions_percent": 0.0}

    def failing(frames, fewer_asked):
        claims = report_claims.judge(shards, [frame] * frames, 100, [scale] * 4, "build", fewer_asked)
        return {"claims": claims, "third_judge": {"pixels_unexplained": 0}}, \
            [claim["id"] for claim in claims if not claim["holds"]]

    assert failing(500, False)[1] == []
    assert failing(20, True)[1] == []
    assert report_claims.shortfall(failing(20, True)[0]) == "frame 20 of 500"
    report, ids = failing(20, False)
    assert ids == ["frame"] and "20 samples are fewer than the 500" in report_claims.complaints(report)[0]


def test_a_row_of_no_samples_is_no_row(result):
    _, report, _ = result
    assert report["twins"] and all(row["samples"] > 0 for row in report["twins"])
    random = [{"stage": stage, "input": "random", "samples": 1, "beyond_bound": 0, "mismatched": 0, "bound": ""}
              for stage in report_claims.STAGES]
    assert report_claims.complaints_of_stages(random) == []
    assert report_claims.complaints_of_stages(random[1:]) == ["sphere: no random sample was compared with double"]


def test_unexplained_pixel_fails():
    claim = next(each for each in report_claims.CLAIMS if each.id == "frame")
    frame = {"pixels_differing": 1, "pixels_unexplained": 0, "pixels_tied": None,
             "max_edge_distance_px": 0.00001}
    judge = report_claims._frame_claim
    assert judge(claim, [frame], 100_000)["holds"]
    assert not judge(claim, [frame], 99_999)["holds"]
    assert not judge(claim, [{**frame, "pixels_unexplained": 1}], 100_000)["holds"]


def test_instructions_may_change_by_a_tenth():
    claim = next(each for each in report_claims.CLAIMS if each.id == "scale")
    row = {"pixels_differing": 0, "pixels": 100, "frames": 1, "instructions_percent": 10.0}
    assert report_claims._scale_claim(claim, [row])["holds"]
    assert not report_claims._scale_claim(claim, [row, {**row, "instructions_percent": 10.1}])["holds"]
    assert not report_claims._scale_claim(claim, [row, {**row, "pixels_differing": 1}])["holds"]


def test_host_counts_no_instructions(built, tmp_path):
    build = build_with_oracle(tmp_path / "build")
    done = run_report(build, tmp_path / "out", "--scene", "scenes/tiny.toml", "--board", "host", samples=100)
    assert_one_sentence(done, "host", "BOARD=")


def test_oracle_that_fails_leaves_nothing(built, tmp_path):
    build = build_with_oracle(tmp_path / "build")
    (build / "host/oracle").write_text("#!/bin/sh\necho 'oracle: out of luck' >&2\nexit 2\n")
    done = run_report(build, tmp_path / "out", samples=100)
    assert_one_sentence(done, "out of luck")
    assert not (tmp_path / "out").exists() and not list(build.glob(".fixel-report-*"))


@pytest.mark.parametrize("option, value, word", [("--samples", "0", "SAMPLES"), ("--samples", "many", "SAMPLES"),
                                                 ("--seed", "-1", "SEED"), ("--jobs", "1025", "--jobs"),
                                                 ("--jobs", "-1", "--jobs"), ("--minutes", "x", "MINUTES")])
def test_bad_numbers(option, value, word):
    assert_one_sentence(run_cli("report", f"{option}={value}"), word, value)


@pytest.mark.parametrize("words", [["vertex", "--input", "1 2 3"], ["vertex", "--input", "x"], ["nothing"],
                                   ["sweep:nothing"], ["vertex", "--seed"], [],
                                   ["fill", "--input", "32 24 3 0 0 1 1 2"], ["texel", "--input", "320 240 1"],
                                   ["depth_buffer_16", "--input", " ".join(["7"] * 34)]])
def test_designs_refuses(built, words):
    done = subprocess.run([built / "host/designs", *words], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stderr.startswith("error: designs: ") and not done.stdout


def test_page_fetches_nothing(result):
    text = (result[0] / "out/report.html").read_text()
    page = Page(text)
    assert page.open == []
    assert all(reference.startswith(("data:image/png;base64,", "data:,", "#"))
               for reference in page.references)
    # Names of XML namespaces are not fetched.
    named = set(re.findall(r"https?://[^\"'<> )]+", text))
    assert all("www.w3.org" in each or "purl.org" in each or "creativecommons" in each or
               "matplotlib.org" in each for each in named)
    assert "@import" not in text and "<script" not in text
    assert len(page.ids) == len(set(page.ids))


def test_page_shows_the_figures(result):
    folder, report, _ = result
    text = (folder / "out/report.html").read_text()
    assert text.count("<svg") == len(STAGES) + len(PARAMETERS) + 1
    assert text.count("data:image/png") >= 9
    for claim in report["claims"]:
        assert f"<code>{claim['id']}</code>" in text
    for row in report["stages"]:
        assert row["worst_input"] in text


def test_page_opens_in_a_browser(result, tmp_path):
    if not CHROMIUM.exists():
        pytest.skip(f"{CHROMIUM} is not installed (Debian package chromium)")
    done = subprocess.run(
        [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
         f"--user-data-dir={tmp_path / 'profile'}", "--virtual-time-budget=5000", "--dump-dom",
         (result[0] / "out/report.html").as_uri()],
        capture_output=True, text=True, check=False,
        env={**os.environ, "HOME": str(tmp_path)})
    assert done.returncode == 0, done.stderr
    assert "How precise is Fixel?" in done.stdout and "asked for fewer samples" in done.stdout
    assert "CONSOLE" not in done.stderr, done.stderr


def test_picture(result, tmp_path):
    file = tmp_path / "precision.png"
    done = run_cli("report", "--picture", file, "--out", result[0] / "out")
    assert done.returncode == 0, done.stderr
    assert file.read_bytes().startswith(b"\x89PNG")
    done = run_cli("report", "--picture", file, "--out", tmp_path / "nowhere")
    assert_one_sentence(done, "nowhere")


@pytest.mark.parametrize("value, words", [(0.5043, "0.504"), (65536, "1 pixel"), (65536 * 31.62, "31.6 pixels"),
                                          (65536 * 1234, "1,234 pixels"), (1500, "1,500")])
def test_errors_in_words(value, words):
    assert report_plots.in_words(value) == words


@pytest.mark.parametrize("value, text", [
    (None, "–"), (0, "0"), (1234567, "1,234,567"), (1234567.0, "1,234,567"), (9999.5, "10,000"), (9999.25, "9999"), (10000.25, "10,000"),
    (-20000.75, "-20,001"), (12.34567, "12.35"), (0.000123456, "0.0001235")])
def test_a_number_of_a_table(value, text):
    assert report_page.figure(value) == text
