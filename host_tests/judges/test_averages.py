# SPDX-License-Identifier: MIT
"""What is off on average: scenes of the bench with surfaces and depth against the record, and claims of the report."""

import copy
import dataclasses
import json
import subprocess

import pytest

from conftest import CHECKOUT
from fixel.bench import bench_plan
from fixel.board import dump
from fixel.image import image, image_surface
from fixel.report import report_claims

BUILT_PROGRAMS = ("host/frames", "host/judge")
FRAMES = 12     # of a path, at most
PLAN = bench_plan.Plan(CHECKOUT / "build")
RECORD = report_claims.record()
# The seed of the report, and the samples that it draws of each claim.
SAMPLES = {name: entry["samples"] for name, entry in RECORD["claims"].items()}


def drawn(build, folder, workload, *changes):
    """A workload's image, and the host's dump of it."""
    entry = PLAN.rgb565[workload]
    file, _ = bench_plan.compile_scene({**entry, "with": [*entry.get("with", ()), *changes]}, folder)
    dumped = folder / "drawn.fxld"
    subprocess.run([build / "host" / "frames", file, dumped, "--frames", str(FRAMES)], check=True, capture_output=True)
    return file, dumped


def divided(build, file, folder):
    """The dump of an image with the same coordinates, whose surfaces are divided at each pixel."""
    made = image.unpack(file.read_bytes())
    surfaces = [dataclasses.replace(one, division=image_surface.DIVIDE_1) for one in made.surfaces.surfaces]
    exact, dumped = folder / "divided.fxls", folder / "divided.fxld"
    exact.write_bytes(image.pack(dataclasses.replace(made, surfaces=dataclasses.replace(made.surfaces, surfaces=surfaces))))
    subprocess.run([build / "host" / "frames", exact, dumped, "--frames", str(FRAMES)], check=True, capture_output=True)
    return dumped


def pixels(dumped):
    return [frame.pixels for frame in dump.read_dump(dumped).frames]


def measured(build, folder, workload):
    """Of a workload's frames: pixels that something is drawn to, those unlike the reference renderer's in double, and
    those unlike the same scene divided at each pixel; None where it has no textures."""
    file, dumped = drawn(build, folder, workload)
    frames = pixels(dumped)
    subprocess.run([build / "host" / "judge", file, dumped, "--json", folder / "judge.json"], check=False, capture_output=True)
    verdict = json.loads((folder / "judge.json").read_text())
    unlike = None
    if workload.startswith(("tq", "crates", "balls", "t64", "bx300", "padd")):
        exact = pixels(divided(build, file, folder))
        unlike = sum(int((one != other).sum()) for one, other in zip(frames, exact, strict=True))
    return {"covered": sum(int((frame != 0).sum()) for frame in frames),
            "unlike_double": sum(frame["pixels_differing"] for frame in verdict["frames"]), "unlike_divided": unlike}


@pytest.mark.parametrize("workload", RECORD["scenes"])
def test_pixels_of_a_scene_are_no_worse_than_in_the_record(build, tmp_path, workload):
    """As many are drawn, to within one in 1,000; of these no more differ. accuracy 3.5b."""
    now, then = measured(build, tmp_path, workload), RECORD["scenes"][workload]
    assert abs(now["covered"] - then["covered"]) <= then["covered"] / 1000
    for key in ("unlike_double", "unlike_divided"):
        assert (now[key] is None) == (then[key] is None)
        assert now[key] is None or now[key] <= then[key], f"{workload}: {key} {now[key]}, in the record {then[key]}"


def test_the_record_has_every_scene_with_surfaces_or_depth():
    assert list(RECORD["scenes"]) == [name for name in PLAN.rgb565 if not name.endswith("-flat")]


def claims(change=1.0):
    return [{"id": name, "bound": 1, "measured": 0, "unit": "texel", "samples": entry["samples"],
             "samples_claimed": entry["samples"], "mean": entry["mean"] * change, "holds": True}
            for name, entry in RECORD["claims"].items()]


def test_a_mean_that_is_the_record_s_holds_and_a_larger_one_fails():
    """accuracy 3.5b."""
    assert all(claim["holds"] and "mean_most" in claim for claim in report_claims.hold(claims(), RECORD["seed"]))
    worse = report_claims.hold(claims(1.001), RECORD["seed"])
    assert not any(claim["holds"] for claim in worse)
    assert "and the record's is" in report_claims.complaints({"claims": worse})[0]


def test_a_mean_of_other_samples_is_not_compared():
    """accuracy 3.5e."""
    fewer = copy.deepcopy(claims(2.0))
    for claim in fewer:
        claim["samples"] -= 1
    for found in (report_claims.hold(claims(2.0), RECORD["seed"] + 1), report_claims.hold(fewer, RECORD["seed"])):
        assert all(claim["holds"] and "mean_most" not in claim for claim in found)


def test_the_record_s_samples_are_those_of_the_report():
    assert {name: report_claims.FEWEST[name] for name in SAMPLES} == SAMPLES
