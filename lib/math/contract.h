/* SPDX-License-Identifier: MIT */
/* Contracts of functions, for `make prove`. They stand after a declaration, before its semicolon or its body, and are
 * nothing without FXL_PROVE. host_tests/proofs/README.md says how they are proved. Internal. */
#ifndef FXL_CONTRACT_H
#define FXL_CONTRACT_H

#ifdef FXL_PROVE
/* What the caller must see to. */
#define FXL_REQUIRES(...) __CPROVER_requires(__VA_ARGS__)
/* What holds afterwards: FXL_RESULT is what the function returns. */
#define FXL_ENSURES(...) __CPROVER_ensures(__VA_ARGS__)
#define FXL_RESULT       __CPROVER_return_value
/* The same, by equations of products: a row of Z3 proves it, and CBMC takes it from there. */
#ifdef FXL_WITHOUT_EQUATIONS
#define FXL_EQUATES(...)
#else
#define FXL_EQUATES(...) __CPROVER_ensures(__VA_ARGS__)
#endif
/* An equation in the midst of a function: a row of Z3 that was written from it proves it, and CBMC goes on with it. */
#define FXL_LEMMA(...) __CPROVER_assume(__VA_ARGS__)
/* All that the function writes; nothing by FXL_ASSIGNS(). */
#define FXL_ASSIGNS(...) __CPROVER_assigns(__VA_ARGS__)
/* In FXL_REQUIRES: a pointer to an object of its own. */
#define FXL_OBJECT(pointer) __CPROVER_is_fresh(pointer, sizeof *(pointer))
/* In FXL_REQUIRES: a pointer to an object that may be part of another. */
#define FXL_READABLE(pointer) __CPROVER_r_ok(pointer, sizeof *(pointer))
/* A pointer to components of at most 1 and 4 units of 2^-30. */
#define FXL_DIRECTION(d) \
    (FXL_BELOW((d)->x, FXL_Q2_30_ONE + 4) && FXL_BELOW((d)->y, FXL_Q2_30_ONE + 4) && \
     FXL_BELOW((d)->z, FXL_Q2_30_ONE + 4))
/* A pointer to coordinates of at most limit. */
#define FXL_POINT_BELOW(p, limit) \
    (FXL_BELOW((p)->x, limit) && FXL_BELOW((p)->y, limit) && FXL_BELOW((p)->z, limit))
/* -limit <= value <= limit. */
#define FXL_BELOW(value, limit) ((value) >= -(limit) && (value) <= (limit))
#else
#define FXL_REQUIRES(...)
#define FXL_ENSURES(...)
#define FXL_EQUATES(...)
#define FXL_LEMMA(...) ((void)0)
#define FXL_ASSIGNS(...)
#endif

#endif
