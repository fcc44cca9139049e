/* SPDX-License-Identifier: MIT */
/* Coverage of every triangle whose corners are quarter pixels of a screen of
 * 4 x 4 pixels, both ways round, repeated corners included; where the first
 * corner begins does not matter to a closed outline. Shards divide the first
 * corners among them. */
#ifndef ORACLE_GRID_H
#define ORACLE_GRID_H

#include "oracle/tally.h"

void oracle_grid(uint64_t shard, uint64_t shards, oracle_tally *tally);

#endif
