#include "surface/parts/hull_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/query/closest/closest.hpp"

namespace plumb::surface {
namespace {

/// The nearest double may be below the number; the one above is not.
double above(double nearest) { return std::nextafter(nearest, std::numeric_limits<double>::infinity()); }
/// Of the distance of a point from a figure, as a double: what rounds to 0 need not be it.
template <class Figure>
double above(double distance, const Point3& p, const Figure& figure) {
  return distance == 0 && contains(figure, p) ? 0 : above(distance);
}
double sum_above(double a, double b) { return (Interval(a) + Interval(b)).upper; }

struct Patch {
  Triangle3 at;
  double off;  // of any point of the hull's surface from the patch that stands for it
  double at_most;
};
struct LessFar {
  bool operator()(const Patch& a, const Patch& b) const { return a.at_most < b.at_most; }
};

/// No two points of the hull, in which the parts lie, are farther from one another.
double width_of(const std::vector<Point3>& points) {
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return above(distance(low, high));
}

/// A guess of which part is near.
double from_box(const RoundedPart& part, const Point3& p) {
  const auto beyond = [](double low, double x, double high) { return std::max({low - x, x - high, 0.0}); };
  return std::hypot(beyond(part.low.x, p.x, part.high.x), beyond(part.low.y, p.y, part.high.y),
                    beyond(part.low.z, p.z, part.high.z));
}

/// A guess of how far a point is from a part, or less: from its box, or from the plane that is farthest below it.
double from_planes(const RoundedPart& part, const Point3& p) {
  double most = 0;
  for (const auto& [x, y, z, offset] : part.planes) most = std::max(most, x * p.x + y * p.y + z * p.z - offset);
  return most;
}

Point3 middle_of(const Point3& p, const Point3& q) { return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2}; }

/// A guess, which leaves what is near the length to a proof: is a middle of a triangle of the hull, or of its edges, farther
/// from every part?
bool is_thought_too_far(const HullProxy& hull, std::span<const RoundedPart* const> parts, double length) {
  const double too_far = 1.001 * length + 1e-6 * width_of(hull.vertices);
  const auto is_far = [&](const Point3& p) {
    return std::ranges::all_of(parts, [&](const RoundedPart* part) {
      return from_box(*part, p) > too_far || from_planes(*part, p) > too_far;
    });
  };
  for (std::size_t f = 0; f < hull.hull.face_count(); ++f) {
    const auto ids = hull.hull.face(f);
    for (std::size_t i = 2; i < ids.size(); ++i) {
      const Point3 &a = hull.vertices[ids[0]], &b = hull.vertices[ids[i - 1]], &c = hull.vertices[ids[i]];
      const Point3 bc = middle_of(b, c);
      if (is_far({a.x / 3 + bc.x / 1.5, a.y / 3 + bc.y / 1.5, a.z / 3 + bc.z / 1.5}) || is_far(bc) ||
          is_far(middle_of(a, b)) || is_far(middle_of(c, a)))
        return true;
    }
  }
  return false;
}

/// A corner of patches and a part, of which the distance is asked more than once.
struct CornerAndPart {
  Point3 corner;
  const RoundedPart* part;
  friend bool operator==(const CornerAndPart&, const CornerAndPart&) = default;
};
struct HashOfCorner {
  std::size_t operator()(const CornerAndPart& c) const {
    std::size_t h = std::hash<const RoundedPart*>()(c.part);
    for (const double x : {c.corner.x, c.corner.y, c.corner.z}) h = h * 0x9e3779b97f4a7c15U ^ std::hash<double>()(x);
    return h;
  }
};
struct CornerDistance {
  double nearest, at_most;  // the nearest double; a proved bound, with the part's own
};

class ReachFinder {
 public:
  explicit ReachFinder(std::span<const RoundedPart* const> parts) : parts_(parts), order_(parts.size()) {}

