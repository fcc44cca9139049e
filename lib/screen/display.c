/* SPDX-License-Identifier: MIT */
#include "fixel/driver.h"

#define BLACK_BYTES 64u

bool fxl_display_command(const fxl_display *display, uint8_t code, const uint8_t *data, size_t size)
{
    const fxl_display_port *port = display->port;
    return port->send(port->user, false, &code, 1) &&
           (size == 0 || port->send(port->user, true, data, size));
}

bool fxl_display_start_data(const fxl_display *display, const uint8_t *bytes, size_t size)
{
    const fxl_display_port *port = display->port;
    return port->start != NULL ? port->start(port->user, bytes, size)
                               : port->send(port->user, true, bytes, size);
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fxl_display *display = (const fxl_display *)user;
    const fxl_pixel_format *format = display->pixels.format;
    /* send_rows reads as many bytes as the frame's rows have. Rows that do not begin with a page
     * reach into one page more than their bytes are for. */
    if (rows == 0 || first_row % format->rows != 0 || first_row + rows > display->frame_height ||
        size != fxl_pixels_size(format, display->frame_width, rows)) {
        return false;
    }
    return display->config.driver->family->send_rows(display, display->left,
                                                     (uint16_t)(display->top + first_row),
                                                     display->frame_width, rows, bytes, size);
}

static bool wait_for_port(const fxl_display_port *port)
{
    return port->wait == NULL || port->wait(port->user);
}

static bool wait(void *user)
{
    return wait_for_port(((const fxl_display *)user)->port);
}

/* Whether a glass has pixels and lies in the memory that its module is wired for, and that one in
 * the controller's. The sums are below 2^17. */
static bool is_sound(const fxl_display_module *module)
{
    return module->width > 0 && module->height > 0 &&
           (uint32_t)module->left + module->width <= module->columns &&
           (uint32_t)module->top + module->height <= module->rows &&
           module->columns <= module->driver->memory_columns &&
           module->rows <= module->driver->memory_rows;
}

/* Of pages, mirrored rows are those of the glass: the row of the memory that it begins with stays
 * the first one. */
fxl_display_config fxl_display_config_turned(const fxl_display_module *module,
                                             uint32_t quarter_turns)
{
    fxl_display_config config = {NULL, 0, 0, 0, 0, 0, false, 0, 0, 0, NULL};
    if (module == NULL || module->driver == NULL || quarter_turns > 3 || !is_sound(module)) {
        return config;
    }
    const fxl_display_family *family = module->driver->family;
    const bool is_exchanged = quarter_turns % 2u == 1u;
    const bool is_mirrored_across = quarter_turns == 1 || quarter_turns == 2;
    const bool is_mirrored_down = quarter_turns >= 2;
    if (is_exchanged && family->exchanges == 0) {
        return config;
    }
    const uint16_t left = is_mirrored_across
                              ? (uint16_t)(module->columns - module->width - module->left)
                              : module->left;
    const uint16_t top = is_mirrored_down && family->exchanges != 0
                             ? (uint16_t)(module->rows - module->height - module->top)
                             : module->top;
    config.driver = module->driver;
    config.width = is_exchanged ? module->height : module->width;
    config.height = is_exchanged ? module->width : module->height;
    config.left = is_exchanged ? top : left;
    config.top = is_exchanged ? left : top;
    config.access = (uint8_t)(module->access ^ (is_exchanged ? family->exchanges : 0u) ^
                              (is_mirrored_across ? family->mirrors_columns : 0u) ^
                              (is_mirrored_down ? family->mirrors_rows : 0u));
    config.is_inverted = module->is_inverted;
    config.com_pins = module->com_pins;
    config.display_offset = is_mirrored_down && module->display_offset != 0
                                ? (uint8_t)(module->driver->memory_rows - module->display_offset)
                                : module->display_offset;
    config.current_reference = module->current_reference;
    config.extra_commands = module->extra_commands;
    return config;
}

