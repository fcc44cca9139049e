; SPDX-License-Identifier: MIT
; fxl_divide_u32 of lib/math/core.h on integers: C's quotient is the floor.
(declare-const n Int) (declare-const d Int)
(assert (<= 0 n 4294967295)) (assert (< 0 d 4294967296))
(define-fun r () Int (- n (* (div n d) d)))
(echo "possible")
(check-sat)
(echo "proved")
(assert (not (and (<= 0 r) (< r d) (<= r n) (<= (div n d) n))))
(check-sat)
