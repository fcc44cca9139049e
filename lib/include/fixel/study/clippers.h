/* SPDX-License-Identifier: MIT */
/* The other clippers, each a constant record, and the functions that they are made of. */
#ifndef FXL_EXTRA_CLIPPERS_H
#define FXL_EXTRA_CLIPPERS_H

#include "fixel/box.h"
#include "fixel/study/clip_once.h"
#include "fixel/clip_record.h"
#include "fixel/study/clip_world.h"
#include "fixel/half_space.h"
#include "fixel/line.h"
#include "fixel/study/normalised.h"
#include "fixel/plane_from_points.h"
#include "fixel/study/rectangle.h"
#include "fixel/split.h"
#include "fixel/study/triangle.h"
#include "fixel/study/workspace.h"

#endif
