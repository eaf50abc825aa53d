// Which numbers are told of a contact?  Each rounded once, over a number type that knows how far off it is.
//
// A corner both of whose points are as far as anything of their bodies is as far apart as these are, and no more than one
// of its points has to be computed.
// Laws: what is told is exact, then rounded; what the numbers leave open is nothing.
// Source: query/contact/corner_numbers.hpp.
// Cost: of pairs of doubles some 150 to 300 operations a corner; of balls four times that.
#pragma once

#include "plumb/arith/ball.hpp"
#include "query/contact/contact_pair.hpp"
#include "query/contact/corner_numbers.hpp"

namespace plumb::query::touching {

/// Is there a contact?  Where there is none the rest is not told.
struct Whole {
  bool is_near;
  Relation relation;
  Vector3 normal;
  double distance;
  bool is_by_integers = false;  // so will be the distances of corners that are nearly as far apart
};

/// Is it within the margin?
struct Corner {
  bool is_near;
  ContactCorner told;
};

/// A list of numbers, each rounded once.
class Told {
 public:
  template <class T>
  double operator()(const T& x) {
    const auto nearest = x.nearest();
    all_ = all_ && nearest;
    return nearest.value_or(0);
  }
  [[nodiscard]] bool all() const { return all_; }

 private:
  bool all_ = true;
};

template <class T>
std::optional<Sign> sign_where_certain(const T& x) {
  if constexpr (requires { x.certain_sign(); }) {  // of zero it is where there are no terms
    const int s = x.certain_sign();
    return s == 0 && x.magnitude != 0 ? std::nullopt : std::optional(static_cast<Sign>(s));
  } else {
    const Unsure<Sign> s = x.sign();
    return s.certain() ? std::optional(s.value()) : std::nullopt;
  }
}

/// Balls know what is halfway between doubles, as sums of a few doubles are.
[[gnu::noinline]] inline Vec<Ball> place_by_balls(const CoreCorners& c, std::size_t i) {
  return parting::corner_of<Ball>(c, i);
}

[[gnu::noinline]] inline Vec<Ball> normal_by_balls(const Pair& p) { return p.normal<Ball>(); }

/// What the numbers leave open.
enum class Open : unsigned char { nothing, distance, place };

template <class T>
class ToldNumbers {
 public:
  explicit ToldNumbers(const Pair& p)
      : pair_(p),
        normal_(normal_of(p)),
        square_(p.way().is_along_axis() ? T(1.0) : sparse_dot(normal_, normal_)),
        length_(is_one(square_) ? square_ : root(square_)),
        share_(over(T(1.0), length_)),
        radii_(T(p.radii().given(0)) + T(p.radii().given(1))),
        limit_(radii_ + T(p.margin())) {}

  [[nodiscard]] const Vec<T>& normal() const { return normal_; }
  [[nodiscard]] std::array<bool, 3> zeros() const {
    return {is_none(normal_.x), is_none(normal_.y), is_none(normal_.z)};
  }
  [[nodiscard]] T height() const { return pair_.height(normal_); }

  /// Of bodies that are so far apart, times the length of the normal.
  [[nodiscard]] std::optional<Whole> whole(const T& height, Open& open) const {
    const T along = times(height, share_);
    open = Open::distance;
    const auto beyond = beyond_limit(height, T(1.0), along);
    if (!beyond) return {};
    if (*beyond) return Whole{false, Relation::disjoint, {}, 0};
    const auto side = sign_where_certain(pair_.radii().are_none() ? height : along - radii_);
    if (!side) return {};
    Told distance, unit;
    const double apart = *side == Sign::zero ? 0 : distance(along - radii_);
    if (!distance.all()) return {};
    open = Open::place;
    const Point3 normal = rounded(scaled(normal_, share_), unit);
    if (!unit.all()) return {};
    open = Open::nothing;
    return Whole{true, static_cast<Relation>(-static_cast<int>(*side)), {normal.x, normal.y, normal.z}, apart};
  }

  /// `gap`: where it is known to more digits.
  [[nodiscard]] std::optional<Corner> corner(const CornerPlaces<T>& places, const Found& f, Open& open,
                                             const std::optional<Gap<T>>& gap = {}) const {
    const CornerFractions<T> n = places.of(f);
    const T share = over(T(1.0), n.whole), height = gap ? gap->height : n.height;
    const T along = times(gap ? over(height, gap->whole) : times(height, share), length_);
    open = Open::distance;
    const auto beyond = beyond_limit(height, gap ? gap->whole : n.whole, along);
    if (!beyond) return {};
    if (*beyond) return Corner{false, {}};
    Told distance, places_told;
    const double apart = pair_.radii().are_none() && is_none(height) ? 0 : distance(along - radii_);
    if (!distance.all()) return {};
    open = Open::place;
    const auto at = [&](const PlaceOn<T>& p, double radius) {
      Vec<T> x = p.base;
      const bool is_level = p.level_axis >= 0, is_upright = is_level && p.level_axis == axis_along(p.along);
      if (!is_upright && !is_none(p.numerator)) {
        x = sparse_sum(x, scaled(p.along, times(p.numerator, share)));
      }
      if (is_level) part(x, p.level_axis) = part(*p.level, p.level_axis);
      return rounded(moved(x, radius), places_told);
    };
    const bool is_vertex = pair_.radii().are_none();
    const bool of_a = is_vertex && (f.kind == CornerKind::vertex_of_a || f.kind == CornerKind::both_vertices);
    const bool of_b = is_vertex && (f.kind == CornerKind::vertex_of_b || f.kind == CornerKind::both_vertices);
    const Corner c{
        true,
        {of_a ? vertex(places.view_of_a(), f.i, places_told) : at(n.on_a, pair_.radii().given(0)),
         of_b ? vertex(places.view_of_b(), f.j, places_told) : at(n.on_b, -pair_.radii().given(1)), apart, f.id}};
    if (!places_told.all()) return {};
    open = Open::nothing;
    return c;
  }

