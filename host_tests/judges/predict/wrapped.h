/* SPDX-License-Identifier: MIT */
/* Functions that count calls of the library's functions. The linker's --wrap puts them in their
 * place for callers in other files, so nothing in the library knows of it. */
#ifndef PREDICT_WRAPPED_H
#define PREDICT_WRAPPED_H

#include "predict/counts.h"

/* The declarations of a function that is wrapped, under both names. */
#define WRAPPED(result, name, parameters) \
    result __real_##name parameters; \
    result __wrap_##name parameters; \
    _Static_assert(__builtin_types_compatible_p(__typeof__(name), __typeof__(__real_##name)), \
                   #name " is declared otherwise"); \
    result __wrap_##name parameters

/* A record of the library in whose place another is, for callers of a function in its own file. */
#define WRAPPED_RECORD(type, name) \
    extern const type __wrap_##name; \
    const type __wrap_##name

#endif
