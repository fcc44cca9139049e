/* SPDX-License-Identifier: MIT */
#include "controller.h"

#include "unit.h"

/* place driver: its facts, and the model in C */
/* The columns and rows are those of the data sheets. */
const controller_facts controllers[] = {
    [CONTROLLER_ST7789] = {&fxl_st7789, PLAYS_MIPI, 1, 1, 240, 320, 240, 320, 0, INVERTED},
    [CONTROLLER_ILI9341] = {&fxl_ili9341, PLAYS_MIPI, 1, 1, 240, 320, 240, 320, 0,
                            MIRRORS_X | BLUE_FIRST},
    [CONTROLLER_ST7735] = {&fxl_st7735, PLAYS_MIPI, 1, 1, 132, 162, 128, 160, 0, MIRRORS_XY},
    [CONTROLLER_ST7796] = {&fxl_st7796, PLAYS_MIPI, 1, 1, 320, 480, 320, 480, 0,
                           MIRRORS_X | BLUE_FIRST},
    [CONTROLLER_ILI9488] = {&fxl_ili9488, PLAYS_MIPI, 1, 1, 320, 480, 320, 480, 0,
                            MIRRORS_X | BLUE_FIRST},
    [CONTROLLER_GC9A01] = {&fxl_gc9a01, PLAYS_MIPI, 1, 1, 240, 240, 240, 240, 0,
                           MIRRORS_X | INVERTED | BLUE_FIRST},
    [CONTROLLER_GC9107] = {&fxl_gc9107, PLAYS_MIPI, 1, 1, 128, 160, 128, 160, 0, BLUE_FIRST},
    [CONTROLLER_SSD1306] = {&fxl_ssd1306, PLAYS_PAGES, 8, 1, 128, 64, 128, 64, 0, MIRRORS_XY},
    [CONTROLLER_SSD1309] = {&fxl_ssd1309, PLAYS_PAGES, 8, 1, 128, 64, 128, 64, 0, MIRRORS_XY},
    [CONTROLLER_SSD1309_132] = {&fxl_ssd1309_132, PLAYS_PAGES, 8, 1, 132, 64, 128, 64, 2,
                                MIRRORS_XY},
    [CONTROLLER_SH1106] = {&fxl_sh1106, PLAYS_PAGES, 8, 1, 132, 64, 128, 64, 2, MIRRORS_XY},
    [CONTROLLER_SH1107] = {&fxl_sh1107, PLAYS_PAGES, 8, 1, 128, 128, 128, 128, 0, 0},
    [CONTROLLER_ST7565] = {&fxl_st7565, PLAYS_PAGES, 8, 1, 132, 64, 128, 64, 0,
                           MIRRORS_X | INVERTED},
    [CONTROLLER_PCD8544] = {&fxl_pcd8544, PLAYS_PAGES, 8, 1, 84, 48, 84, 48, 0, INVERTED},
    [CONTROLLER_SSD1351] = {&fxl_ssd1351, PLAYS_NONE, 1, 1, 128, 128, 128, 128, 0, MIRRORS_Y},
    [CONTROLLER_SSD1331] = {&fxl_ssd1331, PLAYS_NONE, 1, 1, 96, 64, 96, 64, 0, MIRRORS_XY},
    [CONTROLLER_SSD1327] = {&fxl_ssd1327, PLAYS_NONE, 1, 2, 128, 128, 128, 128, 0, MIRRORS_XY},
    [CONTROLLER_SSD1322] = {&fxl_ssd1322, PLAYS_NONE, 1, 4, 480, 128, 256, 64, 112, MIRRORS_Y},
    [CONTROLLER_LS013B7DH03] = {&fxl_ls013b7dh03, PLAYS_NONE, 1, 1, 128, 128, 128, 128, 0, 0},
    [CONTROLLER_LS027B7DH01] = {&fxl_ls027b7dh01, PLAYS_NONE, 1, 1, 400, 240, 400, 240, 0, 0},
};
FXL_STATIC_ASSERT(sizeof controllers / sizeof controllers[0] == CONTROLLERS,
                  "each controller has its facts");

