/* SPDX-License-Identifier: MIT */
/* Opens a scene image (docs/formats.md, section 1) in place. */
#include "../math/arith.h"
#include "../math/memory.h"
#include "crc.h"
#include "fault.h"
#include "fixel/scene.h"
#include "fixel/stage/lens.h"
#include "motion_limits.h"
#include "scene_header.h"

enum {
    PATH_POSES = 0,
    PATH_SEGMENTS = 1
};

/* Null where the header has no such part. A part before another may be 0. */
static const beam_header *beam_header_of(const header *head)
{
    return head->header_size > sizeof *head ? (const beam_header *)(const void *)(head + 1) : NULL;
}

static const cluster_header *cluster_header_of(const header *head)
{
    return head->header_size > BEAM_HEADER_SIZE
               ? (const cluster_header *)(const void *)(beam_header_of(head) + 1)
               : NULL;
}

static const turn_header *turn_header_of(const header *head)
{
    return head->header_size > CLUSTER_HEADER_SIZE
               ? (const turn_header *)(const void *)(cluster_header_of(head) + 1)
               : NULL;
}

static const light_header *light_header_of(const header *head)
{
    return head->header_size > TURN_HEADER_SIZE
               ? (const light_header *)(const void *)(turn_header_of(head) + 1)
               : NULL;
}

static const surface_header *surface_header_of(const header *head)
{
    return head->header_size > LIGHT_HEADER_SIZE
               ? (const surface_header *)(const void *)(light_header_of(head) + 1)
               : NULL;
}

static bool header_size_is_known(const header *head)
{
    if (head->version == VERSION_LIGHT) {
        return head->header_size == LIGHT_HEADER_SIZE || head->header_size == SURFACE_HEADER_SIZE;
    }
    if (head->version == VERSION_TURNS) {
        return head->header_size == TURN_HEADER_SIZE;
    }
    if (head->version == VERSION_CLUSTERS) {
        return head->header_size == CLUSTER_HEADER_SIZE;
    }
    return head->header_size == sizeof *head ||
           (head->version == VERSION_MORE && head->header_size == BEAM_HEADER_SIZE);
}

/* *what is "image", and becomes "header" if only the header's own size is wrong. */
static fxl_status check_envelope(const header *head, size_t size, const char **what)
{
    if (size < sizeof *head) {
        return FXL_E_SIZE;
    }
    if (head->magic != MAGIC) {
        return FXL_E_MAGIC;
    }
    if (head->version < VERSION || head->version > VERSION_LIGHT) {
        return FXL_E_VERSION;
    }
    if (!header_size_is_known(head)) {
        *what = "header";
        return FXL_E_SIZE;
    }
    if (head->image_size < head->header_size || head->image_size > FXL_SCENE_IMAGE_MAX ||
        head->image_size % 4 != 0 || head->image_size > size) {
        return FXL_E_SIZE;
    }
    const uint8_t *bytes = (const uint8_t *)head;
    if (fxl_crc32(bytes + 16, head->image_size - 16) != head->crc) {
        return FXL_E_CRC;
    }
    if (head->has_centre > 1 || head->path_kind > PATH_SEGMENTS) {
        return FXL_E_RESERVED;
    }
    if (head->image_size - head->header_size < head->has_centre * sizeof(lens_centre)) {
        *what = "header"; /* bug: centre-behind */
        return FXL_E_SIZE;
    }
    if (beam_header_of(head) != NULL && beam_header_of(head)->reserved != 0) {
        return FXL_E_RESERVED;
    }
    bool has_bsp = (head->bsp_nodes.offset | head->bsp_nodes.count | head->bsp_instance) != 0;
    if (has_bsp && head->version == VERSION) {
        return FXL_E_RESERVED;
    }
    const surface_header *surfaces = surface_header_of(head);
    if (surfaces != NULL &&
        (surfaces->reserved != 0 || (surfaces->blend.count == 0 && surfaces->blend_first != 0))) {
        return FXL_E_RESERVED;
    }
    /* An image has VERSION_MORE only if it has a tree or beams, so a scene has one image. */
    return head->version == VERSION || has_bsp || beam_header_of(head) != NULL ? FXL_OK
                                                                               : FXL_E_VERSION;
}

/* An image says where the centre is only if that is not the middle, so a scene has one image. */
static fxl_status check_lens(const header *head, fxl_lens *lens)
{
    fxl_status status = fxl_lens_from_fov(head->width, head->height, head->fov, head->near_z,
                                          head->far_z, head->inset, lens);
    if (status != FXL_OK || head->has_centre == 0) {
        return status;
    }
    const lens_centre *centre =
        (const lens_centre *)(const void *)((const uint8_t *)head + head->header_size);
    status = fxl_lens_set_centre(lens, centre->x, centre->y);
    return status == FXL_OK && lens->off_centre == NULL ? FXL_E_RESERVED : status;
}

