"""Are pieces, boundaries, welded vertices, coplanar faces and arrangements those of counting and of fractions?"""

import random
from collections import Counter
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest

import plumb
from test_meshes import CUBE, cube
from test_signs import SEED, cross, sub


def soup(source):
    """Triangles between few points of a lattice: doubled, flat and non-manifold ones among them."""
    n = source.randint(4, 9)
    vertices = [[source.randint(0, 2) for _ in range(3)] for _ in range(n)]
    return plumb.Mesh(vertices, [source.sample(range(n), 3) for _ in range(source.randint(1, 9))])


def edges_of(mesh):
    """The triangles at each edge."""
    found = {}
    for t, face in enumerate(mesh.faces.tolist()):
        for i in range(3):
            found.setdefault(frozenset((face[i], face[(i + 1) % 3])), []).append(t)
    return found


def pieces(count, joined):
    """Numbers of pieces in the order of their first members."""
    of = list(range(count))
    for group in joined:
        for a, b in zip(group, group[1:]):
            old, new = max(of[a], of[b]), min(of[a], of[b])
            of = [new if x == old else x for x in of]
    number = {}
    return [number.setdefault(x, len(number)) for x in of]


def test_components_are_those_of_union():
    source = random.Random(SEED + 10)
    several = 0
    for _ in range(200):
        mesh = soup(source)
        faces, edges = mesh.faces.tolist(), edges_of(mesh)
        at = [[t for t, face in enumerate(faces) if v in face] for v in range(len(mesh.vertices))]
        for over, joined in (("manifold-edges", [u for u in edges.values() if len(u) == 2]), ("edges", edges.values()),
                             ("vertices", at)):
            expected = pieces(len(faces), joined)
            assert plumb.components(mesh, over).tolist() == expected
            several += max(expected) > 0
    assert several > 100
    with pytest.raises(ValueError, match="'manifold-edges', 'edges' or 'vertices'"):
        plumb.components(cube(), "faces")


def test_loops_have_each_boundary_edge_once():
    source = random.Random(SEED + 11)
    seen = Counter()
    for _ in range(200):
        mesh = soup(source)
        walked = Counter()
        for loop in plumb.boundary_loops(mesh):
            v = loop.vertices.tolist()
            walked.update(frozenset(e) for e in (zip(v, v[1:] + v[:1]) if loop.closed else zip(v, v[1:])))
            seen[loop.closed] += 1
        assert walked == Counter(e for e, uses in edges_of(mesh).items() if len(uses) == 1)
    assert seen[True] and seen[False], seen
    assert plumb.boundary_loops(cube()) == []


