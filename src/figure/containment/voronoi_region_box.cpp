// The features of a parallelepiped: each axis is at its lower end, at its upper one, or free between them.
//
// p is nearest to a feature where its projection lies strictly between the ends of every free axis, and what is left
// points outward along every fixed one.  All of that is asked of one vertex, edge or face at a time, by the signs
//   along:  r . u               off the vertex, along an axis
//   across: (u x r) . (u x v)   off the edge along u, along v
//   above:  r . (u x v)         off the face of u and v
// of what is left from center + sum of half_i axes_i, of which those of the free axes cancel.  A projection is strictly
// between two ends where it is strictly inside of both.  Where axes depend on one another some feature of independent
// axes passes, as every point of the box is reached with free axes that are independent.
#include <cmath>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

namespace f = predicates;

/// What is left of the way from the center to p: arguments center, u, v, w, halves, p.
template <class T>
constexpr auto rest(const std::array<T, 18>& p) {
  return f::difference(p, 0, 5) - f::scaled(f::argument(p, 1), p[12]) - f::scaled(f::argument(p, 2), p[13]) -
         f::scaled(f::argument(p, 3), p[14]);
}

struct OffPart {
  static constexpr std::string_view name = "voronoi_region";
  static constexpr int points = 6, dimension = 3;
  static constexpr bool homogeneous = false;
};
struct Along : OffPart {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return f::dot(rest(p), f::argument(p, 1));
  }
};
struct Across : OffPart {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    const auto u = f::argument(p, 1);
    return f::dot(f::cross(u, rest(p)), f::cross(u, f::argument(p, 2)));
  }
};
struct Above : OffPart {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return f::triple(rest(p), f::argument(p, 1), f::argument(p, 2));
  }
};

class Box {
 public:
  Box(const Obb3& box, const Point3& p)
      : box_(box), p_(p), half_{std::fabs(box.half.x), std::fabs(box.half.y), std::fabs(box.half.z)} {
    volume_ = sign_of(f::Determinant3{}, box.axes[0], box.axes[1], box.axes[2]);
  }

  Feature nearest() {
    for (std::uint32_t v = 0; v < 8; ++v) {
      if (at_vertex(v)) return {FeatureKind::vertex, v};
    }
    for (std::uint32_t e = 0; e < 12; ++e) {
      if (at_edge(e / 4, e % 4)) return {FeatureKind::edge, e};
    }
    for (std::uint32_t face = 0; face < 6; ++face) {
      if (at_face(face / 2, face % 2)) return {FeatureKind::face, face};
    }
    return {FeatureKind::interior, 0};
  }

 private:
  using Axis = std::uint32_t;

  /// A feature's fixed axis is at the upper end where the bit is set.
  [[nodiscard]] double end(Axis axis, std::uint32_t ends) const {
    return (ends >> axis & 1) != 0 ? half_[axis] : -half_[axis];
  }
  /// A sign asked once.  Free axes are left at any end, for they cancel.
  template <class F>
  Sign ask(std::optional<Sign>& known, Axis u, Axis v, std::uint32_t ends) {
    if (!known) {
      const Axis w = 3 - u - v;
      known = sign_of(F{}, box_.center, box_.axes[u], box_.axes[v], box_.axes[w],
                      Vector3{end(u, ends), end(v, ends), end(w, ends)}, p_);
    }
    return *known;
  }
  Sign along(Axis u, std::uint32_t ends) { return ask<Along>(along_[u][ends], u, (u + 1) % 3, ends); }
  Sign across(Axis u, Axis v, std::uint32_t ends) {
    ends &= ~(1u << u);
    return ask<Across>(across_[3 * u + v][ends], u, v, ends);
  }
  /// Above the face that fixes w, toward the upper end of that axis.
  Sign above(Axis w, std::uint32_t ends) {
    ends &= 1u << w;
    return volume_ * ask<Above>(above_[w][ends], (w + 1) % 3, (w + 2) % 3, ends);
  }

  /// Does the way into the box, along an axis from that end, lead away from p?
  [[nodiscard]] bool outward(Axis axis, std::uint32_t ends, Sign s) const {
    return half_[axis] == 0 || s == Sign::zero || (s == Sign::positive) == ((ends >> axis & 1) != 0);
  }

  bool at_vertex(std::uint32_t ends) {
    return outward(0, ends, along(0, ends)) && outward(1, ends, along(1, ends)) && outward(2, ends, along(2, ends));
  }
  bool at_edge(Axis u, std::uint32_t others) {
    const Axis v = u == 0 ? 1 : 0, w = 3 - u - v;
    const std::uint32_t ends = (others & 1) << v | (others >> 1) << w, upper = 1u << u;
    return along(u, ends) == Sign::positive && along(u, ends | upper) == Sign::negative &&
           outward(v, ends, across(u, v, ends)) && outward(w, ends, across(u, w, ends));
  }
  bool at_face(Axis w, std::uint32_t at_upper) {
    const Axis u = w == 0 ? 1 : 0, v = 3 - u - w;
    const std::uint32_t ends = at_upper << w;
    const auto between = [&](Axis free, Axis other) {
      return across(other, free, ends) == Sign::positive && across(other, free, ends | 1u << free) == Sign::negative;
    };
    return between(u, v) && between(v, u) && outward(w, ends, above(w, ends));
  }

  const Obb3& box_;
  const Point3& p_;
  std::array<double, 3> half_;
  Sign volume_;
  std::array<std::array<std::optional<Sign>, 8>, 3> along_{}, above_{};
  std::array<std::array<std::optional<Sign>, 8>, 9> across_{};
};

}  // namespace

Feature voronoi_region(const Obb3& box, const Point3& p) {
  figure::require_sound("voronoi_region", box, part::place("p", p));
  return Box(box, p).nearest();
}

}  // namespace plumb
