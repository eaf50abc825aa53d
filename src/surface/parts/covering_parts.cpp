// Covering parts: a guess says which exact parts become one, a proof how far their hull reaches beyond them.
#include "plumb/surface/parts/covering_parts.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <string>
#include <unordered_map>

#include "plumb/arith/error.hpp"
#include "plumb/query/closest/closest.hpp"
#include "surface/parts/hull_reach.hpp"

namespace plumb {
namespace {

using surface::RoundedPart;

/// The nearest doubles, and all next to the point, on both sides of it where a coordinate is none.
void add_around(const ExactPoint3& point, RoundedPart& part) {
  const Point3 nearest = approximate(point);
  part.near.push_back(nearest);
  if (ExactPoint3(nearest) == point) {
    part.around.push_back(nearest);
    return;
  }
  const RationalPoint3 exact = rational_point(point);
  const auto between = [](const Rational& x) { return std::array{x.rounded(Rounding::down), x.rounded(Rounding::up)}; };
  const std::array<std::array<double, 2>, 3> at{between(exact.x), between(exact.y), between(exact.z)};
  for (const double x : at[0])
    for (const double y : at[1])
      for (const double z : at[2]) part.around.push_back({x, y, z});
  const double across = distance(Point3{at[0][0], at[1][0], at[2][0]}, Point3{at[0][1], at[1][1], at[2][1]});
  part.off = std::max(part.off, std::nextafter(across, INFINITY));  // the nearest double may be below the number
}

HullProxy hull_around(const std::vector<Point3>& points) {
  TriangleMesh of;
  of.vertices = points;
  return hull_proxy(of);
}

RoundedPart rounded_part(const ConvexPart& part) {
  RoundedPart rounded;
  for (const ExactPoint3& p : part.solid.vertices) add_around(p, rounded);
  rounded.around = hull_around(rounded.around).vertices;
  HullProxy hull = hull_around(rounded.near);
  if (hull.hull.dimension < 3) hull = hull_around(rounded.around);  // thinner than doubles tell
  rounded.near = hull.vertices;
  rounded.hull = convex_polyhedron(hull.hull, hull.vertices);
  rounded.planes = surface::guessed_planes(rounded.hull);
  rounded.low = rounded.high = rounded.around[0];
  for (const Point3& p : rounded.around) {
    rounded.low = {std::min(rounded.low.x, p.x), std::min(rounded.low.y, p.y), std::min(rounded.low.z, p.z)};
    rounded.high = {std::max(rounded.high.x, p.x), std::max(rounded.high.y, p.y), std::max(rounded.high.z, p.z)};
  }
  return rounded;
}

/// A guess: rounded as it comes.
double rough_volume(const HullProxy& proxy) {
  double six = 0;
  const Point3& o = proxy.vertices[0];
  for (std::size_t f = 0; f < proxy.hull.face_count(); ++f) {
    const auto ids = proxy.hull.face(f);
    for (std::size_t i = 2; i < ids.size(); ++i) {
      const Point3 &a = proxy.vertices[ids[0]], &b = proxy.vertices[ids[i - 1]], &c = proxy.vertices[ids[i]];
      const Vector3 u{a.x - o.x, a.y - o.y, a.z - o.z}, v{b.x - o.x, b.y - o.y, b.z - o.z},
          w{c.x - o.x, c.y - o.y, c.z - o.z};
      six += u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
    }
  }
  return six / 6;
}

struct Cluster {
  std::vector<Point3> around, near;  // corners of hulls: that which holds the share, and a guess of it
  std::vector<std::uint32_t> share;
  std::set<std::uint32_t> neighbors;
  Point3 low, high;
  double volume = 0;  // of the share, as a guess
  bool is_gone = false;
};

struct Union {
  double excess;  // a guess
  std::uint32_t a, b;
  friend bool operator<(const Union& l, const Union& r) {
    return std::tie(r.excess, r.a, r.b) < std::tie(l.excess, l.a, l.b);  // the least first
  }
};

class CoverFinder {
 public:
  CoverFinder(const ConvexParts& exact, const CoveringOptions& options) : exact_(exact), options_(options) {
    for (const ConvexPart& part : exact.parts) rounded_.push_back(rounded_part(part));
    for (std::uint32_t i = 0; i < rounded_.size(); ++i) {
      const RoundedPart& r = rounded_[i];
      Cluster& c = clusters_.emplace_back();
      c.around = r.around, c.near = r.near;
      c.share = {i};
      c.low = r.low, c.high = r.high;
      c.volume = rough_volume(hull_around(r.near));
    }
    left_ = clusters_.size();
  }

  std::vector<CoveringPart> find() {
    const std::size_t most = options_.most_parts.value_or(static_cast<std::uint32_t>(clusters_.size()));
    if (options_.concavity > 0 || left_ > most) {
      find_neighbors();
      join(0);
      find_touching_boxes();
      join(0);
    }
    if (left_ > most) {
      is_proof_asked_ = false;
      for (std::uint32_t i = 0; i < clusters_.size(); ++i)
        for (const std::uint32_t k : clusters_[i].neighbors)
          if (i < k && !clusters_[i].is_gone && !clusters_[k].is_gone) consider(i, k);
      join(most);
    }
    if (left_ > most) {  // what does not even touch
      for (std::uint32_t i = 0; i < clusters_.size(); ++i)
        for (std::uint32_t k = i + 1; k < clusters_.size(); ++k)
          if (!clusters_[i].is_gone && !clusters_[k].is_gone) link(i, k);
      join(most);
    }
    std::vector<CoveringPart> parts;
    for (Cluster& c : clusters_) {
      if (c.is_gone) continue;
      std::ranges::sort(c.share);
      HullProxy proxy = hull_around(c.around);
      // Of one part alone it is known: its corners are off by no more.
      const double reach =
          c.share.size() == 1 ? rounded_[c.share[0]].off : surface::find_reach(proxy, parts_of(c), 0, INFINITY).at_most;
      parts.push_back({std::move(proxy), std::move(c.share), reach});
    }
    std::ranges::sort(parts, {}, [](const CoveringPart& p) { return p.share.front(); });
    return parts;
  }

