/* SPDX-License-Identifier: MIT */
/* A world against a plain model of it: a list of instances that is searched. */
#include "world_unit.h"

enum {
    STALE = 6,
    ROUND = UNIT_REPEAT / 200 /* operations from frame to frame */
};

static fxl_renderer plain_renderer;

/* --- the plain model ------------------------------------------------------------------- */

typedef struct {
    bool used, shown, turned;
    fxl_instance instance;
    fxl_placement placement;
    fxl_handle handle;
} plain_instance;

static plain_instance plain[WORLD_PLACES];
static fxl_handle stale[STALE];
static uint32_t refused;

static uint32_t plain_count(bool turned)
{
    uint32_t count = 0;
    for (int i = 0; i < WORLD_PLACES; i++) {
        count += plain[i].used && plain[i].turned == turned;
    }
    return count;
}

static plain_instance *any_plain(bool used)
{
    for (uint32_t i = unit_random() % WORLD_PLACES, left = WORLD_PLACES; left > 0; left--) {
        if (plain[i].used == used) {
            return &plain[i];
        }
        i = (i + 1) % WORLD_PLACES;
    }
    return NULL;
}

/* A point near the eye, or near the edge of the world. */
static fxl_point any_centre(void)
{
    fxl_point centre = {unit_between(Q16(-20), Q16(20)), unit_between(Q16(-8), Q16(8)),
                        unit_between(Q16(2), Q16(40))};
    if (unit_between(0, 9) == 0) {
        int32_t *const of[] = {&centre.x, &centre.y, &centre.z};
        const int32_t far_away = unit_between(FXL_COORDINATE_MAX - Q16(8), FXL_COORDINATE_MAX);
        *of[unit_between(0, 2)] = unit_between(0, 1) ? far_away : -far_away;
    }
    return centre;
}

/* Three rotations, of which one is out of range at times. */
static fxl_placement any_placement(fxl_status *fault)
{
    static const fxl_orientation orientations[] = {
        {{FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}, {0, 0, FXL_Q2_30_ONE}},
        {{0, 0, FXL_Q2_30_ONE}, {FXL_Q2_30_ONE, 0, 0}, {0, FXL_Q2_30_ONE, 0}},
        {{644245094, -858993459, 0}, {858993459, 644245094, 0}, {0, 0, FXL_Q2_30_ONE}},
        {{0, -FXL_Q2_30_ONE, 0}, {0, 0, -FXL_Q2_30_ONE}, {FXL_Q2_30_ONE, 0, 0}}};
    fxl_placement placement = {orientations[unit_between(0, 3)], unit_between(Q16(1), Q16(4))};
    const int wrong = unit_between(0, 39);
    if (wrong == 0) { /* a mirror */
        placement.orientation.z.x = -placement.orientation.z.x;
        placement.orientation.z.y = -placement.orientation.z.y;
        placement.orientation.z.z = -placement.orientation.z.z;
    } else if (wrong == 1) {
        placement.orientation.y.y += 8;
        placement.orientation.y.x += 8;
        placement.orientation.y.z += 8;
    } else if (wrong == 2) {
        placement.scale = unit_between(0, 1) ? -unit_between(0, 255) : unit_between(0, 255);
    } else if (wrong == 3) {
        placement.scale = Q16(256) + 1;
    }
    *fault = wrong < 2 ? FXL_E_PLACEMENT : wrong < 4 ? FXL_E_RANGE : FXL_OK;
    return placement;
}

/* Whether |c| + r * scale <= 8191, in units of 2^-32; r * scale is rounded up, and enlarged. */
static bool fits(const fxl_instance *instance, const fxl_placement *placement)
{
    const int64_t reach =
        placement == NULL
            ? (int64_t)TINY_RADIUS * 65536
            : (((int64_t)TINY_RADIUS * placement->scale + 65535) / 65536 + FXL_PLACEMENT_SLACK) *
                  65536;
    const int32_t of[] = {instance->centre.x, instance->centre.y, instance->centre.z};
    for (int i = 0; i < 3; i++) {
        const int64_t from = of[i] < 0 ? -(int64_t)of[i] : of[i];
        if (from * 65536 + reach > (int64_t)FXL_COORDINATE_MAX * 65536) {
            return false;
        }
    }
    return true;
}

/* The status of an instance at its place, with a placement that has a fault, or none. */
static fxl_status place_status(const fxl_instance *instance, const fxl_placement *placement,
                               fxl_status fault)
{
    return fault == FXL_E_RANGE || !fits(instance, placement) ? FXL_E_RANGE : fault;
}

/* Counts what is refused. */
static void expect(fxl_status expected, fxl_status found)
{
    TEST_ASSERT_EQUAL(expected, found);
    refused += expected != FXL_OK;
}

