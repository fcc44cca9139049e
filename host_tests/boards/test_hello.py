# SPDX-License-Identifier: MIT
"""docs/hello.md and examples/cube are true to the letter: every block of code is compiled and run, every
command is executed, and the first program's picture is the same on every core."""

import re
import shlex
import subprocess
import zlib

import numpy
from PIL import Image
import pytest

from board_programs import BOARD, ROOT, built, made
from conftest import run_make
from fixel.scene import making, target
from fixel.board import emulator, room
from fixel.board.wires import rgb565
from test_displays import read_wires

BUILT_PROGRAMS = ("lib/*",)
PAGE = (ROOT / "docs" / "hello.md").read_text(encoding="utf-8")
# A firmware of the reader's own. What the page has in the folder my stands here beside the other files.
BOARD_PAGE = (ROOT / "docs" / "tutorials" / "board.md").read_text(encoding="utf-8").replace("-Imy", "-I.").replace("my/", "")
README = (ROOT / "README.md").read_text(encoding="utf-8")
EXAMPLE = ROOT / "examples" / "cube"
FRAME = ROOT / "host_tests" / "boards" / "examples" / "frame.c"
BLOCK = re.compile(r"```(?:c|cpp|ld)\n(?:/\*|//) ([a-z]+\.(?:cpp|c|h|ld))\b[^\n]*\n(.*?)```", re.DOTALL)
BLOCKS, BOARD_BLOCKS = dict(BLOCK.findall(PAGE)), dict(BLOCK.findall(BOARD_PAGE))
COMMANDS, BOARD_COMMANDS = (re.findall(r"^    ((?:make|tools/|gcc|arm-|qemu-).*)$", text, re.MULTILINE) for text in (PAGE, BOARD_PAGE))
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]
C11 = ("gcc", "-std=c11")
WRAPPED = "-Wl,--wrap=main"     # for FRAME, which calls the program's main
WIDTH, HEIGHT = 320, 240

# What the reader writes, for the tests: pixels, or what goes to a display, to stdout.
DISPLAY_ROWS = """
#include <stdint.h>
#include <stdio.h>
void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *pixels);
void display_rows(uint16_t first_row, uint16_t rows, const uint8_t *pixels)
{
    static uint32_t next;
    if (first_row != next % 240) { fprintf(stderr, "row %u\\n", first_row); }
    next = first_row + (uint32_t)rows;
    fwrite(pixels, 320, rows, stdout);
}
"""
DISPLAY_SEND = """
#include <stdint.h>
#include <stdio.h>
void display_send(const uint8_t *bytes, uint32_t size);
void display_send(const uint8_t *bytes, uint32_t size) { fwrite(bytes, 1, size, stdout); }
"""
KEYS = """
#include <fixel/all.h>
uint32_t keys_held(void);
uint32_t keys_held(void)
{
    static int frame;
    frame++;
    return frame > 6 ? FXL_KEY_ALL : frame > 3 ? FXL_KEY_FORWARD : FXL_KEY_LEFT;
}
"""
# The two cores are threads.
THREADS = """
#include <pthread.h>
#include <stddef.h>
void on_both_cores(void (*work)(int core));
static void (*share)(int core);
static void *second_core(void *unused)
{
    (void)unused;
    share(1);
    return NULL;
}
void on_both_cores(void (*work)(int core))
{
    pthread_t thread;
    share = work;
    if (pthread_create(&thread, NULL, second_core, NULL)) { return; }
    share(0);
    pthread_join(thread, NULL);
}
"""
# Included before a program: there is no room for a display list, so both cores traverse the scene.
LEAST = """
#include "cube_scene.h"
#undef CUBE_MEMORY
#undef CUBE_MEMORY_FAST
#define CUBE_MEMORY CUBE_MEMORY_LEAST
#define CUBE_MEMORY_FAST CUBE_MEMORY_LEAST
"""
# The wires of a display go to wires.bin (host_tests/boards/displays/wires_mock.c).
WIRED = """
#include "wires_mock.h"
#include <stdbool.h>
#include <stdlib.h>
bool wires_open(void);
__attribute__((constructor)) static void begin(void)
{
    if (!wires_open()) { exit(1); }
}
__attribute__((destructor)) static void end(void) { wires_mock_end(); }
"""
# The frames of the path, whole, by the first level.
WHOLE = """
#include <stdio.h>
#include <fixel.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[240][320];
int main(void)
{
    fxl_config view = cube_config;
    view.target = &fxl_palette; /* a byte a pixel */
    if (fxl_renderer_init(&renderer, &cube_scene, &view, memory, sizeof memory)) { return 1; }
    for (int i = 0; i < CUBE_FRAMES; i++) {
        if (fxl_render(&renderer, &cube_path[i], pixels[0], 320)) { return 1; }
        fwrite(pixels, 1, sizeof pixels, stdout);
    }
    return 0;
}
"""


