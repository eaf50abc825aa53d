#include "bench/rivals/octree/cgal_octree.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Octree.h>

#include <optional>
#include <vector>

namespace plumb::bench {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Points = std::vector<Kernel::Point_3>;
using Tree = CGAL::Octree<Kernel, Points>;

struct CgalOctree::Held {
  Points asked, ordered;  // the tree orders its points
  std::optional<Tree> tree;
};

CgalOctree::CgalOctree(std::span<const Point3> points) : held_(std::make_unique<Held>()) {
  for (const Point3& p : points) held_->asked.emplace_back(p.x, p.y, p.z);
}
CgalOctree::~CgalOctree() = default;

void CgalOctree::build(std::size_t most_in_leaf, std::size_t most_depth) {
  held_->tree.reset();
  held_->ordered = held_->asked;
  held_->tree.emplace(held_->ordered);
  held_->tree->refine(most_depth, most_in_leaf);
}

std::size_t CgalOctree::located() const {
  std::size_t sum = 0;
  for (const auto& p : held_->asked) sum += held_->tree->locate(p).size();
  return sum;
}

}  // namespace plumb::bench
