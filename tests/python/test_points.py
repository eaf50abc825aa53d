"""Are trees and hulls of points, and pairs of boxes, those of fractions and of brute force, and like SciPy's in shape?"""

import math
import pickle
import random
from fractions import Fraction

import numpy as np
import pytest

import plumb
from test_signs import SEED, dot, sub


def clouds():
    source = np.random.default_rng(SEED)
    for m in (2, 3):
        yield source.integers(-3, 4, (60, m)).astype(float)  # full of ties
        yield source.random((80, m)) * 10.0 ** source.integers(-3, 3, (80, 1))
        yield np.repeat(source.random((1, m)), 9, axis=0)
        yield source.random((1, m))


def squares(points, x):
    """By fractions, of each point."""
    return [dot(d, d) for d in (sub(list(map(Fraction, p)), list(map(Fraction, x))) for p in points.tolist())]


def rounded_root(square):
    """The double nearest to the root of a fraction."""
    root = math.sqrt(square)
    near = [np.nextafter(root, 0), root, np.nextafter(root, math.inf)]
    # the middles between neighbors decide
    for low, high in zip(near, near[1:]):
        if square < ((Fraction(low) + Fraction(high)) / 2) ** 2:
            return float(low)
    return float(near[-1])


@pytest.mark.parametrize("points", clouds(), ids=lambda p: f"{p.shape[0]} of {p.shape[1]}")
def test_nearest_are_those_of_fractions(points):
    tree = plumb.KDTree(points)
    n, m = points.shape
    queries = np.concatenate([points[:5], points[:5] + 0.5, np.zeros((1, m))])
    for k in (1, 2, 5, n + 2):
        distance, index = tree.query(queries, k)
        assert distance.dtype == np.float64 and index.dtype == np.int32
        assert distance.shape == index.shape == (len(queries),) + ((k,) if k > 1 else ())
        for x, d, i in zip(queries.tolist(), distance.reshape(-1, k), index.reshape(-1, k)):
            far = squares(points, x)
            order = sorted(range(n), key=lambda j: (far[j], j))[:k]
            assert i.tolist() == order + [n] * (k - len(order))
            assert d.tolist() == [rounded_root(far[j]) for j in order] + [math.inf] * (k - len(order))
    for x in queries.tolist():
        far = squares(points, x)
        distance, index = tree.query(x, 3, ties="all")
        last = sorted(far)[min(3, n) - 1]
        assert sorted(index.tolist()) == [j for j in range(n) if far[j] <= last] and len(distance) == len(index)


@pytest.mark.parametrize("points", clouds(), ids=lambda p: f"{p.shape[0]} of {p.shape[1]}")
def test_balls_are_those_of_fractions(points):
    tree = plumb.KDTree(points)
    queries = np.concatenate([points[:4], points[:4] + 0.25])
    for r in (0, 1, 2.5):
        found = tree.query_ball_point(queries, r)
        expected = [[j for j, s in enumerate(squares(points, x)) if s <= Fraction(r) ** 2] for x in queries.tolist()]
        assert found.tolist() == expected
        assert tree.query_ball_point(queries, r, return_length=True).tolist() == [len(e) for e in expected]
        assert tree.query_ball_point(queries[0], r) == expected[0]
    each = np.linspace(0, 2, len(queries))
    assert tree.query_ball_point(queries, each).tolist() == [tree.query_ball_point(x, r) for x, r in zip(queries, each)]


def test_shapes_are_those_of_ckdtree():
    spatial = pytest.importorskip("scipy.spatial")
    source = np.random.default_rng(SEED)
    points = source.random((500, 3))
    ours, theirs = plumb.KDTree(points), spatial.cKDTree(points)
    assert (ours.n, ours.m, len(ours)) == (theirs.n, theirs.m, 500) and np.array_equal(ours.data, theirs.data)
    for shape in ((3,), (7, 3), (2, 5, 3), (0, 3)):
        x = source.random(shape)
        for k in (1, 4, 501):
            for a, b in zip(ours.query(x, k), theirs.query(x, k)):
                assert np.shape(a) == np.shape(b) and np.allclose(a, b)
        a, b = ours.query_ball_point(x, 0.2), theirs.query_ball_point(x, 0.2, return_sorted=True)
        assert np.shape(a) == np.shape(b) if len(shape) > 1 else isinstance(a, list)
        assert (a if isinstance(a, list) else a.tolist()) == (b if isinstance(b, list) else b.tolist())


