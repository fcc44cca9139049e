# SPDX-License-Identifier: MIT
"""Two threads draw one frame, each in a workspace of its own, with each target and all that may be attached: the pixels are
those of one thread, and ThreadSanitizer finds no word that one of them writes while the other uses it."""

import subprocess

import pytest
from conftest import CHECKOUT

BUILT_PROGRAMS = ()
PROGRAM = r"""
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <fixel/all.h>

enum { W = 40, H = 32, ROWS = 4, SURFACES = 1, LIGHT = 2, BEAMS = 4, OUTLINES = 8, SETS = 16 };

#define NEAR FXL_UNITS(2)
static const fxl_point vertices[] = {{-NEAR, -NEAR, FXL_UNITS(6)}, {-NEAR, NEAR, FXL_UNITS(6)}, {NEAR, NEAR, FXL_UNITS(6)},
                                     {NEAR, -NEAR, FXL_UNITS(6)},  {-65536, -65536, FXL_UNITS(4)}, {-65536, 65536, FXL_UNITS(4)},
                                     {65536, 65536, FXL_UNITS(4)}, {65536, -65536, FXL_UNITS(4)}};
static const uint16_t indices[] = {0, 1, 2, 0, 2, 3, 0, 1, 2, 3};
static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 3, 1, {0, 1, 2}}, {{0, 0, -FXL_Q2_30_ONE}, 3, 2, {0, 2, 3}},
                                 {{0, 0, -FXL_Q2_30_ONE}, 4, 3, FXL_INDICES_AT(0, 6)}};
static const fxl_model models[] = {{0, 4, 0, 2, FXL_MODEL_SORTED, 0, 0, FXL_UNITS(9), 0}, {4, 4, 2, 1, 0, 0, 0, FXL_UNITS(8), 0}};
static const fxl_instance instances[] = {{{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 1, 0}};
static fxl_scene scene = {.vertices = vertices, .indices = indices, .faces = faces, .models = models, .instances = instances,
                          .vertex_count = 8, .index_count = 10, .face_count = 3, .model_count = 2, .instance_count = 2};
static const fxl_surface surface = {.opacity = 16, .flags = FXL_SURFACE_LIT};
static const fxl_mapped_face mapped = {.corners = {0, 1, 2}};
static const fxl_corner corners[] = {{{0, 0}, 0, 0}, {{0, 65536}, 1, 0}, {{65536, 65536}, 2, 0}};
static const uint16_t face_map[] = {0, 0, 1};
static const fxl_direction normals[] = {{0, 0, -FXL_Q2_30_ONE}};
static const fxl_surface_set set = {.surfaces = &surface, .faces = &mapped, .face_map = face_map, .corners = corners, .normals = normals,
                                    .surface_count = 1, .face_count = 1, .corner_count = 3, .normal_count = 1};
static fxl_renderer renderer;
static fxl_workspace second;
static uint64_t memory[2000], room[2000], beam_room[2000], depth[FXL_DEPTH_BYTES(W, H, 32) / 8];
static uint16_t one[W * H], two[W * H], palette[256];
static uint8_t ramp[FXL_LIGHT_RAMP_BYTES(2)], brighter[256];
static pthread_barrier_t barrier;
static int wrong;

typedef struct { const fxl_target *target; const fxl_painter *painter; } into;
#define INTO(target) {&target, FXL_SURFACES_OF(target)}
static const into all[] = {INTO(fxl_palette), INTO(fxl_palette_depth_16), INTO(fxl_palette_depth_32), INTO(fxl_rgb565),
                           INTO(fxl_rgb565_depth_16), INTO(fxl_rgb565_depth_32)};

#define CHECK(is) do { if (!(is)) { fprintf(stderr, "line %d: %s\n", __LINE__, #is); wrong = 1; } } while (0)

static void draw(fxl_workspace *workspace, uint16_t *pixels, unsigned first, unsigned step)
{
    const unsigned bytes = renderer.target->pixel_bits / 8u;
    for (unsigned row = first * ROWS; row < H; row += step * ROWS) {
        const fxl_band band = {.pixels = (uint8_t *)pixels + row * W * bytes, .width = W, .stride = W, .first_row = (uint16_t)row,
                               .rows = ROWS, .palette = renderer.palette};
        fxl_frame_fill(&renderer, &band, 9);
        CHECK(fxl_frame_draw_with(&renderer, workspace, &band) == FXL_OK);
    }
}

static void *core(void *number)
{
    const unsigned first = number != NULL;
    pthread_barrier_wait(&barrier);
    draw(first ? &second : &renderer.workspace, two, first, 2);
    return NULL;
}

static void try_set(const into *to, unsigned has, size_t list)
{
    static fxl_surfaces surfaces;
    static fxl_light light;
    static fxl_lit_surfaces lit;
    static fxl_outlines outlines;
    static fxl_beam beam;
    const fxl_point from = {0, FXL_UNITS(8), FXL_UNITS(3)};
    const fxl_point window[] = {{-NEAR, 0, 65536}, {-NEAR, 0, FXL_UNITS(6)}, {NEAR, 0, FXL_UNITS(6)}, {NEAR, 0, 65536}};
    const fxl_light_settings lamp = {.ambient = FXL_Q2_30_ONE / 2, .ramp = ramp, .levels = 2};
    const fxl_outline_style style = {.line = 7};
    const fxl_pose eye = {{0, 0, 0}, 0, 0, 0};
    fxl_config config = fxl_config_for(W, H, to->target);
    config.depth = depth;
    config.depth_size = sizeof depth;
    config.palette = palette;
    CHECK(fxl_beam_from_point(&from, window, 4, &beam) == FXL_OK);
    const fxl_beam_set beams = {&beam, 1, brighter};
    CHECK(fxl_renderer_init(&renderer, &scene, &config, memory, list) == FXL_OK);
    if (has & SURFACES) CHECK(fxl_attach_surfaces(&renderer, &surfaces, &set, to->painter) == FXL_OK);
    if (has & LIGHT) CHECK(fxl_attach_light(&renderer, &light, &lamp) == FXL_OK && fxl_attach_lit(&renderer, &lit) == FXL_OK);
    if (has & BEAMS) CHECK(fxl_attach_beams(&renderer, &beams, beam_room, sizeof beam_room) == FXL_OK);
    if (has & OUTLINES) CHECK(fxl_attach_outlines(&renderer, &outlines, &style) == FXL_OK);
    CHECK(fxl_workspace_init(&second, &renderer, room, sizeof room) == FXL_OK);
    if (fxl_frame_begin(&renderer, &eye) == FXL_E_COMBINATION) return;
    pthread_t threads[2];
    draw(&renderer.workspace, one, 0, 1);
    CHECK(fxl_frame_begin(&renderer, &eye) == FXL_OK);
    for (int i = 0; i < 2; i++) CHECK(pthread_create(&threads[i], NULL, core, i ? &second : NULL) == 0);
    for (int i = 0; i < 2; i++) CHECK(pthread_join(threads[i], NULL) == 0);
    CHECK(memcmp(one, two, sizeof one) == 0);
    printf("drawn\n");
}

int main(void)
{
    for (int i = 0; i < 256; i++) { palette[i] = (uint16_t)(257 * i); brighter[i] = (uint8_t)(i + 40); ramp[i] = ramp[256 + i] = (uint8_t)i; }
    CHECK(fxl_scene_check(&scene, NULL) == FXL_OK);
    pthread_barrier_init(&barrier, NULL, 2);
    for (unsigned t = 0; t < sizeof all / sizeof *all; t++)
        for (unsigned has = 0; has < SETS; has++)
            for (int k = 0; k < 2; k++) try_set(&all[t], has, k ? sizeof memory : 256); /* a display list, or hardly one */
    return wrong;
}
"""
DRAWN = 2 * (2 * 12 + 4 * 8)    # outlines go with neither beams nor depth


