/* SPDX-License-Identifier: MIT */
/* Drawing over a picture, geometry for a game's loop, and orientations, with any numbers. */
#include <string.h>

#include "answers.h"
#include "parts.h"

enum {
    WIDTH = 20,
    STRIDE = 23,
    ROWS = 12,
    GROUND = 0x5A
};

/* Often near the band, or anywhere. */
static int32_t any_pixel(fuzz_input *in)
{
    return fuzz_below(in, 4) ? (int8_t)fuzz_bits(in, 1) : fuzz_any(in);
}

static void draw_any_sprite(fuzz_input *in, const fxl_band *band)
{
    static const uint8_t depths[] = {1, 4, 8, 2};
    uint8_t pixels[256], colours[256];
    fxl_sprite sprite = {pixels, fuzz_below(in, 2) ? colours : NULL, 0, 0, 0, 0};
    for (uint32_t i = 0; i < sizeof pixels; i++) {
        pixels[i] = (uint8_t)(i < 64 ? fuzz_bits(in, 1) : i);
        colours[i] = (uint8_t)~i;
    }
    sprite.width = (uint16_t)fuzz_below(in, 17);
    sprite.height = (uint16_t)fuzz_below(in, 17);
    sprite.bits = depths[fuzz_below(in, 4)];
    sprite.key = (uint16_t)fuzz_below(in, 257);
    const int32_t x = any_pixel(in), y = any_pixel(in);
    const fxl_status status = fxl_draw_sprite(band, x, y, &sprite);
    DEMAND(status == (sprite.bits == 2 ? FXL_E_RANGE : FXL_OK));
    sprite.pixels = NULL;
    DEMAND(fxl_draw_sprite(band, 0, 0, &sprite) == FXL_E_ARGUMENT);
}

static void draw_any_text(fuzz_input *in, const fxl_band *band)
{
    char text[8];
    fxl_font font = fxl_font_5x7;
    fxl_text_style style = {&font, 3, (uint8_t)fuzz_bits(in, 1)};
    fxl_text_size size = {1, 2};
    for (uint32_t i = 0; i < sizeof text - 1; i++) {
        text[i] = (char)fuzz_bits(in, 1);
    }
    text[sizeof text - 1] = '\0';
    if (fuzz_below(in, 4) == 0) {
        font.count = (uint16_t)fuzz_below(in, 96);
    } else if (fuzz_below(in, 4) == 0) {
        font.first = (uint8_t)fuzz_bits(in, 1); /* other characters than those it was made for */
    }
    const bool sound = font.first + font.count <= 256 && font.unknown >= font.first &&
                       font.unknown < font.first + font.count;
    const int32_t x = any_pixel(in), y = any_pixel(in);
    const fxl_status status = fxl_draw_text(band, x, y, text, &style);
    DEMAND(status == (sound ? FXL_OK : FXL_E_RANGE));
    DEMAND(fxl_measure_text(text, &style, &size) == status);
    if (band->palette == NULL) { /* the same call in RGB565 has nothing to add */
        record_bytes(&size, sizeof size);
    }
    DEMAND(sound ? size.height % font.line_height == 0 : size.width == 1 && size.height == 2);
    DEMAND(fxl_measure_text(NULL, &style, &size) == FXL_E_ARGUMENT);
    DEMAND(fxl_measure_text(text, &style, NULL) == FXL_E_ARGUMENT);
}

static void draw_any(fuzz_input *in, const fxl_band *band)
{
    const int32_t x = any_pixel(in), y = any_pixel(in), width = any_pixel(in),
                  height = any_pixel(in);
    fxl_status status = FXL_OK;
    switch (fuzz_below(in, 5)) {
    case 0:
        status = fxl_draw_rectangle(band, x, y, width, height, 1);
        break;
    case 1:
        status = fxl_draw_border(band, x, y, width, height, 2);
        break;
    case 2:
        status = fxl_draw_line(band, x, y, width, height, 3);
        DEMAND(status == FXL_OK || status == FXL_E_RANGE);
        return;
    case 3:
        draw_any_sprite(in, band);
        break;
    default:
        draw_any_text(in, band);
    }
    DEMAND(status == FXL_OK);
}

