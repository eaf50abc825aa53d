// A point: the feature that holds the nearest point, then its foot.  Two triangles: all pairs of features that can hold
// the closest points, as in straight_search.hpp.
#include "query/closest/posed_triangle.hpp"

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "certify/carried_errors.hpp"
#include "query/closest/numbers.hpp"

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
Numbers numbers_of_weighted(const PosedTriangle3& t, const Point3& p, Feature feature, Wanted wanted) {
  Numbers r;
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

Numbers numbers_near(const PosedTriangle3& t, const Point3& p, Feature feature, Wanted wanted) {
  const WeightedCorners<Ball> quick(t);
  if (quick.by.has_weight) return numbers_of_weighted(t, p, feature, wanted);
  const auto exactly = [&] { return weighted_foot(WeightedCorners<BigDyadic>(t), p, feature); };
  return numbers(wanted, weighted_foot(quick, p, feature), p, 0, ExactFoot(exactly));
}

template <class T>
WeightedPoint<T> weighted(const Vec3<T>& p) {
  return {p, T(1.0)};
}

/// Negative where p comes first in lexicographic order.
template <class T>
Sign lexicographic_order(const WeightedPoint<T>& p, const WeightedPoint<T>& q, CertainSigns& ask) {
  Sign s = ask(p.at.x * q.weight - q.at.x * p.weight);
  if (s == Sign::zero) s = ask(p.at.y * q.weight - q.at.y * p.weight);
  if (s == Sign::zero) s = ask(p.at.z * q.weight - q.at.z * p.weight);
  return s;
}

template <class T>
struct PosedClosePair {
  WeightedPoint<T> a, b;
  T square, over;  // of the distance
  Feature feature_a, feature_b;

  /// All of it was seen as many times as large.
  void divide_by(const T& weight) {
    a.weight = a.weight * weight, b.weight = b.weight * weight;
    over = over * weight * weight;
  }
};

template <class T>
struct PosedBody {
  std::array<Vec3<T>, 3> corner, along, inward;
  std::array<bool, 3> is_edge;
  Vec3<T> normal;
  T whole;
  bool is_face;

  PosedBody(const std::array<Vec3<T>, 3>& c, CertainSigns& ask)
      : corner(c),
        along{c[1] - c[0], c[2] - c[1], c[0] - c[2]},
        inward(along),
        is_edge{is_way(along[0], ask), is_way(along[1], ask), is_way(along[2], ask)},
        normal(cross(along[0], along[1])),
        whole(dot(normal, normal)),
        is_face(is_edge[0] && is_edge[1] && is_edge[2] && is_positive(ask(whole))) {
    for (std::size_t i = 0; i < 3; ++i) inward[i] = cross(normal, along[i]);
  }
  static bool is_way(const Vec3<T>& v, CertainSigns& ask) { return is_positive(ask(dot(v, v))); }
};

/// Shows see(pair) each that has one closest pair alone, strictly within both features.
template <class T, class See>
class PosedSearch {
 public:
  PosedSearch(const PosedBody<T>& p, const PosedBody<T>& q, CertainSigns& ask, const See& see)
      : p_(p), q_(q), ask_(ask), see_(see) {}

  /// The features of the lowest dimensions first.
  void run() const {
    each([&](std::uint32_t i, std::uint32_t k) { vertices(i, k); });
    each([&](std::uint32_t i, std::uint32_t k) { vertex_edge(p_, i, q_, k, false); });
    each([&](std::uint32_t i, std::uint32_t k) { vertex_edge(q_, k, p_, i, true); });
    each([&](std::uint32_t i, std::uint32_t k) { edges(i, k); });
    on_face(p_, q_, false);
    on_face(q_, p_, true);
  }

 private:
  template <class Take>
  static void each(const Take& take) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) take(i, k);
    }
  }
  void show(PosedClosePair<T> pair, bool turned) const {
    if (turned) std::swap(pair.a, pair.b), std::swap(pair.feature_a, pair.feature_b);
    see_(pair);
  }
  void vertices(std::uint32_t i, std::uint32_t k) const {
    const Vec3<T> w = q_.corner[k] - p_.corner[i];
    see_(PosedClosePair<T>{weighted(p_.corner[i]),
                           weighted(q_.corner[k]),
                           dot(w, w),
                           T(1.0),
                           {FeatureKind::vertex, i},
                           {FeatureKind::vertex, k}});
  }
  void vertex_edge(const PosedBody<T>& of, std::uint32_t i, const PosedBody<T>& body, std::uint32_t k,
                   bool turned) const {
    if (!body.is_edge[k]) return;
    const Vec3<T>& v = of.corner[i];
    const Vec3<T>&from = body.corner[k], &e = body.along[k];
    const Vec3<T> w = v - from;
    const T part = dot(w, e), whole = dot(e, e);
    if (!is_positive(ask_(part)) || !is_positive(ask_(whole - part))) return;
    const Vec3<T> c = cross(w, e);
    show({weighted(v),
          {from * whole + e * part, whole},
          dot(c, c),
          whole,
          {FeatureKind::vertex, i},
          {FeatureKind::edge, k}},
         turned);
  }
  void edges(std::uint32_t i, std::uint32_t k) const {
    if (!p_.is_edge[i] || !q_.is_edge[k]) return;
    const Vec3<T>&e = p_.along[i], &f = q_.along[k];
    const Vec3<T> n = cross(e, f), w = q_.corner[k] - p_.corner[i];
    const T whole = dot(n, n);
    if (!is_positive(ask_(whole))) return;
    const T on_e = dot(cross(w, f), n), on_f = dot(cross(w, e), n), gap = dot(w, n);
    for (const T* part : {&on_e, &on_f}) {
      if (!is_positive(ask_(*part)) || !is_positive(ask_(whole - *part))) return;
    }
    see_(PosedClosePair<T>{{p_.corner[i] * whole + e * on_e, whole},
                           {q_.corner[k] * whole + f * on_f, whole},
                           gap * gap,
                           whole,
                           {FeatureKind::edge, i},
                           {FeatureKind::edge, k}});
  }
  void on_face(const PosedBody<T>& p, const PosedBody<T>& q, bool turned) const {
    if (!q.is_face) return;
    const Feature face{FeatureKind::face, 0};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Vec3<T>& v = p.corner[i];
      bool within = true;
      for (std::size_t k = 0; k < 3; ++k) within = within && is_positive(ask_(dot(q.inward[k], v - q.corner[k])));
      if (!within) continue;
      const T gap = dot(q.normal, q.corner[0] - v);
      show({weighted(v), {v * q.whole + q.normal * gap, q.whole}, gap * gap, q.whole, {FeatureKind::vertex, i}, face},
           turned);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (p.is_edge[i]) edge_through(p, i, q, turned);
    }
  }
  void edge_through(const PosedBody<T>& p, std::uint32_t i, const PosedBody<T>& q, bool turned) const {
    const Vec3<T>&from = p.corner[i], &e = p.along[i];
    const T rise = dot(e, q.normal), gap = dot(q.normal, q.corner[0] - from);
    const Sign up = ask_(rise);
    if (up == Sign::zero || ask_(gap) * up != Sign::positive || ask_(rise - gap) * up != Sign::positive) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<T> v = q.corner[k] - from, w = q.corner[(k + 1) % 3] - from;
      if (ask_(dot(e, cross(v, w))) * up != Sign::positive) return;
    }
    const T zero(0.0);
    const bool rises = up == Sign::positive;
    const T part = rises ? gap : zero - gap, whole = rises ? rise : zero - rise;
    const WeightedPoint<T> at{from * whole + e * part, whole};
    show({at, at, zero, T(1.0), {FeatureKind::edge, i}, {FeatureKind::face, 0}}, turned);
  }

  const PosedBody<T>&p_, &q_;
  CertainSigns& ask_;
  const See& see_;
};

