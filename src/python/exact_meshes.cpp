// Solids whose corners are exact: they go from operation to operation, and are rounded where the chain ends.
#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>

#include "plumb/surface/solid/exact_mesh.hpp"
#include "plumb/surface/solid/intersection_curves.hpp"
#include "python/figure_class.hpp"
#include "python/fractions.hpp"
#include "python/rooms.hpp"
#include "python/solids.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

/// f(pose), of a pose of space.
template <class F>
auto with_pose(const AnyPose& pose, const F& f) {
  if (const auto* by = std::get_if<Pose>(&pose)) return f(PoseView(*by));
  if (const auto* by = std::get_if<RigidPose>(&pose)) return f(PoseView(*by));
  return f(PoseView(identity_pose));
}

std::shared_ptr<ExactMesh> exact_of(const py::object& mesh, const py::object& pose, const py::object& turn,
                                    const py::object& translation) {
  const AnyPose by = pose_of(3, pose, turn, translation, "ExactMesh");
  const auto image = [&by](const auto& of) {
    return std::make_shared<ExactMesh>(
        unlocked([&] { return with_pose(by, [&of](PoseView view) { return exact_mesh(of, view); }); }));
  };
  if (py::isinstance<TriangleMesh>(mesh)) return image(mesh.cast<const TriangleMesh&>());
  if (py::isinstance<ExactMesh>(mesh)) return image(mesh.cast<const ExactMesh&>());
  throw py::type_error("ExactMesh: mesh is no Mesh and no ExactMesh");
}

py::array_t<double> rounded_places(std::span<const ExactPoint3> points) {
  std::vector<Point3> places;
  places.reserve(points.size());
  for (const ExactPoint3& p : points) places.push_back(approximate(p));
  return array_of<double>(std::span<const Point3>(places));
}
py::list exact_places(std::span<const ExactPoint3> points) {
  py::list places;
  for (const ExactPoint3& p : points) places.append(fractions_of(rational_point(p)));
  return places;
}

/// Three doubles of a vertex that they hold, else three texts of its coordinates.
py::tuple state_of(const ExactMesh& mesh) {
  py::list vertices;
  for (const ExactPoint3& p : mesh.vertices) {
    if (const auto* given = std::get_if<Point3>(&p.as())) {
      vertices.append(py::make_tuple(given->x, given->y, given->z));
      continue;
    }
    const RationalPoint3 exact = rational_point(p);
    vertices.append(py::make_tuple(exact.x.text(), exact.y.text(), exact.z.text()));
  }
  return py::make_tuple(vertices, array_of<std::uint32_t>(std::span<const TriangleMesh::Triangle>(mesh.triangles)),
                        array_of<std::uint32_t>(std::span<const SourceFace>(mesh.sources)));
}

template <class Item>
std::vector<Item> items_of(const py::handle& given) {
  const auto rows = given.cast<py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>>();
  std::vector<Item> items(static_cast<std::size_t>(rows.size()) * sizeof(std::uint32_t) / sizeof(Item));
  if (!items.empty()) std::memcpy(items.data(), rows.data(), items.size() * sizeof(Item));
  return items;
}

std::shared_ptr<ExactMesh> mesh_of_state(const py::tuple& state) {
  if (state.size() != 3) throw py::value_error("ExactMesh: what was pickled is none of this version");
  auto mesh = std::make_shared<ExactMesh>();
  for (const py::handle& given : state[0]) {
    const auto p = given.cast<py::tuple>();
    if (py::isinstance<py::str>(p[0])) {
      const auto number = [&p](std::size_t k) { return Rational::from_text(p[k].cast<std::string>()); };
      mesh->vertices.emplace_back(RationalPoint3{number(0), number(1), number(2)});
    } else {
      mesh->vertices.emplace_back(Point3{p[0].cast<double>(), p[1].cast<double>(), p[2].cast<double>()});
    }
  }
  mesh->triangles = items_of<TriangleMesh::Triangle>(state[1]);
  mesh->sources = items_of<SourceFace>(state[2]);
  const auto is_vertex = [n = mesh->vertices.size()](std::uint32_t v) { return v < n; };
  const bool are_faces = std::all_of(mesh->triangles.begin(), mesh->triangles.end(),
                                     [&](const auto& t) { return std::all_of(t.begin(), t.end(), is_vertex); });
  if (!are_faces || mesh->sources.size() != mesh->triangles.size())
    throw py::value_error("ExactMesh: what was pickled has faces without a vertex or a source");
  return mesh;
}

