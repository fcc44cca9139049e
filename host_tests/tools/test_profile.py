# SPDX-License-Identifier: MIT
"""make profile: kinds of instructions, the estimate of cycles, functions and stages, the flame graph."""

import json
import re
import subprocess
import types
import xml.etree.ElementTree

import pytest

from conftest import CHECKOUT, assert_one_sentence, run_cli
from fixel.bench import bench_plan, counter, cycles, debug_lines, places, profile, thumb
from fixel.bench.debug_lines import DebugLines
from fixel.base.errors import ToolError
from fixel.bench.machine_code import MachineCode
from fixel.bench.thumb import Instruction

BUILT_PROGRAMS = ("bench/*", "host/bench_counter.so")
pytestmark = pytest.mark.usefixtures("bench_programs")
CROSS = "arm-none-eabi-"
SVG = "{http://www.w3.org/2000/svg}"

ARMV7M = """
other             adds r0, r1; add.w r8, r9, r10; movw r3, #1234; ubfx r0, r1, #3, #4; clz r0, r1; tst r0, r1
other             lsls r0, r1, #3; mov r8, r9; cmp r8, r9; add r8, r9; add sp, #8; add r0, sp, #4; adr r0, .+8; uxtb r0, r1; rev r0, r1
other             orr.w r0, r1, r2, lsl #3; sub.w r0, sp, #256; addw r0, r1, #100; bfi r0, r1, #2, #3; ssat r0, #4, r1; lsl.w r0, r1, r2
multiply          muls r0, r1; mul r8, r1, r2
multiply-add      mla r0, r1, r2, r3; mls r0, r1, r2, r3
long-multiply     smull r0, r1, r2, r3; umull r4, r5, r6, r7
long-multiply-add smlal r0, r1, r2, r3; umlal r4, r5, r6, r7
divide            sdiv r0, r1, r2; udiv r0, r1, r2
load              ldr r0, [r1]; ldrb r0, [r1, #3]; ldrsh r0, [r1, r2]; ldr r0, [sp, #8]; ldr.w r8, [r1, #100]
load              ldr r0, [pc, #4]; ldrb r0, [r1, r2]; ldrh r0, [r1, #2]; ldrsb.w r0, [r1, #-4]; ldrex r0, [r1]; ldrexb r0, [r1]
store             str r0, [r1]; strb.w r8, [r1]; strh r0, [r1, r2]; str r0, [sp, #4]
store             strb r0, [r1, r2]; strh r0, [r1, #2]; str.w r0, [r1, #-4]; strex r0, r1, [r2]; strexb r0, r1, [r2]
branch            b .; b.w .
branch-conditional beq .; bne.w .; cbz r0, .+6; cbnz r1, .+6; cbz r7, .+80; ble .; bgt.w .
branch-exchange   bx lr; bx r3; mov pc, r0; add pc, r0
call              bl .
call-register     blx r3
it                it eq
other             addeq r0, r0, r1
system            cpsid i; dsb; mrs r0, PRIMASK; msr PRIMASK, r0; isb; nop; bkpt #1; svc #1; pld [r0]
load-to-pc        ldr pc, [r0, #4]; ldr pc, [r0, r1, lsl #2]; ldr pc, [r0], #4
table-branch      tbb [r0, r1]; tbh [r0, r1, lsl #1]
load-multiple/3   ldmia r0!, {r1, r2, r3}; pop {r4, r5, r6}; ldmia.w r8!, {r0, r1, r2}
load-multiple/2   ldrd r0, r1, [r2, #8]; ldrd r0, r1, [r2], #8; ldrd r0, r1, [r2, #-8]!; ldmdb r8!, {r0, r1}
store-multiple/4  push {r4, r5, r6, lr}; stmia r0!, {r1, r2, r3, r4}; stmdb sp!, {r4, r5, r8, lr}
store-multiple/2  strd r0, r1, [r2], #8; strd r0, r1, [r2]; push {r7, lr}; push {r0, r4}
pop-to-pc/3       pop {r4, r5, pc}
pop-to-pc/2       pop.w {r8, pc}
"""
ARMV7EM = """
float               vadd.f32 s0, s1, s2; vmul.f32 s0, s1, s2; vcmp.f32 s0, s1; vmov r0, s1; vcvt.s32.f32 s0, s0
float               vsub.f32 s0, s1, s2; vnmul.f32 s0, s1, s2; vabs.f32 s0, s1; vneg.f32 s0, s1; vmov.f32 s0, #1.0; vmrs r0, FPSCR
float               vmov s1, r0; vmov r0, r1, s2, s3; vmov s2, s3, r0, r1; vcvt.f32.s32 s0, s0
float-multiply-add  vmla.f32 s0, s1, s2; vfma.f32 s0, s1, s2; vmls.f32 s0, s1, s2; vnmla.f32 s0, s1, s2; vfms.f32 s0, s1, s2; vfnma.f32 s0, s1, s2
float-divide        vdiv.f32 s0, s1, s2
float-root          vsqrt.f32 s0, s1
float-load          vldr s0, [r0]; vldr s0, [r0, #-4]
float-store         vstr s0, [r0]; vstr s31, [r0, #8]
float-store-multiple/2 vpush {s16, s17}; vstr d0, [r0]
float-store-multiple/3 vstmia r0!, {s0, s1, s2}
float-load-multiple/2 vldmia r0!, {s0, s1}; vldr d0, [r0]; vpop {s16, s17}
long-multiply-add   smlal r0, r1, r2, r3; smlalbb r0, r1, r2, r3; umaal r0, r1, r2, r3
multiply            smulbb r0, r1, r2; smmul r0, r1, r2; smuad r0, r1, r2
multiply-add        smlabb r0, r1, r2, r3; smmla r0, r1, r2, r3; smlad r0, r1, r2, r3
"""
ARMV81M = """
vector              vadd.i32 q0, q1, q2; vldrw.u32 q0, [r0]; vstrw.32 q0, [r0]; vmul.i16 q0, q1, q2
other               dls lr, r0
branch-conditional  wls lr, r0, .+8; le lr, .-4
call                bl .
float               vadd.f32 s0, s1, s2
"""


