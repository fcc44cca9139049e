# SPDX-License-Identifier: MIT
"""Fuzzes the scene loader and the whole pipeline, and prints which branches were reached.

    fixel fuzz --runs N --build DIR                        what make fuzz does
    fixel fuzz ... --renew-corpus                          then renews host_tests/fuzz/corpus
    fixel fuzz --add-records --build DIR                   fuzzes nothing: adds to host_tests/fuzz/record

The runs are a campaign: the same checkout and number of runs give the same result. A shard is a number of runs of a harness. It begins
with the inputs of the repository's corpus, in the order of their names, and its number is libFuzzer's seed. Two things would make a
shard another one each time. Addresses are input of libFuzzer's mutations, since it learns from what the harness compares: so a fuzzer
runs at the same addresses each time. And an input that takes too long does so on a clock: such a result is not kept. Inputs that reach code
which the corpus does not are written below DIR/fuzz/found, for --renew-corpus. A record has a line for each input of the
corpus: its name, and a hash of all that the library answered. Lines are added for new inputs, and removed with theirs;
no command alters one.
Exit: 0 nothing found, 1 findings (each kept as a file), 2 could not run.
"""

import argparse
import base64
import collections
import functools
import gzip
import json
import os
import pathlib
import re
import shutil
import sys
import zlib

from fixel.base import children, output, scratch
from fixel.base.arguments import whole_number
from fixel.base.errors import one_line, ToolError
from fixel.base.table import coloured
from fixel.campaign import runner, shards
from fixel.check import corpus
from fixel.check.corpus import CHECKOUT, relative

TARGETS = corpus.HARNESSES
SEED_SCENES = ("scenes/tiny.toml", "scenes/cube.toml",
               *sorted(str(file) for file in (CHECKOUT / "host_tests/fuzz/scenes").glob("*.toml")))


# --- the run -----------------------------------------------------------------
SHARD = 2000            # runs
RUNS_MAX = 10 ** 12
INPUT_TIMEOUT = 60      # seconds for one input: wall time, since libFuzzer has no other, so enough for a loaded machine
WORDS = re.compile(r"runtime error:|does not hold|ERROR: \w+Sanitizer|ERROR: libFuzzer")
UNSTEADY = re.compile(r"==\d+==\s*|\b0x[0-9a-f]+\b|\(aka '[^']*'\)\s*")     # what is of a process, or of a platform
WRITTEN = re.compile(r"Test unit written to (\S+)")
EXECUTED = re.compile(r"^stat::number_of_executed_units: (\d+)", re.MULTILINE)
SAME_ADDRESSES = ("setarch", "-R")

SHARD_SETUP = "fuzz"


def run_fuzzers(options):
    """The merged results of each harness's shards."""
    some = plan(options.runs)
    done = runner.run(f"fuzzing, {options.runs:,} runs of each harness, in shards", some, options)
    results = runner.whole(done)
    done.tell(options.build)
    if any(shards.AGAIN in result and not result["finding"] for result in results):
        print("this system does not let a program run at the same addresses each time (setarch -R), as containers often do "
              "not: another run may find other inputs, and none is kept", file=sys.stderr)
    return merge(some, results)


def written(build, name):
    """An empty folder below the build folder."""
    folder = build / "fuzz" / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def findings_of(rows, build):
    """What was found, as JSON has it: each input is a file, with the command that runs it again."""
    folder, found = written(build, "findings"), []
    for row in rows:
        for each in row["findings"]:
            file = folder / f"{row['harness']}-{each['kind']}-{corpus.name_of(each['input'])}"
            file.write_bytes(each["input"])
            found.append({"target": row["harness"], "what": each["what"], "shards": each["shards"], "input": relative(file),
                          "command": f"{relative(program_of(build, row['harness']))} {relative(file)}"})
    return found


# --- branches ------------------------------------------------------------------

def run_tool(command, folder=CHECKOUT, **environment):
    """Standard output of a command that must end well."""
    try:
        done = children.run(command, text=True, errors="replace", cwd=folder, env={**os.environ, **environment})
    except OSError as error:
        raise ToolError(f"{command[0]}: cannot be started: {error.strerror}; "
                        "tools/setup.sh fuzz installs it") from error
    if done.returncode:
        raise ToolError(f"{command[0]} failed: {(done.stderr.strip().splitlines() or ['?'])[-1]}")
    return done.stdout


# A condition that the compiler cannot decide has two branches, a switch one a case. What the compiler decides in this build (FXL_IS_SMALL,
# the kernels of other cores) or leaves out (FXL_ASSERT) has none. A function of a header counts once, however many files include it.

def run_branches(program, files, folder):
    """Runs a program that counts branches on files. What it counts is added to that of the runs before in the folder."""
    run_tool([program, *files], GCOV_PREFIX=str(folder))


def branches_taken(objects, folder):
    """{(file, line, number of the branch in the line): times taken} of lib/. An object of a source that is gone does not
    count."""
    place = folder / objects.resolve().relative_to("/")
    for notes in objects.rglob("*.gcno"):
        if not (CHECKOUT / "lib" / notes.relative_to(objects)).with_suffix(".c").exists():
            continue
        to = place / notes.relative_to(objects)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(notes, to)
    run_tool(["gcov", "--json-format", "--branch-probabilities", "--preserve-paths", *sorted(place.rglob("*.gcno"))], folder=place)
    taken = collections.Counter()
    for report in place.glob("*.gcov.json.gz"):
        for file in json.loads(gzip.decompress(report.read_bytes()))["files"]:
            name = relative(CHECKOUT / file["file"])
            if name.startswith("lib/"):
                _add_lines(taken, name, file["lines"])
    return taken


