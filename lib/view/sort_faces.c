/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "order.h"

/* Sorts faces as instances of one layer, 0: their entries. */
/* SPEC 6.3 */
static void sort_as_instances(fxl_draw_entry *entries, uint32_t count)
{
    for (uint32_t i = 0; !FXL_IS_SMALL && i < count; i++) {
        entries[i].next = 0; /* a link of the sort by buckets, in the bytes of the layer */
    }
    fxl_sort_instances(entries, count);
}

/* The `next` of the last entry of a chain. No entry has this place. */
#define END 0xFFFFu

/* Merges two chains of entries, each in order, into one; returns its first place. Requires that
 * a's entries have lower places than b's: of two entries with equal distances a's comes first. */
/* SPEC 6.3 */
static uint32_t merge(fxl_draw_entry *entries, uint32_t a, uint32_t b)
{
    fxl_draw_entry *at_a = &entries[a], *at_b = &entries[b];
    uint64_t from_a = fxl_draw_entry_distance(at_a), from_b = fxl_draw_entry_distance(at_b);
    uint32_t head = from_a >= from_b ? a : b;
    fxl_draw_entry *last = NULL;
    for (;;) {
        if (from_a >= from_b) {
            if (last != NULL) {
                last->next = (uint16_t)a;
            }
            last = at_a;
            a = at_a->next;
            if (a == END) {
                last->next = (uint16_t)b;
                return head;
            }
            at_a = &entries[a];
            from_a = fxl_draw_entry_distance(at_a);
        } else {
            if (last != NULL) {
                last->next = (uint16_t)b;
            }
            last = at_b;
            b = at_b->next;
            if (b == END) {
                last->next = (uint16_t)a;
                return head;
            }
            at_b = &entries[b];
            from_b = fxl_draw_entry_distance(at_b);
        }
    }
}

/* Chains the longest run of entries from *place on that are in order, or in the reverse order
 * without equal distances, and moves *place behind the run. Returns the chain. */
static uint32_t take_run(fxl_draw_entry *entries, uint32_t count, uint32_t *place)
{
    uint32_t head = *place, at = head + 1;
    uint64_t from_last = fxl_draw_entry_distance(&entries[head]);
    if (at < count && fxl_draw_entry_distance(&entries[at]) > from_last) {
        entries[head].next = END;
        for (; at < count && fxl_draw_entry_distance(&entries[at]) > from_last; at++) {
            from_last = fxl_draw_entry_distance(&entries[at]);
            entries[at].next = (uint16_t)head;
            head = at;
        }
    } else {
        for (; at < count && fxl_draw_entry_distance(&entries[at]) <= from_last; at++) {
            from_last = fxl_draw_entry_distance(&entries[at]);
            entries[at - 1].next = (uint16_t)at;
        }
        entries[at - 1].next = END;
    }
    *place = at;
    return head;
}

/* Writes the numbers of a chain's faces into `face` of the entries from `place` on. Returns the
 * place behind the last. This overwrites distances, but no links. */
static uint32_t put_in_order(fxl_draw_entry *entries, uint32_t chain, uint32_t place)
{
    while (chain != END) {
        const fxl_draw_entry *entry = &entries[chain];
        entries[place++].face = entry->index;
        chain = entry->next;
    }
    return place;
}

/* The levels of the merge sort. A model has at most FXL_MODEL_FACES_MAX faces, so at most half as
 * many runs, rounded up. */
#define LEVELS 16
FXL_STATIC_ASSERT((FXL_MODEL_FACES_MAX + 1) / 2 < 1 << LEVELS, "a chain of all runs has a level");

/* Merge sort of runs, in place and without recursion. chains[i] has 2^i runs, whose places are
 * below those of chains[i - 1]. A run has at least two entries, except the last. */
static void sort_by_merging(fxl_draw_entry *entries, uint32_t count)
{
    uint16_t chains[LEVELS];
    uint32_t levels = 0, place = 0;
    while (place < count) {
        uint32_t chain = take_run(entries, count, &place), level = 0;
        for (; level < levels && chains[level] != END; level++) {
            chain = merge(entries, chains[level], chain);
            chains[level] = END;
        }
        if (level == levels) {
            levels += 1;
        }
        chains[level] = (uint16_t)chain;
    }
    uint32_t all = END;
    for (uint32_t level = 0; level < levels; level++) {
        if (chains[level] != END) {
            all = all == END ? chains[level] : merge(entries, chains[level], all);
        }
    }
    put_in_order(entries, all, 0);
}

#define CHAINS_BITS ((uint32_t)(FXL_ORDER_CHAINS >= 512 ? 9 : FXL_ORDER_CHAINS >= 256 ? 8 : 7))
FXL_STATIC_ASSERT(FXL_ORDER_CHAINS == 1 << CHAINS_BITS, "a power of two");