 private:
  static bool boxes_meet(const Cluster& a, const Cluster& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
           a.low.z <= b.high.z && b.low.z <= a.high.z;
  }
  /// A guess of what touches: exact parts that have a corner in common.
  void find_neighbors() {
    std::unordered_map<ExactPoint3, std::vector<std::uint32_t>> parts_at;
    for (std::uint32_t i = 0; i < rounded_.size(); ++i)
      for (const ExactPoint3& p : exact_.parts[i].solid.vertices) parts_at[p].push_back(i);
    std::set<std::array<std::uint32_t, 2>> pairs;
    for (const auto& [point, parts] : parts_at)
      for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t k = i + 1; k < parts.size(); ++k) pairs.insert({parts[i], parts[k]});
    for (const auto& [i, k] : pairs) link(i, k);
  }
  /// And of what is left, what has boxes that touch.
  void find_touching_boxes() {
    std::vector<std::uint32_t> left;
    for (std::uint32_t i = 0; i < clusters_.size(); ++i)
      if (!clusters_[i].is_gone) left.push_back(i);
    for (std::size_t i = 0; i < left.size(); ++i)
      for (std::size_t k = i + 1; k < left.size(); ++k)
        if (boxes_meet(clusters_[left[i]], clusters_[left[k]]) && !clusters_[left[i]].neighbors.contains(left[k]))
          link(left[i], left[k]);
  }
  void link(std::uint32_t i, std::uint32_t k) {
    clusters_[i].neighbors.insert(k);
    clusters_[k].neighbors.insert(i);
    consider(i, k);
  }
  static HullProxy common_hull(std::vector<Point3> points, const std::vector<Point3>& others) {
    points.insert(points.end(), others.begin(), others.end());
    return hull_around(points);
  }
  void consider(std::uint32_t i, std::uint32_t k) {
    const Cluster &a = clusters_[i], &b = clusters_[k];
    unions_.push({rough_volume(common_hull(a.near, b.near)) - a.volume - b.volume, i, k});
  }
  [[nodiscard]] std::vector<const RoundedPart*> parts_of(const Cluster& c) const {
    std::vector<const RoundedPart*> parts;
    for (const std::uint32_t i : c.share) parts.push_back(&rounded_[i]);
    return parts;
  }

  void join(std::size_t most) {
    while (!unions_.empty() && left_ > std::max<std::size_t>(most, 1)) {
      const Union top = unions_.top();
      unions_.pop();
      Cluster &a = clusters_[top.a], &b = clusters_[top.b];
      if (a.is_gone || b.is_gone) continue;
      Cluster c;
      const HullProxy proxy = common_hull(a.around, b.around);
      c.share = a.share;
      c.share.insert(c.share.end(), b.share.begin(), b.share.end());
      if (is_proof_asked_ &&
          surface::find_reach(proxy, parts_of(c), options_.concavity, options_.concavity).at_most > options_.concavity)
        continue;
      c.around = proxy.vertices;
      c.near = common_hull(a.near, b.near).vertices;
      c.low = {std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)};
      c.high = {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)};
      replace(top.a, top.b, std::move(c));
    }
  }
  void replace(std::uint32_t i, std::uint32_t k, Cluster c) {
    Cluster &a = clusters_[i], &b = clusters_[k];
    a.is_gone = b.is_gone = true;
    --left_;
    c.volume = a.volume + b.volume;
    std::set<std::uint32_t> neighbors = a.neighbors;
    neighbors.insert(b.neighbors.begin(), b.neighbors.end());
    const auto number = static_cast<std::uint32_t>(clusters_.size());
    a.neighbors.clear(), b.neighbors.clear();
    clusters_.push_back(std::move(c));
    for (const std::uint32_t n : neighbors)
      if (!clusters_[n].is_gone) link(n, number);
  }

  const ConvexParts& exact_;
  const CoveringOptions& options_;
  std::vector<RoundedPart> rounded_;
  std::vector<Cluster> clusters_;
  std::priority_queue<Union> unions_;
  std::size_t left_ = 0;
  bool is_proof_asked_ = true;
};

}  // namespace

CoveringParts covering_parts(const TriangleMesh& mesh, const CoveringOptions& options) {
  if (!(options.concavity - options.concavity == 0))
    throw NonFinite("covering_parts: the concavity is " + std::to_string(options.concavity) + ", not a length");
  if (options.concavity < 0) throw InvalidShape("covering_parts: the concavity is negative; give one of at least 0");
  if (options.most_parts == 0U) throw InvalidShape("covering_parts: no part is asked for; give at least 1");
  CoveringParts found;
  found.exact = convex_parts(mesh);
  found.parts = CoverFinder(found.exact, options).find();
  return found;
}

std::vector<HullProxy> compound_proxy(const TriangleMesh& mesh, const CoveringOptions& options) {
  std::vector<HullProxy> hulls;
  for (CoveringPart& part : covering_parts(mesh, options).parts) hulls.push_back(std::move(part.proxy));
  return hulls;
}

}  // namespace plumb
