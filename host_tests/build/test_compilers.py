# SPDX-License-Identifier: MIT
"""Any compiler: headers alone in C and in C++, and all sources in one folder, linked and run where they can be."""

import concurrent.futures
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

import pytest

from conftest import CHECKOUT, environment, run_make, sampled

BUILT_PROGRAMS = ()
INCLUDE = CHECKOUT / "lib" / "include"
SOURCES = sorted(path for path in (CHECKOUT / "lib").rglob("*") if path.suffix in (".c", ".S"))
ROOMS_WITH_KERNELS = ("math", "scene", "view", "clip", "raster", "paint", "draw", "screen")
HEADERS = sorted(INCLUDE.rglob("*.h"))
PROGRAM = CHECKOUT / "host_tests" / "build" / "compilers"
MEMORY = CHECKOUT / "boards" / "parts" / "memory_functions.c"
PICTURE = (PROGRAM / "cube.txt").read_text(encoding="utf-8")

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
HEADER_WARNINGS = [*WARNINGS, "-Wundef"]
# In C++ a record's other members are 0 too, but GCC says that they are missing.
CPP = ["-std=c++20", "-Wno-missing-field-initializers"]
# For CMake: all sources are compiled, and what is asked is whether they are those of the target, with its settings.
QUICKLY = "-DCMAKE_C_FLAGS=-O0"


def clang_named(name):
    """clang or clang++, also where only one with a version in its name is there."""
    versions = ("", *(f"-{number}" for number in range(21, 13, -1)))
    return next((name + version for version in versions if shutil.which(name + version)), name)


def freestanding(compiler):
    """Options that leave a compiler no header but its own."""
    folder = subprocess.run([compiler, "-print-file-name=include"], check=True, text=True, capture_output=True)
    return ["-ffreestanding", "-nostdinc", "-isystem", folder.stdout.strip()]


def run(command, folder=CHECKOUT):
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment(), text=True,
                          capture_output=True, check=False)
    return done.returncode, done.stdout + done.stderr


def linked(program, *command):
    """The program. A linker may warn, of what differs between the compilers that made its objects."""
    code, text = run([*command, "-o", program])
    assert code == 0, text
    return program


def in_parallel(commands, folder=CHECKOUT):
    """Runs commands in a folder; the words of those that failed or said something."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return "\n".join(text for code, text in pool.map(lambda command: run(command, folder), commands)
                         if code or text)


def compiled(folder, compiler, options, sources):
    """The objects of sources, all in one folder and named as a compiler names them. A compiler is started for many
    sources, of which a seventh of the time is saved."""
    folder.mkdir(exist_ok=True)
    objects = [folder / f"{source.stem}.o" for source in sources]
    assert len(set(objects)) == len(sources), "two sources have one name"
    language = ["-x", "c++"] if "++" in compiler else ["-x", "c"]
    kinds = ((language, [source for source in sources if source.suffix == ".c"]),
             (["-x", "assembler-with-cpp"], [source for source in sources if source.suffix == ".S"]))
    processors = os.cpu_count() or 1
    commands = [[compiler, *options, f"-I{INCLUDE}", "-c", *kind, *files[first::processors]]
                for kind, files in kinds for first in range(min(processors, len(files)))]
    assert in_parallel(commands, folder) == ""
    assert all(target.exists() for target in objects)
    return objects


@functools.cache
def small_parts(folder, *options):
    """What runs the program on a Cortex-M, and the functions that a compiler demands of any program."""
    sources = [PROGRAM / "cortexm.c", MEMORY]
    return compiled(folder, "arm-none-eabi-gcc", ["-O1", "-fno-tree-loop-distribute-patterns", *options], sources)


def header_command(compiler, standard, source):
    style = "-Wold-style-cast" if "++" in standard else "-Wstrict-prototypes"
    return [compiler, f"-std={standard}", *HEADER_WARNINGS, style, f"-I{INCLUDE}", "-fsyntax-only", source]


@pytest.mark.parametrize("compiler, oldest, later", [
    ("gcc", "c11", ["c17", "c2x"]), (clang_named("clang"), "c11", ["c17", "c2x"]),
    ("g++", "c++11", ["c++14", "c++17", "c++20"]), (clang_named("clang++"), "c++11", ["c++14", "c++17", "c++20"])])
def test_each_header_compiles_alone(tmp_path, compiler, oldest, later):
    """By the oldest standard, which has the fewest words. By the later ones, all together."""
    commands = []
    for number, header in enumerate(HEADERS):
        source = tmp_path / f"header{number}.{'cc' if '++' in oldest else 'c'}"
        # A source without any declaration is none.
        source.write_text(f'#include "{header.relative_to(INCLUDE)}"\nextern int declared;\n', encoding="utf-8")
        commands.append(header_command(compiler, oldest, source))
        if header.name == "all.h":
            commands += [header_command(compiler, standard, source) for standard in later]
    assert len(commands) == len(HEADERS) + len(later)
    assert in_parallel(commands) == ""


def test_macros_make_no_warning_in_cpp(tmp_path):
    """Macros that take arguments or are casts, used as a program uses them."""
    source = tmp_path / "macros.cc"
    source.write_text("""#include <fixel/all.h>
