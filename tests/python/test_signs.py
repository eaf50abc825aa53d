"""Are the signs of arrays those of C++, of the test vectors, and of fractions?"""

import itertools
import math
import random
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import plumb

VECTORS = Path(__file__).resolve().parents[2] / "docs" / "vectors"
SEED = 20261129


def cases(task):
    """The numbers and the answers of the file of a task."""
    numbers, answers = [], []
    for line in (VECTORS / f"{task}.txt").read_text().splitlines():
        if line.startswith(task + " "):
            asked, answered = line.split("=", 1)
            numbers.append([float.fromhex(word) for word in asked.split()[1:]])
            answers.append(answered.split()[0])
    assert len(numbers) > 50
    return np.array(numbers), answers


@pytest.mark.parametrize("task, dimension", [("orient2d", 2), ("orient3d", 3), ("incircle", 2), ("insphere", 3)])
def test_are_those_of_the_vectors(task, dimension):
    numbers, answers = cases(task)
    points = numbers.reshape(len(numbers), -1, dimension)
    expected = [{"+": 1, "0": 0, "-": -1}[a] for a in answers]
    assert {-1, 0, 1} == set(expected)
    function = getattr(plumb, task)
    arguments = [points[:, i] for i in range(points.shape[1])]
    assert function(*arguments).tolist() == expected
    assert function(*[np.ascontiguousarray(a) for a in arguments]).tolist() == expected
    assert [int(function(*row)) for row in points] == expected


# The functions, by fractions: what each means, stated again.

def sign(x):
    return (x > 0) - (x < 0)


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def square(a):
    return dot(a, a)


def det(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** j * rows[0][j] * det([r[:j] + r[j + 1:] for r in rows[1:]]) for j in range(len(rows)))


def lifted(points, last):
    rows = [sub(p, last) for p in points]
    return det([r + [square(r)] for r in rows])


def to_line(a, b, p):
    d = sub(b, a)
    if square(d) == 0:
        return square(sub(p, a))
    return square(sub(p, a)) - dot(d, sub(p, a)) ** 2 / square(d)


def to_segment(a, b, p):
    d = sub(b, a)
    if dot(d, sub(p, a)) <= 0:
        return square(sub(p, a))
    return square(sub(p, b)) if dot(d, sub(p, b)) >= 0 else to_line(a, b, p)


def to_plane(a, b, c, p):
    n = cross(sub(b, a), sub(c, a))
    if square(n) == 0:  # the line through them, by the two that are farthest apart
        return to_line(*max(itertools.combinations((a, b, c), 2), key=lambda e: square(sub(*e))), p)
    return dot(n, sub(p, a)) ** 2 / square(n)


def against(squared, distance):
    return 1 if distance < 0 else sign(squared - distance ** 2)


def rank_is_one(a, b, c):
    u, v = sub(b, a), sub(c, a)
    return all(u[i] * v[j] == u[j] * v[i] for i, j in itertools.combinations(range(len(a)), 2))


def signed_line(a, b, p):
    return det([sub(b, a), sub(p, a)])


def signed_plane(a, b, c, p):
    return dot(cross(sub(b, a), sub(c, a)), sub(p, a))


def power(p, w):
    return square(sub(p, w[:-1])) - w[-1]


def powered(points, last):
    rows = [sub(p[:-1], last[:-1]) for p in points]
    return det([r + [square(r) - p[-1] + last[-1]] for r, p in zip(rows, points)])


def coplanar_turn(a, b, c):
    for i, j in ((0, 1), (1, 2), (0, 2)):
        s = sign(det([[b[i] - a[i], b[j] - a[j]], [c[i] - a[i], c[j] - a[j]]]))
        if s:
            return s
    return 0


def in_smallest(a, b, *rest):
    p = rest[-1]
    if len(rest) == 1:
        return sign(-dot(sub(a, p), sub(b, p)))
    c = rest[0]
    if rank_is_one(a, b, c):  # two that are equal count once; of three that differ there is no sphere
        return in_smallest(a, c, p) if a == b or b == c else in_smallest(a, b, p) if a == c else 0
    if len(a) == 2:
        return sign(lifted([a, b, c], p)) * sign(signed_line(a, b, c))
    u, v, w = sub(b, a), sub(c, a), sub(p, a)
    n = cross(u, v)  # the center of the circle, from a: (|u|^2 v - |v|^2 u) x n / 2 n.n
    center = cross(sub([square(u) * x for x in v], [square(v) * x for x in u]), n)
    return sign(dot(center, w) - square(w) * square(n))


