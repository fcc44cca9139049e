/* SPDX-License-Identifier: MIT */
/* The loader on arbitrary bytes; of a scene that it opens, everything is used. And mutations of scene
 * images: nearly all get a size and a checksum that match, so that what follows them in the loader is
 * reached. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "answers.h"
#include "parts.h"
#include "fixel/crc.h"

enum {
    WORK = 1 << 18,
    STEPS = 64,
    MOVED = 64 /* instances of a scene in which something moves */
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static uint32_t sum_bytes(const void *table, size_t size)
{
    const uint8_t *bytes = table;
    uint32_t sum = 0;
    for (size_t i = 0; i < size; i++) {
        sum += bytes[i];
    }
    return sum;
}

/* Reads every byte of every table: all of it must lie in the image. */
static void read_tables(const fxl_scene_image *opened)
{
    const fxl_scene *scene = &opened->scene;
    volatile uint32_t sum = sum_bytes(opened->palette, 3u * 256u);
    sum += sum_bytes(scene->vertices, scene->vertex_count * sizeof *scene->vertices);
    sum += sum_bytes(scene->indices, scene->index_count * sizeof *scene->indices);
    sum += sum_bytes(scene->faces, scene->face_count * sizeof *scene->faces);
    sum += sum_bytes(scene->models, scene->model_count * sizeof *scene->models);
    sum += sum_bytes(scene->instances, scene->instance_count * sizeof *scene->instances);
    sum += sum_bytes(scene->beams, scene->beam_count * sizeof *scene->beams);
    sum += sum_bytes(scene->lit, scene->beam_count > 0 ? 256 : 0);
    sum += sum_bytes(scene->face_bounds, scene->face_bounds_count * sizeof *scene->face_bounds);
    sum += sum_bytes(scene->bsp_nodes, scene->bsp_node_count * sizeof *scene->bsp_nodes);
    sum += sum_bytes(scene->clusters, scene->cluster_count * sizeof *scene->clusters);
    if (scene->placements != NULL) {
        sum += sum_bytes(scene->placements,
                         (scene->instance_count - scene->first_turned) * sizeof *scene->placements);
    }
    sum += sum_bytes(opened->motion.motions,
                     opened->motion.motion_count * sizeof *opened->motion.motions);
    sum += sum_bytes(opened->motion.keys, opened->motion.key_count * sizeof *opened->motion.keys);
    sum +=
        sum_bytes(opened->light.points, opened->light.point_count * sizeof *opened->light.points);
    sum += sum_bytes(opened->light.ramp, 256u * opened->light.levels);
    if (opened->light.base != NULL) {
        fxl_light_settings settings;
        sum += sum_bytes(opened->light.base, sizeof *opened->light.base);
        fxl_light_settings_of(&opened->light, &settings);
        DEMAND(fxl_light_check(&settings, NULL) == FXL_OK);
    }
    open_surfaces(opened, &opened->start.pose);
    open_billboards(opened, &opened->start.pose);
    open_horizon(opened, &opened->start.pose);
    DEMAND((opened->poses == NULL) != (opened->segments == NULL));
    if (opened->poses != NULL) {
        sum += sum_bytes(opened->poses, opened->path_count * sizeof *opened->poses);
    } else {
        sum += sum_bytes(opened->segments, opened->path_count * sizeof *opened->segments);
    }
    record_number(sum);
}

/* Draws some rows of a frame, as many as the work allows. */
static void draw_frame(const fxl_scene_image *opened, const fxl_pose *pose, uint32_t frame,
                       fuzz_input *in)
{
    const fxl_lens *lens = &opened->lens;
    uint64_t cost = (draw_model_view(&opened->scene) + 4) * lens->width;
    uint32_t rows = (uint32_t)(WORK / cost);
    if (rows == 0) {
        return;
    }
    rows = rows > lens->height ? lens->height : rows;
    uint32_t first = frame % 2 == 0 ? 0 : frame * 7 % (lens->height - rows + 1u);
    draw_choice choice = {fuzz_below(in, draw_clipper_count()), (uint16_t)first, (uint16_t)rows};
    draw_scene(&opened->scene, lens, pose, &choice, in);
}

static void demand_placements_in_range(const fxl_scene *scene)
{
    for (uint32_t j = scene->first_turned; j < scene->instance_count; j++) {
        DEMAND(fxl_placement_check(&scene->placements[j - scene->first_turned],
                                   &scene->instances[j].centre,
                                   scene->models[scene->instances[j].model].radius) == FXL_OK);
    }
}

