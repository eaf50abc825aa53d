#!/usr/bin/env python3
"""Re-proves certificates of how two convex bodies lie, with nothing but fractions.

    python3 verify_certificate.py FILE...      (or from standard input)

A file holds certificates as plumb::certificate_text writes them, one a line.  For each a line says what is proved, or
why nothing is; the status is 0 where all are.  What the numbers mean, and why they prove it: docs/convex.md.
"""

import json
import math
import re
import struct
import sys
from fractions import Fraction


class Refused(Exception):
    pass


def require(condition, flaw):
    if not condition:
        raise Refused(flaw)


# Numbers are texts: "-3/8", "5", or hexadecimal doubles, "0x1.8p-3".

def real(text):
    require(isinstance(text, str), "a number is no text")
    written = re.fullmatch(r"-?0x[0-9a-fA-F]+(\.[0-9a-fA-F]*)?(p[+-]?[0-9]+)?", text)
    require(written, f"{text!r} is no hexadecimal double")
    try:
        return Fraction(float.fromhex(text))
    except OverflowError:
        raise Refused(f"{text!r} is beyond all doubles") from None


def exact(text):
    require(isinstance(text, str), "a number is no text")
    if "x" in text:
        return real(text)
    require(re.fullmatch(r"-?[0-9]+(/[0-9]*[1-9][0-9]*)?", text), f"{text!r} is no fraction")
    return Fraction(text)


def items(values, count=None):
    require(isinstance(values, list), "a list is missing")
    require(count is None or len(values) == count, "a list is too long or too short")
    return values


def vector(values, number=real):
    return tuple(number(x) for x in items(values, 3))


def member(record, key):
    require(isinstance(record, dict) and key in record, f"{key} is missing")
    return record[key]


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def plus(u, v, times=1):
    return tuple(x + times * y for x, y in zip(u, v))


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


# A body is the hull of its corners, and all within its radius of that.

def corners_along(at, ways, both):
    """At or minus each way, plus the way where the bit of the corner's number is set."""
    corners = []
    for i in range(2 ** len(ways)):
        corner = at
        for k, way in enumerate(ways):
            corner = plus(corner, way, 1 if i >> k & 1 else -1 if both else 0)
        corners.append(corner)
    return corners


def standing(body):
    if "vertices" in body:
        corners = [vector(p) for p in items(body["vertices"])]
        require("radius" not in body or len(corners) in (1, 2), "a radius is of one vertex, or of two")
        return corners
    if "min" in body:
        least, most = vector(body["min"]), vector(member(body, "max"))
        require(all(low <= high for low, high in zip(least, most)), "the box is empty")
        return [tuple((most if i >> k & 1 else least)[k] for k in range(3)) for i in range(8)]
    if "corner" in body:
        member(body, "radius")
        return corners_along(vector(body["corner"]), [vector(e) for e in items(member(body, "edges"), 2)], False)
    axes = [vector(axis) for axis in items(member(body, "axes"))]
    require(len(axes) in (2, 3), "a box has two axes, or three")
    half = [abs(real(h)) for h in items(member(body, "half"), len(axes))]
    ways = [tuple(h * x for x in axis) for axis, h in zip(axes, half)]
    return corners_along(vector(member(body, "center")), ways, True)


def root(x):
    n, d = math.isqrt(x.numerator), math.isqrt(x.denominator)
    require(n * n == x.numerator and d * d == x.denominator, "the pose's scale is not rational")
    return Fraction(n, d)


def body_of(body):
    require(isinstance(body, dict), "a body is missing")
    corners = standing(body)
    require(corners, "a body has no corner")
    radius = real(body["radius"]) if "radius" in body else Fraction(0)
    require(radius >= 0, "a radius is negative")
    if "pose" in body:
        columns = [vector(c) for c in items(member(body["pose"], "columns"), 3)]
        translation = vector(member(body["pose"], "translation"))
        rows = list(zip(*columns))
        corners = [tuple(dot(row, p) + t for row, t in zip(rows, translation)) for p in corners]
        if radius > 0:
            u, v, w = columns
            require(dot(u, v) == dot(v, w) == dot(w, u) == 0 and dot(u, u) == dot(v, v) == dot(w, w),
                    "the pose makes an ellipsoid of a ball")
            radius *= root(dot(u, u))
    return corners, radius


# What is proved by what: the conditions of docs/convex.md.

