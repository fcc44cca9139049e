# SPDX-License-Identifier: MIT
"""The counting plugin: loops counted by hand, both versions of QEMU's interface, runs that repeat."""

import re
import subprocess
import types

import pytest

from conftest import CHECKOUT
from fixel.bench import bench_plan, bench_run, counter
from fixel.board import execute
from fixel.base.errors import ToolError
from fixel.bench.machine_code import MachineCode

BUILT_PROGRAMS = ("bench/*", "host/bench_counter.so")
pytestmark = pytest.mark.usefixtures("bench_programs")
PLUGIN = "host/bench_counter.so"
# A program of the double's: main at 100 calls f at 200, which calls g by a jump at its end.
PROGRAM = """begin 10
end 20
function 100 140
function 200 210
function 300 310
call 106
return 304
"""
BLOCKS = "block 10 2\nblock 20 2\nblock 100 24\nblock 106 2\nblock 200 22\nblock 300 4\n"
WAY = ["100", "200", "300", "106"]


def built(name=""):
    """A file of the build, which bench_programs has had built."""
    path = CHECKOUT / "build" / name
    assert path.exists(), f"{path} is not built"
    return path


@pytest.mark.parametrize("core", bench_plan.CORES)
def test_counts_what_was_counted_by_hand(core, tmp_path):
    elf, plugin = built(f"bench/{core}/calibration.elf"), built(PLUGIN)
    output, counts = counter.run(elf, MachineCode(elf), plugin, tmp_path)
    said = {name: int(number) for name, number in re.findall(r"^bench: calibration (\S+) (\d+)$", output, re.MULTILINE)}
    assert said["long-loop"] > 2_000_000 and said["empty"] == 0
    assert counts.regions == list(said.values())


def test_detail_adds_up_to_the_regions_and_knows_the_calls(tmp_path):
    elf, plugin = built("bench/m3/calibration.elf"), built(PLUGIN)
    code = MachineCode(elf)
    _, counts = counter.run(elf, code, plugin, tmp_path, detail=True)
    everywhere = counter.by_address(counts)
    assert sum(times for times, _ in everywhere.values()) == sum(counts.regions) + len(counts.regions)
    (times, left), = [everywhere[address] for address, instruction in code.each_instruction()
                      if instruction.kind == "branch conditional" and everywhere.get(address, (0, 0))[0] == 1_000_003]
    assert (times, left) == (1_000_003, 1_000_002)


def test_two_runs_are_equal_to_the_instruction(tmp_path):
    plan = bench_plan.Plan(built())
    image, _ = bench_plan.compile_scene(plan.workload("w1"), tmp_path)
    elf = plan.program("m3", "fixel")
    runs = []
    for number in range(2):
        folder = tmp_path / str(number)
        folder.mkdir()
        _, counts = counter.run(elf, MachineCode(elf), plan.counter, folder, image, frames=4, detail=True)
        runs.append((counts.regions, counter.by_address(counts), counts.nodes))
    assert len(runs[0][0]) == 4 and min(runs[0][0]) > 10_000
    assert runs[0] == runs[1]


def test_the_kernels_are_those_of_the_plan_and_repeat():
    plan = bench_plan.Plan(built())
    first = bench_run.kernels(plan, "m3")
    assert set(first) == set(plan.kernels)
    assert first == bench_run.kernels(plan, "m3")


def double(folder, *flags):
    """The double of QEMU, compiled."""
    program = folder / "qemu_double"
    subprocess.run(["gcc", "-std=gnu11", "-rdynamic", *flags, str(CHECKOUT / "host_tests/boards/qemu_double.c"),
                    "-o", str(program), "-ldl"], check=True)
    return program


