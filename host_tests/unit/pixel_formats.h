/* SPDX-License-Identifier: MIT */
/* What pixels are converted to: lib/include/fixel/pixels.h. */
#ifndef PIXEL_FORMATS_H
#define PIXEL_FORMATS_H

#include "fixel/pixels.h"

/* place converter: the list of formats */
#define EVERY_FORMAT                                                                              \
    {&fxl_pixels_rgb565, &fxl_pixels_rgb565_low, &fxl_pixels_rgb332,    &fxl_pixels_rgb666,       \
     &fxl_pixels_grey4,  &fxl_pixels_mono_rows,  &fxl_pixels_mono_pages}

#endif
