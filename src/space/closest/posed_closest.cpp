// Branch and bound over posed boxes, as in closest_on_mesh.cpp and closest_triangles.cpp; ties exactly.
#include "plumb/space/closest/posed_closest.hpp"

#include <algorithm>
#include <queue>
#include <string>

#include "plumb/arith/exact_distance.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "query/body/figure_input.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"

namespace plumb {
namespace space {
namespace {

constexpr double beyond_all = std::numeric_limits<double>::infinity();

/// A triangle of doubles, and how far from it a point of the posed one can be: no farther than a corner.
struct NearbyTriangle {
  Triangle3 triangle;
  double off;

  explicit NearbyTriangle(const Posed<Triangle3>& t) : triangle(t.shape), off(0) {
    for (Point3* p : {&triangle.a, &triangle.b, &triangle.c}) {
      const Aabb3 box = around(t.pose, *p);
      if (!is_bounded(box)) off = beyond_all;
      *p = box.min;
      const double x = raised(box.max.x - box.min.x), y = raised(box.max.y - box.min.y);
      off = std::max(off, raised(raised(x + y) + raised(box.max.z - box.min.z)));
    }
  }
};

/// At most the distance of the posed triangles, and of a point.
double distance_below(const NearbyTriangle& s, const NearbyTriangle& t) {
  const double off = raised(s.off + t.off);
  return off < beyond_all ? lowered(lowered(distance(s.triangle, t.triangle)) - off) : 0;
}
double distance_below(const NearbyTriangle& s, const Point3& p) {
  return s.off < beyond_all ? lowered(lowered(distance(p, s.triangle)) - s.off) : 0;
}

struct PosedCandidate {
  std::uint32_t item, slot;
  double distance;
};

/// The k nearest, in order.
std::vector<PosedCandidate> nearest_posed(const PosedMesh& mesh, const Point3& p, std::size_t k) {
  std::vector<PosedCandidate> found;
  k = std::min(k, mesh.bvh.triangles.size());
  if (k == 0) return found;
  const Aabb3 point{p, p};
  const auto nearer = [&](const PosedCandidate& x, const PosedCandidate& y) {
    if (x.distance != y.distance) return x.distance < y.distance;
    const auto feature = [&](const PosedCandidate& c) {  // as given: what is one before the pose is one under it
      return near_feature(mesh.bvh.triangle(c.slot), query::nearest_feature(mesh.triangle(c.slot), p));
    };
    if (feature(x) == feature(y)) return x.item < y.item;
    const auto order = query::squared_distance_exact(mesh.triangle(x.slot), p) <=>
                       query::squared_distance_exact(mesh.triangle(y.slot), p);
    return order < 0 || (order == 0 && x.item < y.item);
  };
  const auto bound = [&](const BoxNode& node) { return square_below(point, around(mesh, node)); };
  double limit = beyond_all;
  descend_nearer_first(mesh.bvh.tree, limit, bound, [&](std::uint32_t first, std::uint32_t count, double& now) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const Posed<Triangle3> triangle = mesh.triangle(slot);
      if (square_below(point, around(triangle)) > now) continue;
      if (found.size() == k && distance_below(NearbyTriangle(triangle), p) > raised(found.back().distance)) continue;
      const PosedCandidate candidate{mesh.bvh.tree.items[slot], slot, query::distance(triangle, p)};
      if (found.size() == k) {
        if (!nearer(candidate, found.back())) continue;
        found.pop_back();
      }
      found.insert(std::upper_bound(found.begin(), found.end(), candidate, nearer), candidate);
      if (found.size() == k) now = square_above(found.back().distance);
    }
  });
  return found;
}

std::optional<ClosestOnMesh> closest_posed(const PosedMesh& mesh, const Point3& p) {
  const auto found = nearest_posed(mesh, p, 1);
  if (found.empty()) return {};
  const query::ClosestOnPosed near = query::closest_on(mesh.triangle(found[0].slot), p);
  return ClosestOnMesh{found[0].item, near.point, near.distance, near.feature};
}

void require_posed(const char* function, const PosedMesh& mesh, const Point3& p) {
  require_pose(function, "mesh", mesh.pose);
  query::require_figure(function, "p", p);
}

/// The nearest pair of nodes always; once two triangles meet, only those that do and come first.
class PosedClosestSearch {
 public:
  PosedClosestSearch(const PosedMesh& a, const PosedMesh& b)
      : a_(a), b_(b), nodes_a_(a.bvh.tree.nodes.view()), nodes_b_(b.bvh.tree.nodes.view()) {}