#include <study/span_buffer.h>
constexpr fxl_q16_16 one = FXL_Q16_16_ONE, most = FXL_COORDINATE_MAX;
constexpr fxl_q16_16 units = FXL_UNITS(-8), third = FXL_RATIO(1, 3);
constexpr fxl_angle quarter = FXL_ANGLE_QUARTER, right = FXL_DEGREES(90);
constexpr int64_t error = FXL_NORMAL_SQUARE_MAX_ERROR;
constexpr fxl_planes planes = FXL_PLANES_ALL;
uint32_t words(uint32_t vertices) { return FXL_DISPLAY_LIST_WORDS(vertices); }
uint32_t bytes(uint16_t width, uint16_t height) { return FXL_SPAN_BUFFER_BYTES_LEAST(width, height); }
static_assert(units == -8 * one && third == 21845 && quarter == right && most > one && error > 0
              && planes > 0, "values");
""", encoding="utf-8")
    commands = [[*header_command(compiler, standard, source), f"-I{CHECKOUT / 'lib'}"] for compiler in ("g++", clang_named("clang++"))
                for standard in ("c++11", "c++20")]
    assert in_parallel(commands) == ""


@pytest.mark.parametrize("compiler, options", sampled("hosts", [
    ("gcc", ["-std=c11", "-O0"]),
    ("gcc", ["-std=c2x", "-O0", "-DFXL_SMALL"]),
    (clang_named("clang"), ["-std=c2x", "-O0"]),
    ("g++", ["-O0"]),
    (clang_named("clang++"), ["-O0"]),
], 2))
def test_sources_run_on_this_machine(tmp_path, compiler, options):
    language = CPP if "++" in compiler else []
    sources = [*SOURCES, PROGRAM / "cube.c", PROGRAM / "hosted.c"]
    objects = compiled(tmp_path / "objects", compiler, [*WARNINGS, *options, *language], sources)
    assert run([linked(tmp_path / "cube", compiler, *objects)]) == (0, PICTURE)


@pytest.mark.parametrize("compiler, board, flags", sampled("cores", [
    (compiler, *target) for compiler in ("gcc", "clang") for target in (
        ("microbit", ["-mcpu=cortex-m0", "-mthumb"]),
        ("mps2-an385", ["-mcpu=cortex-m3", "-mthumb"]),
        ("mps3-an547", ["-mcpu=cortex-m55", "-mthumb", "-mfloat-abi=hard"]))
], 2))
def test_sources_run_on_a_cortex_m(tmp_path, compiler, board, flags):
    """Without a C library: the compiler has its own headers alone, and the program has memcpy and the like."""
    if compiler == "gcc":
        program, own = ["arm-none-eabi-gcc"], freestanding("arm-none-eabi-gcc")
    else:
        program, own = [clang_named("clang"), "--target=arm-none-eabi"], ["-ffreestanding"]
    # What is asked for by name has no kernels, so one core will do.
    sources = SOURCES if board == "mps2-an385" else [path for path in SOURCES if path.parent.name in ROOMS_WITH_KERNELS]
    options = [*program[1:], *flags, "-std=c11", "-O0", "-DFXL_COMPACT=0", "-ffunction-sections", *WARNINGS, *own]
    objects = compiled(tmp_path / "objects", program[0], options, [*sources, PROGRAM / "cube.c"])
    layout = "--section-start=.vectors=0,-Ttext=0x100,-Tdata=0x20000000"
    elf = linked(tmp_path / "cube.elf", "arm-none-eabi-gcc", *flags, "-nostdlib",
                 f"-Wl,--gc-sections,-u,vectors,-e,start,{layout}", *objects,
                 *small_parts(tmp_path / "parts", *flags), "-lgcc")
    assert run(["qemu-system-arm", "-M", board, "-kernel", elf, "-display", "none", "-monitor", "none",
                "-serial", "none", "-semihosting-config", "enable=on,target=native"]) == (0, PICTURE)


def test_cpp_links_with_the_kernels_of_a_core(tmp_path):
    """Functions that assembly calls, or that are assembly, have C's names in C++ too."""
    flags = ["-mcpu=cortex-m3", "-mthumb"]
    options = [*flags, "-O0", "-DFXL_COMPACT=0", "-fno-exceptions", "-ffreestanding", *WARNINGS, *CPP]
    objects = compiled(tmp_path / "objects", "arm-none-eabi-g++", options, [*SOURCES, PROGRAM / "cube.c"])
    linked(tmp_path / "cube.elf", "arm-none-eabi-gcc", *flags, "-nostdlib", "-Wl,-e,start", *objects,
           *small_parts(tmp_path / "parts", *flags), "-lgcc")


