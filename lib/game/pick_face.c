/* SPDX-License-Identifier: MIT */
/* A pick draws the frame once more, with all that the renderer has, into a band of one pixel that
 * counts. The clipper gives a small square about that pixel in place of each polygon that covers
 * it, so a painter paints this pixel alone, with the texel, the light and the depth that it has
 * there. A shader before all others knows which face it is. What has changed the pixel is what is
 * shown. */
#include "../draw/renderer.h"
#include "../draw/surface_polygon.h"
#include "../math/arith.h"
#include "../paint/billboard_paint.h"
#include "../paint/depth_row.h"
#include "../raster/scan.h"
#include "../view/model_view.h"
#include "fixel/pick.h"

/* A pick. */
typedef struct {
    fxl_shader shader; /* the renderer's first: a pointer to it is one to this record */
    fxl_clipper clipper;
    fxl_billboards billboards;
    fxl_sprite_painter sprites;
    const fxl_clipper *real_clipper; /* what the renderer has beside */
    void *real_workspace;
    const fxl_billboards *real_billboards;
    fxl_surfaces *surfaces; /* null: there are none */
    const fxl_surface_set *real_set;
    fxl_surface_set set; /* in which the surface of a blended face is opaque */
    fxl_surface opaque;
    uint8_t pass; /* of a depth buffer */
    fxl_renderer *renderer;
    fxl_band band;  /* a row of the screen, of which one pixel is in memory */
    uint32_t pixel; /* this one: 8 or 16 bits of it */
    uint8_t *cell;  /* its cell of the depth buffer; null: there is none */
    uint16_t x;
    bool stops;        /* at the first that is shown: near to far, without a depth buffer */
    bool covers;       /* a polygon of the face that is drawn covers the pixel */
    uint8_t colour;    /* of that polygon */
    uint16_t instance; /* whose billboard is drawn */
    fxl_picked found;
} probe;

static probe *probe_of(const fxl_renderer *renderer)
{
    return (probe *)(uintptr_t)renderer->shader;
}

/* --- what covers the pixel ------------------------------------------------------------------ */

/* pick 2.2 */
static bool covers(probe *of, const fxl_screen_polygon *screen)
{
    fxl_scan *scan = &of->renderer->workspace.work.scan;
    fxl_span span;
    fxl_scan_outline(screen->points, screen->count, &of->band, scan);
    while (fxl_scan_next(scan, &span)) {
        if (of->x >= span.x0 && of->x < span.x1) {
            return true;
        }
    }
    return false;
}

static bool is_polygon(fxl_clip_result result)
{
    return result == FXL_CLIP_INSIDE || result == FXL_CLIP_CUT;
}

/* The polygons of a face, from one on, to the first that covers the pixel. */
/* pick 2.2 */
static fxl_clip_result find_covering(probe *of, const fxl_model_view *model_view,
                                     fxl_clipper_work *work, fxl_screen_polygon *screen,
                                     fxl_clip_result result)
{
    while (is_polygon(result) && !covers(of, screen)) {
        result = of->real_clipper->next != NULL ? of->real_clipper->next(model_view, work, screen)
                                                : FXL_CLIP_OUTSIDE;
    }
    if (is_polygon(result)) {
        const fxl_q16_16 x = of->x * 65536, y = of->band.first_row * 65536;
        of->covers = true;
        of->colour = screen->colour;
        screen->count = 4;
        for (uint32_t i = 0; i < 4; i++) { /* clockwise from the upper left corner */
            screen->points[i].x = i == 1 || i == 2 ? x + 65536 : x;
            screen->points[i].y = i >= 2 ? y + 65536 : y;
        }
    }
    return result;
}

/* The renderer's clipper finds its own workspace. No model view is a constant object. */
static fxl_clip_result clip_by(const fxl_model_view *model_view, const fxl_face *face,
                               fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    probe *of = (probe *)model_view->clipper_workspace;
    fxl_model_view *view = (fxl_model_view *)(uintptr_t)model_view;
    view->clipper_workspace = of->real_workspace;
    const fxl_clip_result first = face != NULL
                                      ? of->real_clipper->clip(model_view, face, work, screen)
                                      : of->real_clipper->next(model_view, work, screen);
    const fxl_clip_result result = find_covering(of, model_view, work, screen, first);
    view->clipper_workspace = of;
    return result;
}

static fxl_clip_result next_by(const fxl_model_view *model_view, fxl_clipper_work *work,
                               fxl_screen_polygon *screen)
{
    return clip_by(model_view, NULL, work, screen);
}

/* --- what is shown -------------------------------------------------------------------------- */