static void take_data(controller *of, uint8_t byte);

static void take_bytes(void *user, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        take_data((controller *)user, bytes[i]);
    }
}

void controller_start(controller *of, int kind, uint16_t first_column, uint16_t first_row,
                      uint16_t columns, uint16_t rows)
{
    memset(of, 0, sizeof *of);
    of->kind = kind;
    of->is_colour = controllers[kind].plays == PLAYS_MIPI;
    of->columns = of->is_colour ? controllers[kind].width : controllers[kind].columns;
    of->rows = of->is_colour ? controllers[kind].height : controllers[kind].rows;
    of->first_column = first_column;
    of->first_row = first_row;
    of->kept_columns = columns;
    of->kept_rows = rows;
    of->format = 0x66; /* after reset: 18 bits a pixel */
    of->wire.take = take_bytes;
    of->wire.user = of;
    of->refused = UINT32_MAX;
    of->offset = of->start_row = of->clock = of->contrast = 1;
    of->is_all_on = true;
    of->function = 4; /* powered down */
    TEST_ASSERT_LESS_OR_EQUAL(CONTROLLER_MEMORY,
                              of->is_colour ? 2u * columns * rows : columns * ((rows + 7u) / 8u));
    memset(of->memory, 0xA5, sizeof of->memory);
}

void controller_strap(controller *of, uint16_t columns, uint16_t rows)
{
    of->columns = columns;
    of->rows = rows;
}

/* --- colour: the Display Command Set ------------------------------------------------------------
 */

/* Columns and rows are exchanged (bit 5), and either runs the other way (bits 6 and 7). */
static void put_pixel(controller *of, uint32_t x, uint32_t y, uint32_t colour)
{
    const bool exchanged = (of->access & 0x20u) != 0;
    uint32_t column = exchanged ? y : x, row = exchanged ? x : y;
    column = (of->access & 0x40u) != 0 ? of->columns - 1u - column : column;
    row = (of->access & 0x80u) != 0 ? of->rows - 1u - row : row;
    TEST_ASSERT_LESS_THAN(of->columns, column);
    TEST_ASSERT_LESS_THAN(of->rows, row);
    column -= of->first_column;
    row -= of->first_row;
    if (column < of->kept_columns && row < of->kept_rows) {
        uint8_t *at = &of->memory[2u * (row * of->kept_columns + column)];
        at[0] = (uint8_t)(colour >> 8);
        at[1] = (uint8_t)colour;
    }
}

/* RGB565 of three bytes, of which the upper six bits count. The lowest of red and of blue, which
 * RGB565 has not, is the highest one again. */
static uint32_t colour_of_18_bits(uint32_t bytes)
{
    TEST_ASSERT_EQUAL(bytes >> 23 & 1u, bytes >> 18 & 1u);
    TEST_ASSERT_EQUAL(bytes >> 7 & 1u, bytes >> 2 & 1u);
    return (bytes >> 8 & 0xF800u) | (bytes >> 5 & 0x07E0u) | (bytes >> 3 & 0x001Fu);
}

static void take_pixel_byte(controller *of, uint8_t byte)
{
    const bool has_three = of->kind == CONTROLLER_ILI9488;
    TEST_ASSERT_EQUAL_HEX8_MESSAGE(has_three ? 0x66 : 0x55, of->format, "pixels of another size");
    of->part = (of->part == 0 ? 1u : of->part) << 8 | byte;
    if (of->part < (has_three ? 1u << 24 : 1u << 16)) {
        return;
    }
    TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(of->range[1][1], of->y, "more pixels than the window has");
    put_pixel(of, of->x, of->y, has_three ? colour_of_18_bits(of->part) : of->part & 0xFFFFu);
    of->part = 0;
    if (of->x++ == of->range[0][1]) {
        of->x = of->range[0][0];
        of->y++;
    }
}