/* The steps along chains, on average a face, after which the sort by buckets gives up, beside
 * those of evenly spread distances: half as many as a bucket holds. */
#define STEPS_A_FACE 4u

/* Buckets of equal width, the farthest first: the map from distances to buckets. */
typedef struct {
    uint64_t farthest; /* farther distances go into the first bucket */
    uint64_t range;    /* farthest - nearest; nearer distances go into the last bucket */
    uint32_t factor;   /* below count 2^(32 + shift) / range */
    uint32_t shift;
    uint32_t count; /* a power of two */
} buckets;

/* Sets up the buckets from a sample of the faces: about one a face. */
static void survey_distances(const fxl_draw_entry *entries, uint32_t count, buckets *by)
{
    uint32_t bits_of_count = 1;
    while (bits_of_count < CHAINS_BITS && count >> bits_of_count > 1) {
        bits_of_count++;
    }
    by->count = 1u << bits_of_count;
    uint64_t farthest = 0, nearest = UINT64_MAX;
    for (uint32_t i = 0; i < count; i += count / 64 | 1) {
        uint64_t distance = fxl_draw_entry_distance(&entries[i]);
        farthest = distance > farthest ? distance : farthest;
        nearest = distance < nearest ? distance : nearest;
    }
    by->farthest = farthest;
    by->range = farthest - nearest;
    uint32_t high = (uint32_t)(by->range >> 32), low = (uint32_t)by->range | UINT16_MAX;
    unsigned zeros = fxl_leading_zeros(high != 0 ? high : low);
    unsigned bits = (high != 0 ? 64u : 32u) - zeros;
    uint32_t upper = high != 0 ? high << zeros | low >> 1 >> (31 - zeros) : low << zeros;
    uint32_t rest, factor = fxl_divide_u32(UINT32_MAX, (upper >> 16) + 1, &rest);
    by->factor = bits < 32   ? factor << 15
                 : bits < 47 ? factor << (47 - bits)
                             : factor >> (bits - 47);
    by->shift = (bits < 32 ? bits - 1 : 31) - bits_of_count; /* bits >= 16 */
}

/* floor((farthest - distance) factor / 2^(32 + shift)). The range is below 2^bits. Its upper 16
 * bits, plus 1, times the first factor are not above 2^32. So range factor is below 2^63 if
 * bits >= 32, else below 2^(31 + bits). Nothing wraps, and the result is below by->count. */
static inline uint32_t bucket_of(const buckets *by, uint64_t distance)
{
    uint64_t nearer = by->farthest - distance;
    if (nearer > by->range) {
        return distance > by->farthest ? 0 : by->count - 1;
    }
    uint32_t high = (uint32_t)(nearer >> 32) * by->factor;
    return (high + (uint32_t)(fxl_multiply_u32((uint32_t)nearer, by->factor) >> 32)) >> by->shift;
}

/* Inserts a face into a chain that is in order, before others of the same distance. Returns false
 * after as many steps along chains as are left. */
/* SPEC 6.3 */
static inline bool insert(fxl_draw_entry *entries, uint32_t place, uint64_t distance,
                          uint16_t *link, uint32_t *steps)
{
    while (*link != END && fxl_draw_entry_distance(&entries[*link]) > distance) {
        link = &entries[*link].next;
        if ((*steps)-- == 0) {
            return false;
        }
    }
    entries[place].next = *link;
    *link = (uint16_t)place;
    return true;
}

static void put_chains_in_order(fxl_draw_entry *entries, const uint16_t *chains, uint32_t count)
{
    uint32_t place = 0;
    for (uint32_t i = 0; i < count; i++) {
        place = put_in_order(entries, chains[i], place);
    }
}

static void clear_chains(uint16_t *chains, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        chains[i] = END;
    }
}

/* Inserts each face into its bucket, which is a chain in order. Faces come from the last number to
 * the first, so a face goes before others of the same distance. Squared distances of the points of
 * a plane or a sphere are spread evenly, so a bucket holds few: about one. Returns false if too
 * many faces share too few buckets: then only links have changed. */
static bool sort_by_buckets(fxl_draw_entry *entries, uint32_t count, uint16_t *chains)
{
    buckets by;
    survey_distances(entries, count, &by);
    uint32_t steps = count * (STEPS_A_FACE + count / by.count); /* below 2^16 (4 + 2^15) */
    clear_chains(chains, by.count);
    for (uint32_t i = count; i-- > 0;) {
        uint64_t distance = fxl_draw_entry_distance(&entries[i]);
        if (!insert(entries, i, distance, &chains[bucket_of(&by, distance)], &steps)) {
            return false;
        }
    }
    put_chains_in_order(entries, chains, by.count);
    return true;
}

/* From so many faces on they are sorted by digits. Below, fewer buckets with longer chains take
 * fewer instructions. */
