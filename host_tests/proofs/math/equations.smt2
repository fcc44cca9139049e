; SPDX-License-Identifier: MIT

; [[row]]
; id = "divide_digit exact"
; function = "lib/math/arith.c:divide_digit"
; property = "a digit of 16 bits is the floor, its remainder is below the divisor, and no product of it loses a bit"
; checks = 7
; of = { "lib/math/arith.c:divide_digit" = "6bfc915adafa58a4" }

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

; [[row]]
; id = "fxl_divide_u32 remainder"
; function = "lib/math/core.h:fxl_divide_u32"
; property = "the remainder is below the denominator, and neither it nor the quotient is above the numerator"
; checks = 2
; of = { "lib/math/core.h:fxl_divide_u32" = "a11b9f6bcb79d10c" }

; fxl_divide_u32 of lib/math/core.h on integers: C's quotient is the floor.
(declare-const n Int) (declare-const d Int)
(assert (<= 0 n 4294967295)) (assert (< 0 d 4294967296))
(define-fun quotient () Int (div n d))
(define-fun r () Int (- n (* quotient d)))
(define-fun claim () Bool (and (<= 0 r) (< r d) (<= r n) (<= quotient n)))
(echo "possible")
(check-sat)
(echo "proved")
(assert (not claim))
(check-sat)

; [[row]]
; id = "fxl_divide_u64 exact"
; function = "lib/math/arith.c:fxl_divide_u64"
; property = "the quotient is the floor, and the remainder is below the denominator"
; checks = 7
; of = { "lib/math/arith.c:fxl_divide_u64" = "574029e24d3463c0" }

; fxl_divide_u64 of lib/math/arith.c on integers, with digits as the section of divide_digit proves them. n and D are numerator and
; denominator; S is 2^shift; W is whole, and H, M and L are the parts of shifted: 2^32 H + 2^16 M + L.
(declare-const n Int) (declare-const D Int) (declare-const S Int) (declare-const W Int)
(declare-const H Int) (declare-const M Int) (declare-const L Int)
(declare-const q1 Int) (declare-const r1 Int) (declare-const q2 Int) (declare-const r2 Int)
(declare-const q Int) (declare-const r Int)
(define-fun contract () Bool (and (<= 0 n) (< 0 D 4294967296) (< n (* 4294967296 D)) (<= 0 M 65535) (<= 0 L 65535) (<= 0 H)))
(define-fun shifted () Int (+ (* 4294967296 H) (* 65536 M) L))
(define-fun quotient () Int (+ (* 65536 q1) q2))
(define-fun rest-of-upper () Int (- (+ (* 65536 H) M) (* q1 W)))
(define-fun rest-of-lower () Int (- (+ (* 65536 r1) L) (* q2 W)))
(assert contract) (assert (= q quotient))

(echo "possible")
(push) (assert (= n 18446744069414584319)) (assert (= D 4294967295)) (assert (= r (- n (* q D)))) (assert (<= 0 r)) (assert (< r D))
(check-sat) (pop)
; The upper word of shifted is below whole, as the first digit requires: nothing is shifted out.
(echo "proved")
(push) (assert (<= 1 S 2147483648)) (assert (= W (* S D))) (assert (= (* n S) shifted))
(assert (< (* n S) (* (* 4294967296 D) S)))
(assert (not (< H W))) (check-sat) (pop)
; The two digits and the last remainder are a division of shifted by whole.
(echo "proved")
(push) (assert (= r1 rest-of-upper)) (assert (= r2 rest-of-lower))
(assert (not (= shifted (+ (* q W) r2)))) (check-sat) (pop)
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

; [[row]]
; id = "fraction_digit exact"
; function = "lib/math/arith.c:fraction_digit"
; property = "a digit of a fraction is the floor, and its remainder is below the divisor, where the estimate is right or one too small"
; checks = 6
; of = { "lib/math/arith.c:fraction_digit" = "c4aa8df7fea9d1da" }

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

; [[row]]
; id = "fxl_multiply_su32 bound"
; function = "lib/math/core.h:fxl_multiply_su32"
; property = "at most 2^32 of the first factor"
; checks = 7
; of = { "lib/math/core.h:fxl_multiply_su32" = "8ef8df0b42206770" }

; [[row]]
; id = "fxl_multiply_s32 bound"
; function = "lib/math/core.h:fxl_multiply_s32"
; property = "at most as many times the first factor as the second is large: 2^29 and 2^31"
; checks = 7
; of = { "lib/math/core.h:fxl_multiply_s32" = "c1f2ac56909392c2" }

; [[row]]
; id = "fxl_multiply_s64 bound"
; function = "lib/math/core.h:fxl_multiply_s64"
; property = "factors from 0 to 2^24 and 2^31, or 2^25 and 2^32: at most 2^55 and 2^57; larger factors have no smaller product"
; checks = 7
; of = { "lib/math/core.h:fxl_multiply_s64" = "c604286cd1ca8661" }