static void take_range(controller *of, uint32_t which)
{
    const uint32_t first = (uint32_t)of->arguments[0] << 8 | of->arguments[1];
    const uint32_t last = (uint32_t)of->arguments[2] << 8 | of->arguments[3];
    const bool is_columns = (which == 0) == ((of->access & 0x20u) == 0);
    TEST_ASSERT_LESS_OR_EQUAL(last, first);
    TEST_ASSERT_LESS_THAN(is_columns ? of->columns : of->rows, last);
    of->range[which][0] = (uint16_t)first;
    of->range[which][1] = (uint16_t)last;
}

/* Voltages and the scan of a GC9107, which its data sheet describes in part, as all public drivers
 * set them. */
static const uint8_t gc9107[][2] = {{0xB0, 0xC0}, {0xB2, 0x2F}, {0xB3, 0x03}, {0xB6, 0x19},
                                    {0xB7, 0x01}, {0xAC, 0xCB}, {0xAB, 0x0E}, {0xB4, 0x04},
                                    {0xA8, 0x19}, {0xB8, 0x08}, {0xE8, 0x24}, {0xE9, 0x48},
                                    {0xEA, 0x22}, {0xC6, 0x30}, {0xC7, 0x18}};
enum {
    REGISTERS_OF_GC9107 = sizeof gc9107 / sizeof gc9107[0]
};

/* Which of them, from 1 on; 0: none. */
static uint32_t register_of_gc9107(const controller *of, uint8_t command)
{
    uint32_t n = of->kind == CONTROLLER_GC9107 ? REGISTERS_OF_GC9107 : 0;
    while (n > 0 && gc9107[n - 1u][0] != command) {
        n--;
    }
    return n;
}

/* Arguments of a command. */
static uint32_t count_of(const controller *of, uint8_t command)
{
    return command == 0x2A || command == 0x2B   ? 4
           : command == 0x66 || command == 0x67 ? 10
           : command == 0xB6                    ? of->kind == CONTROLLER_GC9A01 ? 2 : 1
           : register_of_gc9107(of, command)    ? 1
           : command == 0x36 || command == 0x3A ? 1
                                                : 0;
}

/* Two registers of a GC9A01 that are in no data sheet, as all public drivers set them. */
static void take_undescribed(controller *of)
{
    static const uint8_t values[2][10] = {
        {0x3C, 0x00, 0xCD, 0x67, 0x45, 0x45, 0x10, 0x00, 0x00, 0x00},
        {0x00, 0x3C, 0x00, 0x00, 0x00, 0x01, 0x54, 0x10, 0x32, 0x98}};
    const uint32_t which = of->command - 0x66u;
    TEST_ASSERT_EQUAL_HEX8_ARRAY(values[which], of->arguments, 10);
    of->undescribed |= 1u << which;
}

static void take_argument(controller *of, uint8_t byte)
{
    TEST_ASSERT_LESS_THAN_MESSAGE(count_of(of, of->command), of->argument_count,
                                  "too many arguments");
    of->arguments[of->argument_count++] = byte;
    if (of->argument_count < count_of(of, of->command)) {
        return;
    }
    const uint32_t voltage = register_of_gc9107(of, of->command);
    if (voltage > 0) {
        TEST_ASSERT_EQUAL_HEX8(gc9107[voltage - 1u][1], byte);
        of->undescribed |= 1u << (voltage - 1u);
    } else if (of->command == 0x36) {
        of->access = byte;
    } else if (of->command == 0x3A) {
        of->format = byte;
    } else if (of->command == 0xB6) {
        TEST_ASSERT_EQUAL_HEX8_MESSAGE(0, of->arguments[1], "a picture that is mirrored");
        of->is_told_scan = true;
    } else if (of->command == 0x66 || of->command == 0x67) {
        take_undescribed(of);
    } else {
        take_range(of, of->command - 0x2Au);
    }
}