@pytest.fixture(scope="module")
def objects(tmp_path_factory):
    """The library, with ThreadSanitizer."""
    folder = tmp_path_factory.mktemp("lib")
    sources = sorted(file for file in (CHECKOUT / "lib").glob("*/*.c") if file.parent.name != "study")
    subprocess.run(["gcc", "-std=c11", "-O0", "-g1", "-fsanitize=thread", "-I", CHECKOUT / "lib" / "include", "-I", CHECKOUT / "lib", "-c",
                    *sources], check=True, cwd=folder)
    return sorted(folder.glob("*.o"))


def test_two_threads_share_no_word_that_one_writes(objects, tmp_path):
    """surfaces 6.3, rgb565 3.6."""
    (tmp_path / "main.c").write_text(PROGRAM, encoding="utf-8")
    subprocess.run(["gcc", "-std=gnu11", "-g1", "-fsanitize=thread", "-pthread", "-I", CHECKOUT / "lib" / "include", tmp_path / "main.c",
                    *objects, "-o", tmp_path / "main"], check=True)
    done = subprocess.run([tmp_path / "main"], text=True, capture_output=True)
    if "unexpected memory mapping" in done.stderr:      # some kernels place a program where the sanitizer of GCC 12 has its own
        done = subprocess.run(["setarch", "-R", tmp_path / "main"], text=True, capture_output=True)
    assert (done.returncode, done.stdout) == (0, DRAWN * "drawn\n"), done.stdout[-2000:] + done.stderr[:4000]
