"""Does `plumb.degenerate.fuzz` find what is wrong with functions of Python, and nothing with those that are right?"""

import doctest
from fractions import Fraction

import numpy as np
import pytest

import plumb
from plumb import degenerate
from plumb.degenerate import fuzz

CASES = 100


def fraction_turn(a, b, c):
    (ax, ay), (bx, by), (cx, cy) = (map(Fraction, p.tolist()) for p in (a, b, c))
    return (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)


def box(corners):
    return plumb.Aabb3(*corners)


def obb(rows):
    return plumb.Obb3(rows[0], rows[1:4], rows[4])


def first_hit(ray, triangle):
    hit = plumb.first_hit(plumb.Ray3(*ray), plumb.Triangle3(*triangle))
    return None if hit is None else hit.t


RIGHT = {
    "orient2d": plumb.orient2d,
    "orient3d": plumb.orient3d,
    "incircle": plumb.incircle,
    "insphere": plumb.insphere,
    "segment-segment": lambda a, b: plumb.intersects(plumb.Segment2(*a), plumb.Segment2(*b)),
    "segment-segment-3d": lambda a, b: plumb.intersects(plumb.Segment3(*a), plumb.Segment3(*b)),
    "triangle-triangle": lambda a, b: plumb.intersects(plumb.Triangle3(*a), plumb.Triangle3(*b)),
    "box-box": lambda a, b: plumb.intersects(box(a), box(b)),
    "obb-obb": lambda a, b: plumb.intersects(obb(a), obb(b)),
    "ray-triangle": first_hit,
    "point-in-polygon": lambda p, v: plumb.contains(plumb.Polygon2(v), p),
    "hull": lambda points: None,  # it does not know
}


@pytest.mark.parametrize("kind", RIGHT)
def test_what_is_exact_is_clean(kind):
    found = fuzz(RIGHT[kind], kind, cases=CASES)
    assert found.clean, str(found)
    assert sum(t.asked for t in found.tallies) >= CASES * (len(found.tallies) - 1) and str(found).startswith(kind)


def test_signs_smaller_than_doubles_count():
    assert fuzz(fraction_turn, "orient2d", cases=CASES).clean


def test_every_kind_can_be_asked():
    assert len(degenerate.kinds()) > 60
    for kind, about in degenerate.kinds().items():
        shapes = []
        found = fuzz(lambda *arguments: shapes.append([a.shape for a in arguments]), kind, cases=3)
        ray = kind in ("ray-triangle", "ray-mesh")  # None is a miss there
        assert shapes and all(len(s) == about.split("): ")[0].count(",") + 1 for s in shapes), (kind, about)
        assert ray or (found.clean and sum(t.unsure for t in found.tallies) == len(shapes))


def test_a_finding_is_small_and_has_its_line():
    def turn(a, b, c):
        return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])

    found = fuzz(turn, "orient2d", seed=7, generators=["near_half"])
    assert not found.clean and len(found.findings) == 1
    case = found.findings[0]
    assert np.sign(turn(*case.arguments)) != plumb.orient2d(*case.arguments)
    assert case.line.split()[0] == "orient2d" and case.line in str(found)
    numbers = [float.fromhex(x) for x in case.line.split()[1:7]]
    assert numbers == np.concatenate(case.arguments).tolist()
    assert str(fuzz(turn, "orient2d", seed=7, generators=["near_half"])) == str(found)
    assert str(fuzz(turn, "orient2d", seed=8, generators=["near_half"])) != str(found)


def test_meshes_and_hulls_are_arrays():
    seen = []

    def outside(p, vertices, triangles):
        seen.append((p, vertices, triangles))
        return False

    found = fuzz(outside, "point-in-polyhedron", cases=20)
    assert not found.clean and "no for yes" in {f.sort for f in found.findings}
    for p, vertices, triangles in seen:
        assert p.shape == (3,) and vertices.shape[1] == triangles.shape[1] == 3 and triangles.dtype == np.int32
        assert triangles.size == 0 or triangles.max() < len(vertices)
    tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    assert not fuzz(lambda points: tetrahedron, "hull", cases=20).clean


def test_what_is_raised_is_a_finding_and_ctrl_c_is_not():
    def divides(a, b, c):
        return 1 / 0

    found = fuzz(divides, "orient2d", cases=10)
    assert {f.sort for f in found.findings} == {"threw"} and "ZeroDivisionError" in str(found)

    def stops(a, b, c):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fuzz(stops, "orient2d")


def test_progress_can_stop():
    asked = []

    def once(so_far):
        asked.append(so_far)
        return False

    fuzz(plumb.orient2d, "orient2d", cases=100_000, progress=once)
    assert len(asked) == 1 and 0 < asked[0] < 10_000


@pytest.mark.parametrize("kind, answer", [("orient2d", "left"), ("hull", [[0, 1]]), ("convex-distance", "far"),
                                          ("orient2d", np.zeros(2))])
def test_what_is_no_answer_ends_the_run(kind, answer):
    with pytest.raises((TypeError, ValueError)):
        fuzz(lambda *arguments: answer, kind)


def test_what_is_refused():
    with pytest.raises(ValueError, match="orient4d; there are orient2d"):
        fuzz(plumb.orient2d, "orient4d")
    with pytest.raises(ValueError, match="no generator luck"):
        fuzz(plumb.orient2d, "orient2d", generators=["luck"])
    with pytest.raises(TypeError):
        fuzz(plumb.orient2d)


def test_doctests():
    results = doctest.testmod(degenerate)
    assert results.attempted > 3 and results.failed == 0
