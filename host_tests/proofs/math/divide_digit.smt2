; SPDX-License-Identifier: MIT
; divide_digit of lib/math/arith.c on integers. U and L are the halves of whole, R the remainder before, h the numerator's
; next 16 bits; d is the digit and left is R - d U, both before a round of the loop. P is d L.
(declare-const U Int) (declare-const L Int) (declare-const R Int) (declare-const h Int)
(declare-const d Int) (declare-const left Int) (declare-const P Int)
(define-fun whole () Int (+ (* 65536 U) L))
(define-fun contract () Bool (and (<= 32768 U 65535) (<= 0 L 65535) (<= 0 R) (< R whole) (<= 0 h 65535)))
(define-fun state () Bool (and (= left (- R (* d U))) (= P (* d L))))
; The remainder that the digit would leave.
(define-fun rest () Int (- (+ (* 65536 left) h) P))
; What holds whenever the loop's condition is asked: the digit is not too small, and the loop has not ended too early.
(define-fun invariant () Bool (and (<= 0 d 65537) (<= 0 left) (< rest whole) (=> (> left 65535) (<= d 65536))))
(define-fun goes-on () Bool (and (<= left 65535) (> P (+ (* 65536 left) h))))

(echo "possible")
(push) (assert contract) (assert state) (assert invariant) (assert goes-on)
(assert (= U 32768)) (assert (= L 65535)) (assert (= R 2147549182)) (assert (= h 0)) (assert (= d 65537))
(check-sat) (pop)
; It holds at first, where left is R mod U: d <= 65537, for R < 65536 U + L.
(echo "proved")
(push) (assert contract) (assert state) (assert (<= 0 left)) (assert (< left U)) (assert (<= 0 P)) (assert (<= 0 d))
(assert (not invariant)) (check-sat) (pop)
; A round keeps it: d becomes d - 1 and left becomes left + U, so P becomes P - L.
(echo "proved")
(push) (assert contract) (assert (= P (* d L))) (assert (<= 0 P)) (assert invariant) (assert goes-on)
(assert (or (< d 1) (not (< (- (+ (* 65536 (+ left U)) h) (- P L)) whole)) (> (- d 1) 65536)))
(check-sat) (pop)
; d L is below 2^32 whenever it is computed, so no bit of it is lost.
(echo "proved")
(push) (assert (<= 0 d 65537)) (assert (<= 0 L 65535)) (assert (not (< (* d L) 4294967296))) (check-sat) (pop)
; At the end 0 <= rest < whole and d < 65536 ...
(echo "proved")
(push) (assert contract) (assert (= P (* d L))) (assert (<= P (* 65535 d))) (assert invariant) (assert (not goes-on))
(assert (not (and (<= 0 rest) (< rest whole)))) (check-sat) (pop)
; ... and rest is what the text computes: 65536 R + h - d whole.
(echo "proved")
(push) (assert state) (assert (not (= rest (- (+ (* 65536 R) h) (* d whole))))) (check-sat) (pop)
; A digit of 65536 or more would leave less than nothing.
(echo "proved")
(push) (assert contract) (assert (>= d 65536)) (assert (not (< (- (+ (* 65536 R) h) (* d whole)) 0)))
(check-sat) (pop)
