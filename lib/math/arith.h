/* SPDX-License-Identifier: MIT */
/* Integer arithmetic that all stages share. Each function states why it cannot overflow
 * and the error of its rounding. Internal. */
#ifndef FXL_ARITH_H
#define FXL_ARITH_H

#include <stdint.h>

#include "contract.h"
#include "core.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* floor(numerator / denominator); *rest becomes the remainder. Requires a quotient below
 * 2^32, that is, numerator / 2^32 < denominator. */
uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *remainder)
    FXL_REQUIRES(numerator >> 32 < denominator) FXL_REQUIRES(FXL_OBJECT(remainder))
    FXL_ASSIGNS(*remainder) FXL_EQUATES(*remainder < denominator)
    FXL_EQUATES(numerator >> 31 >= denominator || FXL_RESULT >> 31 == 0)
    FXL_EQUATES(numerator >> 28 >= denominator || FXL_RESULT >> 28 == 0);

/* floor(2^64 part / whole). Requires part < whole < 2^63. */
uint64_t fxl_fraction(uint64_t part, uint64_t whole)
    FXL_REQUIRES(part < whole && whole >> 63 == 0) FXL_ASSIGNS();

/* factor * side / depth, rounded to the nearest unit of factor. Returns false if its
 * magnitude is above limit: quotient untouched.
 * Requires 0 < factor < 2^29, |side| < 2^61, 0 < depth < 2^61, 0 < limit < 2^29.
 * Error: 0.5 + 2^-30 unit + 2^-31 of the quotient. */
bool fxl_ratio(fxl_q16_16 factor, fxl_q18_46 side, fxl_q18_46 depth, int32_t limit,
               int32_t *quotient)
    FXL_REQUIRES(factor > 0 && factor < 1 << 29 && FXL_BELOW(side, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(depth > 0 && depth < (int64_t)1 << 61 && limit > 0 && limit < 1 << 29)
    FXL_REQUIRES(FXL_OBJECT(quotient)) FXL_ASSIGNS(*quotient);

/* Sine and cosine in units of 2^-31, so 1 is 2^31: more bits than 2.30, as sums of products need
 * them.
 * Error: at most 0.52 unit of 2^-31. */
int64_t fxl_sin_q31(fxl_angle angle)
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, (int64_t)1 << 31));
int64_t fxl_cos_q31(fxl_angle angle)
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, (int64_t)1 << 31));

#ifdef __cplusplus
}
#endif

/* An assertion, for bugs of the library itself. A test build aborts on it, a proof takes
 * it as a goal, and a build without FXL_ASSERT_HOOK omits it. */
#ifdef FXL_PROVE
#define FXL_ASSERT(condition) __CPROVER_assert(condition, #condition)
#elif defined FXL_ASSERT_HOOK
#ifdef __cplusplus
extern "C" {
#endif
void fxl_assert_failed(const char *file, int line);
#ifdef __cplusplus
}
#endif
#ifndef FXL_ASSERT_LINE /* make equality has another, which a comment does not move */
#define FXL_ASSERT_LINE __LINE__
#endif
#define FXL_ASSERT(condition) \
    do { \
        if (!(condition)) { \
            fxl_assert_failed(__FILE__, FXL_ASSERT_LINE); \
        } \
    } while (0)
#else
#define FXL_ASSERT(condition) ((void)0)
#endif

/* The C standard leaves right shifts of negative numbers to the implementation. They are
 * arithmetic on every compiler that Fixel is built with. */
FXL_STATIC_ASSERT((-3 >> 1) == -2, "needs arithmetic right shift");

/* floor(value / 2^shift + 1/2), 1 <= shift <= 62. The addition cannot overflow for
 * |value| <= 2^62. Error: half a unit of the result. */
/* SPEC 2.2 */
static inline int64_t fxl_round_shift(int64_t value, unsigned shift)
{
    return (value + ((int64_t)1 << (shift - 1))) >> shift;
}

/* floor(numerator / denominator). Requires denominator > 0 and a quotient below 2^31. A negative
 * numerator is inverted: floor((-1 - n) / d) is -1 - floor(n / d). */
