# SPDX-License-Identifier: MIT
"""What a run computed is kept by content: used again where all is the same, checked, bounded, and never in tests."""

import contextlib
import io
import json
import os
import shutil
import subprocess
import sys

import pytest
from conftest import CHECKOUT, LAUNCHER, TOOLS, environment, run_cli

from fixel.board import qemu, run as run_tool
from fixel.base import kept
from fixel.board.programs import HostPrograms
from fixel.report import report_frames

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/mps2-an386/walk.elf", "host/judge", "host/raycast",
                  "host/wire")
SCENE = "scenes/tiny.toml"
PARTS = ["board", "host", "double", "rays"]


@pytest.fixture
def allowed(monkeypatch):
    """As in a user's command."""
    monkeypatch.delenv("FIXEL_KEPT")
    monkeypatch.delenv("CI", raising=False)


@pytest.fixture
def folder(build, tmp_path):
    """A build folder with the real programs, and nothing kept."""
    (tmp_path / "build").mkdir()
    for name in ("host", "boards"):
        (tmp_path / "build" / name).symlink_to(build / name)
    return tmp_path / "build"


def walk(folder, *more, board="mps2-an385", **changes):
    """make run in this process, as in a user's command: (summary, its files, what it said)."""
    out, said = folder.parent / "out", io.StringIO()
    shutil.rmtree(out, ignore_errors=True)
    words = ["--board", board, "--scene", SCENE, "--frames", "2", "--out", str(out), "--build", str(folder), *more]
    with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        for name, value in {"FIXEL_KEPT": "", "CI": "", **changes}.items():
            patch.setenv(name, value)
        patch.chdir(CHECKOUT)
        qemu.version.cache_clear()
        assert run_tool.main(words) == 0, said.getvalue()
    summary = json.loads((out / "summary.json").read_text())
    return summary, {file.name: file.read_bytes() for file in out.iterdir() if file.name != "summary.json"}, said.getvalue()


def entries(folder):
    return sorted(file for file in (folder / "kept").iterdir() if not file.name.startswith("."))


# --- make run -----------------------------------------------------------------

def test_a_second_run_computes_nothing_and_gives_the_same(folder):
    first, files, _ = walk(folder)
    second, same, said = walk(folder)
    assert first.pop("kept") == [] and second.pop("kept") == PARTS
    assert (first, files) == (second, same) and "board.fxld" in files
    assert "board, host, double, rays: computed by an earlier command (FRESH=1 computes all)" in said


def test_fresh_computes_all(folder):
    walk(folder)
    assert walk(folder, "--fresh")[0]["kept"] == []
    assert walk(folder)[0]["kept"] == PARTS, "and keeps it"


@pytest.mark.parametrize("setting", [{"FIXEL_KEPT": "no"}, {"CI": "true"}, {"CI": "1"}])
def test_tests_and_integration_read_nothing_and_keep_nothing(folder, setting):
    assert walk(folder, **setting)[0]["kept"] == [] and not (folder / "kept").exists()
    walk(folder)
    assert walk(folder, **setting)[0]["kept"] == []


def test_another_board_draws_no_double_frame_again(folder):
    walk(folder)
    assert walk(folder, board="mps2-an386")[0]["kept"] == ["host", "double", "rays"]


def test_another_screen_is_another_picture(folder):
    walk(folder)
    assert walk(folder, "--screen", "64x48")[0]["kept"] == []


@pytest.mark.parametrize("name, left", [("boards/mps2-an385/walk.elf", ["host", "double", "rays"]),
                                        ("boards/host/walk", ["board", "double", "rays"]),
                                        ("host/judge", ["board", "host", "rays"]),
                                        ("host/raycast", ["board", "host", "double"])])
def test_another_program_computes_its_part_anew(build, folder, name, left):
    """A program that differs in a byte that does not matter: one more at its end."""
    walk(folder)
    top = name.split("/")[0]
    (folder / top).unlink()
    shutil.copytree(build / top, folder / top, copy_function=os.link, ignore=lambda where, names: {
        each for each in names if os.path.isdir(os.path.join(where, each)) and each not in ("mps2-an385", "host")
        or os.path.isdir(os.path.join(where, each)) and top == "host"})
    data = (folder / name).read_bytes()
    (folder / name).unlink()
    (folder / name).write_bytes(data + b"\0")
    (folder / name).chmod(0o755)
    assert walk(folder)[0]["kept"] == left


