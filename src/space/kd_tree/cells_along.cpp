// The descent keeps what of the ray is in a node's cell, between two of: its start, its end, and crossings of planes.
#include "plumb/space/kd_tree/cells_along.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "figure/basic/finite_parts.hpp"
#include "space/octree/crossing_sign.hpp"

namespace plumb {
namespace space::kd {
namespace {

/// A segment's end, or the vector along a ray.
template <std::size_t d>
struct Path {
  std::array<double, d> from, to;
  bool is_ray;

  /// In which direction it goes along an axis.
  [[nodiscard]] int way(std::size_t axis) const {
    const double origin = is_ray ? 0 : from[axis];
    return static_cast<int>(to[axis] > origin) - static_cast<int>(to[axis] < origin);
  }
};

int sign_of_difference(double a, double b) { return static_cast<int>(a > b) - static_cast<int>(a < b); }

/// A place on a path, in the order of its parameter.
struct Place {
  enum class Kind : unsigned char { start, crossing, end };
  Kind kind;
  std::uint8_t axis;
  double plane;
  bool open;  // is the place itself left out?
};
using Kind = Place::Kind;

template <std::size_t d>
int compare(const Path<d>& path, const Place& a, const Place& b) {
  if (a.kind == Kind::crossing && b.kind == Kind::crossing) {
    if (a.axis == b.axis) return sign_of_difference(a.plane, b.plane) * path.way(a.axis);
    const auto ask = [&](const auto& statement) {
      return certainly(statement, a.plane, path.from[a.axis], path.to[a.axis], b.plane, path.from[b.axis],
                       path.to[b.axis]);
    };
    const Sign sign = path.is_ray ? ask(CrossingOrder<false>{}) : ask(CrossingOrder<true>{});
    return static_cast<int>(sign) * path.way(a.axis) * path.way(b.axis);
  }
  if (b.kind == Kind::crossing) return -compare(path, b, a);
  if (a.kind != Kind::crossing) return static_cast<int>(a.kind) - static_cast<int>(b.kind);
  if (b.kind == Kind::start) return sign_of_difference(a.plane, path.from[a.axis]) * path.way(a.axis);
  return path.is_ray ? -1 : sign_of_difference(a.plane, path.to[a.axis]) * path.way(a.axis);
}

/// What of a path is in a cell.
struct Part {
  Place first, last;
};

template <class Tree, std::size_t d>
class Walk {
 public:
  Walk(const Tree& tree, const Path<d>& path, KdCells cells)
      : tree_(tree), path_(path), closed_(cells == KdCells::closed) {}

  std::vector<std::uint32_t> leaves() {
    const std::size_t first_leaf = tree_.leaves() - 1;
    visit(0, {{Kind::start, 0, 0, false}, {Kind::end, 0, 0, false}});
    while (height_ != 0) {
      const Entry top = stack_[--height_];
      if (top.node < first_leaf) {
        descend(top);
      } else {
        found_.push_back({static_cast<std::uint32_t>(top.node - first_leaf), top.part.first});
      }
    }
    // A path in a plane goes on in the cells of both sides at once.
    if (lies_in_plane_) {
      std::stable_sort(found_.begin(), found_.end(), [&](const Found& a, const Found& b) {
        const int order = compare(path_, a.entry, b.entry);
        return order != 0 ? order < 0 : !a.entry.open && b.entry.open;
      });
    }
    std::vector<std::uint32_t> leaves;
    for (const Found& f : found_) leaves.push_back(f.leaf);
    return leaves;
  }

 private:
  struct Entry {
    std::size_t node;
    Part part;
  };
  struct Found {
    std::uint32_t leaf;
    Place entry;
  };

  void visit(std::size_t node, const Part& part) { stack_[height_++] = {node, part}; }

  /// The part of both that is not empty; of two equal places the open one is the narrower.
  [[nodiscard]] std::optional<Part> after(const Part& part, const Place& from) const {
    const int later = compare(path_, from, part.first);
    Place first = later > 0 ? from : part.first;
    if (later == 0) first.open = first.open || from.open;
    return checked({first, part.last});
  }
  [[nodiscard]] std::optional<Part> before(const Part& part, const Place& to) const {
    const int earlier = compare(path_, part.last, to);
    Place last = earlier > 0 ? to : part.last;
    if (earlier == 0) last.open = last.open || to.open;
    return checked({part.first, last});
  }
  [[nodiscard]] std::optional<Part> checked(const Part& part) const {
    const int length = compare(path_, part.last, part.first);
    const bool is_some = length > 0 || (length == 0 && !part.first.open && !part.last.open);
    return is_some ? std::optional(part) : std::nullopt;
  }

  void descend(const Entry& e) {
    const std::uint8_t axis = tree_.axes[e.node];
    const double plane = tree_.planes[e.node], from = path_.from[axis];
    const std::size_t lower = 2 * e.node + 1, upper = lower + 1;
    const int way = path_.way(axis);
    if (way == 0) {
      const bool in_plane = closed_ && from == plane;
      if (in_plane || from >= plane) visit(upper, e.part);
      if (in_plane || from < plane) visit(lower, e.part);
      lies_in_plane_ = lies_in_plane_ || in_plane;
      return;
    }
    // Where cells are half open the crossing itself belongs to the upper one.
    const Place crossing{Kind::crossing, axis, plane, false}, without{Kind::crossing, axis, plane, !closed_};
    const auto near = before(e.part, way > 0 ? without : crossing), far = after(e.part, way > 0 ? crossing : without);
    if (far) visit(way > 0 ? upper : lower, *far);
    if (near) visit(way > 0 ? lower : upper, *near);
  }

  const Tree& tree_;
  const Path<d>& path_;
  bool closed_, lies_in_plane_ = false;
  std::array<Entry, 66> stack_;  // two a level at the most
  std::size_t height_ = 0;
  std::vector<Found> found_;
};

template <class Tree, std::size_t d>
std::vector<std::uint32_t> walked(const Tree& tree, const Path<d>& path, KdCells cells) {
  return Walk<Tree, d>(tree, path, cells).leaves();
}

}  // namespace
}  // namespace space::kd

std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Segment2& segment, KdCells cells) {
  require_finite_parts<Point2, Point2>("cells_along", {"segment.a", "segment.b"}, segment.a, segment.b);
  return space::kd::walked(tree, space::kd::Path<2>{coordinates(segment.a), coordinates(segment.b), false}, cells);
}
std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Ray2& ray, KdCells cells) {
  require_finite_parts<Point2, Vector2>("cells_along", {"ray.origin", "ray.direction"}, ray.origin, ray.direction);
  return space::kd::walked(tree, space::kd::Path<2>{coordinates(ray.origin), coordinates(ray.direction), true}, cells);
}
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Segment3& segment, KdCells cells) {
  require_finite_parts<Point3, Point3>("cells_along", {"segment.a", "segment.b"}, segment.a, segment.b);
  return space::kd::walked(tree, space::kd::Path<3>{coordinates(segment.a), coordinates(segment.b), false}, cells);
}
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Ray3& ray, KdCells cells) {
  require_finite_parts<Point3, Vector3>("cells_along", {"ray.origin", "ray.direction"}, ray.origin, ray.direction);
  return space::kd::walked(tree, space::kd::Path<3>{coordinates(ray.origin), coordinates(ray.direction), true}, cells);
}

}  // namespace plumb
