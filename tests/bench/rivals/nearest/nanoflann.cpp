#include <array>
#include <nanoflann.hpp>

#include "bench/rivals/nearest/rival.hpp"

namespace plumb::bench {

struct NanoflannTree::Tree {
  struct Cloud {
    std::vector<Point3> points;  // as its users keep them
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
    [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return axis == 0 ? points[i].x : axis == 1 ? points[i].y : points[i].z;
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Index =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

  Cloud cloud;
  Index index;
  explicit Tree(const std::vector<Point3>& points)
      : cloud{points}, index(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {
    index.buildIndex();
  }
};

NanoflannTree::NanoflannTree(const std::vector<Point3>& points) : tree_(std::make_unique<Tree>(points)) {}
NanoflannTree::~NanoflannTree() = default;

void NanoflannTree::nearest(const Point3& p, std::size_t k, std::uint32_t* out) const {
  std::array<double, 64> squares;
  tree_->index.knnSearch(&p.x, k, out, squares.data());
}
std::size_t NanoflannTree::within(const Point3& p, double radius, std::vector<std::uint32_t>& out) const {
  thread_local std::vector<std::pair<std::uint32_t, double>> found;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  tree_->index.radiusSearch(&p.x, radius * radius, found, unsorted);
  for (const auto& [number, square] : found) out.push_back(number);
  return found.size();
}

}  // namespace plumb::bench