  /// The bound of a patch, by the nearest parts; what the farthest of its corners is thought to be away.
  void judge(Patch& patch, double& farthest_corner) {
    const Point3 middle{(patch.at.a.x + patch.at.b.x + patch.at.c.x) / 3,
                        (patch.at.a.y + patch.at.b.y + patch.at.c.y) / 3,
                        (patch.at.a.z + patch.at.b.z + patch.at.c.z) / 3};
    for (std::size_t i = 0; i < parts_.size(); ++i) order_[i] = {from_box(*parts_[i], middle), parts_[i]};
    const std::size_t n = std::min(order_.size(), looked_at);
    std::partial_sort(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(n), order_.end(),
                      [](const auto& l, const auto& r) { return l.first < r.first; });
    patch.at_most = std::numeric_limits<double>::infinity();
    std::array<double, 3> nearest;
    nearest.fill(patch.at_most);
    for (std::size_t i = 0; i < n; ++i) {
      const RoundedPart& part = *order_[i].second;
      const std::array corners{patch.at.a, patch.at.b, patch.at.c};
      bool is_worth_it = false;
      double least = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double thought = from_planes(part, corners[k]);
        is_worth_it = is_worth_it || thought < nearest[k];
        least = std::max(least, thought);
      }
      if (!is_worth_it && least >= patch.at_most) continue;
      double most = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const CornerDistance& d = distance_from(part, corners[k]);
        nearest[k] = std::min(nearest[k], d.nearest);
        most = std::max(most, d.at_most);
      }
      patch.at_most = std::min(patch.at_most, sum_above(most, patch.off));
      if (most == 0) break;
    }
    farthest_corner = std::max({nearest[0], nearest[1], nearest[2]});
  }

 private:
  const CornerDistance& distance_from(const RoundedPart& part, const Point3& p) {
    const auto [at, is_new] = known_.try_emplace(CornerAndPart{p, &part});
    if (is_new) {
      if (std::ranges::find(part.near, p) != part.near.end()) return at->second = {0, part.off};
      const double d = distance(p, part.hull);
      at->second = {d, sum_above(above(d, p, part.hull), part.off)};
    }
    return at->second;
  }

  static constexpr std::size_t looked_at = 6;
  std::span<const RoundedPart* const> parts_;
  std::vector<std::pair<double, const RoundedPart*>> order_;
  std::unordered_map<CornerAndPart, CornerDistance, HashOfCorner> known_;
};

/// Halves of the longest edge, which may be rounded; any point of the edge would do.
std::array<Patch, 2> halves_of(const Patch& patch) {
  const auto& [a, b, c] = patch.at;
  const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
  const auto cut = [&](const Point3& p, const Point3& q, const Point3& r) {
    const Point3 middle = middle_of(p, q);
    const Segment3 edge{p, q};
    const double off = sum_above(patch.off, above(distance(middle, edge), middle, edge));
    return std::array{Patch{{p, middle, r}, off, 0}, Patch{{middle, q, r}, off, 0}};
  };
  if (ab >= bc && ab >= ca) return cut(a, b, c);
  return bc >= ca ? cut(b, c, a) : cut(c, a, b);
}

}  // namespace

std::vector<std::array<double, 4>> guessed_planes(const ConvexPolyhedron3& hull) {
  std::vector<std::array<double, 4>> planes;
  const PolygonMesh& mesh = hull.mesh;
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    const auto corner = [&](std::uint32_t i) { return mesh.vertices[mesh.corners[mesh.first[f] + i]]; };
    const Point3 a = corner(0), b = corner(1), c = corner(2);
    const Vector3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    const Vector3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = std::hypot(n.x, n.y, n.z);
    const std::array up{n.x / length, n.y / length, n.z / length};
    if (!std::isfinite(up[0] + up[1] + up[2])) continue;
    planes.push_back({up[0], up[1], up[2], up[0] * a.x + up[1] * a.y + up[2] * a.z});
  }
  return planes;
}

Reach find_reach(const HullProxy& hull, std::span<const RoundedPart* const> parts, double enough, double too_far) {
  constexpr int steps = 500;
  ReachFinder finder(parts);
  const double across = width_of(hull.vertices);
  if (across <= enough) return {across, 0};
  if (is_thought_too_far(hull, parts, too_far)) return {std::numeric_limits<double>::infinity(), too_far};
  std::priority_queue<Patch, std::vector<Patch>, LessFar> patches;
  Reach found;
  const auto add = [&](Patch patch) {
    double corner = 0;
    finder.judge(patch, corner);
    found.at_least = std::max(found.at_least, corner);
    patches.push(patch);
  };
  for (std::size_t f = 0; f < hull.hull.face_count(); ++f) {
    const auto ids = hull.hull.face(f);
    for (std::size_t i = 2; i < ids.size(); ++i)
      add({{hull.vertices[ids[0]], hull.vertices[ids[i - 1]], hull.vertices[ids[i]]}, 0, 0});
  }
  for (int step = 0; step < steps; ++step) {
    const Patch top = patches.top();
    const bool near_enough = top.at_most <= 1.05 * found.at_least;
    if (top.at_most <= enough || found.at_least > too_far || near_enough) break;
    patches.pop();
    for (const Patch& half : halves_of(top)) add(half);
  }
  found.at_most = patches.top().at_most;
  return found;
}

}  // namespace plumb::surface
