#include <pybind11/stl.h>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/surface/solid/evaluate.hpp"
#include "plumb/surface/solid/round.hpp"
#include "plumb/surface/solid/split.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/named.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

using Operation = ExactMesh (*)(std::span<const TriangleMesh>, WindingRule, Pieces);

Pieces pieces_of(bool merge) { return merge ? Pieces::of_polygons : Pieces::of_triangles; }

py::object shown(RoundedMesh r) {
  py::array_t<std::int32_t> rows(std::vector<py::ssize_t>{static_cast<py::ssize_t>(r.sources.size()), 2});
  std::int32_t* to = rows.mutable_data();
  for (const SourceFace& f : r.sources) {
    *to++ = static_cast<std::int32_t>(f.mesh);
    *to++ = static_cast<std::int32_t>(f.triangle);
  }
  return answer("Combined", std::make_shared<TriangleMesh>(std::move(r.mesh)), r.sound, r.moved, rows);
}

py::object combined(const char* name, Operation operation, const py::args& meshes, bool merge) {
  std::vector<TriangleMesh> solids;
  for (const py::handle& mesh : meshes) {
    if (!py::isinstance<TriangleMesh>(mesh)) throw py::type_error(std::string(name) + ": takes meshes alone");
    solids.push_back(mesh.cast<const TriangleMesh&>());
  }
  return shown(unlocked([&] { return round(operation(solids, WindingRule::positive, pieces_of(merge))); }));
}

py::object resolved(const TriangleMesh& mesh, const std::string& rule, bool merge) {
  const auto by = named<WindingRule>(
      {"resolve", "rule"}, rule,
      {{"odd", WindingRule::odd}, {"nonzero", WindingRule::nonzero}, {"positive", WindingRule::positive}});
  return shown(unlocked([&] { return round(resolve(mesh, by, pieces_of(merge))); }));
}

AnyPlane3 cutting_plane(const py::handle& given) {
  const AnyFigure& figure = figure_in(given, {"split", "plane"});
  if (const auto* plane = get_if<Plane3>(figure)) return *plane;
  if (const auto* plane = get_if<ThreePointPlane3>(figure)) return *plane;
  throw py::value_error("split: plane is a figure that is no Plane3 or ThreePointPlane3");
}

py::tuple halves(const TriangleMesh& mesh, const py::handle& plane) {
  const AnyPlane3 by = cutting_plane(plane);
  std::array<RoundedMesh, 2> made = unlocked([&] {
    const SplitSolid exact = split(resolve(mesh), by);
    return std::array{round(exact.above), round(exact.below)};
  });
  return py::make_tuple(shown(std::move(made[0])), shown(std::move(made[1])));
}

template <class... Shapes>
std::optional<Csg3> leaf_of(const AnyFigure& figure) {
  std::optional<Csg3> leaf;
  const auto take = [&](const auto* shape) {
    if (shape != nullptr) leaf = csg(*shape);
  };
  (take(get_if<Shapes>(figure)), ...);
  return leaf;
}

Csg3 tree_of_python(const py::handle& given) {
  if (py::isinstance<TriangleMesh>(given)) return csg(given.cast<const TriangleMesh&>());
  if (!py::isinstance<py::tuple>(given)) {
    const auto leaf = leaf_of<Aabb3, Obb3, Tetrahedron3, ConvexPolyhedron3>(figure_in(given, {"evaluate", "tree"}));
    if (leaf) return *leaf;
    throw py::value_error(
        "evaluate: tree holds a figure that is no solid with flat sides: it takes Aabb3, Obb3, Tetrahedron3, "
        "ConvexPolyhedron3 and meshes");
  }
  const auto parts = py::reinterpret_borrow<py::tuple>(given);
  if (parts.size() < 2 || !py::isinstance<py::str>(parts[0]))
    throw py::value_error("evaluate: a tuple of tree names an operation first, then solids, one at least");
  enum class Kind { unite, intersect, subtract, symmetric_difference };
  const auto kind = named<Kind>({"evaluate", "tree"}, parts[0].cast<std::string>(),
                                {{"unite", Kind::unite},
                                 {"intersect", Kind::intersect},
                                 {"subtract", Kind::subtract},
                                 {"symmetric_difference", Kind::symmetric_difference}});
  Csg3 tree = tree_of_python(parts[1]);
  for (std::size_t i = 2; i < parts.size(); ++i) {
    const Csg3 next = tree_of_python(parts[i]);
    if (kind == Kind::unite) tree = std::move(tree) | next;
    if (kind == Kind::intersect) tree = std::move(tree) & next;
    if (kind == Kind::subtract) tree = std::move(tree) - next;
    if (kind == Kind::symmetric_difference) tree = (tree - next) | (next - tree);
  }
  return tree;
}

py::object evaluated(const py::handle& given, bool merge) {
  const Csg3 tree = tree_of_python(given);
  return shown(unlocked([&] { return round(evaluate(tree, pieces_of(merge))); }));
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
  module.def(
      "resolve", &resolved, py::arg("mesh"), py::arg("rule") = "positive", py::kw_only(), py::arg("merge") = false,
      "resolve(mesh, rule='positive', *, merge=False)\n--\n\nWhich solid does a mesh that crosses itself "
      "bound?\n\nParameters\n----------\nmesh : Mesh, closed\nrule : 'positive', 'nonzero' or 'odd'; around what "
      "the surface winds so often is in the solid\nmerge : all that lies in one plane becomes as few triangles "
      "as can be\n\nReturns\n-------\nCombined\n\nRaises\n------\nValueError\n    If the mesh is open.");
  module.def("split", &halves, py::arg("mesh"), py::arg("plane"),
             "split(mesh, plane)\n--\n\nWhich solids are on the two sides of a plane?\n\nBoth have the same corners "
             "where they are cut.\n\nParameters\n----------\nmesh : Mesh, closed and wound outward\nplane : Plane3 or "
             "ThreePointPlane3\n\nReturns\n-------\ntuple of two of Combined, that on the normal's side first; sources "
             "of faces in the plane are -1\n\nRaises\n------\nValueError\n    If the mesh is open, or the plane has no "
             "normal.");
  module.def(
      "evaluate", &evaluated, py::arg("tree"), py::kw_only(), py::arg("merge") = false,
      "evaluate(tree, *, merge=False)\n--\n\nWhich solid does a tree of operations make?\n\nIt is exact however "
      "deep the tree is, and rounded once at the end.\n\nParameters\n----------\ntree : Mesh, closed and wound "
      "outward; figure that is a solid with flat sides; or tuple of 'unite', 'intersect', 'subtract' or "
      "'symmetric_difference' and the trees that it takes, in turn\nmerge : all that lies in one plane becomes as few "
      "triangles as can be\n\nReturns\n-------\nCombined, whose sources count the tree's leaves\n\nRaises\n------"
      "\nValueError\n    If a mesh is open, a figure is round or unbounded, or an operation is unknown.");
}

}  // namespace plumb::python
