#include "hull3_interior.hpp"
namespace plumb::hull3 {
std::vector<Node> outer_nodes(std::span<const Point3> points, const Extents&, Execution) {
  std::vector<Node> nodes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) nodes[i] = {points[i], none, static_cast<Id>(i)};
  return nodes;
}
}  // namespace plumb::hull3