static void demand_frame_whole(const controller *of)
{
    if (of->command == 0x2C) {
        TEST_ASSERT_EQUAL_MESSAGE(0, of->part, "a part of a pixel");
        TEST_ASSERT_EQUAL_MESSAGE(of->range[1][1] + 1, of->y, "fewer pixels than the window has");
    }
}

static void take_colour_command(controller *of, uint8_t command)
{
    demand_frame_whole(of);
    TEST_ASSERT_EQUAL_MESSAGE(count_of(of, of->command), of->argument_count,
                              "arguments are missing");
    of->command = command;
    of->argument_count = 0;
    if (register_of_gc9107(of, command) > 0 || command == 0x66 || command == 0x67 ||
        command == 0xB6) {
        TEST_ASSERT_EQUAL_MESSAGE(2, of->unlocks, "it is locked");
    }
    switch (command) {
    case 0xFE:
    case 0xEF:
        TEST_ASSERT_TRUE(of->kind == CONTROLLER_GC9A01 || of->kind == CONTROLLER_GC9107);
        of->unlocks = command == 0xFE ? 1 : of->unlocks == 1 ? 2 : 0;
        break;
    case 0x01: /* reset */
        of->has_reset = true;
        of->is_awake = of->is_on = of->is_inverted = false;
        of->undescribed = of->paused = 0;
        break;
    case 0x11: /* out of sleep */
        TEST_ASSERT_TRUE_MESSAGE(of->has_reset && of->paused >= 120, "not yet after a reset");
        of->is_awake = true;
        of->paused = 0;
        break;
    case 0x20:
    case 0x21:
        of->is_inverted = command == 0x21;
        break;
    case 0x29:
        TEST_ASSERT_TRUE_MESSAGE(of->is_awake && of->paused >= 120, "not yet out of sleep");
        TEST_ASSERT_EQUAL_MESSAGE(of->kind == CONTROLLER_GC9A01, of->is_told_scan, "the scan");
        TEST_ASSERT_EQUAL(of->kind == CONTROLLER_GC9A01   ? 3
                          : of->kind == CONTROLLER_GC9107 ? (1u << REGISTERS_OF_GC9107) - 1u
                                                          : 0,
                          of->undescribed);
        of->is_on = true;
        break;
    case 0x2C:
        of->x = of->range[0][0];
        of->y = of->range[1][0];
        break;
    default:
        TEST_ASSERT_NOT_EQUAL_MESSAGE(0, count_of(of, command), "no such command");
        break;
    }
}

/* --- pages --------------------------------------------------------------------------------------
 */

static void take_page_byte(controller *of, uint8_t byte)
{
    const uint32_t column = (uint32_t)of->x - of->first_column;
    TEST_ASSERT_LESS_THAN_MESSAGE(of->columns, of->x, "past the last column");
    if (column < of->kept_columns && of->y < of->kept_rows / 8) {
        of->memory[of->y * of->kept_columns + column] = byte;
    }
    of->x++; /* the page stays */
}