def test_another_emulator_draws_anew(folder, tmp_path):
    walk(folder)
    (tmp_path / "bin").mkdir()
    real = shutil.which("qemu-system-arm")
    (tmp_path / "bin" / "qemu-system-arm").write_text(
        f'#!/bin/sh\n[ "$1" = --version ] && echo "QEMU emulator version 99" || exec {real} "$@"\n')
    (tmp_path / "bin" / "qemu-system-arm").chmod(0o755)
    path = f"{tmp_path / 'bin'}:{os.environ['PATH']}"
    assert walk(folder, PATH=path)[0]["kept"] == ["host", "double", "rays"]


@pytest.mark.parametrize("damage", [lambda data: data[:-1], lambda data: data[:90] + bytes([data[90] ^ 1]) + data[91:],
                                    lambda data: b"", lambda data: b"x" + data, lambda data: data + b"\0"])
def test_a_damaged_entry_is_thrown_away_and_computed_anew(folder, damage):
    _, files, _ = walk(folder)
    for entry in entries(folder):
        entry.write_bytes(damage(entry.read_bytes()))
    summary, same, said = walk(folder)
    assert summary["kept"] == [] and files == same
    assert said.count("is damaged: it is thrown away, and what it held is computed anew") == 4
    assert walk(folder)[0]["kept"] == PARTS


def test_a_folder_that_cannot_be_written_fails_no_run(folder):
    (folder / "kept").write_text("a file")
    summary, _, said = walk(folder)
    assert summary["kept"] == [] and "cannot be written, so nothing is kept" in said


def test_two_runs_at_once_and_a_third(folder):
    command = [sys.executable, str(LAUNCHER), "run", "--board", "host", "--scene", SCENE, "--frames", "2",
               "--build", str(folder), "--out"]
    running = [subprocess.Popen([*command, str(folder.parent / f"out{number}")], cwd=CHECKOUT, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, env=environment(FIXEL_KEPT="", CI=""))
               for number in range(4)]
    for each in running:
        said = each.communicate()[0]
        assert each.returncode == 0 and "damaged" not in said, said
    assert len(entries(folder)) == 3, "board, double, rays"
    hashes = {json.dumps(json.loads((folder.parent / f"out{number}" / "summary.json").read_text())["frame_sha256"])
              for number in range(4)}
    assert len(hashes) == 1


# --- the folder ---------------------------------------------------------------

def obtain(store, number, size, tmp_path):
    """An entry of so many bytes that do not compress; how often it was computed."""
    file, count = tmp_path / "made", []

    def compute():
        count.append(1)
        file.write_bytes(bytes([number]) + os.urandom(size - 1))

    store.obtain("thing", [number], [file], compute)
    assert file.read_bytes()[0] == number and file.stat().st_size == size
    return len(count)


def test_the_oldest_use_goes_first(allowed, tmp_path, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 10_000)
    store = kept.Kept(tmp_path)
    assert [obtain(store, number, 3000, tmp_path) for number in (1, 2, 3)] == [1, 1, 1]
    assert obtain(store, 1, 3000, tmp_path) == 0, "used now"
    assert obtain(store, 4, 3000, tmp_path) == 1, "2 goes"
    assert [obtain(store, number, 3000, tmp_path) for number in (1, 3, 4)] == [0, 0, 0]
    assert obtain(store, 2, 3000, tmp_path) == 1
    assert sum(file.stat().st_size for file in (tmp_path / "kept").iterdir()) <= 10_000


def test_what_others_put_there_stays(allowed, tmp_path, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 10_000)
    (tmp_path / "kept").mkdir()
    (tmp_path / "kept" / "frame_0000.png").write_bytes(bytes(20_000))
    store = kept.Kept(tmp_path)
    assert [obtain(store, number, 6000, tmp_path) for number in (1, 1, 2, 1)] == [1, 0, 1, 1]
    assert (tmp_path / "kept" / "frame_0000.png").exists()


def test_what_is_larger_than_all_is_not_kept(allowed, tmp_path, monkeypatch):
    monkeypatch.setattr(kept, "MOST", 10_000)
    store = kept.Kept(tmp_path)
    assert obtain(store, 1, 3000, tmp_path) == 1
    assert obtain(store, 2, 10_001, tmp_path) == 1
    assert obtain(store, 1, 3000, tmp_path) == 0 and len(entries(tmp_path)) == 1


