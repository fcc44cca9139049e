; SPDX-License-Identifier: MIT
; fxl_square_root of lib/math/plane.h, and what normalise of lib/math/plane.c takes from it. N is the value at first. Before a
; round bit is B B; r is the root's part that is found, a multiple of 2 B, and the text's root is 2 r B.
(declare-const N Int) (declare-const r Int) (declare-const B Int) (declare-const value Int) (declare-const root Int)
(define-fun invariant () Bool (and (<= 0 r) (= value (- N (* r r))) (<= 0 value) (= root (* 2 r B)) (< N (* (+ r (* 2 B)) (+ r (* 2 B))))))

(echo "possible")
(push) (assert invariant) (assert (= B 4)) (assert (= r 8)) (assert (= N 170)) (check-sat) (pop)
; At first r is 0 and B is 2^31.
(echo "proved")
(push) (assert (<= 0 N)) (assert (< N 18446744073709551616)) (assert (= r 0)) (assert (= B 2147483648)) (assert (= value N))
(assert (= root 0)) (assert (not invariant)) (check-sat) (pop)
; A round in which value >= root + bit: r becomes r + B, and 2 (r + B) B / 2 is root / 2 + bit.
(echo "proved")
(push) (assert invariant) (assert (<= 1 B)) (assert (>= value (+ root (* B B))))
(assert (not (and (= (- value (+ root (* B B))) (- N (* (+ r B) (+ r B)))) (= (* (+ r B) B) (+ (* r B) (* B B)))
  (< N (* (+ (+ r B) B) (+ (+ r B) B)))))) (check-sat) (pop)
; The other round: r stays.
(echo "proved")
(push) (assert invariant) (assert (<= 1 B)) (assert (< value (+ root (* B B))))
(assert (not (< N (* (+ r B) (+ r B))))) (check-sat) (pop)
; At the end 2 B is 1, so N < (r + 1)^2, and the result is r or r + 1. N is 4 times a sum of squares, q, of which x^2 is one.
(declare-const q Int) (declare-const x Int) (declare-const twice Int)
(echo "proved")
(push) (assert (= N (* 4 q))) (assert (>= q (* x x))) (assert (<= 0 x)) (assert (<= 0 r)) (assert (< N (* (+ r 1) (+ r 1))))
(assert (>= twice r)) (assert (<= (+ r 1) (* 2 x))) (check-sat) (pop)
; A component of the result is floor(2^31 x / twice + 1/2) with 2 |x| <= twice: at most 2^30, because 2^30 is an integer.
(declare-const unit Int) (declare-const s Int)
(echo "proved")
(push) (assert (<= 1 twice)) (assert (<= (* 2 s) twice)) (assert (<= (- twice) (* 2 s)))
(assert (<= (* 2 unit twice) (+ (* 4294967296 s) twice))) (assert (< (+ (* 4294967296 s) twice) (* 2 (+ unit 1) twice)))
(assert (not (and (<= (- 1073741824) unit) (<= unit 1073741824)))) (check-sat) (pop)
