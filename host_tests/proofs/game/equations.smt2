; SPDX-License-Identifier: MIT

; [[row]]
; id = "over_norm exact"
; function = "lib/game/quaternion.c:over_norm"
; property = "the quotient by the norm, to the nearest"
; checks = 5
; of = { "lib/game/quaternion.c:over_norm" = "c13863c571909092" }

; over_norm of lib/game/quaternion.c on integers, of a part that is not negative and at most the norm N. Before a round D is the part
; times 2 for each round before it, q the quotient so far and r what is left; P is q N.
(declare-const N Int) (declare-const D Int) (declare-const q Int) (declare-const r Int) (declare-const P Int)
(define-fun state () Bool (and (< 0 N) (= P (* q N)) (= D (+ P r)) (<= 0 r N)))
; A round, and the rounding after the last one.
(define-fun enough () Bool (>= (* 2 r) N))
(define-fun next_q () Int (+ (* 2 q) (ite enough 1 0)))
(define-fun next_r () Int (- (* 2 r) (ite enough N 0)))
(define-fun rounded () Int (+ q (ite enough 1 0)))

(echo "possible")
(push) (assert state) (assert (= N 5)) (assert (= D 5)) (assert (= q 0)) (assert enough) (check-sat) (pop)
; A round keeps it: the part's double has next_q, and next_r is left.
(echo "proved")
(push) (assert state)
(assert (not (and (= (* 2 D) (+ (* 2 P) (ite enough N 0) next_r)) (<= 0 next_r N)))) (check-sat) (pop)
(echo "proved")
(push) (assert (= P (* q N))) (assert (not (= (* next_q N) (+ (* 2 P) (ite enough N 0))))) (check-sat) (pop)
; At the end the product of the rounded quotient and the norm is off by half a norm at most.
(echo "proved")
(push) (assert state) (assert (not (<= (- N) (* 2 (- (+ P (ite enough N 0)) D)) N))) (check-sat) (pop)
(echo "proved")
(push) (assert (= P (* q N))) (assert (not (= (* rounded N) (+ P (ite enough N 0))))) (check-sat) (pop)

; [[row]]
; id = "fxl_orientation_from_quaternion parts"
; function = "lib/game/quaternion.c:fxl_orientation_from_quaternion"
; property = "each product is at most 2^60, squares are not below 0, and no part is above the norm"
; checks = 6
; of = { "lib/game/quaternion.c:fxl_orientation_from_quaternion" = "bbf74ed71333ca42" }

; The parts of fxl_orientation_from_quaternion of lib/game/quaternion.c. Those of the diagonal are the norm but for twice a sum of two
; squares; the others are as this one is, with other letters.
(declare-const w Int) (declare-const x Int) (declare-const y Int) (declare-const z Int)
(define-fun given () Bool (and (<= (- 1073741824) w 1073741824) (<= (- 1073741824) x 1073741824) (<= (- 1073741824) y 1073741824)
                               (<= (- 1073741824) z 1073741824)))
(define-fun product () Int (* x y))
(define-fun norm () Int (+ (* w w) (* x x) (* y y) (* z z)))
(define-fun diagonal () Int (- (+ (* w w) (* x x)) (* y y) (* z z)))
(define-fun less () Int (* 2 (- (* x y) (* w z))))
(define-fun more () Int (* 2 (+ (* x y) (* w z))))
(echo "possible")
(push) (assert given) (assert (= x 1073741824)) (assert (= y (- 1073741824))) (assert (= w 0)) (assert (= z 0)) (assert (= less (- norm))) (check-sat) (pop)
(echo "proved")
(push) (assert given) (assert (not (<= (- 1152921504606846976) product 1152921504606846976))) (check-sat) (pop)
(echo "proved")
(push) (assert (< (* x x) 0)) (check-sat) (pop)
(echo "proved")
(push) (assert (not (<= (- norm) diagonal norm))) (check-sat) (pop)
; norm - less is (x - y)^2 + (w + z)^2, norm + less (x + y)^2 + (w - z)^2; with -z for z it is of more.
(echo "proved")
(push) (assert (not (and (= (- norm less) (+ (* (- x y) (- x y)) (* (+ w z) (+ w z)))) (= (+ norm less) (+ (* (+ x y) (+ x y)) (* (- w z) (- w z)))))))
(check-sat) (pop)
(echo "proved")
(push) (assert (not (and (= (- norm more) (+ (* (- x y) (- x y)) (* (- w z) (- w z)))) (= (+ norm more) (+ (* (+ x y) (+ x y)) (* (+ w z) (+ w z)))))))
(check-sat) (pop)
