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
Vec<T> over(const Vec<T>& v, const T& whole) {
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

/// Of figures that do not meet.
template <class T>
std::optional<Closest> points_over(const CoreCorners& a, const CoreCorners& b, double radius_a, double radius_b,
                                   const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<T>(a, b, corners, ask);
  const T between = root(quotient(n.square, n.square_whole));
  const T left = between - (T(radius_a) + T(radius_b));
  if (certain_sign(left) <= 0) return {};
  Vec<T> p = over(weighted_corners(a, corners, 0, n), n.whole);
  Vec<T> q = over(weighted_corners(b, corners, 1, n), n.whole);
  const Vec<T> way = q - p;
  if (radius_a > 0) p = p + way * quotient(T(radius_a), between);
  if (radius_b > 0) q = q - way * quotient(T(radius_b), between);
  const auto on_a = nearest_doubles_of(p), on_b = nearest_doubles_of(q);
  const auto d = left.nearest();
  if (!on_a || !on_b || !d) return {};
  return Closest{*on_a, *on_b, *d, {}, {}};
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

std::optional<QuickPair> QuickPair::of(const PosedView& a, const PosedView& b) {
  for (const PosedView* v : {&a, &b}) {
    const bool may_be_concave = is_one_of(v->figure.kind, {FigureKind::quadrilateral, FigureKind::polygon});
    if (v->figure.dimension == 2 || may_be_concave || !is_rigid(v->pose)) return {};
    if (!with_figure(v->figure, [](const auto& s) { return is_sound(s); })) return {};
  }
  const double radius_a = radius_of(a.figure), radius_b = radius_of(b.figure);
  if (!(radius_a >= 0 && radius_b >= 0 && radius_a + radius_b < Ball::infinity)) return {};
  auto p = CoreCorners::of(BodyView{.figure = a.figure, .pose = a.pose}),
       q = CoreCorners::of(BodyView{.figure = b.figure, .pose = b.pose});
  if (!p || !q || !p->is_finite() || !q->is_finite()) return {};
  bring_to_one_weight(*p, *q);
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

std::optional<NearestPair> QuickPair::pair() const {
  if (proved_.meets || !proved_.is_alone) return {};
  return any_pair();
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

std::optional<Closest> QuickPair::closest(const FigureView& a, const FigureView& b) const {
  if (proved_.meets || !proved_.is_alone) return {};
  const auto feature_a = feature_of_corners(a, a_, named(proved_.corners, 0).all(), proved_.a);
  const auto feature_b = feature_of_corners(b, b_, named(proved_.corners, 1).all(), proved_.b);
  if (!feature_a || !feature_b) return {};
  return closest(*feature_a, *feature_b);
}

std::optional<Closest> QuickPair::closest(const Feature& feature_a, const Feature& feature_b) const {
  if (proved_.meets || !proved_.is_alone) return {};
  auto c = points_over<Pairs>(a_, b_, radius_a_, radius_b_, proved_.corners);
  if (!c) c = points_over<Ball>(a_, b_, radius_a_, radius_b_, proved_.corners);
  if (c) c->feature_a = feature_a, c->feature_b = feature_b;
  return c;
}

}  // namespace plumb::query
