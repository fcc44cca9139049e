# SPDX-License-Identifier: MIT
"""Fuzzes the scene loader and the whole pipeline, and prints which branches were reached.

    fixel fuzz --seconds N --build DIR [--clang CLANG]     what make fuzz does
    fixel fuzz ... --renew-corpus                          then renews host_tests/fuzz/corpus
    fixel fuzz --add-records --build DIR                   fuzzes nothing: adds to host_tests/fuzz/record

Inputs that the run found stay under DIR/fuzz/corpus and begin the next run. A record has a line for each input of the
corpus: its name, and a hash of all that the library answered. Lines are added for new inputs, and removed with theirs;
no command alters one.
Exit: 0 nothing found, 1 findings (each kept as a file), 2 could not run.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from fixel.base import children, output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import coloured
from fixel.check import corpus
from fixel.check.corpus import CHECKOUT, relative

TARGETS = corpus.HARNESSES
SEED_SCENES = ("scenes/tiny.toml", "scenes/cube.toml",
               *sorted(str(file) for file in (CHECKOUT / "host_tests/fuzz/scenes").glob("*.toml")))
INPUT_TIMEOUT = 60      # seconds for one input: wall time, since libFuzzer has no other, so enough for a loaded machine
GRACE = 180             # seconds that a fuzzer may end after its time: an input that hangs, and a loaded machine
PLAIN_INTERVAL = 10.0   # seconds between two lines where there is no terminal
WORDS = re.compile(r"runtime error:|does not hold|ERROR: \w+Sanitizer|ERROR: libFuzzer")


@dataclasses.dataclass
class Worker:
    """One fuzzing process."""
    target: str
    process: subprocess.Popen
    log: pathlib.Path
    told: bool = False

    def text(self):
        return self.log.read_text(errors="replace")

    def executions(self):
        """So far, or in all."""
        text = self.text()
        final = re.search(r"^stat::number_of_executed_units: (\d+)", text, re.MULTILINE)
        seen = re.findall(r"^#(\d+)\t", text, re.MULTILINE)
        return int(final[1]) if final else int(seen[-1]) if seen else 0

    def failed(self):
        return self.process.poll() not in (None, 0)


# --- the run -----------------------------------------------------------------

def start_worker(target, number, build, seconds):
    """A fuzzer on the corpus that all workers of its target share."""
    folder = build / "fuzz"
    kept, findings = folder / "corpus" / target, folder / "findings"
    for each in (kept, findings):
        each.mkdir(parents=True, exist_ok=True)
    log = folder / f"{target}-{number}.log"
    command = [build / "host" / "fuzz" / f"fuzz_{target}", kept, corpus.unpacked(target, build),
               f"-max_total_time={seconds}", f"-max_len={TARGETS[target]}", "-len_control=0",
               f"-timeout={INPUT_TIMEOUT}", "-rss_limit_mb=2048", "-reload=5",
               "-print_final_stats=1", f"-artifact_prefix={findings}/{target}-"]
    with log.open("wb") as out:
        try:
            process = children.start(command, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                     cwd=CHECKOUT)
        except OSError as error:
            raise ToolError(f"{relative(command[0])}: cannot be started ({error.strerror}); "
                            "make fuzz builds it") from error
    return Worker(target, process, log)


def say(text, terminal):
    """One line that changes on a terminal, plain lines elsewhere."""
    print(f"\r{text:<79}" if terminal else text, file=sys.stderr, flush=True,
          end="" if terminal else "\n")


def watch(workers, seconds):
    """Until all have ended; says how far they are."""
    terminal = sys.stderr.isatty()
    started = time.monotonic()
    shown = started
    while any(worker.process.poll() is None for worker in workers):
        time.sleep(0.2)
        now = time.monotonic()
        if now - started > seconds + GRACE:
            raise ToolError(f"a fuzzer is still running {GRACE} s after its time; "
                            f"its words are in {relative(workers[0].log.parent)}/*.log")
        for worker in workers:
            if worker.failed() and not worker.told:
                worker.told = True
                say(f"fuzz: a finding in {worker.target}: {first_words(worker.text())}", False)
        if now - shown >= (0.5 if terminal else PLAIN_INTERVAL):
            shown = now
            done = sum(worker.executions() for worker in workers)
            say(f"fuzz: {now - started:.0f} of {seconds} s, {done:,} executions", terminal)
    if terminal:
        say("", True)
        print("\r", end="", file=sys.stderr)


def run_fuzzers(build, seconds):
    """Workers that have ended: as many as there are cores, each target at least once."""
    count = max(len(TARGETS), os.cpu_count() or 1)
    names = list(TARGETS)
    workers = []
    try:
        for number in range(count):
            workers.append(start_worker(names[number % len(names)], number // len(names), build,
                                        seconds))
        watch(workers, seconds)
    finally:
        for worker in workers:
            if worker.process.poll() is None:
                worker.process.kill()
                worker.process.wait()
    return workers


def first_words(text):
    """The line of a log that says what was wrong."""
    lines = text.splitlines()
    return next((line.strip() for line in lines if WORDS.search(line)), lines[-1] if lines else "")


def findings_of(workers, build):
    """What each failed worker found, and the command that runs it again."""
    found = []
    for worker in workers:
        if not worker.failed():
            continue
        text = worker.text()
        written = re.search(r"Test unit written to (\S+)", text)
        program = relative(build / "host" / "fuzz" / f"fuzz_{worker.target}")
        file = relative(written[1]) if written else None
        found.append({"target": worker.target, "what": first_words(text), "input": file,
                      "log": relative(worker.log),
                      "command": f"{program} {file}" if file else None})
    return found


# --- branches ------------------------------------------------------------------

def run_tool(command, **environment):
    """Standard output of a command that must end well."""
    try:
        done = children.run(command, text=True, errors="replace", cwd=CHECKOUT, env={**os.environ, **environment})
    except OSError as error:
        raise ToolError(f"{command[0]}: cannot be started: {error.strerror}; "
                        "tools/setup.sh fuzz installs it") from error
    if done.returncode:
        raise ToolError(f"{command[0]} failed: {(done.stderr.strip().splitlines() or ['?'])[-1]}")
    return done.stdout


def llvm_tool(clang, name):
    """The LLVM tool that belongs to a clang."""
    found = run_tool([clang, f"--print-prog-name={name}"]).strip()
    if not shutil.which(found):
        raise ToolError(f"{name} of {clang} is missing; tools/setup.sh fuzz installs it")
    return found


def replay_for_branches(build):
    """Profiles of all inputs, in the repository and found."""
    profiles = []
    for target in TARGETS:
        profile = build / "fuzz" / f"{target}.profraw"
        profile.unlink(missing_ok=True)
        run_tool([build / "host" / "fuzz" / f"cover_{target}", "-runs=0", corpus.unpacked(target, build),
                  build / "fuzz" / "corpus" / target],
                 LLVM_PROFILE_FILE=str(profile))
        profiles.append(profile)
    return profiles


def branch_sides(exported):
    """{(file, line, column): [times true, times false]} of lib/, over all instances."""
    sides = {}
    for file in exported["files"]:
        name = relative(file["filename"])
        for line, column, _, _, true, false, *_ in file["branches"]:
            counts = sides.setdefault((name, line, column), [0, 0])
            counts[0] += true
            counts[1] += false
    return {place: counts for place, counts in sides.items() if place[0].startswith("lib/")}


def measure_branches(build, clang):
    """Percentage of lib's branch sides that were taken, how many there are, and the others."""
    profiles = replay_for_branches(build)
    merged = build / "fuzz" / "all.profdata"
    run_tool([llvm_tool(clang, "llvm-profdata"), "merge", "-o", merged, *profiles])
    programs = [build / "host" / "fuzz" / f"cover_{target}" for target in TARGETS]
    exported = json.loads(run_tool([llvm_tool(clang, "llvm-cov"), "export", programs[0],
                                    "-object", programs[1], f"-instr-profile={merged}"]))
    sides = branch_sides(exported["data"][0])
    uncovered = []
    for (file, line, column), counts in sorted(sides.items()):
        text = (CHECKOUT / file).read_text(encoding="utf-8").splitlines()[line - 1].strip()
        uncovered += [{"file": file, "line": line, "column": column, "never": side, "text": text}
                      for side, count in zip(("true", "false"), counts) if count == 0]
    total = 2 * len(sides)
    if total == 0:
        raise ToolError("llvm-cov saw no branch of lib/; remove build/host/fuzz and try again")
    return 100 * (total - len(uncovered)) / total, total, uncovered


