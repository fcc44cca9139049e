/* SPDX-License-Identifier: MIT */
/* A QEMU plugin that counts a program's executed instructions exactly.
 *
 *   -plugin counter.so,map=FILE,out=FILE[,detail=on]
 *
 * What runs between two marker functions is a region: from the first
 * instruction after the first marker came back up to and with the call of the
 * second. In the order in which they ended:
 *   region INSTRUCTIONS
 * With detail, over all regions together:
 *   node ID PARENT FUNCTION RETURN    the tree of calls; 0 is the root
 *   block ID ADDRESS SIZES            code, and each instruction's bytes (2 or 4)
 *   visit NODE BLOCK TIMES LEFT       how often it ran there, and how often it
 *                                     was not followed by what lies behind it
 * and at the end, so that a file which has it is whole:
 *   done REGIONS
 *
 * A block is what QEMU translates at once; it is left early only by a fault,
 * by an interrupt between two blocks, or by an access to a device, none of
 * which happens in a region. */
#define _GNU_SOURCE /* RTLD_DEFAULT */
#include <dlfcn.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "map.h"
#include "qemu.h"
#include "tree.h"

typedef struct block {
    uint32_t address, end; /* end: the address behind it */
    uint32_t count;        /* instructions */
    uint32_t function;
    bool calls, returns; /* what its last instruction may be */
    bool begins;         /* a function */
    char *sizes;         /* a digit for each instruction */
    tree_visit *visits;
    struct block *next;
} block;

static struct {
    program_map map;
    const char *out;
    bool detail, counting;
    uint64_t instructions; /* of this region so far */
    uint64_t *regions;
    size_t region_count, region_room;
    block *blocks;
    tree_node root, *node;
    const block *before; /* the block that ran last in this region */
    tree_visit *visit;   /* and where */
} counter;

/* QEMU refuses a plugin written for another version than it speaks; ours is
 * written for all, so it asks which one is there. Version 2 (QEMU 9.0) brought
 * the scoreboards, and is accepted by every later one so far. */
int qemu_plugin_version = 1;

__attribute__((constructor)) static void choose_version(void)
{
    if (dlsym(RTLD_DEFAULT, "qemu_plugin_scoreboard_new") != NULL) {
        qemu_plugin_version = 2;
    }
}

static void end_region(void)
{
    if (counter.region_count == counter.region_room) {
        size_t room = counter.region_room == 0 ? 64 : 2 * counter.region_room;
        uint64_t *larger = realloc(counter.regions, room * sizeof *larger);
        if (larger == NULL) {
            fputs("counter: out of memory\n", stderr);
            exit(1);
        }
        counter.regions = larger;
        counter.region_room = room;
    }
    counter.regions[counter.region_count++] = counter.instructions;
}

/* Moves to the node that a block runs at, from the one of the block before. A
 * call goes inward, a return outward; any other way into another function is a
 * jump. What calls into the middle of its own function is none: in a function of
 * more than 2 KB, a core without wide branches jumps by BL. */
static void follow(const block *now)
{
    const block *before = counter.before;
    tree_node *node = counter.node, *back = NULL;
    if (before == NULL) {
        node = tree_call(&counter.root, now->function, 0);
    } else if (now->address != before->end && before->calls &&
               (now->begins || now->function != before->function)) {
        node = tree_call(node, now->function, before->end);
    } else if (now->address != before->end && before->returns &&
               (back = tree_return(node, now->address)) != NULL) {
        node = back;
    }
    if (node->function != now->function) {
        node = tree_jump(node, now->function);
    }
    counter.node = node;
}

static void visit(block *now)
{
    if (counter.before != NULL && now->address != counter.before->end) {
        counter.visit->left++;
    }
    follow(now);
    counter.before = now;
    counter.visit = tree_visit_of(&now->visits, counter.node);
    counter.visit->times++;
}

static void on_executed(unsigned core, void *data)
{
    block *now = data;
    (void)core;
    if (now->address == counter.map.begin) {
        counter.counting = true;
        counter.instructions = 0;
        counter.before = NULL;
        return;
    }
    if (!counter.counting) {
        return;
    }
    if (now->address == counter.map.end) {
        counter.counting = false;
        if (counter.before != NULL) {
            counter.visit->left++; /* the call of the marker itself */
        }
        end_region();
        return;
    }
    counter.instructions += now->count;
    if (counter.detail) {
        visit(now);
    }
}

