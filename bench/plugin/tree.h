/* SPDX-License-Identifier: MIT */
/* The tree of calls, and how often each block ran at each place of it. */
#ifndef PLUGIN_TREE_H
#define PLUGIN_TREE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct tree_node tree_node;

/* A function at one place of the tree: called from one place of its parent, or
 * jumped to at the parent's end (a tail call), and then it comes back to where
 * the parent would. All members belong to tree.c but for reading. */
struct tree_node {
    tree_node *parent, *children, *next; /* next: of the parent's children */
    uint32_t function;
    uint32_t return_address; /* 0 for the outermost */
    bool jumped;             /* to, not called */
    uint32_t id;             /* set by tree_write */
};

/* A block of code that ran at one node. */
typedef struct tree_visit {
    tree_node *node;
    uint64_t times;
    uint64_t left; /* of these, not followed by the code behind the block */
    struct tree_visit *next;
} tree_visit;

/* The child of a node for a function called there, made where there is none.
 * Ends the process where memory ends. */
tree_node *tree_call(tree_node *node, uint32_t function, uint32_t return_address);

/* The node for a function that another, at `node`, went on to by a jump: one of
 * those that did so before where it is among them, else a new one within. */
tree_node *tree_jump(tree_node *node, uint32_t function);

/* The node that a return to an address comes back to: the parent of the
 * innermost call under way, from `node` outward, with that address. Null where
 * there is none. */
tree_node *tree_return(tree_node *node, uint32_t address);

/* The visit of a node in a block's list, made where there is none. The one
 * asked for last is found at once. */
tree_visit *tree_visit_of(tree_visit **list, tree_node *node);

/* Numbers the nodes and writes a line for each: "node ID PARENT FUNCTION
 * RETURN_ADDRESS", the address being 0 where it was jumped to. The root has id 0
 * and no line. */
void tree_write(FILE *file, tree_node *root);

#endif
