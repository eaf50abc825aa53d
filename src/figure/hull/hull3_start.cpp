#include "figure/hull/hull3_start.hpp"

#include <cmath>
#include <tuple>

#include "plumb/certify/direction.hpp"

namespace plumb::figure::hull3 {
namespace {

bool precedes(const Point3& a, const Point3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// The node of the largest measure, if it passes; otherwise the first that does, or none.
template <class Measure, class Passes>
Id pick(std::span<const Node> nodes, Measure measure, Passes passes) {
  std::size_t best = 0;
  double most = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (const double m = measure(nodes[i].point); m > most) {
      most = m;
      best = i;
    }
  }
  if (passes(nodes[best].point)) return static_cast<Id>(best);
  const auto found = std::ranges::find_if(nodes, passes, &Node::point);
  return found == nodes.end() ? none : static_cast<Id>(found - nodes.begin());
}

}  // namespace

Start find_start(std::span<const Node> nodes) {
  Start start;
  if (nodes.empty()) return start;
  const auto [first, last] = std::ranges::minmax_element(nodes, precedes, &Node::point);
  const Point3 &a = first->point, &b = last->point;
  start.simplex[0] = static_cast<Id>(first - nodes.begin());
  start.simplex[1] = static_cast<Id>(last - nodes.begin());
  start.dimension = a == b ? 0 : 1;
  if (a == b) return start;

  const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z};
  const auto from_line = [&](const Point3& p) {
    const Vector3 v{p.x - a.x, p.y - a.y, p.z - a.z};
    const Vector3 w{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    return w.x * w.x + w.y * w.y + w.z * w.z;
  };
  start.simplex[2] = pick(nodes, from_line, [&](const Point3& p) { return !collinear(a, b, p); });
  if (start.simplex[2] == none) return start;
  start.dimension = 2;

  const PlaneSide plane(a, b, nodes[start.simplex[2]].point);
  const auto from_plane = [&](const Point3& p) {
    return std::abs((p.x - a.x) * plane.coefficient(0) + (p.y - a.y) * plane.coefficient(1) +
                    (p.z - a.z) * plane.coefficient(2));
  };
  start.simplex[3] = pick(nodes, from_plane, [&](const Point3& p) { return plane(p) != Sign::zero; });
  if (start.simplex[3] != none) start.dimension = 3;
  return start;
}

}  // namespace plumb::figure::hull3
