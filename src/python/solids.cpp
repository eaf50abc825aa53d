#include "python/solids.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/surface/solid/evaluate.hpp"
#include "plumb/surface/solid/split.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/named.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

/// The same operation of meshes as given, and of exact ones.
struct Operation {
  const char* name;
  ExactMesh (*of_meshes)(std::span<const TriangleMesh>, WindingRule, Pieces);
  ExactMesh (*of_exact)(std::span<const ExactMesh>, WindingRule, Pieces);
};

/// Tells what work() makes, an ExactMesh or several, as it is or rounded.
template <class Work>
py::object made_by(const Work& work, bool exact) {
  if (exact) return py::cast(std::make_shared<ExactMesh>(unlocked(work)));
  return shown(unlocked([&] { return round(work()); }));
}

/// f(mesh), of one as given or of an exact one.
template <class F>
auto with_mesh(const py::handle& given, const char* function, const F& f) {
  if (py::isinstance<TriangleMesh>(given)) return f(given.cast<const TriangleMesh&>());
  if (py::isinstance<ExactMesh>(given)) return f(given.cast<const ExactMesh&>());
  throw py::type_error(std::string(function) + ": takes a Mesh or an ExactMesh");
}

py::object combined(const Operation& operation, const py::args& meshes, bool merge, bool exact) {
  const Pieces pieces = pieces_of(merge);
  const auto is_exact = [](const py::handle& mesh) { return py::isinstance<ExactMesh>(mesh); };
  if (std::none_of(meshes.begin(), meshes.end(), is_exact)) {
    std::vector<TriangleMesh> solids;
    for (const py::handle& mesh : meshes) {
      if (!py::isinstance<TriangleMesh>(mesh))
        throw py::type_error(std::string(operation.name) + ": takes meshes alone");
      solids.push_back(mesh.cast<const TriangleMesh&>());
    }
    return made_by([&] { return operation.of_meshes(solids, WindingRule::positive, pieces); }, exact);
  }
  struct AsExact {
    ExactMesh operator()(const TriangleMesh& mesh) const { return exact_mesh(mesh); }
    ExactMesh operator()(const ExactMesh& mesh) const { return mesh; }
  };
  std::vector<ExactMesh> solids;
  for (const py::handle& mesh : meshes) solids.push_back(with_mesh(mesh, operation.name, AsExact{}));
  return made_by([&] { return operation.of_exact(solids, WindingRule::positive, pieces); }, exact);
}

py::object resolved(const py::handle& given, const std::string& rule, bool merge, bool exact) {
  const auto by = named<WindingRule>(
      {"resolve", "rule"}, rule,
      {{"odd", WindingRule::odd}, {"nonzero", WindingRule::nonzero}, {"positive", WindingRule::positive}});
  return with_mesh(given, "resolve", [&](const auto& mesh) {
    return made_by([&] { return resolve(mesh, by, pieces_of(merge)); }, exact);
  });
}

AnyPlane3 cutting_plane(const py::handle& given) {
  const AnyFigure& figure = figure_in(given, {"split", "plane"});
  if (const auto* plane = get_if<Plane3>(figure)) return *plane;
  if (const auto* plane = get_if<ThreePointPlane3>(figure)) return *plane;
  throw py::value_error("split: plane is a figure that is no Plane3 or ThreePointPlane3");
}

py::tuple halves(const py::handle& given, const py::handle& plane, bool exact) {
  const AnyPlane3 by = cutting_plane(plane);
  SplitSolid made =
      with_mesh(given, "split", [&](const auto& mesh) { return unlocked([&] { return split(resolve(mesh), by); }); });
  const auto half = [exact](ExactMesh& of) { return made_by([&of] { return std::move(of); }, exact); };
  return py::make_tuple(half(made.above), half(made.below));
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

py::object evaluated(const py::handle& given, bool merge, bool exact) {
  const Csg3 tree = tree_of_python(given);
  return made_by([&] { return evaluate(tree, pieces_of(merge)); }, exact);
}

}  // namespace

py::array_t<std::int32_t> told_sources(const std::vector<SourceFace>& sources) {
  py::array_t<std::int32_t> rows(std::vector<py::ssize_t>{static_cast<py::ssize_t>(sources.size()), 2});
  std::int32_t* to = rows.mutable_data();
  for (const SourceFace& f : sources) {
    *to++ = static_cast<std::int32_t>(f.mesh);
    *to++ = static_cast<std::int32_t>(f.triangle);
  }
  return rows;
}

