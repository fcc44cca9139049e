; SPDX-License-Identifier: MIT
; fraction_digit of lib/math/arith.c on integers. W is whole, R the remainder before, d the digit's estimate; P is 2^bits R, and
; Q is d W. That the estimate is right or one too small is the argument above the function, which these queries assume.
(declare-const W Int) (declare-const R Int) (declare-const d Int) (declare-const P Int) (declare-const Q Int)
(define-fun contract () Bool (and (<= 4611686018427387904 W) (< W 9223372036854775808) (<= 0 R) (< R W)))
(define-fun left () Int (- P Q))
(define-fun estimate () Bool (and (<= 0 left) (< left (* 2 W))))
(define-fun corrected () Bool (>= left W))
(define-fun after () Int (ite corrected (- left W) left))
(define-fun digit () Int (ite corrected (+ d 1) d))

(echo "possible")
(push) (assert contract) (assert estimate) (assert (= P (* 4194304 R))) (assert (= Q (* d W)))
(assert (= W 4611686018427387904)) (assert (= R 4611686018427387903)) (assert (= d 4194302)) (assert corrected) (check-sat) (pop)
; The true remainder is below 2^64, so that computed modulo 2^64 is that one.
(echo "proved")
(push) (assert contract) (assert estimate) (assert (not (< left 18446744073709551616))) (check-sat) (pop)
; One correction leaves a remainder below whole: where left is whole itself, it is taken too.
(echo "proved")
(push) (assert contract) (assert estimate) (assert (not (and (<= 0 after) (< after W)))) (check-sat) (pop)
; It is the remainder of the corrected digit, so that digit is the floor of 2^bits R / W.
(echo "proved")
(push) (assert (= Q (* d W))) (assert (not (= after (- P (* digit W))))) (check-sat) (pop)
; The digit has 22 bits, or 21: a larger one would leave less than nothing.
(echo "proved")
(push) (assert contract) (assert (>= d 4194304)) (assert (not (< (- (* 4194304 R) (* d W)) 0))) (check-sat) (pop)
(echo "proved")
(push) (assert contract) (assert (>= d 2097152)) (assert (not (< (- (* 2097152 R) (* d W)) 0))) (check-sat) (pop)
