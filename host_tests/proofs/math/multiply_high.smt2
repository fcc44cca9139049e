; SPDX-License-Identifier: MIT
; fxl_multiply_high of lib/math/core.h on integers. a = 2^32 ah + al and b = 2^32 bh + bl; HH, HL, LH and LL are their products.
(declare-const ah Int) (declare-const al Int) (declare-const bh Int) (declare-const bl Int)
(declare-const HH Int) (declare-const HL Int) (declare-const LH Int) (declare-const LL Int)
(define-fun W () Int 4294967296)
(define-fun most () Int (* 4294967295 4294967295))
(define-fun middle () Int (+ HL (div LL W)))
(define-fun other () Int (+ LH (mod middle W)))
(define-fun result () Int (+ HH (div middle W) (div other W)))
; All that is needed of the products: their range, and that they make up the whole one.
(assert (<= 0 HH most)) (assert (<= 0 HL most)) (assert (<= 0 LH most)) (assert (<= 0 LL most))
(define-fun product () Int (+ (* W W HH) (* W (+ HL LH)) LL))

(echo "possible")
(check-sat)
(echo "proved")
(push) (assert (not (and (< middle (* W W)) (< other (* W W))))) (check-sat) (pop)
(echo "proved")
(push) (assert (not (= result (div product (* W W))))) (check-sat) (pop)
; A product of two numbers below 2^64 is below 2^64 times each of them, so its upper word is not above them.
(declare-const a Int) (declare-const b Int)
(echo "proved")
(push) (assert (<= 0 a)) (assert (< a (* W W))) (assert (<= 0 b)) (assert (< b (* W W)))
(assert (not (<= (* a b) (* a (* W W))))) (check-sat) (pop)
; The products make up the whole one.
(echo "proved")
(push) (assert (not (= (* (+ (* W ah) al) (+ (* W bh) bl)) (+ (* W W (* ah bh)) (* W (+ (* ah bl) (* al bh))) (* al bl)))))
(check-sat) (pop)
