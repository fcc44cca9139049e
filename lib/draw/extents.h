/* SPDX-License-Identifier: MIT */
/* Which rows of the screen the instances reach that are not in the display list, and which rows
 * their faces reach. They are found once, when a frame begins, and kept where the sort has left
 * memory that nobody needs any more: in the entries of the order, and behind the last of them. A
 * band then passes over what does not reach it. What is left of that memory becomes a cache of
 * vertices, if the caller gave none. A library for size keeps the rows of instances and those of a
 * sorted model's faces, not those of other faces. Internal. */
#ifndef FXL_EXTENTS_H
#define FXL_EXTENTS_H

#include "submit.h"

/* Goes on where `filling`, the traversal that filled the display list, had no more room: measures
 * the rows, and counts the faces. Requires that the traversal was fxl_submit_by_distance's. */
void fxl_extents_measure(const fxl_traversal *filling, fxl_frame *frame);

/* Takes back the memory of the order that a frame before has lent to the workspace as a cache of
 * vertices. */
void fxl_extents_take_back(const fxl_renderer *renderer, fxl_workspace *workspace);

/* fxl_submit_by_distance into a band, of a frame whose rows were measured. It counts nothing that
 * the measuring has counted: traversal->counters are thrown away. */
bool fxl_extents_submit(const fxl_traversal *traversal);

#endif