/* A face, a piece or a billboard, drawn over two colours: what is the same as both was not drawn. No
 * pixel of it is blended with them (begin_opaque). */
typedef struct {
    uint32_t over_0;
    uint32_t cell_before;
    uint8_t cell_bytes;
} comparison;

/* bytes: 0, 2 or 4. The compiler is told that they are no more than a cell. */
static void copy_cell(uint8_t *to, const uint8_t *from, uint32_t bytes)
{
    for (uint32_t i = 0; i < bytes && i < sizeof(uint32_t); i++) {
        to[i] = from[i];
    }
}

static fxl_depth_head *depth_head(const probe *of)
{
    return (fxl_depth_head *)of->renderer->workspace.target_memory;
}

/* Has a blended face, whose pixel may be that of any background, drawn as an opaque one; with a depth
 * buffer in the pass in which it is blended: there are two where a surface is. Of all surfaces the
 * face reads only its own. */
/* pick 2.4 */
static bool begin_opaque(probe *of, const fxl_face *face)
{
    const fxl_surface_set *set = of->real_set;
    const uint32_t number =
        of->surfaces != NULL ? set->face_map[face - of->renderer->scene->faces] : 0;
    if (number == 0) {
        return false;
    }
    const uint32_t surface = set->faces[number - 1].surface;
    of->opaque = set->surfaces[surface];
    if ((of->opaque.flags & (FXL_SURFACE_BLEND | FXL_SURFACE_ADD)) == 0) {
        return false;
    }
    of->opaque.flags &= (uint8_t) ~(FXL_SURFACE_BLEND | FXL_SURFACE_ADD);
    of->opaque.sixteenths = 0;
    of->set = *set;
    of->set.surfaces =
        (const fxl_surface *)((uintptr_t)&of->opaque - surface * sizeof(fxl_surface));
    of->surfaces->set = &of->set;
    if (of->cell != NULL) {
        of->pass = depth_head(of)->pass;
        depth_head(of)->pass =
            of->pass == FXL_DEPTH_BLENDED ? (uint8_t)FXL_DEPTH_OPAQUE : (uint8_t)FXL_DEPTH_BLENDED;
    }
    return true;
}

/* A blended face keeps no depth. */
static void end_opaque(probe *of, const comparison *both)
{
    of->surfaces->set = of->real_set;
    if (of->cell != NULL) {
        depth_head(of)->pass = of->pass;
        copy_cell(of->cell, (const uint8_t *)&both->cell_before, both->cell_bytes);
    }
}

static void begin_first(probe *of, comparison *both)
{
    of->covers = false;
    of->pixel = 0;
    both->cell_bytes = of->renderer->target->depth_bits / 8u;
    copy_cell((uint8_t *)&both->cell_before, of->cell, both->cell_bytes);
}

static void begin_second(probe *of, comparison *both)
{
    both->over_0 = of->pixel;
    of->pixel = UINT32_MAX;
    copy_cell(of->cell, (const uint8_t *)&both->cell_before, both->cell_bytes);
}

/* pick 2.4 */
static bool is_shown(const probe *of, const comparison *both)
{
    return both->over_0 != 0 || of->pixel != UINT32_MAX;
}

/* pick 2.5 */
static void name(probe *of, uint32_t instance, uint32_t face)
{
    of->found.instance = (uint16_t)instance;
    of->found.face = (uint16_t)face;
    of->found.colour = of->colour;
}

/* pick 2.3 */
static void name_face(probe *of, const fxl_instance *instance, const fxl_face *face)
{
    const fxl_scene *scene = of->renderer->scene;
    const fxl_model *model = &scene->models[instance->model];
    name(of, fxl_instance_number(scene, instance),
         (uint32_t)(face - &scene->faces[model->first_face]));
}

static bool draw_face(const probe *of, const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal)
{
    const fxl_shader *next =
        fxl_shader_reaching(of->shader.next, of->renderer->scene, model_view->instance);
    return next != NULL ? next->code->face(model_view, face, traversal, next)
                        : fxl_submit_shaded_face(model_view, face, traversal);
}

/* fxl_shader_code.face. */
static bool take_face(const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal, const fxl_shader *shader)
{
    probe *of = (probe *)(uintptr_t)shader;
    comparison both;
    const bool is_blended = begin_opaque(of, face);
    begin_first(of, &both);
    (void)draw_face(of, model_view, face, traversal);
    begin_second(of, &both);
    if (of->covers) {
        (void)draw_face(of, model_view, face, traversal);
    }
    if (is_blended) {
        end_opaque(of, &both);
    }
    if (!of->covers || !is_shown(of, &both)) {
        return true;
    }
    name_face(of, model_view->instance, face);
    return !of->stops;
}