def play(folder, program, way, *arguments):
    """(what the double printed, Counts) of a way through the blocks."""
    (folder / "program.map").write_text(PROGRAM)
    script = BLOCKS + "".join(f"run {address}\n" for address in way)
    done = subprocess.run([str(program), str(built(PLUGIN)), f"map={folder}/program.map",
                           f"out={folder}/counts.txt", *arguments], input=script, capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout, counter.parse((folder / "counts.txt").read_text())


@pytest.mark.parametrize("flags, version", [((), 1), (("-DSCOREBOARD",), 2)])
def test_speaks_the_version_of_the_interface_that_is_there(tmp_path, flags, version):
    said, counts = play(tmp_path, double(tmp_path, *flags), ["10", *WAY, "20"])
    assert said == f"version {version}\n"
    assert counts.regions == [2 + 2 + 1 + 1]


def test_follows_calls_jumps_and_returns(tmp_path):
    _, counts = play(tmp_path, double(tmp_path), ["300", "10", *WAY, *WAY, "20", "300", "10", "106", "20"], "detail=on")
    assert counts.regions == [12, 1]
    nodes = {function: (number, parent, back) for number, (parent, function, back) in counts.nodes.items()}
    assert nodes[0][1:] == (0, 0)
    assert nodes[1][1:] == (nodes[0][0], 0x106)
    assert nodes[2][1:] == (nodes[1][0], 0)     # jumped to: comes back where f would
    seen = {(counts.blocks[block][0], node): (times, left) for node, block, times, left in counts.visits}
    assert seen == {(0x100, nodes[0][0]): (2, 2), (0x200, nodes[1][0]): (2, 2), (0x300, nodes[2][0]): (2, 2),
                    (0x106, nodes[0][0]): (3, 3)}


@pytest.mark.parametrize("target, functions", [("120", [0]), ("100", [0, 0])])
def test_a_call_into_the_middle_of_its_own_function_is_a_jump(tmp_path, monkeypatch, target, functions):
    monkeypatch.setitem(globals(), "BLOCKS", BLOCKS + "block 120 2\n")
    _, counts = play(tmp_path, double(tmp_path), ["10", "100", target, "20"], "detail=on")
    assert [function for _, function, _ in counts.nodes.values()] == functions


def test_an_instruction_before_the_end_of_a_page_ends_where_the_next_one_begins(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "BLOCKS", BLOCKS.replace("block 100 24", "block 100 34"))
    _, counts = play(tmp_path, double(tmp_path), ["10", *WAY, "20"], "detail=on")
    assert (0x100, [2, 4]) in counts.blocks.values()
    assert [back for _, function, back in counts.nodes.values() if function == 1] == [0x106]


@pytest.mark.parametrize("arguments", [(), ("map=program.map",), ("map=nowhere", "out=x"), ("speed=high",)])
def test_the_plugin_refuses_what_it_does_not_understand(tmp_path, arguments):
    done = subprocess.run([str(double(tmp_path)), str(built(PLUGIN)), *arguments], input="", capture_output=True,
                          text=True, check=False)
    assert done.returncode == 3 and "counter: " in done.stderr


@pytest.mark.parametrize("text", ["", "region 5\n", "region 5\nregion 6\ndone 1\n"])
def test_a_file_that_is_not_whole_is_refused(text):
    with pytest.raises(ToolError, match="not whole"):
        counter.parse(text)


def test_a_program_that_fails_is_an_error_of_its_last_words(monkeypatch, tmp_path):
    monkeypatch.setattr(counter.firmware, "load", lambda elf: types.SimpleNamespace(scene_base=0))
    monkeypatch.setattr(counter, "map_text", lambda *_: "")
    ended = execute.Ending(execute.exit_code("STORE"), "first\nlast words", "", 1.0)
    monkeypatch.setattr(counter.emulator, "emulate", lambda *_: ended)
    with pytest.raises(ToolError, match="a.elf") as refused:
        counter.run("a.elf", [], __file__, tmp_path)
    assert refused.value.exit_code == execute.exit_status(ended) != 0 and "last words" in refused.value.words
    with pytest.raises(ToolError, match="nowhere is not built"):
        counter.run("a.elf", [], tmp_path / "nowhere", tmp_path)


def test_each_line_of_the_plugins_file_by_hand():
    counts = counter.parse("region 12\nnode 3 1 7 1f4\nblock 9 1a0 242\nvisit 3 9 5 2\nregion 4\ndone 2\n")
    assert counts.regions == [12, 4]
    assert counts.nodes == {3: (1, 7, 0x1F4)} and counts.blocks == {9: (0x1A0, [2, 4, 2])}
    assert counts.visits == [(3, 9, 5, 2)]
    assert counter.by_address(counts) == {0x1A0: (5, 0), 0x1A2: (5, 0), 0x1A6: (5, 2)}


def test_code_is_read_to_its_last_instruction():
    """A section of an instruction of two bytes, one of four, data, and one of two bytes at the end."""
    code = object.__new__(MachineCode)
    code.path, code.decoded, code.is_riscv = "x.elf", {}, False
    code.sections = [(0x100, bytes.fromhex("00bf") + (0xF000).to_bytes(2, "little") + (0xF800).to_bytes(2, "little") +
                      b"\x11\x22\x33\x44" + (0x4770).to_bytes(2, "little"))]
    code.marks = [(0x100, "t"), (0x106, "d"), (0x10A, "t")]
    assert [(address, found.size) for address, found in code.each_instruction()] == [(0x100, 2), (0x102, 4), (0x10A, 2)]
    with pytest.raises(ToolError, match="no code at 0x10c"):
        code.instruction(0x10C)
    with pytest.raises(ToolError, match="no code at 0xfe"):
        code.instruction(0xFE)
