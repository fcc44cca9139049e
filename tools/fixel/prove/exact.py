# SPDX-License-Identifier: MIT
"""Exact numbers for the formulas of constants (host_tests/proofs/ROOM/constants.py): no float is used.

A real number is a fraction that is off by less than 2^-190 of itself, far less than what decides how a constant is rounded.
"""

import fractions
import functools
import math

BITS = 200      # after the binary point
ONE = 1 << BITS
Real = fractions.Fraction


def _arctangent(number):
    """Of a fraction of at most 1/2, by its series, in units of 2^-BITS."""
    power = total = round(number * ONE)
    square, k = number * number, 1
    while power:
        power = round(-power * square)
        k += 2
        total += power // k
    return total


@functools.cache
def pi():
    """By Machin's formula."""
    return Real(16 * _arctangent(Real(1, 5)) - 4 * _arctangent(Real(1, 239)), ONE)


def arctangent(number):
    """Of 0 to 1."""
    if number > Real(1, 2):     # to pi/4 is the rest
        return pi() / 4 - Real(_arctangent((1 - number) / (1 + number)), ONE)
    return Real(_arctangent(Real(number)), ONE)


def tangent(angle):
    """Of an angle below a quarter turn, in radians."""
    sine = cosine = Real(0)
    term, k = Real(1), 0
    while abs(term) > Real(1, ONE):
        sine, cosine = (sine + term * (-1) ** (k // 2), cosine) if k % 2 else (sine, cosine + term * (-1) ** (k // 2))
        k += 1
        term = Real(round(term * angle / k * ONE * ONE), ONE * ONE)
    return sine / cosine


def root(number, degree=2):
    """The root of a number above 0, downward by less than 2^-BITS."""
    scaled = math.floor(number * ONE ** degree)
    if degree == 2:
        return Real(math.isqrt(scaled), ONE)
    low, high = 0, 1 << (scaled.bit_length() // degree + 1)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle ** degree <= scaled else (low, middle)
    return Real(low, ONE)


def nearest(number):
    """The nearest integer, halves upward."""
    return math.floor(number + Real(1, 2))


floor, ceil = math.floor, math.ceil


def power_below(number):
    """The largest k with number < 2^-k."""
    k = 0
    while number < Real(1, 2 << k):
        k += 1
    return k
