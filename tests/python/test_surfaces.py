"""Are reports on meshes, what mends them and sections those of counts and fractions?"""

import json
import pickle
import math
import random
from collections import Counter
from fractions import Fraction

import numpy as np
import pytest

import plumb
from test_meshes import CUBE, cube, meet
from test_signs import SEED, cross, sub


def counted(mesh):
    """By hand: open edges, edges of more than two triangles, repeated vertices, triangles of no area, pairs that meet."""
    faces = mesh.faces.tolist()
    edges = Counter(frozenset((f[i], f[(i + 1) % 3])) for f in faces for i in range(3) if f[i] != f[(i + 1) % 3])
    corners = [[list(map(Fraction, mesh.vertices[v].tolist())) for v in f] for f in faces]
    flat = [not any(cross(sub(b, a), sub(c, a))) for a, b, c in corners]
    places = Counter(tuple(p) for p in mesh.vertices.tolist())
    return {"open_edges": sum(n == 1 for n in edges.values()), "non_manifold_edges": sum(n > 2 for n in edges.values()),
            "degenerate_triangles": sum(flat), "repeated_vertices": sum(n - 1 for n in places.values()),
            "closed": all(n % 2 == 0 for n in edges.values())}, corners


def test_reports_are_those_of_counts():
    source = random.Random(SEED)
    seen = Counter()
    for _ in range(60):
        n = source.randint(4, 9)
        vertices = [[source.randint(0, 3) for _ in range(3)] for _ in range(n)]
        faces = [source.sample(range(n), 3) for _ in range(source.randint(1, 8))]
        mesh = plumb.Mesh(vertices, faces)
        report = plumb.check(mesh)
        expected, _ = counted(mesh)
        assert {name: report[name] for name in expected} == expected
        seen.update(report["defects"])
        assert ("open" in report["defects"]) == (not report["closed"]) == (expected["open_edges"] > 0 or not expected["closed"])
        assert ("degenerate" in report["defects"]) == (expected["degenerate_triangles"] > 0)
        assert json.loads(json.dumps(report)) == report and str(report).startswith("surface ")
    assert len(seen) >= 5, seen


def test_surfaces_that_meet_themselves():
    source = random.Random(SEED + 1)
    yes = 0
    for _ in range(80):
        corners = np.array([[source.randint(0, 4) for _ in range(3)] for _ in range(6)], float)
        mesh = plumb.Mesh(corners, [[0, 1, 2], [3, 4, 5]])
        expected, triangles = counted(mesh)
        if expected["degenerate_triangles"] or expected["repeated_vertices"]:
            continue
        report = plumb.check(mesh)
        assert report["self_intersecting"] == meet(*triangles) == (report["touching"] + report["overlapping"] > 0)
        yes += report["self_intersecting"]
    assert 5 < yes < 70


def test_a_cube():
    report = plumb.check(cube())
    assert report["defects"] == [] and report["shells"][0]["volume"] == 8 and report["closed"] and report["oriented"]
    assert str(report) == ("surface     closed, oriented, free of self-intersections, free of degenerate triangles\n"
                           "wrong       nothing\nshells      1: 12 triangles from 0 on, closed, volume 8")
    again = pickle.loads(pickle.dumps(report))
    assert again == report and str(again) == str(report)
    inside_out = plumb.check(plumb.Mesh(CUBE[0], CUBE[1][:, ::-1]))
    assert "oriented inward" in str(inside_out) and "wrong       1 shell wound inside out\n" in str(inside_out)
    assert inside_out["defects"] == ["inside-out"] and inside_out["shells"][0]["volume"] == -8
    spike = np.concatenate([CUBE[1], [[8, 0, 1]]])
    near = plumb.check(plumb.Mesh(np.concatenate([CUBE[0], [[0, 0, 1e-9]]]), spike), nearer_than=1e-6)
    assert near["nearer_than"] == 1e-6 and near["close_vertices"] == 2 and "close-vertices" in near["defects"]


