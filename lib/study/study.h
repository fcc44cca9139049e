/* SPDX-License-Identifier: MIT */
/* The study: the other clippers, each a constant record, and the functions that they are made of; the
 * span buffer and the scan by bounding boxes. It is an archive of its own, libfixel_study.a. */
#ifndef FXL_STUDY_H
#define FXL_STUDY_H

#include "clip_once.h"
#include "clip_world.h"
#include "clippers.h"
#include "half_space.h"
#include "targets.h"
#include "normalised.h"
#include "rectangle.h"
#include "scan_box.h"
#include "span_buffer.h"
#include "triangle.h"

#endif
