/* SPDX-License-Identifier: MIT */
/* Declarations of what ports/arduino calls, after Arduino's language reference. */
#ifndef PORTS_ARDUINO_H
#define PORTS_ARDUINO_H
#include <stddef.h>
#include <stdint.h>
#define LOW    0x0
#define HIGH   0x1
#define OUTPUT 0x1
#define INPUT_PULLUP 0x2
void pinMode(uint8_t pin, uint8_t mode);
void digitalWrite(uint8_t pin, uint8_t level);
int digitalRead(uint8_t pin);
void delay(unsigned long milliseconds);
void setup();
void loop();
#endif