def test_trees_are_kept():
    points = np.array([[0.0, 0.0], [1.0, 0.0]])
    tree = plumb.KDTree(points)
    points[0] = 7
    assert tree.data.tolist() == [[0, 0], [1, 0]] and tree.query([0.5, 0])[1] == 0
    again = pickle.loads(pickle.dumps(tree))
    assert again.data.tolist() == tree.data.tolist() and repr(again) == repr(tree) == "KDTree(2 points of the plane)"
    with plumb.ThreadLimit(1):
        assert tree.query([[0.75, 0]])[1].tolist() == [1]
    empty = plumb.KDTree(np.zeros((0, 3)))
    assert empty.query([[0, 0, 0]])[0].tolist() == [math.inf] and empty.query_ball_point([0, 0, 0], 1) == []


@pytest.mark.parametrize("make, error, text", [
    (lambda: plumb.KDTree([1, 2, 3]), ValueError, r"KDTree: points has shape \(3,\)"),
    (lambda: plumb.KDTree([[0, math.nan]]), ValueError, r"points\[0, 1\] is nan"),
    (lambda: plumb.KDTree([[0, 0]]).query([1, 2, 3]), ValueError, r"query: x has shape \(3,\) .* expected shape \(..., 2\)"),
    (lambda: plumb.KDTree([[0, 0]]).query([1, 2], 0), ValueError, "k is 0"),
    (lambda: plumb.KDTree([[0, 0]]).query([1, 2], ties="some"), ValueError, "ties is 'some'"),
    (lambda: plumb.KDTree([[0, 0]]).query([[1, math.inf]]), ValueError, "inf"),
    (lambda: plumb.KDTree([[0, 0]]).query_ball_point([1, 2], -1), ValueError, "negative|radius"),
    (lambda: plumb.KDTree([[0, 0]]).query_ball_point([[1, 2]], [1, 2]), ValueError, "broadcast"),
    (lambda: plumb.ConvexHull([[0, 0, 0, 0]]), ValueError, "ConvexHull: points has shape"),
    (lambda: plumb.ConvexHull([[0, math.nan, 0]]), ValueError, r"points\[0, 1\] is nan"),
    (lambda: plumb.minimum_sphere(np.zeros((0, 3))), ValueError, "minimum_sphere"),
    (lambda: plumb.minimum_obb(np.zeros((0, 3))), ValueError, "minimum_obb"),
    (lambda: plumb.overlapping_pairs([[0, 0]]), ValueError, r"expected shape \(n, 2, 2\) or \(n, 2, 3\)"),
    (lambda: plumb.overlapping_pairs([[[1, 1], [0, 0]]]), ValueError, "empty|min"),
    (lambda: plumb.overlapping_pairs(np.zeros((1, 2, 3)), np.zeros((1, 2, 2))), ValueError, "dimension"),
])
def test_what_is_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()


def volume_of(hull):
    """Of the simplices as they turn, by fractions."""
    rows = [[list(map(Fraction, p)) for p in hull.points[s].tolist()] for s in hull.simplices]
    if hull.points.shape[1] == 2:
        return sum(a[0] * b[1] - a[1] * b[0] for a, b in rows) / 2
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
               + a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in rows) / 6


