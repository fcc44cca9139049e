; SPDX-License-Identifier: MIT

; [[row]]
; id = "scale_of bound"
; function = "lib/view/project.c:scale_of"
; property = "within one unit of the quotient, and at most 2^30; the rest fits 32 bits"
; checks = 17
; of = { "lib/view/project.c:scale_of" = "0af2a4c1983ec2f1" }

; [[row]]
; id = "offset_of bound"
; function = "lib/view/project.c:offset_of"
; property = "the estimate is the quotient or one less: the remainder is below twice the depth"
; checks = 17
; of = { "lib/view/project.c:offset_of" = "d25f91ea43e28298" }

; scale_of and offset_of of lib/view/project.c on integers, with the letters of the comment above them.
(define-fun W () Int 4294967296)
(declare-const F Int) (declare-const d Int)
(assert (<= 4 F 268435452)) (assert (<= 1073741824 d 2147483648))

; --- scale_of: d = 2^15 D + f, 4 F = g D + r, |rest| = k D + t with rest = 2^15 r - g f; it returns 2^15 g +- k.
(declare-const D Int) (declare-const f Int) (declare-const g Int) (declare-const r Int)
(declare-const rest Int) (declare-const k Int) (declare-const t Int)
(define-fun of-parts () Bool (and (= d (+ (* 32768 D) f)) (<= 0 f 32767) (<= 32768 D 65536)))
(define-fun first () Bool (and (= (* 4 F) (+ (* g D) r)) (<= 0 r) (< r D)))
(define-fun rest-of-first () Int (- (* 32768 r) (* g f)))
(define-fun second () Bool (and (= (ite (< rest 0) (- rest) rest) (+ (* k D) t)) (<= 0 t) (< t D)))
(define-fun scale () Int (ite (< rest 0) (- (* 32768 g) k) (+ (* 32768 g) k)))
(echo "possible")
(push) (assert of-parts) (assert (= d 1500000000)) (assert (= F 40000000)) (assert (= g (div (* 4 F) D))) (assert (= r (mod (* 4 F) D))) (check-sat) (pop)
; g is at most 2^15, so g f is below 2^30, and rest fits 32 bits.
(echo "proved")
(push) (assert (<= 32768 D 65536)) (assert (= (* 4 F) (+ (* g D) r))) (assert (<= 0 r)) (assert (< r D)) (assert (>= g 0)) (assert (> g 32768)) (check-sat) (pop)
(declare-const G1 Int)
(echo "proved")
(push) (assert (<= 0 f 32767)) (assert (<= 0 g 32768)) (assert (> (* g f) 1073709056)) (check-sat) (pop)
(echo "proved")
(push) (assert of-parts) (assert (<= 0 r)) (assert (< r D)) (assert (<= 0 G1 1073709056)) (assert (= rest (- (* 32768 r) G1)))
(assert (not (and (< (- 1073741824) rest) (< rest 2147483648) (<= rest d)))) (check-sat) (pop)
; k is at most 2^15 + 1, so k f is at most d; 2^15 |rest| - k d = 2^15 t - k f is then within one unit of d.
(echo "proved")
(push) (assert of-parts) (assert (<= 0 (+ (* k D) t) d)) (assert (<= 0 t)) (assert (< t D)) (assert (> k 32769)) (check-sat) (pop)
(declare-const K Int)
(echo "proved")
(push) (assert (<= 0 f 32767)) (assert (<= 0 k 32768)) (assert (> (* k f) 1073709056)) (check-sat) (pop)
(echo "proved")
(push) (assert of-parts) (assert (<= 0 (+ (* k D) t) d)) (assert (<= 0 t)) (assert (< t D)) (assert (= k 32769)) (check-sat) (pop)
(echo "proved")
(push) (assert of-parts) (assert (<= 0 t)) (assert (< t D)) (assert (<= 0 K 1073709056)) (assert (not (<= (- d) (- (* 32768 t) K) d))) (check-sat) (pop)
(echo "proved")
(push) (assert (not (= (- (* 32768 (+ (* k D) t)) (* k (+ (* 32768 D) f))) (- (* 32768 t) (* k f))))) (check-sat) (pop)

; --- offset_of: |G d - 2^32 F| <= d; x is the upper word of X', l the lower; u = G d - 2^32 F.
(declare-const G Int) (declare-const x Int) (declare-const u Int) (declare-const q Int) (declare-const l Int)
(define-fun near () Bool (<= (- d) (- (* G d) (* W F)) d))
(define-fun product () Int (+ (* F x) (div (* F l) W)))
(define-fun estimate () Int (div (* x G) W))
(define-fun left () Int (- (+ product (div d 2)) (* q d)))
(define-fun offset () Int (ite (>= left d) (+ q 1) q))
(echo "proved")
(push) (assert near) (assert (not (<= 0 G 1073741824))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= 0 G 1073741824)) (assert (<= (- 1073741824) x 1073741824)) (assert (not (<= (- 1152921504606846976) (* x G) 1152921504606846976))) (check-sat) (pop)
(echo "proved")
(push) (declare-const xG Int) (assert (<= (- 1152921504606846976) xG 1152921504606846976)) (assert (not (<= (- 268435456) (div xG W) 268435456))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- 1073741824) x 1073741824)) (assert (<= (- d) u d)) (assert (> (* x u) (* 1073741824 d))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- 1073741824) x 1073741824)) (assert (<= (- d) u d)) (assert (< (* x u) (- (* 1073741824 d)))) (check-sat) (pop)
; 2^32 q d = (x G - s) d = 2^32 F x + x u - s d, where s is the remainder of x G.
(declare-const s Int)
(echo "proved")
(push) (assert (not (= (* (- (* x G) s) d) (+ (* W F x) (* x (- (* G d) (* W F))) (- (* s d)))))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= 0 s)) (assert (< s W)) (assert (>= (* s d) (* W d))) (check-sat) (pop)
; So P + h - q d = floor(F l / 2^32) + h + (s d - x u) / 2^32 lies in 0..2 d - 1.
(declare-const Fl Int) (declare-const xu Int) (declare-const sd Int) (declare-const Fx Int) (declare-const qd Int)
(echo "proved")
(push) (assert (<= 0 Fl)) (assert (< Fl (* W F))) (assert (<= (- (* 1073741824 d)) xu (* 1073741824 d))) (assert (<= 0 sd)) (assert (< sd (* W d)))
(assert (= (* W qd) (+ (* W Fx) xu (- sd))))
(assert (not (and (<= 0 (- (+ Fx (div Fl W) (div d 2)) qd)) (< (- (+ Fx (div Fl W) (div d 2)) qd) (* 2 d))))) (check-sat) (pop)