static const fxl_placement *placement_of(const plain_instance *of)
{
    return of->turned ? &of->placement : NULL;
}

/* --- operations on both ----------------------------------------------------------------- */

static void spawn_one(void)
{
    fxl_status fault = FXL_OK;
    const bool turned = unit_between(0, 2) == 0;
    plain_instance made;
    memset(&made, 0, sizeof made);
    made.used = made.shown = true;
    made.turned = turned;
    made.instance.centre = any_centre();
    made.instance.model = (uint16_t)unit_between(0, 30) % 3; /* model 2 is none */
    made.instance.layer = (uint8_t)unit_between(0, 1);
    if (turned) {
        made.placement = any_placement(&fault);
    }
    const bool full = plain_count(turned) == (turned ? WORLD_TURNED : WORLD_CAPACITY);
    const fxl_status expected = full ? FXL_E_CAPACITY
                                : made.instance.model > 1
                                    ? FXL_E_INDEX
                                    : place_status(&made.instance, placement_of(&made), fault);
    expect(expected, fxl_world_spawn(&world, &made.instance, placement_of(&made), &made.handle));
    if (expected == FXL_OK) {
        *any_plain(false) = made;
    }
}

static void remove_one(plain_instance *of)
{
    expect(FXL_OK, fxl_world_remove(&world, of->handle));
    stale[unit_random() % STALE] = of->handle;
    of->used = false;
}

static void move_one(plain_instance *of)
{
    plain_instance changed = *of;
    changed.instance.centre = any_centre();
    const bool right = fits(&changed.instance, placement_of(of));
    expect(right ? FXL_OK : FXL_E_RANGE,
           fxl_world_move(&world, of->handle, &changed.instance.centre));
    *of = right ? changed : *of;
}

static void place_one(plain_instance *of)
{
    plain_instance changed = *of;
    fxl_status fault = FXL_OK;
    changed.turned = unit_between(0, 2) > 0;
    if (changed.turned) {
        changed.placement = any_placement(&fault);
    }
    const bool full =
        changed.turned != of->turned &&
        plain_count(changed.turned) == (changed.turned ? WORLD_TURNED : WORLD_CAPACITY);
    const fxl_status status = place_status(&of->instance, placement_of(&changed), fault);
    const bool right = status == FXL_OK;
    expect(!right ? status
           : full ? FXL_E_CAPACITY
                  : FXL_OK,
           fxl_world_set_placement(&world, of->handle, placement_of(&changed)));
    *of = right && !full ? changed : *of;
}

static void change_one(plain_instance *of)
{
    const uint8_t value = (uint8_t)unit_between(0, 3);
    switch (unit_between(0, 2)) {
    case 0:
        expect(value > 1                               ? FXL_E_INDEX
               : fits(&of->instance, placement_of(of)) ? FXL_OK
                                                       : FXL_E_RANGE,
               fxl_world_set_model(&world, of->handle, value));
        of->instance.model = value > 1 ? of->instance.model : value;
        break;
    case 1:
        expect(FXL_OK, fxl_world_set_layer(&world, of->handle, value));
        of->instance.layer = value;
        break;
    default:
        expect(value > 2 ? FXL_E_INDEX : FXL_OK, fxl_world_recolour(&world, of->handle, value));
        of->instance.recolour = value > 2 ? of->instance.recolour : value;
        break;
    }
}

static void show_one(plain_instance *of)
{
    of->shown = unit_between(0, 1);
    expect(FXL_OK,
           of->shown ? fxl_world_show(&world, of->handle) : fxl_world_hide(&world, of->handle));
}

static void do_any(void)
{
    plain_instance *of = any_plain(true);
    const int what = unit_between(0, 9);
    if (of == NULL || what < 2) {
        spawn_one();
    } else if (what == 2) {
        remove_one(of);
    } else if (what < 5) {
        show_one(of);
    } else if (what < 7) {
        move_one(of);
    } else if (what == 7) {
        place_one(of);
    } else if (what == 8) {
        change_one(of);
    } else {
        refused += world_use_stale(stale[unit_random() % STALE]);
    }
}

/* --- comparison -------------------------------------------------------------------------- */

