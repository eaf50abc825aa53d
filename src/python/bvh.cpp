#include "plumb/space/bvh/bvh.hpp"

#include <limits>
#include <optional>

#include "plumb/space/bvh/tree_file.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/closest/hausdorff.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/ray/inside.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

/// One answer in place of an array of one.
py::object one_or_all(py::array all, bool single) { return single ? py::object(all[py::int_(0)]) : py::object(all); }

py::tuple closest_hit(const Bvh& self, const py::object& origins, const py::object& directions) {
  bool one_origin = false, one_direction = false;
  const py::array_t<double> from = row_or_rows_of(origins, {"closest_hit", "origins"}, 3, one_origin);
  const py::array_t<double> to = row_or_rows_of(directions, {"closest_hit", "directions"}, 3, one_direction);
  const std::span<const Point3> o = points_of<Point3>(from);
  const std::span<const Vector3> d = points_of<Vector3>(to);
  const std::size_t n = one_origin ? d.size() : o.size();
  if (!one_direction && d.size() != n) {
    throw py::value_error("closest_hit: origins has " + std::to_string(o.size()) + " rows and directions " +
                          std::to_string(d.size()));
  }
  const auto count = static_cast<py::ssize_t>(n);
  py::array_t<std::int32_t> triangles(count);
  py::array_t<double> parameters(count), points(std::vector<py::ssize_t>{count, 3});
  std::int32_t* triangle = triangles.mutable_data();
  double *t = parameters.mutable_data(), *point = points.mutable_data();
  unlocked([&] {
    std::vector<AnyRay> rays;
    rays.reserve(n);
    for (std::size_t i = 0; i < n; ++i) rays.emplace_back(Ray3{o[one_origin ? 0 : i], d[one_direction ? 0 : i]});
    std::vector<std::optional<NumberedHit>> hits(n);
    first_hit(self, rays, hits, {.progress = interruptible()});
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < n; ++i) {
      triangle[i] = hits[i] ? static_cast<std::int32_t>(hits[i]->index) : -1;
      t[i] = hits[i] ? hits[i]->hit.t : std::numeric_limits<double>::infinity();
      const Point3 p = hits[i] ? hits[i]->hit.point : Point3{none, none, none};
      point[3 * i] = p.x;
      point[3 * i + 1] = p.y;
      point[3 * i + 2] = p.z;
    }
  });
  const bool single = one_origin && one_direction;
  return py::make_tuple(one_or_all(triangles, single), one_or_all(parameters, single), one_or_all(points, single));
}

py::object contained(const Bvh& self, const py::object& points) {
  bool single = false;
  const py::array_t<double> rows = row_or_rows_of(points, {"contains", "points"}, 3, single);
  const std::span<const Point3> p = points_of<Point3>(rows);
  py::array_t<bool> out(static_cast<py::ssize_t>(p.size()));
  bool* at = out.mutable_data();
  unlocked([&] {
    std::vector<Location> where(p.size());
    locate(self, p, where);
    for (std::size_t i = 0; i < p.size(); ++i) at[i] = where[i] != Location::outside;
  });
  return one_or_all(out, single);
}

py::tuple closest_point(const Bvh& self, const py::object& points) {
  bool single = false;
  const py::array_t<double> rows = row_or_rows_of(points, {"closest_point", "points"}, 3, single);
  const std::span<const Point3> p = points_of<Point3>(rows);
  const auto count = static_cast<py::ssize_t>(p.size());
  py::array_t<std::int32_t> triangles(count);
  py::array_t<double> distances(count), nearest(std::vector<py::ssize_t>{count, 3});
  std::int32_t* triangle = triangles.mutable_data();
  double *distance = distances.mutable_data(), *point = nearest.mutable_data();
  unlocked([&] {
    std::vector<ClosestOnMesh> found(p.size());
    closest_on_mesh(self, p, found, {.progress = interruptible()});
    for (std::size_t i = 0; i < p.size(); ++i) {
      triangle[i] = static_cast<std::int32_t>(found[i].triangle);
      distance[i] = found[i].distance;
      point[3 * i] = found[i].point.x;
      point[3 * i + 1] = found[i].point.y;
      point[3 * i + 2] = found[i].point.z;
    }
  });
  return py::make_tuple(one_or_all(triangles, single), one_or_all(distances, single), one_or_all(nearest, single));
}

py::tuple told_pairs(const std::vector<TrianglePair>& pairs) {
  const auto count = static_cast<py::ssize_t>(pairs.size());
  py::array_t<std::int32_t> numbers(std::vector<py::ssize_t>{count, 2});
  py::array_t<bool> overlapping(count);
  std::int32_t* number = numbers.mutable_data();
  bool* overlaps = overlapping.mutable_data();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    number[2 * i] = static_cast<std::int32_t>(pairs[i].a);
    number[2 * i + 1] = static_cast<std::int32_t>(pairs[i].b);
    overlaps[i] = pairs[i].relation == Relation::overlapping;
  }
  return py::make_tuple(numbers, overlapping);
}

