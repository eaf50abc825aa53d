#include "query/gjk/body_pair.hpp"

#include "query/gjk/least_face.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

/// Of the hull's points those that span the least face, where the plane through it holds no others.
std::optional<Feature> feature_of(const SeenBody& s, std::span<const std::uint32_t> of, const Support& support) {
  const bool is_polygon =
      !s.view.is_hull() && is_one_of(s.view.figure.kind, {FigureKind::quadrilateral, FigureKind::polygon});
  if (is_polygon && of.size() > 1) return {};
  if (!s.view.is_hull() && !is_polygon) return feature_of_corners(s.view.figure, s.corners, of, support);
  if (support.level != support.known) return {};
  return least_feature(of);
}

bool is_double(const mpq_class& x) { return mpq_class(x.get_d()) == x; }

}  // namespace

Feature least_feature(std::span<const std::uint32_t> of) {
  constexpr std::array kinds{FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};
  return {kinds[of.size() - 1], *std::ranges::min_element(of)};
}

std::vector<Exact3> exact_corners(const CoreCorners& c) {
  std::vector<Exact3> all;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const auto p = c.at<mpq_class>(i);
    all.push_back({p.x, p.y, p.z});
  }
  return all;
}

std::optional<ToldPair> closest_at_once(const QuickPair& pair, const SeenBody& a, const SeenBody& b,
                                        const ProvedCorners& proved, WhichPair common) {
  if (proved.meets || !proved.is_alone) return {};
  const auto feature_a = feature_of(a, named(proved.corners, 0).all(), proved.a);
  const auto feature_b = feature_of(b, named(proved.corners, 1).all(), proved.b);
  if (!feature_a || !feature_b) return {};
  auto c = pair.closest(*feature_a, *feature_b);
  if (c && c->meets && common == WhichPair::any) {
    c->closest.feature_a = c->closest.feature_b = {FeatureKind::interior, 0};
  }
  return c;
}

mpq_class BodyPair::square(const ProvedCorners& proved) const { return QuickPair(a(), b(), 0, 0, proved).square(); }

bool BodyPair::meets(const ProvedCorners& proved) const {
  return proved.meets || (sgn(reach()) > 0 && square(proved) <= reach() * reach());
}

double BodyPair::distance(const ProvedCorners& proved) const {
  return proved.meets ? 0 : rounded_distance(square(proved), reach());
}

NearestPair BodyPair::nearest(const ProvedCorners& proved) const {
  return QuickPair(a(), b(), 0, 0, proved).any_pair();
}

Closest BodyPair::closest(const ProvedCorners& proved, WhichPair which) const {
  const mpq_class &radius_a = bodies_[0].radius, &radius_b = bodies_[1].radius;
  if (is_double(radius_a) && is_double(radius_b)) {
    const QuickPair quick(a(), b(), radius_a.get_d(), radius_b.get_d(), proved);
    if (const auto c = closest_at_once(quick, {views_[0], a()}, {views_[1], b()}, proved, which)) return c->closest;
  }
  const bool is_first = which == WhichPair::first;
  const std::array points{exact_corners(a()), exact_corners(b())};
  const NearestPair pair = is_first && !(proved.is_alone && !proved.meets)
                               ? *nearest_pair({points[0], {}, {}}, {points[1], {}, {}}, which)
                               : nearest(proved);
  if (!is_first && meets(proved)) return told_places(pair, radius_a, radius_b);
  constexpr Point3 some{};
  std::array<std::optional<ExactMap>, 2> maps;
  const auto seen = [&](std::size_t i) -> SeenFigure {
    if (views_[i].is_hull()) return {view_of(some), bodies_[i].radius};
    if (views_[i].pose.stands()) return {views_[i].figure, bodies_[i].radius};
    maps[i] = exact_map(views_[i].pose);
    return {views_[i].figure, bodies_[i].radius, &*maps[i]};
  };
  Closest c = told_pair(pair, seen(0), seen(1));
  const Exact3 way = pair.on_b - pair.on_a;  // of bodies that meet none, and all points are level
  if (views_[0].is_hull()) c.feature_a = least_face(points[0], pair.on_a, way);
  if (views_[1].is_hull()) c.feature_b = least_face(points[1], pair.on_b, way);
  return c;
}

}  // namespace plumb::query
