"""Exact chains of solids, curves where surfaces meet, and terrains: as fractions and loops of their own count them."""

import pickle
import random
from fractions import Fraction

import numpy as np
import pytest

import plumb
from test_meshes import cube
from test_signs import SEED, cross, sub


def volume(vertices, faces):
    """Of corners in fractions."""
    return sum((sum(x * y for x, y in zip(vertices[a], cross(vertices[b], vertices[c]))) for a, b, c in faces), Fraction(0)) / 6


def turned(point, turn):
    """The image under a quaternion of integers, by the textbook's matrix over its norm."""
    w, x, y, z = (Fraction(n) for n in turn)
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]]
    return tuple(sum(r * Fraction(p) for r, p in zip(row, point)) / (w * w + x * x + y * y + z * z) for row in rows)


def test_an_exact_mesh_is_the_image_itself():
    turn = (2, 1, 0, 1)
    exact = plumb.ExactMesh(cube(), turn=turn, translation=[0.5, 0, 0])
    expected = sorted((x + Fraction(1, 2), y, z) for x, y, z in (turned(p, turn) for p in cube().vertices.tolist()))
    assert exact.exact_vertices() == expected and any(y.denominator == 3 for x, y, z in expected)
    assert exact.volume == 8 == volume(exact.exact_vertices(), exact.faces.tolist())
    assert exact.vertices.tolist() == [[float(x) for x in p] for p in expected]
    back = plumb.ExactMesh(plumb.ExactMesh(exact, translation=[-0.5, 0, 0]), turn=(2, -1, 0, -1))
    assert back == plumb.ExactMesh(cube()) and back != exact
    flat = plumb.ExactMesh(cube(), pose=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0.5, 1], [0, 0, 0, 1]])
    assert flat.volume == 4 and repr(flat) == "ExactMesh(8 vertices, 12 faces)"
    mirrored = plumb.ExactMesh(cube(), pose=np.diag([-1.0, 1, 1, 1]))
    assert mirrored.volume == 8


@pytest.mark.parametrize("seed", range(8))
def test_chains_keep_their_volumes(seed):
    source = random.Random(SEED + seed)
    chain, total = plumb.ExactMesh(cube()), None
    for _ in range(4):
        turn = [source.randint(-2, 2) for _ in range(4)]
        if not any(turn):
            turn[0] = 1
        tool = plumb.ExactMesh(cube([source.randint(-2, 1) for _ in range(3)]), turn=turn)
        made = {name: getattr(plumb, name)(chain, tool, exact=True) for name in ("unite", "intersect", "subtract")}
        for solid in made.values():
            assert solid.volume == volume(solid.exact_vertices(), solid.faces.tolist())
            assert solid.sources.shape == solid.faces.shape[:1] + (2,) and (solid.sources[:, 0] < 2).all()
        assert made["unite"].volume + made["intersect"].volume == chain.volume + tool.volume
        assert made["subtract"].volume + made["intersect"].volume == chain.volume
        other = plumb.symmetric_difference(chain, tool, exact=True)
        assert other.volume == made["unite"].volume - made["intersect"].volume
        merged = plumb.unite(chain, tool, merge=True, exact=True)
        assert merged.volume == made["unite"].volume and len(merged.faces) <= len(made["unite"].faces)
        chain, total = made["unite"], merged
    assert plumb.resolve(total, exact=True).volume == chain.volume
    above, below = plumb.split(chain, plumb.Plane3([1, 2, 3], 0.25), exact=True)
    assert above.volume + below.volume == chain.volume
    for half, side in ((above, 1), (below, -1)):
        assert all(side * (x + 2 * y + 3 * z - Fraction(1, 4)) >= 0 for x, y, z in half.exact_vertices())
    told = chain.round()
    assert told.sound and told.moved < 1e-14 and plumb.check(told.mesh)["closed"]
    again = pickle.loads(pickle.dumps(chain))
    assert again == chain and (again.sources == chain.sources).all() and again.exact_vertices() == chain.exact_vertices()


def test_a_mesh_and_an_exact_one_go_together():
    a, b = cube(), cube((1, 1, 1))
    exact = plumb.unite(a, plumb.ExactMesh(b), exact=True)
    assert exact == plumb.unite(a, b, exact=True) and exact.volume == 15
    rounded = plumb.unite(plumb.ExactMesh(a), b)
    assert rounded.mesh == plumb.unite(a, b).mesh and rounded.moved == 0
    assert plumb.evaluate(("subtract", a, b), exact=True).volume == 7
    for wrong, text in ((lambda: plumb.unite(plumb.ExactMesh(a), 3), "unite"), (lambda: plumb.ExactMesh(3), "ExactMesh"),
                        (lambda: plumb.resolve(3), "resolve"), (lambda: plumb.split(3, plumb.Plane3([0, 0, 1], 0)), "split")):
        with pytest.raises(TypeError, match=text):
            wrong()
    with pytest.raises(ValueError, match="turn"):
        plumb.ExactMesh(a, turn=[0, 0, 0, 0])
    with pytest.raises(ValueError, match="pickled"):
        plumb.ExactMesh.__new__(plumb.ExactMesh).__setstate__(([(0.0, 0.0, 0.0)], [[0, 0, 1]], [[0, 0]]))
    with pytest.raises(ValueError, match="edge"):
        plumb.unite(plumb.ExactMesh(plumb.Mesh(a.vertices, a.faces[1:])), b)