static void record_moved(const fxl_scene *scene)
{
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        record_bytes(&scene->instances[i].centre, sizeof scene->instances[i].centre);
    }
    for (uint32_t i = 0; i + scene->first_turned < scene->instance_count; i++) {
        record_bytes(&scene->placements[i], sizeof scene->placements[i]);
    }
}

/* The frames that the loader passed must all be playable: the player asserts it. */
static void play(fxl_scene_image *opened, fuzz_input *in, fxl_motion_player *player)
{
    static fxl_instance instances[MOVED];
    static fxl_placement placements[MOVED];
    const fxl_motion_memory memory = {instances, MOVED, placements, MOVED};
    fxl_scene *scene = &opened->scene;
    player->set.motion_count = 0;
    if (opened->motion.motion_count == 0) {
        return;
    }
    fxl_status status = fxl_motion_begin(player, &opened->motion, scene, &memory);
    DEMAND(status == (scene->instance_count <= MOVED ? FXL_OK : FXL_E_CAPACITY));
    for (uint32_t i = 0; status == FXL_OK && i < 8; i++) {
        fxl_motion_play(player, i < 4 ? i : (uint32_t)fuzz_bits(in, 4));
        record_moved(scene);
        demand_placements_in_range(scene);
    }
}

/* Motions of which one number is another, checked by hand: they are refused, and the check says
 * which, or all that they do is in range. */