/* fxl_shader_code.split. */
static bool take_piece(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                       const fxl_point *points, uint32_t count)
{
    probe *of = (probe *)(uintptr_t)shader;
    comparison both;
    (void)count;
    const bool is_blended = begin_opaque(of, pieces->face);
    begin_first(of, &both);
    (void)fxl_submit_piece_by(pieces, shader->next, face, points);
    begin_second(of, &both);
    if (of->covers) {
        (void)fxl_submit_piece_by(pieces, shader->next, face, points);
    }
    if (is_blended) {
        end_opaque(of, &both);
    }
    if (!of->covers) {
        return true;
    }
    if (is_shown(of, &both)) {
        name_face(of, pieces->instance, pieces->face);
        pieces->outcome |= of->stops ? FXL_OUTCOME_FULL : 0;
    }
    return pieces->outcome < FXL_OUTCOME_FULL;
}

static bool reaches(const fxl_shader *shader, const fxl_scene *scene, const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

/* --- billboards ----------------------------------------------------------------------------- */

/* The entry of the palette that a pixel shows: in RGB565 the first of its colour. */
/* pick 2.3 */
static uint8_t colour_of(const probe *of, uint32_t pixel)
{
    uint32_t colour = 0;
    if (!fxl_kind_of_band(&of->band).is_colour) {
        return (uint8_t)pixel;
    }
    while (colour < 255 && of->band.palette[colour] != (uint16_t)pixel) {
        colour++;
    }
    return (uint8_t)colour;
}

/* fxl_sprite_painter.paint: one column of the record. */
/* billboards 4.3 */
static void paint_sprite(const fxl_renderer *renderer, fxl_workspace *workspace,
                         const fxl_screen_point *points, const fxl_band *band)
{
    probe *of = probe_of(renderer);
    const fxl_sprite_painter *painter = of->real_billboards->painter;
    fxl_screen_point column[FXL_BILLBOARD_POINTS_MAX];
    comparison both;
    for (uint32_t i = 0; i < painter->points; i++) {
        column[i] = points[i];
    }
    column[2].y = of->x + 1;
    begin_first(of, &both);
    painter->paint(renderer, workspace, column, band);
    begin_second(of, &both);
    painter->paint(renderer, workspace, column, band);
    if (is_shown(of, &both)) {
        of->colour = colour_of(of, both.over_0);
        of->covers = true;
        name(of, of->instance, 0);
    }
}

/* fxl_billboard_code.instance. */
/* billboards 4.3 */
static bool take_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    probe *of = probe_of(traversal->renderer);
    const fxl_billboards *real = of->real_billboards;
    const uint32_t model = traversal->renderer->scene->instances[entry->index].model;
    of->instance = entry->index;
    of->covers = false;
    return real->code->instance(traversal, entry) &&
           (real->set->model_map[model] == 0 || !of->covers || !of->stops);
}

/* --- the pick ------------------------------------------------------------------------------- */

/* fxl_target.flat of a target of the study. */
static bool set_pixel(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                      const fxl_band *band)
{
    (void)workspace;
    band->pixels[polygon->points[0].x >> 16] = polygon->colour;
    return true;
}

static const fxl_target probe_target = {
    .pixel_bits = 8, .draw_band = fxl_draw_band, .flat = set_pixel};

/* The target in which a pick looks: without outlines. */
static const fxl_target *target_of(const fxl_renderer *renderer)
{
    const fxl_target *target = fxl_painted_target(renderer);
    const bool is_studied =
        target->pixel_bits == 8 && target->depth_bits == 0 && !target->draws_over;
    return is_studied ? &probe_target : target;
}

/* pick 2.5 */
static void begin_probe(probe *of, fxl_renderer *renderer, uint16_t x, uint16_t y)
{
    static const fxl_shader_code code = {
        .reaches = reaches, .face = take_face, .split = take_piece};
    static const fxl_picked none = {FXL_PICK_NONE, 0, 0};
    const fxl_shader shader = {renderer->shader, FXL_SHADER_TARGET, &code};
    const fxl_target *target = renderer->target;
    const uint16_t width = renderer->frame.view.lens.width;
    of->renderer = renderer;
    of->x = x;
    /* Not as one row of a whole frame: kernels that draw triangles without the clipper leave it alone. */
    const fxl_band row = {
        .width = width, .stride = (uint16_t)(width + 1u), .first_row = y, .rows = 1};
    of->band = row;
    of->band.palette = renderer->palette;
    of->band.pixels = (uint8_t *)((uintptr_t)&of->pixel -
                                  fxl_pixel_bytes(fxl_kind_of_band(&of->band), x));
    of->cell = NULL;
    if (target->depth_bits != 0) {
        of->cell = (uint8_t *)renderer->workspace.target_memory + sizeof(fxl_depth_head) +
                   x * (target->depth_bits / 8u);
    }
    of->stops = renderer->near_first && target->depth_bits == 0;
    of->found = none;
    of->surfaces = (fxl_surfaces *)(uintptr_t)fxl_surfaces_of(renderer); /* of the caller */
    of->real_set = of->surfaces != NULL ? of->surfaces->set : NULL;
    of->shader = shader;
    of->real_clipper = renderer->clipper;
    of->clipper = *renderer->clipper;
    of->clipper.clip = clip_by;
    of->clipper.next = of->real_clipper->next != NULL ? next_by : NULL;
    of->real_workspace = renderer->workspace.cache.clipper_workspace;
    of->real_billboards = renderer->billboards;
}

