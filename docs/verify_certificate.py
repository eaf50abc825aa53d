#!/usr/bin/env python3
"""Re-proves certificates of how two convex bodies lie, with nothing but fractions.

    python3 verify_certificate.py FILE...      (or from standard input)

A file holds certificates as plumb::certificate_text writes them, one a line.  For each a line says what is proved, or
why nothing is; the status is 0 where all are.  What may be written, what the numbers mean, and why they prove it:
docs/convex.md.
"""

import json
import math
import re
import struct
import sys
from fractions import Fraction

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)


class Refused(Exception):
    pass


def require(condition, flaw):
    if not condition:
        raise Refused(flaw)


# The text is JSON of one line.  Its only numbers are those of corners; no member is given twice.

def index(text):
    require(re.fullmatch("0|[1-9][0-9]{0,9}", text), f"{text} is not the number of a corner")
    return int(text)


def no_number(text):
    raise Refused(f"{text} is not the number of a corner")


def once(members):
    record = dict(members)
    require(len(record) == len(members), "a member is given twice")
    return record


def read(line):
    text = line[:-1] if line.endswith(b"\n") else line
    require(b"\n" not in text, "a certificate is one line")
    return json.loads(text.decode("utf-8"), object_pairs_hook=once, parse_int=index, parse_float=no_number,
                      parse_constant=no_number)


# Numbers are texts: "-3/8", "5", or hexadecimal doubles, "0x1.8p-3".

def real(text):
    require(isinstance(text, str), "a number is no text")
    require(re.fullmatch(r"-?0x[01](\.[0-9a-f]{1,13})?p[+-](0|[1-9][0-9]{0,3})", text),
            f"{text!a} is no hexadecimal double")
    digits, power = text.split("p")
    whole, _, part = digits.partition(".")
    value = int(whole + part, 16) * Fraction(2) ** (int(power) - 4 * len(part))
    try:
        require(float(value) == value, f"{text!a} is between two doubles")
    except OverflowError:
        raise Refused(f"{text!a} is beyond all doubles") from None
    return value


def exact(text):
    require(isinstance(text, str), "a number is no text")
    if "x" in text:
        return real(text)
    require(re.fullmatch("0|-?[1-9][0-9]*(/[1-9][0-9]*)?", text), f"{text!a} is no fraction")
    return Fraction(text)


def items(values, count=None):
    require(isinstance(values, list), "a list is missing")
    require(count is None or len(values) == count, "a list is too long or too short")
    return values


def vector(values, number=real):
    return tuple(number(x) for x in items(values, 3))


def members(record, *wanted, optional=()):
    """Those wanted, in their order; there are no others than these and the optional ones."""
    require(isinstance(record, dict), "an object is missing")
    for key in record:
        require(key in wanted or key in optional, f"{key!a} is not known here")
    for key in wanted:
        require(key in record, f"{key} is missing")
    return [record[key] for key in wanted]


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
    """The corners as they are without the pose, and the radius."""
    require(isinstance(body, dict), "a body is missing")
    if "vertices" in body and "radius" in body:
        vertices, radius = members(body, "vertices", "radius", optional=["pose"])
        require(len(items(vertices)) in (1, 2), "a radius is of one vertex, or of two")
        return [vector(p) for p in vertices], real(radius)
    if "vertices" in body:
        [vertices] = members(body, "vertices", optional=["pose"])
        return [vector(p) for p in items(vertices)], Fraction(0)
    if "min" in body:
        least, most = (vector(p) for p in members(body, "min", "max", optional=["pose"]))
        require(all(low <= high for low, high in zip(least, most)), "the box is empty")
        return [tuple((most if i >> k & 1 else least)[k] for k in range(3)) for i in range(8)], Fraction(0)
    if "corner" in body:
        corner, edges, radius = members(body, "corner", "edges", "radius", optional=["pose"])
        return corners_along(vector(corner), [vector(e) for e in items(edges, 2)], False), real(radius)
    center, axes, half = members(body, "center", "axes", "half", optional=["pose"])
    axes = [vector(axis) for axis in items(axes)]
    require(len(axes) in (2, 3), "a box has two axes, or three")
    ways = [tuple(abs(real(h)) * x for x in axis) for axis, h in zip(axes, items(half, len(axes)))]
    return corners_along(vector(center), ways, True), Fraction(0)


def root(x):
    n, d = math.isqrt(x.numerator), math.isqrt(x.denominator)
    require(n * n == x.numerator and d * d == x.denominator, "the pose's scale is not rational")
    return Fraction(n, d)