/// Of the least pairs the first in lexicographic order, where that is asked for.
template <class T>
std::optional<PosedClosePair<T>> least_pair(const PosedTriangle3& a, const PosedTriangle3& b, bool in_order,
                                            CertainSigns& ask) {
  const CornersTogether<T> both(a, b);
  const PosedBody<T> p(both.a, ask), q(both.b, ask);
  std::optional<PosedClosePair<T>> best;
  const auto see = [&](const PosedClosePair<T>& pair) {
    if (best) {
      const Sign s = ask(pair.square * best->over - best->square * pair.over);
      if (s == Sign::positive) return;
      if (s == Sign::zero && (!in_order || lexicographic_order(pair.a, best->a, ask) != Sign::negative)) return;
    }
    best = pair;
  };
  PosedSearch<T, decltype(see)>(p, q, ask, see).run();
  if (best && both.has_weight) best->divide_by(both.weight);
  return best;
}

PosedClosePair<BigDyadic> least_pair_exactly(const PosedTriangle3& a, const PosedTriangle3& b, bool in_order) {
  CertainSigns ask;
  return *least_pair<BigDyadic>(a, b, in_order, ask);
}

double rounded_distance(const PosedClosePair<BigDyadic>& pair) {
  return plumb::rounded_root(Rounding::nearest, pair.square, pair.over);
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
  const Numbers n = numbers_near(triangle, p, feature, Wanted::both);
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
  const auto pair = least_pair_exactly(a, b, false);
  return {pair.a, pair.b};
}
std::optional<WeightedPair<Ball>> quick_closest_points(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const auto pair = least_pair<Ball>(a, b, false, ask);
  if (!pair || !ask.certain()) return {};
  return WeightedPair<Ball>{pair->a, pair->b};
}

Closest closest_points(const PosedTriangle3& a, const PosedTriangle3& b) {
  const auto pair = least_pair_exactly(a, b, true);
  const auto point = [](const WeightedPoint<BigDyadic>& p) {
    const auto rounded = [&](const BigDyadic& x) { return rounded_quotient(Rounding::nearest, x, p.weight); };
    return Point3{rounded(p.at.x), rounded(p.at.y), rounded(p.at.z)};
  };
  return {point(pair.a), point(pair.b), rounded_distance(pair), pair.feature_a, pair.feature_b};
}
double distance(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const auto quick = least_pair<Ball>(a, b, false, ask);
  if (quick && ask.certain()) {
    if (const auto d = root(quotient(quick->square, quick->over)).nearest()) return *d;
  }
  return rounded_distance(least_pair_exactly(a, b, false));
}
Rational squared_distance_exact(const PosedTriangle3& a, const PosedTriangle3& b) {
  const auto pair = least_pair_exactly(a, b, false);
  return exact_number(pair.square) / exact_number(pair.over);
}
std::optional<std::array<Feature, 2>> quick_features(const PosedTriangle3& a, const PosedTriangle3& b) {
  CertainSigns ask;
  const auto pair = least_pair<Ball>(a, b, false, ask);
  if (!pair || !ask.certain()) return {};
  return std::array{pair->feature_a, pair->feature_b};
}
Sign compare_distance(const PosedTriangle3& a, const PosedTriangle3& b, double than) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const auto pair = least_pair<T>(a, b, false, ask);
    return pair ? ask(pair->square - T(than) * T(than) * pair->over) : Sign::zero;
  });
}

}  // namespace plumb::query