def points(dimension, count):
    return [dimension] * count


TRUTH = {
    "orient2d": [(points(2, 3), lambda a, b, c: sign(signed_line(a, b, c)))],
    "orient3d": [(points(3, 4), lambda a, b, c, d: -sign(signed_plane(a, b, c, d)))],
    "incircle": [(points(2, 4), lambda a, b, c, d: sign(lifted([a, b, c], d)))],
    "insphere": [(points(3, 5), lambda a, b, c, d, e: sign(lifted([a, b, c, d], e)))],
    "coplanar_orientation": [
        (points(3, 3), coplanar_turn),
        (points(3, 4), lambda a, b, c, d: sign(dot(cross(sub(b, a), sub(c, a)), cross(sub(b, a), sub(d, a)))))],
    "line_edge": [(points(3, 4), lambda o, d, a, b: sign(det([d, sub(a, o), sub(b, o)])) * -1)],
    "dot_of_crosses": [(points(3, 4), lambda a, b, c, d: sign(dot(cross(a, b), cross(c, d))))],
    "order_along_cross": [(points(3, 4), lambda u, v, p, q: sign(dot(cross(u, v), sub(q, p))))],
    "compare_lexicographically": [(points(d, 2), lambda a, b: (a > b) - (a < b)) for d in (2, 3)],
    "compare_along_direction": [(points(d, 3), lambda a, b, v: sign(dot(sub(a, b), v))) for d in (2, 3)],
    "compare_along_line": [(points(d, 4), lambda a, b, c, e: sign(dot(sub(a, b), sub(e, c)))) for d in (2, 3)],
    "are_ordered_along_line": [
        (points(d, 3), lambda a, b, c: rank_is_one(a, b, c) and dot(sub(a, b), sub(c, b)) <= 0) for d in (2, 3)],
    "dot_sign": [(points(d, 2), lambda a, b: sign(dot(a, b))) for d in (2, 3)],
    "angle_sign": [(points(d, 3), lambda a, b, c: sign(dot(sub(a, b), sub(c, b)))) for d in (2, 3)],
    "cross_sign": [(points(2, 2), lambda a, b: sign(det([a, b])))],
    "perpendicular": [(points(d, 2), lambda a, b: dot(a, b) == 0) for d in (2, 3)],
    "parallel": [(points(d, 2), lambda a, b: rank_is_one([0] * len(a), a, b)) for d in (2, 3)],
    "collinear": [(points(d, 3), rank_is_one) for d in (2, 3)],
    "compare_distance": [
        *[(points(d, 4), lambda a, b, c, e: sign(square(sub(a, b)) - square(sub(c, e)))) for d in (2, 3)],
        *[(points(d, 3), lambda a, b, c: sign(square(sub(a, b)) - square(sub(a, c)))) for d in (2, 3)]],
    "compare_distance_to_line": [
        (points(d, 4), lambda a, b, c, e: sign(to_line(a, b, c) - to_line(a, b, e))) for d in (2, 3)],
    "compare_distance_to_lines": [
        (points(d, 6), lambda a, b, c, e, f, g: sign(to_line(a, b, c) - to_line(e, f, g))) for d in (2, 3)],
    "compare_signed_distance_to_line": [
        (points(2, 4), lambda a, b, c, d: sign(signed_line(a, b, c) - signed_line(a, b, d)))],
    "compare_distance_to_segment": [
        (points(d, 4), lambda a, b, c, e: sign(to_segment(a, b, c) - to_segment(a, b, e))) for d in (2, 3)],
    "compare_distance_to_segments": [
        (points(d, 6), lambda a, b, c, e, f, g: sign(to_segment(a, b, c) - to_segment(e, f, g))) for d in (2, 3)],
    "compare_distance_to_plane": [
        (points(3, 5), lambda a, b, c, d, e: sign(to_plane(a, b, c, d) - to_plane(a, b, c, e)))],
    "compare_distance_to_planes": [
        (points(3, 8), lambda a, b, c, d, e, f, g, h: sign(to_plane(a, b, c, d) - to_plane(e, f, g, h)))],
    "compare_signed_distance_to_plane": [
        (points(3, 5), lambda a, b, c, d, e: sign(signed_plane(a, b, c, d) - signed_plane(a, b, c, e)))],
    "side_of_line": [([2, 0, 2], lambda n, w, p: sign(dot(n, p) - w))],
    "side_of_plane": [([3, 0, 3], lambda n, w, p: sign(dot(n, p) - w))],
    "in_smallest_circle": [(points(2, n), in_smallest) for n in (4, 3)],
    "in_smallest_sphere": [(points(3, n), in_smallest) for n in (4, 3)],
    "in_power_circle": [(points(3, 4), lambda a, b, c, d: sign(powered([a, b, c], d)))],
    "in_power_sphere": [(points(4, 5), lambda a, b, c, d, e: sign(powered([a, b, c, d], e)))],
    "compare_power": [(s, lambda p, a, b: sign(power(p, a) - power(p, b))) for s in ([2, 3, 3], [3, 4, 4])],
    "power_sign": [
        *[(s, lambda p, a: sign(power(p, a))) for s in ([2, 3], [3, 4])],
        *[(s, lambda a, b: sign(square(sub(a[:-1], b[:-1])) - a[-1] - b[-1])) for s in ([3, 3], [4, 4])]],
    "determinant_sign": [([(n, n)], lambda rows: sign(det(rows))) for n in (2, 3, 4, 5)],
}
# Those whose forms are told apart by names alone.
NAMED = {
    ("compare_distance", ("a", "b", "distance")): ([3, 3, 0], lambda a, b, w: against(square(sub(a, b)), w)),
    ("compare_distance_to_line", ("a", "b", "c", "distance")): (
        [3, 3, 3, 0], lambda a, b, c, w: against(to_line(a, b, c), w)),
    ("compare_distance_to_segment", ("a", "b", "c", "distance")): (
        [2, 2, 2, 0], lambda a, b, c, w: against(to_segment(a, b, c), w)),
    ("compare_distance_to_plane", ("a", "b", "c", "d", "distance")): (
        [3, 3, 3, 3, 0], lambda a, b, c, d, w: against(to_plane(a, b, c, d), w)),
    ("orient_seen_from", ("direction", "a", "b", "c")): (
        [3, 3, 3, 3], lambda v, a, b, c: sign(dot(v, cross(sub(b, a), sub(c, a))))),
}


