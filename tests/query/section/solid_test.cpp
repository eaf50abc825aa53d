// Have two solids in common what rationals say, and is it told as the laws say: corners, faces, volume?
#include "plumb/query/section/solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/section/enumerated.hpp"

namespace plumb {
namespace {

using exact::Bound, exact::bound, exact::Bounds, exact::Coordinates, exact::cross, exact::difference, exact::dot,
    exact::enumerate, exact::Enumerated, exact::supports;
using shape_cases::Material, shape_cases::on_shapes;

template <class Figure>
Figure solid_figure(Material& m) {
  if constexpr (std::is_same_v<Figure, ConvexPolyhedron3>) {
    std::vector<Point3> points;
    for (std::size_t n = 4 + m.below(4); n-- > 0;) points.push_back(m.point3());
    for (const Point3& p : {Point3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
      if (const Hull3 hull = convex_hull(points); hull.dimension == 3) return convex_polyhedron(hull, points);
      points.push_back(p);
    }
    return convex_polyhedron(convex_hull(points), points);
  } else if constexpr (std::is_same_v<Figure, KDop3>) {
    const std::vector points{m.point3(), m.point3(), m.point3()};
    const Directions3 axes = k_dop_directions(6), directions = m.below(2) == 0 ? axes : k_dop_directions(14);
    KDop3 k = fit_k_dop(points, axes);
    try {
      k = fit_k_dop(points, directions);
    } catch (const BeyondDoubles&) {  // a sum of coordinates: the axes alone
    }
    if (m.below(3) == 0) k.max[m.below(k.max.size())] = m.number();
    return k;
  } else {
    return m.shape<Figure>();
  }
}

/// The faces of a solid are those of the hull of its vertices, told as the laws say: what is wrong, or nothing.
std::string wrong_faces(const SolidIntersection3& s) {
  if (s.kind != IntersectionKind::solid || !s.is_bounded()) return s.faces() == 0 ? "" : "faces of no solid";
  std::vector<Coordinates> v;
  for (const ExactPoint3& p : s.vertices) v.push_back(exact::of(p));
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::uint32_t> before;
  for (std::size_t f = 0; f < s.faces(); ++f) {
    const auto face = s.corners_of(f);
    const std::vector<std::uint32_t> ids(face.begin(), face.end());
    if (ids.size() < 3 || std::ranges::min_element(ids) != ids.begin() || !(before < ids)) return "wrong order";
    before = ids;
    const Coordinates normal = cross(difference(v[ids[1]], v[ids[0]]), difference(v[ids[2]], v[ids[0]]));
    for (std::uint32_t i = 0; i < v.size(); ++i) {
      const int side = sgn(dot(normal, difference(v[i], v[ids[0]])));
      if (side != (std::ranges::find(ids, i) == ids.end() ? -1 : 0)) return "not a whole face from outside";
    }
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const std::uint32_t a = ids[i], b = ids[(i + 1) % ids.size()], c = ids[(i + 2) % ids.size()];
      if (sgn(dot(normal, cross(difference(v[b], v[a]), difference(v[c], v[b])))) <= 0) return "not strictly convex";
      if (!edges.insert({a, b}).second) return "an edge is passed twice";
    }
    const RationalHalfspace3 plane = plane_of(s, f);
    const Coordinates n{plane.normal.x.value().value, plane.normal.y.value().value, plane.normal.z.value().value};
    if (exact::square(cross(n, normal)) != 0 || dot(n, normal) <= 0) return "wrong normal";
    if (dot(n, v[ids[0]]) != plane.offset.value().value) return "wrong offset";
  }
  for (const auto& [a, b] : edges) {
    if (!edges.contains({b, a})) return "not closed";
  }
  return v.size() + s.faces() == edges.size() / 2 + 2 ? "" : "a vertex of no face";
}

std::string wrong(const SolidIntersection3& s, const exact::CommonSet& set) {
  const std::string text = exact::wrong(Intersection3{s.kind, s.vertices}, set);
  return text.empty() ? wrong_faces(s) : text;
}

std::string wrong(const SolidIntersection3& s, const Bounds& all) {
  const Enumerated set = enumerate(all);
  if (!set.has_corners) return "";  // holds a line, or is nothing
  std::vector<Coordinates> v;
  for (const ExactPoint3& p : s.vertices) v.push_back(exact::of(p));
  if (s.kind == IntersectionKind::ray) v.pop_back();
  std::vector<Coordinates> expected = set.points, found = v;
  std::ranges::sort(expected);
  std::ranges::sort(found);
  if (expected != found) return "wrong vertices";
  if (s.empty()) return "";
  for (const RationalPoint3& d : s.directions) {
    const Coordinates e{d.x.value().value, d.y.value().value, d.z.value().value};
    if (std::ranges::none_of(set.directions, [&](const Coordinates& f) {
          return dot(e, f) > 0 && dot(e, f) * dot(e, f) == dot(e, e) * dot(f, f);
        })) {
      return "wrong direction";
    }
  }
  if (set.directions.empty() != s.is_bounded()) return "bounded or not";
  if (v.size() == 1 && s.is_bounded() && s.kind != IntersectionKind::point) return "no point";
  if (v.size() == 2 && s.is_bounded() && s.kind != IntersectionKind::segment) return "no segment";
  return wrong_faces(s);
}

/// A figure whose type was forgotten.
struct Drawn {
  query::FigureView view;
  Bounds bounds;
  std::shared_ptr<const void> held;
  std::string about;
};
template <class Figure>
Drawn drawn(Material& m) {
  for (int tries = 0; tries < 20; ++tries) {
    const auto s = std::make_shared<const Figure>(solid_figure<Figure>(m));
    Drawn d{query::view_of(*s), {}, s, m.about(*s)};
    if constexpr (requires { s->halfspaces; }) {
      for (const Halfspace3& h : s->halfspaces) d.bounds.push_back(bound(h.normal, h.offset));
    } else if constexpr (requires { s->directions; }) {
      for (std::size_t i = 0; i < s->min.size(); ++i) {
        d.bounds.push_back(bound(s->directions.all()[i], s->max[i]));
        d.bounds.push_back(bound(s->directions.all()[i], s->min[i], -1));
      }
    } else if constexpr (requires { s->normal; }) {
      d.bounds.push_back(bound(s->normal, s->offset));
    } else if constexpr (std::is_same_v<Figure, Aabb3>) {
      for (const auto& [axis, low, high] : {std::tuple{Vector3{1, 0, 0}, s->min.x, s->max.x},
                                            {Vector3{0, 1, 0}, s->min.y, s->max.y},
                                            {Vector3{0, 0, 1}, s->min.z, s->max.z}}) {
        d.bounds.push_back(bound(axis, high));
        d.bounds.push_back(bound(axis, low, -1));
      }
    } else {
      d.bounds = supports(exact::generated(*s).points);
      if (d.bounds.size() < 4) continue;  // flat: tried elsewhere
      if (std::ranges::any_of(d.bounds, [&](const Bound& b) {
            return std::ranges::all_of(exact::generated(*s).points,
                                       [&](const Coordinates& p) { return dot(b.normal, p) == b.offset; });
          })) {
        continue;
      }
    }
    return d;
  }
  return drawn<Aabb3>(m);  // all points of this family lie in one plane
}

using Draw = Drawn (*)(Material&);
constexpr std::array<Draw, 7> draws{drawn<Halfspace3>,
                                    drawn<Tetrahedron3>,
                                    drawn<Aabb3>,
                                    drawn<Obb3>,
                                    drawn<KDop3>,
                                    drawn<HalfspaceIntersection3>,
                                    drawn<ConvexPolyhedron3>};

constexpr auto nothing = IntersectionKind::nothing, solid = IntersectionKind::solid;

TEST(Solid, CornersAreWhereThreePlanesMeet) {
  std::map<IntersectionKind, int> count;
  int unbounded = 0;
  std::uint64_t pair = 0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    for (std::size_t j = i; j < draws.size(); ++j) {
      on_shapes(220 + pair++, battery::sanitized ? 1 : 3, [&](Material& m) {
        const Drawn a = draws[i](m), b = draws[j](m);
        const SolidIntersection3 told = query::common_solid(a.view, b.view);
        Bounds all = a.bounds;
        all.insert(all.end(), b.bounds.begin(), b.bounds.end());
        EXPECT_EQ(wrong(told, all), "") << name_of(a.view.kind) << " " << a.about << name_of(b.view.kind) << " "
                                        << b.about;
        EXPECT_TRUE(told == query::common_solid(b.view, a.view)) << a.about << b.about;
        ++count[told.kind];
        unbounded += told.is_bounded() ? 0 : 1;
      });
    }
  }
  EXPECT_GE(count[nothing], 2);
  EXPECT_GE(count[solid], 5);
  EXPECT_GE(unbounded, 1);
}

template <class A, class B>
void hold(std::uint64_t start, std::uint64_t cases, std::initializer_list<IntersectionKind> kinds, int least = 2) {
  std::map<IntersectionKind, int> count;
  on_shapes(start, battery::sanitized ? 1 + cases / 10 : cases, [&](Material& m) {
    const A a = solid_figure<A>(m);
    const B b = solid_figure<B>(m);
    const SolidIntersection3 told = intersection(a, b);
    ++count[told.kind];
    EXPECT_EQ(wrong(told, exact::common(exact::generated(a), exact::generated(b))), "") << m.about(a, b);
    EXPECT_TRUE(told == intersection(b, a)) << m.about(a, b);
    EXPECT_EQ(told.empty(), !intersects(a, b)) << m.about(a, b);
  });
  if (!battery::reaches_rare) return;
  for (const IntersectionKind kind : kinds)
    EXPECT_GE(count[kind], least) << static_cast<int>(kind) << " start " << start;
}

TEST(Solid, AgreesWithRationals) {
  hold<Tetrahedron3, Tetrahedron3>(201, 14, {nothing}, 1);
  hold<Halfspace3, Tetrahedron3>(203, 24, {nothing, solid}, 1);
  hold<Halfspace3, Obb3>(205, 6, {});
}

TEST(Solid, VolumesAddUp) {
  // A plane cuts a solid into two, whose volumes add up; what a solid has in common with itself is itself.
  int cut = 0;
  on_shapes(250, battery::sanitized ? 4 : 30, [&](Material& m) {
    const auto t = solid_figure<ConvexPolyhedron3>(m);
    const auto box = m.shape<Obb3>();
    const auto h = m.shape<Halfspace3>();
    if (h.normal == Vector3{}) return;
    const Halfspace3 against{{-h.normal.x, -h.normal.y, -h.normal.z}, -h.offset};
    const Rational whole = exact_volume(intersection(t, t));
    EXPECT_EQ(whole.rounded(), volume(t)) << m.about(h);
    const Rational one = exact_volume(intersection(t, h)), other = exact_volume(intersection(against, t));
    EXPECT_EQ(one + other, whole) << m.about(h);
    cut += one.sign() * other.sign() == Sign::positive ? 1 : 0;
    EXPECT_EQ(exact_volume(intersection(box, box)).rounded(), volume(box)) << m.about(box);
    EXPECT_EQ(exact_volume(intersection(h, box)) + exact_volume(intersection(against, box)),
              exact_volume(intersection(box, box)))
        << m.about(h, box);
  });
  EXPECT_GE(cut, 1);
}

TEST(Solid, Touches) {
  const Aabb3 cube{{0, 0, 0}, {2, 2, 2}};
  const auto kind = [&](const Aabb3& b) { return intersection(cube, b).kind; };
  EXPECT_EQ(kind({{2, 2, 2}, {3, 3, 3}}), IntersectionKind::point);
  EXPECT_EQ(kind({{2, 2, 1}, {3, 3, 3}}), IntersectionKind::segment);
  EXPECT_EQ(kind({{2, 1, 1}, {3, 3, 3}}), IntersectionKind::polygon);
  EXPECT_EQ(kind({{1, 1, 1}, {3, 3, 3}}), IntersectionKind::solid);
  EXPECT_EQ(kind({{1, 1, 1}, {1, 3, 3}}), IntersectionKind::polygon);
  EXPECT_EQ(kind({{3, 0, 0}, {4, 1, 1}}), IntersectionKind::nothing);
  EXPECT_EQ(kind({{1, 0, 0}, {0, 1, 1}}), IntersectionKind::nothing);
  const SolidIntersection3 same = intersection(cube, cube);
  EXPECT_EQ(same.vertices.size(), 8u);
  EXPECT_EQ(same.faces(), 6u);
  EXPECT_EQ(volume(same), 8);
  EXPECT_EQ(plane_of(same, 0).normal, (RationalPoint3{-1, 0, 0}));
  // Edges that cross: a point that is a vertex of neither.
  const Tetrahedron3 wedge{{2, 1, 2}, {4, 1, 0}, {3, 0, 3}, {3, 2, 3}};
  EXPECT_EQ(intersection(cube, wedge).kind, IntersectionKind::point);
  const Tetrahedron3 ridge{{1, 3.5, 1.5}, {3.5, 1, 1.5}, {3, 3, 0}, {3, 3, 3}};
  EXPECT_EQ(intersection(cube, ridge).kind, IntersectionKind::nothing);
  const Tetrahedron3 crossing{{1, 3, 1.5}, {3, 1, 1.5}, {3, 3, 0}, {3, 3, 3}};
  const SolidIntersection3 corner = intersection(cube, crossing);
  ASSERT_EQ(corner.kind, IntersectionKind::point);
  EXPECT_EQ(approximate(corner), (std::vector<Point3>{{2, 2, 1.5}}));
  // All of the doubles' range.
  EXPECT_EQ(volume(intersection(Aabb3{{0, 0, 0}, {0x1p1000, 1, 1}}, Aabb3{{-1, -1, -1}, {0x1p-1000, 1, 1}})),
            0x1p-1000);
}

TEST(Solid, GoesOnForever) {
  const Halfspace3 below{{0, 0, 1}, 1}, left{{2, 0, 0}, 1};
  const SolidIntersection3 quarter = intersection(below, left);
  EXPECT_EQ(quarter.kind, IntersectionKind::solid);
  EXPECT_FALSE(quarter.is_bounded());
  EXPECT_THROW((void)volume(quarter), InvalidShape);
  EXPECT_EQ(intersection(below, Halfspace3{{0, 0, -1}, -1}).kind, IntersectionKind::polygon);
  EXPECT_EQ(intersection(below, Halfspace3{{0, 0, -1}, -2}).kind, IntersectionKind::nothing);
  const HalfspaceIntersection3 beam{{{{1, 0, 0}, 0}, {{-1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, -1, 0}, 0}}};
  EXPECT_EQ(intersection(beam, HalfspaceIntersection3{}).kind, IntersectionKind::line);
  const SolidIntersection3 ray = intersection(below, beam);
  ASSERT_EQ(ray.kind, IntersectionKind::ray);
  EXPECT_EQ(ray.vertices[0], ExactPoint3(Point3{0, 0, 1}));
  EXPECT_EQ(ray.vertices[1], ExactPoint3(Point3{0, 0, 0}));
}

TEST(Solid, BadInputIsNamed) {
  EXPECT_EQ(text_of<Error>([] {
              (void)intersection(Aabb3{{0, 0, 0}, {1, 1, NAN}}, Tetrahedron3{});
            }),
            "intersection: aabb.max.z is nan, not a real number; give a finite double");
  EXPECT_EQ(text_of<Error>([] {
              (void)intersection(Halfspace3{{1, 0, 0}, INFINITY}, Aabb3{});
            }),
            "intersection: halfspace.offset is inf, not a real number; give a finite double");
}

}  // namespace
}  // namespace plumb