def cases(text):
    """(kind, registers, instruction)."""
    for line in text.strip().splitlines():
        kind, code = line.split(maxsplit=1)
        kind, _, registers = kind.partition("/")
        for one in code.split(";"):
            yield kind.replace("-", " "), int(registers or 0), one.strip()


@pytest.mark.parametrize("flags, text", [(["-mcpu=cortex-m3"], ARMV7M),
                                         (["-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16"], ARMV7EM),
                                         (["-march=armv8.1-m.main+mve+fp"], ARMV81M)])
def test_kinds_of_what_the_assembler_makes(tmp_path, flags, text):
    wanted = list(cases(text))
    (tmp_path / "code.s").write_text(".syntax unified\n.thumb\n.text\n.type f, %function\nf:\n" +
                                     "".join(f"{one}\n" for _, _, one in wanted))
    subprocess.run([f"{CROSS}as", *flags, "code.s", "-o", "code.o"], cwd=tmp_path, check=True)
    subprocess.run([f"{CROSS}ld", "-Ttext=0x100", "-e", "f", "code.o", "-o", "code.elf"], cwd=tmp_path, check=True)
    found = [each for _, each in MachineCode(tmp_path / "code.elf").each_instruction()]
    # The assembler fills up to a word's end by a nop of its own.
    assert [(code, each.kind, each.registers if registers else 0) for each, (_, registers, code) in zip(found, wanted)] \
        == [(code, kind, registers) for kind, registers, code in wanted]


def test_a_load_from_beside_the_code_is_known(tmp_path):
    code = "ldr r0, [pc, #4]; ldr.w r0, [pc, #8]; ldrb.w r0, [pc, #8]; ldr r0, [r1]; ldr.w r8, [r1, #4]; ldr r0, [sp, #8]"
    (tmp_path / "code.s").write_text(".syntax unified\n.thumb\n.text\n.type f, %function\nf:\n" + code.replace("; ", "\n") + "\n")
    subprocess.run([f"{CROSS}gcc", "-mcpu=cortex-m3", "-nostdlib", "-Wl,-Ttext=0x100,-e,f", "code.s", "-o", "code.elf"], cwd=tmp_path,
                   check=True)
    found = [each.is_literal for _, each in MachineCode(tmp_path / "code.elf").each_instruction()]
    assert found[:6] == [True, True, True, False, False, False]


def test_data_of_a_section_that_is_not_loaded_ends_no_code(tmp_path):
    (tmp_path / "code.s").write_text(".syntax unified\n.thumb\n.text\n.type f, %function\nf:\nnop\nnop\nbx lr\n"
                                     '.section .note, ""\n.space 0x102\n.word 0\n.thumb\nnop\n.word 0\n')
    subprocess.run([f"{CROSS}gcc", "-mcpu=cortex-m3", "-nostdlib", "-Wl,-Ttext=0x100,-e,f", "code.s", "-o", "code.elf"], cwd=tmp_path,
                   check=True)
    code = MachineCode(tmp_path / "code.elf")
    assert code.marks == [(0x100, "t")] and len(list(code.each_instruction())) == 3


