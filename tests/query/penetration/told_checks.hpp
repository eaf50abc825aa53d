// Is this the answer?  What was told of a penetration against what brute force expects: a text that says what is wrong,
// or nothing.
//
// Laws: numbers are compared with bounds of the exact ones of 2,000 bits; features with the point in the middle of the
// corners that lie in the plane.
#pragma once

#include <string>

#include "plumb/arith/big.hpp"
#include "query/convex/features.hpp"
#include "query/penetration/oracle.hpp"

namespace plumb::told_checks {

using namespace penetration_oracle;

inline constexpr mp_bitcnt_t digits = 2000;

/// Is x the double nearest to y?  Where y is as near to two but for 300 bits, either will do.
inline bool is_nearest_to(double x, const mpf_class& y) {
  if (std::signbit(x) && x == 0) return false;
  const mpf_class largest(std::numeric_limits<double>::max(), digits);
  if (!std::isfinite(x)) return abs(y) > largest && (x > 0) == (y > 0);
  const mpf_class off = abs(mpf_class(y - mpf_class(x, digits)));
  const auto is_as_near = [&](double other) {
    if (!std::isfinite(other)) return true;
    const mpf_class to(other, digits);
    return off <= abs(mpf_class(y - to)) + abs(to - mpf_class(x, digits)) * mpf_class(0x1p-300, digits);
  };
  return is_as_near(std::nextafter(x, HUGE_VAL)) && is_as_near(std::nextafter(x, -HUGE_VAL));
}

inline mpf_class big(const mpq_class& x) { return mpf_class(x, digits); }

inline Penetration reversed(const Penetration& p) {
  const auto back = [](const Vector3& v) { return Vector3{0.0 - v.x, 0.0 - v.y, 0.0 - v.z}; };
  return {p.depth, back(p.direction), back(p.translation), p.feature_b, p.feature_a, p.is_unique};
}

inline mpq_class gmp(const Rational& x) { return x.value().value; }
inline Exact3 gmp(const ExactVector3& v) { return {gmp(v.x), gmp(v.y), gmp(v.z)}; }

inline bool same_direction(const Exact3& u, const Exact3& v) {
  return query::is_zero(cross(u, v)) && sgn(dot(u, v)) > 0;
}

inline std::string fault(const Expected& wanted, const Round& a, const Round& b, const Penetration& told,
                         const ExactPenetration& exact) {
  const Exact3 way = gmp(exact.direction);
  if (told.is_unique != wanted.is_unique || exact.is_unique != wanted.is_unique) return "is_unique";
  if (exact.cores_are_apart != wanted.apart) return "cores_are_apart";
  if (gmp(exact.core_square) != wanted.core_square) return "core_square";
  if (gmp(exact.radii) != a.radius + b.radius) return "radii";
  if (!same_direction(way, wanted.direction)) return "exact direction";
  for (const Rational* x : {&exact.direction.x, &exact.direction.y, &exact.direction.z}) {
    if (!x->is_integer()) return "a direction in integers";
  }
  if (gcd(gcd(way[0].get_num(), way[1].get_num()), way[2].get_num()) != 1) return "a direction without a common factor";
  const Exact3 by = gmp(exact.core_translation);
  if (dot(by, by) != wanted.core_square) return "length of the exact translation";
  const int along = wanted.apart ? -1 : 1;
  if (wanted.core_square != 0 && !same_direction(mpq_class(along) * by, way)) return "exact translation";
  if (told.feature_a != exact.feature_a || told.feature_b != exact.feature_b) return "features that differ";
  const mpf_class length = sqrt(big(dot(way, way)));
  const mpf_class depth = big(a.radius + b.radius) + along * sqrt(big(wanted.core_square));
  if (!is_nearest_to(told.depth, depth)) return "depth";
  const std::array direction{told.direction.x, told.direction.y, told.direction.z};
  const std::array translation{told.translation.x, told.translation.y, told.translation.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const mpf_class unit = big(way[k]) / length;
    if (!is_nearest_to(direction[k], unit)) return "direction";
    if (!is_nearest_to(translation[k], unit * depth)) return "translation";
  }
  return "";
}

/// The corners of a body that lie in the plane of contact.
inline std::vector<Exact3> level_corners(const Round& r, const Exact3& out) {
  std::vector<Exact3> level;
  for (const Exact3& p : r.corners) {
    const int more = level.empty() ? 1 : sgn(dot(out, p - level[0]));
    if (more > 0) level.clear();
    if (more >= 0) level.push_back(p);
  }
  return level;
}
inline int dimension(const std::vector<Exact3>& points) {
  int most = 0;
  for (const Exact3& p : points) {
    for (const Exact3& q : points) {
      if (p != points[0]) most = std::max(most, 1);
      if (!query::is_zero(cross(p - points[0], q - points[0]))) most = 2;
    }
  }
  return most;
}

/// The first face of a polyhedron whose corners are all in the plane.
inline std::uint32_t first_face(const PolygonMesh& m, const Round& r, const Exact3& out, const Exact3& in_plane) {
  std::uint32_t face = 0;
  const auto is_level = [&](std::uint32_t v) { return dot(out, r.corners[v] - in_plane) == 0; };
  while (!std::all_of(m.corners.begin() + m.first[face], m.corners.begin() + m.first[face + 1], is_level)) ++face;
  return face;
}

/// `checked` counts those that a point in the middle tells apart: where no vertex stands twice in the plane, and no
/// edge of it is in two parts.
inline std::string fault_of_feature(const query::BodyView& body, const Round& r, const Exact3& out, const Feature& told,
                                    int& checked) {
  const std::vector<Exact3> level = level_corners(r, out);
  const int is = dimension(level);
  const bool is_round = !body.is_hull() && query::is_one_of(body.figure.kind, {FigureKind::ball, FigureKind::capsule,
                                                                               FigureKind::lozenge});
  if (!is_round && static_cast<int>(told.kind) != is) return "dimension of a feature";
  if (body.is_hull()) {  // the first corner in the plane
    std::uint32_t first = 0;
    while (dot(out, r.corners[first] - level[0]) != 0) ++first;
    return told.index == first ? "" : "vertex of a hull";
  }
  if (is == 2 && body.figure.kind == FigureKind::convex_polyhedron) {
    const auto& mesh = static_cast<const ConvexPolyhedron3*>(body.figure.shape)->mesh;
    return told.index == first_face(mesh, r, out, level[0]) ? "" : "face of a polyhedron";
  }
  const bool is_solid =
      query::is_one_of(body.figure.kind, {FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb});
  if (is_solid && level.size() == r.corners.size()) return "";  // a flat one, of which several faces lie in the plane
  if (is < 2 && level.size() != static_cast<std::size_t>(is) + 1) return "";
  Exact3 middle{0, 0, 0};
  for (const Exact3& p : level) middle = middle + mpq_class(1, static_cast<unsigned long>(level.size())) * p;
  std::optional<query::ExactMap> map;
  if (!body.pose.stands()) map = query::exact_map(body.pose);
  const Feature at = query::feature_at(body.figure, middle, false, map ? &*map : nullptr);
  if (!is_round && static_cast<int>(at.kind) != is) return "";  // several features in one line or plane
  ++checked;
  return at == told ? "" : "feature";
}
inline std::string fault_of_features(const Expected& wanted, const Round& a, const Round& b,
                                     const query::BodyView& of_a, const query::BodyView& of_b, const Feature& on_a,
                                     const Feature& on_b, int& checked) {
  const std::string first = fault_of_feature(of_a, a, mpq_class(-1) * wanted.direction, on_a, checked);
  return first.empty() ? fault_of_feature(of_b, b, wanted.direction, on_b, checked) : first;
}

/// Of what is not round: it touches after the whole exact way, and overlaps before.
inline std::string fault_of_move(const ExactPenetration& exact, const Round& a, const Round& b) {
  if (a.radius != 0 || b.radius != 0) return "";
  const Exact3 way = gmp(exact.core_translation);
  const auto moved = [&](const mpq_class& by) {
    FlatSet s{a.corners, {}, {}};
    for (Exact3& p : s.points) p = p + by * way;
    return query::relate(s, FlatSet{b.corners, {}, {}});
  };
  if (query::is_zero(way)) return moved(1) == Relation::disjoint ? "disjoint where it stands" : "";
  if (moved(1) != Relation::touching) return "no touching after the way";
  return moved(mpq_class(1048575, 1048576)) == Relation::overlapping ? "" : "no overlapping before the end of the way";
}

}  // namespace plumb::told_checks
