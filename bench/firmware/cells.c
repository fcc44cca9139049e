/* SPDX-License-Identifier: MIT */
/* Draws scenes in the ways of docs/extras/combinations.md. The scene partition has a list of them,
 * in words of 32 bits: bytes of the scene image, 0 at the end of the list 1 + the colour of
 * outlines, or 0 how many ways follow, and for each the rows of a band, words of the display list,
 * cores, and 1 + the colour of a border that is drawn over the frame, or 0 the image, filled up to
 * a multiple of 4 bytes Prints for each scene and way cells: crc N       of the pixels of all
 * frames, or cells: refused: STATUS and in the end cells: done N      how many lines that were */
#include "contract/store.h"
#include "contract/system.h"
#include "draw.h"
#include "fixel/all.h"
#include "path.h"
#include "program.h"

#define FRAME_BYTES  (2u * 64u * 48u)
#define FRAMES_MAX   2u
#define SECOND_BYTES 49152u

typedef struct {
    uint32_t rows, list_words, cores, border;
} cell_way;

static uint64_t pixels[FRAME_BYTES * FRAMES_MAX / 8u], second_room[SECOND_BYTES / 8u];
static fxl_workspace second;
static fxl_outlines outlines;

/* The renderer as a way wants it. */
static fxl_status set_up(const fxl_scene_image *image, const cell_way *way, uint32_t outline)
{
    fxl_renderer *const renderer = draw_renderer();
    const fxl_outline_style style = {.line = (uint8_t)(outline - 1u),
                                     .keeps_colours = true,
                                     .code = &fxl_outlines_by_depth};
    fxl_status status = FXL_OK;

    if (draw_open(image) != SYSTEM_EXIT_DONE) {
        return FXL_E_CAPACITY;
    }
    if (way->list_words < renderer->frame.display_list.capacity) {
        renderer->frame.display_list.capacity = way->list_words;
    }
    if (outline > 0) {
        status = fxl_attach_outlines(renderer, &outlines, &style);
    }
    if (status == FXL_OK && way->cores == 2) {
        status = fxl_workspace_init(&second, renderer, second_room, sizeof second_room);
    }
    return status;
}

static fxl_status draw_band(const cell_way *way, const fxl_band *band, uint8_t background)
{
    fxl_renderer *const renderer = draw_renderer();
    const bool is_second = way->cores == 2 && band->first_row / way->rows % 2u != 0;
    fxl_status status;

    fxl_frame_fill(renderer, band, background);
    status =
        is_second ? fxl_frame_draw_with(renderer, &second, band) : fxl_frame_draw(renderer, band);
    return status == FXL_OK && way->border > 0
               ? fxl_draw_border(band, 4, 4, 24, 16, (uint8_t)(way->border - 1u))
               : status;
}

static fxl_status draw_one(const fxl_scene_image *image, const fxl_pose *pose, const cell_way *way,
                           uint8_t *frame)
{
    const fxl_lens *const lens = &image->lens;
    const fxl_renderer *const renderer = draw_renderer();
    const uint32_t row_bytes = lens->width * (renderer->target->pixel_bits / 8u);
    fxl_status status = fxl_frame_begin(draw_renderer(), pose);

    for (uint32_t row = 0; row < lens->height && status == FXL_OK; row += way->rows) {
        const uint32_t left = lens->height - row;
        const fxl_band band = {.pixels = frame + row * row_bytes,
                               .width = lens->width,
                               .stride = lens->width,
                               .first_row = (uint16_t)row,
                               .rows = (uint16_t)(way->rows < left ? way->rows : left),
                               .palette = renderer->palette};
        status = draw_band(way, &band, image->background);
    }
    return status;
}

/* The CRC of the pixels of all frames. */
static fxl_status draw_all(const fxl_scene_image *image, const cell_way *way, uint32_t outline,
                           uint32_t *crc)
{
    const uint32_t area = (uint32_t)image->lens.width * image->lens.height;
    fxl_status status = set_up(image, way, outline);
    const uint32_t frame_bytes = area * (draw_renderer()->target->pixel_bits / 8u);
    walk_path path;

    if (status == FXL_OK && (image->frame_count > FRAMES_MAX || 2u * area > FRAME_BYTES)) {
        status = FXL_E_CAPACITY;
    }
    walk_path_begin(&path, image, false);
    for (uint32_t i = 0; i < image->frame_count && status == FXL_OK; i++) {
        status = walk_path_next(&path, 0);
        if (status == FXL_OK) {
            status = draw_one(image, &path.viewer.pose, way, (uint8_t *)pixels + i * frame_bytes);
        }
    }
    *crc = fxl_crc(FXL_CRC_START, pixels, frame_bytes * image->frame_count);
    return status;
}

/* A scene of the list, which *words points to, in all its ways. Goes on to the next one. */
static int draw_scene(const uint32_t **words, uint32_t *lines)
{
    const uint32_t size = (*words)[0], outline = (*words)[1], count = (*words)[2];
    const cell_way *const ways = (const cell_way *)(const void *)(*words + 3);
    const uint32_t *const bytes = (const uint32_t *)(const void *)(ways + count);
    fxl_scene_image image;

    if (fxl_scene_open(bytes, size, &image, NULL) != FXL_OK) {
        return SYSTEM_EXIT_SCENE;
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t crc;
        const fxl_status status = draw_all(&image, &ways[i], outline, &crc);
        if (status == FXL_OK) {
            text_with_number("cells: crc", "", " ", crc);
        } else {
            system_text("cells: refused: ");
            system_text(fxl_status_text(status));
            system_text("\n");
        }
    }
    *lines += count;
    *words = bytes + (size + 3u) / 4u;
    return SYSTEM_EXIT_DONE;
}

static int run(void)
{
    size_t size = 0;
    uint32_t lines = 0;
    int code = SYSTEM_EXIT_DONE;
    const uint32_t *words = (const uint32_t *)store_scene(&size);

    while (code == SYSTEM_EXIT_DONE && words[0] != 0) {
        code = draw_scene(&words, &lines);
    }
    if (code == SYSTEM_EXIT_DONE) {
        text_with_number("cells: done", "", " ", lines);
    }
    return code;
}

int main(int argc, char **argv)
{
    bench_start(argc, argv);
    system_exit(run());
    return SYSTEM_EXIT_DONE; /* not reached */
}
