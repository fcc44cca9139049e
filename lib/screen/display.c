/* SPDX-License-Identifier: MIT */
#include "fixel/driver.h"

#define BLACK_BYTES 56u /* a row of 400 pixels of one bit, and no more: boards of little flash */

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

/* How many rows a row, or a count of rows, is beyond the beginning of a page, which has 1 or 8. */
static uint32_t rows_beyond_page(const fxl_pixel_format *format, uint32_t row)
{
    return row & (format->rows - 1u);
}

/* How many columns a column, or a count of columns, is beyond the beginning of an address. */
static uint32_t columns_beyond_address(const fxl_display_family *family, uint32_t column)
{
    return column & family->columns_less_1;
}

/* changed 4.3 */
static bool start_box(void *user, const fxl_screen_box *box, const uint8_t *bytes, size_t size)
{
    fxl_display *display = (fxl_display *)user;
    const fxl_display_family *family = display->driver->family;
    const fxl_pixel_format *format = display->pixels.format;
    const uint32_t end = (uint32_t)box->first_column + box->columns;
    const uint32_t sides = box->first_column | (end != display->frame_width ? end : 0u);
    /* send_rows reads as many bytes as the box has. Rows that do not begin with a page, and columns
     * that do not begin or end with an address, reach into one more than their bytes are for. */
    if (box->rows == 0 || box->first_row + box->rows > display->frame_height ||
        end > display->frame_width ||
        (rows_beyond_page(format, box->first_row) | columns_beyond_address(family, sides)) != 0 ||
        size != fxl_pixels_size(format, box->columns, box->rows)) {
        return false;
    }
    if (box->first_row == 0) {
        display->frame++;
    }
    return family->send_rows(display, (uint16_t)(display->left + box->first_column),
                             (uint16_t)(display->top + box->first_row), box->columns, box->rows,
                             bytes, size);
}

