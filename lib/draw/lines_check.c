/* SPDX-License-Identifier: MIT */
/* The checks on the lines of a scene. */
#include "fixel/lines.h"

#include "../math/memory.h"
#include "../scene/scene_check.h"

/* lines 1.2 */
static FXL_COLD fxl_status check_line(const fxl_line *line, const fxl_model *model)
{
    if (line->reserved != 0) {
        return FXL_E_RESERVED;
    }
    if (line->width < 1 || line->width > FXL_LINE_WIDTH_MAX) {
        return FXL_E_RANGE;
    }
    return line->from < model->vertex_count && line->to < model->vertex_count &&
                   line->faces[0] <= model->face_count && line->faces[1] <= model->face_count
               ? FXL_OK
               : FXL_E_INDEX;
}

/* lines 1.2, formats 1.14 */
FXL_COLD fxl_status fxl_lines_check(const fxl_line_set *set, const fxl_scene *scene,
                                    fxl_scene_fault *fault)
{
    if (set == NULL || scene == NULL || set->line_map == NULL ||
        (set->count > 0 && set->lines == NULL)) {
        return fxl_fault_at(fault, "line table", 0, FXL_E_ARGUMENT);
    }
    if (!fxl_is_aligned(set->line_map, sizeof *set->line_map) ||
        !fxl_is_aligned(set->lines, sizeof(uint16_t))) {
        return fxl_fault_at(fault, "line table", 0, FXL_E_ALIGNMENT);
    }
    if (set->count > FXL_SCENE_FACES_MAX || set->line_map[0] != 0 ||
        set->line_map[scene->model_count] != set->count) {
        return fxl_fault_at(fault, "line table", 0, FXL_E_COUNT);
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const uint32_t end = set->line_map[i + 1];
        if (end < set->line_map[i] || end > set->count) {
            return fxl_fault_at(fault, "model", i, FXL_E_COUNT);
        }
        for (uint32_t k = set->line_map[i]; k < end; k++) {
            const fxl_status status = check_line(&set->lines[k], &scene->models[i]);
            if (status != FXL_OK) {
                return fxl_fault_at(fault, "line", k, status);
            }
        }
    }
    return FXL_OK;
}
