/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "proof.h"

/* For memcpy: both objects have so many bytes. */
static void *any_copy(void *to, const void *from, size_t size)
{
    ASSERT("it reads and writes within", __CPROVER_w_ok(to, size) && __CPROVER_r_ok(from, size));
    return to;
}

#define memcpy any_copy
#include "draw/display_list.c"
#undef memcpy
#include "draw/conflict.c"
#include "draw/shader.c"
#include "draw/pieces.c"

#define WORDS 72 /* of the largest polygon, and a small one */

/* [[row]]
 * function = "fxl_display_list_append"
 * property = "any list of up to 72 words and any polygon: never beyond the capacity"
 * checks = 100
 * stubs = { memcpy = "asserts that both objects have so many bytes" }
 */
void prove_display_list_append(void)
{
    uint32_t words[WORDS];
    fxl_display_list list;
    fxl_screen_polygon polygon;
    fxl_rows rows;
    list.words = words;
    ASSUME(list.capacity <= WORDS && list.used <= list.capacity);
    ASSUME(polygon.count >= 3 && polygon.count <= FXL_POLYGON_CAPACITY && rows.first < rows.end);
    const uint32_t used = list.used;
    const bool appended = fxl_display_list_append(&list, &polygon, rows);
    ASSERT("within the capacity", list.used <= list.capacity);
    ASSERT("its words", list.used == used + (appended ? 2u + 2u * polygon.count : 0));
    ASSERT("its rows", !appended || words[used] == ((uint32_t)rows.end << 16 | rows.first));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_display_list_next"
 * property = "any list of up to two polygons of up to 8 points: nothing is out of bounds, and a record of the list is found"
 * checks = 149
 */
/* A list of any records that are whole: up to two. */
void prove_display_list_next(void)
{
    uint32_t words[WORDS];
    const fxl_screen_polygon *first = (const fxl_screen_polygon *)(const void *)(words + 1);
    fxl_display_list list;
    fxl_rows rows;
    uint32_t place = 0;
    list.words = words;
    ASSUME(first->count >= 3 && first->count <= 8);
    const uint32_t begin = FXL_DISPLAY_LIST_WORDS((uint32_t)first->count);
    const fxl_screen_polygon *second = (const fxl_screen_polygon *)(const void *)(words + begin + 1);
    ASSUME(second->count >= 3 && second->count <= 8);
    ASSUME(list.used == 0 || list.used == begin || list.used == begin + FXL_DISPLAY_LIST_WORDS((uint32_t)second->count));
    const fxl_screen_polygon *found = fxl_display_list_next(&list, rows, &place);
    ASSERT("a record of the list", found == NULL || found == first || (found == second && list.used > begin));
    ASSERT("behind it", place <= list.used && (found != NULL || place == list.used));
    PROOF_ENDS();
}

static fxl_conflict any_conflict;

const fxl_conflict *fxl_find_conflict(const fxl_renderer *renderer)
{
    (void)renderer;
    return nondet_bool() ? NULL : &any_conflict;
}

/* [[row]]
 * function = "lib/draw/conflict.c:fxl_renderer_conflict"
 * property = "any conflict, and null pointers: both parts have a name"
 * checks = 45
 * stubs = { fxl_find_conflict = "any conflict of the table, or none" }
 */
void prove_renderer_conflict(void)
{
    fxl_renderer renderer;
    const char *names[2];
    ASSUME(any_conflict.first < FXL_HAS_COUNT && any_conflict.second < FXL_HAS_COUNT);
    const bool found = fxl_renderer_conflict(nondet_bool() ? NULL : &renderer, nondet_bool() ? NULL : names);
    ASSERT("both have names", !found || (names[0] != NULL && names[1] != NULL));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/conflict.c:fxl_conflict_sentence"
 * property = "any two parts, and null pointers: nothing is read beyond the table"
 * checks = 28
 * unwind = 12
 * stubs = { fxl_find_conflict = "any two parts, or none" }
 */
void prove_conflict_sentence(void)
{
    fxl_renderer renderer;
    const char *said = fxl_conflict_sentence(nondet_bool() ? NULL : &renderer);
    ASSERT("there is a first letter", said == NULL || *said != '\0');
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/shader.c:fxl_renderer_set_shader"
 * property = "shaders stay in the order of their ranks, one of each; up to two before"
 * checks = 94
 * stubs = { fxl_find_conflict = "not called" }
 */
void prove_renderer_set_shader(void)
{
    fxl_renderer renderer;
    fxl_shader one, two, added;
    const uint32_t rank = nondet_u32();
    /* none, one or two in the order of their ranks */
    renderer.shader = nondet_bool() ? NULL : &one;
    one.next = nondet_bool() ? NULL : &two;
    two.next = NULL;
    ASSUME(one.rank < two.rank);
    fxl_shader *shader = nondet_bool() ? NULL : &added;
    fxl_renderer_set_shader(&renderer, rank, shader);
    const fxl_shader *last = NULL;
    bool is_there = false;
    uint32_t count = 0;
    for (const fxl_shader *each = renderer.shader; each != NULL; each = each->next) {
        ASSERT("in the order of ranks", last == NULL || last->rank < each->rank);
        is_there = is_there || each->rank == rank;
        last = each;
        count++;
    }
    ASSERT("one of the rank, or none", is_there == (shader != NULL) && count <= 3);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/draw/pieces.c:fxl_pieces_begin"
 * property = "nothing is undefined, and no outcome is left from before"
 * checks = 43
 * stubs = { fxl_find_conflict = "not called" }
 */
void prove_pieces_begin(void)
{
    fxl_pieces pieces;
    fxl_renderer renderer;
    fxl_traversal traversal;
    traversal.renderer = &renderer;
    fxl_pieces_begin(&pieces, &traversal);
    ASSERT("no outcome yet", pieces.outcome == 0 && pieces.used == renderer.frame.display_list.used && pieces.take == NULL);
    PROOF_ENDS();
}
