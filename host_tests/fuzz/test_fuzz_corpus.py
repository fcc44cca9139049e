# SPDX-License-Identifier: MIT
"""What fuzzing found worth keeping: run again with the sanitizers, with the answers on record, and enough to reach the
library's branches."""

import subprocess

import branches
import pytest
from fixel.base.errors import ToolError
from fixel.check import corpus, fuzz

TARGETS = list(corpus.HARNESSES)
LEAST = 90          # per cent of the branches of lib/
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
    done = replayed(build, target, "--record", record, *files)
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
    """branches.py says which branches count. Whoever adds code that no input reaches renews the corpus:
    fixel fuzz --renew-corpus."""
    programs = build / "host" / "fuzz"
    for target in TARGETS:
        branches.run(programs / f"branches_{target}", inputs(target), tmp_path)
    taken = branches.counts(programs / "branches" / "lib", tmp_path)
    assert len(taken) > 2000
    never = [place for place, count in sorted(taken.items()) if count == 0]
    percent = 100 * (1 - len(never) / len(taken))
    assert percent >= LEAST, f"{percent:.1f} % of {len(taken)} branches; never: {never}"


def test_corpus_is_small():
    assert sum(corpus.archive_of(target).stat().st_size for target in TARGETS) <= SIZE_MAX


def test_a_fuzzer_starts_on_a_folder_that_the_next_one_uses_too(monkeypatch, tmp_path):
    started = []
    monkeypatch.setattr(fuzz.corpus, "unpacked", lambda target, build: build / "inputs")
    monkeypatch.setattr(fuzz.children, "start", lambda command, **options: started.append(command))
    for number in (0, 1):
        worker = fuzz.start_worker("scene", number, tmp_path / "build", 5)
        assert worker.target == "scene" and (tmp_path / f"build/fuzz/scene-{number}.log").exists()
    assert [list(map(str, command[:4])) for command in started] == 2 * [[
        str(tmp_path / "build" / name) for name in ("host/fuzz/fuzz_scene", "fuzz/corpus/scene", "inputs")] + ["-max_total_time=5"]]
    assert (tmp_path / "build/fuzz/corpus/scene").is_dir() and (tmp_path / "build/fuzz/findings").is_dir()


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
