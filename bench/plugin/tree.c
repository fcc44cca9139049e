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

static tree_node *child_of(tree_node *node, uint32_t function, uint32_t return_address, bool jumped)
{
    tree_node *child = node->children;
    while (child != NULL && (child->function != function ||
                             child->return_address != return_address || child->jumped != jumped)) {
        child = child->next;
    }
    if (child == NULL) {
        child = make(sizeof *child);
        child->parent = node;
        child->function = function;
        child->return_address = return_address;
        child->jumped = jumped;
        child->next = node->children;
        node->children = child;
    }
    return child;
}

tree_node *tree_call(tree_node *node, uint32_t function, uint32_t return_address)
{
    return child_of(node, function, return_address, false);
}

tree_node *tree_jump(tree_node *node, uint32_t function)
{
    tree_node *before = node;
    for (;;) {
        if (before->function == function) {
            return before;
        }
        if (!before->jumped) {
            return child_of(node, function, node->return_address, true);
        }
        before = before->parent;
    }
}

tree_node *tree_return(tree_node *node, uint32_t address)
{
    for (; node->parent != NULL; node = node->parent) {
        if (node->return_address == address && !node->jumped) {
            return node->parent;
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
                child->function, child->jumped ? 0 : child->return_address);
        next_id = write_children(file, child, next_id);
    }
    return next_id;
}

void tree_write(FILE *file, tree_node *root)
{
    root->id = 0;
    write_children(file, root, 1);
}