def on_triangle(p, corners):
    """By areas of fractions: is a point in a triangle that has an area, boundary included?"""
    a, b, c = ([Fraction(x) for x in corner] for corner in corners)
    normal = cross(sub(b, a), sub(c, a))

    def dot(u, v):
        return sum(x * y for x, y in zip(u, v))

    if dot(normal, sub(p, a)) != 0:
        return False
    return all(dot(normal, cross(sub(v, u), sub(p, u))) >= 0 for u, v in ((a, b), (b, c), (c, a)))


def test_curves_lie_in_the_faces_that_they_name():
    source = random.Random(SEED)
    edges = 0
    for _ in range(60):
        a, b = cube(), cube([source.randint(-2, 2) for _ in range(3)])
        if source.random() < 0.5:
            b = plumb.Mesh(b.vertices @ np.array([[1, 0, 1], [-1, 1, 0], [0, -1, 1]]) + 0.5, b.faces)
        told, rounded = plumb.intersection_curves(a, b, exact=True), plumb.intersection_curves(a, b)
        assert bool(told) == any(len(x) for x in plumb.Bvh(a).intersections(plumb.Bvh(b))[:1])
        for curve, near in zip(told, rounded, strict=True):
            n = len(curve.points)
            assert near.points.tolist() == [[float(x) for x in p] for p in curve.points]
            assert curve.closed == near.closed and (curve.faces == near.faces).all()
            ends = [(i, (i + 1) % n) for i in range(n if curve.closed else n - 1)] or [(0, 0)]
            assert len(curve.faces) == len(ends)
            for (i, j), (f, g) in zip(ends, curve.faces.tolist()):
                for p in (curve.points[i], curve.points[j]):
                    assert on_triangle(p, a.vertices[a.faces[f]].tolist()) and on_triangle(p, b.vertices[b.faces[g]].tolist())
                edges += 1
    assert edges > 200
    corner, = plumb.intersection_curves(cube(), cube((2, 2, 2)))
    assert corner.points.tolist() == [[2, 2, 2]] and not corner.closed and corner.faces.shape == (1, 2)
    assert plumb.intersection_curves(cube(), cube((3, 3, 3))) == []


def test_a_terrain_is_its_cells():
    source = random.Random(SEED)
    heights = np.array([[source.randint(0, 5) for _ in range(4)] for _ in range(3)], float)
    land = plumb.Heightfield(heights, spacing=(0.5, 2), origin=(-1, 0, 10))
    mesh = land.mesh()
    assert mesh.vertices.reshape(3, 4, 3).tolist() == [
        [[-1 + 0.5 * i, 2.0 * j, 10 + heights[j, i]] for i in range(4)] for j in range(3)]
    assert len(mesh.faces) == 2 * 3 * 2
    for face, corners in enumerate(mesh.faces.tolist()):
        row, column = land.cell_of(face)
        assert {divmod(v, 4) for v in corners} <= {(row + r, column + c) for r in (0, 1) for c in (0, 1)}
    assert (land.heights == heights).all() and (land.spacing, land.origin) == ((0.5, 2.0), (-1.0, 0.0, 10.0))
    again = pickle.loads(pickle.dumps(land))
    assert again.mesh() == mesh and repr(again) == "Heightfield(3 rows, 4 columns)"
    with pytest.raises(ValueError):
        land.heights[0, 0] = 1
    world = plumb.CollisionWorld()
    world.add(mesh)
    hit = world.first_hit(plumb.Ray3([-0.625, 3.5, 99], [0, 0, -1]))
    assert land.cell_of(hit.part[1]) == (1, 0)
    for wrong, text in ((lambda: plumb.Heightfield([[1, 2]]), "rows"), (lambda: plumb.Heightfield([1, 2]), "shape"),
                        (lambda: plumb.Heightfield([[1, 2], [3, np.nan]]), "heights"),
                        (lambda: plumb.Heightfield(heights, spacing=(0, 1)), "spacing"), (lambda: land.cell_of(12), "no triangle")):
        with pytest.raises(ValueError, match=text):
            wrong()