def number(source, hard):
    """A small integer, so that what is degenerate is as frequent as not; a hard one off by an ulp, or of another size."""
    x = float(source.randint(-1, 1))
    kind = source.random() if hard else 1
    return math.nextafter(x, math.inf) if kind < 0.3 else x * 2.0 ** source.choice([-500, -60, 60]) if kind < 0.5 else x


def drawn(source, shape, count):
    axes = (shape,) if isinstance(shape, int) and shape else shape or ()
    size = math.prod(axes)
    rows = [source.random() < 0.1 for _ in range(count)]
    return np.array([[number(source, hard) for _ in range(size)] for hard in rows]).reshape((count, *axes))


def exact(argument):
    return Fraction(argument) if np.ndim(argument) == 0 else [exact(x) for x in argument]


def check(function, given, truth):
    arrays = list(given.values()) if isinstance(given, dict) else given
    expected = [truth(*[exact(a[i]) for a in arrays]) for i in range(len(arrays[0]))]
    answer = function(**given) if isinstance(given, dict) else function(*given)
    assert answer.dtype == (bool if isinstance(expected[0], bool) else np.int8)
    for i, (is_so, is_true) in enumerate(zip(answer.tolist(), expected)):
        assert is_so == is_true, f"seed {SEED}, case {i}: {[a[i].tolist() for a in arrays]}"
    assert len(set(expected)) > 1 and 0 in expected  # degenerate ones among them


@pytest.mark.parametrize("name", sorted(TRUTH))
def test_are_those_of_fractions(name):
    source = random.Random(f"{SEED} {name}")
    for shapes, truth in TRUTH[name]:
        check(getattr(plumb, name), [drawn(source, s, 300) for s in shapes], truth)


@pytest.mark.parametrize("name, names", sorted(NAMED))
def test_are_those_of_fractions_by_name(name, names):
    source = random.Random(f"{SEED} {name} {names}")
    shapes, truth = NAMED[name, names]
    check(getattr(plumb, name), {n: drawn(source, s, 300) for n, s in zip(names, shapes)}, truth)


