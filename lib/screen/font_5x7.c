/* SPDX-License-Identifier: MIT */
/* The built-in font. A character is seven rows of five pixels, drawn below as names: an X is a
 * pixel. A narrow character has its pixels at the left, and what is right of it is not read. */
#include "fixel/overlay.h"

/* Every row of five pixels that a character may have, as the upper bits of a byte. */
enum {
    ooooo = 0,
    ooooX = 8,
    oooXo = 16,
    oooXX = 24,
    ooXoo = 32,
    ooXoX = 40,
    ooXXo = 48,
    ooXXX = 56,
    oXooo = 64,
    oXooX = 72,
    oXoXo = 80,
    oXoXX = 88,
    oXXoo = 96,
    oXXoX = 104,
    oXXXo = 112,
    oXXXX = 120,
    Xoooo = 128,
    XoooX = 136,
    XooXo = 144,
    XooXX = 152,
    XoXoo = 160,
    XoXoX = 168,
    XoXXo = 176,
    XoXXX = 184,
    XXooo = 192,
    XXooX = 200,
    XXoXo = 208,
    XXoXX = 216,
    XXXoo = 224,
    XXXoX = 232,
    XXXXo = 240,
    XXXXX = 248
};

static const uint8_t rows[][7] = {
    {ooooo, ooooo, ooooo, ooooo, ooooo, ooooo, ooooo}, /* space */
    {Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, ooooo, Xoooo}, /* ! */
    {XoXoo, XoXoo, XoXoo, ooooo, ooooo, ooooo, ooooo}, /* " */
    {oXoXo, oXoXo, XXXXX, oXoXo, XXXXX, oXoXo, oXoXo}, /* # */
    {ooXoo, oXXXX, XoXoo, oXXXo, ooXoX, XXXXo, ooXoo}, /* $ */
    {XXooX, XXooX, oooXo, ooXoo, oXooo, XooXX, XooXX}, /* % */
    {oXXoo, XooXo, XooXo, oXXoo, XooXX, XooXo, oXXoX}, /* & */
    {Xoooo, Xoooo, Xoooo, ooooo, ooooo, ooooo, ooooo}, /* ' */
    {ooXoo, oXooo, Xoooo, Xoooo, Xoooo, oXooo, ooXoo}, /* ( */
    {Xoooo, oXooo, ooXoo, ooXoo, ooXoo, oXooo, Xoooo}, /* ) */
    {ooooo, ooXoo, XoXoX, oXXXo, XoXoX, ooXoo, ooooo}, /* asterisk */
    {ooooo, ooXoo, ooXoo, XXXXX, ooXoo, ooXoo, ooooo}, /* + */
    {ooooo, ooooo, ooooo, ooooo, ooooo, oXooo, Xoooo}, /* , */
    {ooooo, ooooo, ooooo, XXXXo, ooooo, ooooo, ooooo}, /* - */
    {ooooo, ooooo, ooooo, ooooo, ooooo, ooooo, Xoooo}, /* . */
    {ooooX, ooooX, oooXo, ooXoo, oXooo, Xoooo, Xoooo}, /* slash */
    {oXXXo, XoooX, XooXX, XoXoX, XXooX, XoooX, oXXXo}, /* 0 */
    {oXooo, XXooo, oXooo, oXooo, oXooo, oXooo, XXXoo}, /* 1 */
    {oXXXo, XoooX, ooooX, oooXo, ooXoo, oXooo, XXXXX}, /* 2 */
    {oXXXo, XoooX, ooooX, ooXXo, ooooX, XoooX, oXXXo}, /* 3 */
    {oooXo, ooXXo, oXoXo, XooXo, XXXXX, oooXo, oooXo}, /* 4 */
    {XXXXX, Xoooo, XXXXo, ooooX, ooooX, XoooX, oXXXo}, /* 5 */
    {ooXXo, oXooo, Xoooo, XXXXo, XoooX, XoooX, oXXXo}, /* 6 */
    {XXXXX, ooooX, oooXo, oooXo, ooXoo, ooXoo, ooXoo}, /* 7 */
    {oXXXo, XoooX, XoooX, oXXXo, XoooX, XoooX, oXXXo}, /* 8 */
    {oXXXo, XoooX, XoooX, oXXXX, ooooX, oooXo, oXXoo}, /* 9 */
    {ooooo, ooooo, Xoooo, ooooo, ooooo, Xoooo, ooooo}, /* : */
    {ooooo, ooooo, oXooo, ooooo, ooooo, oXooo, Xoooo}, /* ; */
    {oooXo, ooXoo, oXooo, Xoooo, oXooo, ooXoo, oooXo}, /* < */
    {ooooo, ooooo, XXXXo, ooooo, XXXXo, ooooo, ooooo}, /* = */
    {Xoooo, oXooo, ooXoo, oooXo, ooXoo, oXooo, Xoooo}, /* > */
    {oXXXo, XoooX, ooooX, oooXo, ooXoo, ooooo, ooXoo}, /* ? */
    {oXXXo, XoooX, XoXXX, XoXoX, XoXXX, Xoooo, oXXXo}, /* @ */
    {oXXXo, XoooX, XoooX, XXXXX, XoooX, XoooX, XoooX}, /* A */
    {XXXXo, XoooX, XoooX, XXXXo, XoooX, XoooX, XXXXo}, /* B */
    {oXXXo, XoooX, Xoooo, Xoooo, Xoooo, XoooX, oXXXo}, /* C */
    {XXXXo, XoooX, XoooX, XoooX, XoooX, XoooX, XXXXo}, /* D */
    {XXXXX, Xoooo, Xoooo, XXXXo, Xoooo, Xoooo, XXXXX}, /* E */
    {XXXXX, Xoooo, Xoooo, XXXXo, Xoooo, Xoooo, Xoooo}, /* F */
    {oXXXo, XoooX, Xoooo, XoXXX, XoooX, XoooX, oXXXX}, /* G */
    {XoooX, XoooX, XoooX, XXXXX, XoooX, XoooX, XoooX}, /* H */
    {XXXoo, oXooo, oXooo, oXooo, oXooo, oXooo, XXXoo}, /* I */
    {ooXXX, oooXo, oooXo, oooXo, oooXo, XooXo, oXXoo}, /* J */
    {XoooX, XooXo, XoXoo, XXooo, XoXoo, XooXo, XoooX}, /* K */
    {Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, XXXXX}, /* L */
    {XoooX, XXoXX, XoXoX, XoXoX, XoooX, XoooX, XoooX}, /* M */
    {XoooX, XXooX, XXooX, XoXoX, XooXX, XooXX, XoooX}, /* N */
    {oXXXo, XoooX, XoooX, XoooX, XoooX, XoooX, oXXXo}, /* O */
    {XXXXo, XoooX, XoooX, XXXXo, Xoooo, Xoooo, Xoooo}, /* P */
    {oXXXo, XoooX, XoooX, XoooX, XoXoX, XooXo, oXXoX}, /* Q */
    {XXXXo, XoooX, XoooX, XXXXo, XoXoo, XooXo, XoooX}, /* R */
    {oXXXX, Xoooo, Xoooo, oXXXo, ooooX, ooooX, XXXXo}, /* S */
    {XXXXX, ooXoo, ooXoo, ooXoo, ooXoo, ooXoo, ooXoo}, /* T */
    {XoooX, XoooX, XoooX, XoooX, XoooX, XoooX, oXXXo}, /* U */
    {XoooX, XoooX, XoooX, oXoXo, oXoXo, ooXoo, ooXoo}, /* V */
    {XoooX, XoooX, XoooX, XoXoX, XoXoX, XXoXX, XoooX}, /* W */
    {XoooX, XoooX, oXoXo, ooXoo, oXoXo, XoooX, XoooX}, /* X */
    {XoooX, XoooX, oXoXo, ooXoo, ooXoo, ooXoo, ooXoo}, /* Y */
    {XXXXX, ooooX, oooXo, ooXoo, oXooo, Xoooo, XXXXX}, /* Z */
    {XXXoo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, XXXoo}, /* [ */
    {Xoooo, Xoooo, oXooo, ooXoo, oooXo, ooooX, ooooX}, /* backslash */
    {XXXoo, ooXoo, ooXoo, ooXoo, ooXoo, ooXoo, XXXoo}, /* ] */
    {ooXoo, oXoXo, XoooX, ooooo, ooooo, ooooo, ooooo}, /* ^ */
    {ooooo, ooooo, ooooo, ooooo, ooooo, ooooo, XXXXX}, /* _ */
    {Xoooo, oXooo, ooooo, ooooo, ooooo, ooooo, ooooo}, /* ` */
    {ooooo, ooooo, oXXoo, oooXo, oXXXo, XooXo, oXXXo}, /* a */
    {Xoooo, Xoooo, XXXoo, XooXo, XooXo, XooXo, XXXoo}, /* b */
    {ooooo, ooooo, oXXXo, Xoooo, Xoooo, Xoooo, oXXXo}, /* c */
    {oooXo, oooXo, oXXXo, XooXo, XooXo, XooXo, oXXXo}, /* d */
    {ooooo, ooooo, oXXoo, XooXo, XXXXo, Xoooo, oXXXo}, /* e */
    {ooXoo, oXooo, XXXoo, oXooo, oXooo, oXooo, oXooo}, /* f */
    {oXXXo, XooXo, XooXo, XooXo, oXXXo, oooXo, XXXoo}, /* g */
    {Xoooo, Xoooo, XXXoo, XooXo, XooXo, XooXo, XooXo}, /* h */
    {Xoooo, ooooo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo}, /* i */
    {ooXoo, ooooo, ooXoo, ooXoo, ooXoo, XoXoo, oXooo}, /* j */
    {Xoooo, Xoooo, XooXo, XoXoo, XXooo, XoXoo, XooXo}, /* k */
    {Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, oXooo}, /* l */
    {ooooo, ooooo, XXoXo, XoXoX, XoXoX, XoXoX, XoXoX}, /* m */
    {ooooo, ooooo, XXXoo, XooXo, XooXo, XooXo, XooXo}, /* n */
    {ooooo, ooooo, oXXoo, XooXo, XooXo, XooXo, oXXoo}, /* o */
    {XXXoo, XooXo, XooXo, XooXo, XXXoo, Xoooo, Xoooo}, /* p */
    {oXXXo, XooXo, XooXo, XooXo, oXXXo, oooXo, oooXo}, /* q */
    {ooooo, ooooo, XoXoo, XXooo, Xoooo, Xoooo, Xoooo}, /* r */
    {ooooo, ooooo, oXXXo, Xoooo, oXXoo, oooXo, XXXoo}, /* s */
    {oXooo, oXooo, XXXoo, oXooo, oXooo, oXooo, ooXoo}, /* t */
    {ooooo, ooooo, XooXo, XooXo, XooXo, XooXo, oXXXo}, /* u */
    {ooooo, ooooo, XoooX, XoooX, oXoXo, oXoXo, ooXoo}, /* v */
    {ooooo, ooooo, XoooX, XoXoX, XoXoX, XoXoX, oXoXo}, /* w */
    {ooooo, ooooo, XooXo, XooXo, oXXoo, XooXo, XooXo}, /* x */
    {XooXo, XooXo, XooXo, XooXo, oXXXo, oooXo, XXXoo}, /* y */
    {ooooo, ooooo, XXXXo, oooXo, oXXoo, Xoooo, XXXXo}, /* z */
    {ooXoo, oXooo, oXooo, Xoooo, oXooo, oXooo, ooXoo}, /* { */
    {Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo, Xoooo}, /* | */
    {Xoooo, oXooo, oXooo, ooXoo, oXooo, oXooo, Xoooo}, /* } */
    {ooooo, ooooo, oXooX, XoXoX, XooXo, ooooo, ooooo}  /* ~ */
};

