/* SPDX-License-Identifier: MIT */
/* What the functions of these headers refuse. */
#include "fixel/display.h"
#include "fixel/overlay.h"
#include "fixel/pixels.h"
#include "fixel/pump.h"
#include "../scene/reasons.h"

const char fxl_display_reasons[] =
    ON_ARGUMENT "display, config, port and palette must not be null, nor port->send and "
    "port->pause, nor port->wait beside port->start\0"
    ON_RANGE "config->driver must be a driver, config->left + width and top + height "
    "within its memory; a frame 1..width and 1..height of the glass; a memory LCD "
    "for fxl_display_alternate\0"
    ON_DISPLAY "port->send, start and wait must return true: look at the wires and the "
    "clock, then open the display again\0";

const char fxl_overlay_reasons[] =
    ON_ARGUMENT "band, sprite, text, style and size must not be null, nor band->pixels, "
    "sprite->pixels, style->font and its tables\0"
    ON_RANGE "band->width must be 1..1024, band->rows at least 1, and band->first_column "
    "+ columns at most width and stride; coordinates of a line within "
    "FXL_LINE_COORDINATE_MAX; bits of a sprite 1, 4 or 8; a font of 1..256 "
    "characters, `unknown` among them\0"
    ON_ALIGNMENT "band->pixels and palette must begin at an even address: a colour of RGB565 takes 2 "
    "bytes\0";

const char fxl_pixels_reasons[] =
    ON_ARGUMENT "pixels, format, palette, band, band->pixels and out must not be null, and "
    "band must have rows and columns\0"
    ON_RANGE "band->first_column + columns must be at most width and stride; with pages "
    "band->first_row must be a multiple of 8\0"
    ON_CAPACITY "size must be at least fxl_pixels_size(pixels->format, width, band->rows)\0"
    ON_ORDER "pixels was never prepared: fxl_pixels_init must answer FXL_OK first\0"
    ON_ALIGNMENT "out must be aligned to 4 bytes, pixels and palette of RGB565 to 2\0";

const char fxl_pump_reasons[] =
    ON_ARGUMENT "pump, config, sink with its functions, memory, renderer, eye, changed, box and "
    "rows must not be null\0"
    ON_RANGE "config->width and height must be 1..1024 and those of renderer and rows, "
    "config->rows 1..height and with pages a multiple of 8; a box and columns must "
    "begin and end as fxl_pump_steps says; eye->position "
    "within FXL_UNITS(-8191)..FXL_UNITS(8191)\0"
    ON_CAPACITY "memory_size must be at least fxl_pump_memory_size(config), and that of "
    "fxl_changed_init FXL_CHANGED_MEMORY for the scene\0"
    ON_ORDER "pump has no band, or was never set up: fxl_pump_init and fxl_pump_begin "
    "must answer FXL_OK first; renderer must be initialised\0"
    ON_ALIGNMENT "memory must be aligned to 8 bytes, config->palette and pixels of RGB565 to "
    "2\0"
    ON_PLACEMENT "the orientation of an instance in sight must be a rotation, to within "
    "2^-28\0"
    ON_DISPLAY "sink.start and sink.wait must return true: the display, or the wires to "
    "it, failed\0"
    ON_COMBINATION "config->palette must be the palette of an RGB565 renderer, and null for a "
    "palette of bytes; fxl_renderer_conflict names what else does not go "
    "together\0";