def test_kinds_of_surfaces():
    sphere = plumb.surface_kinds(cube())
    assert [(k.euler, k.genus, k.loops, k.orientable) for k in sphere] == [(2, 0, 0, True)]
    n = 12  # a square torus of n * n cells, a strip of it, and the strip with its ends turned over
    at = lambda i, j: (i % n) * n + j % n
    faces = [f for i in range(n) for j in range(n)
             for f in ((at(i, j), at(i + 1, j), at(i, j + 1)), (at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))]
    points = [[i, j, (7 * i + 3 * j) % 5] for i in range(n) for j in range(n)]
    assert [(k.euler, k.genus, k.loops) for k in plumb.surface_kinds(plumb.Mesh(points, faces))] == [(0, 1, 0)]
    band = [(i, i + 1, i + 7) for i in range(6)] + [(i + 1, i + 8, i + 7) for i in range(6)]
    for turned, kind in ((False, (0, 0, 2, True)), (True, (0, 1, 1, False))):
        ends = {6: 7, 13: 0} if turned else {6: 0, 13: 7}
        faces = [[ends.get(v, v) for v in f] for f in band]
        found = plumb.surface_kinds(plumb.Mesh([[i % 7, i // 7, i * i % 5] for i in range(14)], faces))
        assert [(k.euler, k.genus, k.loops, k.orientable) for k in found] == [kind]


def square_distance(a, b):
    return sum((Fraction(x) - Fraction(y)) ** 2 for x, y in zip(a, b))


def test_welded_vertices_are_near_enough():
    source = random.Random(SEED + 12)
    moved = 0
    for _ in range(100):
        n = 12
        points = [[source.randint(0, 6) / 8 for _ in range(3)] for _ in range(n)]
        mesh = plumb.Mesh(points, [source.sample(range(n), 3) for _ in range(6)])
        chains = plumb.weld(mesh, 0.25, rule="chains", turned_over="kept")
        near = [[a, b] for a, b in combinations(range(n), 2)
                if square_distance(points[a], points[b]) <= Fraction(1, 16)]
        assert pieces(n, near) == pieces(n, [[v, int(to)] for v, to in enumerate(chains.into)])
        clusters = plumb.weld(mesh, 0.25, turned_over="kept").into.tolist()
        for a, b in combinations(range(n), 2):
            if clusters[a] == clusters[b]:
                assert square_distance(points[a], points[b]) <= Fraction(1, 16)
        for m in chains.merged:
            assert chains.into[m.vertex] == m.into != m.vertex
            assert m.distance == pytest.approx(float(square_distance(points[m.vertex], points[m.into])) ** 0.5)
        faces = [[int(chains.into[v]) for v in f] for f in mesh.faces]
        kept = [f for f in faces if len(set(f)) == 3]
        assert chains.mesh.faces.tolist() == kept and len(chains.collapsed) == len(faces) - len(kept)
        moved += len(chains.merged)
        exact = plumb.weld(mesh).into.tolist()
        assert exact == [points.index(p) for p in points]
    assert moved > 300
    for wrong in (-1, float("nan"), float("inf")):
        with pytest.raises(ValueError):
            plumb.weld(cube(), wrong)


def vector_area(points, corners):
    """Twice the vector area of a triangle or ring, in fractions."""
    p = [[Fraction(float(x)) for x in points[int(v)]] for v in corners]
    parts = [cross(sub(b, p[0]), sub(c, p[0])) for b, c in zip(p[1:], p[2:])]
    return [sum(column) for column in zip(*parts)]


def test_coplanar_faces_have_the_areas_of_their_triangles():
    source = random.Random(SEED + 13)
    found = plumb.merge_coplanar(cube())
    assert [len(f.rings[0]) for f in found.faces] == [4] * 6 and len(found.mesh.faces) == len(CUBE[1])
    fewer = 0
    for _ in range(100):
        # a sheet of 3 by 3 cells of few heights, parts of it flat
        heights = [[source.randint(0, 1) if source.random() < 0.2 else 0 for _ in range(4)] for _ in range(4)]
        points = [[i, j, heights[i][j]] for i in range(4) for j in range(4)]
        faces = [f for i in range(3) for j in range(3)
                 for f in ((4 * i + j, 4 * i + j + 4, 4 * i + j + 1), (4 * i + j + 4, 4 * i + j + 5, 4 * i + j + 1))]
        mesh = plumb.Mesh(points, faces)
        merged = plumb.merge_coplanar(mesh, collinear="dropped")
        assert sorted(t for f in merged.faces for t in f.triangles) == list(range(len(faces)))
        for f in merged.faces:
            whole = [sum(c) for c in zip(*(vector_area(points, faces[t]) for t in f.triangles))]
            assert [sum(c) for c in zip(*(vector_area(points, ring) for ring in f.rings))] == whole
            assert cross(whole, vector_area(points, faces[f.plane])) == [0, 0, 0]
        areas = [[sum(c) for c in zip(*(vector_area(points, t) for t in m))] for m in (faces, merged.mesh.faces)]
        assert areas[0] == areas[1]
        fewer += len(merged.mesh.faces) < len(faces)
    assert fewer > 80


def orient(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def common_points(s, t):
    """Ends of what two segments have in common, in fractions."""
    a, b, c, d = (tuple(map(Fraction, p)) for p in (s[:2], s[2:], t[:2], t[2:]))
    on = lambda p, q, r: orient(p, q, r) == 0 and min(p, q) <= r <= max(p, q)
    found = {p for p in (c, d) if on(a, b, p)} | {p for p in (a, b) if on(c, d, p)}
    if orient(a, b, c) * orient(a, b, d) < 0 and orient(c, d, a) * orient(c, d, b) < 0:
        u = orient(c, d, a) / (orient(c, d, a) - orient(c, d, b))
        found.add(tuple(p + u * (q - p) for p, q in zip(a, b)))
    return found


def test_arrangements_have_the_points_that_segments_share():
    source = random.Random(SEED + 14)
    crossings = wound = 0
    for trial in range(120):
        corner = lambda: [source.randint(0, 6) for _ in range(2)]
        if trial % 2:
            path = [corner() for _ in range(6)]
            segments = [a + b for a, b in zip(path, path[1:] + path[:1])]
        else:
            segments = [corner() + corner() for _ in range(6)]
        made = plumb.arrange_segments(segments, exact=True)
        ends = {tuple(map(Fraction, p)) for s in segments for p in (s[:2], s[2:])}
        expected = ends.union(*(common_points(s, t) for s, t in combinations(segments, 2)))
        assert [tuple(v) for v in made.vertices] == sorted(expected)
        assert [[tuple(made.vertices[v]) for v in e] for e in made.ends] == [
            [tuple(s[:2]), tuple(s[2:])] for s in segments]
        connected = max(pieces(len(expected), made.edges.tolist())) + 1
        assert len(expected) - len(made.edges) + made.faces == 1 + connected
        crossings += len(expected) > len(ends)
        rounded = plumb.arrange_segments(segments)
        assert rounded.vertices.tolist() == [[float(x) for x in v] for v in made.vertices]
        if not trial % 2:
            continue
        wound += 1
        for t, face in zip(made.triangles, made.face_of):
            middle = [sum(made.vertices[v][k] for v in t) / 3 for k in (0, 1)]
            turns = 0
            for s in segments:
                side = orient(s[:2], s[2:], middle)
                turns += (s[1] <= middle[1] < s[3] and side > 0) - (s[3] <= middle[1] < s[1] and side < 0)
            assert made.windings[face] == turns
    assert crossings > 80 and wound == 60
    with pytest.raises(ValueError, match=r"arrange_segments: segments has shape \(1, 3\)"):
        plumb.arrange_segments([[0, 0, 1]])
    assert plumb.arrange_segments(np.empty((0, 4))).faces == 1


def test_centers_of_circles_are_as_far_from_three_points_as_from_no_other():
    source = random.Random(SEED + 15)
    circles = 0
    for _ in range(60):
        points = [[source.randint(0, 5) for _ in range(2)] for _ in range(9)]
        made = plumb.voronoi(points, exact=True)
        for center, triangle in zip(made.vertices, made.simplices):
            far = [square_distance(center, p) for p in points]
            assert {far[v] for v in triangle} == {min(far)}
            circles += 1
        assert plumb.voronoi(points).vertices.tolist() == [[float(x) for x in c] for c in made.vertices]
        assert made.neighbors.tolist() == plumb.delaunay(points).neighbors.tolist()
    assert circles > 300
