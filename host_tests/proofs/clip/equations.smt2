; SPDX-License-Identifier: MIT

; [[row]]
; id = "fxl_half_space_distance exact"
; function = "lib/clip/volume.c:fxl_half_space_distance"
; property = "the floor of the sum, below 2^62 without the offset; of two points the distances differ by less than 2^63"
; checks = 7
; of = { "lib/clip/volume.c:fxl_half_space_distance" = "cafac51dc1ce385a" }

; fxl_half_space_distance of lib/clip/volume.c on integers. Each coordinate is 2^32 h + l; (a, b, c) is the normal.
(declare-const a Int) (declare-const b Int) (declare-const c Int)
(declare-const hx Int) (declare-const lx Int) (declare-const hy Int) (declare-const ly Int) (declare-const hz Int) (declare-const lz Int)
(define-fun W () Int 4294967296)
(define-fun R () Int 1073741824)
(define-fun M () Int 2305843009213693951)
(define-fun high () Int (+ (* a hx) (* b hy) (* c hz)))
(define-fun low () Int (+ (* a lx) (* b ly) (* c lz)))
(define-fun result () Int (+ (* 4 high) (div low R)))
(define-fun sum () Int (+ (* a (+ (* W hx) lx)) (* b (+ (* W hy) ly)) (* c (+ (* W hz) lz))))

(echo "possible")
(push) (assert (= a 1000000000)) (assert (= b -1000000000)) (assert (= c 5)) (assert (= hx 500000000)) (assert (= hy 7)) (assert (= hz 1))
(assert (= lx 3)) (assert (= ly 0)) (assert (= lz 4294967295)) (assert (< 0 result)) (check-sat) (pop)
; What is returned is the floor of the whole sum, because 2^32 is a multiple of 2^30.
(echo "proved")
(push) (declare-const S Int) (declare-const D Int)
(assert (not (= (+ (* 4 S) (div D R)) (div (+ (* W S) D) R)))) (check-sat) (pop)
(echo "proved")
(push) (assert (not (= (+ (* W high) low) sum))) (check-sat) (pop)
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

; [[row]]
; id = "fxl_intersection_screen bound"
; function = "lib/clip/intersection.h:fxl_intersection_screen"
; property = "the quotient is at most the extent, so that the division takes it"
; checks = 4
; of = { "lib/clip/intersection.h:fxl_intersection_screen" = "9dd44e83a5eb09ca" }

; fxl_intersection_screen of lib/clip/intersection.h on integers: e is the extent, i the inside distance, w the whole one.
(declare-const e Int) (declare-const i Int) (declare-const w Int) (declare-const p Int)
(define-fun contract () Bool (and (<= (- 536739840) e 536739840) (<= 0 i) (< i w) (< w 536870912)))
(define-fun product () Int (* e i))
(define-fun quotient () Int (div (+ (* 2 p) w) (* 2 w)))
(assert contract)
(echo "possible")
(push) (assert (= e 536739840)) (assert (= i 1)) (assert (= w 2)) (check-sat) (pop)
; The product is at most |e| w: a quotient of at most |e|, below 2^31, which is what the division requires.
(echo "proved")
(push) (assert (> product (* 536739840 w))) (check-sat) (pop)
(echo "proved")
(push) (assert (< product (- (* 536739840 w)))) (check-sat) (pop)
; Rounded half up, a quotient of p by w with |p| <= 536739840 w is at most 2^29.
(echo "proved")
(push) (assert (<= (- (* 536739840 w)) p (* 536739840 w)))
(assert (not (<= (- 536870912) quotient 536870912))) (check-sat) (pop)

; [[row]]
; id = "project_onto exact"
; function = "lib/clip/clip_view.c:project_onto"
; property = "at most 3 2^60, and exactly the floor"
; checks = 5
; of = { "lib/clip/clip_view.c:project_onto" = "a8ab07e1646e6252" }

; project_onto of lib/clip/clip_view.c on integers. across = 2^32 ah + al and along = 2^32 bh + bl; s and d are side and depth.
(declare-const s Int) (declare-const d Int)
(declare-const ah Int) (declare-const al Int) (declare-const bh Int) (declare-const bl Int)
(define-fun W () Int 4294967296)
(define-fun across () Int (+ (* W ah) al))
(define-fun along () Int (+ (* W bh) bl))
(define-fun M () Int 2305843009213693951)
(define-fun high () Int (+ (* s ah) (* d bh)))
(define-fun low () Int (+ (* s al) (* d bl)))
(define-fun result () Int (+ (* 4 high) (div low 1073741824)))
(define-fun contract () Bool (and (<= 0 s 1073741824) (<= 0 d 1073741824) (<= (+ s d) 1610612736) (<= 0 al) (< al W) (<= 0 bl) (< bl W)))
(assert contract)

(echo "possible")
(push) (assert (= s 759250124)) (assert (= d 759250124)) (assert (= across M)) (assert (= along M)) (check-sat) (pop)
; The floor of the whole sum, because 2^32 is a multiple of 2^30.
(echo "proved")
(push) (declare-const S Int) (declare-const D Int) (declare-const E Int) (declare-const F Int)
(assert (not (= (+ (* 4 S) (div D 1073741824)) (div (+ (* W S) D) 1073741824)))) (check-sat) (pop)
; The sum is at most 3 2^60 2^30: s x + d y <= (s + d) M.
(declare-const x Int) (declare-const y Int)
(assert (<= (- M) x M)) (assert (<= (- M) y M))
(echo "proved")
(push) (assert (> (* s x) (* s M))) (check-sat) (pop)
(echo "proved")
(push) (assert (< (* s x) (- (* s M)))) (check-sat) (pop)
(echo "proved")
(push) (declare-const P Int) (declare-const Q Int) (assert (<= (- (* s M)) P (* s M))) (assert (<= (- (* d M)) Q (* d M)))
(assert (not (<= (- 3458764513820540928) (div (+ P Q) 1073741824) 3458764513820540928))) (check-sat) (pop)
