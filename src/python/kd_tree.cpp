#include "plumb/space/kd_tree/kd_tree.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <variant>

#include "certify/batch/all_threads.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "python/numbers.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

// Between so many queries the interpreter is asked whether Ctrl-C was pressed.
constexpr std::size_t most_at_once = std::size_t{1} << 18;

struct PointTree {
  py::array_t<double> data;
  std::variant<KdTree2, KdTree3> tree;

  [[nodiscard]] py::ssize_t dimension() const { return tree.index() == 0 ? 2 : 3; }
  [[nodiscard]] std::size_t size() const {
    return std::visit([](const auto& t) { return std::size_t{t.count}; }, tree);
  }
};

PointTree tree_of(const py::object& points) {
  const py::array_t<double> rows = rows_of_plane_or_space(points, {"KDTree", "points"});
  py::array_t<double> kept = rows.attr("copy")().cast<py::array_t<double>>();  // nobody else changes it
  kept.attr("setflags")(py::arg("write") = false);
  PointTree made{kept, KdTree2{}};
  const bool in_plane = kept.shape(1) == 2;
  const std::span<const Point2> flat = points_of<Point2>(kept);
  const std::span<const Point3> solid = points_of<Point3>(kept);
  const py::gil_scoped_release released;
  if (in_plane) {
    made.tree = build_kd_tree(flat);
  } else {
    made.tree = build_kd_tree(solid);
  }
  return made;
}

/// The queries, one after the other, and the shape of what comes back.
struct Queries {
  py::array_t<double> rows;
  std::vector<py::ssize_t> shape;
  [[nodiscard]] std::size_t size() const {
    std::size_t n = 1;
    for (const py::ssize_t s : shape) n *= static_cast<std::size_t>(s);
    return n;
  }
};

Queries queries_of(const PointTree& self, const py::object& x, const Asked& asked) {
  const py::array numbers = numbers_of(x, asked);
  const py::ssize_t d = self.dimension();
  if (numbers.ndim() == 0 || numbers.shape(numbers.ndim() - 1) != d)
    refuse(asked, py::array::ensure(x), "shape (..., " + std::to_string(d) + ")");
  Queries q{{}, {numbers.shape(), numbers.shape() + numbers.ndim() - 1}};
  q.rows = rows_of(numbers.attr("reshape")(q.size(), d), asked, d);
  return q;
}

/// ask(tree, points, first) of up to `most_at_once` queries at a time, without the interpreter's lock.
template <class Ask>
void of_parts(const PointTree& self, const Queries& q, const Ask& ask) {
  std::visit(
      [&]<class Point>(const KdTree<Point>& tree) {
        const std::span<const Point> all = points_of<Point>(q.rows);
        unlocked([&] {
          for (std::size_t first = 0; first < all.size(); first += most_at_once) {
            if (!interruptible()(0)) throw Cancelled("KDTree: stopped");
            ask(tree, all.subspan(first, std::min(most_at_once, all.size() - first)), first);
          }
        });
      },
      self.tree);
}

py::object shaped(py::array all, std::vector<py::ssize_t> shape) {
  return shape.empty() ? py::object(all[py::int_(0)]) : py::object(all.attr("reshape")(shape));
}

/// One array for each query, of as many points as are equally near.
py::tuple with_ties(const PointTree& self, const Queries& q, std::size_t k) {
  std::vector<std::vector<NearestPoint>> found(q.size());
  of_parts(self, q, [&](const auto& tree, const auto& points, std::size_t first) {
    certify::batch::for_each_part(Execution::parallel, points.size(), [&](std::size_t i) {
      found[first + i] = nearest(tree, points[i], std::min(k, self.size()), Ties::all);
    });
  });
  py::array distances(py::dtype("O"), std::vector<py::ssize_t>{static_cast<py::ssize_t>(found.size())});
  py::array numbers(py::dtype("O"), std::vector<py::ssize_t>{static_cast<py::ssize_t>(found.size())});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto n = static_cast<py::ssize_t>(found[i].size());
    py::array_t<double> distance(n);
    py::array_t<std::int32_t> number(n);
    for (py::ssize_t j = 0; j < n; ++j) {
      distance.mutable_at(j) = found[i][static_cast<std::size_t>(j)].distance;
      number.mutable_at(j) = static_cast<std::int32_t>(found[i][static_cast<std::size_t>(j)].index);
    }
    distances[py::int_(i)] = distance;
    numbers[py::int_(i)] = number;
  }
  return py::make_tuple(shaped(distances, q.shape), shaped(numbers, q.shape));
}