/* Lens, start pose and motion limits. */
static fxl_status check_settings(const header *head, fxl_scene_image *opened,
                                 fxl_scene_fault *fault)
{
    fxl_status status = check_lens(head, &opened->lens);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, "lens", 0, status);
    }
    opened->background = head->background;
    opened->start.pose = head->start;
    opened->start.speed = 0;
    opened->start.clamped = 0;
    opened->motion_limits.acceleration = head->acceleration;
    opened->motion_limits.friction = head->friction;
    opened->motion_limits.speed_max = head->speed_max;
    opened->motion_limits.turn = head->turn;
    if (!fxl_point_in_range(&head->start.position)) {
        return fxl_fault_at(fault, "start pose", 0, FXL_E_RANGE);
    }
    if (!fxl_motion_limits_in_range(&opened->motion_limits)) {
        return fxl_fault_at(fault, "motion limits", 0, FXL_E_RANGE);
    }
    return FXL_OK;
}

/* Checks that a table is aligned, behind the header and within the image. A count times the
 * size of an entry, at most 256 bytes, is below 2^37. */
static fxl_status check_table(const header *head, const table *entry, uint32_t entry_size,
                              uint32_t count_max, const char *what, fxl_scene_fault *fault)
{
    if (entry->count == 0 || entry->count > count_max) {
        return fxl_fault_at(fault, what, 0, FXL_E_COUNT);
    }
    if (entry->offset % 4 != 0) {
        return fxl_fault_at(fault, what, 0, FXL_E_ALIGNMENT);
    }
    uint64_t bytes = (uint64_t)entry->count * entry_size;
    if (entry->offset < head->header_size || entry->offset > head->image_size ||
        bytes > head->image_size - entry->offset) {
        return fxl_fault_at(fault, what, 0, FXL_E_OFFSET);
    }
    return FXL_OK;
}

#define SURFACE_TABLE_AT(name) (LIGHT_HEADER_SIZE + offsetof(surface_header, name))

/* The tables whose offset and count the header states, in their order there. An entry size of 0 is
 * that of the path's kind. */
static const struct {
    uint16_t at, entry_size; /* at: where in the header */
    uint32_t count_max;
    const char *what;
} tables[] = {
    {offsetof(header, palette), 3, PALETTE_ENTRIES, "palette table"},
    {offsetof(header, vertices), sizeof(fxl_point), FXL_SCENE_VERTICES_MAX, "vertex table"},
    {offsetof(header, indices), sizeof(uint16_t), FXL_SCENE_INDICES_MAX, "index table"},
    {offsetof(header, faces), sizeof(fxl_face), FXL_SCENE_FACES_MAX, "face table"},
    {offsetof(header, models), sizeof(fxl_model), FXL_SCENE_MODELS_MAX, "model table"},
    {offsetof(header, instances), sizeof(fxl_instance), FXL_SCENE_INSTANCES_MAX, "instance table"},
    {offsetof(header, path), 0, FXL_SCENE_PATH_MAX, "path table"},
    {offsetof(header, face_bounds), sizeof(fxl_face_bounds), FXL_SCENE_FACES_MAX,
     "face bounds table"},
    {offsetof(header, bsp_nodes), sizeof(fxl_bsp_node), FXL_BSP_NODES_MAX, "BSP node table"},
    {sizeof(header) + offsetof(beam_header, beams), sizeof(fxl_beam), FXL_BEAMS_MAX, "beam table"},
    {BEAM_HEADER_SIZE, sizeof(fxl_cluster), FXL_SCENE_CLUSTERS_MAX, "cluster table"},
    {CLUSTER_HEADER_SIZE, sizeof(fxl_turn), FXL_SCENE_INSTANCES_MAX, "turn table"},
    {CLUSTER_HEADER_SIZE + offsetof(turn_header, motions), sizeof(fxl_motion),
     FXL_SCENE_INSTANCES_MAX, "motion table"},
    {CLUSTER_HEADER_SIZE + offsetof(turn_header, keys), sizeof(fxl_motion_key), FXL_MOTION_KEYS_MAX,
     "motion key table"},
    {TURN_HEADER_SIZE, sizeof(fxl_light_base), 1, "light table"},
    {TURN_HEADER_SIZE + offsetof(light_header, points), sizeof(fxl_point_light),
     FXL_LIGHT_POINTS_MAX, "point light table"},
    {TURN_HEADER_SIZE + offsetof(light_header, ramp), PALETTE_ENTRIES, FXL_LIGHT_LEVELS_MAX,
     "ramp"},
    {SURFACE_TABLE_AT(textures), sizeof(fxl_scene_texture), FXL_SCENE_TABLE_MAX, "texture table"},
    {SURFACE_TABLE_AT(texels), 1, FXL_SCENE_IMAGE_MAX, "texel table"},
    {SURFACE_TABLE_AT(surfaces), SURFACE_SIZE, FXL_SCENE_TABLE_MAX, "surface table"},
    {SURFACE_TABLE_AT(mapped_faces), MAPPED_FACE_SIZE, FXL_SCENE_TABLE_MAX, "mapped face table"},
    {SURFACE_TABLE_AT(face_map), sizeof(uint16_t), FXL_SCENE_FACES_MAX, "face map"},
    {SURFACE_TABLE_AT(corner_normals), sizeof(fxl_direction), FXL_SCENE_TABLE_MAX,
     "corner normal table"},
    {SURFACE_TABLE_AT(blend), PALETTE_ENTRIES, PALETTE_ENTRIES, "blend table"},
};

