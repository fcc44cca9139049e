/* SPDX-License-Identifier: MIT */
/* Where the tables of a scene image lie, and how long they are (docs/formats.md, section 1). */
#include "fault.h"
#include "scene_header.h"

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

#define BOARD_TABLE_AT(name) (SURFACE_HEADER_SIZE + offsetof(billboard_header, name))

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
    {BOARD_TABLE_AT(billboards), sizeof(fxl_scene_billboard), FXL_SCENE_TABLE_MAX,
     "billboard table"},
    {BOARD_TABLE_AT(model_map), sizeof(uint16_t), FXL_SCENE_MODELS_MAX, "billboard map"},
    {BOARD_TABLE_AT(pixels), 1, FXL_SCENE_IMAGE_MAX, "sprite pixels"},
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
    BOARD_TABLE = 24,
    TABLE_COUNT = 27
};

FXL_STATIC_ASSERT(sizeof tables / sizeof tables[0] == TABLE_COUNT, "one for each");

/* An image with billboards may have no surfaces; then it has no face map. */
static bool has_surfaces(const header *head)
{
    const surface_header *of = surface_header_of(head);
    return of != NULL && (billboard_header_of(head) == NULL || of->face_map.count != 0);
}

/* Of the tables behind that of the path, a header needs those for which it is so long; light has a
 * ramp. */
static bool is_needed(const header *head, size_t number)
{
    if (number == RAMP_TABLE) {
        return light_header_of(head)->light.count != 0;
    }
    if (surface_header_of(head) != NULL) {
        return number <= PATH_TABLE || number >= BOARD_TABLE ||
               (has_surfaces(head) && number >= SURFACE_TABLE && number <= FACE_MAP_TABLE);
    }
    const size_t last = head->header_size == LIGHT_HEADER_SIZE     ? LIGHT_TABLE
                        : head->header_size == TURN_HEADER_SIZE    ? TURN_TABLE
                        : head->header_size == CLUSTER_HEADER_SIZE ? CLUSTER_TABLE
                                                                   : BEAM_TABLE;
    return number <= PATH_TABLE || number == last;
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

/* Each face has its entry in the face map, and each model its own in the billboard map. */
static fxl_status check_maps(const header *head, fxl_scene_fault *fault)
{
    const billboard_header *boards = billboard_header_of(head);
    /* bug: face-map-count */
    if (has_surfaces(head) && surface_header_of(head)->face_map.count != head->faces.count) {
        return fxl_fault_at(fault, "face map", 0, FXL_E_COUNT);
    }
    /* bug: billboard-map-count */
    if (boards != NULL && boards->model_map.count != head->models.count) {
        return fxl_fault_at(fault, "billboard map", 0, FXL_E_COUNT);
    }
    return FXL_OK;
}

fxl_status fxl_scene_tables_check(const header *head, fxl_scene_fault *fault)
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
    return status == FXL_OK ? check_maps(head, fault) : status;
}