static void play_others(const fxl_scene_image *opened, fuzz_input in)
{
    static fxl_instance instances[MOVED];
    static fxl_placement placements[MOVED];
    static fxl_motion motions[MOVED];
    const fxl_motion_memory memory = {instances, MOVED, placements, MOVED};
    const uint32_t count = opened->motion.motion_count;
    fxl_scene scene = opened->scene;
    fxl_motion_set set = opened->motion;
    fxl_scene_fault fault = {NULL, 0};
    fxl_motion_player player;
    DEMAND(fxl_motion_check(NULL, &scene, &fault) == FXL_E_ARGUMENT && fault.what != NULL);
    DEMAND(fxl_motion_check(&set, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_motion_check(&set, &scene, NULL) == FXL_OK);
    if (count == 0 || scene.instance_count > MOVED) {
        return;
    }
    memcpy(motions, set.motions, count * sizeof motions[0]);
    uint8_t *bytes = (uint8_t *)&motions[fuzz_below(&in, count)];
    const int32_t number = fuzz_any(&in);
    memcpy(bytes + 4u * fuzz_below(&in, sizeof motions[0] / 4u), &number, 4);
    set.motions = NULL;
    DEMAND(fxl_motion_begin(&player, &set, &scene, &memory) == FXL_E_ARGUMENT);
    set.motions = motions;
    fault.what = NULL;
    const fxl_status status = fxl_motion_check(&set, &scene, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    record_text(fault.what);
    if (status == FXL_OK) {
        DEMAND(fxl_motion_begin(&player, &set, &scene, &memory) == FXL_OK);
        for (uint32_t i = 0; i < 4; i++) {
            fxl_motion_play(&player, i < 2 ? i : (uint32_t)fuzz_bits(&in, 4));
            record_moved(&scene);
            demand_placements_in_range(&scene);
        }
    }
}

/* Walks the path as firmware does: poses as they stand, strides step by step. */
static void walk(fxl_scene_image *opened, fuzz_input *in)
{
    fxl_motion_player player;
    play_others(opened, *in);
    play(opened, in, &player);
    fxl_player viewer = opened->start;
    uint32_t frames = 0;
    for (uint32_t i = 0; i < opened->path_count && frames < STEPS; i++) {
        if (opened->poses != NULL) {
            viewer.pose = opened->poses[i];
            fxl_motion_play(&player, frames);
            if (frames < 3) {
                draw_frame(opened, &viewer.pose, frames, in);
            }
            frames += 1;
            continue;
        }
        for (uint32_t j = 0; j < opened->segments[i].frames && frames < STEPS; j++) {
            DEMAND(fxl_player_step(&viewer, opened->segments[i].keys, &opened->motion_limits,
                                   NULL) == FXL_OK);
            record_bytes(&viewer, sizeof viewer);
            if (frames < 3) {
                draw_frame(opened, &viewer.pose, frames, in);
            }
            frames += 1;
        }
    }
    DEMAND(frames == STEPS || frames == opened->frame_count);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fxl_scene_image opened, untouched;
    fxl_scene_fault fault = {NULL, 0};
    memset(&untouched, 0x5A, sizeof untouched);
    memcpy(&opened, &untouched, sizeof opened);
    /* A block of its own size: what lies behind the image belongs to nobody. */
    uint8_t *exact = malloc(size == 0 ? 1 : size);
    DEMAND(exact != NULL);
    if (size > 0) {
        memcpy(exact, data, size);
    }
    fxl_status status = fxl_scene_open(exact, size, &opened, &fault);
    DEMAND((status == FXL_OK) == (fault.what == NULL));
    record_number(status);
    record_text(fault.what);
    record_number(fault.index);
    DEMAND(fxl_scene_open(exact, size, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_scene_open(exact + 1, size, &untouched, NULL) == FXL_E_ALIGNMENT);
    if (status == FXL_OK) {
        fuzz_input in = {data + size / 2, size / 2};
        read_tables(&opened);
        walk(&opened, &in);
    } else {
        DEMAND(memcmp(&opened, &untouched, sizeof opened) == 0);
    }
    free(exact);
    return 0;
}

/* --- mutations ---------------------------------------------------------------- */

enum {
    HEADER_SIZE = 92,
    AT_SECTION_COUNT = 6,
    AT_SIZE = 8,
    AT_CRC = 12,
    ENTRY = 12, /* of the table of sections: kind, needed, offset, count */
    PIECE = 16  /* bytes of a section that change at once */
};

/* libFuzzer has it. A replay has not, and mutates nothing. */
__attribute__((weak)) size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *a, size_t a_size, const uint8_t *b, size_t b_size,
                                 uint8_t *out, size_t max_size, unsigned seed);

static uint32_t get32(const uint8_t *at)
{
    uint32_t value;
    memcpy(&value, at, sizeof value);
    return value;
}

static void put32(uint8_t *at, uint32_t value)
{
    memcpy(at, &value, sizeof value);
}

/* One in 64 stays as it is, one in eight of the others keeps its stated size. */
static size_t mend(uint8_t *data, size_t size, unsigned seed)
{
    if (size < HEADER_SIZE || (seed >> 8) % 64 == 0) {
        return size;
    }
    if ((seed >> 16) % 8 != 0) {
        put32(data + AT_SIZE, (uint32_t)size & ~3u);
    }
    uint32_t stated = get32(data + AT_SIZE);
    if (stated >= HEADER_SIZE && stated <= size) {
        put32(data + AT_CRC, fxl_crc(FXL_CRC_START, data + 16, stated - 16));
    }
    return size;
}

/* The entry of a section in the table; null if the table is not there. */
static uint8_t *entry_of(uint8_t *data, size_t size, unsigned seed)
{
    const unsigned count = data[AT_SECTION_COUNT];
    const size_t at = HEADER_SIZE + (size_t)ENTRY * (count == 0 ? 0 : seed % count);
    return count == 0 || at + ENTRY > size ? NULL : data + at;
}

/* A few bytes, somewhere in a section. */
static void mutate_section(uint8_t *data, size_t size, unsigned seed)
{
    const uint8_t *entry = entry_of(data, size, seed);
    if (entry == NULL) {
        return;
    }
    const size_t offset = get32(entry + 4);
    if (offset >= size) {
        return;
    }
    const size_t at = offset + seed / 64 % (size - offset);
    const size_t piece = size - at < PIECE ? size - at : PIECE;
    LLVMFuzzerMutate(data + at, piece, piece);
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned seed)
{
    unsigned kind = seed % 8;
    unsigned where = seed >> 3;
    if (size < HEADER_SIZE || kind < 2) {
        size = LLVMFuzzerMutate(data, size, max_size);
    } else if (kind < 4) {
        size_t field = 4 * (where % (HEADER_SIZE / 4));
        LLVMFuzzerMutate(data + field, 4, 4);
    } else if (kind < 5) {
        uint8_t *entry = entry_of(data, size, where);
        if (entry != NULL) {
            LLVMFuzzerMutate(entry, ENTRY, ENTRY);
        }
    } else {
        mutate_section(data, size, where);
    }
    return mend(data, size, seed * 2654435761u);
}

/* The head of one, the rest of the other. */
size_t LLVMFuzzerCustomCrossOver(const uint8_t *a, size_t a_size, const uint8_t *b, size_t b_size,
                                 uint8_t *out, size_t max_size, unsigned seed)
{
    size_t cut = seed % (a_size + 1);
    size_t size = b_size > cut ? b_size : cut;
    size = size > max_size ? max_size : size;
    cut = cut > size ? size : cut;
    memcpy(out, a, cut);
    if (size > cut) {
        memcpy(out + cut, b + cut, size - cut);
    }
    return mend(out, size, seed * 2654435761u);
}
