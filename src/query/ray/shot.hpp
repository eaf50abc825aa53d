// Ray cast: how is a line seen by shapes, over any number type?  Its parameters, and what is asked of them.
//
// Numbers are Approximate, Ball and BigDyadic in turn (certify/carried_errors.hpp), until all signs are certain.  A parameter is
// a quotient, or the lesser root of a quadratic; what a decision keeps of it is where it comes from, so that it can be
// computed again in other numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "arith/two_word_integer.hpp"
#include "certify/carried_errors.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/query/ray/ray.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

/// Signs, with a zero that is one by itself: a coordinate as given, or a difference of equal ones.
class RaySigns {
 public:
  Sign operator()(const Approximate& x) { return x.magnitude == 0 ? Sign::zero : signs_(x); }
  template <class T>
  Sign operator()(const T& x) {
    return signs_(x);
  }
  [[nodiscard]] bool certain() const { return signs_.certain(); }

 private:
  CertainSigns signs_;
};
}  // namespace plumb::query

namespace plumb {

/// Integers on the stack, asked as the other numbers are: certain where none takes more than they hold.
template <>
struct Carrying<StackDyadic, query::RaySigns> : query::RaySigns {
  static constexpr WorldKind kind = WorldKind::integers;

  Carrying() { StackDyadic::clear_range(); }
  [[nodiscard]] bool certain() const { return RaySigns::certain() && !StackDyadic::left_range(); }
};
template <>
struct Carrying<TwoWordInteger, query::RaySigns> : query::RaySigns {
  static constexpr WorldKind kind = WorldKind::integers;
};

}  // namespace plumb

namespace plumb::query {

template <class T>
using RayWorld = Carrying<T, RaySigns>;
using RayWorlds = CarriedErrors<RaySigns>;
/// For what is given in integers.
using RayIntegers = Worlds<RayWorld<TwoWordInteger>, RayWorld<StackDyadic>, RayWorld<BigDyadic>>;
/// For questions that are often degenerate: integers on the stack before those of GMP.
using RayWorldsByStack = Worlds<RayWorld<Approximate>, RayWorld<Ball>, RayWorld<StackDyadic>, RayWorld<BigDyadic>>;

template <class T>
Vec3<T> times(const Vec3<T>& v, const T& t) {
  return {v.x * t, v.y * t, v.z * t};
}

/// One part that is certainly not zero is enough.
template <class T>
bool is_zero(const Vec3<T>& v, RaySigns& ask) {
  for (const T* x : {&v.x, &v.y, &v.z}) {
    RaySigns alone;
    if (alone(*x) != Sign::zero && alone.certain()) return false;
  }
  return ask(v.x) == Sign::zero && ask(v.y) == Sign::zero && ask(v.z) == Sign::zero;
}

inline bool has_no_direction(const AnyRay& ray) {
  const auto& [x, y, z] = ray.direction;
  return ray.kind == AnyRay::Kind::segment ? ray.origin == ray.end : x == 0 && y == 0 && z == 0;
}
inline bool begins(const AnyRay& ray) { return ray.kind != AnyRay::Kind::line; }
inline bool ends(const AnyRay& ray) { return ray.kind == AnyRay::Kind::segment; }

/// Calls f with the ray, the segment or the line that it was made of.
template <class F>
decltype(auto) as_given(const AnyRay& ray, const F& f) {
  if (ends(ray)) return f(Segment3{ray.origin, ray.end});
  return begins(ray) ? f(Ray3{ray.origin, ray.direction}) : f(Line3{ray.origin, ray.direction});
}

template <class T>
Vec3<T> direction_of(const AnyRay& ray) {
  return ray.kind == AnyRay::Kind::segment ? between<T>(ray.origin, ray.end) : vector_of<T>(ray.direction);
}

/// The line, and the ray that it is of.
template <class T>
struct ShotLine {
  explicit ShotLine(const AnyRay& r) : ray(r), direction(direction_of<T>(r)) {}
  /// From a point as given to the origin, and back.
  [[nodiscard]] Vec3<T> origin_from(const Point3& p) const { return between<T>(p, ray.origin); }
  [[nodiscard]] Vec3<T> from_origin(const Point3& p) const { return between<T>(ray.origin, p); }

  const AnyRay& ray;
  Vec3<T> direction;
};

/// As a figure under a pose sees it: through no point that a double names.
template <>
struct ShotLine<Rational> {
  [[nodiscard]] Vec3<Rational> origin_from(const Point3& p) const { return origin - vector_of<Rational>(p); }

  AnyRay ray;  // where the line begins and ends, and whether it has a direction; its numbers are none of the line's
  Vec3<Rational> origin, direction;
};

/// numerator / denominator, with a positive denominator where it is compared.
template <class T>
struct Time {
  T numerator, denominator;
};
template <class T>
Time<T> time_zero() {
  return {T(0.0), T(1.0)};
}
template <class T>
Sign compare(const Time<T>& a, const Time<T>& b, RaySigns& ask) {
  return ask(a.numerator * b.denominator - b.numerator * a.denominator);
}
template <class T>
Time<T> with_positive_denominator(const T& n, const T& d, Sign sign_of_d) {
  return sign_of_d == Sign::negative ? Time<T>{T(0.0) - n, T(0.0) - d} : Time<T>{n, d};
}

/// Is the parameter one that the ray has?
template <class T>
bool in_range(const AnyRay& ray, const Time<T>& t, RaySigns& ask) {
  if (begins(ray) && ask(t.numerator) == Sign::negative) return false;
  return !ends(ray) || ask(t.numerator - t.denominator) != Sign::positive;
}

/// constant + slope t <= 0.
template <class T>
struct Linear {
  T constant, slope;
};

/// square t^2 + 2 half t + constant <= 0, square >= 0; discriminant = half^2 - square constant.
template <class T>
struct Quadratic {
  T square, half, constant, discriminant;
};

/// Which parameter: zero, that of a shape's own constraint or facet number `index`, or a root of its quadratic number
/// `index`.
struct When {
  enum class At : unsigned char { zero, quotient, root };
  At at = At::zero;
  std::uint32_t index = 0, part = 0;
};

/// What is decided of a hit; `normal` is the number of a face, where the shape has several.
struct Decided {
  When when;
  Feature feature;
  bool has_normal;
  std::uint32_t normal;
};

}  // namespace plumb::query