py::object hausdorff(const Bvh& self, const Bvh& other, double relative, double absolute) {
  const HausdorffDistance d = unlocked([&] {
    return hausdorff_distance(self, other, {.absolute = absolute, .relative = relative, .progress = interruptible()});
  });
  return answer("HausdorffDistance", d.least, d.most, d.is_within, d.of_b,
                array_of<double>(std::span<const Point3>(&d.point, 1))[py::int_(0)]);
}

constexpr const char* about_pairs =
    "\n\nReturns\n-------\npairs : int32, shape (n, 2), in ascending order\noverlapping : bool, shape (n,), False "
    "where a "
    "pair only touches";

}  // namespace

void add_bvh(py::module_& module) {
  py::class_<Bvh>(module, "Bvh",
                  "Bvh(mesh)\n--\n\nA tree of boxes over the triangles of a mesh, for exact questions.\n\n"
                  "Answers are those of real arithmetic, on any number of threads; numbers are rounded once.  Rows of\n"
                  "points may also be one point, shape (3,): then each answer is one as well.")
      .def(py::init([](const TriangleMesh& mesh) {
             const py::gil_scoped_release released;
             return std::make_unique<Bvh>(build_bvh(mesh));
           }),
           py::arg("mesh"))
      .def("__len__", [](const Bvh& self) { return self.slots(); })
      .def("__repr__", [](const Bvh& self) { return "Bvh(" + std::to_string(self.slots()) + " triangles)"; })
      .def(
          "write",
          [](const Bvh& self, const py::object& path) {
            const std::string name = path_of(path);
            const py::gil_scoped_release released;
            write_bvh(name, self);
          },
          py::arg("path"), "write(self, path)\n--\n\nWrites the tree and its triangles to a file, for read_bvh.")
      .def("__reduce__",
           [](const Bvh& self) {
             return py::make_tuple(py::module_::import("plumb._pickled").attr("tree"),
                                   py::make_tuple(py::bytes(bvh_bytes(self))));
           })
      .def("closest_hit", closest_hit, py::arg("origins"), py::arg("directions"),
           "closest_hit(self, origins, directions)\n--\n\nWhich triangle does each ray hit first?\n\n"
           "Parameters\n----------\norigins, directions : array_like, shape (n, 3) or (3,); of any length\n\n"
           "Returns\n-------\ntriangle : int32, shape (n,); -1 where nothing is hit; of equal hits the lowest\n"
           "t : float64, shape (n,), in lengths of the direction; inf where nothing is hit\n"
           "point : float64, shape (n, 3); nan where nothing is hit")
      .def("contains", contained, py::arg("points"),
           "contains(self, points)\n--\n\nIs each point in the solid that the closed mesh bounds, its surface "
           "included?  "
           "bool, shape (n,).")
      .def("closest_point", closest_point, py::arg("points"),
           "closest_point(self, points)\n--\n\nWhich point of the surface is nearest to each?\n\n"
           "Returns\n-------\ntriangle : int32, shape (n,); of equally near ones the lowest\ndistance : float64, shape "
           "(n,)\n"
           "point : float64, shape (n, 3)")
      .def(
          "self_intersections",
          [](const Bvh& self) {
            return told_pairs(unlocked([&] { return intersecting_pairs(self, {.progress = interruptible()}); }));
          },
          (std::string("self_intersections(self)\n--\n\nWhich triangles meet others beyond the vertices that neighbors "
                       "share?") +
           about_pairs)
              .c_str())
      .def(
          "intersections",
          [](const Bvh& self, const Bvh& other) {
            return told_pairs(unlocked([&] { return intersecting_pairs(self, other, {.progress = interruptible()}); }));
          },
          py::arg("other"),
          (std::string("intersections(self, other)\n--\n\nWhich triangles meet which of another mesh?") + about_pairs)
              .c_str())
      .def(
          "distance", [](const Bvh& self, const Bvh& other) { return unlocked([&] { return distance(self, other); }); },
          py::arg("other"),
          "distance(self, other)\n--\n\nHow far are the two surfaces apart?  0 where they touch, inf where one is "
          "empty.")
      .def("hausdorff", hausdorff, py::arg("other"), py::kw_only(), py::arg("relative") = 0x1p-10,
           py::arg("absolute") = 0.0,
           "hausdorff(self, other, *, relative=2**-10, absolute=0.0)\n--\n\nHow far is the farthest point of either "
           "surface from the other one?\n\nParameters\n----------\nother : Bvh\nrelative, absolute : float, not "
           "negative; how far the two bounds may be apart, as a share of the greater, or as a "
           "length\n\nReturns\n-------\n"
           "HausdorffDistance");
  module.def(
      "read_bvh",
      [](const py::object& path) {
        const std::string name = path_of(path);
        const py::gil_scoped_release released;
        return std::make_unique<Bvh>(read_bvh(name));
      },
      py::arg("path"),
      "read_bvh(path)\n--\n\nThe tree of a file that Bvh.write wrote.\n\nRaises\n------\nOSError, ValueError\n    If "
      "it "
      "cannot be read, or is no such file.");
}

}  // namespace plumb::python
