; SPDX-License-Identifier: MIT

; [[row]]
; id = "fxl_edge_dividend bound"
; function = "lib/raster/edge_divide.h:fxl_edge_dividend"
; property = "at most 2^14 heights"
; checks = 7
; of = { "lib/raster/edge_divide.h:fxl_edge_dividend" = "66da13609cf9e528" }

; [[row]]
; id = "fxl_edge_first_pixel remainder"
; function = "lib/raster/edge.h:fxl_edge_first_pixel"
; property = "the remainder is below the height"
; checks = 7
; of = { "lib/raster/edge.h:fxl_edge_first_pixel" = "c2722a4b12dbde50" }

; [[row]]
; id = "fxl_edge_divide bound"
; function = "lib/raster/edge_divide.h:fxl_edge_divide"
; property = "a quotient is not larger than its dividend"
; checks = 7
; of = { "lib/raster/edge_divide.h:fxl_edge_divide" = "c1dc843333b056fa" }

; Edges of lib/raster/edge.h and lib/raster/edge_divide.h on integers: h is the height, t the centre below the top.
(declare-const part Int) (declare-const h Int) (declare-const dx Int) (declare-const t Int)
(declare-const q Int) (declare-const r Int) (declare-const n Int)
(assert (<= 0 part 65535)) (assert (< 0 h 536870913)) (assert (<= (- 536870912) dx 536870912))
(define-fun sum () Int (+ (* part h) (* dx t)))
(define-fun dividend () Int (div (- sum 1) 65536))
(define-fun floor () Int (div n h))
(define-fun remainder () Int (- n (* floor h)))
(define-fun quotient () Int (ite (>= n 0) (div n h) (- (div (- n) h)))) ; C's, rounded towards 0
(define-fun above () Int (ite (>= n (* quotient h)) (+ quotient 1) quotient))

(echo "possible")
(push) (assert (<= 0 t)) (assert (< t h)) (check-sat) (pop)
; |dx t| is at most 2^29 h, so |sum - 1| is at most (2^29 + 2^16) h, and its 2^16th part at most 2^14 h.
(declare-const P Int)
(echo "proved")
(push) (assert (<= 0 t)) (assert (< t h)) (assert (> (* dx t) (* 536870912 h))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= 0 t)) (assert (< t h)) (assert (< (* dx t) (- (* 536870912 h)))) (check-sat) (pop)
(echo "proved")
(push) (assert (<= (- (* 536870912 h)) P (* 536870912 h))) (assert (<= 0 r (* 65535 h)))
(assert (not (<= (- (* 16384 h)) (div (- (+ r P) 1) 65536) (* 16384 h)))) (check-sat) (pop)
; A quotient that is the floor leaves 0 <= n - q h < h, and that is what is left modulo 2^32.
(echo "proved")
(push) (assert (not (and (<= 0 remainder) (< remainder h)))) (check-sat) (pop)
; C's quotient, rounded towards 0, of a dividend below 2^60 is below 2^60.
(echo "proved")
(push) (assert (<= (- 1152921504606846976) n 1152921504606846976)) (assert (= q quotient))
(assert (not (<= (- 1152921504606846976) q 1152921504606846976))) (check-sat) (pop)
; Of a height of a pixel or more it is at most the 2^16th part of the dividend.
(echo "proved")
(push) (assert (<= 65536 h)) (assert (= q quotient))
(assert (not (<= (- (div (ite (< n 0) (- n) n) 65536)) q (div (ite (< n 0) (- n) n) 65536)))) (check-sat) (pop)

; [[row]]
; id = "first pixel, by formula"
; function = "lib/raster/edge.h:fxl_edge_first_pixel"
; property = "what its rows of CBMC say that it is, with a dividend and a quotient rounded down, is the first pixel whose centre is not left of the edge, for every edge"
; checks = 3
; of = { "lib/raster/edge.h:fxl_edge_first_pixel" = "c2722a4b12dbde50", "lib/raster/edge_divide.h:fxl_edge_dividend" = "66da13609cf9e528" }

; The pixel of fxl_edge_first_pixel, as the rows of CBMC state it. X is the top's x, h the height, dx t the way of the edge to the centre.
(declare-const X Int) (declare-const h Int) (declare-const P Int)
(assert (< 0 h))
(define-fun start () Int (- X 32768))
(define-fun whole () Int (div start 65536))
(define-fun part () Int (mod start 65536))
(declare-const partH Int)
(define-fun dividend () Int (div (- (+ partH P) 1) 65536))
(declare-const q Int) (declare-const qH Int) (declare-const wholeH Int)
; How far the centre of pixel whole + q + 1 is to the right of the edge, times the height, and that of the pixel before it.
(define-fun right () Int (- (+ (* 65536 (+ wholeH qH h)) (* 32768 h)) (+ (* 65536 wholeH) partH (* 32768 h) P)))
(define-fun before () Int (- right (* 65536 h)))
(define-fun pixel () Int (+ whole q 1))

(echo "possible")
(push) (assert (= h 70000)) (assert (= P 3)) (assert (= X 40000)) (assert (= partH (* part h))) (assert (= q (div dividend h))) (check-sat) (pop)
; q is the floor: q h <= dividend < q h + h. The first centre is not left of the edge, and the one before it is.
(echo "proved")
(push) (assert (<= qH dividend)) (assert (< dividend (+ qH h))) (assert (not (and (>= right 0) (< before 0)))) (check-sat) (pop)
; right is (65536 x + 32768 - X) h - P with x = whole + q + 1, where X = 65536 whole + part + 32768.
(echo "proved")
(push) (declare-const w Int) (declare-const f Int)
(assert (not (= (- (* (- (+ (* 65536 (+ w q 1)) 32768) (+ (* 65536 w) f 32768)) h) P)
  (- (+ (* 65536 (+ (* w h) (* q h) h)) (* 32768 h)) (+ (* 65536 (* w h)) (* f h) (* 32768 h) P))))) (check-sat) (pop)
