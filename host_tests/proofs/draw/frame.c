/* SPDX-License-Identifier: MIT */
#include "draw/render.c"
#include "draw/workspace.c"
#include "draw/pieces.c"
#include "proof.h"

void prove_count_outcome(void)
{
    fxl_traversal traversal;
    fxl_counters counters;
    fxl_display_list list;
    const fxl_outcome outcome = nondet_u32();
    const uint32_t used = nondet_u32(), before = list.used;
    ASSUME(counters.outside == 0 && counters.refused == 0 && counters.drawn == 0 && counters.degenerate == 0);
    traversal.counters = &counters;
    traversal.display_list = nondet_bool() ? NULL : &list;
    const bool counted = fxl_count_outcome(&traversal, outcome, used);
    ASSERT("a face is counted once", counters.outside + counters.refused + counters.drawn + counters.degenerate == (counted ? 1u : 0u));
    ASSERT("where the list is full, it is as before", list.used == (counted || traversal.display_list == NULL ? before : used));
    PROOF_ENDS();
}

void prove_cache_entries(void)
{
    fxl_scene scene;
    fxl_model models[2];
    const size_t bytes = nondet_size();
    scene.models = models;
    ASSUME(scene.model_count <= 2 && models[0].vertex_count <= FXL_MODEL_VERTICES_MAX && models[1].vertex_count <= FXL_MODEL_VERTICES_MAX);
    const uint32_t entries = fxl_cache_entries(&scene, bytes);
    ASSERT("a power of two, or none", (entries & (entries - 1u)) == 0 && entries <= 65536);
    ASSERT("within the memory", entries <= bytes / sizeof(fxl_cached_vertex));
    PROOF_ENDS();
}

void prove_pieces_end(void)
{
    fxl_pieces pieces;
    fxl_traversal traversal;
    fxl_counters counters;
    ASSUME(counters.outside == 0 && counters.refused == 0 && counters.drawn == 0 && counters.degenerate == 0);
    traversal.counters = &counters;
    traversal.display_list = NULL;
    pieces.traversal = &traversal;
    const bool counted = fxl_pieces_end(&pieces);
    ASSERT("a face is counted once, whatever its pieces", counters.outside + counters.refused + counters.drawn + counters.degenerate == (counted ? 1u : 0u));
    PROOF_ENDS();
}
