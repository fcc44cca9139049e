; SPDX-License-Identifier: MIT
; fxl_half_space_distance of lib/clip/volume.c on integers. Each coordinate is 2^32 h + l; (a, b, c) is the normal.
(declare-const a Int) (declare-const b Int) (declare-const c Int)
(declare-const hx Int) (declare-const lx Int) (declare-const hy Int) (declare-const ly Int) (declare-const hz Int) (declare-const lz Int)
(define-fun W () Int 4294967296)
(define-fun R () Int 1073741824)
(define-fun M () Int 2305843009213693951)
(define-fun high () Int (+ (* a hx) (* b hy) (* c hz)))
(define-fun low () Int (+ (* a lx) (* b ly) (* c lz)))

(echo "possible")
(push) (assert (= a 1000000000)) (assert (= b -1000000000)) (assert (= c 5)) (assert (= hx 500000000)) (assert (= hy 7)) (assert (= hz 1))
(assert (= lx 3)) (assert (= ly 0)) (assert (= lz 4294967295)) (assert (< 0 (+ (* 4 high) (div low R)))) (check-sat) (pop)
; What is returned is the floor of the whole sum, because 2^32 is a multiple of 2^30.
(echo "proved")
(push) (declare-const S Int) (declare-const D Int)
(assert (not (= (+ (* 4 S) (div D R)) (div (+ (* W S) D) R)))) (check-sat) (pop)
(echo "proved")
(push) (assert (not (= (+ (* W high) low) (+ (* a (+ (* W hx) lx)) (* b (+ (* W hy) ly)) (* c (+ (* W hz) lz)))))) (check-sat) (pop)
; A product is at most |n| M for a coordinate of at most M, and at most |n| 2^32 for a lower word.
(declare-const n Int) (declare-const v Int) (declare-const m Int)
(define-fun size () Int (ite (< n 0) (- n) n))
(assert (< size W)) (assert (or (= m M) (= m W)))
(echo "proved")
(push) (assert (<= (- m) v m)) (assert (>= n 0)) (assert (> (* n v) (* n m))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- m) v m)) (assert (>= n 0)) (assert (< (* n v) (- (* n m)))) (check-sat) (pop)
; The three magnitudes A, B, C add up to less than 2^31, so the sum of three such products has a floor below 2^62.
(declare-const A Int) (declare-const B Int) (declare-const C Int) (declare-const P Int) (declare-const Q Int)
(assert (<= 0 A)) (assert (<= 0 B)) (assert (<= 0 C)) (assert (< (+ A B C) 2147483648))
(echo "proved")
(push) (assert (<= (- (* M (+ A B C))) P (* M (+ A B C))))
(assert (not (< (- 4611686018427387904) (div P R) 4611686018427387904))) (check-sat) (pop)
; The distances of two points from one plane differ by less than 2^63 - 2^31.
(echo "proved")
(push) (assert (<= (- (* M (+ A B C))) P (* M (+ A B C)))) (assert (<= (- (* M (+ A B C))) Q (* M (+ A B C))))
(assert (not (< (- 2147483648 9223372036854775808) (- (div P R) (div Q R)) (- 9223372036854775808 2147483648)))) (check-sat) (pop)