py::tuple query(const PointTree& self, const py::object& x, py::ssize_t k, const std::string& ties) {
  if (k < 1) throw py::value_error("query: k is " + std::to_string(k) + "; ask for one point at least");
  if (ties != "lowest" && ties != "all") throw py::value_error("query: ties is '" + ties + "'; give 'lowest' or 'all'");
  const Queries q = queries_of(self, x, {"query", "x"});
  if (ties == "all") return with_ties(self, q, static_cast<std::size_t>(k));
  const auto asked = static_cast<std::size_t>(k), some = std::min(asked, self.size());
  std::vector<py::ssize_t> shape = q.shape;
  if (k > 1) shape.push_back(k);
  const auto count = static_cast<py::ssize_t>(q.size() * asked);
  py::array_t<double> distances(count);
  py::array_t<std::int32_t> numbers(count);
  double* distance = distances.mutable_data();
  std::int32_t* number = numbers.mutable_data();
  const auto none = static_cast<std::int32_t>(self.size());
  of_parts(self, q, [&](const auto& tree, const auto& points, std::size_t first) {
    std::vector<NearestPoint> found(points.size() * some);
    if (some == 1) {
      nearest(tree, points, found);
    } else if (some != 0) {
      nearest(tree, points, some, found);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < asked; ++j) {
        const std::size_t at = (first + i) * asked + j;
        distance[at] = j < some ? found[i * some + j].distance : std::numeric_limits<double>::infinity();
        number[at] = j < some ? static_cast<std::int32_t>(found[i * some + j].index) : none;
      }
    }
  });
  return py::make_tuple(shaped(distances, shape), shaped(numbers, shape));
}

py::list list_of_numbers(std::span<const std::uint32_t> numbers) {
  py::list all(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) all[i] = numbers[i];
  return all;
}

py::object ball_points(const PointTree& self, const py::object& x, const py::object& r, bool return_length) {
  const Queries q = queries_of(self, x, {"query_ball_point", "x"});
  const py::array radii = numbers_of(r, {"query_ball_point", "r"});
  std::vector<std::vector<std::uint32_t>> found(q.size());
  const bool one_radius = radii.ndim() == 0;
  py::array_t<double> radius = radii.cast<py::array_t<double>>();
  if (!one_radius) {
    const py::object wide = py::module_::import("numpy").attr("broadcast_to")(radii, py::tuple(py::cast(q.shape)));
    radius = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(wide);
  }
  const double* each = radius.data();
  of_parts(self, q, [&](const auto& tree, const auto& points, std::size_t first) {
    certify::batch::for_each_part(Execution::parallel, points.size(), [&](std::size_t i) {
      found[first + i] = within(tree, points[i], each[one_radius ? 0 : first + i]);
    });
  });
  if (return_length) {
    py::array_t<std::int32_t> lengths(static_cast<py::ssize_t>(found.size()));
    for (std::size_t i = 0; i < found.size(); ++i)
      lengths.mutable_at(static_cast<py::ssize_t>(i)) = static_cast<std::int32_t>(found[i].size());
    return shaped(lengths, q.shape);
  }
  if (q.shape.empty()) return list_of_numbers(found[0]);
  py::array lists(py::dtype("O"), std::vector<py::ssize_t>{static_cast<py::ssize_t>(found.size())});
  for (std::size_t i = 0; i < found.size(); ++i) lists[py::int_(i)] = list_of_numbers(found[i]);
  return shaped(lists, q.shape);
}

}  // namespace

void add_kd_tree(py::module_& module) {
  py::class_<PointTree>(
      module, "KDTree",
      "KDTree(points)\n--\n\nA tree over points, for exact nearest neighbors; asked as scipy.spatial.cKDTree is.\n\n"
      "Nearer in real arithmetic comes first, of equally near points the one of the lower number.  Distances are\n"
      "rounded once.  Runs on all threads, without the interpreter's lock.\n\nParameters\n----------\n"
      "points : array_like, shape (n, 2) or (n, 3)\n\nRaises\n------\nValueError\n    If the shape is another, or a "
      "number is not finite.")
      .def(py::init(&tree_of), py::arg("points"))
      .def_property_readonly(
          "data", [](const PointTree& self) { return self.data; }, "float64, shape (n, m): the points, read-only.")
      .def_property_readonly("n", &PointTree::size, "int: how many points there are.")
      .def_property_readonly("m", &PointTree::dimension, "int: 2 or 3.")
      .def("__len__", &PointTree::size)
      .def("__repr__",
           [](const PointTree& self) {
             return "KDTree(" + std::to_string(self.size()) + " points of " +
                    (self.dimension() == 2 ? "the plane)" : "space)");
           })
      .def("__reduce__",
           [](const py::object& self) { return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("data"))); })
      .def(
          "query", query, py::arg("x"), py::arg("k") = 1, py::kw_only(), py::arg("ties") = "lowest",
          "query(self, x, k=1, *, ties='lowest')\n--\n\nWhich k points are nearest to each?\n\nParameters\n----------\n"
          "x : array_like, shape (..., m)\nk : int, one at least\nties : 'lowest', or 'all' for all points that are "
          "exactly as near as the last one\n\nReturns\n-------\ndistance : float64, shape (...) where k is 1, else "
          "(..., k), nearest first; inf where there are fewer points\nindex : int32, of the same shape; n where there "
          "are fewer points\n\nWhere ties is 'all', each is an array of arrays, as long as there are points.")
      .def(
          "query_ball_point", ball_points, py::arg("x"), py::arg("r"), py::kw_only(), py::arg("return_length") = false,
          "query_ball_point(self, x, r, *, return_length=False)\n--\n\nWhich points are no farther away than r?\n\n"
          "Parameters\n----------\nx : array_like, shape (..., m)\nr : float, or array_like that broadcasts to (...); "
          "not negative\nreturn_length : bool; how many, instead of which\n\nReturns\n-------\nlist of int, ascending, "
          "or an array of lists of shape (...); or int32 of shape (...)");
}

}  // namespace plumb::python
