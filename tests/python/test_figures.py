"""Are figures what their numbers say, and are the answers about them those of fractions, of the vectors and of the laws?"""

import itertools
import math
import pickle
import random
import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import plumb
from plumb import (Aabb2, Aabb3, Capsule2, Capsule3, Circle2, Cone3, ConvexPolyhedron3, Cylinder3, Halfspace2, Halfspace3,
                   HalfspaceIntersection2, HalfspaceIntersection3, HoledPolygon2, HoledPolygon3, KDop2, KDop3, Line2,
                   Line3, Lozenge3, Obb2, Obb3, Plane3, Point2, Point3, Polygon2, Polygon3, Quadrilateral2,
                   Quadrilateral3, Ray2, Ray3, Rectangle3, Relation, Segment2, Segment3, Sphere3, SphericalCap3,
                   Tetrahedron3, ThreePointPlane3, Triangle2, Triangle3)
from test_signs import SEED, cases, cross, dot, sub

TREE = Path(__file__).resolve().parents[2]

FIGURES = [
    Point2([1, 2]), Line2([0, 0], [1, 2]), Ray2([0, 0], [1, 2]), Segment2([0, 0], [1, 2]), Halfspace2([1, 1], 2),
    Triangle2([0, 0], [2, 0], [0, 2]), Quadrilateral2([0, 0], [2, 0], [2, 2], [0, 2]),
    Polygon2([[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]]),
    HoledPolygon2(Polygon2([[0, 0], [6, 0], [0, 6]]), [Polygon2([[1, 1], [2, 1], [1, 2]])]), Circle2([1, 1], 0.1),
    Aabb2([0, 0], [2, 1]), Obb2([0, 0], [[3, 4], [-4, 3]], [0.2, 0.4]), Capsule2([0, 0], [1, 1], 0.5),
    KDop2([[1, 0], [0, 1], [1, 1]], [0, 0, 0], [1, 2, 2.5]), HalfspaceIntersection2([Halfspace2([1, 0], 1)]),
    Point3([1, 2, 3]), Line3([0, 0, 0], [1, 2, 3]), Ray3([0, 0, 0], [1, 2, 3]), Segment3([0, 0, 0], [1, 2, 3]),
    Plane3([1, 1, 0], 2), ThreePointPlane3([1, 0, 0], [0, 1, 0], [0, 0, 1]), Halfspace3([1, 1, 1], 2),
    Triangle3([0, 0, 0], [2, 0, 1], [0, 2, 0]), Quadrilateral3([0, 0, 1], [2, 0, 1], [2, 2, 1], [0, 2, 1]),
    Polygon3([[0, 0, 1], [4, 0, 1], [4, 4, 1], [2, 1, 1], [0, 4, 1]]),
    HoledPolygon3(Polygon3([[0, 0, 1], [6, 0, 1], [0, 6, 1]]), [Polygon3([[1, 1, 1], [2, 1, 1], [1, 2, 1]])]),
    Rectangle3([1, 1, 1], [[1, 0, 0], [0, 1, 0]], [0.5, 2]), Tetrahedron3([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]),
    Sphere3([1, 1, 1], 0.1), Aabb3([0, 0, 0], [2, 1, 1]),
    Obb3([0, 0, 0], [[3, 4, 0], [-4, 3, 0], [0, 0, 1]], [0.2, 0.4, 1]), Capsule3([0, 0, 0], [1, 1, 1], 0.5),
    Lozenge3([0, 0, 0], [[1, 0, 0], [0, 2, 0]], 0.25), Cylinder3([0, 0, 0], [0, 0, 2], 1), Cone3([0, 0, 2], [0, 0, 0], 1),
    KDop3(np.eye(3), [0, 0, 0], [1, 2, 3]), HalfspaceIntersection3([Halfspace3([1, 0, 0], 1), Halfspace3([0, 1, 0], 1)]),
    ConvexPolyhedron3([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]),
    SphericalCap3(Sphere3([0, 0, 0], 2), Halfspace3([0, 0, -1], -1)),
]
TURN = {2: [3, 1], 3: [1, 2, 0, -1]}
MATRIX = {2: [[1, 2, 5], [0, 1, 0.25], [0, 0, 1]], 3: [[1, 2, 0, 5], [0, 1, 0, 0.25], [0, 0, 3, 0], [0, 0, 0, 1]]}


def test_every_kind_of_the_library_is_here():
    table = (TREE / "include/plumb/query/body/pairs.hpp").read_text()
    structs = set(re.findall(r"PLUMB_KIND\((\w+), \w+, \d\)", table))
    assert len(structs) == 39
    assert {c.__name__ for c in plumb.Figure.__subclasses__()} == structs == {type(f).__name__ for f in FIGURES}
    assert len(FIGURES) == len(structs)


