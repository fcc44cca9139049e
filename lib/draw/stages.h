/* SPDX-License-Identifier: MIT */
/* The functions of all stages, for tests, benches and the study, which call a stage by itself.
 * Internal. */
#ifndef FXL_STAGES_H
#define FXL_STAGES_H

#include "../clip/clip_by_view.h"
#include "../clip/clip_view.h"
#include "../clip/split.h"
#include "../clip/volume.h"
#include "../math/plane.h"
#include "../raster/fill.h"
#include "../raster/scan.h"
#include "../scene/scene_check.h"
#include "../scene/lens.h"
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "../view/order.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/placement.h"
#include "../view/view.h"
#include "display_list.h"

#endif
