#include <pybind11/stl.h>

#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

using Operation = ExactMesh (*)(std::span<const TriangleMesh>, WindingRule, Pieces);

py::object combined(const char* name, Operation operation, const py::args& meshes, bool merge) {
  std::vector<TriangleMesh> solids;
  for (const py::handle& mesh : meshes) {
    if (!py::isinstance<TriangleMesh>(mesh)) throw py::type_error(std::string(name) + ": takes meshes alone");
    solids.push_back(mesh.cast<const TriangleMesh&>());
  }
  RoundedMesh r = unlocked([&] {
    return round(operation(solids, WindingRule::positive, merge ? Pieces::of_polygons : Pieces::of_triangles));
  });
  std::vector<std::int32_t> sources;
  for (const SourceFace& f : r.sources)
    sources.insert(sources.end(), {static_cast<std::int32_t>(f.mesh), static_cast<std::int32_t>(f.triangle)});
  py::array_t<std::int32_t> rows(std::vector<py::ssize_t>{static_cast<py::ssize_t>(r.sources.size()), 2});
  std::copy(sources.begin(), sources.end(), rows.mutable_data());
  return answer("Combined", std::make_shared<TriangleMesh>(std::move(r.mesh)), r.sound, r.moved, rows);
}

}  // namespace

void add_solids(py::module_& module) {
  const auto add = [&module](const char* name, Operation operation, const std::string& question) {
    module.def(
        name,
        [name, operation](const py::args& meshes, bool merge) { return combined(name, operation, meshes, merge); },
        py::kw_only(), py::arg("merge") = false,
        (std::string(name) + "(*meshes, merge=False)\n--\n\n" + question +
         "\n\nThe solids are those that the closed meshes bound; the result is exact before it is rounded once.\n\n"
         "Parameters\n----------\n*meshes : Mesh, closed and wound outward\nmerge : all that lies in one "
         "plane becomes as few triangles as can be\n\nReturns\n-------\nCombined\n\n"
         "Raises\n------\nValueError\n    If a mesh is open or its triangles run against each other; the text names "
         "an edge.")
            .c_str());
  };
  add("unite", &unite, "Which solid is all that is in any of these?");
  add("intersect", &intersect, "Which solid is all that is in each of these?");
  add("subtract", &subtract, "Which solid is all that is in the first of these, and in none of the others?");
  add("symmetric_difference", &symmetric_difference, "Which solid is all that is in an odd number of these?");
}

}  // namespace plumb::python