def variants(figure):
    d = figure.dimension
    yield figure
    yield figure.posed(MATRIX[d])
    yield figure.posed(turn=TURN[d], translation=[0.1] * d)


@pytest.mark.parametrize("figure", FIGURES, ids=lambda f: type(f).__name__)
def test_is_its_numbers(figure):
    assert figure.dimension == int(type(figure).__name__[-1]) and isinstance(figure.kind, str)
    for f in variants(figure):
        for again in (eval(repr(f)), pickle.loads(pickle.dumps(f))):
            assert again == f and type(again) is type(f) and hash(again) == hash(f) and repr(again) == repr(f)
    assert figure.posed() == figure != figure.posed(MATRIX[figure.dimension])
    assert figure.posed(MATRIX[figure.dimension]).pose.tolist() == MATRIX[figure.dimension]
    rigid = figure.posed(turn=TURN[figure.dimension])
    assert rigid.turn.tolist() == TURN[figure.dimension] and rigid.translation.tolist() == [0] * figure.dimension
    assert rigid.pose is None and figure.turn is None and figure.translation is None


def test_members_are_read_as_they_were_given():
    box = Obb3(center=[0.1, 5e-324, -0.0], axes=[[1, 2, 3], [0, 0, 0], [1e300, 0, 0]], half=[1, 2, 3])
    assert box.center.tolist() == [0.1, 5e-324, 0] and math.copysign(1, box.center[2]) == -1
    assert box.axes.tolist() == [[1, 2, 3], [0, 0, 0], [1e300, 0, 0]] and box.half.dtype == np.float64
    assert Point3([1, 2, 3]).coordinates.tolist() == [1, 2, 3]
    assert FIGURES[8].holes == [Polygon2([[1, 1], [2, 1], [1, 2]])]
    assert FIGURES[-2].faces == [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    assert Sphere3(np.float32([1, 2, 3]), np.int8(4)) == Sphere3(radius=4, center=(1, 2, 3)) != 4


@pytest.mark.parametrize("make, error, text", [
    (lambda: Sphere3([0, 0], 1), ValueError, r"Sphere3: center has shape \(2,\) .* expected shape \(3,\)"),
    (lambda: Sphere3([0, 0, math.nan], 1), ValueError, r"Sphere3: center\[2\] is nan; a finite number is needed"),
    (lambda: Sphere3([0, 0, 0], math.inf), ValueError, "Sphere3: radius is inf"),
    (lambda: Sphere3([0, 0, 0], -1), ValueError, "Sphere3: sphere.radius is negative"),
    (lambda: Sphere3([0, 0, 0], [1]), ValueError, "radius has shape .* expected one number"),
    (lambda: Sphere3([0, 0, 0], "1"), TypeError, "radius"),
    (lambda: Sphere3([0, 0, 0]), TypeError, "missing the argument 'radius'"),
    (lambda: Sphere3([0, 0, 0], 1, 2), TypeError, r"Sphere3\(\) takes 2 arguments, but 3 were given"),
    (lambda: Sphere3([0, 0, 0], 1, radius=2), TypeError, "got argument 'radius' twice"),
    (lambda: Sphere3([0, 0, 0], radios=2), TypeError, "no argument 'radios'"),
    (lambda: Sphere3([2**60 + 1, 0, 0], 1), ValueError, "2\\^53"),
    (lambda: Polygon2([[0, 0], [1, 1]]), ValueError, "polygon.vertices has 2 vertices"),
    (lambda: SphericalCap3(FIGURES[0], FIGURES[0]), ValueError, "sphere is a Point2; expected a Sphere3"),
    (lambda: HoledPolygon2(FIGURES[7].posed(MATRIX[2]), []), ValueError, "outer is under a pose"),
    (lambda: HoledPolygon2([[0, 0], [1, 0], [0, 1]], []), TypeError, "outer is no figure, but list"),
    (lambda: KDop2([[0, 0]], [1], [2]), ValueError, r"directions\[0\] is zero"),
    (lambda: KDop2([[1, 0]], [1, 2], [2]), ValueError, "KDop2"),
    (lambda: ConvexPolyhedron3(np.zeros((3, 3)), [[0, 1, 5]]), ValueError, "vertex 5, but there are 3"),
    (lambda: ConvexPolyhedron3(np.zeros((3, 3)), 7), TypeError, "faces"),
    (lambda: FIGURES[-1].posed(np.eye(3)), ValueError, r"posed: pose has shape \(3, 3\)"),
    (lambda: FIGURES[-1].posed(np.ones((4, 4))), ValueError, "last row"),
    (lambda: FIGURES[-1].posed(turn=[0, 0, 0, 0]), ValueError, "turn is zero"),
    (lambda: FIGURES[-1].posed(np.eye(4), turn=[1, 0, 0, 0]), TypeError, "not both"),
    (lambda: plumb.Figure(), TypeError, "of no kind"),
    (lambda: plumb.relate(3, FIGURES[0]), TypeError, "relate: a is no figure, but int"),
    (lambda: plumb.relate(FIGURES[0], "abc"), TypeError, "relate: b is no figure, but str"),
    (lambda: plumb.relate(FIGURES[0], [1, 2, 3]), ValueError, "no answer for a point of the plane and a point of space"),
    (lambda: plumb.distance([1, 2, math.nan], FIGURES[-1]), ValueError, r"distance: a\[2\] is nan"),
    (lambda: plumb.distance([1, 2, 3, 4], FIGURES[-1]), ValueError, "shape"),
    (lambda: plumb.contact(FIGURES[-9], FIGURES[-10], margin=-1), ValueError, "margin"),
    (lambda: plumb.parse_figure("bowl3 1 2 3"), ValueError, "there is no figure 'bowl3'; there are"),
    (lambda: plumb.first_contact(FIGURES[0], FIGURES[1], [1, 2, 3]), ValueError, r"by has shape \(3,\)"),
])
def test_what_is_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()


def test_lines_of_text():
    for f in FIGURES:
        for v in variants(f):
            line = v.__reduce__()[1][0]
            assert plumb.parse_figure(line) == v
    assert plumb.parse_figure("") is None
    assert plumb.parse_figure("ball3 1 2 3 0x1p-1") == Sphere3([1, 2, 3], 0.5)
    chain = plumb.parse_figure("point3 1 2 3 chain 1 0 0 0 1 1 1 1 1 0 0 0 0 0")
    assert eval(repr(chain), {"parse_figure": plumb.parse_figure}) == chain


def answered(question, *arguments):
    """The answer, or None where the library says that there is none for such a pair."""
    try:
        return question(*arguments)
    except ValueError as e:
        assert re.search("has no answer|takes|not convex", str(e)), e
        return None


def test_laws_of_all_pairs():
    told = {"relate": 0, "distance": 0, "closest_points": 0, "intersection": 0, "first_contact": 0, "penetration": 0}
    for a, b in itertools.combinations_with_replacement(FIGURES, 2):
        if a.dimension != b.dimension:
            continue
        d = a.dimension
        relation = answered(plumb.relate, a, b)
        if relation is None:
            continue
        told["relate"] += 1
        assert plumb.relate(b, a) == relation
        assert plumb.relate(a.posed(MATRIX[d]), b.posed(MATRIX[d])) == relation
        assert plumb.intersects(a, b) == (relation != Relation.disjoint)
        distance = answered(plumb.distance, a, b)
        if distance is not None:
            told["distance"] += 1
            assert plumb.distance(b, a) == distance and (distance == 0) == (relation != Relation.disjoint)
            exact = plumb.distance(a, b, exact=True)
            assert math.isclose(max(0, math.sqrt(exact.square) - exact.inset), distance, rel_tol=1e-15, abs_tol=1e-15)
            if exact.inset == 0:
                assert plumb.squared_distance(a, b) == exact.square
        closest = answered(plumb.closest_points, a, b)
        if closest is not None:
            told["closest_points"] += 1
            assert closest.distance == distance and closest.on_a.shape == (d,)
            assert math.isclose(math.dist(closest.on_a, closest.on_b), distance, rel_tol=1e-14, abs_tol=1e-14)
        common = answered(plumb.intersection, a, b)
        if common is not None:
            told["intersection"] += 1
            assert (common.kind == "nothing") == (relation == Relation.disjoint) and common.vertices.shape[1:] == (d,)
            exact = plumb.intersection(a, b, exact=True)
            assert exact.kind == common.kind and [[float(x) for x in p] for p in exact.vertices] == common.vertices.tolist()
            for p in exact.vertices:
                if all(x == float(x) for x in p) and not isinstance(a, (HoledPolygon2, HoledPolygon3)):
                    assert plumb.intersects(a, [float(x) for x in p])
        contact = answered(plumb.first_contact, a, b, [1] * d)
        if contact is not None:
            told["first_contact"] += 1
            assert (contact.time == 0) == (relation != Relation.disjoint)
            exact = plumb.first_contact(a, b, [1] * d, exact=True).time
            if isinstance(exact, Fraction):
                assert Fraction(contact.time) <= exact <= Fraction(np.nextafter(contact.time, 2))
        parted = answered(plumb.penetration, a, b) if d == 3 else None
        if parted is not None:
            told["penetration"] += 1
            assert relation != Relation.disjoint and parted.depth >= 0
    assert told["relate"] > 350 and told["distance"] > 150 and told["closest_points"] > 150, told
    assert told["intersection"] > 100 and told["first_contact"] > 30 and told["penetration"] > 30, told


def test_distances_of_the_vectors():
    numbers, answers = cases("point-triangle-distance")
    text = (TREE / "docs/vectors/point-triangle-distance.txt").read_text()
    lines = [line for line in text.splitlines() if line.startswith("point-triangle-distance ")]
    for row, line in zip(numbers, lines):
        given = float.fromhex(line.split("=", 1)[1].split()[0])
        assert plumb.distance(row[:3], Triangle3(*row[3:].reshape(3, 3))) == given
    assert len(set(answers)) > 10


@pytest.mark.parametrize("task, make, parts", [
    ("box-box", Aabb3, 2), ("triangle-triangle", Triangle3, 3), ("segment-segment", Segment2, 2),
])
def test_relations_of_the_vectors(task, make, parts):
    numbers, answers = cases(task)
    met = 0
    for row, answer in zip(numbers, answers):
        a, b = (make(*half.reshape(parts, -1)) for half in np.split(row, 2))
        yes = answer in ("yes", "touching", "overlapping")
        met += yes
        assert plumb.intersects(a, b) == yes, (task, row.tolist(), answer)
    assert 0 < met < len(answers)


def fractions(rows):
    return [[Fraction(x) for x in row] for row in rows]


def to_triangle(p, a, b, c):
    """The square of the distance, by fractions."""
    n = cross(sub(b, a), sub(c, a))
    edges = [(a, b), (b, c), (c, a)]
    if any(n) and all(dot(cross(sub(v, u), sub(p, u)), n) >= 0 for u, v in edges):
        return Fraction(dot(n, sub(p, a))) ** 2 / dot(n, n)
    best = None
    for u, v in edges:
        e = sub(v, u)
        t = min(1, max(0, Fraction(dot(e, sub(p, u)), 1) / dot(e, e))) if any(e) else 0
        off = sub(p, [x + t * y for x, y in zip(u, e)])
        best = dot(off, off) if best is None else min(best, dot(off, off))
    return best


def test_squares_of_distances_are_those_of_fractions():
    source = random.Random(SEED)
    for _ in range(300):
        points = [[source.choice([source.randint(-3, 3), source.uniform(-3, 3), 0.1 * source.randint(-9, 9)])
                   for _ in range(3)] for _ in range(4)]
        expected = to_triangle(*fractions(points))
        triangle = Triangle3(*points[1:])
        assert plumb.squared_distance(points[0], triangle) == expected
        distance = plumb.distance(points[0], triangle)
        low, high = (Fraction(np.nextafter(distance, side)) for side in (-1, 1e9))
        assert low ** 2 <= expected <= high ** 2
        radius = Fraction(source.randint(0, 8), 4)
        exact = plumb.distance(points[0], Sphere3(points[1], float(radius)), exact=True)
        off = sub(*fractions(points[:2]))
        outside = dot(off, off) > radius ** 2
        assert exact == (dot(off, off), radius) if outside else exact.square <= exact.inset ** 2


def test_hits_are_those_of_fractions():
    source = random.Random(SEED + 1)
    hits = 0
    for _ in range(2000):
        o, d, a, b, c = ([source.randint(-2, 2) for _ in range(3)] for _ in range(5))
        n = cross(sub(b, a), sub(c, a))
        if not dot(n, d):
            continue
        t = Fraction(dot(n, sub(a, o)), dot(n, d))
        p = [x + t * y for x, y in zip(o, d)]
        inside = t >= 0 and all(dot(cross(sub(v, u), sub(p, u)), n) >= 0 for u, v in ((a, b), (b, c), (c, a)))
        hit = plumb.first_hit(Ray3(o, d), Triangle3(a, b, c), exact=True)
        assert (hit is not None) == inside
        if hit:
            hits += 1
            assert hit.t == t and hit.point.tolist() == [float(x) for x in p]
            assert plumb.first_hit(Ray3(o, d), Triangle3(a, b, c)).t == float(t)
    assert 100 < hits < 1000
    ball = plumb.first_hit(Line3([0, 1, 0], [1, 0, 0]), Sphere3([5, 0, 0], 2), exact=True)
    assert ball.t == plumb.SquareRoot(base=5, square=3, greater=False)
    assert plumb.first_hit(Ray2([0, 0], [1, 0]), Circle2([5, 0], 2), exact=True).t == 3


def test_contacts_in_time():
    assert plumb.first_contact(Sphere3([0, 0, 0], 1), [5, 0, 0], [10, 0, 0], exact=True).time == Fraction(2, 5)
    assert plumb.first_contact(Aabb3([0, 0, 0], [1, 1, 1]), Aabb3([3, 0, 0], [4, 1, 1]), [1, 0, 0], [-2, 0, 0],
                               exact=True).time == Fraction(2, 3)
    assert plumb.first_contact(Aabb2([0, 0], [1, 1]), [3, 0.5], [1, 0]) is None
    assert plumb.intersects(Aabb2([0, 0], [1, 1]), [3, 0.5], [2, 0]) and not plumb.intersects(Aabb2([0, 0], [1, 1]), [3, 0.5])
    time = plumb.first_contact(Capsule3([0, 0, 0], [1, 1, 0], 1), [5, 0, 0], [10, 1, 0], exact=True).time
    if isinstance(time, plumb.PolynomialRoot):
        low, high = time.bounds
        value = [sum(c * x ** i for i, c in enumerate(time.coefficients)) for x in (low, high)]
        assert value[0] * value[1] <= 0


def test_penetration_and_contact():
    a, b = Aabb3([0, 0, 0], [2, 2, 2]), Aabb3([1.5, 0.25, 0], [4, 2, 2])
    parted = plumb.penetration(a, b)
    assert parted.depth == 0.5 and parted.translation.tolist() == [-0.5, 0, 0] and parted.is_unique
    assert plumb.penetration(a, b, exact=True).core_square == Fraction(1, 4)
    assert plumb.penetration(a, Aabb3([5, 5, 5], [6, 6, 6])) is None
    touch = plumb.contact(a, b)
    assert touch.relation == Relation.overlapping and touch.distance == -0.5 and touch.normal.tolist() == [1, 0, 0]
    assert sorted(c.on_a.tolist() for c in touch.corners) == [[2, y, z] for y in (0.25, 2) for z in (0, 2)]
    assert len(plumb.contact(a, b, at_most=2).corners) == 2
    assert plumb.contact(a, [2.25, 1, 1]) is None and plumb.contact(a, [2.25, 1, 1], margin=0.25).distance == 0.25
    exact = plumb.contact(a, b, exact=True)
    assert exact.direction == (1, 0, 0) and exact.along == Fraction(-1, 2)


def test_rigid_poses_keep_lengths():
    turn = [0.1, 0.2, 0.3, 0.4]
    ball = Sphere3([1, 2, 3], 0.5).posed(turn=turn, translation=[1, 1, 1])
    w, x, y, z = fractions([turn])[0]
    s = w * w + x * x + y * y + z * z
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]]
    center = [dot(r, [1, 2, 3]) / s + 1 for r in rows]
    exact = plumb.distance(ball, [7, 7, 7], exact=True)
    off = [7 - c for c in center]
    assert exact == (dot(off, off), Fraction(1, 2))