/* The record of the character with this number, of this width. LOW: of one that begins `top` rows
 * below the top of the line, and so reaches below the baseline. */
#define LOW(number, width, top) \
    { \
        (number) * 7, width, 7, 0, top, (width) + 1, 0 \
    }
#define GLYPH(number, width) LOW(number, width, 0)

static const fxl_glyph glyphs[] = {
    GLYPH(0, 3),  GLYPH(1, 1),  GLYPH(2, 3),   GLYPH(3, 5),   GLYPH(4, 5),  GLYPH(5, 5),
    GLYPH(6, 5),  GLYPH(7, 1),  GLYPH(8, 3),   GLYPH(9, 3),   GLYPH(10, 5), GLYPH(11, 5),
    GLYPH(12, 2), GLYPH(13, 4), GLYPH(14, 1),  GLYPH(15, 5),  GLYPH(16, 5), GLYPH(17, 3),
    GLYPH(18, 5), GLYPH(19, 5), GLYPH(20, 5),  GLYPH(21, 5),  GLYPH(22, 5), GLYPH(23, 5),
    GLYPH(24, 5), GLYPH(25, 5), GLYPH(26, 1),  GLYPH(27, 2),  GLYPH(28, 4), GLYPH(29, 4),
    GLYPH(30, 4), GLYPH(31, 5), GLYPH(32, 5),  GLYPH(33, 5),  GLYPH(34, 5), GLYPH(35, 5),
    GLYPH(36, 5), GLYPH(37, 5), GLYPH(38, 5),  GLYPH(39, 5),  GLYPH(40, 5), GLYPH(41, 3),
    GLYPH(42, 5), GLYPH(43, 5), GLYPH(44, 5),  GLYPH(45, 5),  GLYPH(46, 5), GLYPH(47, 5),
    GLYPH(48, 5), GLYPH(49, 5), GLYPH(50, 5),  GLYPH(51, 5),  GLYPH(52, 5), GLYPH(53, 5),
    GLYPH(54, 5), GLYPH(55, 5), GLYPH(56, 5),  GLYPH(57, 5),  GLYPH(58, 5), GLYPH(59, 3),
    GLYPH(60, 5), GLYPH(61, 3), GLYPH(62, 5),  GLYPH(63, 5),  GLYPH(64, 2), GLYPH(65, 4),
    GLYPH(66, 4), GLYPH(67, 4), GLYPH(68, 4),  GLYPH(69, 4),  GLYPH(70, 3), LOW(71, 4, 2),
    GLYPH(72, 4), GLYPH(73, 1), LOW(74, 3, 1), GLYPH(75, 4),  GLYPH(76, 2), GLYPH(77, 5),
    GLYPH(78, 4), GLYPH(79, 4), LOW(80, 4, 2), LOW(81, 4, 2), GLYPH(82, 3), GLYPH(83, 4),
    GLYPH(84, 3), GLYPH(85, 4), GLYPH(86, 5),  GLYPH(87, 5),  GLYPH(88, 4), LOW(89, 4, 2),
    GLYPH(90, 4), GLYPH(91, 3), GLYPH(92, 1),  GLYPH(93, 3),  GLYPH(94, 5)};

FXL_STATIC_ASSERT(sizeof rows / sizeof rows[0] == sizeof glyphs / sizeof glyphs[0], "95 each");

/* overlay 4.4 */
const fxl_font fxl_font_5x7 = {.bits = rows[0],
                               .glyphs = glyphs,
                               .count = sizeof glyphs / sizeof glyphs[0],
                               .first = ' ',
                               .unknown = '?',
                               .line_height = 9};
