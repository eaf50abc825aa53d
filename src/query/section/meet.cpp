#include "query/section/meet.hpp"

#include <algorithm>

#include "plumb/query/section/intersection.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/set.hpp"
#include "query/section/corner_name.hpp"

namespace plumb::query::meeting {
namespace {

template <std::size_t N>
using Common = std::conditional_t<N == 2, Intersection2, Intersection3>;
template <std::size_t N>
using ExactPointOf = std::conditional_t<N == 2, ExactPoint2, ExactPoint3>;

/// p + the direction times the weight's sign, which is positive.
template <std::size_t N>
ExactPointOf<N> beyond(const Weighted<BigDyadic, N>& p, const Vec<BigDyadic, N>& direction, bool backward) {
  Weighted<BigDyadic, N> q = p;
  for (std::size_t axis = 0; axis < N; ++axis) {
    const BigDyadic step = direction[axis] * p.weight;
    q.at[axis] = backward ? q.at[axis] - step : q.at[axis] + step;
  }
  return rational(q);
}

/// One computation in the numbers T; nothing where they cannot tell.
template <class T, std::size_t N>
class ConvexMeeting {
 public:
  ConvexMeeting(const ConvexSet<N>& a, const ConvexSet<N>& b, const SignTable& of_a, const SignTable& of_b)
      : a_(a), b_(b), of_a_(of_a), of_b_(of_b) {}

  std::optional<Common<N>> operator()() { return a_.dimension <= 1 ? linear() : hull(); }

 private:
  // a is a line, ray, segment or point.
  std::optional<Common<N>> linear() {
    const Edge<N>& e = a_.edges[0];
    const auto piece = Clip<T, N>(a_, e, b_, of_a_, ask_)();
    if (!ask_.certain()) return {};
    Common<N> common;
    if (!piece) return common;
    const bool from_far = piece->from.own && piece->from.index == infinity;
    const bool to_far = piece->to.own && piece->to.index == infinity;
    if (from_far && to_far) {
      common.kind = IntersectionKind::line;
      common.vertices = {e.point, e.named ? ExactPointOf<N>(e.second) : further(e.point, false)};
      return common;
    }
    const Corner<T, N> from = corner(0, from_far ? piece->to : piece->from);
    const auto first = corner_name(from, a_, b_);
    if (!first) return {};
    common.vertices.push_back(*first);
    if (piece->is_point) {
      common.kind = IntersectionKind::point;
    } else if (from_far || to_far) {
      common.kind = IntersectionKind::ray;
      const bool whole = piece->from.own && e.named && to_far;
      common.vertices.push_back(whole ? ExactPointOf<N>(e.second) : further(*first, from_far));
    } else {
      const auto last = corner_name(corner(0, piece->to), a_, b_);
      if (!last) return {};
      common.kind = IntersectionKind::segment;
      common.vertices.push_back(*last);
      if (descends()) std::swap(common.vertices[0], common.vertices[1]);
    }
    return common;
  }

  ExactPointOf<N> further(const ExactPointOf<N>& p, bool backward) {
    const auto at = coordinates_in<BigDyadic>(p);
    if (at.weight.sign() == Sign::positive) return beyond<N>(at, along<BigDyadic, N>(a_, a_.edges[0]), backward);
    return beyond<N>(at, along<BigDyadic, N>(a_, a_.edges[0]), !backward);
  }

  // Does the edge of a run down the lexicographic order?
  [[nodiscard]] bool descends() const {
    if (a_.is_exact()) return false;
    for (std::size_t axis = 0; axis < N; ++axis) {
      if (const int s = direction_sign(a_, a_.edges[0], axis); s != 0) return s < 0;
    }
    return false;
  }

  Corner<T, N> corner(std::size_t edge, const End<T>& end, bool of_b = false) {
    const ConvexSet<N>&set = of_b ? b_ : a_, &other = of_b ? a_ : b_;
    return end.own ? vertex_corner<T, N>(set, end.index, of_b) : crossing_corner<T, N>(set, edge, other, end, of_b);
  }

  // Two sides of polygons of one plane cross at one point, whichever is clipped by the other.
  [[nodiscard]] Origin canonical(const Origin& o) const {
    if (!o.of_b || o.bound == infinity || a_.first_side < 0 || b_.first_side < 0 || o.bound < a_.first_side) return o;
    return {false, o.bound - a_.first_side, o.index + b_.first_side};
  }