def _add_lines(taken, name, lines):
    numbers = collections.Counter()
    for line in lines:
        number = line["line_number"]
        for branch in line["branches"]:
            taken[name, number, numbers[number]] += branch["count"]
            numbers[number] += 1


def measure_branches(build):
    """Percentage of lib's branches that all inputs take, in the repository and found, how many branches there are, and the others."""
    programs = build / "host" / "fuzz"
    with scratch.folder("branches") as folder:
        for target in TARGETS:
            files = [*corpus.unpacked(target, build).iterdir(), *(build / "fuzz" / "found" / target).iterdir()]
            run_branches(programs / f"branches_{target}", files, folder)
        taken = branches_taken(programs / "branches" / "lib", folder)
    if not taken:
        raise ToolError("gcov saw no branch of lib/; remove build/host/fuzz and try again")
    uncovered = [{"file": file, "line": line, "branch": number,
                  "text": (CHECKOUT / file).read_text(encoding="utf-8").splitlines()[line - 1].strip()}
                 for (file, line, number), count in sorted(taken.items()) if count == 0]
    return 100 * (len(taken) - len(uncovered)) / len(taken), len(taken), uncovered


# --- the corpus of the repository -----------------------------------------------

def make_seeds(build):
    """First inputs, of which the corpus takes what reaches something."""
    run_tool([sys.executable, CHECKOUT / "host_tests" / "fuzz" / "seeds.py", written(build, "found"), *SEED_SCENES])
    renew_corpus(build)


def renew_corpus(build):
    """As few inputs as reach what all together reach, into the repository."""
    for target in TARGETS:
        with scratch.folder("corpus") as new:
            run_tool([build / "host" / "fuzz" / f"fuzz_{target}", "-set_cover_merge=1",
                      "-use_counters=0", f"-max_len={TARGETS[target]}", new,
                      build / "fuzz" / "found" / target, corpus.unpacked(target, build)])
            inputs = {file.name: file.read_bytes() for file in new.iterdir()}
        corpus.write(corpus.archive_of(target), inputs)
        print(f"{relative(corpus.archive_of(target))}: {len(inputs)} inputs, "
              f"{sum(map(len, inputs.values())):,} bytes", file=sys.stderr)


# --- the tools' input ---------------------------------------------------------------

def fuzz_tools_input(examples, seed):
    """The tests that give the tools random input, with so many examples."""
    environment = {**os.environ, "FUZZ_SEED": str(seed), "FUZZ_EXAMPLES": str(examples)}
    done = children.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider",
                         str(CHECKOUT / "host_tests" / "fuzz" / "test_input_fuzz.py")],
                        cwd=CHECKOUT, env=environment, stdout=None, stderr=None)
    if done.returncode:
        raise ToolError("the tools failed on random input; pytest's words are above", exit_code=1)


# --- all together -----------------------------------------------------------------

def print_result(result, total):
    """For people."""
    for each in result["targets"]:
        print(f"{each['target']:10} {each['executions']:>12,} executions, {each['inputs']:,} inputs reach code that the corpus does not")
    print(f"branches of lib reached: {result['branches_percent']:.2f} % of {total}")
    for each in result["uncovered"]:
        print(f"  {each['file']}:{each['line']} branch {each['branch']} never: {each['text']}")
    for each in result["findings"]:
        print(f"{coloured('FINDING', 'red')} in {each['target']}, in {each['shards']} shards: {each['what']}")
        print(f"  again: {each['command']}")
    if not result["findings"]:
        print(f"{coloured('nothing found', 'green')} in {result['executions']:,} executions")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--runs", default="10000", help="of each harness (RUNS=)")
    made.add_argument("--examples", type=int, default=0,
                      help="first give the tools so many random inputs a test; --runs chooses which")
    made.add_argument("--build", default="build", help="folder of the programs")
    made.add_argument("--renew-corpus", action="store_true",
                      help="then renew the corpus of the repository")
    made.add_argument("--add-records", action="store_true", help="fuzz nothing, add records of the corpus's new inputs")
    runner.add_options(made)
    return made


def before(options):
    """The number of runs; refuses what is none."""
    return whole_number("--runs", options.runs, 1, RUNS_MAX)


def main(argv):
    options = parser().parse_args(argv)
    options.runs = before(options)
    runner.jobs_of(options)
    build = options.build = pathlib.Path(options.build).resolve()
    if options.add_records:
        corpus.add_records(build)
        return 0
    if options.examples:
        fuzz_tools_input(options.examples, options.runs)
    if options.renew_corpus:
        make_seeds(build)
    rows = run_fuzzers(options)
    for row in rows:
        folder = written(build, f"found/{row['harness']}")
        for name, content in row["inputs"].items():
            (folder / name).write_bytes(content)
    findings = findings_of(rows, build)
    if options.renew_corpus and not findings:
        renew_corpus(build)
        corpus.add_records(build)
    percent, total, uncovered = measure_branches(build)
    result = {"executions": sum(row["runs"] for row in rows), "crashes": len(findings), "branches_percent": round(percent, 2),
              "targets": [{"target": row["harness"], "executions": row["runs"], "inputs": len(row["inputs"])} for row in rows],
              "findings": findings, "uncovered": uncovered}
    output.write_json(build / "fuzz" / "fuzz.json", result)
    print_result(result, total)
    print(f"JSON: {relative(build / 'fuzz' / 'fuzz.json')}", file=sys.stderr)
    return 1 if findings else 0


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
