# SPDX-License-Identifier: MIT
"""Each core's kernels against the portable ones, on the emulated core; fewer inputs than make equality."""

import json
import re
import subprocess

import pytest

from board_programs import ROOT, made
from conftest import assert_one_sentence, environment, run_cli
from fixel.campaign.shards import Shard
from fixel.check import equality as kernel_equality

CORES = ("m0", "m3", "m4f", "m55", "m0-small", "m3-small", "m3-os")
FEWEST = "m3-small"     # of these, the program with the fewest kernels


def equality(core, build, *more, **changes):
    """fixel equality with a build folder of its own, which has the programs."""
    if not (build / "equality").exists():
        (build / "equality").mkdir(parents=True)
        (build / "equality" / f"{core}.elf").symlink_to(made(f"build/equality/{core}.elf"))
    return run_cli("equality", core, "--build", build, *more, **changes)


def kernels_of(core):
    """The tests that a core's program lists. With FXL_SMALL no kernel is in assembly, so that list is shorter; outlines
    with a depth buffer are drawn in one call but by -Os, and smooth ones, small planes and short runs have kernels on Armv7-M
    alone."""
    libraries = {"BOTH", "SMALL"} if core.endswith("-small") else {"BOTH", "LARGE"}
    if core in ("m0", "m3", "m4f", "m55"):
        libraries.add("OUTLINES")
    if core in ("m3", "m4f", "m55"):
        libraries.add("SMOOTH")
    header = (ROOT / "firmware/equality/equality.h").read_text(encoding="utf-8")
    names = [name for name, library in re.findall(r'TEST\("([\w-]+)", test_\w+, (\w+)\)', header) if library in libraries]
    assert len(names) >= 8
    return names


@pytest.fixture(name="compared", scope="module")
def fixture_compared():
    """The small form of make equality (host_tests/build/commands.toml): all programs."""
    made(*(f"build/equality/{core}.elf" for core in CORES))
    done = subprocess.run(["make", "equality", "THOUSANDS=10"], cwd=ROOT, env=environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


@pytest.mark.parametrize("core", CORES)
def test_kernels_are_equal(core, compared):
    done = compared
    lines = re.findall(rf"^{core} +(\S+) +([0-9,]+) inputs  0 differ", done.stdout, re.MULTILINE)
    assert sorted(name for name, _ in lines) == sorted(kernels_of(core)), done.stdout
    assert all(int(cases.replace(",", "")) >= 10000 for _, cases in lines), done.stdout


def test_what_is_done_is_not_done_again(tmp_path):
    allowed = {"FIXEL_KEPT": "", "CI": ""}
    first, again = (equality(FEWEST, tmp_path, "--thousands", "1", **allowed) for _ in range(2))
    count = len(kernels_of(FEWEST))
    assert first.returncode == 0 and first.stdout == again.stdout, first.stdout + first.stderr
    assert f"{count} of {count} shards done, 0 of them by earlier" in first.stderr
    assert f"{count} of {count} shards done, {count} of them by earlier" in again.stderr
    more = equality(FEWEST, tmp_path, "--thousands", "2", **allowed)
    assert f"{count} of {count} shards done, 0 of them by earlier" in more.stderr
    assert sum(row["inputs"] for row in json.loads((tmp_path / "equality/equality.json").read_text())["rows"]) >= 2000 * count


def test_each_shard_has_inputs_of_its_own():
    """Their numbers reach the program: kernels that skip some inputs count others."""
    elf = made(f"build/equality/{FEWEST}.elf")
    counted = list(zip(*(kernel_equality.compare(elf, 1, shard=shard) for shard in (0, 0, 1, 65535)), strict=True))
    assert len(counted) == len(kernels_of(FEWEST))
    assert all(first == same for first, same, _, _ in counted)
    assert any(len({first, *others}) == 3 for first, _, *others in counted)


def test_a_plan_has_all_inputs_once(monkeypatch):
    monkeypatch.setattr(kernel_equality, "kernels", lambda elf: ["a", "b"])
    some = kernel_equality.plan("build", ["m0", "m3"], 2500)
    assert [shard.parameters["thousands"] for shard in some] == 4 * [1000, 1000, 500]
    assert [shard.parameters["shard"] for shard in some] == 4 * [0, 1, 2] and [shard.number for shard in some] == list(range(12))
    assert [shard.kind for shard in some[::3]] == ["m0 a", "m0 b", "m3 a", "m3 b"]
    rows = kernel_equality.merge(some, [{"inputs": 10, "differ": shard.number % 2} for shard in some])
    assert rows[1] == {"core": "m0", "kernel": "b", "inputs": 30, "differ": 2}
    with pytest.raises(ValueError):
        kernel_equality.merge(some[:1] + [Shard("equality", 1, {}, "m0 a", 1)], [{"inputs": 1, "differ": 0}])


def test_nothing_is_refused():
    assert_one_sentence(run_cli("equality", "m3", "--thousands", "0"), "--thousands", "from 1 to 65,536,000")