def test_all_entries_have_at_most_200_mb():
    assert kept.MOST == 200_000_000


def test_inputs_are_told_apart(tmp_path):
    (tmp_path / "one").write_bytes(b"1")
    (tmp_path / "same").write_bytes(b"1")
    keys = [kept.key_of(inputs) for inputs in (["ab", "c"], ["a", "bc"], ["abc"], [1], ["1"], [tmp_path / "one"], [None], [])]
    assert len(set(keys)) == len(keys)
    assert kept.key_of([tmp_path / "one"]) == kept.key_of([tmp_path / "same"])


def test_nothing_is_kept_of_inputs_that_change_meanwhile(allowed, tmp_path):
    program, made = tmp_path / "program", tmp_path / "made"
    program.write_text("old")

    def compute():
        program.write_text("new")
        made.write_text("of the new one")

    kept.Kept(tmp_path).obtain("thing", [program], [made], compute)
    assert not (tmp_path / "kept").exists()


def test_what_fails_is_not_kept(allowed, tmp_path):
    with pytest.raises(ZeroDivisionError):
        kept.Kept(tmp_path).obtain("thing", [1], [tmp_path / "made"], lambda: 1 / 0)
    assert not (tmp_path / "kept").exists()


def test_a_command_that_is_killed_leaves_whole_entries(allowed, tmp_path):
    """Killed at its first rename, when the entry has all its bytes and no name; the next command removes what is left."""
    program = (f"import os, pathlib, signal, sys\nsys.path.insert(0, {str(TOOLS)!r})\nfrom fixel.base import kept\n"
               "os.replace = lambda *_: os.kill(os.getpid(), signal.SIGKILL)\n"
               f"file = pathlib.Path({str(tmp_path / 'made')!r})\n"
               f"kept.Kept({str(tmp_path)!r}).obtain('thing', [1], [file], lambda: file.write_bytes(b'x' * 100))\n")
    assert subprocess.run([sys.executable, "-c", program], cwd=CHECKOUT, check=False).returncode == -9
    assert not entries(tmp_path) and len(list((tmp_path / "kept").glob(".fixel-kept-*"))) == 1
    run_cli("--help")
    assert not list((tmp_path / "kept").glob(".fixel-kept-*"))
    assert obtain(kept.Kept(tmp_path), 1, 100, tmp_path) == 1 and len(entries(tmp_path)) == 1


# --- other commands -----------------------------------------------------------

def test_a_report_shares_frames(allowed, folder, tmp_path, monkeypatch):
    """Its two walks of a scene, and the rays through the first one's frames, which it draws once more for them."""
    monkeypatch.chdir(CHECKOUT)
    found = report_frames.walks([SCENE], tmp_path, 2)

    def judge():
        programs = HostPrograms(folder, kept.Kept(folder))
        said = report_frames.judge_walks(programs, found, tmp_path)[:2], report_frames.cast_rays(programs, found[0], tmp_path, 1)
        return programs.kept.parts, said

    (first, said), (second, same) = judge(), judge()
    assert first == ["host", "double"] and second == ["host", "double"] * 3 + ["rays"] and said == same


def test_a_report_shares_the_frames_of_the_claim_scale(allowed, folder, tmp_path, monkeypatch):
    monkeypatch.chdir(CHECKOUT)
    scene = report_frames.walks([SCENE], tmp_path, 2)[0].scene

    def measure():
        programs = HostPrograms(folder, kept.Kept(folder))
        return report_frames.measure(programs, "mps2-an385", scene, tmp_path), programs.kept.parts

    (first, none), (second, parts) = measure(), measure()
    assert first == second and none == [] and parts == ["board"] * 4


def test_wireframes(folder, tmp_path):
    def wire():
        done = run_cli("wire", "--scene", SCENE, "--frames", 2, "--build", folder, "--out", tmp_path / "wire",
                       FIXEL_KEPT="", CI="")
        assert done.returncode == 0, done.stdout + done.stderr
        return json.loads((tmp_path / "wire/summary.json").read_text())

    first, second = wire(), wire()
    assert first.pop("kept") == [] and second.pop("kept") == ["wireframes"] and first == second
