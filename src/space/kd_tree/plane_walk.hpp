// Ray traversal of planes that divide space in halves: which leaves does a path visit, in which order?
//
// The descent keeps what of the path is in a node's cell, between two of: its start, its end, and crossings of planes.
// Laws: those of plumb/space/kd_tree/cells_along.hpp.  Trees have at most 64 levels.
// Source: RTCD 7.4.1.
// Cost: one or two comparisons of parameters for each plane that is met: of doubles as given for planes of one axis, of
// certified signs for others; no parameter is computed.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "plumb/certify/sign_of.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/kd_tree/cells_along.hpp"
#include "query/body/figure_input.hpp"
#include "space/octree/crossing_sign.hpp"

namespace plumb::space::kd {

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

/// Of a segment or a ray; throws NonFinite.
template <class Way>
auto checked_path(std::string_view function, const Way& way) {
  if constexpr (requires { way.direction; }) {
    query::require_figure(function, "ray", way);
    return Path<sizeof(way.origin) / sizeof(double)>{coordinates(way.origin), coordinates(way.direction), true};
  } else {
    query::require_figure(function, "segment", way);
    return Path<sizeof(way.a) / sizeof(double)>{coordinates(way.a), coordinates(way.b), false};
  }
}

inline int sign_of_difference(double a, double b) { return static_cast<int>(a > b) - static_cast<int>(a < b); }

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
    const Sign sign = crossing_order(!path.is_ray, a.plane, path.from[a.axis], path.to[a.axis], b.plane,
                                     path.from[b.axis], path.to[b.axis]);
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

/// `Planes` says of the nodes of a tree, from `root` on, is_leaf and leaf, axis and plane, lower and upper.
template <class Planes, std::size_t d>
class PlaneWalk {
 public:
  PlaneWalk(const Planes& planes, const Path<d>& path, WalkedCells cells)
      : planes_(planes), path_(path), closed_(cells == WalkedCells::closed) {}

  /// visit(leaf, entry) in the order of entry; but where cells are closed and the path lies in a plane, both sides are
  /// told one after the other.  Ends where it returns Descent::stop.
  template <class Visit>
  void each_leaf(const Visit& visit) {
    push(Planes::root, {{Kind::start, 0, 0, false}, {Kind::end, 0, 0, false}});
    while (height_ != 0) {
      const Entry top = stack_[--height_];
      if (!planes_.is_leaf(top.node)) {
        descend(top);
      } else if (visit(planes_.leaf(top.node), top.part.first) == Descent::stop) {
        return;
      }
    }
  }

  std::vector<std::uint32_t> leaves(std::vector<std::uint32_t> leaves) {
    leaves.clear();
    std::vector<Found> found;
    each_leaf([&](std::size_t leaf, const Place& entry) {
      found.push_back({static_cast<std::uint32_t>(leaf), entry});
      return Descent::go_on;
    });
    // A path in a plane goes on in the cells of both sides at once.
    if (lies_in_plane_) {
      std::stable_sort(found.begin(), found.end(), [&](const Found& a, const Found& b) {
        const int order = compare(path_, a.entry, b.entry);
        return order != 0 ? order < 0 : !a.entry.open && b.entry.open;
      });
    }
    for (const Found& f : found) leaves.push_back(f.leaf);
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

  void push(std::size_t node, const Part& part) { stack_[height_++] = {node, part}; }

  void descend(const Entry& e) {
    const std::uint8_t axis = planes_.axis(e.node);
    const double plane = planes_.plane(e.node), from = path_.from[axis];
    const std::size_t lower = planes_.lower(e.node), upper = planes_.upper(e.node);
    const int way = path_.way(axis);
    if (way == 0) {
      const bool in_plane = closed_ && from == plane;
      if (in_plane || from >= plane) push(upper, e.part);
      if (in_plane || from < plane) push(lower, e.part);
      lies_in_plane_ = lies_in_plane_ || in_plane;
      return;
    }
    const std::size_t near = way > 0 ? lower : upper, far = way > 0 ? upper : lower;
    Place crossing{Kind::crossing, axis, plane, false};
    const Place &first = e.part.first, &last = e.part.last;
    const int behind_first = compare(path_, crossing, first);
    if (behind_first < 0) return push(far, e.part);
    const int before_last = compare(path_, last, crossing);
    if (before_last < 0) return push(near, e.part);
    // The crossing is on the part, or an end of it.  Where cells are half open it belongs to the upper one; of two equal
    // places the open one is the narrower.
    crossing.open = !closed_ && way < 0;
    Place entry = behind_first > 0 ? crossing : first;
    entry.open = entry.open || crossing.open;
    if (before_last > 0 || (before_last == 0 && !entry.open && !last.open)) push(far, {entry, last});
    crossing.open = !closed_ && way > 0;
    Place end = before_last > 0 ? crossing : last;
    end.open = end.open || crossing.open;
    if (behind_first > 0 || (behind_first == 0 && !first.open && !end.open)) push(near, {first, end});
  }

  const Planes planes_;
  const Path<d>& path_;
  bool closed_, lies_in_plane_ = false;
  std::array<Entry, 66> stack_;  // one a level, and one more
  std::size_t height_ = 0;
};

}  // namespace plumb::space::kd