fxl_display_config fxl_display_config_default(const fxl_display_driver *driver,
                                              uint32_t quarter_turns)
{
    fxl_display_module module = {NULL, 0, 0, 0, 0, 0, 0, 0, false, 0, 0, 0, NULL};
    if (driver != NULL) {
        module.driver = driver;
        module.width = driver->width;
        module.height = driver->height;
        module.left = driver->left;
        module.columns = (uint16_t)(driver->width + 2u * driver->left);
        module.rows = driver->height;
        module.access = driver->access;
        module.is_inverted = driver->is_inverted;
    }
    return fxl_display_config_turned(&module, quarter_turns);
}

fxl_status fxl_display_place(fxl_display *display, uint16_t width, uint16_t height)
{
    if (display == NULL) {
        return FXL_E_ARGUMENT;
    }
    const fxl_display_config *config = &display->config;
    if (width == 0 || height == 0 || width > config->width || height > config->height) {
        return FXL_E_RANGE;
    }
    uint32_t above = (config->height - height) / 2u;
    above -= above % display->pixels.format->rows;
    display->left = (uint16_t)(config->left + (config->width - width) / 2u);
    display->top = (uint16_t)(config->top + above); /* both within the memory */
    display->frame_width = width;
    display->frame_height = height;
    return FXL_OK;
}

/* The controller's memory holds noise when power comes. Black is 0 in every format. */
static bool make_black(const fxl_display *display)
{
    static const uint8_t black[BLACK_BYTES] = {0};
    const fxl_display_config *config = &display->config;
    const fxl_pixel_format *format = config->driver->family->format;
    const uint32_t fit = 8u * BLACK_BYTES / ((uint32_t)format->rows * format->bits); /* columns */
    for (uint32_t y = 0; y < config->height; y += format->rows) {
        for (uint32_t x = 0; x < config->width;) {
            const uint32_t left = config->width - x;
            const uint16_t width = (uint16_t)(left < fit ? left : fit);
            if (!config->driver->family->send_rows(display, (uint16_t)(config->left + x),
                                                   (uint16_t)(config->top + y), width, format->rows,
                                                   black, fxl_pixels_size(format, width, 1)) ||
                !wait_for_port(display->port)) {
                return false;
            }
            x += width;
        }
    }
    return true;
}

/* Whether the glass has pixels, all in the controller's memory, and begins and ends with a page.
 * The sums are below 2^17. */
static bool is_in_memory(const fxl_display_config *config)
{
    const fxl_display_driver *driver = config->driver;
    const uint32_t page = driver->family->format->rows;
    const bool is_exchanged = (config->access & driver->family->exchanges) != 0;
    const uint32_t columns = is_exchanged ? driver->memory_rows : driver->memory_columns;
    const uint32_t rows = is_exchanged ? driver->memory_columns : driver->memory_rows;
    return config->width > 0 && config->height > 0 &&
           (uint32_t)config->left + config->width <= columns &&
           (uint32_t)config->top + config->height <= rows && config->top % page == 0 &&
           config->height % page == 0;
}

bool fxl_display_send_commands(const fxl_display *display, const uint8_t *commands)
{
    for (; *commands != 0; commands += 1u + *commands) {
        if (!display->config.driver->family->send_command(display, commands + 1, *commands)) {
            return false;
        }
    }
    return true;
}

fxl_status fxl_display_open(fxl_display *display, const fxl_display_config *config,
                            const fxl_display_port *port, const uint8_t *palette)
{
    if (display == NULL || config == NULL || port == NULL || palette == NULL ||
        port->send == NULL || port->pause == NULL || (port->start != NULL && port->wait == NULL)) {
        return FXL_E_ARGUMENT;
    }
    if (config->driver == NULL || !is_in_memory(config)) {
        return FXL_E_RANGE;
    }
    const fxl_display_family *family = config->driver->family;
    display->config = *config;
    display->port = port;
    display->sink.user = display;
    display->sink.start = start;
    display->sink.wait = wait;
    (void)fxl_pixels_init(&display->pixels, family->format, palette);
    (void)fxl_display_place(display, config->width, config->height);
    return family->set_up(display) &&
                   (config->extra_commands == NULL ||
                    fxl_display_send_commands(display, config->extra_commands)) &&
                   make_black(display) && fxl_display_command(display, family->turn_on, NULL, 0)
               ? FXL_OK
               : FXL_E_DISPLAY;
}
