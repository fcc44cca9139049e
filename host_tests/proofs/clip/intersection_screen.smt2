; SPDX-License-Identifier: MIT
; fxl_intersection_screen of lib/clip/intersection.h on integers: e is the extent, i the inside distance, w the whole one.
(declare-const e Int) (declare-const i Int) (declare-const w Int) (declare-const p Int)
(assert (<= (- 536739840) e 536739840)) (assert (<= 0 i)) (assert (< i w)) (assert (< w 536870912))
(echo "possible")
(push) (assert (= e 536739840)) (assert (= i 1)) (assert (= w 2)) (check-sat) (pop)
; The product is at most |e| w: a quotient of at most |e|, below 2^31, which is what the division requires.
(echo "proved")
(push) (assert (> (* e i) (* 536739840 w))) (check-sat) (pop)
(echo "proved")
(push) (assert (< (* e i) (- (* 536739840 w)))) (check-sat) (pop)
; Rounded half up, a quotient of p by w with |p| <= 536739840 w is at most 2^29.
(echo "proved")
(push) (assert (<= (- (* 536739840 w)) p (* 536739840 w)))
(assert (not (<= (- 536870912) (div (+ (* 2 p) w) (* 2 w)) 536870912))) (check-sat) (pop)
