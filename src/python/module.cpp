#include "python/rooms.hpp"

namespace {

namespace py = pybind11;

/// All that has no underscore, for `from plumb import *`.
py::list names_in(const py::module_& module) {
  py::list names;
  for (const auto& [name, what] : module.attr("__dict__").cast<py::dict>()) {
    if (!py::str(name).cast<std::string>().starts_with('_')) names.append(name);
  }
  return names;
}

}  // namespace

PYBIND11_MODULE(_plumb, module) {
  py::options texts;
  texts.disable_function_signatures();
  module.doc() = "What plumb has of C++; import plumb instead.";
  namespace rooms = plumb::python;
  for (void (*add)(py::module_&) :
       {rooms::add_errors, rooms::add_signs, rooms::add_mesh, rooms::add_bvh, rooms::add_figures,
        rooms::add_figure_questions, rooms::add_kd_tree, rooms::add_hull, rooms::add_surface, rooms::add_topology,
        rooms::add_exact_meshes, rooms::add_solids, rooms::add_planar, rooms::add_generated, rooms::add_fuzzing,
        rooms::add_heightfields, rooms::add_world, rooms::add_clash})
    add(module);
  module.attr("__all__") = names_in(module);
}
