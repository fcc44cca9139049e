/* SPDX-License-Identifier: MIT */
/* What the tool knows about the program, read from a file: lines of a word and
 * hexadecimal addresses.
 *   begin A        the marker function that begins a region
 *   end A          the marker function that ends it
 *   function A B   code from A up to B, in rising order; numbered from 0
 *   call A         where a call comes back to: the address after it
 *   return A       the address after an instruction that may be a return */
#ifndef PLUGIN_MAP_H
#define PLUGIN_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define MAP_NO_FUNCTION UINT32_MAX

typedef struct {
    uint32_t *addresses;
    size_t count, room;
} map_list;

typedef struct {
    uint32_t begin, end;
    map_list starts, ends; /* of functions */
    map_list calls, returns;
} program_map;

/* Reads a map; false, with a word on stderr, where the file is not one. */
bool map_read(const char *path, program_map *map);

/* The number of the function that holds an address, or MAP_NO_FUNCTION. */
uint32_t map_function(const program_map *map, uint32_t address);

/* Whether a list, in rising order, holds an address. */
bool map_holds(const map_list *list, uint32_t address);

#endif
