// GJK: is all of a hull beyond a plane, and is the origin within corners of a difference?  Statements over any world.
//
// Laws: those of certify/world.hpp; numbers of corners are as given, so that exact worlds are exact.
// Source: RTCD 9.5.1, 9.5.2, 5.1.6.
// Cost: 8 operations a corner; 90 for four corners around the origin.
#pragma once

#include <span>

#include "arith/vec.hpp"
#include "figure/support/gjk_simplex.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb::query::gjk_origin {

/// On which side of p is v, along n?
struct Ahead {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};
  template <class W>
  [[gnu::always_inline]] inline Sign operator()(W& w, const arith::Plain& n, const Point3& v, const Point3& p) const {
    const auto x = w.difference(v.x, p.x), y = w.difference(v.y, p.y), z = w.difference(v.z, p.z);
    const auto nx = w.template number<1>(n.x), ny = w.template number<1>(n.y), nz = w.template number<1>(n.z);
    return w.sign(nx * x + ny * y + nz * z);
  }
};

/// Are all of these ahead of p, along n?
struct AreAhead {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};
  template <class W>
  [[gnu::always_inline]] inline bool operator()(W& w, const arith::Plain& n, const Point3* at,
                                                std::span<const std::uint32_t> of, const Point3& p) const {
    const auto nx = w.template number<1>(n.x), ny = w.template number<1>(n.y), nz = w.template number<1>(n.z);
    const auto ahead = [&](std::uint32_t i) {
      const Point3& v = at[i];
      return nx * w.difference(v.x, p.x) + ny * w.difference(v.y, p.y) + nz * w.difference(v.z, p.z);
    };
    auto least = ahead(of[0]);
    for (std::size_t i = 1; i < of.size(); ++i) least = smaller(least, ahead(of[i]));
    return w.sign(least) == Sign::positive;
  }
};

/// Are all of a list on the side of p that n points to, or on the other one?
template <int side>
struct AllOnSide {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};
  template <class W>
  [[gnu::always_inline]] inline bool operator()(W& w, const arith::Plain& n, std::span<const Point3> all,
                                                const Point3& p) const {
    const auto nx = w.template number<1>(n.x), ny = w.template number<1>(n.y), nz = w.template number<1>(n.z);
    const auto ahead = [&](const Point3& v) {
      return nx * w.difference(v.x, p.x) + ny * w.difference(v.y, p.y) + nz * w.difference(v.z, p.z);
    };
    auto nearest = ahead(all[0]);
    for (std::size_t i = 1; i < all.size(); ++i) {
      if constexpr (side > 0) {
        nearest = smaller(nearest, ahead(all[i]));
      } else {
        nearest = larger(nearest, ahead(all[i]));
      }
    }
    return w.sign(nearest) == (side > 0 ? Sign::positive : Sign::negative);
  }
};

/// Corner i of the difference is a[i] - b[i].
struct Pairs {
  std::array<Point3, 4> a, b;
};

/// Is the origin strictly inside of the tetrahedron?
struct IsAroundOrigin {
  static constexpr int highest = 3;
  template <class W>
  [[gnu::always_inline]] inline bool operator()(W& w, const Pairs& p) const {
    using N = decltype(w.difference(0.0, 0.0));
    const auto corner = [&](std::size_t i) {
      return std::array<N, 3>{w.difference(p.a[i].x, p.b[i].x), w.difference(p.a[i].y, p.b[i].y),
                              w.difference(p.a[i].z, p.b[i].z)};
    };
    const std::array<std::array<N, 3>, 4> d{corner(0), corner(1), corner(2), corner(3)};
    return figure::gjk::is_around_origin([&](std::size_t i, std::size_t j, std::size_t k) {
      const auto &u = d[i], &v = d[j], &t = d[k];
      return w.sign(u[0] * (v[1] * t[2] - v[2] * t[1]) + u[1] * (v[2] * t[0] - v[0] * t[2]) +
                    u[2] * (v[0] * t[1] - v[1] * t[0]));
    });
  }
};

}  // namespace plumb::query::gjk_origin
