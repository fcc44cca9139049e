# SPDX-License-Identifier: MIT
"""The other clippers against the reference renderer, given the same polygons (docs/extras/clippers.md)."""

import json
import subprocess

import pytest

BUILT_PROGRAMS = ("host/clipper_errors",)
SAMPLES = 20_000
# place clipper: the errors that are claimed
# Claims hold as they stand; a face that is not quite flat has no corners to within a unit, and
# the sliver rule moves outlines on purpose.
CLAIMED = ("normalised", "once_triangle", "half_spaces", "near_and_guard", "left_and_guard",
           "triangle", "line_by_planes", "line_by_codes", "line_and_plane", "plane_from_points", "rectangle")
POLYGONS = ("normalised", "once", "once_triangle", "half_spaces", "near_and_guard", "left_and_guard",
            "triangle", "rectangle")


@pytest.fixture(scope="module", name="found")
def fixture_found(build):
    done = subprocess.run([build / "host" / "clipper_errors", "--samples", str(SAMPLES), "--seed", "3"],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return {row["clipper"]: row for row in json.loads(done.stdout)["clippers"]}


@pytest.mark.parametrize("clipper", CLAIMED)
def test_outlines_are_within_their_bound(found, clipper):
    """A rare polygon beyond is nearly parallel to a plane that cuts it (docs/accuracy.md, section 3). clippers 7.1."""
    row = found[clipper]
    assert row["cut"] > SAMPLES / 10
    assert row["beyond"] <= row["cut"] / 10_000


@pytest.mark.parametrize("clipper", POLYGONS)
def test_nothing_is_missing_and_nothing_refused(found, clipper):
    row = found[clipper]
    assert row["verdicts"] == 0
    assert row["refused"] == 0
    assert row["max_carried_units"] < 4


def test_lines_are_all_there(found):
    for clipper in ("line_by_planes", "line_by_codes"):
        assert found[clipper]["verdicts"] == 0
        assert found[clipper]["max_outline_units_at_all"] < 4      # 2^-46, from the volume
    assert found["line_by_codes"]["crossings"] < found["line_by_planes"]["crossings"]


def test_a_line_meets_a_plane_beyond_its_ends_too(found):
    row = found["line_and_plane"]
    assert row["verdicts"] == 0
    assert row["crossings"] > row["cut"] / 10          # beyond the ends
    assert row["crossings"] < row["cut"]               # and between them


def test_three_points_make_a_plane_or_lie_on_a_line(found):
    assert found["plane_from_points"]["verdicts"] == 0


def test_faces_have_their_corners_to_within_their_flatness(found):
    row = found["once"]
    assert row["beyond"] < row["cut"] / 100
    assert row["max_outline_units"] < 4096                          # 1/16 pixel


def test_all_planes_at_once_wastes_no_intersection(found):
    """Where no corner of the frustum is enclosed: as many as new vertices, no less, no more."""
    row = found["once"]
    assert row["plain_made"] > SAMPLES / 20
    assert row["plain_crossings"] == row["plain_made"]
    assert found["normalised"]["plain_crossings"] > 1.2 * row["plain_made"]


def test_the_sliver_rule_saves_and_moves(found):
    with_rule, without = found["normalised_without_slivers"], found["normalised"]
    assert with_rule["crossings"] < without["crossings"]
    assert with_rule["mean_outline_units"] > without["mean_outline_units"]


def test_wrong_usage_is_said(build):
    done = subprocess.run([build / "host" / "clipper_errors", "--samples", "many"], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 2
    assert "usage" in done.stderr