enum {
    PATH_TABLE = 6,
    BEAM_TABLE = 9,
    CLUSTER_TABLE = 10,
    TURN_TABLE = 11,
    LIGHT_TABLE = 14,
    RAMP_TABLE = 16,
    SURFACE_TABLE = 19,
    MAPPED_FACE_TABLE = 20,
    FACE_MAP_TABLE = 21,
    TABLE_COUNT = 24
};

FXL_STATIC_ASSERT(sizeof tables / sizeof tables[0] == TABLE_COUNT, "one for each");

/* Of the tables behind that of the path, a header needs those for which it is so long; light has a
 * ramp. */
static bool is_needed(const header *head, size_t number)
{
    if (number == RAMP_TABLE) {
        return light_header_of(head)->light.count != 0;
    }
    if (head->header_size == SURFACE_HEADER_SIZE) {
        return number <= PATH_TABLE || (number >= SURFACE_TABLE && number <= FACE_MAP_TABLE);
    }
    const size_t last = head->header_size == LIGHT_HEADER_SIZE     ? LIGHT_TABLE
                        : head->header_size == TURN_HEADER_SIZE    ? TURN_TABLE
                        : head->header_size == CLUSTER_HEADER_SIZE ? CLUSTER_TABLE
                                                                   : BEAM_TABLE;
    return number <= PATH_TABLE || number == last || number == RAMP_TABLE;
}

/* The lit colours are there if beams are. */
static fxl_status check_lit(const header *head, fxl_scene_fault *fault)
{
    const table lit = {beam_header_of(head)->lit, PALETTE_ENTRIES};
    if (beam_header_of(head)->beams.count == 0) {
        return lit.offset == 0 ? FXL_OK : fxl_fault_at(fault, "lit table", 0, FXL_E_COUNT);
    }
    return check_table(head, &lit, sizeof(uint8_t), PALETTE_ENTRIES, "lit table", fault);
}

/* Turns are those of the last instances, and motions those of the last turns. */
static fxl_status check_turn_counts(const header *head, fxl_scene_fault *fault)
{
    const turn_header *more = turn_header_of(head);
    if (more == NULL) {
        return FXL_OK;
    }
    if (more->turns.count > head->instances.count) {
        return fxl_fault_at(fault, "turn table", 0, FXL_E_COUNT);
    }
    return more->motions.count <= more->turns.count
               ? FXL_OK
               : fxl_fault_at(fault, "motion table", 0, FXL_E_COUNT);
}

/* Point lights and a ramp are there only if light is. */
static fxl_status check_light_counts(const header *head, fxl_scene_fault *fault)
{
    const light_header *more = light_header_of(head);
    return more == NULL || more->light.count != 0 || (more->points.count | more->ramp.count) == 0
               ? FXL_OK
               : fxl_fault_at(fault, "light table", 0, FXL_E_COUNT);
}

/* Each face has its entry in the face map. */
static fxl_status check_face_map(const header *head, fxl_scene_fault *fault)
{
    const surface_header *more = surface_header_of(head);
    /* bug: face-map-count */
    return more == NULL || more->face_map.count == head->faces.count
               ? FXL_OK
               : fxl_fault_at(fault, "face map", 0, FXL_E_COUNT);
}

