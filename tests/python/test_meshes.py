"""Are meshes what files and arrays say, and are the answers of their trees those of the test vectors and of brute force?"""

import copy
import gc
import pickle
import random
import signal
import threading
from fractions import Fraction

import numpy as np
import pytest

import plumb
from test_signs import SEED, cases, cross, dot, sub

CUBE = (np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 2.0) for z in (0.0, 2.0)]),
        np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]], np.int32))


def cube(at=(0, 0, 0)):
    return plumb.Mesh(CUBE[0] + at, CUBE[1])


def test_arrays_are_the_meshs_own():
    mesh = cube()
    assert mesh.vertices.dtype == np.float64 and mesh.faces.dtype == np.int32
    assert np.array_equal(mesh.vertices, CUBE[0]) and np.array_equal(mesh.faces, CUBE[1])
    assert np.shares_memory(mesh.vertices, mesh.vertices)
    with pytest.raises(ValueError, match="read-only"):
        mesh.vertices[0] = 1
    view = mesh.faces
    del mesh
    gc.collect()
    assert np.array_equal(view, CUBE[1])  # it keeps the mesh alive


def test_kept_and_copied():
    mesh = cube()
    for other in (pickle.loads(pickle.dumps(mesh)), copy.deepcopy(mesh), plumb.Mesh(mesh.vertices, mesh.faces)):
        assert other == mesh
    assert mesh != cube((1, 0, 0)) and mesh != 3
    assert repr(mesh) == "Mesh(8 vertices, 12 faces)"
    empty = plumb.Mesh([], [])
    assert empty.vertices.shape == (0, 3) and empty.faces.shape == (0, 3)


@pytest.mark.parametrize("name", ["part.obj", "part.off", "part.ply", "part.stl"])
def test_files(name, tmp_path):
    vertices = CUBE[0] + [0.1, 1e-300, 5e-324]
    mesh = plumb.Mesh(vertices, CUBE[1])
    mesh.write(tmp_path / name)
    again = plumb.read_mesh(str(tmp_path / name))
    assert np.array_equal(again.vertices[again.faces], vertices[CUBE[1]])  # bit for bit
    assert again == mesh or name == "part.stl"  # which has no indices