static bool start(void *user, uint16_t first_row, uint16_t rows, const uint8_t *bytes, size_t size)
{
    const fxl_screen_box box = {0, ((const fxl_display *)user)->frame_width, first_row, rows};
    return start_box(user, &box, bytes, size);
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
 * the controller's, whose rows are rows at turn 0. The sums are below 2^17. */
static bool is_sound(const fxl_display_module *module)
{
    return module->width > 0 && module->height > 0 &&
           (uint32_t)module->left + module->width <= module->columns &&
           (uint32_t)module->top + module->height <= module->rows &&
           module->columns <= module->driver->memory_columns &&
           module->rows <= module->driver->memory_rows &&
           (module->access & module->driver->family->exchanges) == 0;
}

static const fxl_display_config no_config = {NULL, 0, 0, 0, 0, 0, false, 0, 0, 0, NULL};

static bool exchanges(uint32_t quarter_turns)
{
    return (quarter_turns & 1u) != 0;
}

static bool mirrors_across(uint32_t quarter_turns)
{
    return ((quarter_turns + 1u) & 2u) != 0; /* 1 and 2 */
}

static bool mirrors_down(uint32_t quarter_turns)
{
    return (quarter_turns & 2u) != 0; /* 2 and 3 */
}

/* A family without a bit for an exchange has no quarter turns, and one without bits for mirrors none
 * at all. */
static bool can_turn(const fxl_display_driver *driver, uint32_t quarter_turns)
{
    return driver != NULL && quarter_turns <= 3 &&
           (!exchanges(quarter_turns) || driver->family->exchanges != 0) &&
           (quarter_turns == 0 || driver->family->mirrors_rows != 0);
}

/* An access at a turn, in the driver's own bits. */
static uint8_t turned_access(const fxl_display_driver *driver, uint32_t access,
                             uint32_t quarter_turns)
{
    const fxl_display_family *family = driver->family;
    if (exchanges(quarter_turns)) {
        access ^= family->exchanges;
    }
    if (mirrors_across(quarter_turns)) {
        access ^= family->mirrors_columns;
    }
    if (mirrors_down(quarter_turns)) {
        access ^= family->mirrors_rows;
    }
    return (uint8_t)access;
}

/* Of pages, one axis is mirrored as the glass is scanned: the row of the memory, or the column of
 * an SH1107, that the glass begins with stays the first one. */
FXL_COLD fxl_display_config fxl_display_config_turned(const fxl_display_module *module,
                                                      uint32_t quarter_turns)
{
    fxl_display_config config = no_config;
    if (module == NULL || !can_turn(module->driver, quarter_turns) || !is_sound(module)) {
        return config;
    }
    const fxl_display_driver *driver = module->driver;
    const bool is_exchanged = exchanges(quarter_turns), is_mirrored = mirrors_down(quarter_turns);
    const bool is_left_kept = driver->scans_columns;
    const bool is_top_kept = driver->family->exchanges == 0 && !driver->scans_columns;
    const uint16_t left = mirrors_across(quarter_turns) && !is_left_kept
                              ? (uint16_t)(module->columns - module->width - module->left)
                              : module->left;
    const uint16_t top = is_mirrored && !is_top_kept
                             ? (uint16_t)(module->rows - module->height - module->top)
                             : module->top;
    config.driver = driver;
    config.width = is_exchanged ? module->height : module->width;
    config.height = is_exchanged ? module->width : module->height;
    config.left = is_exchanged ? top : left;
    config.top = is_exchanged ? left : top;
    config.access = turned_access(driver, module->access, quarter_turns);
    config.is_inverted = module->is_inverted;
    config.com_pins = module->com_pins;
    config.display_offset = is_mirrored && module->display_offset != 0
                                ? (uint8_t)(driver->memory_rows - module->display_offset)
                                : module->display_offset;
    config.current_reference = module->current_reference;
    config.extra_commands = module->extra_commands;
    return config;
}

/* The glass takes all rows. Of colours it lies in the middle of the columns that its module is wired
 * for, so a program that names no module does not link the function above. */
FXL_COLD fxl_display_config fxl_display_config_default(const fxl_display_driver *driver,
                                                       uint32_t quarter_turns)
{
    if (!can_turn(driver, quarter_turns)) {
        return no_config;
    }
    const bool is_exchanged = exchanges(quarter_turns);
    const uint16_t width = driver->width, height = driver->height;
    uint32_t left = driver->left;
    if (quarter_turns != 0 && driver->family->exchanges == 0) {
        left = (uint32_t)driver->memory_columns - width - left;
    }
    const fxl_display_config config = {driver,
                                       is_exchanged ? height : width,
                                       is_exchanged ? width : height,
                                       (uint16_t)(is_exchanged ? 0 : left),
                                       (uint16_t)(is_exchanged ? left : 0),
                                       turned_access(driver, driver->access, quarter_turns),
                                       driver->is_inverted,
                                       0,
                                       0,
                                       0,
                                       NULL};
    return config;
}

FXL_COLD fxl_status fxl_display_place(fxl_display *display, uint16_t width, uint16_t height)
{
    if (display == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (width == 0 || height == 0 || width > display->glass_width ||
        height > display->glass_height) {
        return FXL_E_RANGE;
    }
    uint32_t above = (display->glass_height - height) / 2u;
    uint32_t before = (display->glass_width - width) / 2u;
    above -= rows_beyond_page(display->pixels.format, above);
    before -= columns_beyond_address(display->driver->family, before);
    /* Both sums are within the memory. */
    display->left = (uint16_t)(display->glass_left + before);
    display->top = (uint16_t)(display->glass_top + above);
    display->frame_width = width;
    display->frame_height = height;
    return FXL_OK;
}

/* The controller's memory holds noise when power comes. Black is 0 in every format. */
static bool make_black(const fxl_display *display)
{
    static const uint8_t black[BLACK_BYTES] = {0};
    const fxl_display_family *family = display->driver->family;
    const fxl_pixel_format *format = family->format;
    const uint32_t fit = 8u * BLACK_BYTES / ((uint32_t)format->rows * format->bits); /* columns */
    for (uint32_t y = 0; y < display->glass_height; y += format->rows) {
        for (uint32_t x = 0; x < display->glass_width;) {
            const uint32_t left = display->glass_width - x;
            const uint16_t width = (uint16_t)(left < fit ? left : fit);
            if (!family->send_rows(display, (uint16_t)(display->glass_left + x),
                                   (uint16_t)(display->glass_top + y), width, format->rows, black,
                                   fxl_pixels_size(format, width, 1)) ||
                !wait_for_port(display->port)) {
                return false;
            }
            x += width;
        }
    }
    return true;
}

/* Whether the glass has pixels, all in the controller's memory, and begins and ends with a page and
 * an address. The sums are below 2^17. */
static bool is_in_memory(const fxl_display_config *config)
{
    const fxl_display_driver *driver = config->driver;
    const bool is_exchanged = (config->access & driver->family->exchanges) != 0;
    const uint32_t columns = is_exchanged ? driver->memory_rows : driver->memory_columns;
    const uint32_t rows = is_exchanged ? driver->memory_columns : driver->memory_rows;
    return config->width > 0 && config->height > 0 &&
           (uint32_t)config->left + config->width <= columns &&
           (uint32_t)config->top + config->height <= rows &&
           (rows_beyond_page(driver->family->format, (uint32_t)config->top | config->height) |
            columns_beyond_address(driver->family, (uint32_t)config->left | config->width)) == 0;
}

bool fxl_display_send_commands(const fxl_display *display, const uint8_t *commands)
{
    uint32_t size = 0;
    while (commands != NULL && (size = *commands++) != 0) {
        if (!display->driver->family->send_command(display, commands, size)) {
            return false;
        }
        commands += size;
    }
    return true;
}

FXL_COLD fxl_status fxl_display_open(fxl_display *display, const fxl_display_config *config,
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
    display->driver = config->driver;
    display->glass_width = config->width;
    display->glass_height = config->height;
    display->glass_left = config->left;
    display->glass_top = config->top;
    display->access = config->access;
    display->frame = 0;
    display->port = port;
    display->sink.user = display;
    display->sink.start = start;
    display->sink.wait = wait;
    display->sink.start_box = family->takes_whole_rows ? NULL : start_box;
    display->sink.columns_less_1 = family->columns_less_1;
    (void)fxl_pixels_init(&display->pixels, family->format, palette);
    display->left = config->left; /* the frame fills the glass */
    display->top = config->top;
    display->frame_width = config->width;
    display->frame_height = config->height;
    return family->set_up(display, config) &&
                   fxl_display_send_commands(display, config->extra_commands) &&
                   make_black(display) && fxl_display_send_commands(display, family->turn_on)
               ? FXL_OK
               : FXL_E_DISPLAY;
}