static inline int32_t fxl_divide_down(int64_t numerator, uint32_t denominator)
    FXL_REQUIRES(denominator > 0 && (uint64_t)(numerator ^ (numerator >> 63)) >> 31 < denominator)
    FXL_ASSIGNS()
    FXL_ENSURES((uint64_t)(numerator ^ (numerator >> 63)) >> 28 >= denominator ||
                FXL_BELOW(FXL_RESULT, 1 << 28))
{
    FXL_ASSERT(denominator > 0);
    uint32_t residue;
    int64_t sign = numerator >> 63;
    return (int32_t)fxl_divide_u64((uint64_t)(numerator ^ sign), denominator, &residue) ^
           (int32_t)sign;
}

/* floor(numerator / denominator + 1/2), under the same conditions. If the denominator is odd, its
 * half is rounded down, which does not change the result. Error: half a unit. */
/* SPEC 2.2 */
static inline int32_t fxl_divide_round(int64_t numerator, uint32_t denominator)
    FXL_REQUIRES(denominator > 0)
    FXL_REQUIRES(FXL_BELOW(numerator, (int64_t)((uint64_t)denominator << 31) - denominator))
    FXL_ASSIGNS()
    FXL_ENSURES(!FXL_BELOW(numerator, (int64_t)((uint64_t)denominator << 28) - denominator) ||
                FXL_BELOW(FXL_RESULT, 1 << 28))
{
    return fxl_divide_down(numerator + (denominator >> 1), denominator);
}

/* floor(numerator / denominator) and the remainder. Requires denominator > 0, and a numerator above
 * -2^31. */
static inline int32_t fxl_divide_floor(int32_t numerator, int32_t denominator, int32_t *remainder)
    FXL_REQUIRES(denominator > 0 && numerator > INT32_MIN && FXL_OBJECT(remainder))
    FXL_ASSIGNS(*remainder) FXL_ENSURES(*remainder >= 0 && *remainder < denominator)
    FXL_ENSURES(numerator >= 0 ? FXL_RESULT >= 0 && FXL_RESULT <= numerator
                               : FXL_RESULT <= 0 && FXL_RESULT >= numerator - (int64_t)1)
{
    FXL_ASSERT(denominator > 0);
    bool negative = numerator < 0;
    uint32_t magnitude = negative ? 0u - fxl_bits_32(numerator) : (uint32_t)numerator;
    uint32_t residue;
    int32_t quotient = (int32_t)fxl_divide_u32(magnitude, (uint32_t)denominator, &residue);
    if (negative) {
        quotient = -quotient - (residue != 0);
        residue = residue != 0 ? (uint32_t)denominator - residue : 0;
    }
    *remainder = (int32_t)residue;
    return quotient;
}

/* Before a function of a header that is in place wherever it is called. With FXL_SMALL it stands
 * once, in the source that defines FXL_HERE before it includes the header. */
#if !FXL_IS_SMALL
#define FXL_IN_PLACE static inline
#else
#define FXL_IN_PLACE
#endif

/* The same for a larger one, of which any library for size has one. */
#if !FXL_IS_COMPACT
#define FXL_IN_PLACE_LARGE static inline
#else
#define FXL_IN_PLACE_LARGE
#endif

/* The number of bits of a value up to its highest 1; 0 for 0. */
FXL_IN_PLACE unsigned fxl_bit_length(uint64_t value)
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    uint32_t high = (uint32_t)(value >> 32);
    uint32_t low = fxl_low_32(value);
    if (high != 0) {
        return 64u - fxl_leading_zeros(high);
    }
    return low == 0 ? 0u : 32u - fxl_leading_zeros(low);
}
#endif

/* value / 2^drop, rounded down, for 0 <= drop <= 63. */
/* accuracy 5.1 */
FXL_IN_PLACE_LARGE int64_t fxl_shifted_down(int64_t value, unsigned drop)
#if FXL_IS_COMPACT && !defined(FXL_HERE)
    ;
#else
{
    return value >> drop;
}
#endif

