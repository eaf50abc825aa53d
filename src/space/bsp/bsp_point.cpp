#include "plumb/space/bsp/bsp_point.hpp"

#include <algorithm>
#include <string>

#include "certify/finite.hpp"
#include "plumb/arith/error.hpp"
#include "space/bsp/plane_side.hpp"

namespace plumb {
namespace {

/// Visits the leaves whose closed set holds the point.
template <class Visit>
void visit_leaves_at(const BspTree& tree, BspChild at, const Point3& p, const Visit& visit) {
  std::vector<BspChild> later;
  for (;;) {
    while (!at.is_leaf()) {
      const BspNode& node = tree.nodes[at.index()];
      const Sign s = space::node_side(tree, node, p);
      if (s == Sign::zero) later.push_back(node.back);
      at = s == Sign::negative ? node.back : node.front;
    }
    visit(at);
    if (later.empty()) return;
    at = later.back();
    later.pop_back();
  }
}

void require_place(std::string_view function, const Point3& p) {
  if ((p.x - p.x) + (p.y - p.y) + (p.z - p.z) != 0) require_finite(function, p);
}

}  // namespace

Location locate(const BspTree& tree, const Point3& p) {
  if (tree.kind != BspKind::solid_leaf)
    throw InvalidShape("locate: the tree has no solid leaves; build_bsp with BspKind::solid_leaf");
  require_place("locate", p);
  BspChild at = tree.root;
  while (!at.is_leaf()) {
    const BspNode& node = tree.nodes[at.index()];
    const Sign s = space::node_side(tree, node, p);
    if (s == Sign::zero) [[unlikely]] {
      bool in = false, out = false;
      visit_leaves_at(tree, at, p, [&](BspChild leaf) { (leaf.is_solid() ? in : out) = true; });
      return in && out ? Location::boundary : in ? Location::inside : Location::outside;
    }
    at = s == Sign::positive ? node.front : node.back;
  }
  return at.is_solid() ? Location::inside : Location::outside;
}

std::vector<std::uint32_t> leaves_at(const BspTree& tree, const Point3& p, std::vector<std::uint32_t> rows) {
  require_place("leaves_at", p);
  rows.clear();
  visit_leaves_at(tree, tree.root, p, [&](BspChild leaf) { rows.push_back(leaf.index()); });
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace plumb
