/* SPDX-License-Identifier: MIT */
/* The settings of LVGL for the tests of lv_fixel; all others are LVGL's own. */
#ifndef LV_CONF_H
#define LV_CONF_H

#define LV_COLOR_DEPTH                    16
#define LV_MEM_SIZE                       (256 * 1024U)
#define LV_DRAW_LAYER_SIMPLE_BUF_SIZE     (24 * 1024)
#define LV_DRAW_SW_SUPPORT_RGB565_SWAPPED 1
#define LV_DRAW_SW_SUPPORT_L8             1
#define LV_USE_SNAPSHOT                   1

#endif