  bool add_pieces(bool of_b) {
    const ConvexSet<N>&set = of_b ? b_ : a_, &other = of_b ? a_ : b_;
    for (std::size_t e = 0; e < set.edges.size(); ++e) {
      const auto piece = Clip<T, N>(set, set.edges[e], other, of_b ? of_b_ : of_a_, ask_)();
      if (!ask_.certain()) return false;
      if (!piece) continue;
      add(corner(e, piece->from, of_b));
      if (!piece->is_point) add(corner(e, piece->to, of_b));
    }
    return true;
  }
  void add(Corner<T, N> c) {
    c.origin = canonical(c.origin);
    if (std::ranges::none_of(corners_, [&](const auto& other) { return other.origin == c.origin; }))
      corners_.push_back(std::move(c));
  }

  std::optional<Common<N>> hull() {
    if (!add_pieces(false) || !add_pieces(true)) return {};
    sort_corners(corners_, ask_);
    if (!ask_.certain()) return {};
    IntersectionKind kind = IntersectionKind::polygon;
    if (corners_.size() > 2) {
      const int axis = N == 2 ? 2 : a_.look >= 0 ? a_.look : b_.look;
      if (axis < 0) return without_look();
      corners_ = extreme(corners_, looks[static_cast<std::size_t>(axis)], ask_);
      if (!ask_.certain()) return {};
    }
    if (corners_.size() < 3) {
      kind = std::array{IntersectionKind::nothing, IntersectionKind::point, IntersectionKind::segment}[corners_.size()];
    }
    return named(kind);
  }

  std::optional<Common<N>> named(IntersectionKind kind) {
    Common<N> common{kind, {}};
    common.vertices.reserve(corners_.size());
    for (const Corner<T, N>& c : corners_) {
      const auto name = corner_name(c, a_, b_);
      if (!name) return {};
      common.vertices.push_back(*name);
    }
    return common;
  }

  // A solid with all of space: its plane, if it has one, is not known.
  std::optional<Common<N>> without_look() {
    if constexpr (N == 3 && std::is_same_v<T, BigDyadic>) {
      for (const std::size_t axis : {2u, 0u, 1u}) {
        const auto flat = [&](std::size_t i) {
          return turn(corners_[0], corners_.back(), corners_[i], looks[axis], ask_) == Sign::zero;
        };
        std::size_t off = 1;
        while (off + 1 < corners_.size() && flat(off)) ++off;
        if (off + 1 == corners_.size()) continue;
        const auto all = named(IntersectionKind::solid);
        const auto& v = all->vertices;
        if (std::ranges::any_of(v, [&](const auto& p) { return orient3d(v[0], v.back(), v[off], p) != Sign::zero; }))
          return all;
        corners_ = extreme(corners_, looks[axis], ask_);
        return named(IntersectionKind::polygon);
      }
      corners_.erase(corners_.begin() + 1, corners_.end() - 1);
      return named(IntersectionKind::segment);
    }
    return {};
  }

  const ConvexSet<N>&a_, &b_;
  const SignTable &of_a_, &of_b_;
  CertainSigns ask_;
  std::vector<Corner<T, N>> corners_;
};

template <std::size_t N>
Common<N> meet_sets(const ConvexSet<N>& a, const ConvexSet<N>& b) {
  if (a.dimension < 0 || b.dimension < 0) return {};
  if (b.dimension <= 1 && a.dimension > b.dimension) return meet_sets(b, a);
  SignTable of_a, of_b;
  if (!of_a.fill(b, a) || !of_b.fill(a, b)) return {};
  if (!a.is_exact() && !b.is_exact()) {
    if (auto common = ConvexMeeting<Approximate, N>(a, b, of_a, of_b)()) return std::move(*common);
    if (auto common = ConvexMeeting<Ball, N>(a, b, of_a, of_b)()) return std::move(*common);
  }
  return std::move(*ConvexMeeting<BigDyadic, N>(a, b, of_a, of_b)());
}

}  // namespace

Intersection2 meet(const ConvexSet<2>& a, const ConvexSet<2>& b) { return meet_sets<2>(a, b); }
Intersection3 meet(const ConvexSet<3>& a, const ConvexSet<3>& b) { return meet_sets<3>(a, b); }

}  // namespace plumb::query::meeting

namespace plumb::query {

Intersection2 common_set2(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  return meeting::meet(meeting::convex_set2(a).value(), meeting::convex_set2(b).value());
}

Intersection3 common_set3(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  return meeting::meet(meeting::convex_set3(a).value(), meeting::convex_set3(b).value());
}

}  // namespace plumb::query