@pytest.mark.parametrize("compiler", sampled("risc-v", ["gcc", "clang"], 1))
def test_sources_link_for_risc_v(tmp_path, compiler):
    flags = ["-march=rv32imac", "-mabi=ilp32"]
    program = {"gcc": ["riscv64-unknown-elf-gcc"],
               "clang": [clang_named("clang"), "--target=riscv32-unknown-elf"]}[compiler]
    sources = SOURCES if compiler == "gcc" else [path for path in SOURCES if path.parent.name in ROOMS_WITH_KERNELS]
    options = [*program[1:], *flags, "-std=c11", "-O0", "-ffunction-sections", *WARNINGS, "-ffreestanding"]
    objects = compiled(tmp_path / "objects", program[0], options, [*sources, PROGRAM / "cube.c", MEMORY])
    linked(tmp_path / "cube.elf", "riscv64-unknown-elf-gcc", *flags, "-nostdlib",
           "-Wl,--gc-sections,-e,main,--defsym=put_text=0", *objects, "-lgcc")


STUDY = """#include <fixel.h>
#include <study/study.h>
int main(void)
{
    return fxl_clipper_near.workspace_size != sizeof(fxl_volume_workspace) || fxl_palette_spans.flat == 0;
}
"""


def test_a_cmake_project_uses_the_targets(tmp_path):
    """Out of tree, with a setting of the build, as a program does that has Fixel in a folder of its own; and the study, for which it asks."""
    (tmp_path / "study.c").write_text(STUDY, encoding="utf-8")
    (tmp_path / "CMakeLists.txt").write_text(f"""cmake_minimum_required(VERSION 3.16)
project(cube LANGUAGES C)
set(FXL_POLYGON_CAPACITY 12)
add_subdirectory({CHECKOUT} fixel)
add_executable(cube {PROGRAM}/cube.c {PROGRAM}/hosted.c)
target_link_libraries(cube PRIVATE fixel::fixel)
add_executable(study study.c)
target_link_libraries(study PRIVATE fixel::study)
""", encoding="utf-8")
    build = tmp_path / "build"
    for command in (["cmake", "-S", tmp_path, "-B", build, "-DFXL_SMALL=ON", "-DFIXEL_STUDY=ON", QUICKLY],
                    ["cmake", "--build", build, "--parallel", "2"]):
        code, text = run(command)
        assert code == 0 and "warning" not in text.lower(), text
    assert run([build / "cube"]) == (0, PICTURE)
    assert run([build / "study"]) == (0, "")
    names = subprocess.run(["nm", build / "cube"], check=True, text=True, capture_output=True).stdout
    assert "fxl_renderer_init_with_for_polygons_of_12" in names
    assert "-DFXL_SMALL" in (build / "fixel" / "CMakeFiles" / "fixel.dir" / "flags.make").read_text(encoding="utf-8")


