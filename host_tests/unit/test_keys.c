/* SPDX-License-Identifier: MIT */
/* Buttons: bounce, the start, and what they mean. */
#include "parts/keys.h"
#include "unit.h"

static keys_debouncer keys;
static uint32_t now;

void setUp(void)
{
    memset(&keys, 0, sizeof keys);
    now = 0;
}

/* Readings a millisecond apart, one a letter: '#' down, '.' up. Answers what
 * was believed after each, in the same letters. */
static const char *believed(uint32_t button, const char *readings)
{
    static char answer[64];
    uint32_t i;

    for (i = 0; readings[i] != '\0'; i++) {
        const uint32_t held = keys_debounce(&keys, readings[i] == '#' ? button : 0, now);

        TEST_ASSERT_EQUAL_HEX32(0, held & ~button);
        answer[i] = held != 0 ? '#' : '.';
        now++;
    }
    answer[i] = '\0';
    return answer;
}

/* How often a button went down in a row of letters that began with it up. */
static uint32_t presses(const char *letters)
{
    uint32_t count = letters[0] == '#';

    for (; letters[0] != '\0'; letters++) {
        count += letters[0] == '.' && letters[1] == '#';
    }
    return count;
}

void test_a_button_is_believed_when_it_was_down_for_long_enough(void)
{
    TEST_ASSERT_EQUAL_STRING("...........####", believed(KEYS_LEFT, "......#########"));
}

void test_and_let_go_when_it_was_up_for_long_enough(void)
{
    (void)believed(KEYS_LEFT, "......#########");
    TEST_ASSERT_EQUAL_STRING("#####....", believed(KEYS_LEFT, "........."));
}

void test_a_bounce_that_is_short_is_nothing(void)
{
    TEST_ASSERT_EQUAL_STRING("................", believed(KEYS_UP, "......##..#.###."));
}

void test_bounces_at_both_ends_of_a_press_are_one_press(void)
{
    const char *answer = believed(KEYS_SELECT, "......#.#..##.##########.#.##..#..#..........");

    TEST_ASSERT_EQUAL(1, presses(answer));
    TEST_ASSERT_EQUAL_STRING("...................#####################.....", answer);
}

void test_readings_that_are_far_apart_must_agree_all_the_same(void)
{
    uint32_t i;

    (void)believed(KEYS_UP, "......");
    for (i = 0; i < KEYS_READINGS - 1u; i++) {
        now += 40;
        TEST_ASSERT_EQUAL(0, keys_debounce(&keys, KEYS_UP, now));
    }
    now += 40;
    TEST_ASSERT_EQUAL(KEYS_UP, keys_debounce(&keys, KEYS_UP, now));
}

void test_readings_that_are_close_together_must_last_all_the_same(void)
{
    uint32_t i;

    (void)believed(KEYS_UP, "......");
    for (i = 0; i < 100; i++) {
        TEST_ASSERT_EQUAL(0, keys_debounce(&keys, KEYS_UP, now));
    }
}

void test_a_button_that_is_down_from_the_start_is_not_believed_before_it_was_up(void)
{
    TEST_ASSERT_EQUAL_STRING("....................", believed(KEYS_RIGHT, "####################"));
    TEST_ASSERT_EQUAL_STRING("..........", believed(KEYS_RIGHT, "..########")); /* up too shortly */
    TEST_ASSERT_EQUAL_STRING("......", believed(KEYS_RIGHT, "......"));
    TEST_ASSERT_EQUAL_STRING(".....##", believed(KEYS_RIGHT, "#######"));
}

void test_buttons_do_not_disturb_each_other(void)
{
    uint32_t i, held = 0;

    (void)believed(KEYS_UP, "......");
    for (i = 0; i < 20; i++) {
        held = keys_debounce(&keys, KEYS_UP | (i % 2 != 0 ? KEYS_DOWN : 0), now++);
    }
    TEST_ASSERT_EQUAL(KEYS_UP, held);
}

void test_time_may_wrap(void)
{
    now = 0xFFFFFFFCu;
    TEST_ASSERT_EQUAL_STRING("...........###", believed(KEYS_DOWN, "......########"));
}

/* Any noise whose quiet stretches are shorter than it takes. */
void test_noise_is_never_believed(void)
{
    uint32_t i;

    (void)believed(KEYS_UP, "......");
    for (i = 0; i < 2000; i++) {
        const uint32_t down = (uint32_t)unit_between(1, (int32_t)KEYS_SETTLE);
        const uint32_t up = (uint32_t)unit_between(1, 9);
        uint32_t j;

        for (j = 0; j < down + up; j++) {
            TEST_ASSERT_EQUAL(0, keys_debounce(&keys, j < down ? KEYS_UP : 0, now++));
        }
    }
}

void test_the_arrows_walk_and_turn(void)
{
    TEST_ASSERT_EQUAL(0, keys_meaning(0));
    TEST_ASSERT_EQUAL(FXL_KEY_FORWARD, keys_meaning(KEYS_UP));
    TEST_ASSERT_EQUAL(FXL_KEY_BACK, keys_meaning(KEYS_DOWN));
    TEST_ASSERT_EQUAL(FXL_KEY_LEFT, keys_meaning(KEYS_LEFT));
    TEST_ASSERT_EQUAL(FXL_KEY_RIGHT, keys_meaning(KEYS_RIGHT));
    TEST_ASSERT_EQUAL(FXL_KEY_FORWARD | FXL_KEY_LEFT, keys_meaning(KEYS_UP | KEYS_LEFT));
}

void test_with_select_they_look(void)
{
    TEST_ASSERT_EQUAL(0, keys_meaning(KEYS_SELECT));
    TEST_ASSERT_EQUAL(FXL_KEY_PITCH_UP, keys_meaning(KEYS_SELECT | KEYS_UP));
    TEST_ASSERT_EQUAL(FXL_KEY_PITCH_DOWN, keys_meaning(KEYS_SELECT | KEYS_DOWN));
    TEST_ASSERT_EQUAL(FXL_KEY_ROLL_LEFT, keys_meaning(KEYS_SELECT | KEYS_LEFT));
    TEST_ASSERT_EQUAL(FXL_KEY_ROLL_RIGHT, keys_meaning(KEYS_SELECT | KEYS_RIGHT));
}