def test_sizes_are_those_of_the_disassembler():
    elf = CHECKOUT / "build/bench/m3/fixel.elf"
    text = subprocess.run([f"{CROSS}objdump", "-dz", str(elf)], capture_output=True, text=True, check=True).stdout
    wanted = {int(address, 16): 2 if len(code.split()) == 1 else 4 for address, code in
              re.findall(r"^\s*([0-9a-f]+):\t([0-9a-f]{4}(?: [0-9a-f]{4})?) +\t(?!\.word|\.short|\.byte)", text, re.MULTILINE)}
    found = {address: each.size for address, each in MachineCode(elf).each_instruction()}
    assert len(found) > 2000 and found == wanted


# --- the estimate -------------------------------------------------------------------

def test_every_core_has_models_but_the_m55_of_which_the_manual_has_no_table():
    assert {core: list(cycles.models(core)) for core in bench_plan.CORES} == {
        "m0": ["cortex-m0plus", "cortex-m0plus-small", "cortex-m3", "cortex-m4"],
        "m3": ["cortex-m3", "cortex-m4"], "m4f": ["cortex-m4"], "m55": []}


@pytest.mark.parametrize("core, model, instruction, times, left, before, wanted", [
    ("m0", "cortex-m0plus", Instruction(2, "other"), 10, 0, None, (10, 10)),
    ("m0", "cortex-m0plus", Instruction(2, "multiply"), 10, 0, None, (10, 10)),
    ("m0", "cortex-m0plus-small", Instruction(2, "multiply"), 10, 0, None, (320, 320)),
    ("m0", "cortex-m0plus-small", Instruction(2, "load"), 10, 0, "load", (20, 20)),
    ("m0", "cortex-m0plus", Instruction(2, "load multiple", 4), 10, 0, None, (50, 50)),
    ("m0", "cortex-m0plus", Instruction(2, "branch conditional"), 10, 7, None, (17, 31)),
    ("m3", "cortex-m3", Instruction(4, "long multiply"), 10, 0, None, (40, 40)),
    ("m3", "cortex-m3", Instruction(4, "divide"), 1, 0, None, (7, 7)),
    ("m3", "cortex-m3", Instruction(2, "load"), 10, 0, None, (20, 20)),
    ("m3", "cortex-m3", Instruction(2, "load"), 10, 0, "load", (10, 10)),
    ("m3", "cortex-m3", Instruction(2, "load"), 10, 0, "load multiple", (20, 20)),
    ("m3", "cortex-m3", Instruction(2, "load", is_literal=True), 10, 0, None, (20, 40)),
    ("m3", "cortex-m3", Instruction(2, "branch conditional"), 10, 7, None, (24, 38)),
    ("m3", "cortex-m3", Instruction(2, "branch"), 10, 0, None, (30, 50)),
    ("m3", "cortex-m3", Instruction(4, "call"), 10, 10, None, (30, 50)),
    ("m3", "cortex-m3", Instruction(2, "pop to pc", 3), 10, 10, None, (70, 90)),
    ("m3", "cortex-m3", Instruction(4, "load multiple", 2), 10, 0, None, (30, 30)),
    ("m3", "cortex-m4", Instruction(4, "long multiply"), 10, 0, None, (10, 10)),
    ("m4f", "cortex-m4", Instruction(4, "float divide"), 2, 0, None, (28, 28)),
])
def test_cycles_by_hand(core, model, instruction, times, left, before, wanted):
    assert cycles.models(core)[model].cycles(instruction, times, left, before) == wanted


def test_loads_in_a_row_are_those_of_one_block():
    """Two loads and a branch that is always taken, then a load by itself."""
    code = types.SimpleNamespace(instruction=lambda address: Instruction(2, "branch" if address == 0x104 else "load"))
    counts = counter.Counts(blocks={0: (0x100, [2, 2, 2]), 1: (0x200, [2])}, visits=[(1, 0, 10, 10), (1, 1, 10, 0)])
    assert cycles.models("m3")["cortex-m3"].total(code, counts) == (20 + 10 + 30 + 20, 20 + 10 + 50 + 20)