; Products of lib/math/core.h on integers: how large they are beside their first factor.
(declare-const a Int) (declare-const b Int)
(define-fun W () Int 4294967296)
(define-fun size () Int (ite (< a 0) (- a) a))
(define-fun product () Int (* a b))
(define-fun within-word () Bool (<= (- (* size W)) product (* size W)))
(define-fun within-half () Bool (<= (- (* size 2147483648)) product (* size 2147483648)))
(define-fun within-2-29 () Bool (<= (- (* size 536870912)) product (* size 536870912)))
(assert (<= (- 2147483648) a 2147483647))
(echo "possible")
(push) (assert (= a -2147483648)) (assert (= b 4294967295)) (check-sat) (pop)
(echo "proved")
(push) (assert (<= 0 b)) (assert (< b W)) (assert (not within-word)) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- 2147483648) b 2147483647)) (assert (not within-half)) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- 536870912) b 536870912)) (assert (not within-2-29)) (check-sat) (pop)
; Two factors that are not below 0: a product below 2^63 is the whole one.
(declare-const c Int) (declare-const d Int) (assert (<= 0 c)) (assert (<= 0 d))
(define-fun positive-product () Int (* c d))
(echo "proved")
(push) (assert (<= c 16777216)) (assert (<= d 2147483648)) (assert (> positive-product 36028797018963968)) (check-sat) (pop)
(echo "proved")
(push) (assert (<= c 33554432)) (assert (<= d 4294967296)) (assert (> positive-product 144115188075855872)) (check-sat) (pop)
; It is not smaller where neither factor is.
(declare-const e Int) (declare-const f Int)
(echo "proved")
(push) (assert (<= c e)) (assert (<= d f)) (assert (> positive-product (* e f))) (check-sat) (pop)

; [[row]]
; id = "fxl_multiply_high exact"
; function = "lib/math/core.h:fxl_multiply_high"
; property = "the upper 64 bits of the product, exactly; no sum of it overflows"
; checks = 5
; of = { "lib/math/core.h:fxl_multiply_high" = "5548e9fb3fa0958a" }

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

; [[row]]
; id = "normalise bound"
; function = "lib/math/plane.c:normalise"
; property = "each component is at most 1, because the root is at least each component"
; checks = 6
; of = { "lib/math/plane.c:normalise" = "794d749202b4c0bb", "lib/math/plane.c:shifted" = "cb5cbb3a289fe939" }

; [[row]]
; id = "fxl_square_root bound"
; function = "lib/math/plane.h:fxl_square_root"
; property = "at least the floor of the root"
; checks = 6
; of = { "lib/math/plane.h:fxl_square_root" = "9640895145a69416" }

; fxl_square_root of lib/math/plane.h, and what normalise of lib/math/plane.c takes from it. N is the value at first. Before a
; round bit is B B; r is the root's part that is found, a multiple of 2 B, and the text's root is 2 r B.
(declare-const N Int) (declare-const r Int) (declare-const B Int) (declare-const value Int) (declare-const root Int)
(define-fun invariant () Bool (and (<= 0 r) (= value (- N (* r r))) (<= 0 value) (= root (* 2 r B)) (< N (* (+ r (* 2 B)) (+ r (* 2 B))))))
(define-fun goes-up () Bool (>= value (+ root (* B B))))
(define-fun found () Int (ite (> value root) (+ root 1) root))

(echo "possible")
(push) (assert invariant) (assert (= B 4)) (assert (= r 8)) (assert (= N 170)) (check-sat) (pop)
; At first r is 0 and B is 2^31.
(echo "proved")
(push) (assert (<= 0 N)) (assert (< N 18446744073709551616)) (assert (= r 0)) (assert (= B 2147483648)) (assert (= value N))
(assert (= root 0)) (assert (not invariant)) (check-sat) (pop)
; A round in which value >= root + bit: r becomes r + B, and 2 (r + B) B / 2 is root / 2 + bit.
(echo "proved")
(push) (assert invariant) (assert (<= 1 B)) (assert goes-up)
(assert (not (and (= (- value (+ root (* B B))) (- N (* (+ r B) (+ r B)))) (= (* (+ r B) B) (+ (* r B) (* B B)))
  (< N (* (+ (+ r B) B) (+ (+ r B) B)))))) (check-sat) (pop)
; The other round: r stays.
(echo "proved")
(push) (assert invariant) (assert (<= 1 B)) (assert (not goes-up))
(assert (not (< N (* (+ r B) (+ r B))))) (check-sat) (pop)
; At the end 2 B is 1, so N < (r + 1)^2, and the result is r or r + 1. N is 4 times a sum of squares, q, of which x^2 is one.
(declare-const q Int) (declare-const x Int) (declare-const twice Int)
(echo "proved")
(push) (assert (= N (* 4 q))) (assert (>= q (* x x))) (assert (<= 0 x)) (assert (<= 0 r)) (assert (< N (* (+ r 1) (+ r 1))))
(assert (>= twice r)) (assert (<= (+ r 1) (* 2 x))) (check-sat) (pop)
; A component of the result is floor(2^31 x / twice + 1/2) with 2 |x| <= twice: at most 2^30, because 2^30 is an integer.
(declare-const unit Int) (declare-const s Int)
(define-fun shorter () Bool (and (<= 1 twice) (<= (* 2 s) twice) (<= (- twice) (* 2 s))))
(define-fun component () Bool (and (<= (* 2 unit twice) (+ (* 4294967296 s) twice)) (< (+ (* 4294967296 s) twice) (* 2 (+ unit 1) twice))))
(echo "proved")
(push) (assert shorter) (assert component)
(assert (not (and (<= (- 1073741824) unit) (<= unit 1073741824)))) (check-sat) (pop)
