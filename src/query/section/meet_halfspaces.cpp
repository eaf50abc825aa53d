#include "query/section/meet_halfspaces.hpp"

#include "arith/exact_number.hpp"
#include "query/section/solid_faces.hpp"

namespace plumb::query::meeting {
namespace {

Corner<BigDyadic, 3> exact_corner(const RationalPoint3& p) {
  Corner<BigDyadic, 3> c{weighted<BigDyadic>(p), {}, {}};
  c.known.fill(unknown);
  return c;
}

SolidIntersection3 bounded_set(std::vector<Exact3> points, const std::vector<ExactHalfspace>& halfspaces) {
  std::ranges::sort(points);
  SolidCorners<BigDyadic> of;
  for (const Exact3& p : points) {
    of.corners.push_back(exact_corner(rational_of(p)));
    Ids on;
    for (std::uint32_t i = 0; i < halfspaces.size(); ++i) {
      if (dot(halfspaces[i].normal, p) == halfspaces[i].offset) on.push_back(i);
    }
    of.on.push_back(std::move(on));
  }
  const auto look = [&](std::size_t i) {
    return face_look([&](std::size_t axis) { return sign_of_number(sgn(halfspaces[i].normal[axis])); });
  };
  const auto name = [](const Corner<BigDyadic, 3>& c) { return std::optional<ExactPoint3>(rational(c.at)); };
  CertainSigns ask;
  return std::move(*solid_of(std::move(of), halfspaces.size(), look, name, ask));
}

SolidIntersection3 unbounded_set(const FlatSet& s) {
  std::vector<Exact3> all = s.directions, points = s.points;
  for (const Exact3& line : s.lines) {
    all.push_back(line);
    all.push_back(mpq_class(-1) * line);
  }
  for (Exact3& d : all) d = primitive(d);
  std::ranges::sort(all);
  std::ranges::sort(points);
  std::vector<Exact3> spans = all;
  for (const Exact3& p : points) spans.push_back(p - points[0]);
  SolidIntersection3 common;
  const std::size_t dimension = rank_of(spans);
  common.kind = dimension == 3    ? IntersectionKind::solid
                : dimension == 2  ? IntersectionKind::polygon
                : s.lines.empty() ? IntersectionKind::ray
                                  : IntersectionKind::line;
  for (const Exact3& d : all) common.directions.push_back(rational_of(d));
  if (dimension == 1) points = {points[0], points[0] + all.back()};
  for (const Exact3& p : points) common.vertices.emplace_back(rational_of(p));
  return common;
}

}  // namespace

RationalPoint3 rational_of(const Exact3& p) { return {exact_number(p[0]), exact_number(p[1]), exact_number(p[2])}; }

SolidIntersection3 meet_halfspaces(const std::vector<ExactHalfspace>& halfspaces) {
  const FlatSet s = flat_set(halfspaces);
  if (s.points.empty()) return {};
  if (s.directions.empty() && s.lines.empty()) return bounded_set(s.points, halfspaces);
  return unbounded_set(s);
}

}  // namespace plumb::query::meeting
