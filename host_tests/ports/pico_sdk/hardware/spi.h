/* SPDX-License-Identifier: MIT */
#ifndef PORTS_HARDWARE_SPI_H
#define PORTS_HARDWARE_SPI_H
#include "pico/stdlib.h"
typedef struct spi_inst spi_inst_t;
typedef struct {
    volatile uint32_t dr;
} spi_hw_t;
typedef enum {
    SPI_CPOL_0,
    SPI_CPOL_1
} spi_cpol_t;
typedef enum {
    SPI_CPHA_0,
    SPI_CPHA_1
} spi_cpha_t;
typedef enum {
    SPI_LSB_FIRST,
    SPI_MSB_FIRST
} spi_order_t;
extern spi_inst_t *const ports_spi0;
#define spi0 ports_spi0
uint spi_init(spi_inst_t *spi, uint baudrate);
void spi_set_format(spi_inst_t *spi, uint data_bits, spi_cpol_t cpol, spi_cpha_t cpha,
                    spi_order_t order);
int spi_write_blocking(spi_inst_t *spi, const uint8_t *bytes, size_t size);
uint spi_get_baudrate(const spi_inst_t *spi);
bool spi_is_busy(const spi_inst_t *spi);
uint spi_get_dreq(spi_inst_t *spi, bool is_tx);
spi_hw_t *spi_get_hw(spi_inst_t *spi);
#endif