def test_places_of_points():
    grid = np.array([[x, y, z] for x in range(-1, 4) for y in range(-1, 4) for z in range(-1, 4)], float)
    box = Aabb3([0, 0, 0], [2, 2, 2])
    where = plumb.locate(box, grid)
    strictly, closed = ((grid > 0) & (grid < 2)).all(axis=1), ((grid >= 0) & (grid <= 2)).all(axis=1)
    assert where.dtype == np.int8 and np.array_equal(where, closed.astype(int) + strictly - 1)
    assert np.array_equal(plumb.contains(box, grid), closed)
    assert plumb.locate(box, [2, 1, 1]) == plumb.Location.boundary and plumb.contains(box, [2, 1, 1])
    assert plumb.contains(box, Sphere3([1, 1, 1], 1)) and not plumb.contains(box, Sphere3([1, 1, 1], 1.5))
    assert plumb.locate(FIGURES[8], [[1.2, 1.2], [0.5, 0.5], [1, 1]]).tolist() == [-1, 1, 0]
    assert plumb.support_point(FIGURES[5], [1, 0]).point.tolist() == [2, 0]
    assert plumb.support_value(Sphere3([0, 0, 0], 2), [3, 0, 4]) == 10
    assert plumb.fit_aabb(FIGURES[8]) == Aabb2([0, 0], [6, 6]) and plumb.fit_aabb(Sphere3([1, 2, 3], 1)) == Aabb3([0, 1, 2], [2, 3, 4])