  ClosestTriangles run() {
    push({0, 0});
    while (!later_.empty() && !(later_.top().bound > limit_)) {
      const NodePair pair = later_.top().pair;
      later_.pop();
      const BoxNode &a = nodes_a_[pair.a], &b = nodes_b_[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        leaves(a, b);
      } else {
        const auto larger = [&](const BoxNode& x, const BoxNode& y) {  // a guess
          const auto size = [](const Aabb3& box) {
            return std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
          };
          return size(around(a_, x)) < size(around(b_, y)) ? Descend::second : Descend::first;
        };
        replace_pair(nodes_a_, nodes_b_, larger, pair, [&](NodePair next) { push(next); });
      }
    }
    return {best_.a, best_.b, query::closest_points(a_.triangle(best_.slot_a), b_.triangle(best_.slot_b))};
  }

 private:
  struct Waiting {
    double bound;
    NodePair pair;
  };
  struct Farther {
    bool operator()(const Waiting& x, const Waiting& y) const {
      return x.bound != y.bound     ? x.bound > y.bound
             : x.pair.a != y.pair.a ? x.pair.a < y.pair.a
                                    : x.pair.b < y.pair.b;  // the deeper one first
    }
  };
  struct Candidate {
    std::uint32_t a, b, slot_a, slot_b;
    double distance;
  };

  void push(NodePair pair) {
    const double bound = square_below(around(a_, nodes_a_[pair.a]), around(b_, nodes_b_[pair.b]));
    if (!(bound > limit_)) later_.push({bound, pair});
  }

  void leaves(const BoxNode& a, const BoxNode& b) {
    for (std::uint32_t i = a.link; i < a.link + a.count; ++i) {
      const Aabb3 box = around(a_.triangle(i));
      const NearbyTriangle near(a_.triangle(i));
      for (std::uint32_t k = b.link; k < b.link + b.count; ++k) {
        const double bound = square_below(box, around(b_.triangle(k)));
        if (bound > limit_ || distance_below(near, NearbyTriangle(b_.triangle(k))) > raised(best_.distance)) continue;
        offer({a_.bvh.tree.items[i], b_.bvh.tree.items[k], i, k, 0}, bound == 0);
      }
    }
  }

  void offer(Candidate candidate, bool may_meet) {
    const bool comes_first = candidate.a != best_.a ? candidate.a < best_.a : candidate.b < best_.b;
    if (meet_ && !comes_first) return;
    const Posed<Triangle3> s = a_.triangle(candidate.slot_a), t = b_.triangle(candidate.slot_b);
    if (may_meet && query::relate(s, t) != Relation::disjoint) {
      best_ = candidate;
      meet_ = true;
      limit_ = 0;
    }
    if (meet_) return;
    candidate.distance = query::distance(s, t);
    if (found_ && !is_before(candidate, s, t, comes_first)) return;
    best_ = candidate;
    found_ = true;
    limit_ = square_above(candidate.distance);
  }