@pytest.mark.parametrize("options, more, wanted", [
    ([], "", ["-O2"]), (["-DCMAKE_BUILD_TYPE=Debug"], "", []), (["-DCMAKE_BUILD_TYPE=MinSizeRel"], "", ["-Os"]),
    (["-DCMAKE_C_FLAGS=-O1"], "", ["-O1"]), ([], "add_compile_options(-Os)", ["-Os"])])
def test_a_cmake_project_gets_optimised_code_unless_it_chooses(tmp_path, options, more, wanted):
    (tmp_path / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.16)\nproject(cube LANGUAGES C)\n{more}\n"
                                             f"add_subdirectory({CHECKOUT} fixel)\n", encoding="utf-8")
    code, text = run(["cmake", "-S", tmp_path, "-B", tmp_path / "build", *options])
    assert code == 0, text
    flags = (tmp_path / "build" / "fixel" / "CMakeFiles" / "fixel.dir" / "flags.make").read_text(encoding="utf-8")
    line = next(line for line in flags.splitlines() if line.startswith("C_FLAGS"))
    assert [word for word in line.split() if word.startswith("-O")] == wanted


# What decides which kernels a library has: the families of cores, and whether it is small or compact.
CHOOSING = re.compile(r"FXL_(KERNELS|CORE)_|FXL_\w+_IN_ASSEMBLY|FXL_IS_(COMPACT|SMALL)|FXL_SCANS_BY_CHAINS|FXL_FILLS_COMPACT")


# The options do not decide which names an object has once the preprocessor has chosen by them.
COMPILED = ("arm-none-eabi-gcc", "-mcpu=cortex-m3", "-mthumb", "-std=gnu11", "-O1", "-w", "-c")


@functools.cache
def names_in(command, text):
    """The functions and records that others may name, of the preprocessed text of a source: it is compiled once, whichever build it is of."""
    with tempfile.TemporaryDirectory() as folder:
        language = "assembler" if command[-1].endswith(".S") else "cpp-output"
        target = pathlib.Path(folder) / "x.o"
        subprocess.run([*command[:-1], "-x", language, "-", "-o", target], input=text, text=True, check=True)
        names = subprocess.run(["arm-none-eabi-nm", "--defined-only", "--extern-only", target], check=True, text=True, capture_output=True).stdout
    return re.findall(r" [A-TV-Z] (\w+)$", names, re.MULTILINE)


def places_of(commands):
    """In which source each function of the kernels and of the sources beside them is, for commands that compile; each must be in one."""
    places = {}
    for command in commands:
        source = re.search(r"lib/(\w+/\w+\.[cS])(?=[\s\"']|$)", command.split(" -c ")[1])[1]
        if source.startswith("study/") or not CHOOSING.search((CHECKOUT / "lib" / source).read_text(encoding="utf-8")):
            continue
        words = shlex.split(command)
        options = [word for before, word in zip(["", *words], words) if "-o" not in (before, word) and word != "-c" and not word.endswith(source)]
        text = subprocess.run([*options, "-E", "-P", f"lib/{source}"], cwd=CHECKOUT, check=True, text=True, capture_output=True).stdout
        for name in names_in((*COMPILED, source), text):
            assert places.setdefault(name, source) == source, f"{name} is in {places[name]} and in {source}"
    return places