  /// Of a corner that is as far apart as the bodies: by `step` from a to b, which is none where they touch.
  [[nodiscard]] std::optional<Corner> level_corner(const CornerPlaces<T>& places, const Found& f, const Whole& of_pair,
                                                   const Vec<T>& step) const {
    const bool from_b = f.kind == CornerKind::vertex_of_b;
    Vec<T> x = from_b ? places.view_of_b().at(f.j) : places.view_of_a().at(f.i);
    if (f.kind == CornerKind::edges) {
      const CornerFractions<T> n = places.of(f);
      x = x + n.on_a.along * times(n.on_a.numerator, over(T(1.0), n.whole));
    }
    Told told;
    const auto other = [&](const T& from, const T& by) { return is_none(by) ? from : from_b ? from - by : from + by; };
    const auto far = [&] { return Vec<T>{other(x.x, step.x), other(x.y, step.y), other(x.z, step.z)}; };
    Corner c{true, {{}, {}, of_pair.distance, f.id}};
    if (pair_.radii().are_none()) {
      const Point3 near = f.kind == CornerKind::edges ? rounded(x, told)
                          : from_b                    ? vertex(places.view_of_b(), f.j, told)
                                                      : vertex(places.view_of_a(), f.i, told);
      const Vec<T> y = far();
      const auto same = [&](double of_near, const T& by, const T& of_far) {
        return is_none(by) ? of_near : told(of_far);
      };
      const Point3 end{same(near.x, step.x, y.x), same(near.y, step.y, y.y), same(near.z, step.z, y.z)};
      c.told.on_a = from_b ? end : near, c.told.on_b = from_b ? near : end;
    } else {
      const Vec<T> y = far();
      c.told.on_a = rounded(moved(from_b ? y : x, pair_.radii().given(0)), told);
      c.told.on_b = rounded(moved(from_b ? x : y, -pair_.radii().given(1)), told);
    }
    if (!told.all()) return {};
    return c;
  }
  /// From a to b, of bodies that are so far apart.
  [[nodiscard]] Vec<T> step(const T& height) const { return scaled(normal_, over(height, square_)); }

 private:
  /// Pairs of doubles cannot tell what is none: balls can.
  static Vec<T> normal_of(const Pair& p) {
    Vec<T> n = p.normal<T>();
    if constexpr (!std::is_same_v<T, Ball>) {
      const auto may_be_none = [](const T& x) { return x.high == 0 && x.low == 0 && x.magnitude != 0; };
      if (may_be_none(n.x) || may_be_none(n.y) || may_be_none(n.z)) settle_zeros(normal_by_balls(p), n);
    }
    return n;
  }
  static void settle_zeros(const Vec<Ball>& known, Vec<T>& n) {
    if (certainly_zero(known.x)) n.x = T(0.0);
    if (certainly_zero(known.y)) n.y = T(0.0);
    if (certainly_zero(known.z)) n.z = T(0.0);
  }
  static bool is_one(const T& x) {
    if constexpr (requires { x.radius; }) {
      return x.high == 1 && x.low == 0 && x.radius == 0;
    } else {
      return x.high == 1 && x.low == 0 && x.error == 0;
    }
  }
  static bool is_none(const T& x) {
    if constexpr (requires { x.radius; }) {
      return certainly_zero(x);
    } else {
      return x.magnitude == 0;
    }
  }
  static T times(const T& x, const T& by) { return is_one(by) ? x : x * by; }
  /// What is times nothing is none.
  static Vec<T> scaled(const Vec<T>& v, const T& by) {
    const auto part_of = [&](const T& x) { return is_none(x) ? T(0.0) : times(x, by); };
    return {part_of(v.x), part_of(v.y), part_of(v.z)};
  }
  static T over(const T& x, const T& by) { return is_one(by) ? x : quotient(x, by); }
  static T& part(Vec<T>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
  static const T& part(const Vec<T>& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

  [[nodiscard]] Vec<T> moved(const Vec<T>& x, double radius) const {
    return radius == 0 ? x : sparse_sum(x, scaled(normal_, share_ * T(radius)));
  }
  template <class N>
  static Point3 rounded(const Vec<N>& x, Told& told) {
    return {told(x.x), told(x.y), told(x.z)};
  }
  static Point3 vertex(const View<T>& v, std::size_t i, Told& told) {
    const Vec<T>& p = v.at(i);
    Told quick;
    const Point3 x = rounded(p, quick);
    return quick.all() ? x : rounded(place_by_balls(v.seen.core, v.f.corners[i]), told);
  }

  /// Of height / whole normals; `along` is that with their length.
  [[nodiscard]] std::optional<bool> beyond_limit(const T& height, const T& whole, const T& along) const {
    const auto h = sign_where_certain(height), w = sign_where_certain(whole);
    if (!h || !w) return {};
    if (*h * *w != Sign::positive) return false;
    const auto s = sign_where_certain(along - limit_);
    if (!s) return {};
    return *s == Sign::positive;
  }

  const Pair& pair_;
  Vec<T> normal_;
  T square_, length_, share_, radii_, limit_;
};

}  // namespace plumb::query::touching
