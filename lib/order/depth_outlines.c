/* SPDX-License-Identifier: MIT */
/* Outlines with a depth buffer: each edge of a face that faces the eye is a line on that face. */
#include "../draw/line_view.h"
#include "../paint/billboard_paint.h"
#include "outlines.h"

/* --- edges ---------------------------------------------------------------------------------- */

/* wire 3.5 */
static void draw_face(fxl_line_instance *of, const fxl_face *face, uint8_t colour)
{
    const uint16_t *corners = fxl_face_indices(of->traversal->renderer->scene->indices, face);
    fxl_line line = {.from = corners[face->count - 1u], .colour = colour, .width = 1};
    bool fits = true;
    for (uint32_t i = 0; i < face->count; i++) {
        line.to = corners[i];
        (void)fxl_draw_line_on(of, &line, &face, 1, &fits);
        line.from = line.to;
    }
}

typedef struct {
    fxl_line_canvas canvas;
    uint8_t colour;
} outlined_band;

/* fxl_instance_overdraw. An instance that shows a billboard has no outlines. */
/* wire 3.5 */
static void draw_instance(const fxl_traversal *traversal, uint32_t number, void *with)
{
    outlined_band *of_band = (outlined_band *)with;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_model *model = &scene->models[scene->instances[number].model];
    const fxl_billboards *billboards = renderer->billboards;
    FXL_ALIGN_8 fxl_turned_view view;
    fxl_line_instance of;
    if (billboards != NULL && billboards->set->model_map[scene->instances[number].model] != 0) {
        return;
    }
    fxl_begin_line_instance(traversal, number, &view, &of_band->canvas, &of);
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (fxl_line_face_is_front(&of, face)) {
            draw_face(&of, face, of_band->colour);
        }
    }
}

static fxl_outlines *outlines_of(const fxl_shader *shader)
{
    return (fxl_outlines *)(uintptr_t)shader;
}

/* fxl_overdraw.draw_over. */
static void draw_over(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    fxl_outlines *outlines = outlines_of(fxl_renderer_shader(renderer, FXL_SHADER_OUTLINES));
    outlined_band of;
    of.colour = outlines->style.line;
    fxl_find_line_canvas(renderer, workspace, band, &of.canvas);
    fxl_draw_over_instances(renderer, workspace, band, draw_instance, &of);
}

/* --- faces of one colour -------------------------------------------------------------------- */

static bool fills(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)scene;
    (void)instance;
    return !outlines_of(shader)->style.keeps_colours;
}

/* fxl_shader_code.face: past colours of instances and light, to the last shader. */
static bool submit_filled(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_shader *last = traversal->renderer->target->extras->last;
    fxl_face filled = *face;
    filled.material = outlines_of(shader)->style.fill;
    traversal->workspace->screen.shade = 0;
    return last->code->face(model_view, &filled, traversal, last);
}

/* --- attaching ------------------------------------------------------------------------------ */

static void attach(fxl_outlines *outlines)
{
    static const fxl_shader_code code = {.reaches = fills, .face = submit_filled};
    outlines->overdraw.shader.code = &code;
    outlines->overdraw.draw_over = draw_over;
}

const fxl_outline_code fxl_outlines_by_depth = {attach};
