/* SPDX-License-Identifier: MIT */
#ifndef SPI_MOCK_H
#define SPI_MOCK_H

/* Ends the file, after the display was closed. */
void spi_mock_end(void);

#endif