def library(core):
    done = run_make("lib", f"CORE={core}")
    assert done.returncode == 0, done.stderr
    return ROOT / "build" / "lib" / core


@pytest.mark.parametrize("core", ["foo", "cortex-a53", ""])
def test_an_unknown_core_is_refused_with_a_list(core):
    done = run_make("lib", f"CORE={core}")
    assert done.returncode == 2 and f"CORE={core} is unknown; the cores are: cortex-m0 " in done.stderr
    assert not (ROOT / "build" / "lib" / "unknown").exists()


@pytest.mark.parametrize("core", ["m55", "cortex-m55"])
def test_the_readers_core_reaches_the_compiler(core):
    """No flag of the library's takes the core's place: -mcmse would not compile then."""
    done = run_make("lib", "--always-make", "--dry-run", f"CORE={core}", "LIB_FLAGS=-mcmse")
    lines = [line for line in done.stdout.splitlines() if re.search(r"\bgcc .* -c ", line)]
    assert done.returncode == 0 and len(lines) > 50
    assert all({"-mcpu=cortex-m55", "-mthumb", "-mcmse"} <= set(line.split()) and line.count("-mcpu=") == 1 for line in lines)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """A folder with the page's files, the exported scene among them."""
    folder = tmp_path_factory.mktemp("hello")
    for name, text in {**BLOCKS, **BOARD_BLOCKS}.items():
        (folder / name).write_text(text, encoding="utf-8")
    for name, text in (("rows.c", DISPLAY_ROWS), ("send.c", DISPLAY_SEND), ("keys.c", KEYS), ("threads.c", THREADS), ("least.h", LEAST),
                       ("wired.c", WIRED), ("whole.c", WHOLE)):
        (folder / name).write_text(text, encoding="utf-8")
    export(folder)
    library("host")
    return folder


def export(folder):
    """The page's scene, of palette entries."""
    making.export(str(EXAMPLE / "cube.obj"), str(folder / "cube_scene.h"), frames=60)


