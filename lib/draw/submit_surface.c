/* SPDX-License-Identifier: MIT */
/* The shader of surfaces: a face that has one goes, after the clipper, with its gradients to the
 * display list or into the band. */
#include "../paint/gradients.h"
#include "../paint/segments.h"
#include "../paint/texture_level.h"
#include "../scene/face_bounds.h"
#include "../view/model_view.h"
#include "renderer.h"
#include "submit.h"
#include "surface_polygon.h"

bool fxl_surfaces_reach(const fxl_shader *shader, const fxl_scene *scene,
                        const fxl_instance *instance)
{
    (void)shader;
    (void)scene;
    (void)instance;
    return true;
}

/* The values of a face's attributes at its corners. */
/* surfaces 1.2 */
static FXL_ONE_COPY uint32_t find_values(const fxl_surfaces *surfaces,
                                         const fxl_model_view *model_view,
                                         const fxl_surface *surface,
                                         const fxl_corner *const corners[3],
                                         const fxl_traversal *traversal, int32_t (*values)[3])
{
    uint32_t count = 0;
    if (surface->texture != 0) {
        for (uint32_t i = 0; i < 3; i++) {
            values[FXL_ATTRIBUTE_U][i] = corners[i]->texel.u;
            values[FXL_ATTRIBUTE_V][i] = corners[i]->texel.v;
        }
        count = 2;
    }
    if (fxl_surface_is_lit(surfaces, surface)) {
        surfaces->light_code->light_corners(surfaces, model_view, traversal, corners,
                                            values[count]);
        count++;
    }
    return count;
}

/* Light that is the same at all corners of a face with a texture is no attribute. */
static void find_even_light(const int32_t light[3], uint32_t *count, fxl_surface_polygon *polygon)
{
    polygon->is_evenly_lit =
        *count > FXL_SEGMENT_LIGHT && light[0] == light[1] && light[0] == light[2];
    if (polygon->is_evenly_lit) {
        polygon->light = (uint16_t)(light[0] >> 8); /* below 64 levels */
        *count = FXL_SEGMENT_LIGHT;
    }
}

/* The least depth of a face: of its corners, whose depths are z, and of the other vertices of the
 * whole face. So it does not depend on which three of them are corners. has_others: false where the
 * corners are known to be all vertices of the face. */
/* SPEC 9.4, surfaces 3.2 */
static fxl_q18_46 nearest_depth(const fxl_model_view *model_view, const fxl_face *face,
                                const fxl_corner *const corners[3], const fxl_traversal *traversal,
                                const fxl_q18_46 z[3], bool has_others)
{
    const fxl_q18_46 nearer = z[0] < z[1] ? z[0] : z[1];
    fxl_q18_46 nearest = nearer < z[2] ? nearer : z[2];
    const uint16_t *indices = NULL;
    uint32_t count = 0;
    if (has_others) {
        const fxl_face_outline outline = fxl_whole_face(traversal->renderer->scene, face);
        indices = outline.indices;
        count = outline.count;
    }
    for (uint32_t i = 0; i < count; i++) {
        if (indices[i] != corners[0]->vertex && indices[i] != corners[1]->vertex &&
            indices[i] != corners[2]->vertex) {
            fxl_view_point vertex;
            fxl_find_corner(model_view, indices[i], traversal, &vertex);
            nearest = vertex.z < nearest ? vertex.z : nearest;
        }
    }
    return nearest;
}

/* Before what finds a face's gradients. A library for size has two functions that do, of which a
 * program without a depth buffer links the short one; any other has one, as a program may link both. */
#if FXL_IS_COMPACT
#define IN_PLACE static inline __attribute__((always_inline))
#else
#define IN_PLACE static
#endif

/* The gradients of a small face, and its depth where its texels are words: *has_words. find_texels:
 * null: they are not. Of planes for words alone it finds nothing else. Returns the level of its texture. */
IN_PLACE uint8_t find_small(const fxl_texture *texture, const fxl_model_view *model_view,
                            const fxl_face *face, const fxl_corner *const of[3],
                            const fxl_traversal *traversal, fxl_texels_finder *find_texels,
                            fxl_corner_planes *planes, fxl_gradient_corners *corners,
                            bool is_affine, fxl_surface_polygon *polygon, bool *has_words)
{
    const bool has_levels = texture != NULL && texture->levels > 1;
    fxl_gradients *gradients = &polygon->gradients;
    fxl_texel_density density;
    if (has_levels) {
        density.texels = fxl_texel_area(corners->values);
        fxl_corner_planes_density(planes, is_affine,
                                  nearest_depth(model_view, face, of, traversal,
                                                planes->corners->depths, !planes->is_triangle),
                                  &density);
    }
    *has_words = find_texels != NULL && find_texels(planes, corners->values, corners->count,
                                                    is_affine, gradients, &polygon->depth);
    if (!*has_words && !planes->is_for_words) {
        fxl_corner_planes_find(planes, corners->values, corners->count, is_affine, gradients);
    }
    return has_levels ? fxl_texture_level_choose(texture, &density, gradients) : 0;
}

