/* SPDX-License-Identifier: MIT */
/* Modules with displays as they are sold: what fxl_display_config_turned takes. A program links the
 * records that it names. None was tried on glass. docs/displays.md, "Modules as they are sold", has
 * a table of them: colours, SPI mode, clock, and where the pins are at turn 0. */
#ifndef FXL_MODULES_H
#define FXL_MODULES_H

#include "fixel/display.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place driver: the modules of a driver */
extern const fxl_display_module fxl_module_ili9341_240x320;          /* 2.4", 2.8" */
extern const fxl_display_module fxl_module_st7789_240x320;           /* 2.0" */
extern const fxl_display_module fxl_module_st7789_240x240;           /* 1.3", 1.54" */
extern const fxl_display_module fxl_module_st7789_135x240;           /* 1.14" */
extern const fxl_display_module fxl_module_st7789_172x320;           /* 1.47" */
extern const fxl_display_module fxl_module_st7789_170x320;           /* 1.9" */
extern const fxl_display_module fxl_module_st7789_240x280;           /* 1.69" */
extern const fxl_display_module fxl_module_st7735_128x160;           /* 1.8", black tab */
extern const fxl_display_module fxl_module_st7735_128x160_green;     /* 1.8", green tab */
extern const fxl_display_module fxl_module_st7735_128x128;           /* 1.44" */
extern const fxl_display_module fxl_module_st7735_128x128_row_32;    /* 1.44", another */
extern const fxl_display_module fxl_module_st7735_80x160;            /* 0.96" */
extern const fxl_display_module fxl_module_st7735_80x160_column_24;  /* 0.96", older */
extern const fxl_display_module fxl_module_st7796_320x480;           /* 3.5" */
extern const fxl_display_module fxl_module_st7796_222x480;           /* 2.33" */
extern const fxl_display_module fxl_module_ili9488_320x480;          /* 3.5" */
extern const fxl_display_module fxl_module_gc9a01_240x240;           /* 1.28", round */
extern const fxl_display_module fxl_module_ssd1351_128x128;          /* 1.5" */
extern const fxl_display_module fxl_module_ssd1351_128x96;           /* 1.27" */
extern const fxl_display_module fxl_module_ssd1306_128x64;           /* 0.96" */
extern const fxl_display_module fxl_module_ssd1306_128x64_com_02;    /* 0.96", another */
extern const fxl_display_module fxl_module_ssd1306_128x32;           /* 0.91" */
extern const fxl_display_module fxl_module_ssd1306_64x48;            /* 0.66" */
extern const fxl_display_module fxl_module_ssd1306_64x32;            /* 0.49" */
extern const fxl_display_module fxl_module_ssd1306_72x40;            /* 0.42" */
extern const fxl_display_module fxl_module_ssd1309_128x64;           /* 2.42" */
extern const fxl_display_module fxl_module_ssd1309_128x64_column_2;  /* 2.42", another */
extern const fxl_display_module fxl_module_sh1106_128x64;            /* 1.3" */
extern const fxl_display_module fxl_module_sh1106_72x40;             /* 0.42" */
extern const fxl_display_module fxl_module_sh1107_128x128;           /* 1.12" */
extern const fxl_display_module fxl_module_sh1107_128x128_column_96; /* 1.12", another */
extern const fxl_display_module fxl_module_sh1107_64x128;            /* 1.3", upright */
extern const fxl_display_module fxl_module_sh1107_80x128;            /* 0.78", upright */

#ifdef __cplusplus
}
#endif

#endif
