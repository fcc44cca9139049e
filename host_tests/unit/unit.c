/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include <math.h>

#define FIRST_STATE 2463534242u

static uint32_t state;
static const char *test; /* the name of the one that state belongs to */

/* Marsaglia's xorshift. */
uint32_t unit_random(void)
{
    if (test != Unity.CurrentTestName) {
        test = Unity.CurrentTestName;
        state = FIRST_STATE;
    }
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

void unit_seed(uint32_t seed)
{
    test = Unity.CurrentTestName;
    state = seed * 2654435769u; /* odd, so not 0 */
}

int32_t unit_between(int32_t low, int32_t high)
{
    uint64_t count = (uint64_t)((int64_t)high - low + 1);
    uint64_t bits = (uint64_t)unit_random() << 16 ^ unit_random();
    return (int32_t)(low + (int64_t)(bits % count));
}

int64_t unit_wide(unsigned bits)
{
    int64_t limit = ((int64_t)1 << bits) - 1;
    int64_t size = (int64_t)((uint64_t)unit_random() << 32 | unit_random()) & limit;
    uint32_t kind = unit_random();
    if ((kind & 0x70u) == 0) {
        size = limit - (kind & 2u);
    }
    return kind & 1u ? size : -size;
}

fxl_point unit_point(fxl_q16_16 limit)
{
    fxl_point point = {unit_between(-limit, limit), unit_between(-limit, limit),
                       unit_between(-limit, limit)};
    uint32_t ends = unit_random();
    if ((ends & 0xF0u) == 0) {
        point.x = ends & 1u ? limit : -limit;
        point.y = ends & 2u ? limit : -limit;
        point.z = ends & 4u ? limit : -limit;
    }
    return point;
}

fxl_direction unit_direction(void)
{
    double x, y, z, length;
    do {
        x = unit_between(-1000000, 1000000);
        y = unit_between(-1000000, 1000000);
        z = unit_between(-1000000, 1000000);
        length = sqrt(x * x + y * y + z * z);
    } while (length < 1000);
    double scale = FXL_Q2_30_ONE / length;
    return (fxl_direction){(fxl_q2_30)floor(x * scale + 0.5), (fxl_q2_30)floor(y * scale + 0.5),
                           (fxl_q2_30)floor(z * scale + 0.5)};
}

fxl_pose unit_pose(void)
{
    fxl_pose pose = {unit_point(FXL_COORDINATE_MAX), unit_random(), unit_random(), unit_random()};
    return pose;
}

static fxl_q2_30 rounded(double value)
{
    return (fxl_q2_30)floor(value * FXL_Q2_30_ONE + 0.5);
}

/* From a unit quaternion a + bi + cj + dk. */
fxl_orientation unit_orientation(void)
{
    double q[4], length;
    do {
        length = 0;
        for (int i = 0; i < 4; i++) {
            q[i] = unit_between(-1000000, 1000000);
            length += q[i] * q[i];
        }
    } while (length < 1e6);
    const double a = q[0] / sqrt(length), b = q[1] / sqrt(length), c = q[2] / sqrt(length),
                 d = q[3] / sqrt(length);
    return (fxl_orientation){{rounded(1 - 2 * (c * c + d * d)), rounded(2 * (b * c - a * d)),
                              rounded(2 * (b * d + a * c))},
                             {rounded(2 * (b * c + a * d)), rounded(1 - 2 * (b * b + d * d)),
                              rounded(2 * (c * d - a * b))},
                             {rounded(2 * (b * d - a * c)), rounded(2 * (c * d + a * b)),
                              rounded(1 - 2 * (b * b + c * c))}};
}

fxl_placement unit_placement(void)
{
    fxl_placement placement = {unit_orientation(), FXL_Q16_16_ONE};
    const uint32_t kind = unit_random() % 8;
    if (kind == 0) {
        placement.scale = unit_between(0, 1) ? FXL_SCALE_MIN : FXL_SCALE_MAX;
    } else if (kind >= 3) {
        placement.scale = unit_between(FXL_SCALE_MIN, FXL_SCALE_MAX) >> unit_between(0, 16);
        placement.scale = placement.scale < FXL_SCALE_MIN ? FXL_SCALE_MIN : placement.scale;
    }
    return placement;
}

fxl_lens unit_lens(uint16_t width, uint16_t height)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(width, height, FXL_ANGLE_QUARTER, Q16(0.0625),
                                                Q16(1000), 4, &lens));
    return lens;
}

fxl_lens unit_any_lens(void)
{
    fxl_lens lens;
    fxl_q16_16 near = unit_between(FXL_NEAR_MIN, unit_random() % 2 ? Q16(100) : Q16(0.5));
    fxl_angle fov = (fxl_angle)unit_between((int32_t)FXL_FOV_MIN + 1, (int32_t)FXL_FOV_MAX - 1);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov((uint16_t)unit_between(1, FXL_SCREEN_MAX),
                                                (uint16_t)unit_between(1, FXL_SCREEN_MAX), fov,
                                                near, unit_between(Q16(200), FXL_FAR_MAX),
                                                unit_between(0, FXL_INSET_MAX), &lens));
    return lens;
}

uint32_t unit_crc32(const uint8_t *bytes, uint32_t size)
{
    uint32_t crc = 0xFFFFFFFFu;
    for (uint32_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
        }
    }
    return ~crc;
}

bool unit_near(double a, double b, double bound)
{
    return fabs(a - b) <= bound;
}

uint32_t unit_mix(uint32_t hash, int64_t value)
{
    hash = 31u * hash + (uint32_t)value;
    hash = 31u * hash + (uint32_t)(value >> 32);
    return hash ^ hash >> 15;
}

static void write_hash(uint32_t hash, char *last)
{
    for (uint32_t i = 0; i < 8; i++) {
        last[-(int)i] = "0123456789ABCDEF"[hash >> 4 * i & 15];
    }
}

uint32_t unit_tell_hash(size_t row, uint32_t hash, uint32_t on_record)
{
    char text[] = "row 00: 0x00000000, on record 0x00000000";
    if (hash == on_record) {
        return 0;
    }
    text[4] = (char)('0' + (row + 1) / 10 % 10);
    text[5] = (char)('0' + (row + 1) % 10);
    write_hash(hash, text + 17);
    write_hash(on_record, text + sizeof text - 2);
    UnityMessage(text, (UNITY_LINE_TYPE)Unity.CurrentTestLineNumber);
    return 1;
}

void unit_expect_hashes(const unit_hash *record, size_t count,
                        uint32_t (*hash_of)(uint8_t division, uint32_t with))
{
    uint32_t wrong = 0;
    for (size_t i = 0; i < count; i++) {
        wrong += unit_tell_hash(i, hash_of(record[i].division, record[i].with), record[i].hash);
    }
    UNITY_TEST_ASSERT_EQUAL_UINT32(0, wrong, Unity.CurrentTestLineNumber, "rows of another hash");
}

void unit_expect_fields(const unit_field *fields, size_t count,
                        void (*expect)(fxl_status status, const char *what, uint32_t index))
{
    for (size_t i = 0; i < count; i++) {
        UNITY_SET_DETAIL(fields[i].change);
        memcpy(fields[i].member, &fields[i].value,
               fields[i].bytes); /* all cores are little-endian */
        expect(fields[i].status, fields[i].what, fields[i].index);
    }
    UNITY_CLR_DETAILS();
}
