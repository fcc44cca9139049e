# SPDX-License-Identifier: MIT
"""What fuzzing found worth keeping, run again with the sanitizers."""

import subprocess

import pytest
from conftest import CHECKOUT

CORPUS = CHECKOUT / "host_tests" / "fuzz" / "corpus"


@pytest.mark.parametrize("target", ["scene", "pipeline"])
def test_corpus_runs_clean(build, target):
    files = sorted((CORPUS / target).iterdir())
    assert len(files) > 10
    done = subprocess.run([build / "host" / "fuzz" / f"replay_{target}", *files], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
