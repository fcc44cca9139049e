/* SPDX-License-Identifier: MIT */
/* Lists of sentences for fxl_explain: the files reasons*.c have one for each public header. In a list
 * each sentence stands after the number of its status and before a 0. A list is one array of
 * characters, so that a linker which drops sections keeps the lists that a program names and no
 * others. Internal. */
#ifndef FXL_REASONS_H
#define FXL_REASONS_H

/* The statuses as characters: test_public.py compares them with fixel/types.h. */
#define ON_ARGUMENT    "\001"
#define ON_RANGE       "\002"
#define ON_CAPACITY    "\003"
#define ON_DEGENERATE  "\004"
#define ON_ORDER       "\005"
#define ON_ALIGNMENT   "\006"
#define ON_SIZE        "\007"
#define ON_MAGIC       "\010"
#define ON_VERSION     "\011"
#define ON_CRC         "\012"
#define ON_OFFSET      "\013"
#define ON_COUNT       "\014"
#define ON_INDEX       "\015"
#define ON_NORMAL      "\016"
#define ON_PLANARITY   "\017"
#define ON_RESERVED    "\020"
#define ON_RADIUS      "\021"
#define ON_FACE_BOUNDS "\022"
#define ON_BSP         "\023"
#define ON_CLUSTER     "\024"
#define ON_PLACEMENT   "\025"
#define ON_DISPLAY     "\026"
#define ON_STALE       "\027"
#define ON_COMBINATION "\030"

#endif
