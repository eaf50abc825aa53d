#include <memory>

#include "plumb/world/heightfield.hpp"
#include "python/figure_class.hpp"
#include "python/mesh.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

Heightfield field_of(const py::object& heights, const py::object& spacing, const py::object& origin) {
  constexpr const char* function = "Heightfield";
  const py::array given = numbers_of(heights, {function, "heights"});
  if (given.ndim() != 2) refuse({function, "heights"}, given, "shape (rows, columns)");
  const auto rows = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!rows) throw py::error_already_set();
  Heightfield field;
  field.columns = static_cast<std::size_t>(rows.shape(1));
  field.heights.assign(rows.data(), rows.data() + rows.size());
  read_member(field.spacing, spacing, {function, "spacing"});
  read_member(field.origin, origin, {function, "origin"});
  return field;
}

py::array rows_of_heights(const py::object& self) {
  const auto& field = self.cast<const Heightfield&>();
  const auto columns = static_cast<py::ssize_t>(field.columns);
  const auto rows = static_cast<py::ssize_t>(field.heights.size()) / columns;
  py::array_t<double> view({rows, columns}, field.heights.data(), self);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

py::tuple told_numbers(const Vector2& v) { return py::make_tuple(v.x, v.y); }
py::tuple told_numbers(const Point3& p) { return py::make_tuple(p.x, p.y, p.z); }

}  // namespace

void add_heightfields(py::module_& module) {
  py::class_<Heightfield>(
      module, "Heightfield",
      "Heightfield(heights, spacing=(1, 1), origin=(0, 0, 0))\n--\n\nA terrain of two triangles a cell.\n\n"
      "Parameters\n----------\nheights : array_like of float64, shape (rows, columns), two of each at least\n"
      "spacing : from column to column along x, and from row to row along y\n"
      "origin : of the corner in column 0 and row 0; heights are above it\n\n"
      "Raises\n------\nValueError\n    If there are fewer rows or columns, a number is not finite, or a spacing is "
      "zero.")
      .def(py::init([](const py::object& heights, const py::object& spacing, const py::object& origin) {
             auto field = std::make_unique<Heightfield>(field_of(heights, spacing, origin));
             static_cast<void>(mesh_of(*field));  // refuses what is none
             return field;
           }),
           py::arg("heights"), py::arg("spacing") = py::make_tuple(1, 1), py::arg("origin") = py::make_tuple(0, 0, 0))
      .def_property_readonly("heights", rows_of_heights,
                             "float64, shape (rows, columns): the field's own memory, read-only.")
      .def_property_readonly(
          "spacing", [](const Heightfield& self) { return told_numbers(self.spacing); }, "A pair of float.")
      .def_property_readonly(
          "origin", [](const Heightfield& self) { return told_numbers(self.origin); }, "Three of float.")
      .def(
          "mesh",
          [](const Heightfield& self) {
            const py::gil_scoped_release released;
            return std::make_shared<TriangleMesh>(mesh_of(self));
          },
          "mesh(self)\n--\n\nThe surface: the vertex of a corner has the number of its height, and cell c has the "
          "faces "
          "2 c and\n2 c + 1.\n\nReturns\n-------\nMesh")
      .def(
          "cell_of",
          [](const Heightfield& self, std::uint32_t face) {
            const HeightfieldCell cell = cell_of(self, face);
            return py::make_tuple(cell.row, cell.column);
          },
          py::arg("face"),
          "cell_of(self, face)\n--\n\nIn which cell is a face of the mesh?\n\nReturns\n-------\ntuple of the row and "
          "the "
          "column of its first corner")
      .def("__repr__",
           [](const Heightfield& self) {
             return "Heightfield(" + std::to_string(self.heights.size() / self.columns) + " rows, " +
                    std::to_string(self.columns) + " columns)";
           })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self),
                              py::make_tuple(self.attr("heights"), self.attr("spacing"), self.attr("origin")));
      });
}

}  // namespace plumb::python