def compiled(folder, compiler, *files):
    host = ROOT / "build" / "lib" / "host"
    done = subprocess.run([*compiler, *WARNINGS, f"-I{host / 'include'}", f"-I{folder}", *files, host / "libfixel.a",
                           "-o", "program"], cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return folder / "program"


def drawn(folder, *files):
    """What a program of these files, in C11, writes to stdout, as bytes."""
    done = subprocess.run([compiled(folder, C11, *files)], cwd=folder, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    return numpy.frombuffer(done.stdout, dtype=numpy.uint8)


def picture_of(folder, program, compiler=C11):
    """The pixels of a first program."""
    file = compiled(folder, compiler, f'-DEXAMPLE="{program}"', FRAME, WRAPPED)
    done = subprocess.run([file], capture_output=True, check=True)
    return numpy.frombuffer(done.stdout, dtype=numpy.uint8).reshape(HEIGHT, WIDTH)


def palette_of(folder):
    text = re.search(r"cube_palette\[256\]\[3\] = \{(.*?)\};", (folder / "cube_scene.h").read_text(), re.DOTALL).group(1)
    entries = numpy.array(list(map(int, re.findall(r"\d+", text))), dtype=numpy.uint8).reshape(-1, 3)
    return numpy.concatenate([entries, numpy.zeros((256 - len(entries), 3), numpy.uint8)])


@pytest.fixture(scope="module")
def picture(page):
    return picture_of(page, EXAMPLE / "main.c")


def test_a_lopsided_window_shows_the_same_perspective(page, picture):
    """Straight ahead is half a screen further right, so each column is one of the usual picture."""
    moved = picture_of(page, "window.c")
    assert (moved[:, WIDTH // 2:] == picture[:, :WIDTH // 2]).all()
    assert len(set(moved[:, WIDTH // 2:].ravel())) > 1


def statements(program):
    """A program without its comments and its layout."""
    return re.sub(r"\s+", "", re.sub(r"/\*.*?\*/", "", program, flags=re.DOTALL))


def test_readme_page_and_example_have_the_same_program():
    readme = re.search(r"```c\n(#include <fixel\.h>.*?)```", README, re.DOTALL).group(1)
    example = (EXAMPLE / "main.c").read_text(encoding="utf-8")
    assert readme == example
    assert statements(BLOCKS["main.c"]) == statements(example)
    assert len(example.splitlines()) <= 15


def test_the_page_has_its_sections():
    assert set(BLOCKS) == {"main.c", "main.cpp", "picture.c", "bands.h", "bands.c", "cores.c", "loop.c", "steer.c",
                           "turn.c", "display.c", "ahead.c", "spin.c", "screen.c", "window.c"}
    assert set(BOARD_BLOCKS) == {"start.c", "chip.ld", "firmware.c"}
    assert PAGE.count("\n## ") == 8 and PAGE.count("```") == 2 * len(BLOCKS)


def test_each_program_is_what_a_reader_types():
    """No program is another one whose main has another name; they share a header."""
    for name, text in {**BLOCKS, "README": README}.items():
        assert not re.search(r"#\s*define\s+main\b|#\s*include\s+[<\"][\w/]+\.c[\">]", text), name
    assert sum('#include "bands.h"' in text for text in BLOCKS.values()) == 6


def test_the_picture_is_a_cube(page, picture):
    """Its background, three sides, and nothing else; in the middle of the screen."""
    colours, counts = numpy.unique(picture, return_counts=True)
    assert len(colours) == 4 and colours[0] == 0 and counts[1:].min() > 300
    rows, columns = numpy.nonzero(picture)
    assert 80 < rows.min() < rows.max() < 200 and 90 < columns.min() < columns.max() < 230


@pytest.mark.parametrize("compiler, program", [
    (("clang", "-std=c11"), EXAMPLE / "main.c"),
    (("gcc", "-std=c2x"), EXAMPLE / "main.c"),
    # C++ has a warning of its own for fields that are not named; they are 0, as in C.
    (("g++", "-std=c++20", "-x", "c++", "-Wold-style-cast", "-Wno-missing-field-initializers"), EXAMPLE / "main.c"),
    (("g++", "-std=c++11", "-x", "c++", "-Wold-style-cast"), "main.cpp"),
    (("clang++", "-std=c++11", "-x", "c++", "-Wold-style-cast"), "main.cpp"),
], ids=lambda value: "-".join(value[:2]) if isinstance(value, tuple) else "")
def test_each_language_draws_the_same_picture(page, picture, compiler, program):
    if "++" in compiler[0]:  # what -x says holds for an archive too
        host = ROOT / "build" / "lib" / "host"
        done = subprocess.run([*compiler, *WARNINGS, f"-I{host / 'include'}", f"-I{page}", f'-DEXAMPLE="{program}"',
                               "-c", FRAME, "-o", "frame.o"], cwd=page, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")
        subprocess.run([compiler[0], WRAPPED, "frame.o", host / "libfixel.a", "-o", "program"], cwd=page, check=True)
        done = subprocess.run([page / "program"], capture_output=True, check=True)
        assert done.stdout == picture.tobytes()
    else:
        assert picture_of(page, program, compiler).tobytes() == picture.tobytes()


def test_the_program_links_no_check_of_a_scene(page):
    program = compiled(page, C11, "main.c")
    names = subprocess.run(["nm", program], capture_output=True, text=True, check=True).stdout.split()
    assert "fxl_render" in names and not [name for name in names if "check" in name or "scene_open" in name]


def test_the_file_that_the_page_writes_is_the_picture_that_it_shows(page, picture):
    drawn(page, "picture.c")
    with Image.open(page / "cube.ppm") as written, Image.open(ROOT / "docs" / "cube.png") as shown:
        assert numpy.array_equal(numpy.asarray(written.convert("RGB")), palette_of(page)[picture])
        assert numpy.array_equal(numpy.asarray(shown.convert("RGB")), palette_of(page)[picture])


def test_bands_draw_the_same_picture(page, picture):
    assert drawn(page, "bands.c", "rows.c").tobytes() == picture.tobytes()


def test_two_cores_draw_the_same_picture(page, picture):
    assert drawn(page, "-pthread", "cores.c", "threads.c", "rows.c").tobytes() == picture.tobytes()


WATCHED = (*C11, "-O1", "-pthread", "-fsanitize=thread", "-ffunction-sections", "-fdata-sections",
           f"-I{ROOT / 'lib'}", f"-I{ROOT / 'lib' / 'include'}")


@pytest.fixture(scope="module")
def watched_library(tmp_path_factory):
    """The library's objects with ThreadSanitizer, for all programs of two threads."""
    folder = tmp_path_factory.mktemp("watched")
    rooms = ("math", "scene", "view", "clip", "raster", "paint", "draw")
    sources = [file for room in rooms for file in (ROOT / "lib" / room).glob("*.c")]
    done = subprocess.run([*WATCHED, "-c", *sources], cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    objects = list(folder.glob("*.o"))
    assert len(objects) == len(sources)
    return objects


def watched(page, library_objects, *files):
    """What a program of two threads writes. ThreadSanitizer ends it with 66 where the threads meet."""
    built_so = subprocess.run([*WATCHED, "-Wl,--gc-sections", *files, *library_objects, "-o", "threads"],
                              cwd=page, capture_output=True, text=True, check=False)
    assert (built_so.returncode, built_so.stderr) == (0, "")
    # Without random addresses: some kernels choose such as ThreadSanitizer cannot start with.
    done = subprocess.run(["setarch", "-R", "./threads"], cwd=page, capture_output=True, check=False)
    assert (done.returncode, done.stderr.decode()) == (0, "")
    return done.stdout


@pytest.mark.parametrize("least", [[], ["-include", "least.h"]])
def test_two_cores_touch_nothing_of_each_other(page, picture, watched_library, least):
    assert watched(page, watched_library, *least, "cores.c", "threads.c", "rows.c") == picture.tobytes()


@pytest.mark.parametrize("least", [[], ["-include", "least.h"]])
def test_a_frame_begins_while_another_is_drawn(page, watched_library, least):
    assert watched(page, watched_library, *least, "ahead.c", "threads.c", "rows.c") == drawn(page, "whole.c").tobytes()


def test_a_scene_changes_while_its_frame_is_drawn(page, watched_library):
    assert watched(page, watched_library, "spin.c", "threads.c", "rows.c") == drawn(page, "turn.c", "rows.c").tobytes()


def test_without_room_for_the_frame_the_scene_must_not_change(page):
    program = compiled(page, C11, "-include", "least.h", "-pthread", "spin.c", "threads.c", "rows.c")
    done = subprocess.run([program], capture_output=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (1, b"", b"")


def test_the_loop_draws_the_path(page):
    frames = drawn(page, "loop.c", "rows.c").reshape(60, HEIGHT, WIDTH)
    assert frames.tobytes() == drawn(page, "whole.c").tobytes()
    assert len({frame.tobytes() for frame in frames}) == 60 and all(frame.any() for frame in frames)


def test_keys_steer_the_camera(page):
    frames = drawn(page, "steer.c", "rows.c", "keys.c").reshape(6, HEIGHT, WIDTH)
    assert len({frame.tobytes() for frame in frames}) == 6 and all(frame.any() for frame in frames)
    # Turned to the left, the cube moves to the right; then it comes nearer.
    middle = [numpy.nonzero(frame)[1].mean() for frame in frames]
    assert middle[0] < middle[1] < middle[2]
    assert numpy.count_nonzero(frames[5]) > numpy.count_nonzero(frames[3])


def test_the_cube_turns_once(page, picture):
    frames = drawn(page, "turn.c", "rows.c").reshape(60, HEIGHT, WIDTH)
    assert frames[0].tobytes() == picture.tobytes()
    assert len({frame.tobytes() for frame in frames}) == 60
    # A quarter turn shows the next side where the first was.
    assert ((frames[15] != 0) == (frames[0] != 0)).mean() > 0.999


def test_the_display_gets_the_colours_of_the_palette(page, picture):
    sent = drawn(page, "bands.c", "display.c", "send.c").reshape(HEIGHT, WIDTH, 2).astype(int)
    red, green, blue = (palette_of(page)[picture][..., i].astype(int) for i in range(3))
    assert numpy.array_equal(sent[..., 0] << 8 | sent[..., 1], (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3)


@pytest.mark.parametrize("pixels", ["palette", "rgb565"])
def test_an_st7789_shows_the_path(page, tmp_path, pixels):
    """Its program is short, and what comes over the wires are the frames of the path: at the end the last one."""
    making.export(str(EXAMPLE / "cube.obj"), str(tmp_path / "cube_scene.h"), frames=60, asked=target.Target(pixels=pixels))
    (tmp_path / "screen.c").write_text(BLOCKS["screen.c"], encoding="utf-8")
    mock = ROOT / "host_tests" / "boards" / "displays"
    drawn(tmp_path, "screen.c", page / "wired.c", mock / "wires_mock.c", f"-I{mock}")
    display = read_wires(tmp_path / "wires.bin")
    last = drawn(page, "whole.c").reshape(60, HEIGHT, WIDTH)[-1]
    assert display.on and display.inverted and display.access == 0x60
    assert f"&fxl_{pixels}," in (tmp_path / "cube_scene.h").read_text(encoding="utf-8")
    assert numpy.array_equal(display.picture(1), rgb565(palette_of(page))[last])
    assert len([line for line in BLOCKS["screen.c"].splitlines() if line.strip()]) <= 22


def test_the_commands_run_as_written(page):
    """make where Fixel is; the others where the reader's files are, with Fixel's folders beside."""
    for name in ("build", "tools", "examples"):
        (page / name).symlink_to(ROOT / name)
    assert COMMANDS[0] == "tools/setup.sh tools"
    assert [command.split()[0] for command in COMMANDS[1:]] == \
        ["tools/scene.py", "make", "gcc", "make", "arm-none-eabi-gcc", "make", "tools/scene.py"]
    for command in COMMANDS[1:]:
        if command.startswith("make "):
            words = [word.replace("PROGRAM=", f"PROGRAM={page}/") for word in shlex.split(command)[1:]]
            done = run_make(*words, *([f"OUT={page / 'run'}"] if words[0] == "run" else []))
        else:
            done = subprocess.run(command, shell=True, cwd=page, capture_output=True, text=True, check=False)
        assert done.returncode == 0, (command, done.stderr)


def test_a_program_of_your_own_shows_its_picture(page, picture):
    """The first program, on the board that the page names."""
    command, = [each for each in COMMANDS if each.startswith("make run PROGRAM=")]
    done = run_make(*[word.replace("PROGRAM=", f"PROGRAM={page}/") for word in shlex.split(command)[1:]], f"OUT={page / 'shown'}")
    assert done.returncode == 0 and "equal to host         yes" in done.stdout, done.stdout + done.stderr
    with Image.open(page / "shown" / "frame_0000.png") as shown:
        assert numpy.array_equal(numpy.asarray(shown.convert("RGB")), palette_of(page)[picture])


def firmware_of(page):
    """The firmware of the tutorial of the board, built as the page says."""
    library("cortex-m3")
    if not (page / "build").exists():
        (page / "build").symlink_to(ROOT / "build")
    command = [each for each in BOARD_COMMANDS if each.startswith("arm-none-eabi-gcc")][-1]
    done = subprocess.run(command.replace("-O2", "-O2 -std=c11 -Wall -Wextra -Werror"), shell=True, cwd=page, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return page / "firmware.elf"


def test_a_firmware_of_your_own_prints_the_frames(page):
    """Of a scene of palette entries: the commands of the page have exported it in RGB565 meanwhile."""
    export(page)
    firmware_of(page)
    frames = drawn(page, "whole.c").reshape(60, HEIGHT * WIDTH)
    process = subprocess.Popen(shlex.split(BOARD_COMMANDS[-1]), cwd=page, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)
    try:
        said = [process.stdout.readline().strip() for _ in range(61)]
    finally:
        process.kill()
        process.communicate()
    assert said == [f"{zlib.crc32(frame.tobytes()):08x}" for frame in (*frames, frames[0])]


def test_a_firmware_of_your_own_is_short():
    """Start code, linker script and command: 40 lines."""
    lines = [line for name in ("start.c", "chip.ld") for line in BOARD_BLOCKS[name].splitlines() if line.strip()]
    assert len(lines) + 2 + 2 <= 40


def objects_for(core):
    """The board's parts, and the library for a core: for the M3 as the board's programs have it, since
    the board traps misaligned access."""
    parts = sorted(built(f"{BOARD}/walk.elf").parent.glob("boards/**/*.o"))
    if core == "cortex-m0":
        return [*parts, library(core) / "libfixel.a"]
    return [*parts, made("build/core/cpu-cortex-m3_float-abi-soft_no-unaligned-access/unit/libfixel.a")]


# The board has an M3, which runs what is compiled for an M0 too (bench/bench.mk).
@pytest.mark.parametrize("core", ["cortex-m0", "cortex-m3"])
def test_an_emulated_core_draws_the_same_picture(page, picture, core):
    program = page / f"{core}.elf"
    done = subprocess.run(["arm-none-eabi-gcc", f"-mcpu={core}", "-mthumb", "-mfloat-abi=soft", "-std=c11", "-O2", *WARNINGS,
                           "-ffreestanding", "-ffunction-sections", "-fdata-sections", f"-I{ROOT / 'lib' / 'include'}",
                           f"-I{page}", f"-I{ROOT / 'boards'}", "-DEXAMPLE_ON_BOARD",
                           f'-DEXAMPLE="{EXAMPLE / "main.c"}"', FRAME, *objects_for(core), "-nostartfiles",
                           "-nostdlib", "-lgcc", *(f"-Wl,--defsym=fxl_{name}={value}" for name, value in room.memory(BOARD).items()), "-T", ROOT / "linker/sections.ld",
                           "-Wl,--gc-sections,--no-warn-rwx-segments", WRAPPED, "-o", program],
                          capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    ending = emulator.run_text(program)
    assert ending.code == emulator.exit_code("DONE"), ending.output
    assert f"crc {zlib.crc32(picture.tobytes()):08x}" in ending.output
