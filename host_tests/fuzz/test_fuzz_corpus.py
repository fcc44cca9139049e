# SPDX-License-Identifier: MIT
"""What fuzzing found worth keeping: run again with the sanitizers, with the answers on record, and enough to reach the
library's branches."""

import pathlib
import subprocess

import pytest
from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.check import corpus, fuzz

BUILT_PROGRAMS = ("host/fuzz/replay_scene", "host/fuzz/replay_pipeline", "host/fuzz/branches_scene", "host/fuzz/branches_pipeline")
TARGETS = list(corpus.HARNESSES)
LEAST = 90          # per cent of the branches of lib/
# A renderer on a host draws by rows and planes what these draw on cores without a kernel: unit tests call them there.
CALLED_BY_TESTS = ("lib/paint/smooth_outline.c", "lib/draw/depth_pixel.c")
SIZE_MAX = 1 << 20  # bytes, so that a clone stays small


@pytest.fixture(scope="module", name="inputs")
def fixture_inputs(tmp_path_factory):
    """A function: the files of a target's inputs."""
    folder = tmp_path_factory.mktemp("corpus")
    return lambda target: corpus.unpack(corpus.read(corpus.archive_of(target)), folder / target)


@pytest.mark.parametrize("target", TARGETS)
def test_corpus_runs_clean_and_the_answers_are_on_record(build, inputs, target):
    """Where the library answers otherwise on purpose: remove the lines of the record that the failure names, and call
    fixel fuzz --add-records, which also adds those of new inputs."""
    files, record = inputs(target), corpus.record_of(target)
    assert len(files) > 10
    for sequence in (files, files[::-1]):       # so no answer depends on the inputs before
        done = replayed(build, target, "--record", record, *sequence)
        assert done.returncode == 0, done.stdout + done.stderr
    assert [line.split()[0] for line in record.read_text(encoding="ascii").splitlines()] == [file.name for file in files]


@pytest.mark.parametrize("target", TARGETS)
def test_other_answers_are_seen(build, inputs, target, tmp_path):
    files, record = inputs(target)[:20], tmp_path / "record.txt"
    lines = replayed(build, target, *files).stdout.splitlines()
    last = lines[7][-1]
    lines[7] = lines[7][:-1] + ("0" if last != "0" else "1")
    record.write_text("\n".join(lines[:-1]), encoding="ascii")
    done = replayed(build, target, "--record", record, *files)
    assert done.returncode == 1
    said = done.stdout.splitlines()
    assert [files[7].name in said[0], files[19].name in said[1], len(said)] == [True, True, 2]


def replayed(build, target, *words):
    return subprocess.run([build / "host" / "fuzz" / f"replay_{target}", *words], text=True, capture_output=True,
                          check=False)


def test_corpus_reaches_the_branches_of_the_library(build, inputs, tmp_path):
    """Whoever adds code that no input reaches renews the corpus:
    fixel fuzz --renew-corpus."""
    programs = build / "host" / "fuzz"
    for target in TARGETS:
        fuzz.run_branches(programs / f"branches_{target}", inputs(target), tmp_path)
    taken = {place: count for place, count in fuzz.branches_taken(programs / "branches" / "lib", tmp_path).items() if place[0] not in CALLED_BY_TESTS}
    assert len(taken) > 2000
    never = [place for place, count in sorted(taken.items()) if count == 0]
    percent = 100 * (1 - len(never) / len(taken))
    assert percent >= LEAST, f"{percent:.1f} % of {len(taken)} branches; never: {never}"


def test_corpus_is_small():
    assert sum(corpus.archive_of(target).stat().st_size for target in TARGETS) <= SIZE_MAX


# A fuzzer whose every second seed finds something; its words name its process, as those of a sanitizer do.
FUZZER = """#!/bin/sh
test "$1" = -merge=1 && exec cp found/new corpus/
for word in "$@"; do
    case $word in -seed=*) seed=${word#-seed=} ;; -runs=*) runs=${word#-runs=} ;; esac
done
test "$(tr ',' '\\n' <list | sort -c && wc -c <list)" -gt 1000 || exit 9
printf "%s" "$seed" >found/new
echo "stat::number_of_executed_units: $runs" >&2
test $((seed % 2)) -gt 0 && exit
echo "==$$==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x$$ at pc 0x$$" >&2
printf "crash of %s" "$seed" >crash-1
echo "artifact_prefix='./'; Test unit written to ./crash-1" >&2
exit 1
"""


def test_one_process_and_eight_find_the_same(tmp_path, monkeypatch):
    monkeypatch.chdir(CHECKOUT)
    for harness in TARGETS:
        program = fuzz.program_of(tmp_path, harness)
        program.parent.mkdir(parents=True, exist_ok=True)
        program.write_text(FUZZER)
        program.chmod(0o755)
    rows = []
    for jobs in (1, 8):
        options = fuzz.parser().parse_args(["--build", str(tmp_path), "--jobs", str(jobs)])
        options.runs = 3 * fuzz.SHARD + 1
        rows.append(fuzz.run_fuzzers(options))
    assert rows[0] == rows[1]
    what = "ERROR: AddressSanitizer: heap-buffer-overflow on address at pc"
    for row, harness in zip(rows[0], TARGETS, strict=True):
        assert row["harness"] == harness and row["runs"] == options.runs and row["inputs"] == {"new": b"4"}
        assert row["findings"] == [{"kind": "crash", "what": what, "input": b"crash of 2", "shards": 2}]
    found = fuzz.findings_of(rows[0], tmp_path)
    assert [pathlib.Path(each["input"]).name.rpartition("-")[0] for each in found] == [f"{harness}-crash" for harness in TARGETS]
    assert all((CHECKOUT / each["input"]).read_bytes() == b"crash of 2" for each in found)


def test_a_fuzzer_that_ends_without_an_input_is_one_sentence(tmp_path):
    program = fuzz.program_of(tmp_path, "scene")
    program.parent.mkdir(parents=True)
    program.write_text("#!/bin/sh\necho 'no memory' >&2\nexit 3\n")
    program.chmod(0o755)
    with pytest.raises(ToolError, match="^fuzz_scene ended with 3: no memory$"):
        fuzz.run_shard(tmp_path, {"harness": "scene", "shard": 0, "runs": 1})


def test_an_input_is_added_once(monkeypatch, tmp_path, capsys):
    harness = TARGETS[0]
    file, inputs, record = tmp_path / "input", {}, {}
    file.write_bytes(b"abc")
    name = corpus.name_of(b"abc")
    monkeypatch.setattr(corpus, "read", lambda archive: dict(inputs))
    monkeypatch.setattr(corpus, "write", lambda archive, made: inputs.update(made))
    monkeypatch.setattr(corpus, "read_record", lambda harness: dict(record))
    monkeypatch.setattr(corpus, "write_record", lambda harness, made: record.update(made))
    monkeypatch.setattr(corpus, "replayed", lambda harness, build, files: {file.name: "1" for file in files})
    monkeypatch.setattr(corpus, "with_answers", lambda harness, answers: {**record, **answers})
    corpus.add(harness, file, tmp_path)
    assert inputs == {name: b"abc"} and list(record.values()) == ["1"]
    record[name] = "1"
    with pytest.raises(ToolError, match="has this input already"):
        corpus.add(harness, file, tmp_path)
    del record[name]        # an input without an answer is no input yet
    corpus.add(harness, file, tmp_path)
    assert "1 inputs in all" in capsys.readouterr().out