/* The gradients of any other face. */
IN_PLACE uint8_t find_large(const fxl_surface *surface, const fxl_texture *texture,
                            const fxl_model_view *model_view, const fxl_face *face,
                            const fxl_corner *const of[3], const fxl_traversal *traversal,
                            fxl_gradient_corners *corners, fxl_gradients *gradients)
{
    const fxl_view *view = model_view->view;
    const bool has_levels = texture != NULL && texture->levels > 1;
    const fxl_view_point *p = corners->corners;
    fxl_texel_density density;
    fxl_q18_46 nearest = 0;
    for (uint32_t i = 0; i < 3; i++) {
        fxl_find_corner(model_view, of[i]->vertex, traversal, &corners->corners[i]);
    }
    if (has_levels) {
        const fxl_q18_46 z[3] = {p[0].z, p[1].z, p[2].z};
        nearest = nearest_depth(model_view, face, of, traversal, z, true);
    }
    if (surface->division == FXL_AFFINE && fxl_corners_make_affine(corners, view)) {
        nearest = p[0].z; /* of all of the face: it is in the plane of the screen */
    }
    fxl_gradients_find(corners, view, gradients);
    if (!has_levels) {
        return 0;
    }
    density.texels = fxl_texel_area(corners->values);
    return fxl_texture_level_choose(
        texture, fxl_texel_density_find(nearest, view, gradients, &density) ? &density : NULL,
        gradients);
}

/* surfaces 6.1 */
IN_PLACE void find_surface(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                           const fxl_model_view *model_view, const fxl_face *face,
                           const fxl_traversal *traversal, fxl_depth_finder *find_depth,
                           fxl_linear_finder *find_linear, fxl_texels_finder *find_texels,
                           fxl_surface_polygon *polygon)
{
    const fxl_view *view = model_view->view;
    const fxl_surface *surface = &surfaces->set->surfaces[mapped->surface];
    const fxl_texture *texture =
        surface->texture != 0 ? &surfaces->set->textures[surface->texture - 1] : NULL;
    fxl_screen_corners on_screen;
    fxl_corner_planes planes;
    fxl_gradient_corners corners;
    const fxl_corner *of[3];
    fxl_find_mapped_corners(surfaces->set, surface, mapped, of);
    const bool is_projected = fxl_find_screen_corners(model_view, face, of, traversal, &on_screen);
    corners.count = find_values(surfaces, model_view, surface, of, traversal, corners.values);
    find_even_light(corners.values[FXL_SEGMENT_LIGHT], &corners.count, polygon);
    polygon->surface = mapped->surface;
    polygon->colour = face->material;
    polygon->shade = 0;
    polygon->is_in_beam = false;
    polygon->has_depth = find_depth != NULL;
    if (is_projected && find_linear != NULL && corners.count == 1 &&
        fxl_has_light_alone(surfaces, surface) &&
        find_linear(&on_screen, &view->lens, corners.values[0], &polygon->gradients,
                    &polygon->depth)) {
        polygon->level = 0;
        return;
    }
    const bool has_colours = (surface->flags & FXL_SURFACE_COLOURS) != 0;
    const bool may_have_words = find_texels != NULL && texture != NULL && is_projected &&
                                on_screen.is_triangle &&
                                fxl_may_have_words(surfaces, surface, texture);
    const bool has_planes =
        is_projected &&
        fxl_corner_planes_begin(&on_screen, &view->lens,
                                has_colours                              ? FXL_COLOURS_SIDE_MAX
                                : may_have_words && texture->levels == 1 ? FXL_TEXELS_SIDE_MAX
                                                                         : FXL_SMALL_SIDE_MAX,
                                &planes);
    const bool is_small = has_planes && !planes.is_for_words;
    const bool is_affine = has_planes && surface->division == FXL_AFFINE &&
                           fxl_corners_are_on_screen(&on_screen, &view->lens);
    const bool is_found =
        has_colours &&
        surfaces->painter->find_colours(
            surfaces, of, has_planes && surface->division != FXL_DIVIDE_1 ? &planes : NULL,
            is_affine, surface->division != FXL_DIVIDE_8, &corners, &polygon->gradients);
    /* What is divided at each pixel, or has more texels, keeps the exact planes. */
    const bool has_few = texture == NULL || fxl_has_few_texels(corners.values);
    bool is_in_words = false, is_done = is_found;
    polygon->level = 0;
    if (!is_done && has_few && has_planes && surface->division != FXL_DIVIDE_1) {
        polygon->level = find_small(texture, model_view, face, of, traversal,
                                    may_have_words ? find_texels : NULL, &planes, &corners,
                                    is_affine, polygon, &is_in_words);
        is_done = is_small || is_in_words;
    }
    if (!is_done) {
        polygon->level = find_large(surface, texture, model_view, face, of, traversal, &corners,
                                    &polygon->gradients);
    }
    if (find_depth != NULL && !is_in_words) {
        const bool may_be_words = is_found && on_screen.width <= FXL_WORDS_SIDE_MAX &&
                                  on_screen.height <= FXL_WORDS_SIDE_MAX;
        find_depth(model_view, face, traversal, is_small || may_be_words ? &planes : NULL, is_found,
                   &polygon->depth);
    }
}

