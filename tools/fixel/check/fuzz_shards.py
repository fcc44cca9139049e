# SPDX-License-Identifier: MIT
"""The runs of the fuzzers, as a campaign (fixel/campaign/shards.py). A shard is a number of runs of a harness. It begins with
the inputs of the repository's corpus, in the order of their names, and its number is libFuzzer's seed.

Two things would make a shard another one each time. Addresses are input of libFuzzer's mutations, since it learns from what the
harness compares: so a fuzzer runs at the same addresses each time. And an input that takes too long does so on a clock: such a
result is not kept.
"""

import base64
import functools
import os
import pathlib
import re
import zlib

from fixel.base import children, scratch
from fixel.base.errors import ToolError, one_line
from fixel.campaign import shards
from fixel.check import corpus

SHARD = 2000            # runs
RUNS_MAX = 10 ** 12
INPUT_TIMEOUT = 60      # seconds for one input: wall time, since libFuzzer has no other, so enough for a loaded machine
WORDS = re.compile(r"runtime error:|does not hold|ERROR: \w+Sanitizer|ERROR: libFuzzer")
UNSTEADY = re.compile(r"==\d+==\s*|\b0x[0-9a-f]+\b|\(aka '[^']*'\)\s*")     # what is of a process, or of a platform
WRITTEN = re.compile(r"Test unit written to (\S+)")
EXECUTED = re.compile(r"^stat::number_of_executed_units: (\d+)", re.MULTILINE)
SAME_ADDRESSES = ("setarch", "-R")

SHARD_SETUP = "fuzz"


def program_of(build, harness):
    """The fuzzer of a harness."""
    return pathlib.Path(build) / "host" / "fuzz" / f"fuzz_{harness}"


@functools.cache
def prefix():
    """The words before a program that runs at the same addresses each time; none where the system forbids that."""
    return SAME_ADDRESSES if children.run([*SAME_ADDRESSES, "true"]).returncode == 0 else ()


def _fuzzer(folder, harness, *options):
    """A fuzzer that has ended. Its environment and its name on the stack are the same each time."""
    command = [*prefix(), "./fuzzer", *options, f"-max_len={corpus.HARNESSES[harness]}", f"-timeout={INPUT_TIMEOUT}",
               "-rss_limit_mb=2048"]
    try:
        return children.run(command, text=True, errors="replace", cwd=folder, env={"PATH": os.defpath})
    except OSError as error:
        raise ToolError(f"fuzz_{harness}: cannot be started: {error.strerror}; make fuzz builds it") from error


def first_words(text):
    """The line of a log that says what was wrong, the same in each process."""
    lines = text.splitlines()
    said = next((line for line in lines if WORDS.search(line)), lines[-1] if lines else "")
    return " ".join(UNSTEADY.sub("", said).split())


def _finding(folder, harness, done):
    """What ended a fuzzer, and the input; None if nothing was found."""
    if done.returncode == 0:
        return None
    written = WRITTEN.search(done.stderr)
    if written is None:
        raise ToolError(f"fuzz_{harness} ended with {done.returncode}: {one_line(first_words(done.stderr))}")
    kind = written[1].removeprefix("./").partition("-")[0]
    return {"kind": kind, "what": first_words(done.stderr), "input": _packed(folder / written[1])}


def _packed(file):
    return base64.b64encode(zlib.compress(file.read_bytes(), 9)).decode("ascii")


def content(packed):
    """The bytes of an input of a result."""
    return zlib.decompress(base64.b64decode(packed))


def run_shard(build, parameters):
    """{"runs", "inputs": {name: content} of those that reach code which the corpus does not, "finding"}."""
    harness = parameters["harness"]
    with scratch.folder("fuzz") as folder:
        files = corpus.unpack(corpus.read(corpus.archive_of(harness)), folder / "corpus")
        (folder / "list").write_text(",".join(f"corpus/{file.name}" for file in files), encoding="ascii")
        (folder / "found").mkdir()
        (folder / "fuzzer").symlink_to(program_of(build, harness).resolve())
        first = len(files) + 1      # libFuzzer's runs begin with the corpus and an empty input
        done = _fuzzer(folder, harness, "found", "-seed_inputs=@list", f"-runs={first + parameters['runs']}",
                       f"-seed={parameters['shard'] + 1}", "-reload=0", "-len_control=0", "-print_final_stats=1",
                       "-artifact_prefix=./")
        finding, executed = _finding(folder, harness, done), EXECUTED.search(done.stderr)
        result = {"runs": max(0, int(executed[1]) - first) if executed else 0, "inputs": _new_inputs(folder, harness, files),
                  "finding": finding}
    if not prefix() or finding and finding["kind"] == "timeout":
        result[shards.AGAIN] = True
    return result


def _new_inputs(folder, harness, files):
    """{name: content}: as few of what the fuzzer found as reach what all of it reaches beyond the corpus."""
    done = _fuzzer(folder, harness, "-merge=1", "-merge_control_file=control", "-use_counters=0", "corpus", "found")
    if done.returncode:
        raise ToolError(f"fuzz_{harness} cannot sort its inputs: {one_line(first_words(done.stderr))}")
    known = {file.name for file in files}
    return {file.name: _packed(file) for file in sorted((folder / "corpus").iterdir()) if file.name not in known}


def shard_inputs(build, parameters):
    return [program_of(build, parameters["harness"]), corpus.archive_of(parameters["harness"])]


def shard_targets(build, parameters):
    return [str(program_of(build, parameters["harness"]))]


def plan(runs):
    """The shards of so many runs of each harness."""
    counts = [min(SHARD, runs - first) for first in range(0, runs, SHARD)]
    return [shards.Shard("fuzz", place * len(counts) + number, {"harness": harness, "shard": number, "runs": count}, harness, count)
            for place, harness in enumerate(corpus.HARNESSES) for number, count in enumerate(counts)]


def merge(some, results):
    """[{"harness", "runs", "inputs": {name: content}, "findings": [{"kind", "what", "input": content, "shards"}]}] of the
    shards' results, in order. Of the findings with the same words there is the first."""
    rows = {harness: {"harness": harness, "runs": 0, "inputs": {}, "findings": {}} for harness in corpus.HARNESSES}
    for shard, result in zip(some, results, strict=True):
        row, found = rows[shard.parameters["harness"]], result["finding"]
        row["runs"] += result["runs"]
        row["inputs"].update((name, content(packed)) for name, packed in result["inputs"].items())
        if found:
            first = row["findings"].setdefault(found["what"], {**found, "input": content(found["input"]), "shards": 0})
            first["shards"] += 1
    return [{**row, "findings": list(row["findings"].values())} for row in rows.values()]