py::object shown(RoundedMesh rounded) {
  return answer("Combined", std::make_shared<TriangleMesh>(std::move(rounded.mesh)), rounded.sound, rounded.moved,
                told_sources(rounded.sources));
}

void add_solids(py::module_& module) {
  const auto add = [&module](const Operation& operation, const std::string& question) {
    module.def(
        operation.name,
        [operation](const py::args& meshes, bool merge, bool exact) {
          return combined(operation, meshes, merge, exact);
        },
        py::kw_only(), py::arg("merge") = false, py::arg("exact") = false,
        (std::string(operation.name) + "(*meshes, merge=False, exact=False)\n--\n\n" + question +
         "\n\nThe solids are those that the closed meshes bound; the result is exact before it is rounded once.\n\n"
         "Parameters\n----------\n*meshes : Mesh or ExactMesh, closed and wound outward\nmerge : all that lies in one "
         "plane becomes as few triangles as can be\nexact : not rounded\n\nReturns\n-------\nCombined; where exact, "
         "ExactMesh\n\nRaises\n------\nValueError\n    If a mesh is open or its triangles run against each other; the "
         "text names an edge.")
            .c_str());
  };
  add({"unite", &unite, &unite}, "Which solid is all that is in any of these?");
  add({"intersect", &intersect, &intersect}, "Which solid is all that is in each of these?");
  add({"subtract", &subtract, &subtract},
      "Which solid is all that is in the first of these, and in none of the others?");
  add({"symmetric_difference", &symmetric_difference, &symmetric_difference},
      "Which solid is all that is in an odd number of these?");
  module.def(
      "resolve", &resolved, py::arg("mesh"), py::arg("rule") = "positive", py::kw_only(), py::arg("merge") = false,
      py::arg("exact") = false,
      "resolve(mesh, rule='positive', *, merge=False, exact=False)\n--\n\nWhich solid does a mesh that crosses itself "
      "bound?\n\nParameters\n----------\nmesh : Mesh or ExactMesh, closed\nrule : 'positive', 'nonzero' or 'odd'; "
      "around what the surface winds so often is in the solid\nmerge : all that lies in one plane becomes as few "
      "triangles as can be\nexact : not rounded\n\nReturns\n-------\nCombined; where exact, "
      "ExactMesh\n\nRaises\n------\n"
      "ValueError\n    If the mesh is open.");
  module.def("split", &halves, py::arg("mesh"), py::arg("plane"), py::kw_only(), py::arg("exact") = false,
             "split(mesh, plane, *, exact=False)\n--\n\nWhich solids are on the two sides of a plane?\n\nBoth have the "
             "same corners where they are cut.\n\nParameters\n----------\nmesh : Mesh or ExactMesh, closed and wound "
             "outward\nplane : Plane3 or ThreePointPlane3\nexact : not rounded\n\nReturns\n-------\ntuple of two of "
             "Combined, where exact of ExactMesh, that on the normal's side first; sources of faces in the plane are "
             "-1\n\nRaises\n------\nValueError\n    If the mesh is open, or the plane has no normal.");
  module.def(
      "evaluate", &evaluated, py::arg("tree"), py::kw_only(), py::arg("merge") = false, py::arg("exact") = false,
      "evaluate(tree, *, merge=False, exact=False)\n--\n\nWhich solid does a tree of operations make?\n\nIt is exact "
      "however deep the tree is, and rounded once at the end.\n\nParameters\n----------\ntree : Mesh, closed and wound "
      "outward; figure that is a solid with flat sides; or tuple of 'unite', 'intersect', 'subtract' or "
      "'symmetric_difference' and the trees that it takes, in turn\nmerge : all that lies in one plane becomes as few "
      "triangles as can be\nexact : not rounded\n\nReturns\n-------\nCombined, or where exact ExactMesh, whose sources "
      "count the tree's leaves\n\nRaises\n------\nValueError\n    If a mesh is open, a figure is round or unbounded, "
      "or "
      "an operation is unknown.");
}

}  // namespace plumb::python