#if FXL_IS_COMPACT

void fxl_surface_find(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                      const fxl_model_view *model_view, const fxl_face *face,
                      const fxl_traversal *traversal, fxl_surface_polygon *polygon)
{
    find_surface(surfaces, mapped, model_view, face, traversal, NULL, NULL, NULL, polygon);
}

#endif

void fxl_surface_find_deep(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                           const fxl_model_view *model_view, const fxl_face *face,
                           const fxl_traversal *traversal, fxl_depth_finder *find_depth,
                           fxl_linear_finder *find_linear, fxl_texels_finder *find_texels,
                           fxl_surface_polygon *polygon)
{
    find_surface(surfaces, mapped, model_view, face, traversal, find_depth, find_linear,
                 find_texels, polygon);
}

static bool pass_on(const fxl_model_view *model_view, const fxl_face *face,
                    const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_shader *next =
        fxl_shader_reaching(shader->next, traversal->renderer->scene, model_view->instance);
    return next != NULL ? next->code->face(model_view, face, traversal, next)
                        : fxl_submit_shaded_face(model_view, face, traversal);
}

/* The beams of a renderer with surfaces, if they reach an instance; or null. */
static const fxl_shader *beams_of(const fxl_surfaces *surfaces, const fxl_scene *scene,
                                  const fxl_instance *instance)
{
    const fxl_shader *beams = surfaces->beams;
    return beams != NULL && beams->code->reaches(beams, scene, instance) ? beams : NULL;
}

/* The mapped face of a face; null: it has no surface. The painter is the target's own: a frame with
 * another does not begin (combination.c). */
/* surfaces 6.2 */
static const fxl_mapped_face *mapped_of(const fxl_surfaces *surfaces, const fxl_face *face,
                                        const fxl_renderer *renderer)
{
    const fxl_surface_set *set = surfaces->set;
    const uint32_t number = set->face_map[face - renderer->scene->faces];
    return number == 0 ? NULL : &set->faces[number - 1];
}

bool fxl_surfaces_map(const fxl_shader *shader, const fxl_renderer *renderer, const fxl_face *face)
{
    return mapped_of((const fxl_surfaces *)(const void *)shader, face, renderer) != NULL;
}

const fxl_mapped_face *fxl_surfaces_take(const fxl_surfaces *surfaces,
                                         const fxl_model_view *model_view, const fxl_face *face,
                                         const fxl_traversal *traversal, bool *fitted)
{
    const fxl_mapped_face *mapped = mapped_of(surfaces, face, traversal->renderer);
    if (mapped == NULL) {
        *fitted = pass_on(model_view, face, traversal, &surfaces->shader);
        return NULL;
    }
    const fxl_shader *beams = beams_of(surfaces, traversal->renderer->scene, model_view->instance);
    if (beams != NULL) { /* fxl_submit_split_face, which a program without beams does not link */
        *fitted = beams->code->face(model_view, face, traversal, &surfaces->shader);
        return NULL;
    }
    return mapped;
}

