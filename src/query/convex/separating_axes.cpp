#include "query/convex/separating_axes.hpp"

#include <algorithm>

#include "arith/running_error.hpp"
#include "plumb/arith/big.hpp"
#include "query/body/axis_body.hpp"

namespace plumb::query {
namespace {

using namespace axes;

/// What lies along an axis: between which numbers its ends are, infinite where the body goes on.
struct Reached {
  double low_least, low_most, high_least, high_most;
  bool certain = true;
};

/// An axis is the cross product of two edges, of which these are the body's own: nothing changes along them.
struct Own {
  std::size_t first = 6, second = 6;
  [[nodiscard]] bool has(std::size_t i) const { return i == first || i == second; }
};

Reached reached(const AxisBody<Running>& body, const arith::Vec<Running>& axis, const Own& own) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Reached r{infinity, infinity, -infinity, -infinity};
  double widths = 0;  // NaN or infinite where something is
  for (std::size_t i = 0; i < body.point_count; ++i) {
    const Running at = dot(body.points[i], axis);
    const double least = at.lower(), most = at.upper();
    widths += most - least;
    r.low_least = std::min(r.low_least, least);
    r.low_most = std::min(r.low_most, most);
    r.high_least = std::max(r.high_least, least);
    r.high_most = std::max(r.high_most, most);
  }
  for (std::size_t i = 0; i < body.edge_count; ++i) {
    if (body.ends[i] == EdgeEnd::none || own.has(i)) continue;
    const Unsure<Sign> along = dot(body.edges[i], axis).sign();
    if (!along.certain()) {
      r.certain = false;
      return r;
    }
    if (along.value() == Sign::zero) continue;
    if (along.value() == Sign::positive || body.ends[i] == EdgeEnd::both) r.high_least = r.high_most = infinity;
    if (along.value() == Sign::negative || body.ends[i] == EdgeEnd::both) r.low_least = r.low_most = -infinity;
  }
  r.certain = widths - widths == 0;
  return r;
}

enum class AxisVerdict : unsigned char { apart, level, across, flat, no_axis, unsure };

AxisVerdict by_doubles(const AxisBody<Running>& a, const AxisBody<Running>& b, const arith::Vec<Running>& axis,
                       const Own& own_a, const Own& own_b) {
  const Reached p = reached(a, axis, own_a);
  if (!p.certain) return AxisVerdict::unsure;
  const Reached q = reached(b, axis, own_b);
  if (!q.certain) return AxisVerdict::unsure;
  if (p.high_most < q.low_least || q.high_most < p.low_least) return AxisVerdict::apart;
  if (p.high_least > q.low_most && q.high_least > p.low_most) return AxisVerdict::across;
  return AxisVerdict::unsure;
}

/// Both ends exactly; nothing where the body goes on.
struct ExactReached {
  std::optional<BigDyadic> low, high;
};
ExactReached reached(const AxisBody<BigDyadic>& body, const arith::Vec<BigDyadic>& axis) {
  ExactReached r;
  for (std::size_t i = 0; i < body.point_count; ++i) {
    const BigDyadic at = dot(body.points[i], axis);
    if (!r.low || (at - *r.low).sign() == Sign::negative) r.low = at;
    if (!r.high || (at - *r.high).sign() == Sign::positive) r.high = at;
  }
  for (std::size_t i = 0; i < body.edge_count; ++i) {
    if (body.ends[i] == EdgeEnd::none) continue;
    const Sign along = dot(body.edges[i], axis).sign();
    if (along == Sign::zero) continue;
    if (along == Sign::positive || body.ends[i] == EdgeEnd::both) r.high.reset();
    if (along == Sign::negative || body.ends[i] == EdgeEnd::both) r.low.reset();
  }
  return r;
}

AxisVerdict exactly(const AxisBody<BigDyadic>& a, const AxisBody<BigDyadic>& b, const arith::Vec<BigDyadic>& axis) {
  if (axis.x.sign() == Sign::zero && axis.y.sign() == Sign::zero && axis.z.sign() == Sign::zero)
    return AxisVerdict::no_axis;
  const ExactReached p = reached(a, axis), q = reached(b, axis);
  const auto gap = [](const std::optional<BigDyadic>& low, const std::optional<BigDyadic>& high) {
    return low && high ? (*low - *high).sign() : Sign::negative;
  };
  const Sign above = gap(q.low, p.high), below = gap(p.low, q.high);
  if (above == Sign::positive || below == Sign::positive) return AxisVerdict::apart;
  if (above == Sign::zero && below == Sign::zero) return AxisVerdict::flat;
  return above == Sign::zero || below == Sign::zero ? AxisVerdict::level : AxisVerdict::across;
}

template <class Shape>
Point3 origin(const Shape& s) {
  if constexpr (has_body<Shape>) {
    return origin_of(s);
  } else {
    return {0, 0, 0};
  }
}

class Test {
 public:
  Test(const PosedView& a, const PosedView& b)
      : a_(a),
        b_(b),
        origin_(a.pose.stands() && b.pose.stands() ? with_shape(a.figure, [](const auto& s) { return origin(s); })
                                                   : Point3{0, 0, 0}) {}

