// Closest points of two hulls: are these up to three corners of the difference all that the nearest point needs, and
// does every other corner of both lie strictly behind the planes through it?  A statement over any world.
//
// What query/separation/nearest_corners.hpp asks over numbers that carry their errors, of points of doubles as given: of
// the search where all is strict, so that the nearest pair is the only one of these corners; where doubles do not tell,
// with what is level and what holds the origin.
// Laws: those of certify/world.hpp.
// Source: Wolfe 1976; Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// Cost: 30 to 90 operations, and 8 for each corner that is asked.
#pragma once

#include <algorithm>
#include <span>

#include "plumb/certify/certainly.hpp"
#include "query/gjk/origin.hpp"

namespace plumb::query::gjk_origin {

/// Corners of one hull that have to lie behind the plane through `ref`, but for those that are known to lie in it.
struct Asked {
  const Point3* at;
  std::span<const std::uint32_t> of;  // their numbers; where there is none all of the first `size`
  std::uint32_t size;
  std::span<const std::uint32_t> in_plane;  // the first is that through which the plane goes

  template <class Take>
  [[gnu::always_inline]] void each(const Take& take) const {
    const auto is_known = [this](std::uint32_t i) {
      for (const std::uint32_t k : in_plane) {
        if (i == k) return true;
      }
      return false;
    };
    for (const std::uint32_t i : of) {
      if (!is_known(i)) take(at[i]);
    }
    for (std::uint32_t i = 0; of.empty() && i < size; ++i) {
      if (!is_known(i)) take(at[i]);
    }
  }
};

/// What these corners of the difference are to the origin, and what else lies in the planes through the nearest points.
struct Nearness {
  bool is_so = false;     // the nearest point of their plane is within their hull, and nothing is nearer
  bool meets = false;     // it is the origin
  unsigned positive = 0;  // the corners that it needs; where it is not the origin and not all are needed, not so
  std::array<bool, 2> is_level{};  // of a, of b: there are others in the planes
};

/// Strictly: the nearest pair is the only one of these corners, and no others lie in the planes.
template <int count, bool is_strict = true>
struct AreNearest {
  static constexpr int highest = count == 1 ? 2 : 4;
  static constexpr Scales scales{.count = 2};

  template <class W>
  [[gnu::always_inline]] inline auto operator()(W& w, const Pairs& p, const Asked& a, const Asked& b) const {
    const Nearness n = nearness(w, p, a, b);
    if constexpr (is_strict) {
      return n.is_so;
    } else {
      return n;
    }
  }

