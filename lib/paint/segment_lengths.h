/* SPDX-License-Identifier: MIT */
/* Which lengths the segments of a row have, in portable C. Internal. */
#ifndef FXL_SEGMENT_LENGTHS_H
#define FXL_SEGMENT_LENGTHS_H

#include "../math/family.h"
#include "segments.h"

/* Segments may end beyond what the gradients are bounded for: then their sums wrap. */
static inline int64_t sum(int64_t value, int64_t step, uint32_t times)
{
    return (int64_t)((uint64_t)value + (uint64_t)fxl_multiply_s64_u16(step, times));
}

/* The segments of 16 columns, by the weight at their left end. */
/* SPEC 9.2 */
FXL_ONCE uint32_t log_of(const fxl_segment_face *face, uint64_t weight)
{
    const uint64_t next = weight + (uint64_t)face->weight_step; /* beyond the row it may wrap */
    return fxl_segment_log(face->least, (uint32_t)(weight >> 32), (uint32_t)(next >> 32));
}

/* Where the segments of a row have another length than those of 2^log columns. Weights are linear:
 * the least one of 16 columns is that at their left end if it rises, and that at their right end if
 * it falls. */
/* SPEC 9.2 */
static inline int32_t length_bound(const fxl_segment_face *face, uint32_t log, bool rises)
{
    const uint32_t *least = face->least;
    if (rises) {
        return log == 4 ? INT32_MAX : (int32_t)least[log == 3 ? 0 : log == 2 ? 1 : 2];
    }
    return log == 0 ? INT32_MIN : (int32_t)least[log == 4 ? 0 : log == 3 ? 1 : 2];
}

/* The end of the columns from x0 on, before x1, that have segments of 2^log. weight: at the left
 * end of the first 16; becomes that at the left end of those that follow. */
/* SPEC 9.2 */
static inline int32_t length_end(const fxl_segment_face *face, uint32_t log, int32_t x0, int32_t x1,
                                 uint64_t *weight)
{
    const uint64_t step = (uint64_t)face->weight_step;
    if (FXL_IS_COMPACT) { /* each 16 columns are looked at */
        do {
            x0 = (x0 & ~15) + 16;
            *weight += step;
        } while (x0 < x1 && log_of(face, *weight) == log);
        return x0 < x1 ? x0 : x1;
    }
    const bool rises = face->weight_step >= 0;
    const int32_t bound = length_bound(face, log, rises);
    uint64_t at = *weight + step; /* beyond the row it may wrap */
    int32_t end = (x0 & ~15) + 16;
    if (rises) {
        for (; end < x1 && (int32_t)(at >> 32) < bound; end += 16) {
            at += step;
        }
        *weight = at;
    } else {
        for (at += step; end < x1 && (int32_t)(at >> 32) >= bound; end += 16) {
            at += step;
        }
        *weight = at - step;
    }
    return end < x1 ? end : x1;
}

/* The columns from x0 on, before x1, that have segments of one length. weight: as above. Returns
 * their end, and the logarithm of that length. */
static inline int32_t next_length(const fxl_segment_face *face, int32_t x0, int32_t x1,
                                  uint64_t *weight, uint32_t *log)
{
    *log = log_of(face, *weight);
    return length_end(face, *log, x0, x1, weight);
}

#endif
