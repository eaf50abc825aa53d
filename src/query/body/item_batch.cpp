#include "plumb/query/body/item_batch.hpp"

#include <string>

#include "figure/basic/mesh_input.hpp"
#include "query/body/figure_input.hpp"

namespace plumb {

namespace query {
namespace {

constexpr std::size_t most_lanes = 8;

}  // namespace

template <class Item, std::size_t corners>
ItemBatch<Item, corners>::ItemBatch(std::span<const Item> items) : size_(items.size()) {
  constexpr std::string_view name = corners == 1 ? "PointBatch" : corners == 2 ? "SegmentBatch" : "TriangleBatch";
  const std::size_t padded = items.empty() ? 0 : items.size() + most_lanes;
  for (auto& numbers : of_) numbers.reserve(padded);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!is_sound(items[i]))
      require_figure(name, std::string("items[").append(std::to_string(i)).append("]"), items[i]);
    auto to = of_.begin();
    const auto push = [&to](const Point3& p) {
      for (const double x : {p.x, p.y, p.z}) (to++)->push_back(x);
    };
    body(items[i], [&](std::string_view, const auto&... corner) { (push(corner.is), ...); });
  }
  if (items.empty()) return;
  for (auto& numbers : of_) numbers.resize(padded, numbers.back());
}

template class ItemBatch<Point3, 1>;
template class ItemBatch<Segment3, 2>;
template class ItemBatch<Triangle3, 3>;

}  // namespace query

TriangleBatch triangle_batch(const TriangleMesh& mesh) {
  require_mesh("triangle_batch", mesh);
  std::vector<Triangle3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  return TriangleBatch(triangles);
}

}  // namespace plumb
