/* SPDX-License-Identifier: MIT */
/* The walk against a board that is mocked: what it asks of a board, in which
 * order, and what it does when the board says no. */
#include <math.h>
#include <string.h>

#include "board_double.h"
#include "contract/system.h"
#include "draw/stages.h"
#include "fixel/all.h"
#include "mock_clock.h"
#include "mock_display.h"
#include "mock_input.h"
#include "mock_journal.h"
#include "mock_store.h"
#include "mock_system.h"
#include "reference/camera.h"
#include "scene_bytes.h"
#include "unity.h"
#include "walk.h"

#define UNIT  65536
#define BANDS 3 /* of 16, 16 and 8 rows: 1024 bytes hold 16 rows of 64 pixels */

static const fxl_pose poses[3] = {{{0, 0, 0}, 0, 0, 0},
                                  {{32768, 16384, 0}, 100000000, 50000000, 30000000},
                                  {{0, 0, -65536}, 0, 0, 0}};
static const fxl_path_segment strides[1] = {{FXL_KEY_FORWARD, 2}};

static scene_bytes scene;

fxl_status __real_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);
fxl_status __wrap_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band);

void setUp(void)
{
    scene_bytes_make(&scene, 1, poses, NULL, 3);
    board_double_begin(&scene);
}

void tearDown(void)
{
    TEST_ASSERT_FALSE_MESSAGE(board.display_is_open, "the display was left open");
}

static void assert_text(const char *part)
{
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(board.text, part), board.text);
}

static void assert_no_marker(void)
{
    TEST_ASSERT_NULL_MESSAGE(strstr(board.text, "done"), board.text);
}

/* What the library draws in one band. */
static void draw_whole(const fxl_pose *pose, uint8_t *pixels)
{
    static fxl_renderer renderer;
    fxl_draw_entry order[4];
    const fxl_memory memory = {order, 4, NULL, 0, NULL, 0};
    fxl_scene_image image;
    const fxl_band band = {.pixels = pixels,
                           .width = SCENE_WIDTH,
                           .stride = SCENE_WIDTH,
                           .first_row = 0,
                           .rows = SCENE_HEIGHT};

    TEST_ASSERT_EQUAL(FXL_OK, fxl_scene_open(scene.words, scene.size, &image, NULL));
    TEST_ASSERT_EQUAL(FXL_OK,
                      fxl_renderer_init_with(&renderer, &image.scene, &image.lens, &memory));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_frame_begin(&renderer, pose));
    fxl_fill_band(&band, image.background);
    TEST_ASSERT_EQUAL(FXL_OK, __real_fxl_frame_draw(&renderer, &band));
}

void test_every_row_of_every_frame_is_flushed_once_and_downward(void)
{
    uint32_t frame, row;

    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(3, board.announced);
    TEST_ASSERT_EQUAL(3, board.begun);
    TEST_ASSERT_EQUAL(3, board.ended);
    TEST_ASSERT_EQUAL(3 * BANDS, board.flushes);
    TEST_ASSERT_EQUAL(3 * BANDS, board.alive);
    for (frame = 0; frame < 3; frame++) {
        for (row = 0; row < SCENE_HEIGHT; row++) {
            TEST_ASSERT_EQUAL(1, board.times_covered[frame][row]);
        }
        TEST_ASSERT_EQUAL_MEMORY(&poses[frame], &board.poses[frame], sizeof poses[frame]);
        TEST_ASSERT_EQUAL(1, board.counters[frame].in);
    }
    TEST_ASSERT_EQUAL_STRING("walk: done 3 frames\n", board.text);
}

void test_bands_together_are_the_frame_that_one_band_gives(void)
{
    uint8_t whole[SCENE_HEIGHT][SCENE_WIDTH];
    uint32_t frame;

    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    for (frame = 0; frame < 3; frame++) {
        draw_whole(&poses[frame], whole[0]);
        TEST_ASSERT_EQUAL_MEMORY(whole, board.pixels[frame], sizeof whole);
    }
    TEST_ASSERT_EQUAL(SCENE_COLOUR, board.pixels[0][SCENE_HEIGHT / 2][SCENE_WIDTH / 2]);
    TEST_ASSERT_EQUAL(SCENE_BACKGROUND, board.pixels[0][0][0]);
}

/* What fxl_frame_draw was asked for in the frame that is being drawn: how often each pixel of it, and
 * the first column of the last rectangle. */
static uint8_t times_asked[FRAMES_MAX][SCENE_HEIGHT][SCENE_WIDTH];
static uint32_t calls[FRAMES_MAX], borders[FRAMES_MAX];

fxl_status __wrap_fxl_frame_draw(fxl_renderer *renderer, const fxl_band *band)
{
    const uint32_t frame = board.begun > 0 ? board.begun - 1 : 0;
    const uint32_t columns = band->columns > 0 ? band->columns : band->width;
    uint32_t row, column;

    calls[frame]++;
    borders[frame] = band->first_column;
    for (row = 0; row < band->rows; row++) {
        for (column = 0; column < columns; column++) {
            times_asked[frame][band->first_row + row][band->first_column + column]++;
        }
    }
    return __real_fxl_frame_draw(renderer, band);
}