def test_radicals():
    assert plumb.sign_of_radicals(-5, 1, 9, 1, 4) == 0
    assert plumb.sign_of_radicals(0, 1, 8, -2, 2) == 0
    assert plumb.sign_of_radicals([-3, -3, -3], 1, [8, 9, 10]).tolist() == [-1, 0, 1]
    with pytest.raises(ValueError, match="negative"):
        plumb.sign_of_radicals(0, 1, -1)


def test_every_sign_is_tested():
    signs = {n for n in plumb.__all__ if getattr(getattr(plumb, n), "__doc__", "").startswith("") and n.islower()
             and "Exact for every finite double." in getattr(plumb, n).__doc__}
    assert signs == set(TRUTH) | {name for name, _ in NAMED} | {"sign_of_radicals"}


# Broadcasting, as NumPy has it.

def by_hand(function, *arguments, own):
    shape = np.broadcast_shapes(*[a.shape[: a.ndim - o] for a, o in zip(arguments, own)])
    spread = [np.broadcast_to(a, shape + a.shape[a.ndim - o:]) for a, o in zip(arguments, own)]
    out = np.empty(shape, np.int8)
    for at in np.ndindex(*shape):
        out[at] = function(*[np.ascontiguousarray(a[at]) for a in spread])
    return out


SHAPES = [[(), (), ()], [(4,), (), (1,)], [(3, 1), (1, 4), (4,)], [(2, 1, 3), (5, 1), ()], [(0,), (1,), ()],
          [(2, 300), (300,), (2, 1)], [(300, 2), (2,), (300, 1)]]


@pytest.mark.parametrize("shapes", SHAPES)
def test_broadcast(shapes):
    source = np.random.default_rng(SEED)
    arguments = [source.integers(-2, 3, (*s, 2)).astype(float) for s in shapes]
    answer = plumb.orient2d(*arguments)
    expected = by_hand(plumb.orient2d, *arguments, own=[1, 1, 1])
    assert np.shape(answer) == expected.shape and np.array_equal(answer, expected)
    distances = source.integers(0, 4, shapes[2]).astype(float)
    answer = plumb.compare_distance(arguments[0], arguments[1], distance=distances)
    expected = by_hand(lambda a, b, d: plumb.compare_distance(a, b, distance=d), arguments[0], arguments[1],
                       distances, own=[1, 1, 0])
    assert np.array_equal(answer, expected)


def test_any_layout():
    source = np.random.default_rng(SEED)
    plain = source.integers(-3, 4, (3, 1000, 2)).astype(float)
    expected = plumb.orient2d(*plain)
    assert set(expected.tolist()) == {-1, 0, 1}
    layouts = {
        "fortran": [np.asfortranarray(a) for a in plain],
        "reversed": [a[::-1].copy()[::-1] for a in plain],
        "every other": [np.repeat(a, 2, axis=0)[::2] for a in plain],
        "columns of a wider one": [np.hstack([a, a])[:, 1:3][:, ::-1] for a in plain],
        "unaligned": [np.frombuffer(b"x" + a.tobytes(), np.uint8)[1:].view(np.float64).reshape(-1, 2) for a in plain],
        "records": [np.rec.fromarrays([a[:, 0], np.zeros(1000, np.int8), a[:, 1]], names="x,k,y") for a in plain],
        "big-endian": [a.astype(">f8") for a in plain],
        "float32": [a.astype(np.float32) for a in plain],
        "float16": [a.astype(np.float16) for a in plain],
        "int8": [a.astype(np.int8) for a in plain],
        "uint64": [(a + 8).astype(np.uint64) for a in plain],
        "lists": [a.tolist() for a in plain],
    }
    layouts["records"] = [np.stack([r.x, r.y], axis=-1) for r in layouts["records"]]
    for name, arguments in layouts.items():
        assert np.array_equal(plumb.orient2d(*arguments), expected), name
    columns = [np.array([a[:, 0], a[:, 1]]).T for a in plain]
    assert np.array_equal(plumb.orient2d(*columns), expected)


def test_one_item_is_a_number():
    answer = plumb.orient2d([0, 0], [1, 0], [0, 1])
    assert isinstance(answer, np.int8) and answer == 1
    assert plumb.collinear([0, 0], [1, 1], [2, 2]) is np.True_


