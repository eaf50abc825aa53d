#include "plumb/space/kd_tree/cells_along.hpp"

#include "space/kd_tree/plane_walk.hpp"

namespace plumb {
namespace space::kd {
namespace {

/// Of a complete tree, whose nodes lie as in a heap.
template <class Point>
struct HeapPlanes {
  static constexpr std::size_t root = 0;
  const KdTree<Point>& tree;

  [[nodiscard]] bool is_leaf(std::size_t node) const { return node >= tree.leaves() - 1; }
  [[nodiscard]] std::size_t leaf(std::size_t node) const { return node - (tree.leaves() - 1); }
  [[nodiscard]] std::uint8_t axis(std::size_t node) const { return tree.axes[node]; }
  [[nodiscard]] double plane(std::size_t node) const { return tree.planes[node]; }
  [[nodiscard]] static std::size_t lower(std::size_t node) { return 2 * node + 1; }
  [[nodiscard]] static std::size_t upper(std::size_t node) { return 2 * node + 2; }
};

template <class Point, class Way>
std::vector<std::uint32_t> heap_cells(const KdTree<Point>& tree, const Way& way, WalkedCells cells,
                                      std::vector<std::uint32_t> rows) {
  const auto path = checked_path("cells_along", way);
  return PlaneWalk<HeapPlanes<Point>, KdTree<Point>::dimension>({tree}, path, cells).leaves(std::move(rows));
}

}  // namespace
}  // namespace space::kd

std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Segment2& segment, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  return space::kd::heap_cells(tree, segment, cells, std::move(rows));
}
std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Ray2& ray, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  return space::kd::heap_cells(tree, ray, cells, std::move(rows));
}
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Segment3& segment, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  return space::kd::heap_cells(tree, segment, cells, std::move(rows));
}
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Ray3& ray, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  return space::kd::heap_cells(tree, ray, cells, std::move(rows));
}

}  // namespace plumb
