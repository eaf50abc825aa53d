#include <optional>
#include <vector>

#include "c/figures.hpp"
#include "c/solids.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/surface/solid/evaluate.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

namespace {

template <class... Shapes>
std::optional<Csg3> flat_leaf(const AnyFigure& figure) {
  std::optional<Csg3> leaf;
  const auto take = [&](const auto* shape) {
    if (shape != nullptr) leaf = csg(*shape);
  };
  (take(get_if<Shapes>(figure)), ...);
  return leaf;
}

Csg3 leaf_in(const plumb_tree_step& step, const std::string& name) {
  if (step.mesh != nullptr && step.figure != nullptr)
    throw c::InvalidArgument(name + " has a mesh and a figure: a leaf is one of them");
  if (step.mesh != nullptr) return csg(step.mesh->mesh);
  const AnyFigure figure = c::figure_of(step.figure, name.c_str());
  if (!figure.is_posed()) {
    if (const auto leaf = flat_leaf<Aabb3, Obb3, Tetrahedron3, ConvexPolyhedron3>(figure)) return *leaf;
  }
  throw Unsupported(name +
                    " is a figure that is no solid with flat sides, or not as it stands: a tree takes boxes, "
                    "tetrahedra, polyhedra and meshes");
}

Csg3 joined(int operation, Csg3 tree, const Csg3& next, const std::string& name) {
  switch (operation) {
    case PLUMB_UNITE:
      return std::move(tree) | next;
    case PLUMB_INTERSECT:
      return std::move(tree) & next;
    case PLUMB_SUBTRACT:
      return std::move(tree) - next;
    case PLUMB_SYMMETRIC_DIFFERENCE:
      return (tree - next) | (next - tree);
    default:
      break;
  }
  throw c::InvalidArgument(name + " has operation " + std::to_string(operation) + ", which is none");
}

Csg3 tree_of(std::span<const plumb_tree_step> steps) {
  std::vector<Csg3> made;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const plumb_tree_step& step = steps[i];
    const std::string name = "steps[" + std::to_string(i) + "]";
    if (step.mesh != nullptr || step.figure != nullptr) {
      made.push_back(leaf_in(step, name));
      continue;
    }
    if (step.operands == 0 || step.operands > made.size()) {
      throw c::InvalidArgument(name + " takes " + std::to_string(step.operands) + " operands, but before it are " +
                               std::to_string(made.size()));
    }
    const auto first = made.end() - static_cast<std::ptrdiff_t>(step.operands);
    Csg3 tree = *first;
    for (auto next = first + 1; next != made.end(); ++next) tree = joined(step.operation, std::move(tree), *next, name);
    made.erase(first, made.end());
    made.push_back(std::move(tree));
  }
  if (made.size() == 1) return made.front();
  throw c::InvalidArgument("steps make " + std::to_string(made.size()) + " trees instead of one");
}

}  // namespace

extern "C" plumb_status plumb_evaluate(const plumb_tree_step* steps, std::size_t count, int merges, plumb_mesh** result,
                                       plumb_solid_report* report) {
  return guarded("plumb_evaluate", [&] {
    need(steps, count, "steps");
    need(result, "result");
    if (report != nullptr) need_size(report, "report");
    *result = c::told_solid(round(evaluate(tree_of({steps, count}), c::pieces_of(merges))), report);
  });
}
