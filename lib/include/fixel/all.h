/* SPDX-License-Identifier: MIT */
/* Every public header: the renderer, and all that a program attaches to it or draws beside it. */
#ifndef FXL_ALL_H
#define FXL_ALL_H

#include "fixel.h"
#include "fixel/beams.h"
#include "fixel/billboards.h"
#include "fixel/camera.h"
#include "fixel/changed.h"
#include "fixel/collide.h"
#include "fixel/crc.h"
#include "fixel/display.h"
#include "fixel/driver.h"
#include "fixel/horizon.h"
#include "fixel/light.h"
#include "fixel/line.h"
#include "fixel/lines.h"
#include "fixel/motion.h"
#include "fixel/order.h"
#include "fixel/orientation.h"
#include "fixel/overlay.h"
#include "fixel/pick.h"
#include "fixel/pixels.h"
#include "fixel/player.h"
#include "fixel/pump.h"
#include "fixel/records.h"
#include "fixel/setup.h"
#include "fixel/surfaces.h"
#include "fixel/tables.h"
#include "fixel/target.h"
#include "fixel/wire.h"
#include "fixel/world.h"

#endif