def test_a_kind_without_a_cost_is_refused():
    with pytest.raises(ToolError, match="no cost for 'vector'"):
        cycles.models("m3")["cortex-m3"].cycles(Instruction(4, "vector"), 1, 0)


# --- places -------------------------------------------------------------------------

class Code:
    """Functions outer at 0x100 and helper at 0x200; every instruction is a plain one."""
    functions = [types.SimpleNamespace(name="outer", start=0x100),
                 types.SimpleNamespace(name="helper", start=0x200)]

    @staticmethod
    def instruction(address):
        kind = "branch conditional" if address == 0x104 else "other"
        return Instruction(2, kind)


class Debug:
    """small is inlined at 0x102 into outer."""
    files = {"outer": "lib/view/project.c", "small": "lib/math/arith.h", "helper": "libgcc/div.c"}

    @staticmethod
    def file_of(name, address):
        return None

    @staticmethod
    def inlined(address):
        return ["small"] if address == 0x102 else []

    @staticmethod
    def line(address):
        return None if address >= 0x200 else f"lib/view/project.c:{address - 0x100}"


def small_profile():
    counts = counter.Counts(regions=[50], nodes={1: (0, 0, 0), 2: (1, 1, 0x106)},
                            blocks={0: (0x100, [2, 2, 2]), 1: (0x200, [2, 2])},
                            visits=[(1, 0, 10, 4), (2, 1, 10, 10)])
    return places.Profile(Code, counts, Debug, cycles.models("m3"))


def test_every_instruction_has_one_function_one_line_one_stack_and_one_stage():
    taken = small_profile()
    assert taken.total.instructions == 50
    assert {name: each.instructions for name, each in taken.own.items()} == {"outer": 20, "small": 10, "helper": 20}
    assert {name: each.instructions for name, each in taken.inclusive.items()} == \
        {"outer": 50, "small": 10, "helper": 20}
    assert taken.entered == {"outer": 10, "helper": 10}
    assert taken.inlined == {"small": 10} and taken.taken == {"taken": 4, "not taken": 6}
    assert {names: each.instructions for names, each in taken.stacks.items()} == \
        {("outer",): 20, ("outer", "small (inlined)"): 10, ("outer", "helper"): 20}
    assert {line: each.instructions for line, each in taken.lines.items()} == \
        {"lib/view/project.c:0": 10, "lib/view/project.c:2": 10, "lib/view/project.c:4": 10, "helper (no source)": 20}
    assert taken.stages == {"project": 50}      # a helper's work is its caller's
    assert taken.staged == {("project", "outer"): 20, ("project", "small"): 10, ("project", "helper"): 20}
    data = places.as_json(taken, 5)
    assert data["frames"] == 5 and data["stages"] == [{"stage": "project", "instructions": 50}]
    # 40 plain ones, 10 conditional branches of which 4 were followed.
    assert data["cycles_estimate"]["cortex-m3"] == [40 + 6 + 4 * 3, 40 + 6 + 4 * 5]


@pytest.mark.parametrize("back, about", [(0x104, ("small (inlined)",)), (0x102, ()), (0x106, ())])
def test_the_stack_of_a_call_has_what_is_inlined_about_the_call(back, about):
    """The call stands before the address that it comes back to."""
    counts = counter.Counts(regions=[20], nodes={1: (0, 0, 0), 2: (1, 1, back)}, blocks={1: (0x200, [2, 2])},
                            visits=[(2, 1, 10, 10)])
    taken = places.Profile(Code, counts, Debug, cycles.models("m3"))
    assert {names: each.instructions for names, each in taken.stacks.items()} == {("outer", *about, "helper"): 20}


FILES = {"frame": "lib/draw/render.c", "outline": "lib/raster/scan.c", "fxl_scan_outline": "lib/raster/scan.c",
         "next": "lib/raster/scan.c", "rows": "lib/raster/fill_armv7m.S", "product": "lib/math/arith.h",
         "divide": "lib/math/arith.c", "main": "bench/firmware/frames.c", "new": "lib/draw/unheard_of.c"}


@pytest.mark.parametrize("names, stage", [
    (["main", "frame"], "glue"), (["main", "frame", "next"], "spans"), (["main", "frame", "next", "memset"], "spans"),
    (["main", "frame", "fxl_scan_outline", "outline", "product"], "edges"),
    (["main", "frame", "fxl_scan_outline", "rows"], "fill"), (["main", "new"], "unheard_of"),
    (["main", "frame", "outline", "divide"], "spans"),
    (["main", "memset"], places.OTHERS)])