static void expect_equal_instance(const plain_instance *of)
{
    const fxl_instance *found = fxl_world_instance(&world, of->handle);
    const fxl_placement *placement = fxl_world_placement(&world, of->handle);
    TEST_ASSERT_NOT_NULL(found);
    TEST_ASSERT_EQUAL_MEMORY(&of->instance, found, sizeof *found);
    TEST_ASSERT_EQUAL(of->turned, placement != NULL);
    if (placement != NULL) {
        TEST_ASSERT_EQUAL_MEMORY(&of->placement, placement, sizeof *placement);
    }
    const fxl_instance *first = world.scene.instances;
    const bool in_scene = found >= first && found < first + world.scene.instance_count;
    TEST_ASSERT_EQUAL(of->shown, in_scene);
    if (in_scene) {
        const fxl_handle handle = fxl_world_handle_at(&world, (uint32_t)(found - first));
        TEST_ASSERT_EQUAL_MEMORY(&of->handle, &handle, sizeof handle);
    }
    TEST_ASSERT_EQUAL(of->shown, fxl_world_is_shown(&world, of->handle));
    if (in_scene && of->turned) { /* the placement is that of its place in the scene */
        TEST_ASSERT_TRUE(placement ==
                         world.scene.placements + (found - first) - world.scene.first_turned);
    } else if (in_scene) {
        TEST_ASSERT_TRUE(world.scene.placements == NULL ||
                         found < first + world.scene.first_turned);
    }
}

static void expect_equal(void)
{
    uint32_t shown = 0;
    for (int i = 0; i < WORLD_PLACES; i++) {
        if (plain[i].used) {
            expect_equal_instance(&plain[i]);
            shown += plain[i].shown;
        }
    }
    TEST_ASSERT_EQUAL_UINT32(shown, world.scene.instance_count);
    const fxl_handle none = fxl_world_handle_at(&world, shown);
    TEST_ASSERT_TRUE(none.slot == 0 && none.generation == 0);
    TEST_ASSERT_EQUAL_UINT32(refused, world.refused_calls);
}

/* A scene made anew of what the plain model shows: those without a placement, then the others. */
static uint32_t make_anew(fxl_scene *scene, fxl_instance *list, fxl_placement *placement_list)
{
    uint32_t count = 0, turned = 0;
    for (int with_placement = 0; with_placement < 2; with_placement++) {
        for (int i = 0; i < WORLD_PLACES; i++) {
            if (plain[i].used && plain[i].shown && plain[i].turned == with_placement) {
                list[count] = plain[i].instance;
                list[count++].recolour = 0;
                placement_list[turned] = plain[i].placement;
                turned += (uint32_t)with_placement;
            }
        }
    }
    scene->instances = list;
    scene->instance_count = count;
    scene->placements = turned > 0 ? placement_list : NULL;
    scene->first_turned = turned > 0 ? count - turned : 0;
    scene->placement_code = &fxl_turned_instances;
    return count;
}

/* Returns whether there was something to see. */
static bool expect_equal_frames(const fxl_scene *from)
{
    static fxl_instance list[WORLD_PLACES];
    static fxl_placement placement_list[WORLD_TURNED + 1];
    const fxl_lens lens = unit_lens(WORLD_WIDTH, WORLD_HEIGHT);
    const fxl_memory room = world_renderer_memory(1);
    const fxl_pose pose = {{unit_between(-65536, 65536), 0, Q16(-4)}, 0, 0, unit_random()};
    fxl_scene scene = *from;
    scene.draw_list_needed = 0;
    world_draw(&world_renderer, &pose, world_frames[0]);
    if (make_anew(&scene, list, placement_list) == 0) {
        TEST_ASSERT_EACH_EQUAL_HEX8(WORLD_BACKGROUND, world_frames[0], sizeof world_frames[0]);
        return false;
    }
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_check(&scene, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_renderer_init_with(&plain_renderer, &scene, &lens, &room));
    world_draw(&plain_renderer, &pose, world_frames[1]);
    TEST_ASSERT_EQUAL_MEMORY(world_frames[1], world_frames[0], sizeof world_frames[0]);
    TEST_ASSERT_EQUAL_MEMORY(&plain_renderer.workspace.counters, &world_renderer.workspace.counters,
                             sizeof(fxl_counters));
    return world_renderer.workspace.counters.drawn > 0;
}

static void plain_from(const fxl_scene *scene)
{
    memset(plain, 0, sizeof plain);
    memset(stale, 0, sizeof stale);
    refused = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        plain[i].used = plain[i].shown = true;
        plain[i].instance = scene->instances[i];
        plain[i].handle = fxl_world_handle(i);
    }
}

/* world 1.5, 1.2a, 1.3a-d */
void test_a_world_is_its_plain_model(void)
{
    uint32_t drawn = 0, most = 0, rounds = 0;
    tiny_scene *tiny = world_start();
    plain_from(&tiny->scene);
    for (uint32_t done = 0; done < UNIT_REPEAT; done++) {
        do_any();
        if (done % 16 == 0) {
            expect_equal();
        }
        if (done % ROUND == 0) {
            rounds++;
            drawn += expect_equal_frames(&tiny->scene);
        }
        const uint32_t count = plain_count(false) + plain_count(true);
        most = count > most ? count : most;
    }
    TEST_ASSERT_EQUAL(WORLD_PLACES, most);
    TEST_ASSERT_TRUE(drawn > rounds / 2 && refused > UNIT_REPEAT / 20);
}