/* Frames 3 and 7 of eight; none of a live walk. */
void test_every_fourth_frame_is_two_rectangles_whose_border_moves(void)
{
    static const fxl_pose still[FRAMES_MAX];
    uint8_t whole[SCENE_HEIGHT][SCENE_WIDTH], once[SCENE_HEIGHT][SCENE_WIDTH];
    uint32_t frame;
    int live;

    scene_bytes_make(&scene, 1, still, NULL, FRAMES_MAX);
    memset(once, 1, sizeof once);
    for (live = 0; live < 2; live++) {
        board_double_begin(&scene);
        board.live = live;
        board.frames_asked = FRAMES_MAX;
        board.clock_step = 100;
        memset(times_asked, 0, sizeof times_asked);
        memset(calls, 0, sizeof calls);
        TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
        for (frame = 0; frame < FRAMES_MAX; frame++) {
            const bool parted = live == 0 && frame % 4 == 3;

            TEST_ASSERT_EQUAL(parted ? 2 * BANDS : BANDS, calls[frame]);
            TEST_ASSERT_EQUAL(parted, borders[frame] > 0);
            TEST_ASSERT_EQUAL_UINT64(parted ? 0 : 100 * (1 + BANDS), board.instructions[frame]);
            TEST_ASSERT_EQUAL_MEMORY(once, times_asked[frame], sizeof once);
            draw_whole(&board.poses[frame], whole[0]);
            TEST_ASSERT_EQUAL_MEMORY(whole, board.pixels[frame], sizeof whole);
        }
        TEST_ASSERT_TRUE(live == 1 || borders[3] != borders[7]);
    }
}

void test_as_many_frames_as_asked(void)
{
    board.frames_asked = 2;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(2, board.announced);
    TEST_ASSERT_EQUAL(2, board.ended);
    TEST_ASSERT_EQUAL(0, board.keys_read);
    assert_text("walk: done 2 frames\n");
}

void test_keys_drive_the_viewer_once_the_path_has_ended(void)
{
    scene_bytes_make(&scene, 1, NULL, strides, 1);
    board.frames_asked = 4;
    board.keys = FXL_KEY_RIGHT;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(2, board.keys_read);
    TEST_ASSERT_EQUAL_HEX32(0, board.poses[1].yaw);
    TEST_ASSERT_GREATER_THAN(board.poses[0].position.z, board.poses[1].position.z);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER / 16, board.poses[2].yaw);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER / 8, board.poses[3].yaw);
}

/* A key that bounces is down in one frame and up in the next. */
void test_keys_that_change_every_frame_give_the_steps_of_the_twin(void)
{
    static const uint32_t keys[FRAMES_MAX] = {FXL_KEY_FORWARD,
                                              FXL_KEY_FORWARD | FXL_KEY_LEFT,
                                              0,
                                              FXL_KEY_FORWARD | FXL_KEY_BACK,
                                              FXL_KEY_RIGHT | FXL_KEY_PITCH_UP,
                                              FXL_KEY_ALL,
                                              FXL_KEY_BACK | FXL_KEY_ROLL_LEFT,
                                              FXL_KEY_FORWARD | FXL_KEY_RIGHT};
    const fxl_pose *start = &poses[0];
    const ref_pose from = {{start->position.x, start->position.y, UNIT / 2}, 0, 0, 0};
    const ref_motion_limits motion_limits = {1.0 / 4, 1.0 / 16, 1.0, FXL_ANGLE_QUARTER / 16};
    ref_player reference = ref_player_at(&from);
    uint32_t frame;

    board.live = true;
    board.frames_asked = FRAMES_MAX;
    board.keys_of_frame = keys;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(FRAMES_MAX, board.keys_read);
    for (frame = 0; frame < FRAMES_MAX; frame++) {
        const fxl_pose *pose = &board.poses[frame];

        ref_player_step(&reference, keys[frame], &motion_limits);
        TEST_ASSERT_EQUAL_HEX32(reference.yaw, pose->yaw);
        TEST_ASSERT_EQUAL_HEX32(reference.pitch, pose->pitch);
        TEST_ASSERT_EQUAL_HEX32(reference.roll, pose->roll);
        /* A step rounds once. */
        TEST_ASSERT_TRUE(fabs(reference.position.x * UNIT - pose->position.x) <= frame + 1);
        TEST_ASSERT_TRUE(fabs(reference.position.z * UNIT - pose->position.z) <= frame + 1);
    }
    TEST_ASSERT_NOT_EQUAL(0, board.poses[FRAMES_MAX - 1].position.x);
}

void test_a_live_walk_reads_the_keys_for_every_frame(void)
{
    board.live = true;
    board.keys = FXL_KEY_LEFT;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(3, board.keys_read);
    TEST_ASSERT_EQUAL_HEX32(0u - FXL_ANGLE_QUARTER / 16, board.poses[0].yaw);
}

void test_a_sign_of_life_for_every_frame(void)
{
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL(3 * BANDS, board.alive);
}

