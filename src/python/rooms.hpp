// What is in the module?  A function for each of its rooms, which adds what the room has.
//
// Source: none.
// Cost: once, when Python imports it.
#pragma once

#include <pybind11/pybind11.h>

namespace plumb::python {

void add_errors(pybind11::module_& module);
void add_signs(pybind11::module_& module);
void add_mesh(pybind11::module_& module);
void add_bvh(pybind11::module_& module);
void add_figures(pybind11::module_& module);
void add_figure_questions(pybind11::module_& module);
void add_kd_tree(pybind11::module_& module);
void add_hull(pybind11::module_& module);
void add_planar(pybind11::module_& module);
void add_solids(pybind11::module_& module);
void add_exact_meshes(pybind11::module_& module);
void add_surface(pybind11::module_& module);
void add_topology(pybind11::module_& module);
void add_generated(pybind11::module_& module);
void add_fuzzing(pybind11::module_& module);
void add_heightfields(pybind11::module_& module);
void add_world(pybind11::module_& module);
void add_clash(pybind11::module_& module);

}  // namespace plumb::python