def test_stages(names, stage):
    assert places.Stages().of(reversed(names), FILES) == stage


def test_every_file_of_the_library_has_a_stage():
    stages = places.Stages()
    sources = [*(CHECKOUT / "lib").rglob("*.[cS]")]
    assert sorted(stem for stem in {places.stem_of(path) for path in sources} - stages.shared if stages.of_file(stem) is None) == []


def test_a_name_of_a_file_comes_before_a_pattern(tmp_path):
    (tmp_path / "stages.toml").write_text('shared = []\n[[stages]]\nname = "show"\npart = "paint"\nwhat = ""\nfiles = ["grey*"]\nfunctions = []\n'
                                          '[[stages]]\nname = "fill"\npart = "paint"\nwhat = ""\nfiles = ["grey4"]\nfunctions = []\n', encoding="utf-8")
    stages = places.Stages(tmp_path / "stages.toml")
    assert [stages.of_file(stem) for stem in ("grey", "grey4", "mono")] == ["show", "fill", None]


def test_debug_information_knows_lines_and_inlined_functions():
    elf = CHECKOUT / "build/bench/m3/fixel.elf"
    code, debug = MachineCode(elf), DebugLines(elf)
    (function,) = [each for each in code.functions if each.name == "fxl_frame_begin"]
    inside = [address for address, _ in code.each_instruction() if function.start <= address < function.end]
    assert all(re.fullmatch(r"lib/(\w+|include/fixel(/\w+)*)/\w+\.[ch]:\d+", debug.line(address)) for address in inside)
    assert debug.files["fxl_frame_begin"] == "lib/draw/render.c"
    assert debug.files.get("bench_begin") == "bench/firmware/program.c"
    tool = subprocess.run([f"{CROSS}addr2line", "-i", "-f", "-e", str(elf), *map(hex, inside)], capture_output=True,
                          text=True, check=True).stdout.splitlines()
    inlined = set().union(*(debug.inlined(address) for address in inside))
    assert inlined == set(tool[0::2]) - {"fxl_frame_begin"}
    assert {debug.line(address).split("/")[-1] for address in inside} <= \
        {re.sub(r" \(.*", "", place).split("/")[-1] for place in tool[1::2]}


def test_functions_of_assembly_stand_in_the_file_that_their_lines_name(tmp_path):
    (tmp_path / "rows.S").write_text(".syntax unified\n.thumb\n.text\n.global f\n.type f, %function\n.thumb_func\nf: bx lr\n")
    subprocess.run([f"{CROSS}gcc", "-mcpu=cortex-m3", "-mthumb", "-g", "-nostdlib", "-Wl,-Ttext=0x100,-e,f", "rows.S",
                    "-o", "code.elf"], cwd=tmp_path, check=True)
    debug = DebugLines(tmp_path / "code.elf")
    assert "f" not in debug.files
    assert debug.file_of("f", 0x100).endswith("rows.S") and debug.file_of("g", 0x900) == ""


# --- the flame graph ----------------------------------------------------------------

STACKS = {("main",): 25, ("main", "a<b>"): 50, ("main", "a<b>", "tiny"): 24, ("main", "hair"): 1}


def bars(svg):
    """{title: (x, y, width)} of a graph."""
    found = {}
    for group in xml.etree.ElementTree.fromstring(svg).iter(f"{SVG}g"):
        rect = group.find(f"{SVG}rect")
        found[group.find(f"{SVG}title").text] = tuple(float(rect.get(name)) for name in ("x", "y", "width"))
    return found


def test_a_flame_graph_has_bars_as_wide_as_what_they_took():
    found = bars(profile.svg(STACKS, "title", "below", "(inlined)"))
    whole = profile.WIDTH - 2 * profile.MARGIN
    assert set(found) == {"main: 100 (100.00 %)", "a<b>: 74 (74.00 %)", "tiny: 24 (24.00 %)", "hair: 1 (1.00 %)"}
    main, inner, tiny = (found[name] for name in ("main: 100 (100.00 %)", "a<b>: 74 (74.00 %)", "tiny: 24 (24.00 %)"))
    assert [round(bar[2] / whole, 3) for bar in (main, inner, tiny)] == [1, 0.74, 0.24]
    assert main[1] - inner[1] == inner[1] - tiny[1] == profile.ROW      # callers below
    assert main[0] <= inner[0] and inner[0] + inner[2] <= main[0] + main[2]