def test_files_that_are_none(tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere.stl"):
        plumb.read_mesh(tmp_path / "nowhere.stl")
    bad = tmp_path / "bad.obj"
    bad.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")
    with pytest.raises(ValueError, match=r"bad.obj.*4"):
        plumb.read_mesh(bad)
    with pytest.raises(OSError):
        cube().write(tmp_path / "no folder" / "part.obj")
    with pytest.raises(ValueError):
        cube().write(tmp_path / "part.unknown")


@pytest.mark.parametrize("vertices, faces, error, text", [
    (CUBE[0][:, :2], CUBE[1], ValueError, r"vertices has shape \(8, 2\) and dtype float64; expected shape \(n, 3\)"),
    (CUBE[0], CUBE[1][:, :2], ValueError, r"faces has shape \(12, 2\)"),
    (CUBE[0], CUBE[1] * 1.0, TypeError, "faces has .* dtype float64; expected integers"),
    (CUBE[0], [[0, 1, 8]], ValueError, r"faces\[0, 2\] is 8, but there are 8 vertices"),
    (CUBE[0], [[0, 1, 2], [0, -1, 2]], ValueError, r"faces\[1, 1\] is -1"),
    (CUBE[0], np.array([[0, 1, 2**64 - 1]], np.uint64), ValueError, "beyond the 8"),
    (CUBE[0] * np.where(np.arange(3) == 1, np.nan, 1), CUBE[1], ValueError, r"vertices\[0, 1\] is nan"),
])
def test_what_is_refused(vertices, faces, error, text):
    with pytest.raises(error, match=text):
        plumb.Mesh(vertices, faces)


def test_rays_at_the_meshes_of_the_vectors():
    numbers, answers = cases("ray-mesh")  # origin, direction, the corners +x -x +y -y +z -z of an octahedron
    faces = [[x, y, z] for x in (0, 1) for y in (2, 3) for z in (4, 5)]
    for row, answer in zip(numbers, answers):
        triangle, t, point = plumb.Bvh(plumb.Mesh(row[6:].reshape(6, 3), faces)).closest_hit(row[:3], row[3:6])
        assert (triangle >= 0) == (answer == "yes")
        assert np.isfinite(t) == (triangle >= 0) == (not np.isnan(point).any())


def test_closest_hit():
    tree = plumb.Bvh(cube())
    assert len(tree) == 12 and repr(tree) == "Bvh(12 triangles)"
    triangle, t, point = tree.closest_hit([[-1, 0.5, 1], [-1, 5, 5], [1, 1, 1]], [1, 0, 0])
    assert triangle.dtype == np.int32 and triangle.tolist()[1] == -1
    assert t.tolist() == [1.0, np.inf, 1.0]
    assert point[0].tolist() == [0, 0.5, 1] and np.isnan(point[1]).all() and point[2].tolist() == [2, 1, 1]
    triangle, t, point = tree.closest_hit([-1, 2, 2], [2, 0, 0])  # along an edge
    assert triangle >= 0 and t == 0.5 and point.tolist() == [0, 2, 2]
    with pytest.raises(ValueError, match="origins has 2 rows and directions 3"):
        tree.closest_hit(np.zeros((2, 3)), np.ones((3, 3)))
    with pytest.raises(ValueError, match=r"origins\[0, 2\] is nan"):
        tree.closest_hit([0, 0, np.nan], [1, 0, 0])


def test_trees_are_kept(tmp_path):
    tree = plumb.Bvh(cube())
    tree.write(tmp_path / "cube.bvh")
    for again in (pickle.loads(pickle.dumps(tree)), copy.deepcopy(tree), plumb.read_bvh(tmp_path / "cube.bvh")):
        assert len(again) == 12 and again.contains([[1, 1, 1], [3, 1, 1]]).tolist() == [True, False]
        assert again.closest_point([1, 1, 5])[1] == 3 and again.distance(plumb.Bvh(cube((5, 6, 0)))) == 5
    with pytest.raises((OSError, ValueError), match="nowhere.bvh"):
        plumb.read_bvh(tmp_path / "nowhere.bvh")
    (tmp_path / "bad.bvh").write_bytes(b"no tree")
    with pytest.raises(ValueError, match="bad.bvh"):
        plumb.read_bvh(tmp_path / "bad.bvh")


def test_contains():
    tree = plumb.Bvh(cube())
    grid = np.array([[x, y, z] for x in range(-1, 4) for y in range(-1, 4) for z in range(-1, 4)], float)
    expected = ((grid >= 0) & (grid <= 2)).all(axis=1)
    answer = tree.contains(grid)
    assert answer.dtype == bool and np.array_equal(answer, expected)
    assert tree.contains([1, 1, 1]) and not tree.contains([1, 1, np.nextafter(2, 3)])


def test_closest_point():
    tree = plumb.Bvh(cube())
    triangle, distance, point = tree.closest_point([[1, 1, 5], [-3, 1, -4], [1, 1, 1.5]])
    assert distance.tolist() == [3, 5, 0.5]
    assert point.tolist() == [[1, 1, 2], [0, 1, 0], [1, 1, 2]]
    _, one, _ = tree.closest_point([5, 1, 1])
    assert one == 3 and np.ndim(one) == 0
    with pytest.raises(ValueError):
        plumb.Bvh(plumb.Mesh([], [])).closest_point([[0, 0, 0]])


def meet(a, b):
    """Do two triangles have a point in common?  Closed sets that no plane divides, by fractions."""
    edges = [[sub(t[(i + 1) % 3], t[i]) for i in range(3)] for t in (a, b)]
    normals = [cross(e[0], e[1]) for e in edges]
    axes = normals + [cross(u, v) for u in edges[0] for v in edges[1]]
    axes += [cross(n, u) for n, e in zip(normals, edges) for u in e]
    for axis in axes:
        p, q = [dot(axis, x) for x in a], [dot(axis, x) for x in b]
        if max(p) < min(q) or max(q) < min(p):
            return False
    return True


def test_intersections():
    source = random.Random(SEED)
    soups = []
    while len(soups) < 2:
        corners = np.array([[source.randint(0, 5) for _ in range(3)] for _ in range(90)], float)
        rows = corners.reshape(30, 3, 3)
        solid = [any(cross(sub(t[1], t[0]), sub(t[2], t[0]))) for t in rows.tolist()]
        corners = rows[solid].reshape(-1, 3)
        soups.append(plumb.Mesh(corners, np.arange(len(corners)).reshape(-1, 3)))
    corners = [[[list(map(Fraction, p)) for p in t] for t in m.vertices[m.faces].tolist()] for m in soups]
    expected = [[i, j] for i, a in enumerate(corners[0]) for j, b in enumerate(corners[1]) if meet(a, b)]
    trees = [plumb.Bvh(m) for m in soups]
    pairs, overlapping = trees[0].intersections(trees[1])
    assert pairs.dtype == np.int32 and pairs.tolist() == expected and 0 < len(expected) < len(corners[0]) ** 2
    assert overlapping.any() and not overlapping.all()
    expected = [[i, j] for i, a in enumerate(corners[0]) for j, b in enumerate(corners[0]) if i < j and meet(a, b)]
    assert trees[0].self_intersections()[0].tolist() == expected


def test_a_cube_meets_itself_nowhere():
    pairs, overlapping = plumb.Bvh(cube()).self_intersections()
    assert pairs.shape == (0, 2) and overlapping.shape == (0,)


def test_distance():
    tree = plumb.Bvh(cube())
    assert tree.distance(plumb.Bvh(cube((5, 6, 0)))) == 5
    assert tree.distance(plumb.Bvh(cube((2, 2, 2)))) == 0
    assert tree.distance(plumb.Bvh(plumb.Mesh([], []))) == np.inf


def test_ctrl_c_stops_what_is_long():
    source = np.random.default_rng(SEED)
    corners = source.random((6000, 3, 3)).reshape(-1, 3)
    tree = plumb.Bvh(plumb.Mesh(corners, np.arange(len(corners)).reshape(-1, 3)))
    timer = threading.Timer(0.02, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(200):
            tree.self_intersections()
    timer.join()