@functools.cache
def places_by_make(flags):
    """The places of make lib."""
    done = run_make("lib", "--always-make", "--dry-run", "V=1", "CORE=cortex-m3", f"LIB_FLAGS={flags}")
    return places_of([re.sub(" -(MMD|MP|fstack-usage)", "", line) for line in done.stdout.splitlines() if " -c lib/" in line])


@pytest.mark.parametrize("options, by_make", [
    (["-DCMAKE_C_FLAGS=-Os"], "-Os"), (["-DCMAKE_C_FLAGS=-O2"], ""), (["-DCMAKE_BUILD_TYPE=MinSizeRel"], "-Os"),
    (["-DCMAKE_BUILD_TYPE=Release"], ""), (["-DFXL_COMPACT=OFF"], "")])
def test_a_cmake_project_has_the_kernels_that_make_lib_has(tmp_path, options, by_make):
    """Whatever options the two languages have, C and assembly agree whether the library is compact: each function is there once."""
    code, text = run(["cmake", "-S", CHECKOUT, "-B", tmp_path, "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                      f"-DCMAKE_TOOLCHAIN_FILE={CHECKOUT / 'cmake' / 'arm-none-eabi.cmake'}", *options])
    assert code == 0, text
    commands = [each["command"] for each in json.loads((tmp_path / "compile_commands.json").read_text(encoding="utf-8"))]
    places = places_of(commands)
    assert len([name for name, source in places.items() if source.endswith(".S")]) >= 12
    wanted = places_by_make(by_make)
    assert places == wanted, {name: (places.get(name), wanted.get(name)) for name in set(places) ^ set(wanted)}
    assert places_by_make("") != places_by_make("-Os")


@pytest.mark.parametrize("options, is_refused", [([], True), (["-O2"], False), (["-DFXL_COMPACT=1"], False), (["-DFXL_SMALL"], False)])
def test_assembly_that_cannot_know_how_c_is_compiled_is_refused(tmp_path, options, is_refused):
    done = subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m3", "-mthumb", *options, "-c", CHECKOUT / "lib/clip/clip_by_view_armv7m.S", "-o", tmp_path / "x.o"],
                          text=True, capture_output=True, check=False)
    assert (done.returncode != 0) == is_refused and ("FXL_COMPACT, 0 or 1" in done.stderr) == is_refused


@pytest.mark.parametrize("chosen", ["ON", "OFF"])
def test_a_cmake_project_has_the_study_where_it_asks_for_it(tmp_path, chosen):
    """And the target without it has none of its sources."""
    (tmp_path / "CMakeLists.txt").write_text(f"cmake_minimum_required(VERSION 3.16)\nproject(study LANGUAGES C)\nadd_subdirectory({CHECKOUT} fixel)\n"
                                             "if(TARGET fixel::study)\nfile(WRITE ${CMAKE_BINARY_DIR}/target \"\")\nendif()\n", encoding="utf-8")
    code, text = run(["cmake", "-S", tmp_path, "-B", tmp_path / "build", f"-DFIXEL_STUDY={chosen}", QUICKLY])
    assert code == 0, text
    assert (tmp_path / "build" / "target").exists() == (tmp_path / "build" / "fixel" / "CMakeFiles" / "fixel_study.dir").exists() == (chosen == "ON")
    sources = (tmp_path / "build" / "fixel" / "CMakeFiles" / "fixel.dir" / "build.make").read_text(encoding="utf-8")
    assert "lib/draw/render.c" in sources and "lib/study/" not in sources