static fxl_status check_tables(const header *head, fxl_scene_fault *fault)
{
    const uint32_t path_entry =
        head->path_kind == PATH_POSES ? sizeof(fxl_pose) : sizeof(fxl_path_segment);
    if (head->palette.count != PALETTE_ENTRIES) {
        return fxl_fault_at(fault, "palette table", 0, FXL_E_COUNT);
    }
    for (size_t i = 0; i < TABLE_COUNT && tables[i].at < head->header_size; i++) {
        const table *entry = (const table *)(const void *)((const uint8_t *)head + tables[i].at);
        const uint32_t entry_size = i == PATH_TABLE ? path_entry : tables[i].entry_size;
        fxl_status status = FXL_OK;
        if (is_needed(head, i) || entry->count != 0) {
            status =
                check_table(head, entry, entry_size, tables[i].count_max, tables[i].what, fault);
        } else if (entry->offset != 0) {
            status = fxl_fault_at(fault, tables[i].what, 0, FXL_E_COUNT);
        }
        if (status == FXL_OK && i == BEAM_TABLE) {
            status = check_lit(head, fault);
        }
        if (status != FXL_OK) {
            return status;
        }
    }
    fxl_status status = check_turn_counts(head, fault);
    if (status == FXL_OK) {
        status = check_light_counts(head, fault);
    }
    return status == FXL_OK ? check_face_map(head, fault) : status;
}

static const void *at(const header *head, uint32_t offset)
{
    return (const uint8_t *)head + offset;
}

static void point_to_turns(const header *head, fxl_scene_image *opened)
{
    const turn_header *more = turn_header_of(head);
    if (more == NULL) {
        return;
    }
    if (more->turns.count > 0) {
        opened->scene.turns = (const fxl_turn *)at(head, more->turns.offset);
        opened->scene.first_turned = head->instances.count - more->turns.count;
    }
    if (more->motions.count > 0) {
        opened->motion.motions = (const fxl_motion *)at(head, more->motions.offset);
        opened->motion.motion_count = more->motions.count;
    }
    if (more->keys.count > 0) {
        opened->motion.keys = (const fxl_motion_key *)at(head, more->keys.offset);
        opened->motion.key_count = more->keys.count;
    }
}

static void point_to_light(const header *head, fxl_scene_image *opened)
{
    const light_header *more = light_header_of(head);
    if (more == NULL || more->light.count == 0) {
        return;
    }
    opened->light.base = (const fxl_light_base *)at(head, more->light.offset);
    if (more->points.count > 0) {
        opened->light.points = (const fxl_point_light *)at(head, more->points.offset);
        opened->light.point_count = more->points.count;
    }
    opened->light.ramp = (const uint8_t *)at(head, more->ramp.offset);
    opened->light.levels = more->ramp.count; /* bug: light-ramp-of-image */
}

static void point_to_surfaces(const header *head, fxl_scene_image *opened)
{
    const surface_header *more = surface_header_of(head);
    fxl_scene_surfaces *to = &opened->surfaces;
    if (more == NULL) {
        return;
    }
    to->textures = (const fxl_scene_texture *)at(head, more->textures.offset);
    to->texels = (const uint8_t *)at(head, more->texels.offset);
    to->surfaces = (const fxl_surface *)at(head, more->surfaces.offset);
    to->faces = (const fxl_mapped_face *)at(head, more->mapped_faces.offset);
    to->face_map = (const uint16_t *)at(head, more->face_map.offset);
    to->normals = (const fxl_direction *)at(head, more->corner_normals.offset);
    to->texture_count = more->textures.count;
    to->texel_bytes = more->texels.count;
    to->surface_count = more->surfaces.count;
    to->face_count = more->mapped_faces.count;
    to->normal_count = more->corner_normals.count;
    if (more->blend.count > 0) {
        to->blend = (const uint8_t *)at(head, more->blend.offset);
        to->blend_count = more->blend.count;
        to->blend_first = more->blend_first;
    }
}

