/* SPDX-License-Identifier: MIT */
/* What ports/arduino calls, as a diary, and a core's main. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "Arduino.h"
#include "SPI.h"
#include "diary.h"

SPIClass SPI;
static bool is_begun, is_in_transaction, is_input[8];
static uint8_t message[2 * 320 * 240];
static size_t length;

static void require(bool holds, const char *sentence)
{
    if (!holds) {
        printf("fault %s\n", sentence);
    }
}

void pinMode(uint8_t pin, uint8_t mode)
{
    require(mode == OUTPUT || (mode == INPUT_PULLUP && pin < sizeof is_input), "a pin is neither an output nor a key");
    if (mode == INPUT_PULLUP && pin < sizeof is_input) {
        is_input[pin] = true;
    }
}

/* A test that holds a key has the number of its pin in HELD_PIN. */
int digitalRead(uint8_t pin)
{
    const char *held = getenv("HELD_PIN");

    require(pin < sizeof is_input && is_input[pin], "a pin is read that is no input");
    return held != NULL && atoi(held) == pin ? LOW : HIGH;
}

/* What was sent since the last change of a pin is a message. */
void digitalWrite(uint8_t pin, uint8_t level)
{
    if (length > 0) {
        diary_bytes(message, length);
        length = 0;
    }
    diary_pin(pin, level == HIGH);
}

void delay(unsigned long milliseconds)
{
    diary_sleep((unsigned)milliseconds);
}

void SPIClass::begin()
{
    is_begun = true;
    diary_setup("spi");
}

void SPIClass::beginTransaction(SPISettings settings)
{
    require(is_begun && !is_in_transaction, "a transaction in another one");
    require(settings.clock == 40000000 && settings.bit_order == MSBFIRST && settings.mode == SPI_MODE0, "the settings");
    is_in_transaction = true;
}

/* The library's own buffers must not be given: what came back stands in the place of what was sent. */
void SPIClass::transfer(void *bytes, size_t size)
{
    require(is_in_transaction, "bytes without a transaction");
    memcpy(message + length, bytes, size);
    length += size;
    memset(bytes, 0xEE, size);
}

void SPIClass::endTransaction()
{
    require(is_in_transaction, "no transaction");
    is_in_transaction = false;
}

int main()
{
    setup();
    for (;;) {
        loop();
    }
}