bool are_equal(const ExactMesh& a, const ExactMesh& b) {
  return a.triangles == b.triangles && a.vertices.size() == b.vertices.size() &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(),
                    [](const ExactPoint3& p, const ExactPoint3& q) { return std::is_eq(p <=> q); });
}

py::list curves(const TriangleMesh& a, const TriangleMesh& b, bool exact) {
  py::list all;
  for (const IntersectionCurve& c : unlocked([&] { return intersection_curves(a, b); })) {
    const py::object points = exact ? py::object(exact_places(c.points)) : py::object(rounded_places(c.points));
    const std::span<const std::array<std::uint32_t, 2>> faces(c.faces);
    all.append(answer("IntersectionCurve", points, c.closed, array_of<std::int32_t>(faces)));
  }
  return all;
}

}  // namespace

void add_exact_meshes(py::module_& module) {
  py::class_<ExactMesh, std::shared_ptr<ExactMesh>>(
      module, "ExactMesh",
      "ExactMesh(mesh, *, pose=None, turn=None, translation=None)\n--\n\nA surface with exact corners: a mesh, or its "
      "image under a pose, which is not rounded.\n\nunite and its like take them beside meshes, and make them where "
      "exact=True: so a chain of operations is\nrounded once, at its end.\n\nParameters\n----------\nmesh : Mesh or "
      "ExactMesh\npose : array_like of float64, shape (4, 4)\nturn : array_like of float64, shape (4,), a quaternion "
      "w, x, y, z of any length\ntranslation : array_like of float64, shape (3,)\n\nRaises\n------\nValueError\n    If "
      "a "
      "number is not finite, or the turn is zero.")
      .def(py::init(&exact_of), py::arg("mesh"), py::kw_only(), py::arg("pose") = py::none(),
           py::arg("turn") = py::none(), py::arg("translation") = py::none())
      .def_property_readonly(
          "vertices", [](const ExactMesh& self) { return rounded_places(self.vertices); },
          "float64, shape (n, 3): each coordinate is rounded once.  Exactly they ascend, no two equal.")
      .def_property_readonly(
          "faces",
          [](const ExactMesh& self) {
            return array_of<std::int32_t>(std::span<const TriangleMesh::Triangle>(self.triangles));
          },
          "int32, shape (m, 3)")
      .def_property_readonly(
          "sources", [](const ExactMesh& self) { return told_sources(self.sources); },
          "int32, shape (m, 2): of each face, which mesh of the last operation and which face of it it is a piece of.")
      .def_property_readonly(
          "volume",
          [](const ExactMesh& self) {
            const Rational volume = unlocked([&] { return exact_volume(self); });
            return fraction_of(volume);
          },
          "Fraction: of the solid that a closed mesh bounds, negative where it is wound inward.")
      .def(
          "exact_vertices", [](const ExactMesh& self) { return exact_places(self.vertices); },
          "exact_vertices(self)\n--\n\nThe corners as they are: a list of tuples of three Fraction.")
      .def(
          "round",
          [](const ExactMesh& self, std::uint32_t rounds) {
            return shown(unlocked([&] { return round(self, {.rounds = rounds}); }));
          },
          py::arg("rounds") = 24,
          "round(self, rounds=24)\n--\n\nWhich mesh of doubles stands for it, and is that sound?\n\nReturns\n-------\n"
          "Combined\n\nRaises\n------\nValueError\n    If the mesh is open.")
      .def("__eq__",
           [](const ExactMesh& self, const py::object& other) {
             return py::isinstance<ExactMesh>(other) && are_equal(self, other.cast<const ExactMesh&>());
           })
      .def("__repr__",
           [](const ExactMesh& self) {
             return "ExactMesh(" + std::to_string(self.vertices.size()) + " vertices, " +
                    std::to_string(self.triangles.size()) + " faces)";
           })
      .def(py::pickle(&state_of, &mesh_of_state));
  module.def(
      "intersection_curves", &curves, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("exact") = false,
      "intersection_curves(a, b, *, exact=False)\n--\n\nWhere do two surfaces meet?  Polylines, closed or open, "
      "and points where they touch.\n\nOf areas that lie in faces of both, the boundaries are told.\n\nParameters\n"
      "----------\na, b : Mesh, each may be open, closed, or cross itself\nexact : points are lists of tuples of "
      "three Fraction, not rounded\n\nReturns\n-------\nlist of IntersectionCurve");
}

}  // namespace plumb::python
