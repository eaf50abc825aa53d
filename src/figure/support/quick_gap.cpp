#include "figure/support/quick_gap.hpp"

#include <algorithm>
#include <cmath>

#include "figure/support/near_points.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/detail/gap_filter.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::figure::swept {
namespace {

using predicates::argument, predicates::difference, predicates::dot, predicates::Triple;

// (corner a, its edges, corner b, its edges, four parts, two radii): the points at these parts, against the sum of the
// radii.
struct NearPoints {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 1, 1, 1, 1, 1, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const auto apart = [&](std::size_t i) {
      return (p[i] - p[9 + i]) + ((p[18] * p[3 + i] + p[19] * p[6 + i]) - (p[20] * p[12 + i] + p[21] * p[15 + i]));
    };
    const auto x = apart(0), y = apart(1), z = apart(2);
    const auto reach = p[22] + p[23];
    return x * x + y * y + z * z - reach * reach;
  }
};

// (corner a, its edges, corner b, its edges, n, two radii): twice what n's projections of the cores are apart, a beyond
// b, less twice the radii.  An edge reaches back by min(0, n . e), twice which is n . e - |n . e|.
struct PlaneBetween {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 1, 1};
  template <class T, class Absolute>
  static constexpr auto gap(const std::array<T, 23>& p, Absolute absolute) {
    const auto n = argument(p, 6);
    const auto corners = dot(difference(p, 3, 0), n);
    const auto e = dot(argument(p, 1), n), f = dot(argument(p, 2), n);
    const auto g = dot(argument(p, 4), n), h = dot(argument(p, 5), n);
    const auto back = (e - absolute(e)) + (f - absolute(f)), front = (g + absolute(g)) + (h + absolute(h));
    const auto reach = p[21] + p[22];
    return (corners + corners) + (back - front) - (reach + reach);
  }
  template <class T>
  constexpr auto operator()(const std::array<T, 23>& p) const {
    return gap(p, [](const auto& product) { return product; });
  }
};

// (n): 1 - n^2.
struct Shorter {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return p[3] * p[3] - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }
};

double product(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

/// The parts at which | d + sum of part_i w_i | is nearly least: each in turn, the others held.
std::array<double, 4> near_parts(const Vector3& d, const std::array<Vector3, 4>& w) {
  constexpr int most_rounds = 24;
  std::array<double, 4> part{0.5, 0.5, 0.5, 0.5}, along{};
  std::array<std::array<double, 4>, 4> gram{};
  for (std::size_t i = 0; i < 4; ++i) {
    along[i] = product(d, w[i]);
    for (std::size_t j = 0; j < 4; ++j) gram[i][j] = product(w[i], w[j]);
  }
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(gram[i][i] > 0)) continue;
      double slope = along[i];
      for (std::size_t j = 0; j < 4; ++j) slope += gram[i][j] * part[j];
      const double next = std::clamp(part[i] - slope / gram[i][i], 0.0, 1.0);
      change = std::fmax(change, std::fabs(next - part[i]));
      part[i] = next;
    }
    constexpr double settled = 0x1p-20;  // a guess, for what is proved after it
    if (change < settled) break;
  }
  return part;
}

/// A guess of the vector made a little shorter than 1, where the filter proves that it is.
std::optional<Vector3> shortened(const Vector3& n) {
  constexpr double a_little_shorter = 1 - 0x1p-50;  // a guess: less than roundings make of a length
  const double shrink = a_little_shorter / std::sqrt(product(n, n));
  const Vector3 s{n.x * shrink, n.y * shrink, n.z * shrink};
  return filter<Shorter>({s.x, s.y, s.z, 1.0}) > 0 ? std::optional(s) : std::nullopt;
}

}  // namespace

std::optional<Sign> quick_gap(const Capsule3& a, const Capsule3& b) {
  assert_sound_thread();
  return figure::near_points::quick_gap(Segment3{a.a, a.b}, Segment3{b.a, b.b}, a.radius, b.radius);
}

std::optional<Sign> quick_gap(const Lozenge3& a, const Lozenge3& b) {
  if (!(a.radius >= 0 && b.radius >= 0)) return {};
  assert_sound_thread();
  const Vector3 d{a.corner.x - b.corner.x, a.corner.y - b.corner.y, a.corner.z - b.corner.z};
  const auto back = [](const Vector3& v) { return Vector3{-v.x, -v.y, -v.z}; };
  const std::array<Vector3, 4> w{a.edges[0], a.edges[1], back(b.edges[0]), back(b.edges[1])};
  const std::array<double, 4> part = near_parts(d, w);
  if (filter<NearPoints>(coordinates_of<NearPoints>(a.corner, a.edges[0], a.edges[1], b.corner, b.edges[0], b.edges[1],
                                                    part, a.radius, b.radius)) < 0)
    return Sign::negative;
  Vector3 n = d;
  for (std::size_t i = 0; i < 4; ++i) n = {n.x + part[i] * w[i].x, n.y + part[i] * w[i].y, n.z + part[i] * w[i].z};
  const std::optional<Vector3> shorter = shortened(n);
  if (!shorter) return {};
  if (gap_filter<PlaneBetween>(coordinates_of<PlaneBetween>(a.corner, a.edges[0], a.edges[1], b.corner, b.edges[0],
                                                            b.edges[1], *shorter, a.radius, b.radius)) <= 0)
    return {};
  return Sign::positive;
}

}  // namespace plumb::figure::swept