 private:
  template <class W>
  [[gnu::always_inline]] static inline Nearness nearness(W& w, const Pairs& p, const Asked& a, const Asked& b) {
    using N = std::remove_cvref_t<decltype(w.difference(0.0, 0.0))>;
    using V = std::array<N, 3>;
    const auto corner = [&](std::size_t i) {
      return V{w.difference(p.a[i].x, p.b[i].x), w.difference(p.a[i].y, p.b[i].y), w.difference(p.a[i].z, p.b[i].z)};
    };
    const auto less = [](const auto& u, const auto& v) { return std::array{u[0] - v[0], u[1] - v[1], u[2] - v[2]}; };
    const auto crossed = [](const auto& u, const auto& v) {
      return std::array{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const auto product = [](const auto& u, const auto& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; };
    const auto is_positive = [&](const auto& x) { return w.sign(x) == Sign::positive; };
    const auto is_negative = [&](const auto& x) { return w.sign(x) == Sign::negative; };
    [[maybe_unused]] const auto is_zero = [&](const auto& v) {
      return w.sign(v[0]) == Sign::zero && w.sign(v[1]) == Sign::zero && w.sign(v[2]) == Sign::zero;
    };
    const V d = corner(0);
    if constexpr (count == 1) {
      if constexpr (!is_strict) {
        if (is_zero(d)) return {true, true, 1};
      }
      return beside(w, d, true, a, b);
    } else {
      const auto u = less(corner(1), d);
      if constexpr (count == 2) {
        const auto along = product(u, d);  // below zero, and above minus the square of u
        const auto rest = product(u, u) + along;
        if constexpr (is_strict) {
          if (!is_negative(along) || !is_positive(rest)) return {};
        }
        const auto turn = crossed(d, u);
        if constexpr (!is_strict) {
          const Nearness weights = needed(std::array{w.sign(rest), -w.sign(along)});
          if (weights.positive != 0 && is_zero(turn)) return {true, true, weights.positive};
          if (!weights.is_so) return weights;
        }
        return beside(w, crossed(u, turn), true, a, b);
      } else {
        const auto v = less(corner(2), d);
        const auto normal = crossed(u, v);
        const auto second = product(crossed(d, v), normal), third = product(crossed(u, d), normal);
        const auto rest = product(normal, normal) + second + third;
        if constexpr (is_strict) {
          if (!is_negative(second) || !is_negative(third) || !is_positive(rest)) return {};
        } else {
          const Nearness weights = needed(std::array{w.sign(rest), -w.sign(second), -w.sign(third)});
          if (weights.positive == 0) return {};
          const Sign side = w.sign(product(normal, d));
          if (side == Sign::zero) return {true, true, weights.positive};
          return weights.is_so ? beside(w, normal, side == Sign::positive, a, b) : weights;
        }
        const Sign side = w.sign(product(normal, d));
        return side != Sign::zero ? beside(w, normal, side == Sign::positive, a, b) : Nearness{};
      }
    }
  }

  /// By the signs of the weights, which are not all zero of corners that are independent.
  template <std::size_t n>
  static Nearness needed(const std::array<Sign, n>& weights) {
    Nearness r{true};
    for (std::size_t i = 0; i < n; ++i) {
      if (weights[i] == Sign::negative) return {};
      if (weights[i] == Sign::positive) r.positive |= 1U << i;
      r.is_so = r.is_so && weights[i] == Sign::positive;
    }
    return r;
  }
  /// Is all of a farther along than its plane, and all of b less far than its own, or in them where they may be?
  /// `forth`: or the other way.
  template <class W, class Way>
  [[gnu::always_inline]] static inline Nearness beside(W& w, const Way& way, bool forth, const Asked& a,
                                                       const Asked& b) {
    const Sign of_a = side_of(w, way, forth, a);
    if (of_a == Sign::negative || (is_strict && of_a == Sign::zero)) return {};
    const Sign of_b = side_of(w, way, !forth, b);
    if (of_b == Sign::negative || (is_strict && of_b == Sign::zero)) return {};
    return {true, false, 0, {of_a == Sign::zero, of_b == Sign::zero}};
  }
  /// Positive where all are on the side where they are to be.
  template <class W, class Way>
  [[gnu::always_inline]] static inline Sign side_of(W& w, const Way& way, bool farther, const Asked& asked) {
    const Point3& ref = asked.at[asked.in_plane[0]];
    const auto ahead = [&](const Point3& p) {
      return way[0] * w.template difference<1>(p.x, ref.x) + way[1] * w.template difference<1>(p.y, ref.y) +
             way[2] * w.template difference<1>(p.z, ref.z);
    };
    if constexpr (is_strict) {
      std::optional<std::remove_cvref_t<decltype(ahead(ref))>> nearest;
      asked.each([&](const Point3& p) {
        const auto x = ahead(p);
        nearest = !nearest ? x : farther ? smaller(*nearest, x) : larger(*nearest, x);
      });
      if (!nearest) return Sign::positive;
      const Sign s = w.sign(*nearest);
      return farther ? s : -s;
    } else {
      Sign least = Sign::positive;
      asked.each([&](const Point3& p) {
        if (least == Sign::negative) return;
        const Sign s = w.sign(ahead(p));
        least = std::min(least, farther ? s : -s);
      });
      return least;
    }
  }
};

/// Of three corners whose plane holds the origin: is all of a on one side of it and all of b on the other, or in it, but not
/// all of both in it?
struct AreParted {
  static constexpr int highest = 3;
  static constexpr Scales scales{.count = 2};

  template <class W>
  bool operator()(W& w, const Pairs& p, const Asked& a, const Asked& b) const {
    const auto corner = [&](std::size_t i) {
      return std::array{w.difference(p.a[i].x, p.b[i].x), w.difference(p.a[i].y, p.b[i].y),
                        w.difference(p.a[i].z, p.b[i].z)};
    };
    const auto d = corner(0), e = corner(1), f = corner(2);
    const std::array u{e[0] - d[0], e[1] - d[1], e[2] - d[2]}, v{f[0] - d[0], f[1] - d[1], f[2] - d[2]};
    const std::array n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    std::array<bool, 2> ahead{}, behind{};
    const auto see = [&](std::size_t of, const Asked& asked) {
      const Point3& ref = asked.at[asked.in_plane[0]];
      asked.each([&](const Point3& q) {
        if (ahead[of] && behind[of]) return;
        const Sign s =
            w.sign(n[0] * w.template difference<1>(q.x, ref.x) + n[1] * w.template difference<1>(q.y, ref.y) +
                   n[2] * w.template difference<1>(q.z, ref.z));
        ahead[of] = ahead[of] || s == Sign::positive, behind[of] = behind[of] || s == Sign::negative;
      });
    };
    see(0, a);
    if (ahead[0] && behind[0]) return false;
    see(1, b);
    return ahead[0] ? !ahead[1] : behind[0] ? !behind[1] : ahead[1] != behind[1];
  }
};

}  // namespace plumb::query::gjk_origin
