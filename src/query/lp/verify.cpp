#include "plumb/query/lp/verify.hpp"

#include <optional>

namespace plumb {
namespace {

Rational product(std::span<const Rational> a, std::span<const Rational> b) {
  Rational sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum = sum + a[k] * b[k];
  return sum;
}

bool has_size(const LinearSystem& s, std::size_t dimension) {
  for (const auto& row : s.rows) {
    if (row.size() != dimension) return false;
  }
  return s.rows.size() == s.limits.size();
}

bool is_feasible(const LinearSystem& s, std::span<const Rational> point, std::size_t dimension) {
  if (point.size() != dimension) return false;
  for (std::size_t i = 0; i < s.rows.size(); ++i) {
    if (product(s.rows[i], point) > s.limits[i]) return false;
  }
  return true;
}

/// Are the weights at least zero, and do the rows add up to `sum`?
bool adds_up(const LinearSystem& s, std::span<const LinearWeight> weights, std::span<const Rational> sum) {
  std::vector<Rational> rest(sum.begin(), sum.end());
  for (const LinearWeight& w : weights) {
    if (w.constraint >= s.rows.size() || w.weight.sign() == Sign::negative) return false;
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = rest[k] - w.weight * s.rows[w.constraint][k];
  }
  for (const Rational& r : rest) {
    if (r.sign() != Sign::zero) return false;
  }
  return true;
}

/// Does the point meet with equality what has a weight?
bool is_tight(const LinearSystem& s, std::span<const LinearWeight> weights, std::span<const Rational> point) {
  for (const LinearWeight& w : weights) {
    if (w.weight.sign() != Sign::zero && product(s.rows[w.constraint], point) != s.limits[w.constraint]) return false;
  }
  return true;
}

/// 0 <= a negative number.
bool refutes(const LinearSystem& s, std::span<const LinearWeight> weights, std::size_t dimension) {
  if (!adds_up(s, weights, std::vector<Rational>(dimension))) return false;
  Rational sum;
  for (const LinearWeight& w : weights) sum = sum + w.weight * s.limits[w.constraint];
  return sum.sign() == Sign::negative;
}

/// The point is feasible, and all of the weight is on what it meets with equality.
bool is_extreme(const LinearSystem& s, const LinearProof& p, std::span<const Rational> sum) {
  return is_feasible(s, p.point, sum.size()) && adds_up(s, p.weights, sum) && is_tight(s, p.weights, p.point);
}

bool is_way_out(const LinearSystem& s, const LinearProof& p, std::span<const Rational> objective) {
  if (!is_feasible(s, p.point, objective.size()) || p.ray.size() != objective.size()) return false;
  for (const auto& row : s.rows) {
    if (product(row, p.ray).sign() == Sign::positive) return false;
  }
  return product(objective, p.ray).sign() == Sign::positive;
}

using Exact = std::array<Rational, 3>;

Exact exact(const Point3& p) { return {p.x, p.y, p.z}; }

/// The weighted sum, where the weights are at least zero and add up to one.
std::optional<Exact> center(std::span<const SupportingPoint> support, std::span<const Point3> points) {
  Exact sum;
  Rational whole;
  for (const SupportingPoint& s : support) {
    if (s.point >= points.size() || s.weight.sign() == Sign::negative) return {};
    const Exact p = exact(points[s.point]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + s.weight * p[k];
    whole = whole + s.weight;
  }
  if (whole != Rational(1)) return {};
  return sum;
}

}  // namespace

bool verify(std::span<const Rational> objective, const LinearSystem& system, const LinearProof& proof) {
  if (!has_size(system, objective.size())) return false;
  if (proof.kind == LinearKind::optimal) return is_extreme(system, proof, objective);
  if (proof.kind == LinearKind::infeasible) return refutes(system, proof.weights, objective.size());
  return is_way_out(system, proof, objective);
}

bool verify_nearest(std::span<const Rational> from, const LinearSystem& system, const LinearProof& proof) {
  if (!has_size(system, from.size())) return false;
  if (proof.kind == LinearKind::infeasible) return refutes(system, proof.weights, from.size());
  if (proof.kind != LinearKind::optimal || proof.point.size() != from.size()) return false;
  std::vector<Rational> way;
  for (std::size_t k = 0; k < from.size(); ++k) way.push_back(from[k] - proof.point[k]);
  return is_extreme(system, proof, way);
}

bool verify(const Vector2& objective, std::span<const Halfspace2> halfspaces, const LinearProof& proof) {
  return verify(std::vector<Rational>{objective.x, objective.y}, linear_system(halfspaces), proof);
}
bool verify(const Vector3& objective, std::span<const Halfspace3> halfspaces, const LinearProof& proof) {
  return verify(std::vector<Rational>{objective.x, objective.y, objective.z}, linear_system(halfspaces), proof);
}

bool verify(std::span<const Point3> first, std::span<const Point3> second, const GreatestMargin3& margin) {
  const std::optional<Exact> a = center(margin.of_first, first), b = center(margin.of_second, second);
  if (!a || !b || margin.square.sign() != Sign::positive) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (margin.direction[k] != (*b)[k] - (*a)[k]) return false;
  }
  if (margin.square != product(margin.direction, margin.direction)) return false;
  if (margin.first_end != product(margin.direction, *a) || margin.second_end != product(margin.direction, *b))
    return false;
  for (const Point3& p : first) {
    if (product(margin.direction, exact(p)) > margin.first_end) return false;
  }
  for (const Point3& p : second) {
    if (product(margin.direction, exact(p)) < margin.second_end) return false;
  }
  return true;
}

}  // namespace plumb
