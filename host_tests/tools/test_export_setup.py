# SPDX-License-Identifier: MIT
"""An exported scene sets itself up: fxl_setup_init with NAME_setup draws what make run draws. And how much memory an exported scene says that the
library wants."""

import argparse
import itertools
import math
import re
import subprocess

import numpy
import pytest
from PIL import Image

from board_programs import ROOT, made
from conftest import CHECKOUT, assert_one_sentence, run_cli
from fixel.base.errors import ToolError
from fixel.bench import frame_costs, predict
from fixel.board import crc
from fixel.check import frame_hashes
from fixel.image import image, memory_needed
from fixel.report import showcase_models
from fixel.scene import command as scene_command, compiler, look, making, target
from test_export import CUBE, EXPORTED, compiled, fixture_exported, looks_of, printed  # noqa: F401: the fixture of a header

BUILT_PROGRAMS = ("boards/mps2-an385/walk.elf", "boards/microbit/walk.elf", "boards/stm32vldiscovery/walk.elf", "host/predict")
SCENES = sorted(file.stem for file in (CHECKOUT / "scenes").glob("*.toml"))
FRAMES = 2

# Draws whole frames, then the same in bands of three rows; a scene without a path takes the poses of its arguments.
PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
#include <fixel/crc.h>
#include "scene.h"
#include "scene.h"
enum { ROWS = 16 };
static const uint32_t most = 3; /* rows of a band */
static fxl_setup it;
static uint64_t memory[SCENE_SETUP_MEMORY(ROWS)];
static uint8_t pixels[1024 * 1024 * 2];
static const fxl_pose *eye_of(int frame, char **arguments)
{
    static fxl_pose pose;
    const fxl_pose *eye = fxl_setup_frame(&it, FXL_CAST(uint32_t, frame));
    if (scene_setup.path == NULL) {
        int32_t *const place[] = {&pose.position.x, &pose.position.y, &pose.position.z};
        fxl_angle *const angle[] = {&pose.yaw, &pose.pitch, &pose.roll};
        for (int i = 0; i < 3; i++) {
            *place[i] = FXL_CAST(int32_t, strtol(arguments[6 * frame + i], NULL, 10));
            *angle[i] = FXL_CAST(fxl_angle, strtoul(arguments[6 * frame + 3 + i], NULL, 10));
        }
        eye = &pose;
    }
    return eye;
}
int main(int count, char **arguments)
{
    const fxl_config *config = scene_setup.config;
    const size_t bytes = config->target->pixel_bits / 8u;
    (void)count;
    fxl_status status = fxl_setup_init(&it, &scene_setup, ROWS, memory, sizeof memory);
    if (status != FXL_OK) {
        printf("%d: %s\\n", it.step, fxl_setup_explain(&it, &scene_setup, ROWS, memory, sizeof memory));
        return 1;
    }
    for (int frame = 0; frame < 2; frame++) {
        const fxl_pose *eye = eye_of(frame, arguments + 1);
        uint32_t whole = FXL_CRC_START, bands = FXL_CRC_START;
        fxl_band band = fxl_band();
        band.pixels = pixels;
        band.width = band.stride = config->width;
        band.rows = config->height;
        band.palette = it.renderer.palette;
        status = fxl_render(&it.renderer, eye, pixels, config->width);
        if (status != FXL_OK || fxl_band_crc(&whole, &band) != FXL_OK || fxl_frame_begin(&it.renderer, eye) != FXL_OK) {
            printf("%s\\n", fxl_render_explain(&it.renderer, eye, pixels, config->width, NULL));
            return 2;
        }
        for (uint32_t row = 0; row < config->height; row += band.rows) {
            band.first_row = FXL_CAST(uint16_t, row);
            band.rows = FXL_CAST(uint16_t, config->height - row < most ? config->height - row : most);
            band.pixels = pixels + row * config->width * bytes;
            fxl_frame_fill(&it.renderer, &band, config->background);
            if (fxl_frame_draw(&it.renderer, &band) != FXL_OK || fxl_band_crc(&bands, &band) != FXL_OK) { return 3; }
        }
        printf("%08x %08x\\n", FXL_CAST(unsigned, whole), FXL_CAST(unsigned, bands));
    }
    return 0;
}
"""


# All at once: RGB565 with a depth buffer, texels of 16 bits, smooth light, billboards.
PLANET = """background = "#02030c"
[view]
near = "1/2"
far = 64
pixels = "rgb565"
depth = 16
[light]
levels = 8
ambient = 0.12
direction = [0.8, -0.3, 0.6]
[[billboards]]
name = "star"
file = "star.png"
size = [0.5, 0.5]
anchor = [0.25, 0.25]
[[objects]]
name = "stars"
billboard = "star"
positions = [[20, 3, -9], [-14, 8, 20], [5, -6, 24], [-20, -2, -4]]
[[objects]]
name = "planet"
model = "planet.obj"
fit = 4
images = { size = 32, bits = 16 }
smooth = true
turn = 0
[[objects]]
name = "ring"
solid = "torus"
sides = 12
rings = 4
scale = [7, 0.3, 7]
colour = "#c8b080"
smooth = true
rotation = [0, 0, 18]
[path]
orbit = { radius = 9, height = 2.5, frames = 2 }
"""


def write_planet(folder):
    """The scene file of a planet, with its model and image."""
    across, down = 10, 5
    points = [(math.sin(a) * math.sin(b), math.cos(a), math.sin(a) * math.cos(b)) for j in range(down + 1) for i in range(across + 1)
              for a, b in [(math.pi * j / down, 2 * math.pi * i / across)]]
    corners = [(j * (across + 1) + i + 1, (j + 1) * (across + 1) + i + 1) for j in range(down) for i in range(across)]
    faces = [face for n, (a, c) in enumerate(corners) for face in [(a, c, a + 1)] * (n >= across) + [(a + 1, c, c + 1)] * (n < across * (down - 1))]
    lines = ["mtllib planet.mtl", "usemtl earth", *(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points),
             *(f"vt {i / across:.6f} {1 - j / down:.6f}" for j in range(down + 1) for i in range(across + 1)),
             *("f " + " ".join(f"{corner}/{corner}" for corner in face) for face in faces)]
    (folder / "planet.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "planet.mtl").write_text("newmtl earth\nKd 1 1 1\nmap_Kd earth.png\n", encoding="utf-8")
    Image.fromarray((numpy.indices((32, 64)).sum(0)[..., None] * (5, 3, 2)).astype(numpy.uint8)).save(folder / "earth.png")
    Image.fromarray(numpy.array([[(255, 255, 220, 255 * (i > 0)) for i in (0, 1)] for _ in (0, 1)], numpy.uint8)).save(folder / "star.png")
    (folder / "planet.toml").write_text(PLANET, encoding="utf-8")
    return folder / "planet.toml"


@pytest.fixture(scope="module", params=[*SCENES, "planet"], name="drawn")
def fixture_drawn(request, tmp_path_factory):
    """A scene: the folder with its header, the frames that the host draws of its image."""
    folder = tmp_path_factory.mktemp("setup")
    source = write_planet(folder) if request.param == "planet" else CHECKOUT / "scenes" / f"{request.param}.toml"
    made("build/host/frames")
    making.build(str(source), str(folder / "scene.fxls"))
    scene, _ = compiler.compile_scene(str(source), None, None, None, "program")
    frames = len(scene.path) if scene.path_kind == image.POSES else None
    making.export(str(source), str(folder / "scene.h"), "scene", frames)
    return folder, frame_hashes.drawn_by_host(folder / "scene.fxls", ROOT / "build", folder).frames[:FRAMES]


@pytest.mark.parametrize("language", [["gcc", "-std=c11"], ["g++", "-std=c++11"]], ids=["c", "c++"])
def test_the_setup_draws_the_frames_of_make_run(drawn, language):
    folder, frames = drawn
    name = "main.c" if language[0] == "gcc" else "main.cpp"
    text = PROGRAM if name == "main.cpp" else PROGRAM.replace("fxl_band band = fxl_band();", "fxl_band band = {0};")
    program = compiled(folder, text, "-Wno-redundant-decls", compiler=language, name=name)
    poses = [str(number) for frame in frames for number in (*frame.position, *frame.angles)]
    crcs = crc.drawn(frames).each
    assert printed(program, *poses).split() == [crcs[frame % len(crcs)] for frame in range(FRAMES) for _ in range(2)]


# Functions of the library that a plan names, by the part.
PARTS = {"light": "fxl_attach_light", "lit": "fxl_attach_lit", "surfaces": "fxl_attach_surfaces", "billboards": "fxl_attach_billboards",
         "beams": "fxl_attach_beams", "motions": "fxl_motion_play", "tree": "fxl_submit_by_bsp", "centre": "fxl_renderer_set_centre",
         "depth": "fxl_palette_depth_16", "rgb565": "fxl_rgb565", "clusters": "fxl_clusters", "turned": "fxl_turned_instances"}
HAVE = {"cube": set(), "knot": {"tree"}, "beam": {"beams"}, "lit": {"light", "motions", "turned"}, "window": {"centre"},
        "grove": {"billboards", "surfaces", "motions", "turned"}, "room": {"surfaces", "motions", "turned"}}
SECTIONS = ["-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections"]
BY_HAND = """
#include "scene.h"
int main(void)
{
    static fxl_renderer renderer;
    static uint64_t memory[SCENE_MEMORY];
    fxl_config config = fxl_config_default(320, 240);
    return fxl_renderer_init(&renderer, &scene_scene, &config, memory, sizeof memory);
}
"""
BY_SETUP = """
#include "scene.h"
int main(void)
{
    static fxl_setup it;
    static uint64_t memory[SCENE_SETUP_MEMORY(1)];
    return fxl_setup_init(&it, &scene_setup, 1, memory, sizeof memory);
}
"""


def linked(folder, text):
    """The parts that a program links, and whether it links a setup."""
    names = subprocess.run(["nm", compiled(folder, text, *SECTIONS)], check=True, text=True, capture_output=True).stdout.split()
    return {part for part, name in PARTS.items() if name in names}, "fxl_setup_init" in names


@pytest.mark.parametrize("name", HAVE)
def test_a_program_links_what_the_setup_names_and_without_it_nothing(tmp_path, name):
    making.export(str(CHECKOUT / "scenes" / f"{name}.toml"), str(tmp_path / "scene.h"), "scene")
    assert linked(tmp_path, BY_SETUP) == (HAVE[name], True)
    assert linked(tmp_path, BY_HAND) == (HAVE[name] & {"clusters", "turned"}, False)


def demand_frames_of_make_run(tmp_path, source, asked, options, **build):
    """The program that is written too, in bands and whole, draws what the host draws of the same image. asked: a look.Asked of a model."""
    header, program = tmp_path / "scene.h", tmp_path / "main.c"
    looks = (look.PLAIN if asked is None else look.best(asked, target.Target(), False),)
    made("build/host/frames")
    making.build(str(source), str(tmp_path / "scene.fxls"), looks=looks, **build)
    done = run_cli("export", "--c", source, "-o", header, "--name", "scene", "--program", program, *options)
    assert done.returncode == 0 and str(program) in done.stdout, done.stderr
    frames = frame_hashes.drawn_by_host(tmp_path / "scene.fxls", ROOT / "build", tmp_path).frames
    text, shown = program.read_text(encoding="utf-8"), "(void)fxl_band_crc(&crc, &band);"
    height, path = frames[0].pixels.shape[0], image.load(tmp_path / "scene.fxls").path_kind == image.POSES
    for rows in (16, height):
        drawn = re.sub(r"#define ROWS 16 .*", f"#include <stdio.h>\n#include <fixel/crc.h>\n#define ROWS {rows}\nstatic uint32_t crc;", text)
        drawn = drawn.replace("/* Here band.rows rows", f"if (status == FXL_OK) {{ {shown} }} /* rows")
        drawn = re.sub(r"return (fxl_render\(.*\));", r"const fxl_status status = \1;\n"
                       r"    const fxl_band band = {.pixels = (uint8_t *)pixels[0], .width = WIDTH, .stride = WIDTH, .rows = ROWS, "
                       f".palette = it.renderer.palette}};\n    {shown}\n    return status;", drawn)
        drawn = drawn.replace("WIDTH", str(frames[0].pixels.shape[1])).replace("if (draw(", "crc = FXL_CRC_START;\n        if (draw(")
        drawn = drawn.replace("{ return 2; }", '{ return 2; }\n        printf("%08x\\n", (unsigned)crc);')
        crcs = printed(compiled(tmp_path, drawn, name="shown.c")).split()
        assert crcs == crc.drawn(frames).each[:len(crcs)] if path else len(crcs) == 1
        assert len(crcs) == (len(frames) if path else 1)


@pytest.mark.parametrize("name", ["gallery", "grove", "tiny", "planet.obj", "animated.glb", "emissive.glb", "mirrored.glb", "vertex_colours.obj"])
def test_the_program_that_is_written_too_draws_the_frames_of_make_run(tmp_path, name):
    """In bands, and whole; of a model in the best look."""
    source = CHECKOUT / "scenes" / f"{name}.toml"
    if "." in name:
        source = write_planet(tmp_path).with_suffix(".obj") if name == "planet.obj" else CHECKOUT / "host_tests" / "tools" / "models" / name
    demand_frames_of_make_run(tmp_path, source, look.Asked() if "." in name else None, [])


@pytest.mark.parametrize("model", showcase_models.MODELS, ids=lambda each: each.name)
def test_the_program_of_a_showcase_model_draws_the_frames_of_make_run(tmp_path, monkeypatch, model):
    """Of few pixels; the scan has fewer faces and texels, so that it is made in seconds."""
    monkeypatch.setattr(showcase_models, "SCAN_FACES", 8000)
    monkeypatch.setattr(showcase_models, "SCAN_IMAGE", 512)
    words = model.look.split()
    asked = look.Asked(flat="--flat" in words, simplify=int(words[1]) if "--simplify" in words else None)
    demand_frames_of_make_run(tmp_path, showcase_models.write(model, tmp_path), asked, [*words, "--frames", FRAMES, "--screen", "64x48"],
                              frames=FRAMES, screen=(64, 48))


def test_a_program_of_the_users_own_is_not_written_over(tmp_path):
    program = tmp_path / "main.c"
    program.write_text("int main(void) { return 0; }\n", encoding="utf-8")
    done = run_cli("export", "--c", CHECKOUT / "scenes" / "cube.toml", "-o", tmp_path / "cube.h", "--program", program)
    assert_one_sentence(done, "main.c", "--program")
    assert program.read_text(encoding="utf-8") == "int main(void) { return 0; }\n" and not (tmp_path / "cube.h").exists()


# Two tetrahedra, of which one hides the other: a depth buffer is wanted.
PAIR = "".join(f"v {x + at} {y} {z}\n" for at in (0, 1.5) for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))) + \
    "".join(f"f {a + n} {b + n} {c + n}\n" for n in (0, 4) for a, b, c in ((1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4)))


@pytest.mark.parametrize("board, options, shown, rows", [
    ("microbit", [], "fxl_palette", 8), ("microbit", ["--frames", "24"], "fxl_palette", 8),
    ("microbit", ["--screen", "64x48"], "fxl_rgb565_depth_16", 16), ("stm32vldiscovery", [], "fxl_palette", 3),
    ("mps2-an385", [], "fxl_rgb565_depth_16", 16), (None, ["--frames", "24"], "fxl_rgb565_depth_16", 16)])
def test_a_model_is_exported_as_a_board_draws_it(tmp_path, board, options, shown, rows):
    """Its program has no more rows in a band than the board has room for."""
    (tmp_path / "pair.obj").write_text(PAIR, encoding="utf-8")
    done = run_cli("export", "--c", tmp_path / "pair.obj", "-o", tmp_path / "pair.h", "--program", tmp_path / "main.c",
                   *(["--board", board] if board else []), *options)
    assert done.returncode == 0, done.stderr
    config = re.search(r"fxl_config pair_config = \{(.*?)\}", (tmp_path / "pair.h").read_text(encoding="utf-8"), re.DOTALL)[1]
    assert f"&{shown}," in config and f"#define ROWS {rows} " in (tmp_path / "main.c").read_text(encoding="utf-8")


@pytest.mark.parametrize("scene, board, said", [
    ("examples/cube/cube.obj", "nothere", ["nothere", "microbit", "pico"]), ("scenes/cube.toml", "microbit", ["cube.toml", "--board"])])
def test_a_board_that_says_nothing_of_a_scene_is_refused(tmp_path, scene, board, said):
    done = run_cli("export", "--c", CHECKOUT / scene, "-o", tmp_path / "cube.h", "--board", board)
    assert_one_sentence(done, *said)
    assert not (tmp_path / "cube.h").exists()


def test_a_board_whose_program_alone_knows_its_room_is_refused_where_that_is_not_built(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ToolError) as error:
        scene_command.main(["export", "--c", str(CHECKOUT / "examples/cube/cube.obj"), "-o", str(tmp_path / "cube.h"), "--board", "netduino2"])
    assert "--board" in str(error.value) and "make run BOARD=netduino2 SCENE=" in str(error.value)
    assert not (tmp_path / "cube.h").exists()


# What the library makes of blocks of several sizes; then the path, with the block that the header asks for.
MEMORY = """
#include <stdio.h>
#include <fixel/all.h>
#include "scene.h"
#define JOIN(a, b)  JOINED(a, b)
#define JOINED(a, b) a##b
#define OF(what)    JOIN(NAME, what)
static fxl_renderer renderer;
static uint64_t memory[MEMORY];
static fxl_status init(size_t units)
{
    static const uint16_t palette[256];
    fxl_config config = OF(_config);
    config.target = &TARGET;
    config.palette = palette;
    return fxl_renderer_init(&renderer, &OF(_scene), &config, memory, units * sizeof memory[0]);
}
int main(void)
{
    if (init(LEAST - 1) != FXL_E_CAPACITY || renderer.memory_missing != sizeof memory[0]) { return 1; }
    for (size_t units = LEAST; units <= MEMORY; units += units < MEMORY && units + 97 > MEMORY ? MEMORY - units : 97) {
        if (init(units) != FXL_OK) { return 2; }
        const fxl_vertex_cache *cache = &renderer.workspace.cache;
        const uint64_t *list = (const uint64_t *)(const void *)renderer.frame.display_list.words;
        printf("%u %u %u\\n", (unsigned)units, cache->entries == NULL ? 0 : (unsigned)cache->mask + 1,
               (unsigned)renderer.frame.display_list.capacity);
        if (list + (renderer.frame.display_list.capacity + 1) / 2 > memory + units) { return 3; }
    }
#ifdef SURFACES
    static fxl_surfaces surfaces;
    if (fxl_attach_surfaces(&renderer, &surfaces, &OF(_surfaces), &JOIN(TARGET, _surfaces)) != FXL_OK) { return 6; }
#endif
#ifdef BILLBOARDS
    static fxl_billboards billboards;
    if (fxl_attach_billboards(&renderer, &billboards, &OF(_billboards), &JOIN(TARGET, _sprites)) != FXL_OK) { return 7; }
#endif
#ifdef PATH
    unsigned most = 0;
    for (int frame = 0; frame < PATH; frame++) {
        if (fxl_frame_begin(&renderer, &OF(_path)[frame]) != FXL_OK) { return 4; }
        most = renderer.frame.display_list.used > most ? renderer.frame.display_list.used : most;
        if (renderer.frame.resume.instances < renderer.frame.visible_count) { return 5; }
    }
    printf("most %u\\n", most);
#endif
    return 0;
}
"""


def test_the_header_names_three_sizes(exported):
    text = (exported.folder / "scene.h").read_text(encoding="utf-8")
    sizes = [int(re.search(rf"^#define {exported.name.upper()}_MEMORY{more} +(\d+)$", text, re.MULTILINE)[1])
             for more in ("_LEAST", "", "_FAST")]
    assert sizes == [size(exported.scene) for size in (memory_needed.least, memory_needed.moderate, memory_needed.most)]
    assert all(f"{8 * size:,} bytes" in " ".join(text.split("#ifndef")[1].split(" * ")).replace("\n", "") for size in sizes)


def divided(scene, units):
    """Cache entries and words of the display list, from the rule in words: the order of drawing first; of
    the rest a quarter at most for the cache, a power of two of entries and no more than the largest
    model needs; all that is left is the list."""
    rest = (units - memory_needed.least(scene)) * 8
    entries = 1
    while entries < max(len(model.vertices) for model in scene.models):
        entries *= 2
    while entries > rest // 4 // 40:
        entries //= 2
    return entries, (rest - entries * 40) // 4


def test_the_library_divides_the_block_as_the_tool_says(exported):
    name = exported.name.upper()
    path = [f"-DPATH={name}_FRAMES"] if exported.frames else []
    program = compiled(exported.folder, MEMORY, f"-DNAME={exported.name}", f"-DMEMORY={name}_MEMORY_FAST",
                       f"-DLEAST={name}_MEMORY_LEAST", *path, *looks_of(exported.scene))
    rows = printed(program).splitlines()
    if exported.frames:
        assert int(rows.pop().split()[1]) > 0
    found = [tuple(map(int, row.split())) for row in rows]
    assert found[0][0] == memory_needed.least(exported.scene) and found[-1][0] == memory_needed.most(exported.scene)
    for units, entries, words in found:
        assert (entries, words) == divided(exported.scene, units) == memory_needed.divided(exported.scene, units), units
    _, entries, words = found[-1]
    assert entries >= max(len(model.vertices) for model in exported.scene.models)
    assert words >= memory_needed.most_words(exported.scene)
    assert divided(exported.scene, found[-1][0] - 1) != (entries, words)


def test_with_one_unit_less_something_is_missing():
    """most() is the least block that holds all."""
    for file, layers in EXPORTED.values():
        scene, _ = compiler.compile_scene(str(file), None, None, layers, "program")
        most = memory_needed.most(scene)
        vertices = max(len(model.vertices) for model in scene.models)

        def is_enough(units):
            entries, words = divided(scene, units)
            return entries >= vertices and words >= memory_needed.most_words(scene)
        assert is_enough(most) and not is_enough(most - 1)


MODELS = ["scenes/plaza.toml", "scenes/w3b.toml", "scenes/spin.toml", "scenes/landscape.toml", "scenes/c500.toml", "scenes/f32.toml",
          "scenes/lit.toml", "scenes/room.toml", "scenes/gallery.toml", "scenes/car.toml", CUBE]    # smooth, textured, with a depth buffer too


def test_what_less_memory_costs(tmp_path):
    """The header's comment, docs/hello.md and make predict say so: of a Cortex-M3 and of a Cortex-M0."""
    most, options = {}, argparse.Namespace(build=made("build/host/predict").parents[1], frames=6, scene="")
    for file, core in itertools.product(MODELS, ("m3", "m0")):
        compiled_scene, options.scene = tmp_path / "scene.fxls", str(file)
        making.build(str(ROOT / file), compiled_scene, 12 if str(file).endswith(".obj") else None)
        told = predict.of_memory(options, compiled_scene, frame_costs.load()["cores"][core])
        fast, moderate, least = ({way: each[way] for way in ("bytes", "fxl_render", "bands")} for each in told)
        bands = -(-image.load(compiled_scene).height // predict.BAND_ROWS)
        for way in ("fxl_render", "bands"):
            assert fast[way] <= 1.001 * moderate[way] and moderate[way] <= 1.001 * least[way], (file, way)
            most[core, way] = [max(old, each[way] / fast[way]) for old, each in zip(most.get((core, way), (0, 0)), (moderate, least))]
        assert all(each["bands"] <= (bands + 1) * each["fxl_render"] for each in (fast, moderate, least)), file
        assert moderate["bytes"] - least["bytes"] <= 10240 and least["bytes"] <= moderate["bytes"] <= fast["bytes"]
    # The table of docs/hello.md: its bounds hold, and are not far from what is so.
    table = re.findall(r"^\| `CUBE_MEMORY\w*` .* \| up to ([\d.]+) times \| up to ([\d.]+) times \|$", (ROOT / "docs/hello.md").read_text(), re.M)
    for way, bounds in zip(("fxl_render", "bands"), zip(*table, strict=True), strict=True):
        assert all(0.9 * float(bound) <= found <= float(bound) for found, bound in zip(most["m3", way], bounds, strict=True)), (way, most)
