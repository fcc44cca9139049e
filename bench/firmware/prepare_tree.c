/* SPDX-License-Identifier: MIT */
/* For the BSP: memory for pieces of moving instances, enough for any scene of the comparison. */
#include "combination.h"
#include "fixel/order.h"

static uint32_t pieces[65536u / 4u];
static uint32_t most;

void combination_prepare(fxl_renderer *renderer)
{
    fxl_bsp_workspace *room = renderer->order_memory;
    room->pieces = pieces;
    room->pieces_size = sizeof pieces;
}

uint32_t combination_memory(const fxl_renderer *renderer)
{
    const fxl_bsp_workspace *room = renderer->order_memory;
    most = room->used > most ? room->used : most;
    return most;
}
