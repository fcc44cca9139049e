/* SPDX-License-Identifier: MIT */
/* After the Armv7-M Architecture Reference Manual, A5.2 (16 bits) and A5.3 (32). */
#include "parts/thumb.h"

/* Bits high to low of a half-word. */
static uint32_t bits(uint32_t half, uint32_t high, uint32_t low)
{
    return (half >> low) & ((2u << (high - low)) - 1u);
}

static bool answer(thumb_access *access, uint32_t address, uint32_t alignment, bool is_write)
{
    access->address = address;
    access->alignment = alignment;
    access->is_write = is_write;
    return true;
}

static uint32_t count_bits(uint32_t list)
{
    uint32_t count = 0;

    for (; list != 0; list &= list - 1u) {
        count++;
    }
    return count;
}

/* The program counter as an operand: four bytes on, of a whole word. */
static uint32_t literal_base(const uint32_t registers[16])
{
    return (registers[THUMB_PC] + 4u) & ~3u;
}

/* 0101 ooom mmnn nttt: register offset. */
static bool decode_register(uint32_t half, const uint32_t registers[16], thumb_access *access)
{
    /* STR STRH STRB LDRSB LDR LDRH LDRB LDRSH */
    static const uint8_t alignments[8] = {4, 2, 1, 1, 4, 2, 1, 2};
    const uint32_t operation = bits(half, 11, 9);
    const uint32_t address = registers[bits(half, 5, 3)] + registers[bits(half, 8, 6)];

    return answer(access, address, alignments[operation], operation < 3);
}

/* 011B Liii iinn nttt words and bytes, 1000 L... half-words: five-bit offset. */
static bool decode_offset(uint32_t half, const uint32_t registers[16], thumb_access *access)
{
    const uint32_t kind = bits(half, 15, 12); /* 6: words, 7: bytes, 8: half-words */
    const uint32_t alignment = kind == 6 ? 4u : kind == 7 ? 1u : 2u;
    const uint32_t address = registers[bits(half, 5, 3)] + bits(half, 10, 6) * alignment;

    return answer(access, address, alignment, bits(half, 11, 11) == 0);
}

static bool decode_short(uint32_t half, const uint32_t registers[16], thumb_access *access)
{
    const bool is_write = bits(half, 11, 11) == 0;
    const uint32_t low = bits(half, 7, 0);
    const uint32_t sp = registers[THUMB_SP];

    switch (bits(half, 15, 12)) {
    case 4: /* 01001: LDR, literal */
        return !is_write && answer(access, literal_base(registers) + low * 4u, 4, false);
    case 5:
        return decode_register(half, registers, access);
    case 6:
    case 7:
    case 8:
        return decode_offset(half, registers, access);
    case 9: /* STR and LDR relative to sp */
        return answer(access, sp + low * 4u, 4, is_write);
    case 11: /* PUSH 1011 010, POP 1011 110 */
        if (bits(half, 10, 9) != 2) {
            return false;
        }
        return answer(access, is_write ? sp - 4u * count_bits(bits(half, 8, 0)) : sp, 4, is_write);
    case 12: /* STM, LDM: low registers, upwards */
        return answer(access, registers[bits(half, 10, 8)], 4, is_write);
    default:
        return false;
    }
}

/* 1111 100s uzzl nnnn: one register; u chooses twelve bits of offset. */
static bool decode_single(uint32_t first, uint32_t second, const uint32_t registers[16],
                          thumb_access *access)
{
    const uint32_t number = bits(first, 3, 0);
    const uint32_t size = bits(first, 6, 5);
    const bool is_write = bits(first, 4, 4) == 0;
    const uint32_t base = registers[number];

    if (size == 3 || (is_write && number == THUMB_PC)) {
        return false;
    }
    if (number == THUMB_PC) {
        const uint32_t offset = bits(second, 11, 0);
        const uint32_t from = literal_base(registers);

        return answer(access, bits(first, 7, 7) != 0 ? from + offset : from - offset, 1u << size,
                      false);
    }
    if (bits(first, 7, 7) != 0) {
        return answer(access, base + bits(second, 11, 0), 1u << size, is_write);
    }
    if (bits(second, 11, 11) != 0) { /* 1PUW: eight bits, before or after, up or down */
        const uint32_t offset = bits(second, 7, 0);
        const uint32_t moved = bits(second, 9, 9) != 0 ? base + offset : base - offset;

        return answer(access, bits(second, 10, 10) != 0 ? moved : base, 1u << size, is_write);
    }
    if (bits(second, 11, 6) != 0) {
        return false;
    }
    return answer(access, base + (registers[bits(second, 3, 0)] << bits(second, 5, 4)), 1u << size,
                  is_write);
}

/* 1110 100p u1wl nnnn: two registers; 1110 1000/1 d0wl nnnn: several. */
static bool decode_several(uint32_t first, uint32_t second, const uint32_t registers[16],
                           thumb_access *access)
{
    const uint32_t base = registers[bits(first, 3, 0)];
    const bool is_write = bits(first, 4, 4) == 0;
    const bool before = bits(first, 8, 8) != 0;

    if (bits(first, 6, 6) != 0) {
        const uint32_t offset = bits(second, 7, 0) * 4u;
        const uint32_t moved = bits(first, 7, 7) != 0 ? base + offset : base - offset;

        /* Neither before nor written back: exclusive accesses and tables. */
        return (before || bits(first, 5, 5) != 0) &&
               answer(access, before ? moved : base, 4, is_write);
    }
    if (before) { /* downwards */
        return answer(access, base - 4u * count_bits(second), 4, is_write);
    }
    return answer(access, base, 4, is_write);
}

bool thumb_decode(const uint16_t *code, const uint32_t registers[16], thumb_access *access)
{
    const uint32_t first = code[0];

    if (bits(first, 15, 11) < 0x1Du) { /* 11101 and above have a second half */
        return decode_short(first, registers, access);
    }
    if (bits(first, 15, 9) == 0x7Cu) {
        return decode_single(first, code[1], registers, access);
    }
    if (bits(first, 15, 9) == 0x74u) {
        return decode_several(first, code[1], registers, access);
    }
    return false;
}