@pytest.mark.parametrize("call, text", [
    (lambda: plumb.orient3d(np.zeros((5, 2)), *[[0, 0, 0]] * 3), r"orient3d: a has shape \(5, 2\) and dtype float64"),
    (lambda: plumb.orient3d([0, 0, 0], [0, 0, 0], 1.0, [0, 0, 0]), r"c has shape \(\) .* expected shape \(\.\.\., 3\)"),
    (lambda: plumb.orient2d(np.zeros((3, 2)), np.zeros((4, 2)), [0, 0]), r"broadcast together: a \(3, 2\), b \(4, 2\)"),
    (lambda: plumb.orient2d([0, 0], [np.nan, 0], [1, 1]), "orient2d: b.x is nan"),
    (lambda: plumb.orient2d([[0, 0]] * 3, [0, 0], [[1, 1], [1, -np.inf], [2, 2]]), "c.y of row 1 is -inf"),
    (lambda: plumb.collinear([[[0, 0], [np.inf, 0]]] * 2, [0, 0], [1, 1]), r"a.x of row \(0, 1\) is inf"),
    (lambda: plumb.determinant_sign([[1, 2], [np.nan, 4]]), r"rows\[1\]\[0\] is nan"),
    (lambda: plumb.power_sign(a=[1, 2, np.nan], b=[0, 0, 0]), "a.w is nan"),
    (lambda: plumb.compare_distance([0, 0], [1, 1], distance=np.nan), "distance is nan"),
    (lambda: plumb.orient2d([2**53 + 1, 0], [0, 0], [0, 1]), "a holds 9007199254740993; .* nothing is rounded"),
    (lambda: plumb.compare_distance([0, 0], [1, 1], [2, 2, 2]), r"c has shape \(3,\)"),
])
def test_what_is_refused_is_named(call, text):
    with pytest.raises(ValueError, match=text):
        call()


@pytest.mark.parametrize("call, text", [
    (lambda: plumb.orient2d([0, 0], [1, 1]), r"orient2d\(\) takes \(a, b, c\)"),
    (lambda: plumb.orient2d([0, 0], [1, 1], [2, 2], [3, 3]), "takes 3 arguments, but 4 were given"),
    (lambda: plumb.orient2d([0, 0], [1, 1], d=[2, 2]), "no argument 'd'"),
    (lambda: plumb.orient2d([0, 0], [1, 1], a=[2, 2]), "'a' twice"),
    (lambda: plumb.orient2d(["0", "1"], [0, 0], [1, 1]), "a has shape .* dtype <U1"),
    (lambda: plumb.orient2d([1j, 0], [0, 0], [1, 1]), "dtype complex128"),
    (lambda: plumb.orient2d([Fraction(1, 3), 0], [0, 0], [1, 1]), "dtype object"),
    (lambda: plumb.orient2d(np.zeros(2, np.longdouble), [0, 0], [1, 1]), "dtype float128"),
    (lambda: plumb.orient2d(np.zeros(2, bool), [0, 0], [1, 1]), "dtype bool"),
])
def test_what_is_no_number_is_a_type_error(call, text):
    with pytest.raises(TypeError, match=text):
        call()


def test_nothing_is_rounded():
    third = np.float32(1 / 3)
    assert plumb.orient2d([0, 0], np.array([1, third], np.float32), [3, 3 * float(third)]) == 0
    assert plumb.orient2d([0, 0], np.array([1, third], np.float32), [3, 1.0]) == -1


def test_threads_change_nothing():
    source = np.random.default_rng(SEED)
    a, b, c, d = source.integers(-4, 5, (4, 100_000, 3)).astype(float)
    expected = plumb.orient3d(a, b, c, d)
    line = plumb.compare_distance_to_line(a, b, c, d)
    with plumb.ThreadLimit(1) as threads:
        assert threads == 1
        assert np.array_equal(plumb.orient3d(a, b, c, d), expected)
        assert np.array_equal(plumb.compare_distance_to_line(a, b, c, d), line)


def test_no_memory_is_kept():
    import tracemalloc

    a, b, c = np.random.default_rng(SEED).random((3, 100, 2))
    plumb.orient2d(a, b, c)
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    for _ in range(2000):
        plumb.orient2d(a, b, c)
        plumb.orient2d(a[:, None], b[None], c[::-1])
    assert tracemalloc.get_traced_memory()[0] - before < 20_000
    tracemalloc.stop()
