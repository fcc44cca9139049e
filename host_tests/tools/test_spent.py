# SPDX-License-Identifier: MIT
"""A command of make says the CPU time that it took, with all that it started."""

import os
import re
import resource

from conftest import run_cli, run_make

SETTINGS = ["BOARD=host", "SCENE=scenes/tiny.toml", "FRAMES=1"]


def told(done):
    """The seconds, which are the last word on stderr; None without them."""
    found = re.search(r"^(\d+\.\d) s of CPU\n\Z", done.stderr, re.MULTILINE)
    return float(found[1]) if found else None


def test_a_command_tells_what_all_its_processes_took(build, tmp_path):
    """The kernel's count of them all, less what make does after the tool's last word."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = run_make("run", *SETTINGS, f"OUT={tmp_path / 'out'}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    assert done.returncode == 0, done.stdout + done.stderr
    assert 0.8 * taken <= told(done) <= taken + 0.2


def test_a_tool_that_no_make_started_tells_nothing(build, tmp_path):
    words = ["--board", "host", "--scene", "scenes/tiny.toml", "--frames", "1", "--out", tmp_path / "out"]
    assert told(run_cli("run", *words)) is None


def test_what_this_process_took_counts():
    from fixel.base import spent
    before, own = spent.seconds(), sum(os.times()[:2])
    while sum(os.times()[:2]) < own + 0.2:
        sum(range(10_000))
    assert spent.seconds() > before + 0.15    # the kernel counts in hundredths


def test_what_the_kernel_says_of_this_process():
    from fixel.base import spent
    _, parent, taken = spent._process(os.getpid())
    own = sum(os.times()[:4])
    assert parent == os.getppid() and 0.5 * own < taken <= own + 0.001   # sums of hundredths