def test_what_is_mended():
    soup = plumb.Mesh(CUBE[0][CUBE[1]].reshape(-1, 3), np.arange(36).reshape(-1, 3))
    assert plumb.check(soup)["open_edges"] == 36
    done = plumb.repair(soup)
    assert done.report["defects"] == [] and len(done.mesh.vertices) == 8 and done.report["shells"][0]["volume"] == 8
    assert sum(c.what == "vertex merged with another" for c in done.changes) == 28 and not any(c.is_left for c in done.changes)
    assert plumb.check(done.mesh) == done.report
    hole = plumb.repair(plumb.Mesh(CUBE[0], CUBE[1][2:]), ["holes"])
    assert hole.report["closed"] and [(c.what, c.step, c.how_many) for c in hole.changes] == [("hole filled", "holes", 2)]
    moved = CUBE[0][CUBE[1]].reshape(-1, 3)
    moved[0] += 1e-7
    assert plumb.repair(plumb.Mesh(moved, soup.faces), [("weld", 1e-6)]).report["closed"]
    assert not plumb.repair(plumb.Mesh(moved, soup.faces), ["weld"]).report["closed"]
    assert len(plumb.repair(cube(), [("small-components", 13)]).mesh.faces) == 0


def test_sections():
    planes = [plumb.Plane3([0, 0, 1], z) for z in (0.5, 3, 2, 0)]
    cuts = plumb.sections(cube(), planes)
    assert [len(c) for c in cuts] == [1, 0, 1, 0]
    assert [len(c) for c in plumb.sections(cube(), planes, on_plane="below")] == [1, 0, 0, 1]
    contour = cuts[0][0]
    assert contour.closed and contour.turn == 1 and contour.parent is None and contour.depth == 0
    assert (contour.points[:, 2] == 0.5).all()
    x, y = contour.points[:, 0], contour.points[:, 1]
    assert abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2 == 4
    hollow = plumb.Mesh(np.concatenate([CUBE[0], CUBE[0] / 2 + 0.5]), np.concatenate([CUBE[1], CUBE[1][:, ::-1] + 8]))
    (both,) = plumb.sections(hollow, [plumb.ThreePointPlane3([0, 0, 1], [1, 0, 1], [0, 1, 1])])
    assert sorted((c.depth, c.turn) for c in both) == [(0, 1), (1, -1)] and {c.parent for c in both} == {None, 0} or \
        {c.parent for c in both} == {None, 1}