def images(columns, translation, points):
    rows = list(zip(*columns))
    return [tuple(dot(row, p) + t for row, t in zip(rows, translation)) for p in points]


def moved(pose, points):
    """By a quaternion of any length but zero, v -> q v / q, and a translation; of a chain by its last link first."""
    if "links" in pose:
        [links] = members(pose, "links")
        for link in reversed(items(links)):
            require(isinstance(link, dict) and "turn" in link, "a link is no turn")
            points = moved(link, points)
        return points
    turn, translation = members(pose, "turn", "translation")
    w, x, y, z = (real(part) for part in items(turn, 4))
    norm = w * w + x * x + y * y + z * z
    require(norm > 0, "the quaternion is zero, which is no turn")
    v = (x, y, z)

    def turned(p):  # p + 2 w (v x p) / norm + 2 v x (v x p) / norm
        once = cross(v, p)
        return plus(plus(p, once, 2 * w / norm), cross(v, once), 2 / norm)
    return [plus(turned(p), vector(translation)) for p in points]


def body_of(body):
    corners, radius = standing(body)
    require(corners, "a body has no corner")
    require(radius >= 0, "a radius is negative")
    if "pose" in body:
        pose = body["pose"]
        if isinstance(pose, dict) and ("turn" in pose or "links" in pose):
            return moved(pose, corners), radius
        columns, translation = members(pose, "columns", "translation")
        columns, translation = [vector(c) for c in items(columns, 3)], vector(translation)
        corners = images(columns, translation, corners)
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
    for i, j, weight in pairs:
        require(i < len(a) and j < len(b), f"there is no corner {i} of a, or {j} of b")
        require(weight > 0, "a weight is not above zero")
        whole += weight
        d = plus(d, plus(a[i], b[j], -1), weight)
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
    require(text == "infinity" or real(text) >= 0 and not text.startswith("-"), "the distance is negative")
    infinity = 0x7FF0000000000000
    bits = infinity if text == "infinity" else struct.unpack(">Q", struct.pack(">d", float.fromhex(text)))[0]

    def value(k):
        return Fraction(2) ** 1024 if k == infinity else Fraction(struct.unpack(">d", struct.pack(">Q", k))[0])

    def beyond_middle(neighbor):
        middle = (value(bits) + value(neighbor)) / 2 + inset
        return (square > middle**2) - (square < middle**2)

    ties = 0 if bits % 2 == 0 else 1
    return (bits == 0 or beyond_middle(bits - 1) >= ties) and (bits == infinity or beyond_middle(bits + 1) <= -ties)


def pair_of(record):
    i, j, weight = members(record, "a", "b", "weight")
    require(type(i) is int and type(j) is int, "a corner is named by no number")
    return i, j, exact(weight)


def prove(record):
    require(isinstance(record, dict), "an object is missing")
    claim = record.get("claim")
    require(claim in ("disjoint", "touching", "overlapping", "intersecting", "distance"), "it claims nothing known")
    numbers = ("distance", "square", "inset") if claim == "distance" else ()
    pairs, a, b, *_ = members(record, "pairs", "a", "b", "claim", *numbers, optional=["direction"])
    (a, radius_a), (b, radius_b) = body_of(a), body_of(b)
    radii = radius_a + radius_b
    pairs = [pair_of(pair) for pair in items(pairs)]
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
        require(spans([plus(a[i], b[j], -1) for i, j, _ in pairs], ways), "the pairs do not span the bodies")
    elif claim == "intersecting":
        require(square <= radii**2, "the points of the pairs are farther apart than the radii reach")
    else:
        require(exact(record["square"]) == square, "the square is not that of the points of the pairs")
        require(exact(record["inset"]) == radii, "the inset is not the sum of the radii")
        require(is_rounded(record["distance"], square, radii), "the distance is not the nearest double")
        require((n is not None) == (square > 0), "a direction, or none")
        if square > 0:
            gap, _ = gap_along(n, a, b)
            require(gap > 0 and gap**2 == square * dot(n, n), "the gap is not as wide as the points are apart")
        return f"distance {record['distance']}"
    return claim


def verdict(line):
    """Of the bytes of a certificate."""
    try:
        return True, "proved: " + prove(read(line))
    except (Refused, ValueError, RecursionError) as flaw:
        return False, f"refused: {flaw}"


def main(paths):
    good = True
    for path in paths or ["/dev/stdin"]:
        with open(path, "rb") as lines:
            for line in filter(lambda blank: blank.strip(b" \t\r\n"), lines):
                proved, text = verdict(line)
                good = good and proved
                print(text)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
