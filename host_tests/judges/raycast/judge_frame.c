/* SPDX-License-Identifier: MIT */
#include "judge_frame.h"

#include "file.h"

#include <math.h>
#include <string.h>

/* An edge within this distance, in pixels, explains a different colour. */
#define NEARNESS (1.0 / 64.0)
#define RINGS    4
#define SPOKES   32

/* Turns a vector in the plane of two of its components: a vector along `from` then points an
 * angle further towards `towards`. */
static void turn(double *from, double *towards, double cosine, double sine)
{
    double a = *from, b = *towards;
    *from = a * cosine - b * sine;
    *towards = a * sine + b * cosine;
}

typedef struct {
    const scene *s;
    vector eye;
    double cosine[3], sine[3]; /* yaw, pitch, roll */
} viewpoint;

static viewpoint viewpoint_of(const scene *s, const dump_frame *frame)
{
    viewpoint v = {.s = s, .eye = frame->eye};
    double angles[3] = {frame->yaw, frame->pitch, frame->roll};
    for (int i = 0; i < 3; i++) {
        v.cosine[i] = cos(angles[i]);
        v.sine[i] = sin(angles[i]);
    }
    return v;
}

/* The camera was turned by yaw, then, in its own frame, by pitch, then by roll. So a vector in the
 * camera's frame is transformed into the world by roll first and yaw last. */
static vector in_world(const viewpoint *v, vector along)
{
    turn(&along.x, &along.y, v->cosine[2], v->sine[2]); /* the right side towards the up side */
    turn(&along.z, &along.y, v->cosine[1], v->sine[1]); /* forward towards up */
    turn(&along.z, &along.x, v->cosine[0], v->sine[0]); /* forward from +z towards +x */
    return along;
}

/* Makes the ray through a point of the screen. */
static world_ray ray_through(const viewpoint *v, double x, double y)
{
    const double right = x - v->s->centre_x, up = v->s->centre_y - y, scale = v->s->scale;
    if (scale != 0) { /* all rays are parallel */
        const vector beside = in_world(v, (vector){right / scale, up / scale, 0});
        return (world_ray){vector_plus(v->eye, beside), in_world(v, (vector){0, 0, 1}), v->s->near,
                           v->s->far};
    }
    return (world_ray){v->eye, in_world(v, (vector){right / v->s->focal, up / v->s->focal, 1}),
                       v->s->near, v->s->far};
}

/* What is seen by a ray that meets nothing. */
static uint8_t colour_behind(const scene *s, const world_ray *ray)
{
    const double sine = ray->direction.y / sqrt(vector_dot(ray->direction, ray->direction));
    uint32_t level = 0;
    while (level < s->horizon.count && get_i32(s->horizon.at + 4 * level) / 1073741824.0 <= sine)
        level++;
    return s->horizon.count ? s->levels.at[level] : s->background;
}

static uint8_t colour_of(const scene *s, const world_ray *ray, world_hit hit)
{
    return hit.found ? hit.colour : colour_behind(s, ray);
}

static bool shows(const viewpoint *v, double x, double y, uint8_t colour)
{
    world_ray ray = ray_through(v, x, y);
    world_hit hit = world_nearest(&v->s->world, &ray, NULL);
    return colour_of(v->s, &ray, hit) == colour || (hit.found && world_shows(&v->s->world, &ray, colour));
}

/* accuracy 4.4 */
static bool explained(const viewpoint *v, double x, double y, uint8_t colour)
{
    for (int ring = 1; ring <= RINGS; ring++)
        for (int spoke = 0; spoke < SPOKES; spoke++) {
            double radius = NEARNESS * ring / RINGS;
            double angle = spoke * (2 * acos(-1.0) / SPOKES);
            if (shows(v, x + radius * cos(angle), y + radius * sin(angle), colour))
                return true;
        }
    return false;
}

/* accuracy 4.4 */
void judge_frame(scene *s, const dump_frame *frame, verdict *v, uint8_t *pixels)
{
    viewpoint view = viewpoint_of(s, frame);
    scene_light(s, view.eye, ray_through(&view, s->width / 2.0, s->height / 2.0).direction);
    memset(v, 0, sizeof *v);
    const world_polygon *guess = NULL; /* what the ray before met */
    for (uint32_t j = 0; j < s->height; j++)
        for (uint32_t i = 0; i < s->width; i++) {
            double x = i + 0.5, y = j + 0.5;
            uint8_t reference = frame->pixels[(size_t)j * s->width + i];
            world_ray ray = ray_through(&view, x, y);
            world_hit hit = world_nearest(&s->world, &ray, guess);
            guess = hit.polygon;
            uint8_t seen = colour_of(s, &ray, hit);
            if (pixels)
                pixels[(size_t)j * s->width + i] = seen;
            if (seen == reference || world_shows(&s->world, &ray, reference))
                continue;
            v->differing++;
            if (explained(&view, x, y, reference))
                continue;
            if (v->unexplained < EXAMPLES)
                v->examples[v->unexplained] = (example){i, j, reference, seen};
            v->unexplained++;
        }
}
