#include <pybind11/stl.h>

#include "plumb/surface/repair/merge_coplanar.hpp"
#include "plumb/surface/repair/weld.hpp"
#include "plumb/surface/topology/components.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/named.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

py::array_t<std::int32_t> components_of(const TriangleMesh& mesh, const std::string& over) {
  const auto by = named<JoinedOver>({"components", "over"}, over,
                                    {{"manifold-edges", JoinedOver::manifold_edges},
                                     {"edges", JoinedOver::edges},
                                     {"vertices", JoinedOver::vertices}});
  const Components found = unlocked([&] { return connected_components(mesh, find_edges(mesh), by); });
  return array_of<std::int32_t>(std::span<const std::uint32_t>(found.of));
}

py::list loops_of(const TriangleMesh& mesh) {
  py::list out;
  for (const BoundaryLoop& loop : unlocked([&] { return boundary_loops(mesh, find_edges(mesh)); }))
    out.append(
        answer("BoundaryLoop", array_of<std::int32_t>(std::span<const std::uint32_t>(loop.vertices)), loop.closed));
  return out;
}

py::list kinds_of(const TriangleMesh& mesh) {
  py::list out;
  for (const SurfaceKind& k : unlocked([&] { return surface_kinds(mesh, find_edges(mesh)); }))
    out.append(answer("SurfaceKind", k.vertices, k.edges, k.faces, k.loops, k.orientable, k.euler(), k.genus()));
  return out;
}

py::object welded_of(const TriangleMesh& mesh, double tolerance, const std::string& rule,
                     const std::string& turned_over) {
  const WeldOptions options{
      tolerance,
      named<WeldRule>({"weld", "rule"}, rule, {{"clusters", WeldRule::clusters}, {"chains", WeldRule::chains}}),
      named<TurnedOver>({"weld", "turned_over"}, turned_over,
                        {{"refused", TurnedOver::refused}, {"kept", TurnedOver::kept}})};
  auto [weld, made] = unlocked([&] {
    Weld found = find_weld(mesh, options);
    TriangleMesh result = welded(mesh, found);
    return std::pair(std::move(found), std::move(result));
  });
  py::list merged;
  for (const MergedVertex& m : weld.merged) merged.append(answer("MergedVertex", m.vertex, m.into, m.distance));
  const auto numbers = [](const std::vector<std::uint32_t>& of) {
    return array_of<std::int32_t>(std::span<const std::uint32_t>(of));
  };
  return answer("Welded", std::make_shared<TriangleMesh>(std::move(made)), numbers(weld.into), merged,
                numbers(weld.collapsed), numbers(weld.turned), numbers(weld.refused));
}

py::object coplanar_of(const TriangleMesh& mesh, double tolerance, const std::string& collinear) {
  const CoplanarOptions options{tolerance, named<CollinearVertices>({"merge_coplanar", "collinear"}, collinear,
                                                                    {{"kept", CollinearVertices::kept},
                                                                     {"dropped", CollinearVertices::dropped}})};
  auto [found, made] = unlocked([&] {
    CoplanarFaces faces = merge_coplanar(mesh, options);
    TriangleMesh fewer = triangulated(mesh, faces);
    return std::pair(std::move(faces), std::move(fewer));
  });
  py::list faces;
  for (std::uint32_t f = 0; f < found.size(); ++f) {
    py::list rings;
    for (const auto ring : found.rings_of(f)) rings.append(array_of<std::int32_t>(ring));
    faces.append(answer("CoplanarFace", rings, array_of<std::int32_t>(found.triangles_of(f)), found.plane[f]));
  }
  return answer("CoplanarFaces", faces, array_of<std::int32_t>(std::span<const std::uint32_t>(found.apart)),
                std::make_shared<TriangleMesh>(std::move(made)));
}

}  // namespace

void add_topology(py::module_& module) {
  module.def("components", components_of, py::arg("mesh"), py::arg("over") = "manifold-edges",
             "components(mesh, over='manifold-edges')\n--\n\nOf how many pieces is a mesh?\n\nParameters\n----------\n"
             "mesh : Mesh\nover : 'manifold-edges' (those of two triangles), 'edges' or 'vertices': what joins "
             "triangles\n\nReturns\n-------\nint32, shape (n,): the piece of each triangle, numbered by their first");
  module.def("boundary_loops", loops_of, py::arg("mesh"),
             "boundary_loops(mesh)\n--\n\nWhere does a surface end?\n\nParameters\n----------\nmesh : Mesh\n\n"
             "Returns\n-------\nlist of BoundaryLoop, by their first edges; each boundary edge is in one");
  module.def("surface_kinds", kinds_of, py::arg("mesh"),
             "surface_kinds(mesh)\n--\n\nWhat kind of surface is each component over manifold edges?\n\nParameters\n"
             "----------\nmesh : Mesh\n\nReturns\n-------\nlist of SurfaceKind: Euler's characteristic, genus, loops");
  module.def(
      "weld", welded_of, py::arg("mesh"), py::arg("tolerance") = 0.0, py::kw_only(), py::arg("rule") = "clusters",
      py::arg("turned_over") = "refused",
      "weld(mesh, tolerance=0.0, *, rule='clusters', turned_over='refused')\n--\n\nWhich vertices are one and the "
      "same, and what becomes of the triangles?\n\nEqual vertices are always one; the order of vertices changes no "
      "group.\n\nParameters\n----------\nmesh : Mesh\ntolerance : float, a length\nrule : 'clusters' (none wider than "
      "the tolerance) or 'chains' (all that short steps connect)\nturned_over : 'refused' or 'kept': triangles that "
      "welding would turn over\n\nReturns\n-------\nWelded\n\nRaises\n------\nValueError\n    If the tolerance is "
      "negative, infinite or NaN.");
  module.def("merge_coplanar", coplanar_of, py::arg("mesh"), py::arg("tolerance") = 0.0, py::kw_only(),
             py::arg("collinear") = "kept",
             "merge_coplanar(mesh, tolerance=0.0, *, collinear='kept')\n--\n\nWhich neighboring triangles lie in one "
             "plane, and which polygons with holes do they make up?\n\nParameters\n----------\nmesh : Mesh\n"
             "tolerance : float, a length; 0 is exactly in one plane\ncollinear : 'kept' or 'dropped': vertices that "
             "all polygons run straight through\n\nReturns\n-------\nCoplanarFaces\n\nRaises\n------\nValueError\n"
             "    If the tolerance is negative, infinite or NaN.");
}

}  // namespace plumb::python
