/* SPDX-License-Identifier: MIT */
#include "oracle/clipper.h"

#include <stdlib.h>
#include <string.h>

#include "frames/methods.h"
#include "unit/polygon_face.h"
#include "study/clippers.h"

static const fxl_clipper *chosen = &fxl_clipper_view;
static int own_integers;

int oracle_clipper_choose(const char *name)
{
    const named_clipper *found = find_clipper(name);
    chosen = found ? found->clipper : chosen;
    return found != NULL;
}

void oracle_clipper_own_integers(void)
{
    own_integers = 1;
}

static int is_normalised(void)
{
    return chosen == &fxl_clipper_normalised || chosen == &fxl_clipper_once;
}

oracle_space oracle_clipper_space(const fxl_view *view)
{
    return own_integers && is_normalised() ? oracle_space_of_normalised(view)
                                           : oracle_space_of_view(view);
}

double oracle_clipper_bound(const fxl_lens *lens)
{
    if (chosen == &fxl_clipper_world) { /* two units of the world at the near plane */
        return 1.25 + 2.0 * lens->focal / lens->near_z;
    }
    if (own_integers && is_normalised()) {
        return 1.25;
    }
    return chosen == &fxl_clipper_normalised || oracle_clipper_wants_triangles() ? 2 : 1.25;
}

int oracle_clipper_wants_triangles(void)
{
    return chosen == &fxl_clipper_once || chosen == &fxl_clipper_triangles;
}

fxl_clip_result oracle_clipper_take(fxl_view *view, const fxl_polygon *polygon,
                                    fxl_screen_polygon *screens, int room_for, int *count)
{
    static fxl_clipper_work work;
    static fxl_clipper_workspace room;
    static polygon_face face;
    memset(&room, 0, sizeof room);
    view->frame += 1;
    if (chosen->begin != NULL) {
        chosen->begin(view);
    }
    polygon_face_set(&face, polygon, view, FXL_POLYGON_CAPACITY);
    face.model_view.clipper_workspace = &room;
    fxl_clip_result result = chosen->clip(&face.model_view, &face.face, &work, &screens[0]);
    fxl_clip_result now = result;
    *count = 0;
    while (now == FXL_CLIP_INSIDE || now == FXL_CLIP_CUT || now == FXL_CLIP_BETWEEN) {
        *count += 1;
        if (chosen->next == NULL) {
            break;
        }
        if (*count == room_for) {
            abort(); /* the caller's array is too small */
        }
        now = chosen->next(&face.model_view, &work, &screens[*count]);
    }
    return result;
}
