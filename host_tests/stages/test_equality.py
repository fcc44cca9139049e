# SPDX-License-Identifier: MIT
"""Each core's kernels against the portable ones, on the emulated core: those that are not on record, with fewer inputs than make
equality; and the record."""

import pathlib
import re
import shutil
import subprocess

import pytest

from board_programs import ROOT, made
from conftest import assert_one_sentence, environment, run_cli
from fixel.campaign.shards import Shard
from fixel.base.errors import ToolError
from fixel.check import equality as kernel_equality, kernel_text
from fixel.prove import functions, rows

BUILT_PROGRAMS = ("equality/*",)
CORES = ("m0", "m3", "m4f", "m55", "m0-small", "m3-small", "m3-os")
FEWEST = "m3-small"     # of these, the program with the fewest kernels
DONE = re.compile(r"^(\S+) +(\S+) +([0-9,]+) (inputs  0 differ|random inputs, as on record)$", re.MULTILINE)


def equality(core, build, *more, keep="record.txt", **changes):
    """fixel equality with a build folder of its own, which has the programs, and a record of its own."""
    if not (build / "equality").exists():
        (build / "equality").mkdir(parents=True)
        (build / "equality" / f"{core}.elf").symlink_to(made(f"build/equality/{core}.elf"))
    return run_cli("equality", core, "--build", build, "--keep", build / keep, *more, **changes)


def kernels_of(core):
    """The tests that a core's program lists. With FXL_SMALL no kernel is in assembly, so that list is shorter; outlines
    with a depth buffer are drawn in one call but by -Os, and smooth ones, small planes and short runs have kernels on Armv7-M
    alone; smooth ones in words are drawn in C on other cores."""
    libraries = {"BOTH", "SMALL"} if core.endswith("-small") else {"BOTH", "LARGE"}
    if core in ("m0", "m3", "m4f", "m55"):
        libraries.add("OUTLINES")
    if core in ("m3", "m4f", "m55"):
        libraries.add("SMOOTH")
    if core == "m0":
        libraries.add("WORDS")
    header = (ROOT / "firmware/equality/equality.h").read_text(encoding="utf-8")
    names = [name for name, library in re.findall(r'TEST\("([\w-]+)", test_\w+, (\w+)\)', header) if library in libraries]
    assert len(names) >= 8
    return names


