/* SPDX-License-Identifier: MIT */
#ifndef WIRES_MOCK_H
#define WIRES_MOCK_H

/* Ends the file, after the display was closed. */
void wires_mock_end(void);

#endif
