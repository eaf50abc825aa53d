#include "tool/drawing/drawn_hull.hpp"

#include <algorithm>

namespace plumb::tool {

DrawnHull drawn_hull(const Hull3& hull, std::span<const Point3> of) {
  DrawnHull drawn;
  for (const std::uint32_t v : hull.vertices) drawn.points.push_back(of[v]);
  const auto place = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::ranges::lower_bound(hull.vertices, v) - hull.vertices.begin());
  };
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t p = place(face[i]), q = place(face[(i + 1) % face.size()]);
      drawn.edges.insert({std::min(p, q), std::max(p, q)});
    }
  }
  if (hull.dimension == 1) drawn.edges.insert({0, 1});
  return drawn;
}

}  // namespace plumb::tool