@pytest.fixture(name="compared", scope="module")
def fixture_compared(tmp_path_factory):
    """The small form of make equality (host_tests/build/commands.toml): all programs. It leaves the record as it is."""
    made(*(f"build/equality/{core}.elf" for core in CORES))
    record = shutil.copy(kernel_equality.RECORD, tmp_path_factory.mktemp("equality"))
    done = subprocess.run(["make", "equality", "THOUSANDS=10", f"KEEP={record}"], cwd=ROOT, env=environment(), stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done


def test_entries_in_assembly_are_reached_by_the_kernels_that_compare_them():
    """What host_tests/proofs/measured.toml says of a file's entries, by the programs whose libraries have the file."""
    reached = {}
    for core in ("m0", "m3", "m3-os"):
        program = kernel_text._Program(made(f"build/equality/{core}.elf").with_suffix(".map"))
        for kernel, function in program.tests():
            reached.setdefault(kernel, set()).update(name for name, place in program.defined.items()
                                                     if place in program.reached(function) and program.objects[place[0]][0] == "machine")
    listed = rows.assembly(ROOT)
    lost = [key for key in functions.assembly(ROOT) if not any(key.partition(":")[2] in reached[kernel] for kernel in listed[key.partition(":")[0]])]
    assert not lost
    idle = [(file, kernel) for file, kernels in listed.items() for kernel in kernels
            if not any(key.startswith(f"{file}:") and key.partition(":")[2] in reached[kernel] for key in functions.assembly(ROOT))]
    assert idle == [("lib/raster/fill_rows_mve.S", "fill")]     # another text of the entries of fill_rows_armv7m.S


@pytest.mark.parametrize("core", CORES)
def test_kernels_are_equal(core, compared):
    rows = [row for row in DONE.findall(compared.stdout) if row[0] == core]
    assert sorted(name for _, name, _, _ in rows) == sorted(kernels_of(core)), compared.stdout
    assert all(int(cases.replace(",", "")) >= 10000 for _, _, cases, _ in rows), compared.stdout


def test_those_on_record_are_counted(compared):
    """A kernel is compared unless its hashes stand on record with as many inputs."""
    record = kernel_equality.recorded(kernel_equality.RECORD)
    for core in CORES:
        kernels = kernel_text.kernels(ROOT / f"build/equality/{core}.elf")
        rows = {name: words for where, name, _, words in DONE.findall(compared.stdout) if where == core}
        for kernel in kernels:
            on_record = record.get((core, kernel.name, kernel.machine, kernel.text), 0) >= 10000
            assert ("as on record" in rows[kernel.name]) == on_record, (core, kernel)
    said = re.search(r"; (\d+) kernels as on record$", compared.stdout, re.MULTILINE)
    assert int(said[1]) == compared.stdout.count("random inputs, as on record")


def test_what_is_done_is_not_done_again(tmp_path):
    allowed = {"FIXEL_KEPT": "", "CI": ""}
    count = len(kernels_of(FEWEST))
    first = equality(FEWEST, tmp_path, "--thousands", "1", **allowed)
    record = (tmp_path / "record.txt").read_text()
    assert first.returncode == 0 and f"{count} of {count} shards done, 0 of them by earlier" in first.stderr, first.stdout + first.stderr
    assert len(kernel_equality.recorded(tmp_path / "record.txt")) == count
    again = equality(FEWEST, tmp_path, "--thousands", "1", **allowed)
    assert again.returncode == 0 and f"; {count} kernels as on record" in again.stdout and "shards done" not in again.stderr
    resumed = equality(FEWEST, tmp_path, "--thousands", "1", keep="other.txt", **allowed)
    assert f"{count} of {count} shards done, {count} of them by earlier" in resumed.stderr and resumed.stdout == first.stdout
    assert (tmp_path / "other.txt").read_text() == record
    more = equality(FEWEST, tmp_path, "--thousands", "2", "--only", "fill,m3-small/project", **allowed)
    assert "2 of 2 shards done, 0 of them by earlier" in more.stderr
    assert sorted(kernel_equality.recorded(tmp_path / "record.txt").values()) == (count - 2) * [1000] + 2 * [2000]


# --- hashes ------------------------------------------------------------------------

def changed_program(folder, core, name, change):
    """A program as its hashes are read: its map, with an object that is changed ({section: bytes} to other bytes)."""
    text = pathlib.Path(made(f"build/equality/{core}.elf")).with_suffix(".map").read_text(encoding="utf-8", errors="replace")
    [old] = re.findall(rf"^LOAD (\S+/{name}\.o)$", text, re.MULTILINE)
    new = folder / old
    new.parent.mkdir(parents=True)
    data = (ROOT / old).read_bytes()
    new.write_bytes(change(data))
    (folder / f"{core}.map").write_text("".join(f"LOAD {new if each == old else each}\n" for each in kernel_text.LOADED.findall(text)))
    return folder / f"{core}.elf"


def test_one_instruction_of_a_kernel_makes_it_new_and_no_other(tmp_path):
    before = kernel_text.kernels(made("build/equality/m3.elf"))

    def change(data):
        sections, _ = kernel_text._object(data)
        [kernel] = [section.data for section in sections.values() if section.name == ".text.fxl_row_to_16"]
        assert data.count(kernel) == 1
        place = data.index(kernel)
        return data[:place] + bytes([data[place] ^ 1]) + data[place + 1:]
    after = kernel_text.kernels(changed_program(tmp_path, "m3", "row_to_16_armv7m", change))
    assert [(old.name, old.text) for old in before] == [(new.name, new.text) for new in after]
    assert [old.name for old, new in zip(before, after, strict=True) if old.machine != new.machine] == ["row-to-16"]
    record = {("m3", kernel.name, kernel.machine, kernel.text): 10000 for kernel in before}
    options = kernel_equality.parser().parse_args(["m3", "--thousands", "10"])
    new, old = kernel_equality.due({"m3": after}, options, record)
    assert [kernel.name for _, kernel in new] == ["row-to-16"] and len(old) == len(before) - 1


def test_another_c_text_makes_a_kernel_new(tmp_path):
    """Of a test itself, too: it may have other inputs."""
    before = kernel_text.kernels(made("build/equality/m3.elf"))

    def change(data):
        sections, _ = kernel_text._object(data)
        [text] = [section.data for section in sections.values() if section.name == ".text.test_row_to_16"]
        place = data.index(text)
        return data[:place] + bytes([data[place] ^ 1]) + data[place + 1:]
    after = kernel_text.kernels(changed_program(tmp_path, "m3", "rows", change))
    assert [old.machine for old in before] == [new.machine for new in after]
    assert [old.name for old, new in zip(before, after, strict=True) if old.text != new.text] == ["row-to-16"]


def test_a_comment_does_not_make_a_kernel_new(tmp_path):
    """Not even above an assertion, whose line an object would else have."""
    flags = re.search(r"^EQUALITY_CFLAGS := (.*)$", (ROOT / "firmware/equality/equality.mk").read_text(), re.MULTILINE)[1]
    objects = []
    for comment in ("", "/* One more line. */\n\n"):
        source = tmp_path / "a.c"
        source.write_text(f'#include "math/arith.h"\n{comment}int f(int a);\nint f(int a) {{ FXL_ASSERT(a > 0); return a; }}\n')
        subprocess.run(["arm-none-eabi-gcc", "-mthumb", "-O2", "-ffunction-sections", *flags.split(), "-Ilib", "-Ilib/include", "-c",
                        source, "-o", tmp_path / "a.o"], cwd=ROOT, check=True)
        objects.append(kernel_text._object((tmp_path / "a.o").read_bytes())[0])
    one, other = ([section[:3] for section in each.values() if section.name.startswith(".text")] for each in objects)
    assert one == other and any(data for _, data, _ in one)


# --- the record --------------------------------------------------------------------

A, B, C = 3 * "abcd", 3 * "0123", 3 * "4567"


def test_a_record_keeps_what_holds(tmp_path):
    """Two branches may each have put their line of a kernel in; what is renewed takes the place of both."""
    path = tmp_path / "record.txt"
    path.write_text(f"# words\nm3 fill {A} {B} 1000\nm3 fill {A} {C} 2000\nm3 gone {A} {B} 5\nm0 fill {A} {B} 7\n")
    assert kernel_equality.recorded(path) == {("m3", "fill", A, B): 1000, ("m3", "fill", A, C): 2000, ("m3", "gone", A, B): 5,
                                              ("m0", "fill", A, B): 7}
    programs = {"m3": [kernel_text.Kernel("fill", 1, A, B), kernel_text.Kernel("runs", 2, B, C)]}
    kernel_equality.renew(path, programs, {("m3", "runs", B, C): 3000})
    assert kernel_equality.recorded(path) == {("m3", "fill", A, B): 1000, ("m3", "fill", A, C): 2000, ("m3", "runs", B, C): 3000,
                                              ("m0", "fill", A, B): 7}
    kernel_equality.renew(path, programs, {("m3", "fill", A, B): 10})
    assert kernel_equality.recorded(path) == {("m3", "fill", A, B): 1000, ("m3", "runs", B, C): 3000, ("m0", "fill", A, B): 7}
    assert kernel_equality.short_of(kernel_equality.recorded(path), programs) == ([("m3", "fill", 1000), ("m3", "runs", 3000)], 2)


def test_a_line_of_the_record_that_is_none_is_named(tmp_path):
    path = tmp_path / "record.txt"
    path.write_text(f"m3 fill {A} {B} 1000\nm3 fill {A} 1000\n")
    with pytest.raises(ToolError) as refused:
        kernel_equality.recorded(path)
    assert f"{path}:2" in str(refused.value) and "make equality" in str(refused.value)


def test_a_kernel_that_differs_gets_no_line(tmp_path, monkeypatch, capsys):
    kernel = kernel_text.Kernel("fill", 1, A, B)
    options = ["m3", "--thousands", "1", "--keep", str(tmp_path / "record.txt")]
    for differ in (1, 0):
        monkeypatch.setattr(kernel_equality, "programs_of", lambda _: {"m3": [kernel]})
        monkeypatch.setattr(kernel_equality, "compute", lambda some, *_, differ=differ: {each: {"inputs": 9, "differ": differ} for each in some})
        assert kernel_equality.main(options) == differ
        assert len(kernel_equality.recorded(tmp_path / "record.txt")) == 1 - differ
    assert "1 differ; 0 kernels as on record" in capsys.readouterr().out


# --- shards ------------------------------------------------------------------------

def test_each_shard_has_inputs_of_its_own():
    """Their numbers reach the program: kernels that skip some inputs count others."""
    elf = made(f"build/equality/{FEWEST}.elf")
    counted = list(zip(*(kernel_equality.compare(elf, 1, shard=shard) for shard in (0, 0, 1, 65535)), strict=True))
    assert len(counted) == len(kernels_of(FEWEST))
    assert all(first == same for first, same, _, _ in counted)
    assert any(len({first, *others}) == 3 for first, _, *others in counted)


def test_a_plan_has_all_inputs_once():
    kernels = [kernel_text.Kernel(name, number, A, B) for number, name in enumerate("ab", 1)]
    some = kernel_equality.plan([(core, kernel) for core in ("m0", "m3") for kernel in kernels], 2500)
    assert [shard.parameters["thousands"] for shard in some] == 4 * [1000, 1000, 500]
    assert [shard.parameters["shard"] for shard in some] == 4 * [0, 1, 2] and [shard.number for shard in some] == list(range(12))
    assert [shard.kind for shard in some[::3]] == ["m0 a", "m0 b", "m3 a", "m3 b"]
    rows = kernel_equality.merge(some, [{"inputs": 10, "differ": shard.number % 2} for shard in some])
    assert rows["m0", "b"] == {"inputs": 30, "differ": 2}
    with pytest.raises(ValueError):
        kernel_equality.merge(some[:1] + [Shard("equality", 1, {}, "m0 a", 1)], [{"inputs": 1, "differ": 0}])


def test_nothing_is_refused():
    assert_one_sentence(run_cli("equality", "m3", "--thousands", "0"), "--thousands", "from 1 to 65,536,000")
    assert_one_sentence(run_cli("equality", "m3", "--only", "fill,nothing"), "ONLY", "'nothing'", "equality.h")
