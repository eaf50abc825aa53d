#include "query/time_of_impact/exact_contact.hpp"

#include <utility>

#include "query/time_of_impact/contact_features.hpp"

namespace plumb::query::moving {
namespace {

/// Signs of projections along the first axis that shows them; in the order of edges of the triangle, or of the
/// vertices a, b, c, d of the edges.
struct Projection {
  std::array<MovingVector, 4> sides;
  MovingVector whole;  // zero where the figures are degenerate along the axis
  std::size_t count;
};

Projection projection(MovingKind kind, const FourMoving& p) {
  if (kind == MovingKind::vertex_triangle) {
    const MovingVector a = difference(p[1], p[0]), b = difference(p[2], p[0]), c = difference(p[3], p[0]);
    Projection s{{cross(a, b), cross(b, c), cross(c, a), {}}, {}, 3};
    s.whole = sum(s.sides[0], sum(s.sides[1], s.sides[2]));
    return s;
  }
  const MovingVector ac = difference(p[2], p[0]), ad = difference(p[3], p[0]);
  const MovingVector bc = difference(p[2], p[1]), bd = difference(p[3], p[1]);
  Projection s{{cross(ac, ad), cross(bc, bd), cross(ac, bc), cross(ad, bd)}, {}, 4};
  s.whole = difference(s.sides[0], s.sides[1]);
  return s;
}

/// The cubic: p[0] (or a) against the plane of the others.
arith::Polynomial coplanarity(const FourMoving& p) {
  return dot(difference(p[1], p[0]), cross(difference(p[2], p[0]), difference(p[3], p[0])));
}

/// Which features meet at a time when the four points are in one plane?
class ContactInPlane {
 public:
  ContactInPlane(MovingKind kind, const FourMoving& points)
      : kind_(kind), points_(points), projection_(projection(kind, points)) {}

  std::optional<FeaturesInContact> at(arith::IsolatedRoot& time) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int whole = arith::sign_at(projection_.whole[axis], time);
      if (whole == 0) continue;
      std::array<int, 4> side{};
      for (std::size_t i = 0; i < projection_.count; ++i) side[i] = arith::sign_at(projection_.sides[i][axis], time);
      return features_in_contact(kind_, side, whole);
    }
    return when_flat(time);
  }

 private:
  // A triangle without area is its edges, parallel edges meet in vertices.
  std::optional<FeaturesInContact> when_flat(arith::IsolatedRoot& time) {
    if (flat_.empty()) flat_ = feature_pairs(kind_, points_, true);
    for (const FeaturePair& pair : flat_) {
      if (arith::sign_at(pair.zero, time) == 0 && counts(pair, time)) return FeaturesInContact{pair.a, pair.b};
    }
    return {};
  }

 public:
  static bool counts(const FeaturePair& pair, arith::IsolatedRoot& time) {
    if (arith::sign_at(pair.denominator, time) <= 0) return false;
    for (const arith::Polynomial& bound : pair.bounds) {
      if (arith::sign_at(bound, time) < 0) return false;
    }
    return true;
  }

 private:
  MovingKind kind_;
  const FourMoving& points_;
  Projection projection_;
  std::vector<FeaturePair> flat_;
};

mpz_class at_start(const arith::Polynomial& p) { return p.empty() ? mpz_class(0) : p.front(); }

bool counts_at_start(const FeaturePair& pair) {
  if (at_start(pair.denominator) <= 0) return false;
  for (const arith::Polynomial& bound : pair.bounds) {
    if (at_start(bound) < 0) return false;
  }
  return true;
}

/// The nearest features at time 0, where they are near enough.
std::optional<TimedContact> contact_at_start(const std::vector<FeaturePair>& pairs, const mpz_class& square) {
  const FeaturePair* nearest = nullptr;
  mpq_class least;
  for (const FeaturePair& pair : pairs) {
    if (!counts_at_start(pair)) continue;
    mpq_class distance(at_start(pair.numerator), at_start(pair.denominator));
    distance.canonicalize();
    if (nearest != nullptr && distance >= least) continue;
    nearest = &pair;
    least = distance;
  }
  if (least > square) return {};
  return TimedContact{arith::root_at(0), nearest->a, nearest->b};
}

/// The least time at which a pair that counts is at this distance.
std::optional<TimedContact> first_of_pairs(const std::vector<FeaturePair>& pairs, const mpz_class& square) {
  if (auto contact = contact_at_start(pairs, square)) return contact;
  std::optional<TimedContact> first;
  for (const FeaturePair& pair : pairs) {
    arith::Polynomial distance = pair.zero;
    if (square != 0) {
      distance = pair.numerator;
      subtract_product(distance, {square}, pair.denominator);
    }
    arith::make_primitive(distance);
    if (distance.size() < 2) continue;
    arith::visit_roots_in_unit_interval(distance, [&](arith::IsolatedRoot& time) {
      if (first && compare(time, first->time) >= 0) return false;
      if (!ContactInPlane::counts(pair, time)) return true;
      first = TimedContact{time, pair.a, pair.b};
      return false;
    });
  }
  return first;
}

}  // namespace

std::optional<TimedContact> exact_first_contact(MovingKind kind, std::span<const Point3, 4> at_0,
                                                std::span<const Point3, 4> at_1, double separation) {
  ExponentSpan exponents;
  for (const auto& points : {at_0, at_1}) {
    for (const Point3& p : points) {
      for (const double x : {p.x, p.y, p.z}) exponents.include(odd_form(x));
    }
  }
  exponents.include(odd_form(separation));
  const int exponent = exponents.lattice().exponent;
  FourMoving points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = moving(exponent, at_0[i], at_1[i]);
  return exact_first_contact(kind, points, integer_on(exponent, separation));
}

std::optional<TimedContact> exact_first_contact(MovingKind kind, const FourMoving& points,
                                                const mpz_class& separation) {
  const mpz_class square = separation * separation;
  if (square != 0) return first_of_pairs(feature_pairs(kind, points, false), square);
  arith::Polynomial cubic = coplanarity(points);
  if (cubic.empty()) return first_of_pairs(feature_pairs(kind, points, false), square);
  arith::make_primitive(cubic);
  std::optional<TimedContact> first;
  std::optional<ContactInPlane> contact;
  arith::visit_roots_in_unit_interval(cubic, [&](arith::IsolatedRoot& time) {
    if (!contact) contact.emplace(kind, points);
    const auto features = contact->at(time);
    if (features) first = TimedContact{time, features->a, features->b};
    return !features.has_value();
  });
  return first;
}

}  // namespace plumb::query::moving
