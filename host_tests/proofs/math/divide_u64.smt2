; SPDX-License-Identifier: MIT
; fxl_divide_u64 of lib/math/arith.c on integers, with digits as divide_digit.smt2 proves them. n and D are numerator and
; denominator; S is 2^shift; W is whole, and H, M and L are the parts of shifted: 2^32 H + 2^16 M + L.
(declare-const n Int) (declare-const D Int) (declare-const S Int) (declare-const W Int)
(declare-const H Int) (declare-const M Int) (declare-const L Int)
(declare-const q1 Int) (declare-const r1 Int) (declare-const q2 Int) (declare-const r2 Int)
(declare-const q Int) (declare-const r Int)
(assert (<= 0 n)) (assert (< 0 D 4294967296)) (assert (< n (* 4294967296 D)))
(assert (<= 0 M 65535)) (assert (<= 0 L 65535)) (assert (<= 0 H))
(assert (= q (+ (* 65536 q1) q2)))

(echo "possible")
(push) (assert (= n 18446744069414584319)) (assert (= D 4294967295)) (assert (= r (- n (* q D)))) (assert (<= 0 r)) (assert (< r D))
(check-sat) (pop)
; The upper word of shifted is below whole, as the first digit requires: nothing is shifted out.
(echo "proved")
(push) (assert (<= 1 S 2147483648)) (assert (= W (* S D))) (assert (= (* n S) (+ (* 4294967296 H) (* 65536 M) L)))
(assert (< (* n S) (* (* 4294967296 D) S)))
(assert (not (< H W))) (check-sat) (pop)
; The two digits and the last remainder are a division of shifted by whole.
(echo "proved")
(push) (assert (= r1 (- (+ (* 65536 H) M) (* q1 W)))) (assert (= r2 (- (+ (* 65536 r1) L) (* q2 W))))
(assert (not (= (+ (* 4294967296 H) (* 65536 M) L) (+ (* q W) r2)))) (check-sat) (pop)
; That remainder is 2^shift times n - q D, so r2 >> shift is n - q D, and it is below D.
(echo "proved")
(push) (assert (<= 1 S 2147483648)) (assert (= (* n S) (+ (* (* q D) S) r2))) (assert (<= 0 r2)) (assert (< r2 (* D S)))
(assert (= r (- n (* q D))))
(assert (not (and (= r2 (* r S)) (<= 0 r) (< r D)))) (check-sat) (pop)
; What callers take: a numerator below 2^31 D or 2^28 D has a quotient below 2^31 or 2^28. numerator >> 31 < denominator
; says that numerator < 2^31 denominator, because the latter is a multiple of 2^31.
(echo "proved")
(push) (assert (= r (- n (* q D)))) (assert (<= 0 r)) (assert (< r D)) (assert (< n (* 2147483648 D)))
(assert (>= q 2147483648)) (check-sat) (pop)
(echo "proved")
(push) (assert (= r (- n (* q D)))) (assert (<= 0 r)) (assert (< r D)) (assert (< n (* 268435456 D)))
(assert (>= q 268435456)) (check-sat) (pop)
; A remainder in its range makes the quotient the floor, and the only one.
(echo "proved")
(push) (assert (= n (+ (* q D) r))) (assert (<= 0 r)) (assert (< r D)) (assert (= n (+ (* q1 D) r1))) (assert (<= 0 r1))
(assert (< r1 D)) (assert (not (= q1 q))) (check-sat) (pop)