#define DIGITS_FACES (FXL_ORDER_CHAINS * 7u / 2u)
#define DIGIT_BITS   (CHAINS_BITS - 1u)
#define DIGIT_VALUES (1u << DIGIT_BITS)

/* The least and the greatest upper word of the distances. */
static void find_upper_words(const fxl_draw_entry *entry, uint32_t count, uint32_t *least,
                             uint32_t *most)
{
    const fxl_draw_entry *const end = entry + count;
    *least = UINT32_MAX;
    *most = 0;
    do {
        const uint32_t high = entry->distance_high;
        *least = high < *least ? high : *least;
        *most = high > *most ? high : *most;
    } while (++entry != end);
}

/* Finds what to take from the distances, a number of upper words, and by how many bits they may be
 * shifted then. Where the upper words differ by 8 bits at most, they are first shifted by 24, twice
 * if need be: what is left is below 2^40. */
static unsigned scale_distances(fxl_draw_entry *entries, uint32_t count, uint32_t *least)
{
    uint32_t most;
    find_upper_words(entries, count, least, &most);
    for (uint32_t times = 0; times < 2 && most - *least < 256; times++) {
        for (uint32_t i = 0; i < count; i++) {
            const uint32_t high = entries[i].distance_high - *least, low = entries[i].distance_low;
            entries[i].distance_high = high << 24 | low >> 8;
            entries[i].distance_low = low << 24;
        }
        find_upper_words(entries, count, least, &most);
    }
    return fxl_leading_zeros((most - *least) | 1u);
}

/* Puts each face before those with the same lower digit. Upper words of the distances become such
 * that the least is 0 and the greatest has its uppermost bit. This changes no order and loses no
 * bit. */
static void sort_by_lower_digit(fxl_draw_entry *entry, uint32_t count, uint16_t *lower)
{
    uint32_t least, place = 0;
    const unsigned shift = scale_distances(entry, count, &least);
    do {
        const uint32_t low = entry->distance_low;
        const uint32_t high = (entry->distance_high - least) << shift | low >> 1 >> (31u - shift);
        uint16_t *const link = &lower[high >> (32u - 2 * DIGIT_BITS) & (DIGIT_VALUES - 1u)];
        entry->distance_high = high;
        entry->distance_low = low << shift;
        entry->next = *link;
        *link = (uint16_t)place;
        entry++;
    } while (++place != count);
}

/* Sorts by the two uppermost digits of the scaled distances, in two passes, each by one of
 * them: so the time grows with the faces alone. The first pass turns the order of numbers round, so
 * faces come to the second one from the nearest to the farthest, by both digits, and then from the
 * last number to the first. A face then stands before all that came earlier, and only where both
 * digits are equal may a chain have to be followed. Returns false if they are equal too often: then
 * links have changed, and distances have kept their order. */
/* SPEC 6.3 */
static bool sort_by_digits(fxl_draw_entry *entries, uint32_t count, uint16_t *chains)
{
    uint16_t *const lower = chains, *const upper = chains + DIGIT_VALUES;
    uint32_t steps = count * STEPS_A_FACE;
    clear_chains(chains, 2 * DIGIT_VALUES);
    sort_by_lower_digit(entries, count, lower);
    for (uint32_t digit = 0; digit < DIGIT_VALUES; digit++) {
        uint32_t place = lower[digit];
        while (place != END) {
            fxl_draw_entry *const entry = &entries[place];
            const uint32_t next = entry->next, high = entry->distance_high;
            const uint32_t upper_digit = high >> (32u - DIGIT_BITS), first = upper[upper_digit];
            if (first == END || entries[first].distance_high < high) { /* as nearly always */
                entry->next = (uint16_t)first;
                upper[upper_digit] = (uint16_t)place;
            } else if (!insert(entries, place, fxl_draw_entry_distance(entry), &upper[upper_digit],
                               &steps)) {
                return false;
            }
            place = next;
        }
    }
    uint32_t place = 0;
    for (uint32_t digit = DIGIT_VALUES; digit-- > 0;) {
        place = put_in_order(entries, upper[digit], place);
    }
    return true;
}

void fxl_sort_faces(fxl_draw_entry *entries, uint32_t count, fxl_sort_work *work)
{
    const bool has_digits = !FXL_IS_COMPACT && count >= DIGITS_FACES;
    if (work != NULL) {
        if (!FXL_IS_SMALL && (has_digits ? sort_by_digits(entries, count, work->chains)
                                         : sort_by_buckets(entries, count, work->chains))) {
            return;
        }
        if (!FXL_IS_COMPACT) {
            sort_by_merging(entries, count);
            return;
        }
        sort_as_instances(entries, count);
    }
    for (uint32_t i = 0; i < count; i++) {
        entries[i].face = entries[i].index;
    }
}