/* Null pointers, one at a time. */
static void demand_refused(const fxl_band *band)
{
    const uint8_t pixel = 1;
    const fxl_sprite sprite = {&pixel, NULL, 1, 1, 8, 0};
    const fxl_band none = {
        .pixels = NULL, .width = WIDTH, .stride = STRIDE, .first_row = 0, .rows = 1};
    fxl_font font = fxl_font_5x7;
    fxl_text_style style = {&font, 1, 0};
    DEMAND(fxl_draw_rectangle(NULL, 0, 0, 1, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_rectangle(&none, 0, 0, 1, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_border(NULL, 0, 0, 1, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_line(NULL, 0, 0, 1, 1, 1) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_line(band, 0, 0, 0, INT32_MIN, 1) == FXL_E_RANGE);
    DEMAND(fxl_draw_sprite(band, 0, 0, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_sprite(NULL, 0, 0, &sprite) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_text(NULL, 0, 0, "x", &style) == FXL_E_ARGUMENT);
    DEMAND(fxl_draw_text(band, 0, 0, "x", NULL) == FXL_E_ARGUMENT);
    font.bits = NULL;
    DEMAND(fxl_draw_text(band, 0, 0, "x", &style) == FXL_E_ARGUMENT);
    font.glyphs = NULL;
    font.bits = &pixel;
    DEMAND(fxl_draw_text(band, 0, 0, "x", &style) == FXL_E_ARGUMENT);
    style.font = NULL;
    DEMAND(fxl_draw_text(band, 0, 0, "x", &style) == FXL_E_ARGUMENT);
}

/* The same calls in RGB565 and in two rectangles side by side: the same pixels. */
typedef struct {
    uint16_t pixels[ROWS * STRIDE], colours[256];
} overlay_565;

static void begin_565(overlay_565 *wide)
{
    for (uint32_t i = 0; i < 256; i++) {
        wide->colours[i] = (uint16_t)(i * 40503u);
    }
    for (uint32_t i = 0; i < ROWS * STRIDE; i++) {
        wide->pixels[i] = wide->colours[GROUND];
    }
}

static void draw_565(const fuzz_input *in, overlay_565 *wide)
{
    const uint16_t columns[2] = {WIDTH / 3, WIDTH - WIDTH / 3};
    for (uint32_t i = 0; i < 2; i++) {
        fuzz_input again = *in;
        const uint16_t first = i == 0 ? 0 : columns[0];
        const fxl_band band = {.pixels = (uint8_t *)(wide->pixels + first),
                               .width = WIDTH,
                               .stride = STRIDE,
                               .first_row = 0,
                               .rows = ROWS,
                               .palette = wide->colours,
                               .first_column = first,
                               .columns = columns[i]};
        draw_any(&again, &band);
    }
}

static void demand_565(const overlay_565 *wide, const uint8_t *whole)
{
    fxl_band odd = {.pixels = (uint8_t *)(uintptr_t)wide->pixels + 1,
                    .width = WIDTH,
                    .stride = STRIDE,
                    .first_row = 0,
                    .rows = ROWS,
                    .palette = wide->colours};
    DEMAND(fxl_draw_rectangle(&odd, 0, 0, 1, 1, 1) == FXL_E_ALIGNMENT);
    for (uint32_t i = 0; i < ROWS * STRIDE; i++) {
        DEMAND(wide->pixels[i] == wide->colours[whole[i]]);
    }
}

/* The same calls into a whole screen and into its bands: the same pixels, none beside the band. */
void fuzz_overlay(fuzz_input *in)
{
    uint8_t whole[ROWS * STRIDE], bands[ROWS * STRIDE];
    overlay_565 wide;
    const uint16_t step = (uint16_t)(1 + fuzz_below(in, ROWS));
    const fxl_band all = {
        .pixels = whole, .width = WIDTH, .stride = STRIDE, .first_row = 0, .rows = ROWS};
    fxl_band wrong = {.pixels = whole, .width = 0, .stride = 0, .first_row = 0, .rows = 0};
    wrong.width = (uint16_t)fuzz_any(in);
    wrong.stride = (uint16_t)fuzz_any(in);
    wrong.first_row = (uint16_t)fuzz_any(in);
    memset(whole, GROUND, sizeof whole);
    memset(bands, GROUND, sizeof bands);
    begin_565(&wide);
    demand_refused(&all);
    DEMAND(fxl_draw_rectangle(&wrong, 0, 0, 1, 1, 1) == FXL_E_RANGE);
    for (uint32_t i = 0; i < 8 && (i == 0 || in->left > 0); i++) {
        const fuzz_input before = *in;
        draw_any(in, &all);
        draw_565(&before, &wide);
        for (uint16_t row = 0; row < ROWS; row = (uint16_t)(row + step)) {
            const uint16_t rows = row + step <= ROWS ? step : (uint16_t)(ROWS - row);
            const fxl_band band = {.pixels = bands + row * STRIDE,
                                   .width = WIDTH,
                                   .stride = STRIDE,
                                   .first_row = row,
                                   .rows = rows};
            fuzz_input again = before;
            draw_any(&again, &band);
        }
    }
    DEMAND(memcmp(whole, bands, sizeof whole) == 0);
    demand_565(&wide, whole);
    record_bytes(whole, sizeof whole);
    for (uint32_t i = 0; i < ROWS; i++) {
        DEMAND(whole[i * STRIDE + WIDTH] == GROUND && whole[i * STRIDE + STRIDE - 1] == GROUND);
    }
}

static fxl_sphere any_sphere(fuzz_input *in)
{
    fxl_sphere sphere;
    sphere.centre = fuzz_point(in, FXL_COORDINATE_MAX);
    sphere.radius =
        fuzz_below(in, 2) ? fuzz_between(in, 0, FXL_RADIUS_MAX) : (fxl_q16_16)fuzz_bits(in, 2);
    return sphere;
}

static void look_at_any(fuzz_input *in)
{
    fxl_pose pose = fuzz_pose(in), before;
    fxl_point target = fuzz_point(in, FXL_COORDINATE_MAX);
    const uint32_t kind = fuzz_below(in, 8);
    if (kind < 2) { /* straight up or down, or nowhere */
        target.x = pose.position.x;
        target.z = pose.position.z;
        target.y = kind == 0 ? pose.position.y : target.y;
    } else if (kind == 2) {
        target.y = fuzz_any(in);
    }
    before = pose;
    const fxl_status status = fxl_pose_look_at(&pose, &target);
    DEMAND(status == FXL_OK || memcmp(&pose, &before, sizeof pose) == 0);
    DEMAND(pose.roll == before.roll);
    record_bytes(&pose, sizeof pose);
    DEMAND(pose.pitch <= FXL_ANGLE_QUARTER || pose.pitch >= 0u - FXL_ANGLE_QUARTER ||
           status != FXL_OK);
    DEMAND(fxl_pose_look_at(NULL, &target) == FXL_E_ARGUMENT);
}

static void scale_any(fuzz_input *in)
{
    fxl_motion_limits limits;
    limits.acceleration = fuzz_any(in);
    limits.friction = fuzz_between(in, 0, FXL_MOTION_MAX);
    limits.speed_max = fuzz_between(in, 0, FXL_MOTION_MAX);
    limits.turn = fuzz_below(in, FXL_ANGLE_QUARTER + 2);
    fxl_motion_limits scaled = {-7, 0, 0, 0};
    const fxl_status status = fxl_scale_motion_limits(&limits, fuzz_any(in), &scaled);
    DEMAND((status == FXL_OK) == (scaled.acceleration >= 0));
    record_number(scaled.acceleration);
    record_number(scaled.friction);
    record_number(scaled.speed_max);
    DEMAND(fxl_scale_motion_limits(NULL, 0, &scaled) == FXL_E_ARGUMENT);
}

/* What a game's calls must refuse. */
static void demand_no_scene(void)
{
    const fxl_scene unchecked = {0};
    const fxl_point point = {0, 0, 0};
    fxl_motion_limits limits = {0, 0, 0, 0};
    fxl_pose pose = {{0, FXL_COORDINATE_MAX + 1, 0}, 0, 0, 0};
    fxl_sphere sphere = {{0, 0, 0}, FXL_SLIDE_RADIUS_MIN};
    fxl_screen_place place;
    fxl_view view;
    fxl_hit hit;
    view.frame = 0;
    DEMAND(fxl_find_on_screen(&view, &point, &place) == FXL_E_ORDER);
    DEMAND(fxl_find_on_screen(&view, NULL, &place) == FXL_E_ARGUMENT);
    DEMAND(fxl_find_on_screen(&view, &point, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_cast_segment(NULL, &point, &point, &hit) == FXL_E_ARGUMENT);
    DEMAND(fxl_cast_segment(&unchecked, NULL, &point, &hit) == FXL_E_ARGUMENT);
    DEMAND(fxl_cast_segment(&unchecked, &point, NULL, &hit) == FXL_E_ARGUMENT);
    DEMAND(fxl_cast_segment(&unchecked, &point, &point, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_cast_segment(&unchecked, &point, &point, &hit) == FXL_E_ORDER);
    DEMAND(fxl_cast_segment(&unchecked, &pose.position, &point, &hit) == FXL_E_ORDER);
    DEMAND(fxl_slide_sphere(&unchecked, &sphere, &point, NULL) == FXL_E_ORDER);
    DEMAND(fxl_slide_sphere(&unchecked, NULL, &point, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_slide_sphere(&unchecked, &sphere, NULL, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_pose_look_at(&pose, &point) == FXL_E_RANGE);
    DEMAND(fxl_pose_look_at(&pose, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_scale_motion_limits(&limits, 1, NULL) == FXL_E_ARGUMENT);
    limits.acceleration = FXL_MOTION_MAX;
    DEMAND(fxl_scale_motion_limits(&limits, 65537, &limits) == FXL_E_RANGE);
}

/* What overlaps overlaps from either side; what meets a segment meets a box about it. */
void fuzz_geometry(fuzz_input *in)
{
    demand_no_scene();
    for (uint32_t i = 0; i < 8 && (i == 0 || in->left > 0); i++) {
        const fxl_sphere a = any_sphere(in), b = any_sphere(in);
        const fxl_point from = fuzz_point(in, FXL_COORDINATE_MAX),
                        to = fuzz_point(in, FXL_COORDINATE_MAX);
        const fxl_box about = {{from.x < to.x ? from.x : to.x, from.y < to.y ? from.y : to.y,
                                from.z < to.z ? from.z : to.z},
                               {from.x < to.x ? to.x : from.x, from.y < to.y ? to.y : from.y,
                                from.z < to.z ? to.z : from.z}};
        const fxl_box point = {a.centre, a.centre};
        const bool meets = fxl_sphere_meets_segment(&a, &from, &to);
        DEMAND(fxl_spheres_overlap(&a, &b) == fxl_spheres_overlap(&b, &a));
        DEMAND(meets == fxl_sphere_meets_segment(&a, &to, &from));
        record_number(meets + 2 * fxl_spheres_overlap(&a, &b) +
                      4 * fxl_sphere_meets_box(&a, &about) + 8 * fxl_boxes_overlap(&about, &point));
        DEMAND(!meets || fxl_sphere_meets_box(&a, &about));
        DEMAND(fxl_boxes_overlap(&about, &point) == fxl_boxes_overlap(&point, &about));
        DEMAND(!fxl_boxes_overlap(&about, &point) || fxl_sphere_meets_box(&a, &about));
        look_at_any(in);
        scale_any(in);
    }
}

static const fxl_point origin = {0, 0, 0};

static fxl_point any_vector(fuzz_input *in)
{
    const fxl_q16_16 limit = (fxl_q16_16)1 << fuzz_below(in, 31);
    const fxl_point near = fuzz_point(in, limit < FXL_COORDINATE_MAX ? limit : FXL_COORDINATE_MAX);
    fxl_point any;
    any.x = fuzz_any(in);
    any.y = fuzz_any(in);
    any.z = fuzz_any(in);
    return fuzz_below(in, 4) ? near : any;
}

static void demand_made(fxl_status status, const fxl_orientation *o, const fxl_orientation *before)
{
    const fxl_placement placement = {*o, FXL_Q16_16_ONE};
    DEMAND(status == FXL_OK ? fxl_placement_check(&placement, &origin, 0) == FXL_OK
                            : memcmp(o, before, sizeof *o) == 0);
    record_bytes(o, sizeof *o);
}

/* An orientation by one of the functions, or of any numbers. */
static fxl_orientation any_orientation(fuzz_input *in)
{
    const fxl_orientation none = FXL_ORIENTATION_NONE;
    fxl_orientation o = none;
    const fxl_angle yaw = (fxl_angle)fuzz_bits(in, 4), pitch = (fxl_angle)fuzz_bits(in, 4);
    const fxl_point a = any_vector(in), b = any_vector(in);
    switch (fuzz_below(in, 4)) {
    case 0:
        demand_made(fxl_orientation_from_angles(yaw, pitch, (fxl_angle)fuzz_bits(in, 4), &o), &o,
                    &none);
        break;
    case 1:
        demand_made(fxl_orientation_from_axis(&a, yaw, &o), &o, &none);
        break;
    case 2:
        demand_made(fxl_orientation_look_at(&a, &b, &o), &o, &none);
        break;
    default:
        o.x.x += (fxl_q2_30)fuzz_bits(in, 1);
        o.y.z = fuzz_below(in, 2) ? fuzz_any(in) : 0;
        break;
    }
    return o;
}

/* There from any numbers, and back: w is not below 0, and the turn is nearly the same. */
static void fuzz_quaternion(const fxl_quaternion *given)
{
    const fxl_orientation none = FXL_ORIENTATION_NONE;
    const fxl_quaternion untouched = {1, 2, 3, 4};
    fxl_quaternion back = untouched;
    fxl_orientation o = none, again;
    const fxl_status status = fxl_orientation_from_quaternion(given, &o);
    demand_made(status, &o, &none);
    DEMAND(fxl_orientation_to_quaternion(&o, &back) == FXL_OK && back.w >= 0);
    DEMAND(fxl_orientation_from_quaternion(&back, &again) == FXL_OK);
    for (int i = 0; i < 9; i++) { /* numbers within 2 units move an entry by at most 4 sqrt(4) 2 */
        DEMAND(llabs((int64_t)(&o.x.x)[i] - (&again.x.x)[i]) <= 17);
    }
    record_bytes(&back, sizeof back);
    o.x.x = o.y.y = 0;
    o.z.z = given->w;
    back = untouched;
    DEMAND(fxl_orientation_to_quaternion(&o, &back) == FXL_OK ||
           memcmp(&back, &untouched, sizeof back) == 0);
}

void fuzz_orientations(fuzz_input *in)
{
    fxl_placement parent, child, placement, before = FXL_PLACEMENT_NONE;
    fxl_point centre = origin;
    parent.orientation = any_orientation(in);
    child.orientation = any_orientation(in);
    parent.scale = fuzz_below(in, 4) ? 1 + (fxl_q16_16)fuzz_bits(in, 2) : fuzz_any(in);
    child.scale = fuzz_below(in, 4) ? 256 + (fxl_q16_16)fuzz_bits(in, 2) : fuzz_any(in);
    placement = before;
    demand_made(
        fxl_orientation_multiply(&parent.orientation, &child.orientation, &placement.orientation),
        &placement.orientation, &before.orientation);
    const fxl_point at = any_vector(in), local = any_vector(in);
    placement = before;
    const fxl_status status =
        fxl_placement_attach(&at, &parent, &local, &child, &centre, &placement);
    record_bytes(&placement, sizeof placement);
    record_bytes(&centre, sizeof centre);
    if (status == FXL_OK) {
        DEMAND(fxl_placement_check(&placement, &centre, 0) == FXL_OK);
    } else {
        DEMAND(memcmp(&placement, &before, sizeof placement) == 0);
        DEMAND(memcmp(&centre, &origin, sizeof centre) == 0);
    }
    fuzz_quaternion(&(fxl_quaternion){at.x, at.y, local.x, local.y});
    DEMAND(fxl_placement_attach(&at, NULL, &local, &child, &centre, &placement) == FXL_E_ARGUMENT);
    DEMAND(fxl_orientation_look_at(&at, &local, NULL) == FXL_E_ARGUMENT);
    DEMAND(fxl_orientation_multiply(NULL, &child.orientation, &placement.orientation) ==
           FXL_E_ARGUMENT);
}
