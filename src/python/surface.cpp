#include <pybind11/stl.h>

#include "plumb/surface/repair/repair.hpp"
#include "plumb/surface/section/section.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/named.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"
#include "surface/topology/fault_words.hpp"

namespace plumb::python {
namespace {

py::dict shown_shell(const Shell& s) {
  py::dict d;
  d["first_triangle"] = s.first_triangle;
  d["triangles"] = s.triangles;
  d["closed"] = s.closed;
  d["oriented"] = s.oriented;
  d["volume"] = s.volume;
  d["volume_sign"] = static_cast<int>(s.volume_sign);
  d["depth"] = s.depth;
  d["parent"] = s.parent;
  d["inside_out"] = s.inside_out();
  d["internal_wall"] = s.wall;
  d["meets_another"] = s.meets;
  d["crosses_another"] = s.crosses;
  return d;
}

/// Members have the names that the program's JSON has for them.
py::object report_of(const SurfaceFaults& f, const MeshStatistics& statistics) {
  py::dict d;
  d["triangles"] = f.triangles;
  d["closed"] = f.closed;
  d["oriented"] = f.oriented;
  d["inside_out"] = f.inside_out();
  d["self_intersecting"] = f.meets_itself();
  d["touching"] = f.met.touching;
  d["overlapping"] = f.met.overlapping;
  d["degenerate_triangles"] = f.degenerate;
  d["shell_count"] = f.shells.size();
  d["closed_shells"] = f.closed_shells;
  d["inside_out_shells"] = f.inside_out_shells;
  d["crossing_shells"] = f.crossing_shells;
  d["internal_walls"] = f.internal_walls;
  d["open_edges"] = f.open_edges;
  d["repeated_vertices"] = f.repeated_vertices;
  d["non_manifold_edges"] = f.non_manifold_edges;
  d["non_manifold_vertices"] = f.non_manifold_vertices;
  d["vertices_on_edges"] = f.vertices_on_edges;
  d["duplicate_triangles"] = f.duplicate_triangles;
  d["opposite_triangles"] = f.opposite_triangles;
  if (f.nearer_than) {
    d["nearer_than"] = *f.nearer_than;
    d["close_vertices"] = f.close_vertices;
  }
  py::list defects, shells;
  for (const std::string_view name : surface_defects) {
    if (f.has(name)) defects.append(std::string(name));
  }
  for (const Shell& s : f.shells) shells.append(shown_shell(s));
  d["defects"] = defects;
  d["shells"] = shells;
  std::string text =
      "surface     " + surface::surface_verdict(f) + "\nwrong       " + surface::wrong_words(f, statistics);
  std::string lines = surface::shell_lines(f, "            ", ", in report[\"shells\"]");
  if (!lines.empty()) {
    lines.pop_back();
    text += "\nshells      " + lines;
  }
  return answer("MeshReport", d, text);
}

py::object check(const TriangleMesh& mesh, std::optional<double> nearer_than) {
  const auto [faults, statistics] = unlocked([&] {
    const MeshEdges edges = find_edges(mesh);
    const MeshStatistics counts = mesh_statistics(mesh, edges);
    return std::pair(find_faults(mesh, edges, counts, {.nearer_than = nearer_than, .progress = interruptible()}),
                     counts);
  });
  return report_of(faults, statistics);
}

RepairKind repair_kind_named(const std::string& name) {
  std::string names;
  for (std::size_t k = 0; k < repair_kinds; ++k) {
    const auto kind = static_cast<RepairKind>(k);
    if (name == name_of(kind)) return kind;
    names += (names.empty() ? "" : ", ") + std::string(name_of(kind));
  }
  throw py::value_error("repair: there is no step '" + name + "'; there are " + names);
}

/// A name, or a name and a number: the size of small components, the tolerance of any other.
RepairStep step_of(const py::handle& given) {
  if (py::isinstance<py::str>(given)) return {repair_kind_named(py::str(given))};
  if (!py::isinstance<py::tuple>(given) || py::len(given) != 2)
    throw py::type_error("repair: a step is a name, or a tuple of a name and a number");
  const auto pair = py::reinterpret_borrow<py::tuple>(given);
  RepairStep step{repair_kind_named(py::str(pair[0]))};
  const double number = number_of(pair[1], {"repair", "steps"});
  if (step.kind == RepairKind::small_components) {
    if (number < 0) throw py::value_error("repair: the size of small components is negative");
    step.size = static_cast<std::uint64_t>(number);
  } else {
    step.tolerance = number;
  }
  return step;
}

py::object repaired(const TriangleMesh& mesh, const py::object& steps, double tolerance) {
  std::vector<RepairStep> plan;
  if (steps.is_none()) {
    plan = printable_solid(tolerance);
  } else {
    for (const py::handle& step : py::iter(steps)) plan.push_back(step_of(step));
  }
  auto [done, statistics] = unlocked([&] {
    Repaired made = repair(mesh, plan, {.progress = interruptible()});
    const MeshStatistics counts = mesh_statistics(made.mesh, find_edges(made.mesh));
    return std::pair(std::move(made), counts);
  });
  py::list changes;
  for (const RepairChange& c : done.changes) {
    changes.append(answer("RepairChange", std::string(text_of(c.kind)), std::string(name_of(c.step)),
                          shown_member(c.place), c.count, c.distance, is_left(c.kind)));
  }
  return answer("Repaired", std::make_shared<TriangleMesh>(std::move(done.mesh)), changes,
                report_of(done.faults, statistics));
}

AnyPlane3 plane_of_python(const py::handle& given) {
  const AnyFigure& figure = figure_in(given, {"sections", "planes"});
  if (const auto* plane = get_if<Plane3>(figure)) return *plane;
  if (const auto* plane = get_if<ThreePointPlane3>(figure)) return *plane;
  throw py::value_error("sections: planes holds a figure that is no Plane3 or ThreePointPlane3");
}

py::list contours_of(const Section& cut) {
  py::list contours;
  for (const Contour& c : cut.contours) {
    std::vector<Point3> points;
    for (const SectionCorner& corner : c.corners) points.push_back(corner.nearest);
    contours.append(answer("Contour", array_of<double>(std::span<const Point3>(points)), c.closed,
                           static_cast<int>(c.turn), c.parent, c.depth));
  }
  return contours;
}

py::list cut(const TriangleMesh& mesh, const py::object& planes, const std::string& on_plane) {
  const auto side =
      named<OnPlane>({"sections", "on_plane"}, on_plane, {{"above", OnPlane::above}, {"below", OnPlane::below}});
  std::vector<AnyPlane3> all;
  for (const py::handle& plane : py::iter(planes)) all.push_back(plane_of_python(plane));
  const std::vector<Section> found = unlocked([&] { return sections(mesh, all, side); });
  py::list shown;
  for (const Section& one : found) shown.append(contours_of(one));
  return shown;
}

}  // namespace

void add_surface(py::module_& module) {
  module.def("check", check, py::arg("mesh"), py::arg("nearer_than") = py::none(),
             "check(mesh, nearer_than=None)\n--\n\nWhat is wrong with the surface of a mesh, decided exactly?\n\n"
             "Parameters\n----------\nmesh : Mesh\nnearer_than : float; vertices that are nearer count as close\n\n"
             "Returns\n-------\nMeshReport: a dict by the names that `plumb check --json` has, which prints");
  module.def(
      "repair", repaired, py::arg("mesh"), py::arg("steps") = py::none(), py::kw_only(), py::arg("tolerance") = 0.0,
      "repair(mesh, steps=None, *, tolerance=0.0)\n--\n\nWhat makes a mesh the surface of a solid, and what was "
      "changed?\n\nParameters\n----------\nmesh : Mesh\nsteps : sequence of names such as 'weld' or 'holes', or of "
      "(name, tolerance), or ('small-components', size); the default is a printable solid\ntolerance : float, of "
      "the default steps\n\nReturns\n-------\nRepaired\n\nRaises\n------\nValueError\n    If there is no such "
      "step, or a tolerance is negative.");
  module.def(
      "sections", cut, py::arg("mesh"), py::arg("planes"), py::kw_only(), py::arg("on_plane") = "above",
      "sections(mesh, planes, *, on_plane='above')\n--\n\nWhere do planes cut a mesh?\n\nParameters\n----------\n"
      "mesh : Mesh\nplanes : sequence of Plane3 or ThreePointPlane3\non_plane : 'above' or 'below'; where vertices "
      "in a plane count\n\nReturns\n-------\nlist of lists of Contour, one of each plane");
}

}  // namespace plumb::python