void test_only_the_renderer_is_counted(void)
{
    board.clock_step = 100;
    board.flush_cost = 1000000;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    /* One difference for the beginning of the frame and one a band. */
    TEST_ASSERT_EQUAL_UINT64(100 * (1 + BANDS), board.instructions[0]);
    TEST_ASSERT_EQUAL_UINT64(100 * (1 + BANDS), board.instructions[2]);
}

void test_instructions_beyond_32_bits(void)
{
    board.clock_step = 3000000000u;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_EQUAL_UINT64((uint64_t)3000000000u * (1 + BANDS), board.instructions[1]);
}

void test_a_clock_that_stands_still_counts_nothing(void)
{
    board.clock = 123456;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
    TEST_ASSERT_GREATER_THAN(0, board.clock_read);
    TEST_ASSERT_EQUAL_UINT64(0, board.instructions[0]);
    TEST_ASSERT_EQUAL_UINT64(0, board.instructions[2]);
}

void test_a_clock_that_runs_backward_spoils_the_count_of_its_frame_alone(void)
{
    const uint32_t readings = 2 * (1 + BANDS); /* in a frame */
    uint32_t reading;

    for (reading = 1; reading < readings; reading += 2) {
        board_double_begin(&scene);
        board.clock = 1000000;
        board.clock_step = 100;
        board.clock_backward = readings + reading;
        TEST_ASSERT_EQUAL(SYSTEM_EXIT_DONE, walk());
        TEST_ASSERT_EQUAL_UINT64(100 * (1 + BANDS), board.instructions[0]);
        TEST_ASSERT_EQUAL_UINT64(0, board.instructions[1]);
        TEST_ASSERT_EQUAL_UINT64(100 * (1 + BANDS), board.instructions[2]);
    }
}

void test_a_partition_that_ends_within_the_scene(void)
{
    static const size_t sizes[] = {0, 4, 159, 160};
    size_t i;

    for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        board_double_begin(&scene);
        board.scene_size = sizes[i];
        TEST_ASSERT_EQUAL(SYSTEM_EXIT_SCENE, walk());
        TEST_ASSERT_EQUAL(0, board.announced);
        assert_text("walk: scene refused");
    }
}

void test_a_board_without_a_scene(void)
{
    board.scene = NULL;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_STORE, walk());
    TEST_ASSERT_FALSE(board.display_was_opened);
    assert_text("no scene");
}

void test_a_damaged_scene_is_refused_before_anything_is_shown(void)
{
    scene.words[50] ^= 1u << 7;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_SCENE, walk());
    TEST_ASSERT_FALSE(board.display_was_opened);
    TEST_ASSERT_EQUAL(0, board.announced);
    assert_text(fxl_status_text(FXL_E_CRC));
    assert_no_marker();
}

void test_an_erased_partition_is_refused(void)
{
    memset(scene.words, 0xFF, sizeof scene.words);
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_SCENE, walk());
    assert_text(fxl_status_text(FXL_E_MAGIC));
}

void test_a_scene_that_needs_more_memory_says_how_much(void)
{
    scene_bytes_make(&scene, 5, poses, NULL, 3);
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_CAPACITY, walk());
    TEST_ASSERT_FALSE(board.display_was_opened);
    assert_text("needs 5 order entries, this board has 4");
}

void test_a_journal_that_refuses(void)
{
    board.refuse_journal = true;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_JOURNAL, walk());
    TEST_ASSERT_FALSE(board.display_was_opened);
    assert_no_marker();
}

void test_a_display_that_refuses(void)
{
    board.refuse_display = true;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DISPLAY, walk());
    TEST_ASSERT_EQUAL(0, board.begun);
    assert_text("display");
    assert_no_marker();
}

void test_a_display_that_loses_pixels_ends_the_walk(void)
{
    board.refuse_flush = BANDS + 1; /* the second band of the second frame */
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DISPLAY, walk());
    TEST_ASSERT_EQUAL(BANDS + 2, board.flushes);
    TEST_ASSERT_EQUAL(1, board.ended);
    assert_text("in frame 1\n");
    assert_no_marker();
}

void test_a_display_that_fails_at_the_end(void)
{
    board.refuse_close = true;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_DISPLAY, walk());
    assert_no_marker();
}

void test_a_pose_that_cannot_be_noted(void)
{
    board.refuse_begin = 1;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_JOURNAL, walk());
    TEST_ASSERT_EQUAL(BANDS, board.flushes);
    assert_text("in frame 1\n");
    assert_no_marker();
}

void test_counters_that_cannot_be_noted(void)
{
    board.refuse_end = 2;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_JOURNAL, walk());
    assert_text("in frame 2\n");
    assert_no_marker();
}

void test_keys_that_do_not_exist(void)
{
    board.live = true;
    board.keys = FXL_KEY_ALL + 1u;
    TEST_ASSERT_EQUAL(SYSTEM_EXIT_INPUT, walk());
    TEST_ASSERT_EQUAL(0, board.begun);
    assert_no_marker();
}