# --- the corpus of the repository -----------------------------------------------

def make_seeds(build):
    """First inputs, beside those that runs found."""
    run_tool([sys.executable, CHECKOUT / "host_tests" / "fuzz" / "seeds.py",
              build / "fuzz" / "corpus", *SEED_SCENES])


def renew_corpus(build):
    """As few inputs as reach what all together reach, into the repository."""
    for target in TARGETS:
        with scratch.folder("corpus") as new:
            run_tool([build / "host" / "fuzz" / f"fuzz_{target}", "-set_cover_merge=1",
                      "-use_counters=0", f"-max_len={TARGETS[target]}", new,
                      build / "fuzz" / "corpus" / target, corpus.unpacked(target, build)])
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
        print(f"{each['target']:10} {each['executions']:>12,} executions, "
              f"{each['inputs']:,} inputs kept")
    print(f"branches of lib reached: {result['branches_percent']:.2f} % of {total}")
    for each in result["uncovered"]:
        print(f"  {each['file']}:{each['line']}:{each['column']} never {each['never']}: "
              f"{each['text']}")
    for each in result["findings"]:
        print(f"{coloured('FINDING', 'red')} in {each['target']}: {each['what']}")
        print(f"  again: {each['command']}" if each["command"] else f"  see {each['log']}")
    if not result["findings"]:
        print(f"{coloured('nothing found', 'green')} in {result['seconds']} s, "
              f"{result['executions']:,} executions")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--seconds", type=int, default=60, help="time of fuzzing")
    made.add_argument("--examples", type=int, default=0,
                      help="first give the tools so many random inputs a test; --seconds chooses which")
    made.add_argument("--build", default="build", help="folder of the programs")
    made.add_argument("--clang", default="clang", help="the clang that built them")
    made.add_argument("--renew-corpus", action="store_true",
                      help="then renew the corpus of the repository")
    made.add_argument("--add-records", action="store_true", help="fuzz nothing, add records of the corpus's new inputs")
    return made