  std::optional<Relation> relation() {
    if (is_apart_by_middles()) return Relation::disjoint;
    if (a_.figure.dimension == 2) {
      const arith::Vec<Running> up{Running(0.0), Running(0.0), Running(1.0)};
      for (std::size_t i = 0; i < near_a_.edge_count; ++i) {
        if (!add(cross(near_a_.edges[i], up), {i, 6}, {}, i, none)) return result();
      }
      for (std::size_t j = 0; j < near_b_.edge_count; ++j) {
        if (!add(cross(near_b_.edges[j], up), {}, {j, 6}, none, j)) return result();
      }
      return result();
    }
    for (std::size_t k = 0; k < near_a_.face_count; ++k) {
      const auto [i, j] = near_a_.faces[k];
      if (!add(cross(near_a_.edges[i], near_a_.edges[j]), {i, j}, {}, k, face)) return result();
    }
    for (std::size_t k = 0; k < near_b_.face_count; ++k) {
      const auto [i, j] = near_b_.faces[k];
      if (!add(cross(near_b_.edges[i], near_b_.edges[j]), {}, {i, j}, face, k)) return result();
    }
    for (std::size_t i = 0; i < near_a_.edge_count; ++i) {
      for (std::size_t j = 0; j < near_b_.edge_count; ++j) {
        if (!add(cross(near_a_.edges[i], near_b_.edges[j]), {i, 6}, {j, 6}, i, j)) return result();
      }
    }
    return result();
  }

 private:
  static constexpr std::size_t none = 100, face = 200;
  template <class T>
  [[nodiscard]] AxisBody<T> body(const PosedView& v) const {
    AxisBody<T> made = with_shape(v.figure, [this](const auto& s) {
      if constexpr (has_body<std::remove_cvref_t<decltype(s)>>) {
        return axis_body_of<T>(s, origin_);
      } else {
        return AxisBody<T>{};
      }
    });
    return made;
  }
  /// Both under their poses, each as large as the other's weight makes it.
  template <class T>
  [[nodiscard]] std::array<AxisBody<T>, 2> bodies() const {
    std::array<AxisBody<T>, 2> made{body<T>(a_), body<T>(b_)};
    if (a_.pose.stands() && b_.pose.stands()) return made;
    const std::array poses{weighted_pose<T>(a_.pose), weighted_pose<T>(b_.pose)};
    for (std::size_t i = 0; i < 2; ++i) {
      pose(made[i], poses[i]);
      if (!poses[1 - i].has_weight) continue;
      for (std::size_t k = 0; k < made[i].point_count; ++k) made[i].points[k] = made[i].points[k] * poses[1 - i].weight;
    }
    return made;
  }

  // Along the line of their middles, which most pairs that lie apart are.
  bool is_apart_by_middles() {
    const arith::Vec<double> from = middle(near_a_), to = middle(near_b_);
    const arith::Vec<Running> axis{Running(to.x - from.x), Running(to.y - from.y), Running(to.z - from.z)};
    return by_doubles(near_a_, near_b_, axis, {}, {}) == AxisVerdict::apart;
  }
  static arith::Vec<double> middle(const AxisBody<Running>& body) {
    arith::Vec<double> sum{0, 0, 0};
    const double share = 1 / static_cast<double>(body.point_count);
    for (std::size_t i = 0; i < body.point_count; ++i) {
      const auto& p = body.points[i];
      sum = sum + arith::Vec<double>{p.x.value * share, p.y.value * share, p.z.value * share};
    }
    return sum;
  }

  bool add(const arith::Vec<Running>& axis, const Own& own_a, const Own& own_b, std::size_t i, std::size_t j) {
    AxisVerdict v = by_doubles(near_a_, near_b_, axis, own_a, own_b);
    if (v == AxisVerdict::unsure) v = by_integers(i, j);
    apart_ = v == AxisVerdict::apart;
    flat_ = v == AxisVerdict::flat;
    level_ = level_ || v == AxisVerdict::level;
    any_ = any_ || v != AxisVerdict::no_axis;
    return !apart_ && !flat_;
  }
  [[nodiscard]] std::optional<Relation> result() const {
    if (apart_) return Relation::disjoint;
    if (flat_ || !any_) return {};
    return level_ ? Relation::touching : Relation::overlapping;
  }

  AxisVerdict by_integers(std::size_t i, std::size_t j) {
    if (!exact_) exact_ = bodies<BigDyadic>();
    const auto& [a, b] = *exact_;
    const arith::Vec<BigDyadic> up{BigDyadic(0), BigDyadic(0), BigDyadic(1)};
    const auto axis = j == none   ? cross(a.edges[i], up)
                      : i == none ? cross(b.edges[j], up)
                      : j == face ? cross(a.edges[a.faces[i][0]], a.edges[a.faces[i][1]])
                      : i == face ? cross(b.edges[b.faces[j][0]], b.edges[b.faces[j][1]])
                                  : cross(a.edges[i], b.edges[j]);
    return exactly(a, b, axis);
  }

  const PosedView &a_, &b_;
  Point3 origin_;
  std::array<AxisBody<Running>, 2> near_ = bodies<Running>();
  const AxisBody<Running>&near_a_ = near_[0], &near_b_ = near_[1];
  std::optional<std::array<AxisBody<BigDyadic>, 2>> exact_;
  bool apart_ = false, flat_ = false, level_ = false, any_ = false;
};

}  // namespace

bool has_axes(const FlatView& v) {
  return with_shape(v, []<class Shape>(const Shape&) { return has_body<Shape>; });
}

std::optional<Relation> relate_by_axes(const PosedView& a, const PosedView& b) { return Test(a, b).relation(); }

}  // namespace plumb::query
