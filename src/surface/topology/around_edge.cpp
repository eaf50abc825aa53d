#include "surface/topology/around_edge.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"

namespace plumb::surface {
namespace {

Sign turn(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const auto seen = [axis](const Point3& p) {
    return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  };
  return orient2d(seen(a), seen(b), seen(c));
}

/// The order of points around the line from a to b, beginning with that of p: by quadrants, and within them by signs.
class AroundEdge {
 public:
  AroundEdge(const Point3& a, const Point3& b, const Point3& p) : a_(a), b_(b), p_(p) {}

  /// Positive where q lies less than half a turn counterclockwise from p, seen from b.
  [[nodiscard]] Sign ahead(const Point3& p, const Point3& q) const { return -orient3d(a_, b_, p, q); }
  /// 0 for p's own half plane, 1 and 3 for what is before and behind the opposite one, which is 2.
  [[nodiscard]] int quarter(const Point3& q) const {
    const Sign s = ahead(p_, q);
    if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
    for (const int axis : {0, 1, 2}) {
      const Sign of_p = turn(a_, b_, p_, axis), of_q = turn(a_, b_, q, axis);
      if (of_p != Sign::zero && of_q != Sign::zero) return of_p == of_q ? 0 : 2;
    }
    return 0;  // on the line itself
  }

 private:
  const Point3 &a_, &b_, &p_;
};

}  // namespace

std::vector<EdgeUse> order_around_edge(const TriangleMesh& mesh, const std::array<std::uint32_t, 2>& edge,
                                       std::span<const EdgeUse> uses) {
  const auto at = [&](std::uint32_t v) -> const Point3& { return mesh.vertices[v]; };
  const AroundEdge around(at(edge[0]), at(edge[1]), at(uses[0].opposite));
  struct Placed {
    int quarter;
    EdgeUse use;
  };
  std::vector<Placed> placed;
  for (const EdgeUse& use : uses) placed.push_back({around.quarter(at(use.opposite)), use});
  const auto before = [&](const Placed& l, const Placed& r) {
    if (l.quarter != r.quarter) return l.quarter < r.quarter;
    return l.quarter % 2 == 1 && around.ahead(at(l.use.opposite), at(r.use.opposite)) == Sign::positive;
  };
  std::ranges::sort(placed, before);
  std::vector<EdgeUse> order;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (i > 0 && !before(placed[i - 1], placed[i])) return {};
    order.push_back(placed[i].use);
  }
  return order;
}

}  // namespace plumb::surface
