/* SPDX-License-Identifier: MIT */
#include "tree.h"

#include <inttypes.h>
#include <stdlib.h>

static void *make(size_t size)
{
    void *memory = calloc(1, size);
    if (memory == NULL) {
        fputs("counter: out of memory\n", stderr);
        exit(1);
    }
    return memory;
}

tree_node *tree_child(tree_node *node, uint32_t function, uint32_t return_address)
{
    tree_node *child = node->children;
    while (child != NULL &&
           (child->function != function || child->return_address != return_address)) {
        child = child->next;
    }
    if (child == NULL) {
        child = make(sizeof *child);
        child->parent = node;
        child->function = function;
        child->return_address = return_address;
        child->next = node->children;
        node->children = child;
    }
    return child;
}

tree_node *tree_returning(tree_node *node, uint32_t address)
{
    for (; node != NULL && node->parent != NULL; node = node->parent) {
        if (node->return_address == address) {
            return node;
        }
    }
    return NULL;
}

tree_visit *tree_visit_of(tree_visit **list, tree_node *node)
{
    tree_visit **place = list;
    tree_visit *visit;
    while (*place != NULL && (*place)->node != node) {
        place = &(*place)->next;
    }
    visit = *place;
    if (visit == NULL) {
        visit = make(sizeof *visit);
        visit->node = node;
    } else {
        *place = visit->next;
    }
    visit->next = *list;
    *list = visit;
    return visit;
}

static uint32_t write_children(FILE *file, tree_node *node, uint32_t next_id)
{
    for (tree_node *child = node->children; child != NULL; child = child->next) {
        child->id = next_id++;
        fprintf(file, "node %" PRIu32 " %" PRIu32 " %" PRIu32 " %" PRIx32 "\n", child->id, node->id,
                child->function, child->return_address);
        next_id = write_children(file, child, next_id);
    }
    return next_id;
}

void tree_write(FILE *file, tree_node *root)
{
    root->id = 0;
    write_children(file, root, 1);
}
