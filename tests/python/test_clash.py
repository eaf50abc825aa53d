"""Clashes: the words of parts that are known, and what poses, names and rules say."""

import itertools

import numpy as np
import pytest

import plumb


def box(low, high):
    corners = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    faces = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6),
             (0, 6, 2), (1, 3, 7), (1, 7, 5)]
    return plumb.Mesh(np.array(corners, float), np.array(faces, np.int32))


CUBE = box([0, 0, 0], [4, 4, 4])


def told(clashes):
    return [(c.a, c.b, c.word) for c in clashes]


@pytest.mark.parametrize("other, word", [
    (box([4, 0, 0], [6, 4, 4]), "touching"), (box([3, 3, 3], [6, 6, 6]), "overlapping"),
    (box([1, 1, -1], [2, 2, 5]), "piercing through"), (box([1, 1, 1], [2, 2, 2]), "enclosed"), (CUBE, "duplicate"),
    (box([5, 0, 0], [6, 4, 4]), None)])
def test_words_of_known_parts(other, word):
    for parts in ([CUBE, other], [other, CUBE]):
        assert [c.word for c in plumb.clash(parts)] == ([word] if word else [])


def test_numbers_are_told():
    (c,) = plumb.clash({"case": CUBE, "core": box([3, 2, 1], [6, 6, 6])})
    assert (c.a, c.b, c.volume, c.depth, c.inner, c.distance) == ("case", "core", 6.0, (1.0, 1.0), None, None)
    assert c.direction.tolist() == [-1, 0, 0] and c.meeting.shape[1] == 2 and len(c.meeting) > 0
    assert c.meeting.dtype == np.int32 and c.place.shape == (3,)
    (c,) = plumb.clash([CUBE, box([1, 1, 1], [2, 2, 2])])
    assert (c.word, c.inner, c.volume) == ("enclosed", 1, 1.0)
    (c,) = plumb.clash([CUBE, box([3, 2, 1], [6, 6, 6])], measure=False)
    assert (c.word, c.volume, c.depth, c.direction) == ("overlapping", None, None, None)


def test_poses_place_the_same_mesh():
    brick = box([0, 0, 0], [2, 1, 1])
    quarter, turned = (1, 0, 0, 1), np.array([[0, -1, 0, 2], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], float)
    parts = {"a": brick, "b": (brick, (1, 0, 0, 0), [2, 0, 0]), "c": (brick, quarter, [1, 1, 0]), "d": (brick, turned)}
    meshes = {"a": brick, "b": box([2, 0, 0], [4, 1, 1]), "c": box([0, 1, 0], [1, 3, 1]), "d": box([1, 0, 0], [2, 2, 1])}
    assert told(plumb.clash(parts)) == told(plumb.clash(meshes))
    assert ("a", "d", "overlapping") in told(plumb.clash(parts)) and ("a", "b", "touching") in told(plumb.clash(parts))


def test_rules_are_asked_by_name():
    row = {f"p{i}": box([1.25 * i, 0, 0], [1.25 * i + 1, 1, 1]) for i in range(4)}
    assert plumb.clash(row) == []
    near = [("p0", "p1"), ("p1", "p2"), ("p2", "p3")]
    assert told(plumb.clash(row, clearance=0.25)) == [(a, b, "within clearance") for a, b in near]
    assert [c.distance for c in plumb.clash(row, clearance=0.25)] == [0.25] * 3
    assert plumb.clash(row, clearance=np.nextafter(0.25, 0)) == []
    seen = []

    def rule(a, b):
        seen.append((a, b))
        return {("p0", "p1"): False, ("p1", "p2"): 0.125, ("p0", "p2"): 1.5}.get((a, b))

    assert told(plumb.clash(row, clearance=0.25, rule=rule)) == [
        ("p0", "p2", "within clearance"), ("p2", "p3", "within clearance")]
    assert sorted(seen) == sorted(itertools.combinations(row, 2))


def test_what_is_wrong_is_named():
    for parts in ([CUBE, 3], [(CUBE,)], [(CUBE, 1, 2, 3)], {"a": "b"}, 7):
        with pytest.raises(TypeError):
            plumb.clash(parts)
    for clearance in (-1, float("nan")):
        with pytest.raises(ValueError, match="clearance"):
            plumb.clash([CUBE], clearance=clearance)
    with pytest.raises(ValueError, match="clash"):
        plumb.clash([(CUBE, (0, 0, 0, 0), [0, 0, 0])])
    with pytest.raises(ZeroDivisionError):
        plumb.clash([CUBE, CUBE], rule=lambda a, b: 1 / 0)
    assert plumb.clash([]) == [] and plumb.clash([CUBE]) == []
