#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include "bench/rivals/nearest/rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Numbered = std::pair<Kernel::Point_3, std::uint32_t>;
using Place = CGAL::First_of_pair_property_map<Numbered>;
using Traits = CGAL::Search_traits_adapter<Numbered, Place, CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

Kernel::Point_3 cgal(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace

struct CgalTree::Tree {
  Search::Tree tree;
};

CgalTree::CgalTree(const std::vector<Point3>& points) : tree_(std::make_unique<Tree>()) {
  std::uint32_t number = 0;
  for (const Point3& p : points) tree_->tree.insert({cgal(p), number++});
  tree_->tree.build();
}
CgalTree::~CgalTree() = default;

void CgalTree::nearest(const Point3& p, std::size_t k, std::uint32_t* out) const {
  const Search search(tree_->tree, cgal(p), static_cast<unsigned>(k));
  for (const auto& found : search) *out++ = found.first.second;
}
std::size_t CgalTree::within(const Point3& p, double radius, std::vector<std::uint32_t>& out) const {
  const CGAL::Fuzzy_sphere<Traits> ball(Numbered(cgal(p), 0), radius);
  thread_local std::vector<Numbered> found;
  found.clear();
  tree_->tree.search(std::back_inserter(found), ball);
  for (const Numbered& n : found) out.push_back(n.second);
  return found.size();
}

}  // namespace plumb::bench
