// What do the contours of a section go around?  By rational arithmetic on their corners alone.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "plumb/surface/section/section.hpp"

namespace plumb::oracle {

using Flat = std::array<Rational, 2>;

/// The corners along two axes that show the plane; `turned` where they show it from below.
struct Shown {
  std::size_t u, v;
  bool turned;
};

inline Flat flat(const RationalPoint3& p, const Shown& s) {
  const std::array<Rational, 3> x{p.x, p.y, p.z};
  return {x[s.u], x[s.v]};
}

inline std::vector<std::vector<Flat>> flat_contours(const TriangleMesh& mesh, const Section& cut, const Shown& s) {
  std::vector<std::vector<Flat>> contours;
  for (const Contour& c : cut.contours) {
    auto& points = contours.emplace_back();
    for (const SectionCorner& corner : c.corners)
      points.push_back(flat(rational_point(exact_corner(mesh, cut.plane, corner)), s));
  }
  return contours;
}

inline Rational doubled_area(const std::vector<Flat>& loop) {
  Rational sum;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat &p = loop[i], &q = loop[(i + 1) % loop.size()];
    sum = sum + (p[0] * q[1] - q[0] * p[1]);
  }
  return sum;
}

/// How often the loop winds around p, counterclockwise; nothing on it.  By the crossings of the ray along u.
inline std::optional<int> winding(const std::vector<Flat>& loop, const Flat& p) {
  int turns = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const Rational cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    if (cross.sign() == Sign::zero) {
      const Rational along =
          (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]);  // not positive between a and b
      if (along.sign() != Sign::positive) return std::nullopt;
    }
    if (a[1] <= p[1] && b[1] > p[1] && cross.sign() == Sign::positive) ++turns;
    if (a[1] > p[1] && b[1] <= p[1] && cross.sign() == Sign::negative) --turns;
  }
  return turns;
}

/// All contours about p; nothing where p is on one.
inline std::optional<int> winding(const std::vector<std::vector<Flat>>& contours, const Flat& p) {
  int turns = 0;
  for (const auto& loop : contours) {
    const auto one = winding(loop, p);
    if (!one) return std::nullopt;
    turns += *one;
  }
  return turns;
}

}  // namespace plumb::oracle
