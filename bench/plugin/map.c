/* SPDX-License-Identifier: MIT */
#include "map.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool append(map_list *list, uint32_t address)
{
    if (list->count == list->room) {
        size_t room = list->room == 0 ? 256 : 2 * list->room;
        uint32_t *larger = realloc(list->addresses, room * sizeof *larger);
        if (larger == NULL) {
            return false;
        }
        list->addresses = larger;
        list->room = room;
    }
    list->addresses[list->count++] = address;
    return true;
}

static bool take(program_map *map, const char *word, uint32_t a, uint32_t b, int numbers)
{
    if (strcmp(word, "function") == 0) {
        return numbers == 2 && append(&map->starts, a) && append(&map->ends, b);
    }
    if (numbers != 1) {
        return false;
    }
    if (strcmp(word, "begin") == 0) {
        map->begin = a;
        return true;
    }
    if (strcmp(word, "end") == 0) {
        map->end = a;
        return true;
    }
    if (strcmp(word, "call") == 0) {
        return append(&map->calls, a);
    }
    return strcmp(word, "return") == 0 && append(&map->returns, a);
}

bool map_read(const char *path, program_map *map)
{
    FILE *file = fopen(path, "r");
    char line[128], word[16];
    bool good = file != NULL;
    memset(map, 0, sizeof *map);
    while (good && fgets(line, sizeof line, file) != NULL) {
        uint32_t a = 0, b = 0;
        int fields = sscanf(line, "%15s %" SCNx32 " %" SCNx32, word, &a, &b);
        good = fields >= 2 && take(map, word, a, b, fields - 1);
    }
    if (file != NULL) {
        fclose(file);
    }
    good = good && map->begin != 0 && map->end != 0;
    if (!good) {
        fprintf(stderr, "counter: %s is not a program map\n", path);
    }
    return good;
}

/* How many addresses of a rising list are at most `address`. */
static size_t count_up_to(const map_list *list, uint32_t address)
{
    size_t low = 0, high = list->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (list->addresses[middle] <= address) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

uint32_t map_function(const program_map *map, uint32_t address)
{
    size_t place = count_up_to(&map->starts, address);
    if (place == 0 || address >= map->ends.addresses[place - 1]) {
        return MAP_NO_FUNCTION;
    }
    return (uint32_t)(place - 1);
}

bool map_holds(const map_list *list, uint32_t address)
{
    size_t place = count_up_to(list, address);
    return place > 0 && list->addresses[place - 1] == address;
}
