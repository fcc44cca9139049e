/* SPDX-License-Identifier: MIT */
/* Where the cube's text goes: hosted.c, cortexm.c. */
#ifndef PUT_TEXT_H
#define PUT_TEXT_H

#ifdef __cplusplus
extern "C" {
#endif

void put_text(const char *text);

#ifdef __cplusplus
}
#endif

#endif