def test_hausdorff_distance():
    a, b = plumb.Bvh(cube()), plumb.Bvh(cube((0, 0, 3)))
    far = a.hausdorff(b)
    assert far.least <= 3 <= far.most and far.is_within and far.most - far.least <= far.most / 1024
    exact = plumb.Bvh(plumb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    same = exact.hausdorff(exact)
    assert same.least == 0 and same.most < 1e-9
    assert math.isclose(a.hausdorff(exact, relative=2**-20).most, math.dist([2, 2, 2], [0.5, 0.5, 0]), rel_tol=1e-5)


@pytest.mark.parametrize("make, error, text", [
    (lambda: plumb.check(3), TypeError, "check"),
    (lambda: plumb.check(cube(), -1.0), ValueError, "negative|length|nearer"),
    (lambda: plumb.repair(cube(), ["wield"]), ValueError, "there is no step 'wield'; there are weld, degenerate"),
    (lambda: plumb.repair(cube(), [3]), TypeError, "a step is a name"),
    (lambda: plumb.repair(cube(), [("weld", -1)]), ValueError, "tolerance"),
    (lambda: plumb.repair(cube(), [("weld", math.nan)]), ValueError, "nan"),
    (lambda: plumb.repair(cube(), tolerance=-1.0), ValueError, "tolerance"),
    (lambda: plumb.sections(cube(), [plumb.Sphere3([0, 0, 0], 1)]), ValueError, "no Plane3"),
    (lambda: plumb.sections(cube(), [plumb.Plane3([0, 0, 0], 1)]), ValueError, "normal"),
    (lambda: plumb.sections(cube(), [], on_plane="beside"), ValueError, "on_plane is 'beside'"),
    (lambda: plumb.Bvh(cube()).hausdorff(plumb.Bvh(plumb.Mesh([], []))), ValueError, "hausdorff"),
    (lambda: plumb.Bvh(cube()).hausdorff(plumb.Bvh(cube()), relative=-1), ValueError, "hausdorff"),
])
def test_what_is_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()


def volume(mesh):
    """Six times the volume, exactly."""
    corners = [[list(map(Fraction, mesh.vertices[v].tolist())) for v in face] for face in mesh.faces.tolist()]
    return sum((sum(x * y for x, y in zip(a, cross(b, c))) for a, b, c in corners), Fraction(0))


def test_solids_of_solids_have_their_volumes():
    source = random.Random(SEED)
    shared = 0
    for _ in range(40):
        at = [source.randint(0, 3) for _ in range(3)]
        a, b = cube(), cube(at)
        whole = {name: getattr(plumb, name)(a, b) for name in ("unite", "intersect", "subtract", "symmetric_difference")}
        for name, told in whole.items():
            report = plumb.check(told.mesh)
            assert told.sound and told.moved == 0 and (report["closed"] or not len(told.mesh.faces)), name
            assert not report["overlapping"] and len(told.sources) == len(told.mesh.faces)
            merged = getattr(plumb, name)(a, b, merge=True)
            assert merged.sound and volume(merged.mesh) == volume(told.mesh)
            assert len(merged.mesh.faces) <= len(told.mesh.faces)
        assert sum(x != 0 for x in at) > 1 or len(plumb.unite(a, b, merge=True).mesh.faces) in (12, 24)
        common = math.prod(max(0, 2 - abs(x)) for x in at)
        shared += common > 0
        assert volume(whole["intersect"].mesh) == 6 * common
        assert volume(whole["unite"].mesh) == 6 * (16 - common)
        assert volume(whole["subtract"].mesh) == 6 * (8 - common)
        assert volume(whole["symmetric_difference"].mesh) == 6 * (16 - 2 * common)
    assert 5 < shared < 40
    with pytest.raises(ValueError, match="edge"):
        plumb.unite(cube(), plumb.Mesh(cube().vertices, cube().faces[1:]))
    with pytest.raises(TypeError, match="unite"):
        plumb.unite(3)


def test_trees_of_solids_are_exact_to_the_end():
    source = random.Random(SEED + 7)
    for _ in range(20):
        a, b, c = (cube([source.randint(0, 2) for _ in range(3)]) for _ in range(3))
        tree = ("subtract", ("unite", a, b), c)
        step = plumb.subtract(plumb.unite(a, b).mesh, c)
        told = plumb.evaluate(tree)
        assert told.sound and volume(told.mesh) == volume(step.mesh)
        odd = plumb.evaluate(("symmetric_difference", a, b, c), merge=True)
        assert volume(odd.mesh) == volume(plumb.symmetric_difference(a, b, c).mesh)
        assert volume(plumb.evaluate(("intersect", a, ("unite", b, c))).mesh) == volume(
            plumb.evaluate(("unite", ("intersect", a, b), ("intersect", a, c))).mesh
        )
    box = plumb.Aabb3([0, 0, 0], [2, 2, 2])
    assert volume(plumb.evaluate(box).mesh) == 6 * 8
    assert volume(plumb.evaluate(("subtract", box, cube([1, 1, 1]))).mesh) == 6 * 7
    for wrong in (plumb.Sphere3([0, 0, 0], 1), ("unite",), ("join", box, box), ("unite", box, "box"), (box, box)):
        with pytest.raises((ValueError, TypeError), match="evaluate"):
            plumb.evaluate(wrong)


def test_planes_split_solids_into_all_of_them():
    source = random.Random(SEED + 8)
    for _ in range(40):
        normal = [source.randint(-2, 2) for _ in range(3)]
        plane = plumb.Plane3(normal, source.randint(-3, 3) / 2)
        if not any(normal):
            with pytest.raises(ValueError, match="normal"):
                plumb.split(cube(), plane)
            continue
        halves = plumb.split(cube(), plane)
        assert all(h.sound for h in halves)
        if all(h.moved == 0 for h in halves):
            assert sum(volume(h.mesh) for h in halves) == 6 * 8
        for h, way in zip(halves, (1, -1)):
            beyond = way * (h.mesh.vertices @ normal - plane.offset)
            assert len(beyond) == 0 or beyond.min() >= -1e-12
            assert (np.all(h.sources[h.sources[:, 0] < 0] == -1)) and len(h.sources) == len(h.mesh.faces)
    with pytest.raises(ValueError, match="split"):
        plumb.split(cube(), plumb.Sphere3([0, 0, 0], 1))


def test_what_crosses_itself_is_resolved_by_a_rule():
    twice = plumb.Mesh(
        np.concatenate([cube().vertices, cube([1, 0, 0]).vertices]),
        np.concatenate([cube().faces, cube().faces + len(cube().vertices)]),
    )
    assert volume(plumb.resolve(twice).mesh) == volume(plumb.resolve(twice, "nonzero").mesh) == 6 * 12
    assert volume(plumb.resolve(twice, "odd", merge=True).mesh) == 6 * 8
    with pytest.raises(ValueError, match="rule"):
        plumb.resolve(twice, "even")


def test_polygons_are_cut_without_losing_area():
    source = random.Random(SEED + 1)
    for _ in range(60):
        outer = [[0, 0], [8, 0], [8, 8], [0, 8]]
        x, y = source.randint(1, 5), source.randint(1, 5)
        hole = [[x, y], [x, y + source.randint(1, 2)], [x + source.randint(1, 2), y]]
        figure = plumb.HoledPolygon2(plumb.Polygon2(outer), [plumb.Polygon2(hole)])
        points = outer + hole
        area = lambda f: sum((points[b][0] - points[a][0]) * (points[c][1] - points[a][1])
                             - (points[c][0] - points[a][0]) * (points[b][1] - points[a][1]) for a, b, c in f)
        whole = 128 - abs(area([(4, 5, 6)]))
        triangles = plumb.triangulate(figure).tolist()
        assert area(triangles) == whole and {v for t in triangles for v in t} == set(range(7))
        pieces = [p.tolist() for p in plumb.convex_pieces(figure)]
        assert sum(area([(p[0], p[i], p[i + 1])]) for p in pieces for i in range(1, len(p) - 1)) == whole
        assert len(pieces) < len(triangles)
    with pytest.raises(ValueError, match="rule"):
        plumb.triangulate(figure, "even")
    with pytest.raises(ValueError, match="triangulate"):
        plumb.triangulate(plumb.Sphere3([0, 0, 0], 1))


def test_delaunay_circles_are_empty():
    source = random.Random(SEED + 2)
    for _ in range(30):
        points = [[source.randint(0, 6), source.randint(0, 6)] for _ in range(12)]
        told = plumb.delaunay(points)
        for (a, b, c), beside in zip(told.simplices.tolist(), told.neighbors.tolist()):
            assert plumb.orient2d(points[a], points[b], points[c]) == 1
            assert not np.any(plumb.incircle(points[a], points[b], points[c], points) == 1)
            assert all(n == -1 or a in told.simplices[n] or b in told.simplices[n] for n in beside)
    with pytest.raises(ValueError, match="cross"):
        plumb.delaunay([[0, 0], [2, 2], [0, 2], [2, 0]], [[0, 1], [2, 3]])


def test_parts_of_a_solid_add_up_and_hulls_cover_it():
    step = plumb.unite(cube(), cube([2, 0, 0]), cube([0, 2, 0])).mesh
    parts = plumb.convex_parts(step)
    assert sum(p.volume for p in parts) == 24 and all(p.is_exact for p in parts) and len(parts) == 2
    assert sum(len(f) for p in parts for f in p.faces) > 0
    hull, = plumb.covering_parts(step, concavity=4)
    assert {tuple(v) for v in hull.vertices.tolist()} <= {tuple(v) for v in step.vertices.tolist()}
    assert 0 < hull.concavity <= 4