def difference_of(pairs, a, b):
    """The point of a that the weights make, less that of b."""
    whole, d = Fraction(0), (Fraction(0),) * 3
    for pair in pairs:
        weight = exact(member(pair, "weight"))
        for key, corners in (("a", a), ("b", b)):
            index = member(pair, key)
            require(type(index) is int and 0 <= index < len(corners), f"there is no corner {index!r} of {key}")
        require(weight > 0, "a weight is not above zero")
        whole += weight
        d = plus(d, plus(a[pair["a"]], b[pair["b"]], -1), weight)
    require(whole == 1, "the weights do not add up to 1")
    return d


def gap_along(n, a, b):
    """From the farthest of a to the nearest of b; and whether all of both is at these ends."""
    of_a, of_b = [dot(n, u) for u in a], [dot(n, v) for v in b]
    return min(of_b) - max(of_a), min(of_a) == max(of_a) and min(of_b) == max(of_b)


def spans(differences, ways):
    """Is every way a combination of the differences?"""
    basis = []
    for d in differences:
        if not in_span(basis, d):
            basis.append(d)
    return all(in_span(basis, way) for way in ways)


def in_span(basis, v):
    if len(basis) == 3:
        return True
    if len(basis) == 2:
        return dot(cross(*basis), v) == 0
    return not any(cross(basis[0], v) if basis else v)


def is_rounded(text, square, inset):
    """Is it the double nearest to root(square) - inset, or to zero where that is negative?"""
    require(text == "infinity" or real(text) >= 0 and not str(text).startswith("-"), "the distance is negative")
    infinity = 0x7FF0000000000000
    bits = infinity if text == "infinity" else struct.unpack(">Q", struct.pack(">d", float.fromhex(text)))[0]

    def value(k):
        return Fraction(2) ** 1024 if k == infinity else Fraction(struct.unpack(">d", struct.pack(">Q", k))[0])

    def beyond_middle(neighbor):
        middle = (value(bits) + value(neighbor)) / 2 + inset
        return (square > middle**2) - (square < middle**2)

    ties = 0 if bits % 2 == 0 else 1
    return (bits == 0 or beyond_middle(bits - 1) >= ties) and (bits == infinity or beyond_middle(bits + 1) <= -ties)


def prove(record):
    claim = member(record, "claim")
    require(claim in ("disjoint", "touching", "overlapping", "intersecting", "distance"), "it claims nothing known")
    (a, radius_a), (b, radius_b) = body_of(member(record, "a")), body_of(member(record, "b"))
    radii = radius_a + radius_b
    pairs = items(member(record, "pairs"))
    n = vector(record["direction"], exact) if "direction" in record else None
    require(claim == "distance" or (n is not None) == (claim in ("disjoint", "touching")), "a direction, or none")
    if claim == "disjoint":
        require(not pairs, "pairs are of no use")
        gap, _ = gap_along(n, a, b)
        require(gap > 0 and gap**2 > radii**2 * dot(n, n), "the gap is not as wide as the radii")
        return claim
    d = difference_of(pairs, a, b)
    square = dot(d, d)
    if claim == "touching":
        require(any(n), "the direction is zero")
        require(square == radii**2, "the points of the pairs are not as far apart as the radii reach")
        gap, is_everything = gap_along(n, a, b)
        require(gap >= 0 and gap**2 == radii**2 * dot(n, n), "the gap is not as wide as the radii")
        require(radii > 0 or not is_everything, "the plane holds all of both bodies")
    elif claim == "overlapping" and radii > 0:
        require(square < radii**2, "the points of the pairs are not nearer than the radii reach")
    elif claim == "overlapping":
        require(square == 0, "the pairs make no common point")
        ways = [plus(p, corners[0], -1) for corners in (a, b) for p in corners]
        require(spans([plus(a[p["a"]], b[p["b"]], -1) for p in pairs], ways), "the pairs do not span the bodies")
    elif claim == "intersecting":
        require(square <= radii**2, "the points of the pairs are farther apart than the radii reach")
    else:
        require(exact(member(record, "square")) == square, "the square is not that of the points of the pairs")
        require(exact(member(record, "inset")) == radii, "the inset is not the sum of the radii")
        require(is_rounded(member(record, "distance"), square, radii), "the distance is not the nearest double")
        require((n is not None) == (square > 0), "a direction, or none")
        if square > 0:
            gap, _ = gap_along(n, a, b)
            require(gap > 0 and gap**2 == square * dot(n, n), "the gap is not as wide as the points are apart")
        return f"distance {record['distance']}"
    return claim


def verdict(line):
    try:
        return True, "proved: " + prove(json.loads(line))
    except (Refused, ValueError, RecursionError) as flaw:
        return False, f"refused: {flaw}"


def main(paths):
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    good = True
    for path in paths or ["/dev/stdin"]:
        with open(path, encoding="utf-8") as lines:
            for line in filter(str.strip, lines):
                proved, text = verdict(line)
                good = good and proved
                print(text)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
