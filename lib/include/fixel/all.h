/* SPDX-License-Identifier: MIT */
/* Every public header: the renderer, its stages, and all extras. */
#ifndef FXL_ALL_H
#define FXL_ALL_H

#include "fixel.h"
#include "fixel/extra/beams.h"
#include "fixel/extra/bsp.h"
#include "fixel/extra/clippers.h"
#include "fixel/extra/light.h"
#include "fixel/extra/player.h"
#include "fixel/extra/spans.h"
#include "fixel/extra/wire.h"
#include "fixel/extra/world.h"
#include "fixel/stage/angle.h"
#include "fixel/stage/camera.h"
#include "fixel/stage/clip_view.h"
#include "fixel/stage/clipper.h"
#include "fixel/stage/cull.h"
#include "fixel/stage/display_list.h"
#include "fixel/stage/fill.h"
#include "fixel/stage/frustum.h"
#include "fixel/stage/lens.h"
#include "fixel/stage/model_view.h"
#include "fixel/stage/order.h"
#include "fixel/stage/outcode.h"
#include "fixel/stage/plane.h"
#include "fixel/stage/project.h"
#include "fixel/stage/scan.h"
#include "fixel/stage/sphere.h"
#include "fixel/stage/transform.h"
#include "fixel/stage/view.h"
#include "fixel/stage/visibility.h"

#endif
