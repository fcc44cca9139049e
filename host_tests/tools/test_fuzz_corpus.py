# SPDX-License-Identifier: MIT
"""What fuzzing found worth keeping: run again with the sanitizers, and enough to reach the library's branches."""

import subprocess

import branches
import pytest
from conftest import CHECKOUT

CORPUS = CHECKOUT / "host_tests" / "fuzz" / "corpus"
TARGETS = ["scene", "pipeline"]
LEAST = 90          # per cent of the branches of lib/
SIZE_MAX = 1 << 20  # bytes, so that a clone stays small


def inputs(target):
    return sorted((CORPUS / target).iterdir())


@pytest.mark.parametrize("target", TARGETS)
def test_corpus_runs_clean(build, target):
    files = inputs(target)
    assert len(files) > 10
    done = subprocess.run([build / "host" / "fuzz" / f"replay_{target}", *files], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_corpus_reaches_the_branches_of_the_library(build, tmp_path):
    """branches.py says which branches count. Whoever adds code that no input reaches renews the corpus:
    tools/fuzz.py --renew-corpus."""
    programs = build / "host" / "fuzz"
    for target in TARGETS:
        branches.run(programs / f"branches_{target}", inputs(target), tmp_path)
    taken = branches.counts(programs / "branches" / "lib", tmp_path)
    assert len(taken) > 2000
    never = [place for place, count in sorted(taken.items()) if count == 0]
    percent = 100 * (1 - len(never) / len(taken))
    assert percent >= LEAST, f"{percent:.1f} % of {len(taken)} branches; never: {never}"


def test_corpus_is_small():
    assert sum(file.stat().st_size for target in TARGETS for file in inputs(target)) <= SIZE_MAX