/* How long an instruction of a block is. It is told by where the next one is: before the end of a
 * page QEMU 7 takes the next halfword, which it looks at in advance, as part of the instruction. */
static size_t size_of(const struct qemu_plugin_tb *translated, size_t index, size_t count)
{
    const struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(translated, index);
    if (index + 1 == count) {
        return qemu_plugin_insn_size(instruction);
    }
    return (size_t)(qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(translated, index + 1)) -
                    qemu_plugin_insn_vaddr(instruction));
}

static void on_translated(qemu_plugin_id_t id, struct qemu_plugin_tb *translated)
{
    size_t count = qemu_plugin_tb_n_insns(translated);
    block *made = calloc(1, sizeof *made);
    char *sizes = malloc(count + 1);
    (void)id;
    if (made == NULL || sizes == NULL) {
        fputs("counter: out of memory\n", stderr);
        exit(1);
    }
    made->address = made->end = (uint32_t)qemu_plugin_tb_vaddr(translated);
    made->count = (uint32_t)count;
    for (size_t i = 0; i < count; i++) {
        size_t size = size_of(translated, i, count);
        made->end += (uint32_t)size;
        sizes[i] = (char)('0' + size);
    }
    sizes[count] = '\0';
    made->sizes = sizes;
    made->function = map_function(&counter.map, made->address);
    made->begins = map_holds(&counter.map.starts, made->address);
    made->calls = map_holds(&counter.map.calls, made->end);
    made->returns = map_holds(&counter.map.returns, made->end);
    made->next = counter.blocks;
    counter.blocks = made;
    qemu_plugin_register_vcpu_tb_exec_cb(translated, on_executed, PLUGIN_NO_REGISTERS, made);
}

static void write_blocks(FILE *file)
{
    uint32_t number = 0;
    for (const block *each = counter.blocks; each != NULL; each = each->next) {
        if (each->visits == NULL) {
            continue;
        }
        fprintf(file, "block %" PRIu32 " %" PRIx32 " %s\n", number, each->address, each->sizes);
        for (const tree_visit *seen = each->visits; seen != NULL; seen = seen->next) {
            fprintf(file, "visit %" PRIu32 " %" PRIu32 " %" PRIu64 " %" PRIu64 "\n", seen->node->id,
                    number, seen->times, seen->left);
        }
        number++;
    }
}

static void on_exit_of_qemu(qemu_plugin_id_t id, void *data)
{
    FILE *file = fopen(counter.out, "w");
    (void)id;
    (void)data;
    if (file == NULL) {
        fprintf(stderr, "counter: cannot write %s\n", counter.out);
        return;
    }
    for (size_t i = 0; i < counter.region_count; i++) {
        fprintf(file, "region %" PRIu64 "\n", counter.regions[i]);
    }
    tree_write(file, &counter.root);
    write_blocks(file);
    fprintf(file, "done %zu\n", counter.region_count);
    if (fclose(file) != 0) {
        fprintf(stderr, "counter: cannot write %s\n", counter.out);
    }
}

/* The value of an argument name=value; null where it is another's. */
static const char *value_of(const char *argument, const char *name)
{
    size_t length = strlen(name);
    return strncmp(argument, name, length) == 0 && argument[length] == '=' ? argument + length + 1
                                                                           : NULL;
}

int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc, char **argv)
{
    const char *map = NULL;
    (void)info;
    for (int i = 0; i < argc; i++) {
        const char *value;
        if ((value = value_of(argv[i], "map")) != NULL) {
            map = value;
        } else if ((value = value_of(argv[i], "out")) != NULL) {
            counter.out = strdup(value);
        } else if ((value = value_of(argv[i], "detail")) != NULL) {
            counter.detail = strcmp(value, "on") == 0;
        } else {
            fprintf(stderr, "counter: argument not understood: %s\n", argv[i]);
            return 1;
        }
    }
    if (map == NULL || counter.out == NULL || !map_read(map, &counter.map)) {
        fputs("counter: map= and out= are needed\n", stderr);
        return 1;
    }
    counter.root.function = MAP_NO_FUNCTION;
    counter.node = &counter.root;
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translated);
    qemu_plugin_register_atexit_cb(id, on_exit_of_qemu, NULL);
    return 0;
}