/* Billboards are drawn by the probe's record of them. */
static void probe_billboards(probe *of, fxl_billboard_code *code)
{
    const fxl_billboards *real = of->real_billboards;
    if (real != NULL) {
        *code = *real->code;
        code->instance = take_instance;
        of->sprites = *real->painter;
        of->sprites.paint = paint_sprite;
        const fxl_billboards billboards = {real->set, &of->sprites, code};
        of->billboards = billboards;
        of->renderer->billboards = &of->billboards;
    }
}

/* The workspace knows the order of no model's faces: it numbers instances by the direction of the
 * traversal, which may be turned round for a pick. */
static void forget_faces(fxl_workspace *workspace)
{
    workspace->sorted_instance = UINT16_MAX;
    workspace->face_rows_known = false;
}

/* Draws all faces of the frame into the band: none is taken from the display list, and none is
 * counted. */
/* pick 2.2 */
static void draw_frame(probe *of)
{
    fxl_renderer *renderer = of->renderer;
    fxl_frame *frame = &renderer->frame;
    fxl_workspace *workspace = &renderer->workspace;
    const fxl_resume_point resume = frame->resume;
    const uint32_t used = frame->display_list.used;
    const uint8_t state = frame->state;
    const bool rest_counted = workspace->rest_counted;
    frame->resume.instances = 0;
    frame->resume.faces = 0;
    frame->display_list.used = 0;
    frame->state = FXL_FRAME_BEGUN;
    workspace->rest_counted = true;
    forget_faces(workspace);
    (void)renderer->target->draw_band(renderer, workspace, &of->band);
    forget_faces(workspace);
    workspace->rest_counted = rest_counted;
    frame->state = state;
    frame->display_list.used = used;
    frame->resume = resume;
}

/* Without a depth buffer the order by distance is turned round, so that the first face that is
 * shown ends the traversal. A tree's leaves are in the order in which the frame began. */
static void pick(fxl_renderer *renderer, uint16_t x, uint16_t y, fxl_picked *picked)
{
    const fxl_target *target = renderer->target;
    const bool near_first = renderer->near_first;
    fxl_billboards *billboards = renderer->billboards;
    probe of;
    fxl_billboard_code code;
    renderer->target = target_of(renderer);
    if (renderer->order->memory_size == NULL && renderer->target->depth_bits == 0) {
        renderer->near_first = true;
    }
    begin_probe(&of, renderer, x, y);
    probe_billboards(&of, &code);
    renderer->shader = &of.shader;
    renderer->clipper = &of.clipper;
    renderer->workspace.cache.clipper_workspace = &of;
    draw_frame(&of);
    renderer->workspace.cache.clipper_workspace = of.real_workspace;
    renderer->clipper = of.real_clipper;
    renderer->shader = of.shader.next;
    renderer->billboards = billboards;
    renderer->near_first = near_first;
    renderer->target = target;
    *picked = of.found;
}

/* pick 2.1 */
fxl_status fxl_pick_face(fxl_renderer *renderer, uint16_t x, uint16_t y, fxl_picked *picked)
{
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_workspace *workspace = &renderer->workspace;
    if (picked == NULL) {
        return fxl_refuse(workspace, FXL_E_ARGUMENT);
    }
    if (renderer->frame.state == FXL_FRAME_NONE || renderer->frame.state == FXL_FRAME_RELEASED) {
        return fxl_refuse(workspace, FXL_E_ORDER);
    }
    const fxl_lens *lens = &renderer->frame.view.lens;
    if (x >= lens->width || y >= lens->height) {
        return fxl_refuse(workspace, FXL_E_RANGE);
    }
    pick(renderer, x, y, picked);
    return FXL_OK;
}
