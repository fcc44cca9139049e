/* SPDX-License-Identifier: MIT */
/* The clusters of turned instances. A file of its own, so that the loop of the others is compiled
 * with its tests in place. */
#define PLANES_OF      tests->planes
#define IS_TURNED_AWAY tests->is_turned_away
#define FIND_FRONT     tests->find_front

#include "cluster_loop.h"
#include "fixel/records.h"

/* The length, in units of 2^-14, by which an eye that was rounded once must be farther into a cone:
 * more than twice its error of sqrt(3) / 2 units of 2^-16. With v = u + d, |d| no more than this
 * error, v . axis is at least u . axis - |d| and |v| at most |u| + |d|. So the exact eye is in the
 * cone if u . axis - 2 |d| >= sqrt(cutoff) |u|. */
#define ROUNDED_EYE 1

bool fxl_cluster_is_surely_turned_away(const fxl_cluster *cluster, const fxl_point *eye,
                                       const fxl_model_view *model_view)
{
    (void)model_view;
    return fxl_is_in_cone(cluster, eye, ROUNDED_EYE);
}

uint32_t fxl_list_clusters_by(const fxl_cluster_tests *tests, const fxl_scene *scene,
                              const fxl_model *model, const fxl_model_view *model_view, bool drops,
                              fxl_draw_entry *entries, uint32_t *front)
{
    return fxl_list_each_cluster(tests, scene, model, model_view, drops, entries, front);
}
