/* SPDX-License-Identifier: MIT */
/* The serial ports where nobody is at the other end: registers that are plain
 * memory, which never change by themselves. */
#include "parts/pl022.h"
#include "parts/sbcon.h"
#include "unity.h"

#define PL022_DATA   2 /* registers, in words */
#define PL022_STATUS 3
#define HAS_ROOM     2u
#define RECEIVED     4u

static uint32_t registers[8];
static const uint8_t bytes[3] = {1, 2, 3};

void setUp(void)
{
    uint32_t i;

    for (i = 0; i < 8; i++) {
        registers[i] = 0;
    }
}

void tearDown(void)
{
}

void test_a_port_that_gets_on_sends(void)
{
    registers[PL022_STATUS] = HAS_ROOM | RECEIVED;
    TEST_ASSERT_TRUE(pl022_send((uintptr_t)registers, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(3, registers[PL022_DATA]);
}

void test_a_port_without_room_ends_in_a_failure(void)
{
    registers[PL022_STATUS] = RECEIVED;
    TEST_ASSERT_FALSE(pl022_send((uintptr_t)registers, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(0, registers[PL022_DATA]);
}

void test_a_port_whose_bytes_do_not_leave_ends_in_a_failure(void)
{
    registers[PL022_STATUS] = HAS_ROOM;
    TEST_ASSERT_FALSE(pl022_send((uintptr_t)registers, bytes, sizeof bytes));
    TEST_ASSERT_EQUAL(1, registers[PL022_DATA]);
}

void test_a_port_is_set_up_for_eight_bits_and_turned_on(void)
{
    pl022_open((uintptr_t)registers, 6);
    TEST_ASSERT_EQUAL_HEX32(0xC7, registers[0]);
    TEST_ASSERT_EQUAL_HEX32(2, registers[1]);
    TEST_ASSERT_EQUAL(6, registers[4]);
}

/* The word that lets lines rise reads as what was let go last: the clock, with
 * data low. That is what an acknowledgement looks like. */
void test_an_acknowledgement(void)
{
    TEST_ASSERT_TRUE(sbcon_send((uintptr_t)registers, 0x3D, bytes, sizeof bytes));
}