static void point_to_tables(const header *head, fxl_scene_image *opened)
{
    opened->palette = (const uint8_t *)at(head, head->palette.offset);
    opened->scene.vertices = (const fxl_point *)at(head, head->vertices.offset);
    opened->scene.indices = (const uint16_t *)at(head, head->indices.offset);
    opened->scene.faces = (const fxl_face *)at(head, head->faces.offset);
    opened->scene.models = (const fxl_model *)at(head, head->models.offset);
    opened->scene.instances = (const fxl_instance *)at(head, head->instances.offset);
    opened->scene.face_bounds = head->face_bounds.count > 0
                                    ? (const fxl_face_bounds *)at(head, head->face_bounds.offset)
                                    : NULL;
    opened->scene.face_bounds_count = head->face_bounds.count;
    opened->scene.bsp_nodes =
        head->bsp_nodes.count > 0 ? (const fxl_bsp_node *)at(head, head->bsp_nodes.offset) : NULL;
    opened->scene.bsp_node_count = head->bsp_nodes.count;
    opened->scene.bsp_instance = head->bsp_instance;
    if (cluster_header_of(head) != NULL && cluster_header_of(head)->clusters.count > 0) {
        const table *clusters = &cluster_header_of(head)->clusters;
        opened->scene.clusters = (const fxl_cluster *)at(head, clusters->offset);
        opened->scene.cluster_count = clusters->count;
    }
    if (beam_header_of(head) != NULL && beam_header_of(head)->beams.count > 0) {
        opened->scene.beams = (const fxl_beam *)at(head, beam_header_of(head)->beams.offset);
        opened->scene.beam_count = beam_header_of(head)->beams.count;
        opened->scene.lit = (const uint8_t *)at(head, beam_header_of(head)->lit);
    }
    point_to_turns(head, opened);
    point_to_light(head, opened);
    point_to_surfaces(head, opened);
    opened->scene.vertex_count = head->vertices.count;
    opened->scene.index_count = head->indices.count;
    opened->scene.face_count = head->faces.count;
    opened->scene.model_count = head->models.count;
    opened->scene.instance_count = head->instances.count;
    opened->poses =
        head->path_kind == PATH_POSES ? (const fxl_pose *)at(head, head->path.offset) : NULL;
    opened->segments = head->path_kind == PATH_SEGMENTS
                           ? (const fxl_path_segment *)at(head, head->path.offset)
                           : NULL;
    opened->path_count = head->path.count;
    opened->frame_count = head->frame_count;
}

static fxl_status check_light(const fxl_scene_light *light, fxl_scene_fault *fault)
{
    fxl_light_settings settings;
    if (light->base == NULL) {
        return FXL_OK;
    }
    fxl_light_settings_of(light, &settings);
    return fxl_light_check(&settings, fault);
}

static fxl_status check_path(const fxl_scene_image *opened, fxl_scene_fault *fault)
{
    uint64_t frames = 0; /* at most 10^6 entries of 16 bits */
    for (uint32_t i = 0; i < opened->path_count; i++) {
        if (opened->poses != NULL) {
            if (!fxl_point_in_range(&opened->poses[i].position)) {
                return fxl_fault_at(fault, "pose", i, FXL_E_RANGE);
            }
            frames += 1;
            continue;
        }
        const fxl_path_segment *segment = &opened->segments[i];
        if ((segment->keys & ~(uint32_t)FXL_KEY_ALL) != 0) {
            return fxl_fault_at(fault, "path segment", i, FXL_E_RESERVED);
        }
        if (segment->frames == 0) {
            return fxl_fault_at(fault, "path segment", i, FXL_E_COUNT);
        }
        frames += segment->frames;
    }
    if (frames != opened->frame_count || frames > FXL_SCENE_PATH_MAX) {
        return fxl_fault_at(fault, "path table", 0, FXL_E_COUNT);
    }
    return FXL_OK;
}

fxl_status fxl_scene_open(const void *image, size_t size, fxl_scene_image *opened,
                          fxl_scene_fault *fault)
{
    if (image == NULL || opened == NULL) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ARGUMENT);
    }
    if ((uintptr_t)image % 4 != 0) {
        return fxl_fault_at(fault, "image", 0, FXL_E_ALIGNMENT);
    }
    const header *head = (const header *)image;
    const char *what = "image";
    fxl_status status = check_envelope(head, size, &what);
    if (status != FXL_OK) {
        return fxl_fault_at(fault, what, 0, status);
    }
    fxl_scene_image found;
    memset(&found, 0, sizeof found);
    status = check_settings(head, &found, fault);
    if (status != FXL_OK) {
        return status;
    }
    status = check_tables(head, fault);
    if (status != FXL_OK) {
        return status;
    }
    point_to_tables(head, &found);
    status = fxl_scene_check_all(&found.scene, fault);
    if (status != FXL_OK) {
        return status;
    }
    if (turn_header_of(head) != NULL) {
        status = fxl_motion_check(&found.motion, &found.scene, fault);
    }
    if (status == FXL_OK) {
        status = check_light(&found.light, fault);
    }
    if (status == FXL_OK) {
        status = check_path(&found, fault);
    }
    if (status == FXL_OK) {
        *opened = found;
    }
    return status;
}
