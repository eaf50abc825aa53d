"""The C interface from another language, by its declarations alone: Python's ctypes.  Arguments: the shared library, its
headers.  Every function that they declare is there, and nothing else is."""

import ctypes
import re
import subprocess
import sys

lib = ctypes.CDLL(sys.argv[1])
lib.plumb_last_error.restype = ctypes.c_char_p
code = ""
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as header:
        code += re.sub(r"/\*.*?\*/", "", header.read(), flags=re.DOTALL)
declared = set(re.findall(r"\b(plumb_\w+)\(", code))
symbols = subprocess.run(["nm", "-D", "--defined-only", sys.argv[1]], capture_output=True, text=True, check=True).stdout
exported = {line.split()[2].split("@")[0] for line in symbols.splitlines()} - {"PLUMB_0.1"}
if declared != exported:
    raise SystemExit(f"declared or exported alone: {sorted(declared ^ exported)}")
lib.plumb_find_sign.restype = ctypes.c_size_t
lib.plumb_kept_destroy.argtypes = [ctypes.c_void_p]
lib.plumb_points_destroy.argtypes = [ctypes.c_void_p]


class Figure(ctypes.Structure):
    """plumb_figure, whose unions are as long as their longest members: an obb3, a matrix3."""

    _fields_ = [
        ("size", ctypes.c_size_t),
        ("kind", ctypes.c_int32),
        ("dimension", ctypes.c_int32),
        ("numbers", ctypes.c_double * 15),
        ("pose_kind", ctypes.c_int32),
        ("pose", ctypes.c_double * 12),
        ("kept", ctypes.c_void_p),
    ]


def figure(kind, dimension, *numbers):
    made = Figure(size=ctypes.sizeof(Figure), kind=kind, dimension=dimension)
    for i, x in enumerate(numbers):
        made.numbers[i] = x
    return made


def expect(is_so, what):
    if not is_so:
        raise SystemExit(f"failed: {what} (last error: {lib.plumb_last_error().decode()})")


BALL, AABB = 14, 15
ball, box = figure(BALL, 3, 0, 0, 0, 1), figure(AABB, 3, 1, -1, -1, 2, 1, 1)
relation = ctypes.c_int(7)
expect(lib.plumb_relate(ctypes.byref(ball), ctypes.byref(box), ctypes.byref(relation)) == 0, "relate")
expect(relation.value == 0, "a ball touches the box at its side")

distance = ctypes.c_double()
far = figure(BALL, 3, 0, 5, 0, 1)
expect(lib.plumb_distance(ctypes.byref(ball), ctypes.byref(far), ctypes.byref(distance)) == 0, "distance")
expect(distance.value == 3.0, "the distance of two balls")

status = lib.plumb_relate(ctypes.byref(figure(BALL, 3, 0, 0, 0, -1)), ctypes.byref(box), ctypes.byref(relation))
expect(status == 3 and b"radius" in lib.plumb_last_error(), "a negative radius is told by name")

kept = ctypes.c_void_p()
expect(lib.plumb_kept_parse(b"ball3 0 0 0 1", ctypes.byref(kept)) == 0, "a line is read")
by_line = figure(0, 0)
by_line.kept = kept
expect(lib.plumb_relate(ctypes.byref(by_line), ctypes.byref(box), ctypes.byref(relation)) == 0, "a kept figure")
expect(relation.value == 0, "a kept figure is what its line says")
lib.plumb_kept_destroy(kept)

orient = lib.plumb_find_sign(b"orient2d")
sign = ctypes.c_int(7)
turn = (ctypes.c_double * 6)(0, 0, 1e-300, 0, 0, 1e-300)
expect(lib.plumb_sign(ctypes.c_size_t(orient), turn, ctypes.byref(sign)) == 0 and sign.value == 1, "a sign")

points = (ctypes.c_double * 6)(0, 0, 3, 4, 1, 0)
tree = ctypes.c_void_p()
expect(lib.plumb_points_create(points, ctypes.c_size_t(3), 2, ctypes.byref(tree)) == 0, "a tree of points")
query = (ctypes.c_double * 2)(0, 0)
indices, distances = (ctypes.c_int64 * 3)(), (ctypes.c_double * 3)()
expect(lib.plumb_points_nearest(tree, query, ctypes.c_size_t(1), ctypes.c_size_t(3), indices, distances) == 0, "nearest")
expect(list(indices) == [0, 2, 1] and list(distances) == [0, 1, 5], "the nearest points in turn")

TAKE = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_uint32, ctypes.c_void_p)
taken = []
take = TAKE(lambda index, user: taken.append(index) or 1)
expect(lib.plumb_points_within(tree, query, ctypes.c_double(1), take, None) == 0 and taken == [0, 2], "within")
lib.plumb_points_destroy(tree)
print("all as it should be")
