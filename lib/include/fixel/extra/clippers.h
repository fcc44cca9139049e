/* SPDX-License-Identifier: MIT */
/* The other clippers, each a constant record, and the functions that they are made of. */
#ifndef FXL_EXTRA_CLIPPERS_H
#define FXL_EXTRA_CLIPPERS_H

#include "fixel/extra/clippers/box.h"
#include "fixel/extra/clippers/clip_once.h"
#include "fixel/extra/clippers/clip_record.h"
#include "fixel/extra/clippers/clip_world.h"
#include "fixel/extra/clippers/half_space.h"
#include "fixel/extra/clippers/line.h"
#include "fixel/extra/clippers/normalised.h"
#include "fixel/extra/clippers/plane_from_points.h"
#include "fixel/extra/clippers/rectangle.h"
#include "fixel/extra/clippers/split.h"
#include "fixel/extra/clippers/triangle.h"
#include "fixel/extra/clippers/workspace.h"

#endif
