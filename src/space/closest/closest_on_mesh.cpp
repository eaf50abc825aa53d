// Branch and bound: boxes by squares that are rounded outward, triangles by distances, ties exactly.
#include "plumb/space/closest/closest_on_mesh.hpp"

#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "query/body/figure_input.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/closest/box_distance.hpp"
#include "space/closest/near_feature.hpp"

namespace plumb {
namespace space {
namespace {

/// The k nearest triangles of those that were offered.
class Nearest {
 public:
  struct Candidate {
    std::uint32_t item, slot;
    double distance;
  };

  Nearest(const Bvh& mesh, std::size_t k) : mesh_(mesh), k_(std::min(k, mesh.triangles.size())) {}

  const std::vector<Candidate>& of(const Point3& p) {
    p_ = p;
    found_.clear();
    if (k_ == 0) return found_;
    const BoxFrame& frame = mesh_.tree.frame;
    const Aabb3 point{p, p};
    const FloatBox3 at = frame.around(point);
    const std::span<const Point3> vertices = mesh_.vertices.view();
    const std::span<const Bvh::Corners> triangles = mesh_.triangles.view();
    const std::span<const std::uint32_t> items = mesh_.tree.items.view();
    SquareLimits limits;
    const auto bound = [&](const BoxNode& node) { return square_below(at, node); };
    const auto visit = [&](std::uint32_t first, std::uint32_t count, double& now) {
      for (std::uint32_t slot = first; slot < first + count; ++slot) {
        const Bvh::Corners& c = triangles[slot];
        if (square_below(point, box_around(c, vertices)) > limits.of_triangles) continue;
        const double d = plumb::distance(p, Triangle3{vertices[c[0]], vertices[c[1]], vertices[c[2]]});
        if (!offer({items[slot], slot, d}) || found_.size() < k_) continue;
        limits = limits_above(frame, found_.back().distance);
        now = limits.of_nodes;
      }
    };
    double limit = limits.of_nodes;
    descend_nearer_first(mesh_.tree, limit, bound, visit);
    return found_;
  }

 private:
  bool offer(const Candidate& candidate) {
    const auto nearer = [&](const Candidate& x, const Candidate& y) {
      return x.distance != y.distance ? x.distance < y.distance : comes_first(x, y);
    };
    if (found_.size() == k_) {
      if (!nearer(candidate, found_.back())) return false;
      found_.pop_back();
    }
    found_.insert(std::upper_bound(found_.begin(), found_.end(), candidate, nearer), candidate);
    return true;
  }

  /// Of distances that round alike.
  [[nodiscard]] bool comes_first(const Candidate& x, const Candidate& y) const {
    const Triangle3 s = mesh_.triangle(x.slot), t = mesh_.triangle(y.slot);
    if (near_feature(s, voronoi_region(s, p_)) == near_feature(t, voronoi_region(t, p_))) return x.item < y.item;
    const Sign order = compare(exact_distance(p_, s), exact_distance(p_, t));
    return order == Sign::zero ? x.item < y.item : order == Sign::negative;
  }

  const Bvh& mesh_;
  std::size_t k_;
  Point3 p_{};
  std::vector<Candidate> found_;
};

ClosestOnMesh closest_found(const Bvh& mesh, const Point3& p, const Nearest::Candidate& found) {
  const Closest closest = closest_points(p, mesh.triangle(found.slot));
  return {found.item, closest.on_b, closest.distance, closest.feature_b};
}

}  // namespace
}  // namespace space

std::optional<ClosestOnMesh> closest_on_mesh(const Bvh& mesh, const Point3& p) {
  query::require_figure("closest_on_mesh", "p", p);
  const auto found = space::Nearest(mesh, 1).of(p);
  if (found.empty()) return {};
  return space::closest_found(mesh, p, found[0]);
}

void closest_on_mesh(const Bvh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options) {
  space::require_equal_lengths("closest_on_mesh", "points", points.size(), "out", out.size());
  figure::require_finite_points("closest_on_mesh", "points", points);
  if (points.empty()) return;
  if (mesh.triangles.empty()) throw InvalidShape("closest_on_mesh: the mesh is empty; give one triangle at least");
  constexpr std::size_t part_size = 64;
  const std::size_t parts = space::blocks_of(points.size(), part_size);
  space::for_parts("closest_on_mesh", options.execution, options.progress, parts, [&](std::size_t part) {
    space::Nearest nearest(mesh, 1);
    const std::size_t to = std::min(points.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) {
      out[i] = space::closest_found(mesh, points[i], nearest.of(points[i])[0]);
    }
  });
}

std::vector<NearTriangle> nearest_triangles(const Bvh& mesh, const Point3& p, std::size_t k) {
  query::require_figure("nearest_triangles", "p", p);
  std::vector<NearTriangle> nearest;
  space::Nearest search(mesh, k);
  for (const auto& c : search.of(p)) nearest.push_back({c.item, c.distance});
  return nearest;
}

std::vector<NearTriangle> triangles_within(const Bvh& mesh, const Point3& p, double distance) {
  query::require_figure("triangles_within", "p", p);
  if (!(distance - distance == 0)) {
    throw NonFinite("triangles_within: distance is " + std::to_string(distance) + ", but it must be finite");
  }
  std::vector<NearTriangle> within;
  if (distance < 0) return within;
  const BoxFrame& frame = mesh.tree.frame;
  const Aabb3 point{p, p};
  const FloatBox3 at = frame.around(point);
  const space::SquareLimits limits = space::limits_above_exact(frame, distance);
  const std::span<const Point3> vertices = mesh.vertices.view();
  descend(
      mesh.tree, [&](const BoxNode& node) { return !(space::square_below(at, node) > limits.of_nodes); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const Aabb3 box = space::box_around(mesh.triangles[slot], vertices);
          if (space::square_below(point, box) > limits.of_triangles) continue;
          const Triangle3 t = mesh.triangle(slot);
          const double d = plumb::distance(p, t);
          if (d < distance || (d == distance && compare(exact_distance(p, t), distance) != Sign::positive)) {
            within.push_back({mesh.tree.items[slot], d});
          }
        }
      });
  std::ranges::sort(within, {}, &NearTriangle::triangle);
  return within;
}

}  // namespace plumb
