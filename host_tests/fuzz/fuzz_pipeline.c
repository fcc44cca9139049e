/* SPDX-License-Identifier: MIT */
/* The whole pipeline on arbitrary scenes, lenses and poses, and each stage on
 * arbitrary records of its contract. The first byte says which. */
#include "answers.h"
#include "parts.h"
#include "input.h"

enum {
    PIXELS = 4096,
    POSES = 3,
    PARTS = 28 /* the parts below; all others are scenes */
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Status and fault of a scene are written when, and only when, they should. */
static bool check_scene(fxl_scene *scene)
{
    fxl_scene_fault fault = {NULL, 0};
    scene->draw_list_needed = UINT32_MAX;
    fxl_status status = fxl_scene_check_all(scene, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    DEMAND((status == FXL_OK) == (scene->draw_list_needed != UINT32_MAX));
    DEMAND(fxl_scene_check_all(scene, NULL) == status);
    record_text(fault.what);
    record_number(fault.index);
    record_number(scene->draw_list_needed);
    bool bare = scene->bsp_nodes == NULL && scene->bsp_node_count == 0 &&
                scene->bsp_instance == 0 && scene->beam_count == 0 && scene->clusters == NULL &&
                scene->cluster_count == 0;
    DEMAND(bare ? fxl_scene_check(scene, NULL) == status : fxl_scene_check(scene, NULL) != FXL_OK);
    return status == FXL_OK;
}

static void draw_made(made_scene *made, fuzz_input *in)
{
    if (check_scene(&made->scene)) {
        fxl_lens lens = fuzz_lens(in, PIXELS);
        fxl_pose first = {.yaw = 0};
        for (uint32_t i = 0; i < POSES && (i == 0 || in->left > 0); i++) {
            fxl_pose pose = fuzz_pose(in);
            draw_choice choice = {fuzz_below(in, draw_clipper_count()), 0, lens.height};
            draw_scene(&made->scene, &lens, &pose, &choice, in);
            if (i == 0) {
                draw_attached(&made->scene, &lens, &pose);
                draw_lines(&made->scene, &lens, &pose, NULL, in);
                draw_setup(&made->scene, &lens, &pose);
                first = pose;
            }
        }
        draw_sequences(&made->scene, &lens, &first, in);
    }
    free_scene(made);
}

static void fuzz_scenes(fuzz_input *in)
{
    draw_made(make_scene(in), in);
}

static void fuzz_turned(fuzz_input *in)
{
    made_scene *made = make_scene(in);
    add_placements(made, in);
    draw_made(made, in);
}

/* One model placed so often that it passes the limit on placed vertices, or
 * not quite: the loader's time is bounded. */
static void fuzz_placed_limit(fuzz_input *in)
{
    static const fxl_point vertices[FXL_MODEL_VERTICES_MAX];
    static const uint16_t corners[3] = {0, 1, 2};
    static const fxl_face faces[] = {{{FXL_Q2_30_ONE, 0, 0}, 3, 1, {0, 1, 2}}};
    static const fxl_instance instances[FXL_SCENE_INSTANCES_MAX];
    fxl_model models[] = {{0, FXL_MODEL_VERTICES_MAX, 0, 1, FXL_MODEL_SORTED, 0, 0, 0, 0}};
    fxl_scene scene = SCENE_OF(vertices, corners, faces, models, instances);
    scene.instance_count = 1 + fuzz_below(in, fuzz_below(in, 2) ? 8 : FXL_SCENE_INSTANCES_MAX);
    scene.vertex_count = models[0].vertex_count = 3 + fuzz_below(in, FXL_MODEL_VERTICES_MAX - 2);
    uint64_t model_view = (uint64_t)scene.instance_count * scene.vertex_count;
    DEMAND(check_scene(&scene) == (model_view <= FXL_SCENE_PLACED_MAX));
    DEMAND(model_view > FXL_SCENE_PLACED_MAX || scene.draw_list_needed == scene.instance_count + 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static void (*const parts[])(fuzz_input *) = {
        fuzz_project,      fuzz_scan,    fuzz_clip_world, fuzz_clip_view,     fuzz_viewer,
        fuzz_lenses,       fuzz_misuse,  fuzz_sort,       fuzz_beams,         fuzz_split,
        fuzz_placed_limit, fuzz_volumes, fuzz_normalised, fuzz_first_program, fuzz_overlay,
        fuzz_geometry,     fuzz_world,   fuzz_turned,     fuzz_orientations,  fuzz_planes,
        fuzz_surfaces,
    };
    fuzz_input in = {data, size};
    uint32_t part = fuzz_below(&in, PARTS);
    if (part < sizeof parts / sizeof parts[0]) {
        parts[part](&in);
    } else {
        fuzz_scenes(&in);
    }
    return 0;
}
