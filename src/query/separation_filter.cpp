#include "query/separation_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plumb::query::moving {
namespace {

using Vec = std::array<double, 3>;

Vec difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Do all reach beyond the distance along the direction, or all against it?
bool beyond(const std::array<Vec, 8>& differences, std::size_t count, const Vec& direction, double distance) {
  // The product is off by a rounding of each difference, each product and two sums: below 6 units of its terms' sizes,
  // and by underflow; the length by below 4 units.
  constexpr double unit = 0x1p-53, least = 0x1p-960;
  const double length =
      std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  const double needed = distance * length * (1 + 16 * unit) + least;
  bool along = length > 0x1p-400 && length < 0x1p400, against = along;  // where squares neither vanish nor overflow
  for (std::size_t i = 0; i < count; ++i) {
    const Vec& d = differences[i];
    const double x = d[0] * direction[0], y = d[1] * direction[1], z = d[2] * direction[2];
    const double off = 8 * unit * (std::abs(x) + std::abs(y) + std::abs(z));
    along = along && x + y + z > needed + off;
    against = against && x + y + z < -(needed + off);
  }
  return along || against;
}

}  // namespace

bool surely_apart(const ContactQuestion& question, double separation) {
  const bool edges = question.kind == MovingKind::edge_edge;
  const std::size_t first = edges ? 2 : 1;  // of the other figure
  std::array<Vec, 8> differences;
  std::size_t count = 0;
  for (const auto& p : {question.at_0, question.at_1}) {
    for (std::size_t i = 0; i < first; ++i) {
      for (std::size_t j = first; j < 4; ++j) differences[count++] = difference(p[j], p[i]);
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto all = [&](const auto& says) {
      return std::all_of(differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(count), says);
    };
    if (all([&](const Vec& d) { return d[axis] > separation; })) return true;
    if (all([&](const Vec& d) { return d[axis] < -separation; })) return true;
  }
  for (const auto& p : {question.at_0, question.at_1}) {
    const Vec e = edges ? difference(p[1], p[0]) : difference(p[2], p[1]);
    const Vec f = edges ? difference(p[3], p[2]) : difference(p[3], p[1]);
    if (beyond(differences, count, cross(e, f), separation)) return true;
  }
  return false;
}

}  // namespace plumb::query::moving
