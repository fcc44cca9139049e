/* SPDX-License-Identifier: MIT */
#ifndef PORTS_SPI_H
#define PORTS_SPI_H
#include <stddef.h>
#include <stdint.h>
#define MSBFIRST  1
#define SPI_MODE0 0x00
class SPISettings
{
  public:
    SPISettings(uint32_t clock, uint8_t bit_order, uint8_t mode)
        : clock(clock), bit_order(bit_order), mode(mode)
    {
    }
    uint32_t clock;
    uint8_t bit_order, mode;
};
class SPIClass
{
  public:
    void begin();
    void beginTransaction(SPISettings settings);
    void transfer(void *bytes, size_t size);
    void endTransaction();
};
extern SPIClass SPI;
#endif