/* A number mantissa * 2^exponent, above 0. */
typedef struct {
    uint32_t mantissa; /* 2^31 to 2^32 - 1 */
    int exponent;
} fxl_real;

/* number * 2^exponent, rounded down by less than 2^-31 of it. Requires number > 0. */
FXL_IN_PLACE fxl_real fxl_real_of(uint64_t number, int exponent)
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    const uint32_t high = (uint32_t)(number >> 32), low = fxl_low_32(number);
    const unsigned zeros = fxl_leading_zeros(high != 0 ? high : low);
    const fxl_real result = {high != 0 ? high << zeros | low >> 1 >> (31 - zeros) : low << zeros,
                             exponent + (high != 0 ? 32 : 0) - (int)zeros};
    return result;
}
#endif

/* The ratio of the mantissas, times 2^31 and rounded down: from 2^30 to 2^32 - 2. */
static inline uint32_t fxl_mantissa_ratio(const fxl_real *part, const fxl_real *whole)
{
    uint32_t remainder;
    return fxl_divide_u64((uint64_t)(part->mantissa >> 1) << 32, whole->mantissa, &remainder);
}

static inline uint64_t fxl_magnitude(int64_t value)
{
    return value < 0 ? (uint64_t)0 - fxl_bits_64(value) : (uint64_t)value;
}

static inline bool fxl_within(int64_t value, int64_t limit)
{
    return value >= -limit && value <= limit;
}

static inline bool fxl_point_in_range(const fxl_point *point)
    FXL_REQUIRES(FXL_OBJECT(point)) FXL_ASSIGNS()
    FXL_ENSURES(FXL_RESULT == (FXL_BELOW(point->x, FXL_COORDINATE_MAX) &&
                               FXL_BELOW(point->y, FXL_COORDINATE_MAX) &&
                               FXL_BELOW(point->z, FXL_COORDINATE_MAX)))
{
    return fxl_within(point->x, FXL_COORDINATE_MAX) && fxl_within(point->y, FXL_COORDINATE_MAX) &&
           fxl_within(point->z, FXL_COORDINATE_MAX);
}

/* direction . (x, y, z), exact, in units of 2^-46.
 * Requires |x|, |y|, |z| < 2^30 and |direction| <= 1 + 2^-28. By Cauchy-Schwarz the sum
 * is below sqrt(3) * 2^60 * (1 + 2^-28) < 2^61. So is every partial sum: it is the
 * product with the same vector, with some components set to 0. */
/* SPEC 3.3 */
FXL_IN_PLACE fxl_q18_46 fxl_dot(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
    FXL_REQUIRES(FXL_OBJECT(direction) && FXL_DIRECTION(direction))
    FXL_REQUIRES(FXL_BELOW(x, 1 << 30) && FXL_BELOW(y, 1 << 30) && FXL_BELOW(z, 1 << 30))
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, (int64_t)7 << 59))
    FXL_ENSURES(!FXL_BELOW(x, 1 << 29) || !FXL_BELOW(y, 1 << 29) || !FXL_BELOW(z, 1 << 29) ||
                FXL_BELOW(FXL_RESULT, (int64_t)7 << 58))
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    return fxl_multiply_s31(direction->x, x) + fxl_multiply_s31(direction->y, y) +
           fxl_multiply_s31(direction->z, z);
}
#endif

/* *difference = a - b. Requires points of the world: each coordinate of the result is then below
 * 2^30. */
FXL_IN_PLACE void fxl_subtract(const fxl_point *a, const fxl_point *b, fxl_point *difference)
    FXL_REQUIRES(FXL_OBJECT(a) && FXL_OBJECT(b) && FXL_OBJECT(difference))
    FXL_REQUIRES(fxl_point_in_range(a) && fxl_point_in_range(b)) FXL_ASSIGNS(*difference)
    FXL_ENSURES(FXL_BELOW(difference->x, (1 << 30) - 1) && FXL_BELOW(difference->y, (1 << 30) - 1) &&
                FXL_BELOW(difference->z, (1 << 30) - 1))
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    difference->x = a->x - b->x;
    difference->y = a->y - b->y;
    difference->z = a->z - b->z;
}
#endif

#endif