def test_a_flame_graph_says_what_it_shows_and_is_the_same_twice():
    svg = profile.svg(STACKS, "w1 & more", "instructions", "(inlined)")
    root = xml.etree.ElementTree.fromstring(svg)
    assert "w1 & more" in [text.text for text in root.iter(f"{SVG}text")]
    assert svg == profile.svg(dict(reversed(STACKS.items())), "w1 & more", "instructions", "(inlined)")


# --- the command --------------------------------------------------------------------

def test_the_command(tmp_path):
    done = run_cli("profile", "--workload", "w3b", "--core", "m3", "--out", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    data = json.loads((tmp_path / "out/profile.json").read_text())
    for key in ("functions", "lines", "stages"):
        assert sum(row["instructions"] for row in data[key]) == data["instructions"]
    assert sum(data["kinds"].values()) == data["instructions"]
    assert (tmp_path / "out/flame.svg").read_text().count("<g>") > 20
    folded = (tmp_path / "out/stacks.txt").read_text().splitlines()
    assert sum(int(line.rsplit(" ", 1)[1]) for line in folded) == data["instructions"]
    words = [line for line in done.stdout.splitlines() if "cycles" in line]
    assert words and all("ESTIMATE" in line for line in words)


@pytest.mark.parametrize("workload, kernels", [("vcold", {"fxl_draw_colour_outline": 1000}), ("head", {"fxl_draw_smooth_triangle_16": 60}),
                                               ("c500-depth", {"fxl_draw_depth_face_16": 400})])
def test_the_kernel_of_a_scene_draws_its_faces(tmp_path, workload, kernels):
    """Where a face takes another way its pixels are the same, so no other test sees that a kernel is not called: so often a frame at least."""
    plan = bench_plan.Plan(CHECKOUT / "build")
    drawn, renderer = profile.chosen(plan, types.SimpleNamespace(workload=workload, renderer=None))
    elf, (scene, _) = plan.program("m3", renderer), bench_plan.compile_scene(drawn, tmp_path)
    code = MachineCode(elf)
    _, counts = counter.run(elf, code, plan.counter, tmp_path, scene, detail=True)
    times = counter.by_address(counts)
    entered = {function.name: times.get(function.start, (0, 0))[0] / len(counts.regions) for function in code.functions}
    assert not {name: entered.get(name) for name, least in kernels.items() if entered.get(name, 0) < least}


@pytest.mark.parametrize("workload, core, words", [("w9", "m3", ("no workload 'w9'", "w3b")),
                                                   ("w1", "m7", ("no core 'm7'", "m55"))])
def test_the_command_says_what_there_is(workload, core, words):
    assert_one_sentence(run_cli("profile", "--workload", workload, "--core", core), *words)


def test_what_is_drawn_to_rgb565_is_profiled_as_it_is_drawn():
    plan = bench_plan.Plan(CHECKOUT / "build")
    for renderer, named, change in ((None, "fixel-native", ["rgb565"]), ("fixel-rgb565", "fixel-rgb565", [])):
        workload, taken = profile.chosen(plan, types.SimpleNamespace(workload="tqpl", renderer=renderer))
        assert (taken, workload["with"]) == (named, ["lit", *change])
    workload, taken = profile.chosen(plan, types.SimpleNamespace(workload="w1", renderer=None))
    assert (taken, workload["name"]) == ("fixel", "w1")


def test_the_command_says_which_renderers_there_are(monkeypatch):
    monkeypatch.setattr(profile.qemu, "find_qemu", None)    # nothing is run
    with pytest.raises(ToolError, match="no renderer 'fixed' of w1; the renderers are: .*fixel"):
        profile.main(["--build", str(CHECKOUT / "build"), "--workload", "w1", "--core", "m3", "--renderer", "fixed"])


assert set(cycles.LEAVING) <= set(thumb.KINDS)


def test_a_line_belongs_to_the_addresses_up_to_the_next_row():
    lines = object.__new__(debug_lines.DebugLines)
    lines.rows, lines.files = [(0x100, 0x104, "a.c:1"), (0x104, 0x106, "a.c:2"), (0x200, 0x202, "b.S:9")], {"f": "a.c"}
    lines.addresses = [row[0] for row in lines.rows]
    assert [lines.line(address) for address in (0xFE, 0x100, 0x103, 0x104, 0x106, 0x1FF, 0x200, 0x202)] == \
        [None, "a.c:1", "a.c:1", "a.c:2", None, None, "b.S:9", None]
    assert [lines.file_of(name, address) for name, address in (("f", 0x200), ("g", 0x200), ("h", 0x300))] == ["a.c", "b.S", ""]
