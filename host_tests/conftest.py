# SPDX-License-Identifier: MIT
"""What the tests of all rooms share: tools/ on the path, dumps made by hand, commands as a user runs them."""

import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import zlib

import named_programs
import numpy
import pytest
import warm_start

CHECKOUT = pathlib.Path(__file__).resolve().parents[1]
TOOLS = CHECKOUT / "tools"
LAUNCHER = TOOLS / "fixel" / "launcher.py"
sys.path.insert(0, str(TOOLS))

# A shell ignores one for what it starts in the background, nohup ignores the other, and what these start inherits it:
# the tests send both to programs.
signal.signal(signal.SIGINT, signal.default_int_handler)
signal.signal(signal.SIGHUP, signal.SIG_DFL)

os.environ["FIXEL_KEPT"] = "no"     # the tests compute everything (kept.py)

from fixel.base import bounded
bounded.start = warm_start.job_start(bounded.start)

named_programs.heed()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    """Each file of tests runs the programs that it names."""
    named_programs.of(item.module)


COUNTERS_OF_A_FRAME = (10, 3, 2, 1, 0, 4, 2, 0, 1)     # in == 3 + 2 + 1 + 0 + 4


def dump_bytes(frames, palette=None, promised=None, version=3, bits=8, instructions=1000):
    """A frame dump of docs/formats.md, section 2, written here from that section alone."""
    height, width = frames[0].shape
    palette = bytes(range(256)) * 3 if palette is None else palette
    count = len(frames) if promised is None else promised
    out = b"FXLD" + struct.pack("<HHHHI", version, width, height, bits, count) + palette
    for number, pixels in enumerate(frames):
        out += b"FRAM" + struct.pack("<I3i3I", number, 1, -2, 3, 4, 5, 6) + pixels.tobytes()
        out += struct.pack("<9IIQ", *COUNTERS_OF_A_FRAME, 0, instructions + number)
    out += b"FEND" + struct.pack("<I", len(frames))
    return out + struct.pack("<I", zlib.crc32(out))


def random_frames(count, height=24, width=32, seed=1):
    """Frames of noise."""
    generator = numpy.random.default_rng(seed)
    return [generator.integers(0, 256, (height, width), dtype=numpy.uint8) for _ in range(count)]


def write_files(root, files):
    """A small checkout: {path: text} below a folder, with the folders that they need."""
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def environment(**changes):
    """The environment of a user's own command, not of one under make test."""
    kept = {name: value for name, value in os.environ.items()
            if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES")}
    return {**kept, **changes}


def run_cli(command, *arguments, **changes):
    """fixel COMMAND as a finished process, run in the checkout. Without a limit of its own: fixel test
    limits the CPU time and the sleep of the tests of a file and all that they start."""
    return warm_start.run([str(LAUNCHER), command, *map(str, arguments)], CHECKOUT, environment(**changes))


def without_progress(text):
    """What a command said on stderr, less the lines that a slow machine hears of a scene that is compiled."""
    return [line for line in text.splitlines() if not line.startswith("scene: ")]


def run_make(*arguments, **changes):
    """make in the checkout as a finished process."""
    return subprocess.run(["make", *map(str, arguments)], cwd=CHECKOUT, stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=False,
                          env=environment(**changes))


def sampled(name, values, count):
    """So many of a test's parameters, in their order: what takes minutes whole. Other sources give another sample, and
    make test WHOLE=1 takes all."""
    from fixel.base import sampling
    values = list(values)
    if os.environ.get("FIXEL_WHOLE"):
        return values
    numbers = sampling.choose(CHECKOUT, name, range(len(values)), count)
    return [values[number] for number in sorted(numbers)]


def clipper_names(but=()):
    """The names that CLIPPER= takes, in their order, without those of `but`."""
    makefile = (CHECKOUT / "firmware" / "firmware.mk").read_text(encoding="utf-8")
    names = re.search(r"^CLIPPERS := (.*)$", makefile, re.MULTILINE)[1].split()
    assert set(but) <= set(names), f"{sorted(set(but) - set(names))} are no clippers"
    return [name for name in names if name not in but]


def dry_run(command, *settings):
    """make -n of a command: its steps. What its sub-makes would build is left out, which takes seconds to list."""
    return run_make("-n", command, *settings, "MAKE=:")


def assert_one_sentence(done, *words, code=2):
    """A command failed with the exit code, one line that begins with error:, and these words in it."""
    lines = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
    assert done.returncode == code, done.stdout + done.stderr
    assert len(lines) == 1, done.stderr
    assert "Traceback" not in done.stderr
    for word in words:
        assert word in lines[0]


@pytest.fixture(autouse=True)
def nothing_is_read():
    """Each test stands for a command of its own: what another one read is no input of it (reading.py)."""
    from fixel.base import reading
    reading._opened.clear()


@pytest.fixture
def checkout():
    """The root of the project."""
    return CHECKOUT


@pytest.fixture(scope="module")
def build():
    """The folder with the programs built; a test that asks for it needs those that its file names, or make all."""
    missing = named_programs.missing()
    assert not missing, f"not built: {missing}; make test ONLY= builds them, and make all most of them"
    return CHECKOUT / "build"


@pytest.fixture(scope="session")
def bench_programs():
    """What the tests of the bench run. make test builds them for these alone."""
    from board_programs import made
    made("bench-test-programs")


@pytest.fixture(scope="module")
def chromium():
    """A headless browser (browser.py)."""
    from fixel.view import browser
    with browser.chromium() as opened:
        yield opened