  [[nodiscard]] bool is_before(const Candidate& c, const Posed<Triangle3>& s, const Posed<Triangle3>& t,
                               bool comes_first) const {
    if (c.distance != best_.distance) return c.distance < best_.distance;
    const Posed<Triangle3> best_s = a_.triangle(best_.slot_a), best_t = b_.triangle(best_.slot_b);
    const auto features = query::quick_features(s, t), best = query::quick_features(best_s, best_t);
    const auto same = [&](std::size_t i, const Posed<Triangle3>& one, const Posed<Triangle3>& other) {
      return near_feature(one.shape, (*features)[i]) == near_feature(other.shape, (*best)[i]);
    };
    if (features && best && same(0, s, best_s) && same(1, t, best_t)) return comes_first;
    const auto order = query::squared_distance_exact(s, t) <=> query::squared_distance_exact(best_s, best_t);
    return order < 0 || (order == 0 && comes_first);
  }

  const PosedMesh &a_, &b_;
  std::span<const BoxNode> nodes_a_, nodes_b_;
  std::priority_queue<Waiting, std::vector<Waiting>, Farther> later_;
  double limit_ = beyond_all;
  Candidate best_{0, 0, 0, 0, beyond_all};
  bool found_ = false, meet_ = false;
};

}  // namespace
}  // namespace space

std::optional<ClosestOnMesh> closest_on_mesh(const PosedMesh& mesh, const Point3& p) {
  space::require_posed("closest_on_mesh", mesh, p);
  return space::closest_posed(mesh, p);
}

void closest_on_mesh(const PosedMesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  if (points.size() != out.size()) {
    throw UnequalLengths("closest_on_mesh: points has length " + std::to_string(points.size()) + ", out has length " +
                         std::to_string(out.size()));
  }
  space::require_pose("closest_on_mesh", "mesh", mesh.pose);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!query::is_sound(points[i]))
      query::require_figure("closest_on_mesh", "points[" + std::to_string(i) + "]", points[i]);
  }
  if (points.empty()) return;
  if (mesh.bvh.triangles.empty()) throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
  constexpr std::size_t part_size = 16;
  const std::size_t parts = space::blocks_of(points.size(), part_size);
  space::for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(points.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) out[i] = *space::closest_posed(mesh, points[i]);
  });
}

std::vector<NearTriangle> nearest_triangles(const PosedMesh& mesh, const Point3& p, std::size_t k) {
  space::require_posed("nearest_triangles", mesh, p);
  std::vector<NearTriangle> nearest;
  for (const auto& c : space::nearest_posed(mesh, p, k)) nearest.push_back({c.item, c.distance});
  return nearest;
}

std::vector<NearTriangle> triangles_within(const PosedMesh& mesh, const Point3& p, double distance) {
  space::require_posed("triangles_within", mesh, p);
  if (!(distance - distance == 0)) {
    throw NonFinite("triangles_within: distance is " + std::to_string(distance) + ", but it must be finite");
  }
  std::vector<NearTriangle> within;
  if (distance < 0) return within;
  const Aabb3 point{p, p};
  const double limit = space::square_above_exact(distance);
  const auto enters = [&](const Aabb3& box) { return !(space::square_below(point, box) > limit); };
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return enters(space::around(mesh, node)); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const Posed<Triangle3> triangle = mesh.triangle(slot);
          if (!enters(space::around(triangle))) continue;
          const double d = query::distance(triangle, p);
          const auto exact = [&] { return ExactDistance{query::squared_distance_exact(triangle, p)}; };
          if (d < distance || (d == distance && compare(exact(), distance) != Sign::positive))
            within.push_back({mesh.bvh.tree.items[slot], d});
        }
      });
  std::ranges::sort(within, {}, &NearTriangle::triangle);
  return within;
}

std::optional<ClosestTriangles> closest_triangles(const PosedMesh& a, const PosedMesh& b) {
  space::require_pose("closest_triangles", "a", a.pose);
  space::require_pose("closest_triangles", "b", b.pose);
  if (a.bvh.triangles.empty() || b.bvh.triangles.empty()) return {};
  return space::PosedClosestSearch(a, b).run();
}

}  // namespace plumb
