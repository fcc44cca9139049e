/* SPDX-License-Identifier: MIT */
/* The cases of the faults program. */
#ifndef FAULTS_CASES_H
#define FAULTS_CASES_H

typedef struct {
    const char *name;
    void (*run)(void);
} fault_case;

/* Each list ends with an entry whose name is null. */
extern const fault_case core_cases[], misaligned_cases[], ending_cases[], clock_cases[];

/* Ends the program, and says why this board cannot show the case. */
void cannot_show(const char *why);

#endif
