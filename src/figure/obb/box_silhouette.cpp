// Boxes of which an axis is given.
#include <algorithm>
#include <limits>

#include "figure/obb/box_search.hpp"
#include "figure/obb/calipers.hpp"

namespace plumb::figure::frame {
namespace {

// The convex polygon that the hull's outline fills, seen along d, in the plane of u and v, counterclockwise.  Of
// corners, for the order of edges is lost where some are seen end-on.
std::vector<Vector2> silhouette(const HullModel& model, const Vector3& d, const Vector3& u, const Vector3& v) {
  std::vector<char> facing(model.normals.size());
  for (std::size_t f = 0; f < facing.size(); ++f) facing[f] = dot(model.normals[f], d) > 0 ? 1 : 0;
  std::vector<Vector2> seen;
  for (const HullModel::Edge& e : model.edges) {
    if (facing[e.left] == facing[e.right]) continue;
    // Where it starts, going counterclockwise.
    const Vector3& from = model.vertices[facing[e.left] != 0 ? e.from : e.to];
    seen.push_back({dot(from, u), dot(from, v)});
  }
  std::ranges::sort(seen, [](const Vector2& a, const Vector2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Vector2> polygon;
  polygon.reserve(seen.size() + 1);
  const auto grow = [&polygon](std::size_t kept, const Vector2& p) {
    const auto turns_left = [&p](const Vector2& a, const Vector2& b) {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
    };
    while (polygon.size() > kept && !turns_left(polygon[polygon.size() - 2], polygon.back())) polygon.pop_back();
    polygon.push_back(p);
  };
  for (const Vector2& p : seen) grow(1, p);
  const std::size_t lower = polygon.size();
  for (std::size_t i = seen.size(); i-- > 1;) grow(lower, seen[i - 1]);
  if (polygon.size() > 1) polygon.pop_back();
  return polygon;
}

double width(const HullModel& model, const Vector3& d) {
  return dot(model.vertices[model.climb(0, d)], d) - dot(model.vertices[model.climb(0, {-d.x, -d.y, -d.z})], d);
}

}  // namespace

FoundBox box_along(const HullModel& model, const Vector3& direction) {
  const auto [d, u, v] = orthonormal({direction, axis_beside(direction), Vector3{0, 0, 0}});
  const Calipers best = smallest_rectangle(silhouette(model, d, u, v));
  const Vector3 along = plus(times(u, best.direction.x), times(v, best.direction.y));
  const double volume = best.area * width(model, d);
  return {{d, along, cross(d, along)}, volume >= 0 ? volume : std::numeric_limits<double>::infinity()};
}

FoundBox turned_about_axes(const HullModel& model, FoundBox box) {
  constexpr int most_rounds = 16;       // each halves what is left to gain, as a rule
  constexpr double gain = 1 - 0x1p-40;  // a guess: a volume that is not less than this part is no gain
  for (int round = 0, idle = 0; round < 3 * most_rounds && idle < 3; ++round) {
    const FoundBox next = box_along(model, box.axes[static_cast<std::size_t>(round % 3)]);
    const bool better = next.volume < box.volume * gain;
    idle = better ? 0 : idle + 1;
    if (better) box = {{next.axes[0], next.axes[1], next.axes[2]}, next.volume};
  }
  return box;
}

}  // namespace plumb::figure::frame
