# SPDX-License-Identifier: MIT
"""The fuzzers themselves, by clang: the same runs give the same result on one process and on eight. make test-campaigns builds
them where there is a clang."""

import pytest
from conftest import CHECKOUT

from fixel.campaign import runner
from fixel.check import fuzz

BUILD = CHECKOUT / "build"
RUNS = 100      # of each of two shards


@pytest.mark.parametrize("harness", fuzz.corpus.HARNESSES)
def test_one_process_and_eight_find_the_same(harness, monkeypatch):
    if not fuzz.program_of(BUILD, harness).exists():
        pytest.skip("needs clang with libFuzzer, which make fuzz installs")
    if not fuzz.prefix():
        pytest.skip("needs setarch -R, which this system forbids")
    monkeypatch.chdir(CHECKOUT)
    monkeypatch.setattr(fuzz, "SHARD", RUNS)
    some = [shard for shard in fuzz.plan(2 * RUNS) if shard.kind == harness]
    some = [fuzz.shards.Shard("fuzz", number, shard.parameters, harness, RUNS) for number, shard in enumerate(some)]
    results = []
    for jobs in (1, 8):
        options = fuzz.parser().parse_args(["--build", "build", "--jobs", str(jobs), "--fresh"])
        results.append(runner.whole(runner.run("fuzzing", some, options)))
    assert results[0] == results[1] and len(results[0]) == 2
    assert [result["runs"] for result in results[0]] == [RUNS, RUNS] or any(result["finding"] for result in results[0])
