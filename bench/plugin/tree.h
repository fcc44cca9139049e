/* SPDX-License-Identifier: MIT */
/* The tree of calls, and how often each block ran at each place of it. */
#ifndef PLUGIN_TREE_H
#define PLUGIN_TREE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct tree_node tree_node;

/* A function at one place of the tree: called from one place of its parent.
 * All members belong to tree.c but for reading. */
struct tree_node {
    tree_node *parent, *children, *next; /* next: of the parent's children */
    uint32_t function;
    uint32_t return_address; /* where the call comes back to; 0 for the outermost */
    uint32_t id;             /* set by tree_write */
};

/* A block of code that ran at one node. */
typedef struct tree_visit {
    tree_node *node;
    uint64_t times;
    uint64_t left; /* of these, not followed by the code behind the block */
    struct tree_visit *next;
} tree_visit;

/* The child of a node for a function that comes back to an address, made where
 * there is none. Ends the process where memory ends. */
tree_node *tree_child(tree_node *node, uint32_t function, uint32_t return_address);

/* The innermost node under way, from `node` outward, whose call comes back to
 * an address; null where none does. */
tree_node *tree_returning(tree_node *node, uint32_t address);

/* The visit of a node in a block's list, made where there is none. The one
 * asked for last is found at once. */
tree_visit *tree_visit_of(tree_visit **list, tree_node *node);

/* Numbers the nodes and writes a line for each: "node ID PARENT FUNCTION
 * RETURN_ADDRESS". The root has id 0 and no line. */
void tree_write(FILE *file, tree_node *root);

#endif