def main(argv):
    options = parser().parse_args(argv)
    if options.seconds < 1:
        raise ToolError(f"--seconds {options.seconds} is less than 1")
    build = pathlib.Path(options.build).resolve()
    if options.add_records:
        corpus.add_records(build)
        return 0
    if options.examples:
        fuzz_tools_input(options.examples, options.seconds)
    if options.renew_corpus:
        make_seeds(build)
    workers = run_fuzzers(build, options.seconds)
    findings = findings_of(workers, build)
    if options.renew_corpus and not findings:
        renew_corpus(build)
        corpus.add_records(build)
    percent, total, uncovered = measure_branches(build, options.clang)
    targets = [{"target": target,
                "executions": sum(worker.executions() for worker in workers
                                  if worker.target == target),
                "inputs": len(list((build / "fuzz" / "corpus" / target).iterdir()))}
               for target in TARGETS]
    result = {"seconds": options.seconds,
              "executions": sum(each["executions"] for each in targets),
              "crashes": len(findings), "branches_percent": round(percent, 2),
              "targets": targets, "findings": findings, "uncovered": uncovered}
    output.write_json(build / "fuzz" / "fuzz.json", result)
    print_result(result, total)
    print(f"JSON: {relative(build / 'fuzz' / 'fuzz.json')}", file=sys.stderr)
    return 1 if findings else 0