@pytest.mark.parametrize("points", clouds(), ids=lambda p: f"{p.shape[0]} of {p.shape[1]}")
def test_hulls(points):
    hull = plumb.ConvexHull(points)
    m = points.shape[1]
    assert hull.dimension == (m if len({tuple(p) for p in points.tolist()}) > 1 else 0)
    if hull.dimension < m:
        assert hull.vertices.tolist() == [0] and hull.simplices.shape == hull.neighbors.shape == (0, m)
        assert hull.volume == 0 and hull.equations.shape == (0, m + 1)
        return
    for s, beside, equation in zip(hull.simplices, hull.neighbors, hull.equations):
        sides = (plumb.orient2d if m == 2 else plumb.orient3d)(*points[s], points)
        assert (sides >= 0).all() if m == 2 else len(set(sides.tolist()) - {0}) == 1
        assert math.isclose(math.hypot(*equation[:-1]), 1) and (points @ equation[:-1] + equation[-1] < 1e-9 * 1e3).all()
        assert np.allclose(points[s] @ equation[:-1] + equation[-1], 0)
        for k, other in enumerate(beside):
            assert set(s) - {s[k]} <= set(hull.simplices[other]) and s[k] not in hull.simplices[other]
    assert set(hull.simplices.ravel()) == set(hull.vertices)
    assert volume_of(hull) > 0 and hull.volume == float(volume_of(hull))
    assert plumb.ConvexHull(points[hull.vertices]).volume == hull.volume
    again = pickle.loads(pickle.dumps(hull))
    assert again.vertices.tolist() == hull.vertices.tolist() and repr(again) == repr(hull)
    spatial = pytest.importorskip("scipy.spatial")
    theirs = spatial.ConvexHull(points)
    assert math.isclose(theirs.volume, hull.volume, rel_tol=1e-9) and math.isclose(theirs.area, hull.area, rel_tol=1e-9)
    assert theirs.equations.shape[1] == hull.equations.shape[1] and theirs.neighbors.shape[1] == hull.neighbors.shape[1]


def test_flat_hulls():
    hull = plumb.ConvexHull([[0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1], [1, 1, 1]])
    assert hull.dimension == 2 and hull.vertices.tolist() == [0, 1, 2, 3] and hull.area == 8 and hull.volume == 0
    line = plumb.ConvexHull([[0, 0], [3, 4], [1.5, 2]])
    assert line.dimension == 1 and sorted(line.vertices.tolist()) == [0, 1] and line.area == 10
    assert plumb.ConvexHull(np.zeros((0, 2))).dimension == -1


def test_smallest_balls_and_boxes():
    ball, support = plumb.minimum_sphere([[0, 0, 0], [2, 0, 0], [1, 0.5, 0], [1, 0, 1]])
    assert ball == plumb.Sphere3([1, 0, 0], 1) and set(support.tolist()) >= {0, 1}
    assert plumb.minimum_sphere([[0, 0], [0, 2], [1, 1]]).ball == plumb.Circle2([0, 1], 1)
    box = plumb.minimum_obb([[0, 0], [4, 3], [-3, 4], [1, 7]])
    assert isinstance(box, plumb.Obb2) and plumb.contains(box, [[0, 0], [4, 3], [-3, 4], [1, 7]]).all()
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 3)], float)
    box = plumb.minimum_obb(corners)
    assert plumb.contains(box, corners).all() and math.isclose(8 * np.prod(box.half), 6, rel_tol=1e-9)


@pytest.mark.parametrize("m", [2, 3])
def test_pairs_of_boxes(m):
    source = random.Random(SEED + m)
    boxes = []
    for _ in range(2):
        low = np.array([[source.randint(0, 12) for _ in range(m)] for _ in range(40)], float)
        boxes.append(np.stack([low, low + [[source.randint(0, 3) for _ in range(m)] for _ in range(40)]], axis=1))
    a, b = boxes
    meet = ((a[:, None, 0] <= b[None, :, 1]) & (b[None, :, 0] <= a[:, None, 1])).all(axis=2)
    pairs = plumb.overlapping_pairs(a, b)
    assert pairs.dtype == np.int32 and pairs.tolist() == np.argwhere(meet).tolist() and 0 < len(pairs) < meet.size
    meet = ((a[:, None, 0] <= a[None, :, 1]) & (a[None, :, 0] <= a[:, None, 1])).all(axis=2)
    assert plumb.overlapping_pairs(a).tolist() == np.argwhere(np.triu(meet, 1)).tolist()
    fewer = plumb.overlapping_pairs(a, touching=False).tolist()
    make = plumb.Aabb2 if m == 2 else plumb.Aabb3
    assert fewer == [[i, j] for i, j in plumb.overlapping_pairs(a).tolist()
                     if plumb.relate(make(*a[i]), make(*a[j])) == plumb.Relation.overlapping]
    assert plumb.overlapping_pairs(np.zeros((0, 2, m))).shape == (0, 2)
