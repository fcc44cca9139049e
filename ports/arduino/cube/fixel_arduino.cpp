/* SPDX-License-Identifier: MIT */
#include "fixel_arduino.h"

#include <Arduino.h>
#include <SPI.h>
#include <string.h>

/* SPI.transfer puts what came back in the place of what it sent, so it gets copies. */
static const size_t PIECE = 64;

static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    uint8_t piece[PIECE];

    (void)user;
    SPI.beginTransaction(SPISettings(FIXEL_ARDUINO_HZ, MSBFIRST, SPI_MODE0));
    digitalWrite(FIXEL_ARDUINO_DC, is_data ? HIGH : LOW);
    digitalWrite(FIXEL_ARDUINO_SELECT, LOW);
    while (size > 0) {
        const size_t count = size < PIECE ? size : PIECE;

        memcpy(piece, bytes, count);
        SPI.transfer(piece, count);
        bytes += count;
        size -= count;
    }
    digitalWrite(FIXEL_ARDUINO_SELECT, HIGH);
    SPI.endTransaction();
    return true;
}

static void pause_for(void *user, uint32_t milliseconds)
{
    (void)user;
    delay(milliseconds);
}

extern const fxl_display_port fixel_arduino_port = {NULL, send, NULL, NULL, pause_for};

void fixel_arduino_open(void)
{
    const uint8_t pins[] = {FIXEL_ARDUINO_SELECT, FIXEL_ARDUINO_DC, FIXEL_ARDUINO_RESET};

    for (uint8_t pin : pins) {
        digitalWrite(pin, HIGH);
        pinMode(pin, OUTPUT);
    }
    SPI.begin();
    digitalWrite(FIXEL_ARDUINO_RESET, LOW);
    delay(1);
    digitalWrite(FIXEL_ARDUINO_RESET, HIGH);
    delay(120);
}
