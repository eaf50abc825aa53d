// Motions that are hard to answer: on small integer grids, so that everything that can coincide does.
#pragma once

#include <array>
#include <string_view>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/time_of_impact/continuous_contact.hpp"

namespace plumb::lab::moving_cases {

struct Case {
  bool vertex_face = false;
  std::array<Point3, 4> at_0{}, at_1{};

  [[nodiscard]] Moving<Point3> vertex() const { return {at_0[0], at_1[0]}; }
  [[nodiscard]] Moving<Triangle3> triangle() const {
    return {{at_0[1], at_0[2], at_0[3]}, {at_1[1], at_1[2], at_1[3]}};
  }
  [[nodiscard]] Moving<Segment3> edge(std::size_t i) const {
    return {{at_0[2 * i], at_0[2 * i + 1]}, {at_1[2 * i], at_1[2 * i + 1]}};
  }
};

/// ask(a, b) of its two figures.
template <class Ask>
auto of_figures(const Case& c, const Ask& ask) {
  return c.vertex_face ? ask(c.vertex(), c.triangle()) : ask(c.edge(0), c.edge(1));
}

enum class Kind : unsigned char { any, planar, resting, flat, parallel, planted, double_root, family };
inline constexpr std::array kinds{Kind::any,      Kind::planar,  Kind::resting,     Kind::flat,
                                  Kind::parallel, Kind::planted, Kind::double_root, Kind::family};
constexpr std::string_view name_of(Kind kind) {
  constexpr std::array<std::string_view, 8> names{"any",      "planar",  "resting",     "flat",
                                                  "parallel", "planted", "double_root", "family"};
  return names[static_cast<std::size_t>(kind)];
}

inline Point3 grid_point(Entropy& entropy, std::int64_t most) {
  const auto x = [&] { return static_cast<double>(entropy.within(most)); };
  const double a = x(), b = x();
  return {a, b, x()};
}
constexpr Point3 plus(const Point3& p, const Point3& q, double factor) {
  return {p.x + factor * q.x, p.y + factor * q.y, p.z + factor * q.z};
}

/// All points as they are at a time, in contact there, and moving as they like.
inline void plant(Case& c, Entropy& entropy) {
  std::array<Point3, 4> p{};
  for (Point3& x : p) x = grid_point(entropy, 3);
  const auto part = [&] { return static_cast<double>(entropy.below(5)) / 4; };
  if (c.vertex_face) {
    const double u = part(), v = part() * (1 - u);
    p[0] = plus(plus(plus({0, 0, 0}, p[1], 1 - u - v), p[2], u), p[3], v);
  } else {
    const double u = part(), v = static_cast<double>(entropy.below(3)) / 2;
    const Point3 meeting = plus(plus({0, 0, 0}, p[0], 1 - u), p[1], u);
    if (v == 1) {
      p[3] = meeting;
    } else {
      p[2] = plus(plus({0, 0, 0}, meeting, 1 / (1 - v)), p[3], -v / (1 - v));
    }
  }
  const double time = part();
  for (std::size_t i = 0; i < 4; ++i) {
    const Point3 velocity = grid_point(entropy, 8);
    c.at_0[i] = plus(p[i], velocity, -time);
    c.at_1[i] = plus(p[i], velocity, 1 - time);
  }
}

/// The three differences to the first point are rows whose determinant is a multiple of (2t - 1)^2; in any combination.
inline void plant_double_root(Case& c, Entropy& entropy) {
  const auto small = [&] { return static_cast<double>(entropy.within(2)); };
  const double k = small(), x = small(), y = small();
  const std::array<std::array<Point3, 3>, 2> rows{
      {{{{-1, 0, 0}, {k, -1, 0}, {x, y, 1}}}, {{{1, 0, 0}, {k, 1, 0}, {x, y, 1}}}}};
  const Point3 start = grid_point(entropy, 3), end = grid_point(entropy, 3);
  c.at_0[0] = start;
  c.at_1[0] = end;
  for (std::size_t i = 1; i < 4; ++i) {
    c.at_0[i] = start;
    c.at_1[i] = end;
    for (std::size_t j = 0; j < 3; ++j) {
      const double factor = small();
      c.at_0[i] = plus(c.at_0[i], rows[0][j], factor);
      c.at_1[i] = plus(c.at_1[i], rows[1][j], factor);
    }
  }
}

/// Any three coordinates instead of z: x, y and a combination of them.
inline void flatten(Case& c, Entropy& entropy) {
  const double a = static_cast<double>(entropy.within(2)), b = static_cast<double>(entropy.within(2));
  for (auto* points : {&c.at_0, &c.at_1}) {
    for (Point3& p : *points) p.z = a * p.x + b * p.y;
  }
}

inline Case make(Kind kind, bool vertex_face, Entropy& entropy) {
  Case c;
  c.vertex_face = vertex_face;
  const std::int64_t most = std::array{1, 2, 3, 8}[entropy.below(4)];
  for (auto* points : {&c.at_0, &c.at_1}) {
    for (Point3& p : *points) p = grid_point(entropy, most);
  }
  const std::size_t i = entropy.below(4), j = entropy.below(4);
  switch (kind) {
    case Kind::any:
      break;
    case Kind::planar:
      flatten(c, entropy);
      break;
    case Kind::resting:
      c.at_1[i] = c.at_0[i];
      c.at_1[j] = c.at_0[j];
      break;
    case Kind::flat:  // equal points, or three in a line the whole time; half of them where contact is likely
      if (entropy.coin()) plant(c, entropy);
      if (entropy.coin()) {
        c.at_0[i] = c.at_0[j];
        c.at_1[i] = c.at_1[j];
      } else {
        c.at_0[3] = plus(c.at_0[1], plus(c.at_0[2], c.at_0[1], -1), 2);
        c.at_1[3] = plus(c.at_1[1], plus(c.at_1[2], c.at_1[1], -1), 2);
      }
      break;
    case Kind::parallel: {
      const double factor = static_cast<double>(entropy.within(2));
      for (auto* p : {&c.at_0, &c.at_1}) (*p)[3] = plus((*p)[2], plus((*p)[1], (*p)[0], -1), factor);
      if (entropy.coin()) flatten(c, entropy);
      break;
    }
    case Kind::planted:
      plant(c, entropy);
      break;
    case Kind::double_root:
      plant_double_root(c, entropy);
      break;
    case Kind::family: {
      const std::vector<Point3> points = points3(any_family(entropy), Degeneracy::coplanar, 8, entropy);
      for (std::size_t k = 0; k < 4; ++k) c.at_0[k] = points[k], c.at_1[k] = points[k + 4];
      break;
    }
  }
  return c;
}
inline Case make(Kind kind, Entropy& entropy) {
  const bool vertex_face = entropy.coin();
  return make(kind, vertex_face, entropy);
}

}  // namespace plumb::lab::moving_cases
