#include "query/separation/quick.hpp"

#include "arith/exact_number.hpp"
#include "arith/twofold.hpp"
#include "plumb/arith/ball.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/vectors.hpp"
#include "query/convex/core.hpp"

namespace plumb::query {
namespace {

mpq_class quotient_of(const BigDyadic& n, const BigDyadic& d) { return mpq_class(gmp_number(n) / gmp_number(d)); }

/// Weighted by the corners of the difference that they belong to.
template <class T>
Vec<T> weighted_corners(const CoreCorners& c, const DifferenceCorners& corners, std::size_t which,
                        const NearestOfCorners<T>& n) {
  Vec<T> sum = c.at<T>(corners.ends[0][which]) * n.weight[0];
  for (std::size_t i = 1; i < corners.size; ++i) sum = sum + c.at<T>(corners.ends[i][which]) * n.weight[i];
  return sum;
}

template <class T>
Vec<T> each_over(const Vec<T>& v, const T& whole) {
  return {quotient(v.x, whole), quotient(v.y, whole), quotient(v.z, whole)};
}

template <class T>
std::optional<Point3> nearest_doubles_of(const Vec<T>& v) {
  const auto x = v.x.nearest(), y = v.y.nearest(), z = v.z.nearest();
  if (!x || !y || !z) return {};
  return told(Point3{*x, *y, *z});
}

/// Zero where the figures meet; nothing where it is not certain, or between two doubles.
template <class T>
std::optional<double> distance_over(const CoreCorners& a, const CoreCorners& b, double radius_a, double radius_b,
                                    const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<T, Sought::square>(a, b, corners, ask);
  const T between = root(quotient(n.square, n.square_whole));
  const T left = between - (T(radius_a) + T(radius_b));
  const int sign = certain_sign(left);
  if (sign > 0) return left.nearest();
  if constexpr (std::is_same_v<T, Ball>) {
    if (left.sign().certain()) return 0;
  }
  return {};
}

/// Where radii reach farther than the cores are apart: the point that divides the way between these as the radii do.
template <class T>
std::optional<ToldPair> points_over(const CoreCorners& a, const CoreCorners& b, double radius_a, double radius_b,
                                    const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<T>(a, b, corners, ask);
  const T between = root(quotient(n.square, n.square_whole)), reach = T(radius_a) + T(radius_b);
  const T left = between - reach;
  const int side = certain_sign(left);
  if (side == 0) return {};
  Vec<T> p = each_over(weighted_corners(a, corners, 0, n), n.whole);
  Vec<T> q = each_over(weighted_corners(b, corners, 1, n), n.whole);
  const Vec<T> way = q - p;
  if (side < 0) {
    const auto common = nearest_doubles_of(p + way * quotient(T(radius_a), reach));
    if (!common) return {};
    return ToldPair{{*common, *common, 0, {}, {}}, true};
  }
  if (radius_a > 0) p = p + way * quotient(T(radius_a), between);
  if (radius_b > 0) q = q - way * quotient(T(radius_b), between);
  const auto on_a = nearest_doubles_of(p), on_b = nearest_doubles_of(q);
  const auto d = left.nearest();
  if (!on_a || !on_b || !d) return {};
  return ToldPair{{*on_a, *on_b, *d, {}, {}}, false};
}

/// Of cores that meet by the weights of corners that hold the origin.
template <class T>
std::optional<Point3> common_over(const CoreCorners& a, const CoreCorners& b, double radius_a, double radius_b,
                                  const ProvedCorners& proved) {
  if (!proved.meets) {
    const auto told = points_over<T>(a, b, radius_a, radius_b, proved.corners);
    return told && told->meets ? std::optional(told->closest.on_a) : std::nullopt;
  }
  CertainSigns ask;
  const auto n = nearest_of<T>(a, b, proved.corners, ask);
  if (certain_sign(n.whole) == 0) return {};
  return nearest_doubles_of(each_over(weighted_corners(a, proved.corners, 0, n), n.whole));
}

using Pairs = Twofold<false>;

}  // namespace

std::optional<QuickPair> QuickPair::of(const FigureAt& a, const FigureAt& b) {
  for (const FigureAt* at : {&a, &b}) {
    if (!with_figure(at->figure, [](const auto& s) { return is_sound(s); })) return {};
  }
  const double radius_a = radius_of(a.figure), radius_b = radius_of(b.figure);
  if (!(radius_a >= 0 && radius_b >= 0 && radius_a + radius_b < Ball::infinity)) return {};
  auto p = CoreCorners::of(a.figure), q = CoreCorners::of(b.figure);
  if (!p || !q) return {};
  p->move(a.by, a.time), q->move(b.by, b.time);
  const auto proved = proved_nearest(*p, *q);
  if (!proved) return {};
  return QuickPair(*p, *q, radius_a, radius_b, *proved);
}

std::optional<double> QuickPair::distance() const {
  if (proved_.meets) return 0;
  if (const auto d = distance_over<Pairs>(a_, b_, radius_a_, radius_b_, proved_.corners)) return d;
  return distance_over<Ball>(a_, b_, radius_a_, radius_b_, proved_.corners);
}

mpq_class QuickPair::square() const {
  if (proved_.meets) return 0;
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic, Sought::square>(a_, b_, proved_.corners, ask);
  const BigDyadic scale = a_.scale<BigDyadic>();
  return quotient_of(n.square, n.square_whole * (scale * scale));
}

std::optional<ToldPair> QuickPair::common() const {
  auto p = common_over<Pairs>(a_, b_, radius_a_, radius_b_, proved_);
  if (!p) p = common_over<Ball>(a_, b_, radius_a_, radius_b_, proved_);
  if (!p) return {};
  constexpr Feature interior{FeatureKind::interior, 0};
  return ToldPair{{*p, *p, 0, interior, interior}, true};
}

NearestPair QuickPair::any_pair() const {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a_, b_, proved_.corners, ask);
  const BigDyadic scale = a_.scale<BigDyadic>(), whole = n.whole * scale;
  const auto place = [&](const CoreCorners& c, std::size_t which) -> Exact3 {
    const Vec<BigDyadic> sum = weighted_corners(c, proved_.corners, which, n);
    return {quotient_of(sum.x, whole), quotient_of(sum.y, whole), quotient_of(sum.z, whole)};
  };
  return {place(a_, 0), place(b_, 1), quotient_of(n.square, n.square_whole * (scale * scale)), true};
}

std::optional<ToldPair> QuickPair::closest(const Feature& feature_a, const Feature& feature_b) const {
  if (proved_.meets || !proved_.is_alone) return {};
  auto told = points_over<Pairs>(a_, b_, radius_a_, radius_b_, proved_.corners);
  if (!told) told = points_over<Ball>(a_, b_, radius_a_, radius_b_, proved_.corners);
  if (!told) return {};
  constexpr Feature interior{FeatureKind::interior, 0};
  told->closest.feature_a = told->meets && radius_a_ > 0 ? interior : feature_a;
  told->closest.feature_b = told->meets && radius_b_ > 0 ? interior : feature_b;
  return told;
}

}  // namespace plumb::query
