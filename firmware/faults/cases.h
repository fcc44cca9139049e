/* SPDX-License-Identifier: MIT */
/* What the faults program can do. */
#ifndef FAULTS_CASES_H
#define FAULTS_CASES_H

typedef struct {
    const char *name;
    void (*run)(void);
} fault_case;

/* Each ends with an entry whose name is null. */
extern const fault_case core_cases[], misaligned_cases[], ending_cases[], clock_cases[];

/* Ends the program: this board cannot show the case, and why. */
void cannot_show(const char *why);

#endif
