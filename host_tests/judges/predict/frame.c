/* SPDX-License-Identifier: MIT */
#include "predict/frame.h"

#include <string.h>

#include "predict/counts.h"
#include "predict/shares.h"
#include "scene/lens.h"

const char *predict_no_room(const fxl_scene_image *image, const uint32_t settings[PREDICT_SETTINGS],
                            uint32_t taken)
{
    if (settings[PREDICT_BAND] < image->lens.width * (image->pixel_bits / 8u)) {
        return "a band holds no row of the screen";
    }
    if (settings[PREDICT_ORDER] > 0 && image->scene.draw_list_needed > settings[PREDICT_ORDER]) {
        return "the order has too few entries";
    }
    const uint32_t left = taken < settings[PREDICT_LIST] ? settings[PREDICT_LIST] - taken : 0;
    return taken > settings[PREDICT_LIST] ||
                   depth_bytes(image, left) + tree_bytes(image, left) > left
               ? "the display list's memory is too small for what the scene has beside its faces"
               : NULL;
}

/* What fills the frame with a horizon: it is counted as a clear, and by its rows and the places in
 * them where the colour changes; in the first row of a band nothing says where that may be. */
static void (*fill_horizon)(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour);

/* place pixel-format: whether two pixels are of one colour */
static bool has_change(const fxl_band *band, size_t place)
{
    const uint16_t *wide = (const uint16_t *)(const void *)band->pixels;
    return band->palette != NULL ? wide[place] != wide[place + 1]
                                 : band->pixels[place] != band->pixels[place + 1];
}

static void count_horizon(const fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    renderer->target->fill(renderer, band, colour);
    const predict_counts before = counted;
    fill_horizon(renderer, band, colour);
    counted = before;
    counted.horizon_rows += band->rows;
    for (uint32_t row = 0; row < band->rows; row++) {
        for (uint32_t column = 0; column + 1 < band->width; column++) {
            const bool is_there = has_change(band, (size_t)row * band->stride + column);
            counted.horizon_changes += is_there;
            counted.horizon_searched += is_there && row == 0;
        }
    }
}

const char *predict_set_up(session *run, const uint32_t settings[PREDICT_SETTINGS], uint32_t taken)
{
    const uint32_t order =
        settings[PREDICT_ORDER] > 0 ? settings[PREDICT_ORDER] : run->image.scene.draw_list_needed;
    const uint32_t depth = depth_bytes(&run->image, settings[PREDICT_LIST] - taken);
    const uint32_t tree = tree_bytes(&run->image, settings[PREDICT_LIST] - taken);
    uint32_t list = settings[PREDICT_LIST] - taken - depth - tree;
    list = settings[PREDICT_LIST_MOST] > 0 && list > settings[PREDICT_LIST_MOST]
               ? settings[PREDICT_LIST_MOST]
               : list;
    session_settings methods = {.clipper = &fxl_clipper_view,
                                .display_list_words = list / 4,
                                .cache_entries = settings[PREDICT_CACHE],
                                .raster_bytes = depth,
                                .pixel_bits = run->image.pixel_bits,
                                .pieces_bytes = tree - tree_bytes(&run->image, 0)};
    session_follow_scene(run, &methods);
    if (draws_by_tree(&run->image)) {
        methods.order = &counting_tree;
    }
    session_reserve(run, &methods);
    run->memory.draw_list = session_memory(order * sizeof(fxl_draw_entry));
    run->memory.draw_list_capacity = order;
    const fxl_status status = session_set_up(run, &methods);
    if (status == FXL_OK && run->renderer.horizon != NULL) {
        fill_horizon = run->renderer.fill;
        run->renderer.fill = count_horizon;
    }
    if (status == FXL_OK) {
        count_lines_in_order(&run->renderer);
    }
    return status == FXL_OK ? NULL : fxl_status_text(status);
}

fxl_status predict_frame(session *run, const fxl_pose *pose, uint32_t number,
                         const uint32_t settings[PREDICT_SETTINGS], uint8_t *pixels)
{
    const fxl_lens *lens = &run->image.lens;
    const uint32_t rows = settings[PREDICT_BAND] / (lens->width * (run->image.pixel_bits / 8u));
    session_play(run, number);
    memset(&counted, 0, sizeof counted);
    is_wide = run->image.pixel_bits == 16;
    is_parallel = fxl_orthographic_of(lens) != NULL;
    const fxl_status status = session_draw(run, pose, rows, run->image.background, pixels);
    counted.frames = 1;
    counted.bands += is_wide ? (lens->height + rows - 1) / rows : 0;
    counted.instances = run->image.scene.instance_count;
    counted.instances_seen = run->renderer.frame.visible_count;
    counted.parallel_instances = is_parallel ? counted.instances_seen : 0;
    return status;
}