/* Bytes of a command, its own included; 0 where there is no such command. */
static uint32_t length_of(const controller *of, uint8_t command)
{
    static const uint8_t all[] = {0x81, 0xA8, 0xD3, 0xD5, 0xD9, 0xDB};
    static const uint8_t others[CONTROLLERS][3] = {[CONTROLLER_SSD1306] = {0x20, 0x8D, 0xAD},
                                                   [CONTROLLER_SSD1309] = {0x20, 0xFD, 0xFD},
                                                   [CONTROLLER_SSD1309_132] = {0x20, 0xFD, 0xFD},
                                                   [CONTROLLER_SH1106] = {0xAD, 0xAD, 0xAD},
                                                   [CONTROLLER_SH1107] = {0xAD, 0xDC, 0xDC}};
    const bool is_sh1107 = of->kind == CONTROLLER_SH1107;
    if (of->kind == CONTROLLER_ST7565) { /* none for multiplex, offset and clock */
        const bool is_one = command < 0x30 || (command >= 0x40 && command < 0x80) ||
                            (command >= 0xA0 && command <= 0xB8 && command / 2 != 0xAC / 2) ||
                            command == 0xC0 || command == 0xC8 || command == 0xE2;
        return command == 0x81 || command == 0xF8 ? 2 : is_one ? 1 : 0;
    }
    if (memchr(all, command, sizeof all) != NULL || memchr(others[of->kind], command, 3) != NULL ||
        (command == 0xDA && !is_sh1107)) {
        return 2;
    }
    const bool is_known =
        command < (is_sh1107 ? 0x18 : 0x20) ||
        (is_sh1107 ? command == 0x20 || command == 0x21 : command >= 0x40 && command < 0x80) ||
        (command >= 0xA0 && command <= 0xA1) || (command >= 0xA4 && command <= 0xA7) ||
        (command >= 0xAE && command < 0xB0 + of->rows / 8) || command == 0xC0 || command == 0xC8;
    return is_known ? 1 : 0;
}

static void take_page_command(controller *of, const uint8_t *command)
{
    const uint8_t code = command[0];
    if (code < 0x10) {
        of->x = (uint16_t)((of->x & 0xF0u) | (code & 15u));
    } else if (code < 0x20) {
        of->x = (uint16_t)((of->x & 15u) | (code & 15u) << 4);
    } else if (of->kind == CONTROLLER_ST7565 && code < 0x30) {
        of->is_charged = code >= 0x28 ? code == 0x2F : of->is_charged; /* all three circuits */
    } else if (code == 0xE2) {
        of->has_reset = true;
        of->is_charged = false;
    } else if (code == 0x20) {
        of->mode = of->kind == CONTROLLER_SH1107 ? 2 : command[1]; /* 2: page by page */
    } else if (code >= 0xB0 && code <= 0xBF) {
        of->y = code & 15u;
    } else if (code == 0xA8) {
        of->multiplex = command[1];
    } else if (code == 0xDA) {
        of->wires = command[1];
    } else if (code == 0xD3) {
        of->offset = command[1];
    } else if (code == 0xD5) {
        of->clock = command[1];
    } else if (code == 0x81) {
        of->contrast = command[1];
    } else if (code == 0xDC || (code >= 0x40 && code < 0x80)) {
        of->start_row = code == 0xDC ? command[1] : code & 63u;
    } else if (code >= 0xA4 && code <= 0xA5) {
        of->is_all_on = code == 0xA5;
    } else if (code == 0xAD && of->kind == CONTROLLER_SSD1306) {
        of->reference = command[1];
    } else if (code == 0x8D || code == 0xAD) {
        of->is_charged = command[1] == (code == 0x8D                    ? 0x14
                                        : of->kind == CONTROLLER_SH1107 ? 0x8A /* by another */
                                                                        : 0x8B);
    } else if (code == 0xFD) { /* its lock: there is no converter */
        of->is_charged = command[1] == 0x12;
    } else if (code >= 0xA0 && code <= 0xA1) {
        of->access = (uint8_t)((of->access & ~1u) | (code & 1u));
    } else if (code == 0xC0 || code == 0xC8) {
        of->access = (uint8_t)((of->access & ~8u) | (code & 8u));
    } else if (code >= 0xA6 && code <= 0xA7) {
        of->is_inverted = code == 0xA7;
    } else if (code >= 0xAE && code <= 0xAF) {
        of->is_on = code == 0xAF;
    }
}

