// A point: the feature that holds the nearest point, then its foot.  Two triangles: all pairs of features that can hold
// the closest points, by the search of straight_search.hpp over the posed corners.
#include "query/closest/posed_triangle.hpp"

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "certify/carried_errors.hpp"
#include "query/closest/numbers.hpp"
#include "query/closest/straight_search.hpp"

namespace plumb::query {
namespace {

bool is_positive(Sign s) { return s == Sign::positive; }

/// A corner is nearest where no other lies ahead of it toward p, the inside of an edge where the third corner does not.
template <class T>
Feature nearest_feature(const std::array<Vec3<T>, 3>& corner, const Vec3<T>& p, CertainSigns& ask) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vec3<T>&v = corner[i], &next = corner[(i + 1) % 3], &last = corner[(i + 2) % 3];
    if (!is_positive(ask(dot(p - v, next - v))) && !is_positive(ask(dot(p - v, last - v))))
      return {FeatureKind::vertex, i};
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Vec3<T>& from = corner[i];
    const Vec3<T> e = corner[(i + 1) % 3] - from, third = corner[(i + 2) % 3] - from, to = p - from;
    const T along = dot(to, e), whole = dot(e, e);
    if (is_positive(ask(along)) && is_positive(ask(whole - along)) &&
        !is_positive(ask(dot(to, third) * whole - along * dot(e, third)))) {
      return {FeatureKind::edge, i};
    }
  }
  return {FeatureKind::face, 0};
}

template <class T>
Foot<T> foot_of(const std::array<Vec3<T>, 3>& corner, const Vec3<T>& p, Feature feature) {
  const Vec3<T>&from = corner[feature.index], &next = corner[(feature.index + 1) % 3];
  if (feature.kind == FeatureKind::vertex) return foot_on_point(from, p);
  if (feature.kind == FeatureKind::edge) return foot_on_line(from, next - from, p);
  const Vec3<T> normal = cross(next - from, corner[2] - from);
  return foot_on_plane(normal, dot(normal, p - from), p);
}

/// From p to the corners, all times the weight of the pose.
template <class T>
Foot<T> weighted_foot(const WeightedCorners<T>& corners, const Point3& p, Feature feature) {
  return foot_of(corners.at, corners.beside(vector_of<T>(p)), feature);
}

/// Of a pose that has a weight: the point by integers, the distance by pairs of doubles first.
NearestNumbers numbers_of_weighted(const PosedTriangle3& t, const Point3& p, Feature feature, Wanted wanted) {
  NearestNumbers r;
  std::optional<WeightedCorners<BigDyadic>> corners;
  const auto exactly = [&] {
    if (!corners) corners.emplace(t);
    return weighted_foot(*corners, p, feature);
  };
  if (wanted != Wanted::point) {
    const WeightedCorners<Ball> quick(t);
    const Foot<Ball> foot = weighted_foot(quick, p, feature);
    const auto d = root(quotient(foot.square(), foot.over() * quick.by.weight * quick.by.weight)).nearest();
    if (d) {
      r.distance = *d;
    } else {
      const Foot<BigDyadic> exact = exactly();
      const BigDyadic& weight = corners->by.weight;
      r.distance = plumb::rounded_root(Rounding::nearest, exact.square(), exact.over() * weight * weight);
    }
  }
  if (wanted != Wanted::distance) {
    const Foot<BigDyadic> exact = exactly();
    const bool at_point = exact.carrier == Carrier::point;
    const BigDyadic over = at_point ? corners->by.weight : exact.whole * corners->by.weight;
    const Vec3<BigDyadic> at = at_point ? exact.from : exact.from * exact.whole + exact.along * exact.part;
    const auto rounded = [&](const BigDyadic& x) { return rounded_quotient(Rounding::nearest, x, over) + 0.0; };
    r.point = {rounded(at.x), rounded(at.y), rounded(at.z)};
  }
  return r;
}

NearestNumbers numbers_near(const PosedTriangle3& t, const Point3& p, Feature feature, Wanted wanted) {
  const WeightedCorners<Ball> quick(t);
  if (quick.by.has_weight) return numbers_of_weighted(t, p, feature, wanted);
  const auto exactly = [&] { return weighted_foot(WeightedCorners<BigDyadic>(t), p, feature); };
  return numbers(wanted, weighted_foot(quick, p, feature), p, 0, ExactFoot(exactly));
}

template <class T>
using PosedPair = Found<T, Vec3<T>>;

