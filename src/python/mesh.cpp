#include "python/mesh.hpp"

#include <cstdint>
#include <limits>

#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

using Triangle = TriangleMesh::Triangle;

/// Integers of any width, each the number of a vertex.
std::vector<Triangle> triangles_of(const py::handle& given, std::size_t vertices) {
  const Asked asked{"Mesh", "faces"};
  const py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::type_error("Mesh: faces is no array of integers");
  }
  if (array.size() == 0 && array.ndim() == 1) return {};
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u') {
    throw py::type_error("Mesh: faces has " + told(array) + "; expected integers of shape (n, 3)");
  }
  if (array.ndim() != 2 || array.shape(1) != 3) refuse(asked, array, "integers of shape (n, 3)");
  const bool large = kind == 'u' && array.itemsize() == 8;  // beyond int64 is no vertex
  if (large && array.size() != 0 && array.attr("max")().cast<std::uint64_t>() >= vertices) {
    throw py::value_error("Mesh: faces names a vertex beyond the " + std::to_string(vertices) + " that there are");
  }
  const auto rows = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!rows) throw py::error_already_set();
  std::vector<Triangle> triangles(static_cast<std::size_t>(rows.shape(0)));
  const std::int64_t* at = rows.data();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k, ++at) {
      if (*at < 0 || static_cast<std::uint64_t>(*at) >= vertices) {
        throw py::value_error("Mesh: faces[" + std::to_string(i) + ", " + std::to_string(k) + "] is " +
                              std::to_string(*at) + ", but there are " + std::to_string(vertices) + " vertices");
      }
      triangles[i][k] = static_cast<std::uint32_t>(*at);
    }
  }
  return triangles;
}

SharedMesh mesh_of(const py::handle& vertices, const py::handle& faces) {
  auto mesh = std::make_shared<TriangleMesh>();
  const py::array_t<double> rows = rows_of(vertices, {"Mesh", "vertices"}, 3);
  const std::span<const Point3> points = points_of<Point3>(rows);
  if (points.size() > std::numeric_limits<std::int32_t>::max()) throw py::value_error("Mesh: too many vertices");
  mesh->vertices.assign(points.begin(), points.end());
  mesh->triangles = triangles_of(faces, mesh->vertices.size());
  return mesh;
}

SharedMesh read(const py::handle& path) {
  const std::string name = path_of(path);
  const py::gil_scoped_release released;
  return std::make_shared<TriangleMesh>(read_mesh(name));
}

}  // namespace

std::string path_of(const py::handle& given) { return py::str(py::module_::import("os").attr("fspath")(given)); }

void add_mesh(py::module_& module) {
  py::class_<TriangleMesh, std::shared_ptr<TriangleMesh>>(
      module, "Mesh",
      "Mesh(vertices, faces)\n--\n\nTriangles over vertices; nothing is assumed of their shape.\n\n"
      "Parameters\n----------\nvertices : array_like of float64, shape (n, 3)\n"
      "faces : array_like of integers, shape (m, 3), the numbers of vertices, counterclockwise seen from outside\n\n"
      "Raises\n------\nValueError\n    If a shape is another, a coordinate is not finite, or a face names no vertex.")
      .def(py::init([](const py::object& vertices, const py::object& faces) {
             return std::const_pointer_cast<TriangleMesh>(mesh_of(vertices, faces));
           }),
           py::arg("vertices"), py::arg("faces"))
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return view_of<double>(std::span<const Point3>(self.cast<const TriangleMesh&>().vertices), self);
          },
          "float64, shape (n, 3): the mesh's own memory, read-only.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return view_of<std::int32_t>(std::span<const Triangle>(self.cast<const TriangleMesh&>().triangles), self);
          },
          "int32, shape (m, 3): the mesh's own memory, read-only.")
      .def(
          "write",
          [](const TriangleMesh& self, const py::object& path) {
            const std::string name = path_of(path);
            const py::gil_scoped_release released;
            write_mesh(name, self);
          },
          py::arg("path"),
          "write(self, path)\n--\n\nWrites a file, whose name tells the format: OBJ, OFF, STL or PLY.  It appears "
          "whole or not "
          "at all.")
      .def("__eq__",
           [](const TriangleMesh& self, const py::object& other) {
             if (!py::isinstance<TriangleMesh>(other)) return false;
             const auto& mesh = other.cast<const TriangleMesh&>();
             return self.vertices == mesh.vertices && self.triangles == mesh.triangles;
           })
      .def("__repr__",
           [](const TriangleMesh& self) {
             return "Mesh(" + std::to_string(self.vertices.size()) + " vertices, " +
                    std::to_string(self.triangles.size()) + " faces)";
           })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("vertices"), self.attr("faces")));
      });
  module.def(
      "read_mesh", [](const py::object& path) { return std::const_pointer_cast<TriangleMesh>(read(path)); },
      py::arg("path"),
      "read_mesh(path)\n--\n\nThe mesh of a file: OBJ, OFF, STL, PLY, 3MF, glTF or GLB, each also packed by gzip.\n\n"
      "Polygons are triangulated; no coordinate and no face is changed.\n\nRaises\n------\nFileNotFoundError, OSError\n"
      "    If it cannot be read.\nValueError\n    If it is not as its format has it; the text names file, line and "
      "mend.");
}

}  // namespace plumb::python