/* A PCD8544: bit 0 of its function chooses between two sets of commands. */
static void take_pcd8544_command(controller *of, uint8_t code)
{
    if ((code & 0xF8u) == 0x20) {
        of->function = code & 7u;
    } else if ((of->function & 1u) != 0) {
        of->voltage = (code & 0x80u) != 0 ? code & 0x7Fu : of->voltage;
        of->bias = (code & 0xF8u) == 0x10 ? code & 7u : of->bias;
        TEST_ASSERT_TRUE_MESSAGE(code >= 0x80 || (code & 0xF8u) == 0x10 || (code & 0xFCu) == 0x04,
                                 "no such command");
    } else if ((code & 0x80u) != 0) {
        of->x = code & 0x7Fu;
        TEST_ASSERT_LESS_THAN(of->columns, of->x);
    } else if ((code & 0xF8u) == 0x40) {
        of->y = code & 7u;
        TEST_ASSERT_LESS_THAN(of->rows / 8, of->y);
    } else {
        TEST_ASSERT_EQUAL_HEX8_MESSAGE(0x08, code & 0xFAu, "no such command");
        of->is_all_on = code != 0x0C && code != 0x0D; /* or all off */
        of->is_inverted = code == 0x0D;
    }
    of->is_on = (of->function & 4u) == 0;
    of->is_charged = of->voltage > 0 && of->bias == 3; /* that of 48 rows */
}

static void take_page_commands(controller *of, const uint8_t *bytes, size_t size)
{
    for (size_t i = 0; of->kind == CONTROLLER_PCD8544 && i < size; i++) {
        take_pcd8544_command(of, bytes[i]);
    }
    for (size_t i = 0; of->kind != CONTROLLER_PCD8544 && i < size;) {
        const uint32_t length = length_of(of, bytes[i]);
        TEST_ASSERT_NOT_EQUAL_MESSAGE(0, length, "no such command");
        TEST_ASSERT_LESS_OR_EQUAL_MESSAGE(size - i, length, "an argument is missing");
        take_page_command(of, &bytes[i]);
        i += length;
    }
}

/* --- wires --------------------------------------------------------------------------------------
 */

static void take_data(controller *of, uint8_t byte)
{
    if (!of->is_colour) {
        take_page_byte(of, byte);
    } else if (of->command == 0x2C) {
        take_pixel_byte(of, byte);
    } else {
        take_argument(of, byte);
    }
}

bool controller_send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    controller *of = (controller *)user;
    TEST_ASSERT_NULL_MESSAGE(of->wire.bytes, "used while a transfer is under way");
    TEST_ASSERT_GREATER_THAN(0, size);
    if (of->sends++ == of->refused) {
        return false;
    }
    if (is_data) {
        take_bytes(of, bytes, size);
    } else if (of->is_colour) {
        TEST_ASSERT_EQUAL(1, size);
        take_colour_command(of, bytes[0]);
    } else {
        take_page_commands(of, bytes, size);
    }
    return true;
}

bool controller_begin(void *user, const uint8_t *bytes, size_t size)
{
    controller *of = (controller *)user;
    if (of->sends++ == of->refused) {
        return false;
    }
    transfer_start(&of->wire, bytes, size);
    return true;
}

bool controller_wait(void *user)
{
    transfer_wait(&((controller *)user)->wire);
    return true;
}

void controller_pause(void *user, uint32_t milliseconds)
{
    ((controller *)user)->paused += milliseconds;
}

uint32_t controller_pixel(const controller *of, uint16_t column, uint16_t row)
{
    const uint32_t x = (uint32_t)column - of->first_column, y = (uint32_t)row - of->first_row;
    TEST_ASSERT_TRUE(x < of->kept_columns && y < of->kept_rows);
    if (of->is_colour) {
        const uint8_t *at = &of->memory[2u * (y * of->kept_columns + x)];
        return (uint32_t)at[0] << 8 | at[1];
    }
    return (uint32_t)of->memory[y / 8u * of->kept_columns + x] >> (y & 7u) & 1u;
}