/* A piece of a mapped face, which no beam splits further. */
static bool submit_piece(fxl_pieces *pieces, const fxl_mapped_surface *of, const fxl_point *points,
                         uint32_t count)
{
    const fxl_traversal *traversal = pieces->traversal;
    fxl_face piece = {.material = pieces->face->material};
    fxl_model_view model_view;
    fxl_model_view_of_polygon(&model_view, points, &traversal->renderer->frame.view,
                              &traversal->workspace->cache);
    model_view.planes = pieces->planes;
    fxl_set_face_of_points(&piece, count);
    pieces->outcome |= of->surfaces->painter->submit_piece(of, &model_view, &piece, traversal);
    return pieces->outcome < FXL_OUTCOME_FULL;
}

/* fxl_piece_taker. */
static bool take_piece(fxl_pieces *pieces, const fxl_point *points, uint32_t count, bool is_lit)
{
    const fxl_mapped_surface *of = (const fxl_mapped_surface *)pieces->taker;
    of->polygon->is_in_beam = is_lit;
    return submit_piece(pieces, of, points, count);
}

/* Beams split the face, or the piece of it, and give the pieces back. */
/* beams 6.1 */
bool fxl_surfaces_split(const fxl_shader *shader, fxl_pieces *pieces, const fxl_face *face,
                        const fxl_point *points, uint32_t count)
{
    const fxl_renderer *renderer = pieces->traversal->renderer;
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)shader;
    fxl_surface_polygon polygon;
    fxl_mapped_surface of = {surfaces, mapped_of(surfaces, pieces->face, renderer), pieces,
                             &polygon, false};
    FXL_ASSERT(of.mapped != NULL);
    const fxl_shader *beams = beams_of(surfaces, renderer->scene, pieces->instance);
    if (beams == NULL) {
        return submit_piece(pieces, &of, points, count);
    }
    surfaces->painter->find(&of, NULL, NULL, pieces->traversal, &polygon);
    of.is_found = true;
    pieces->take = take_piece;
    pieces->taker = &of;
    const bool fitted = beams->code->split(beams, pieces, face, points, count);
    pieces->take = NULL;
    return fitted;
}

const fxl_model_view *fxl_surfaces_view(const fxl_traversal *traversal,
                                        const fxl_instance *instance, fxl_turned_view *view)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const uint32_t number = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    fxl_vertex_cache *cache = &traversal->workspace->cache;
    fxl_model_view *model_view = &view->model_view;
    if (turned != NULL) {
        (void)turned->view(view, scene, number, &traversal->renderer->frame.view, cache,
                           FXL_PLANES_ALL);
    } else {
        fxl_model_view_of_instance(model_view, scene, instance, &traversal->renderer->frame.view,
                                   cache);
    }
    model_view->instance = instance;
    return model_view;
}

/* combinations 1.1, 1.3, surfaces 6.4 */
fxl_status fxl_attach_surfaces(fxl_renderer *renderer, fxl_surfaces *surfaces,
                               const fxl_surface_set *set, const fxl_painter *painter)
{
    fxl_status status = FXL_OK;
    if (renderer == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (renderer->scene == NULL) {
        status = FXL_E_ORDER;
    } else if (set != NULL) {
        status = surfaces == NULL || painter == NULL
                     ? FXL_E_ARGUMENT
                     : fxl_surfaces_check(set, renderer->scene, painter->target->pixel_bits, NULL);
    }
    if (status != FXL_OK) {
        return fxl_refuse(&renderer->workspace, status);
    }
    if (set == NULL) {
        fxl_renderer_attach(renderer, FXL_SHADER_SURFACES, NULL);
        return FXL_OK;
    }
    surfaces->set = set;
    surfaces->painter = painter;
    surfaces->light = NULL;
    surfaces->light_code = NULL;
    surfaces->beams = NULL;
    surfaces->shader.code = painter->code;
    renderer->draw_display_list = fxl_mixed_draw_list;
    fxl_renderer_attach(renderer, FXL_SHADER_SURFACES, &surfaces->shader);
    return FXL_OK;
}

/* The depth of a face: from its corners on the screen where it is small, else from its normal. */
void fxl_find_depth(const fxl_model_view *model_view, const fxl_face *face,
                    const fxl_traversal *traversal, fxl_corner_planes *planes, bool has_words,
                    fxl_depth_plane *plane)
{
    if (planes != NULL && has_words && fxl_corner_planes_depth_words(planes, plane)) {
        return;
    }
    if (planes == NULL || planes->is_for_words) {
        fxl_find_depth_by_normal(model_view, face, traversal, plane);
    } else {
        fxl_corner_planes_depth(planes, plane);
    }
}