/// The corners are times both weights; the points are told without.
template <class T>
WeightedPair<T> weighted_points(const PosedPair<T>& found, const CornersTogether<T>& both) {
  const auto place = [&](const PointOn<T, Vec3<T>>& p, Feature f) {
    const bool is_corner = f.kind == FeatureKind::vertex;
    const T whole = is_corner ? T(1.0) : p.whole;
    return WeightedPoint<T>{is_corner ? p.base : p.base * p.whole + p.along * p.numerator,
                            both.has_weight ? whole * both.weight : whole};
  };
  return {place(found.pair.a, found.a), place(found.pair.b, found.b)};
}

/// The square of the distance is that of `pair`, times the square of the weights, if there are any.
template <class T>
std::optional<PosedPair<T>> least_pair(const CornersTogether<T>& both, LeastOf of, CertainSigns& ask) {
  const auto p = body_of<T>(both.a, ask), q = body_of<T>(both.b, ask);
  auto best = FeatureSearch<T, Vec3<T>>(p, q, everything, ask, of).run();
  if (best && both.has_weight) best->pair.square_whole = best->pair.square_whole * both.weight * both.weight;
  return best;
}
template <class T>
std::optional<PosedPair<T>> least_pair(const PosedTriangle3& a, const PosedTriangle3& b, CertainSigns& ask) {
  return least_pair<T>(CornersTogether<T>(a, b), LeastOf::any, ask);
}
PosedPair<BigDyadic> least_pair_exactly(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  return *least_pair<BigDyadic>(a, b, ask);
}

}  // namespace

Feature nearest_feature(const PosedTriangle3& triangle, const Point3& p) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const WeightedCorners<T> corners(triangle);
    return nearest_feature<T>(corners.at, corners.beside(vector_of<T>(p)), ask);
  });
}

ClosestOnPosed closest_on(const PosedTriangle3& triangle, const Point3& p) {
  const Feature feature = nearest_feature(triangle, p);
  const NearestNumbers n = numbers_near(triangle, p, feature, Wanted::both);
  return {n.point, n.distance, feature};
}
double distance(const PosedTriangle3& triangle, const Point3& p) {
  return numbers_near(triangle, p, nearest_feature(triangle, p), Wanted::distance).distance;
}
Rational squared_distance_exact(const PosedTriangle3& triangle, const Point3& p) {
  const WeightedCorners<BigDyadic> corners(triangle);
  const Rational square = rational_square(weighted_foot(corners, p, nearest_feature(triangle, p)));
  if (!corners.by.has_weight) return square;
  return square / exact_number(corners.by.weight * corners.by.weight);
}
Sign compare_distance(const PosedTriangle3& triangle, const Point3& p, double than) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const WeightedCorners<T> corners(triangle);
    const Vec3<T> at = corners.beside(vector_of<T>(p));
    const Foot<T> foot = foot_of(corners.at, at, nearest_feature<T>(corners.at, at, ask));
    const T far = corners.beside(T(than));
    return ask(foot.square() - far * far * foot.over());
  });
}

WeightedPair<BigDyadic> exact_closest_points(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const CornersTogether<BigDyadic> both(a, b);
  return weighted_points(*least_pair(both, LeastOf::any, ask), both);
}
std::optional<WeightedPair<Ball>> quick_closest_points(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const CornersTogether<Ball> both(a, b);
  const auto found = least_pair(both, LeastOf::any, ask);
  if (!found || !ask.certain()) return {};
  return weighted_points(*found, both);
}

Closest closest_points(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const CornersTogether<BigDyadic> both(a, b);
  const auto found = *least_pair(both, LeastOf::first_in_order, ask);
  const auto [p, q] = weighted_points(found, both);
  const auto point = [](const WeightedPoint<BigDyadic>& w) {
    const auto rounded = [&](const BigDyadic& x) { return rounded_quotient(Rounding::nearest, x, w.weight); };
    return Point3{rounded(w.at.x), rounded(w.at.y), rounded(w.at.z)};
  };
  return {point(p), point(q), nearest_distance(found.pair), found.a, found.b};
}
double distance(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const auto quick = least_pair<Ball>(a, b, ask);
  if (quick && ask.certain()) {
    if (const auto d = nearest_distance(quick->pair)) return *d;
  }
  return nearest_distance(least_pair_exactly(a, b).pair);
}
Rational squared_distance_exact(const PosedTriangle3& a, const PosedTriangle3& b) {
  return square_of(least_pair_exactly(a, b).pair);
}
std::optional<std::array<Feature, 2>> quick_features(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const auto found = least_pair<Ball>(a, b, ask);
  if (!found || !ask.certain()) return {};
  return std::array{found->a, found->b};
}
Sign compare_distance(const PosedTriangle3& a, const PosedTriangle3& b, double than) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const auto found = least_pair<T>(a, b, ask);
    return found ? ask(found->pair.square - T(than) * T(than) * found->pair.square_whole) : Sign::zero;
  });
}

}  // namespace plumb::query
