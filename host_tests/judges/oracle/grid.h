/* SPDX-License-Identifier: MIT */
/* Coverage of every triangle whose vertices are quarter pixels of a screen of 4 x 4 pixels, in
 * both windings, with repeated vertices. The first vertex of a closed outline has no effect, so
 * it is not varied. Shards divide the first vertices among them. */
/* place fill-rule: what the two claims count */
#ifndef ORACLE_GRID_H
#define ORACLE_GRID_H

#include "oracle/tally.h"

void oracle_grid(uint64_t shard, uint64_t shards, oracle_tally *tally);

#endif
