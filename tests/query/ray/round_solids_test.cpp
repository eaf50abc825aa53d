// Are the hits of cones, lozenges and ellipsoids those of real arithmetic?  Held against membership in rationals.
//
// What a line has in common with a convex set is one interval, so that outside just before a parameter, by a part in
// 2^2300, and not outside at it proves that it is the first.  Whether there is a hit at all is that of intersects, which
// asks otherwise; for ellipsoids that of the least value along the line.
#include <gtest/gtest.h>

#include "figure/basic/thrown.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/cases.hpp"
#include "query/ray/oracle.hpp"

namespace plumb {
namespace {

using namespace ray_cases;
namespace oracle = ray_oracle;
using oracle::Coordinates, oracle::Path, oracle::Rational;

/// -1 outside, 0 on the boundary (or in a flat shape), 1 inside.
int where(const Cone3& c, const Coordinates& p) {
  const Coordinates apex = exact::of(c.apex), e = exact::difference(exact::of(c.base), apex),
                    w = exact::difference(p, apex);
  const Rational ee = exact::square(e), along = exact::dot(w, e), rr = exact::squared(c.radius);
  if (ee == 0) return sgn(Rational(rr - exact::square(w)));
  if (along < 0 || along > ee) return -1;
  const Rational off = exact::square(w) - along * along / ee;  // from the axis, squared
  const int side = sgn(Rational(rr * along * along / (ee * ee) - off));
  return side < 0 ? -1 : along == 0 || along == ee ? 0 : side;
}
/// Nearest point of the parallelogram: in its inside, or on an edge.
int where(const Lozenge3& l, const Coordinates& p) {
  const Coordinates o = exact::of(l.corner), e = exact::of(l.edges[0]), f = exact::of(l.edges[1]),
                    n = oracle::cross(e, f), w = exact::difference(p, o);
  std::optional<Rational> least;
  const auto take = [&](const Rational& x) {
    if (!least || x < *least) least = x;
  };
  const Rational zero(0), one(1);
  for (const Coordinates& from : {o, exact::combination(o, 1, f)})
    take(exact::foot(from, e, p, zero, one).squared_distance);
  for (const Coordinates& from : {o, exact::combination(o, 1, e)})
    take(exact::foot(from, f, p, zero, one).squared_distance);
  if (const Rational nn = exact::square(n); nn != 0) {
    const Rational s = exact::dot(oracle::cross(w, f), n) / nn, t = exact::dot(oracle::cross(e, w), n) / nn;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) take(exact::dot(w, n) * exact::dot(w, n) / nn);
  }
  return sgn(Rational(exact::squared(l.radius) - *least));
}
/// By a solution of its columns, where they span space; else by the library's own law, which is tested elsewhere.
std::optional<int> where(const Ellipsoid3& e, const Coordinates& p) {
  std::vector<Coordinates> columns;
  const double half[] = {e.half.x, e.half.y, e.half.z};
  for (std::size_t i = 0; i < 3; ++i)
    columns.push_back(exact::combination(exact::of(Vector3{0, 0, 0}), Rational(half[i]), exact::of(e.axes[i])));
  if (exact::dot(columns[0], oracle::cross(columns[1], columns[2])) == 0) return {};
  const auto s = exact::solve_columns(columns, exact::difference(p, exact::of(e.center)));
  return sgn(Rational(1 - exact::square(*s.unknowns)));
}

template <class Shape>
bool meets(const AnyRay& r, const Shape& s) {
  if (r.kind == AnyRay::Kind::segment) return intersects(Segment3{r.origin, r.end}, s);
  if (r.kind == AnyRay::Kind::ray) return intersects(Ray3{r.origin, r.direction}, s);
  return intersects(Line3{r.origin, r.direction}, s);
}

/// Numbers a part in 2^200 of their size below and above.
std::pair<Rational, Rational> around(const RayParameter& t) {
  const Rational base = t.base.value().value, square = t.square.value().value;
  if (square == 0) return {base, base};
  const mpz_class scale = mpz_class(1) << 2400;
  const mpz_class root = sqrt(mpz_class(square.get_num() * square.get_den() * scale * scale));
  const Rational low = Rational(root, mpz_class(square.get_den() * scale)),
                 high = Rational(mpz_class(root + 1), mpz_class(square.get_den() * scale));
  Rational a = t.greater ? Rational(base + low) : Rational(base - high),
           b = t.greater ? Rational(base + high) : Rational(base - low);
  a.canonicalize(), b.canonicalize();
  return {a, b};
}

struct Seen {
  long misses = 0, interiors = 0, flats = 0, roots = 0, greater = 0, tangents = 0;
};

/// Membership along the ray, and the numbers of the hit.
template <class Where>
void check_parameter(const std::string& about, const AnyRay& ray, const Hit& hit, const RayParameter& t, Where at,
                     Seen& seen) {
  const Path path(ray);
  const auto [low, high] = around(t);
  if (hit.t == 0 && hit.feature.kind == FeatureKind::interior) {
    EXPECT_EQ(at(path.origin), 1) << about;
    ++seen.interiors;
    return;
  }
  const bool start = path.is_point() || (path.begins && low <= 0 && high >= 0);
  const Rational step = path.is_point() ? Rational(1) : Rational(1, mpz_class(1) << 2300);
  // Outside just before.
  if (!start) {
    EXPECT_EQ(at(path.at(Rational(low - step * (1 + abs(low))))), -1) << about;
  }
  if (low == high) {
    EXPECT_EQ(at(path.at(low)), 0) << about;
    ++seen.flats;
  } else {
    // On it where the root is rational after all; else outside before the root, not outside behind it.
    const int before = at(path.at(low));
    EXPECT_TRUE(before == 0 || (before == -1 && at(path.at(high)) >= 0)) << about;
    ++(t.greater ? seen.greater : seen.roots);
  }
  EXPECT_EQ(hit.t, t.rounded()) << about;
  EXPECT_TRUE(path.has(low) || path.has(high)) << about;
  const double point[] = {hit.point.x, hit.point.y, hit.point.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational p = path.at(low)[i], q = path.at(high)[i];
    const double a = plumb::Rational(BigRational{p}).rounded(), b = plumb::Rational(BigRational{q}).rounded();
    EXPECT_TRUE(point[i] == a || point[i] == b) << about;
  }
}

TEST(FirstHitCone, IsThatOfMembership) {
  Seen seen;
  long vertices = 0, edges = 0, bases = 0, sides = 0;
  on_shapes(731, 2500, [&](Material& m) {
    const auto cone = m.shape<Cone3>();
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(cone) + " " + text_of(ray);
    const auto hit = first_hit(ray, cone);
    const auto t = first_hit_parameter(ray, cone);
    ASSERT_EQ(hit.has_value(), meets(ray, cone)) << about;
    ASSERT_EQ(t.has_value(), hit.has_value()) << about;
    ASSERT_EQ(hits(ray, cone), hit.has_value()) << about;
    if (!hit) {
      ++seen.misses;
      return;
    }
    check_parameter(
        about, ray, *hit, *t, [&](const Coordinates& p) { return where(cone, p); }, seen);
    if (cone.apex == cone.base || t->square.sign() != Sign::zero || hit->feature.kind == FeatureKind::interior) return;
    const Coordinates x = Path(ray).at(t->base.value().value), apex = exact::of(cone.apex),
                      e = exact::difference(exact::of(cone.base), apex), w = exact::difference(x, apex);
    const Rational along = exact::dot(w, e), ee = exact::square(e);
    const bool side = (exact::square(w) - along * along / ee) * ee * ee == exact::squared(cone.radius) * along * along;
    const Feature expected = along == 0            ? Feature{FeatureKind::vertex, 0}
                             : along == ee && side ? Feature{FeatureKind::edge, 0}
                                                   : Feature{FeatureKind::face, along == ee ? 1u : 0u};
    EXPECT_EQ(hit->feature, expected) << about;
    ++(expected.kind == FeatureKind::vertex ? vertices
       : expected.kind == FeatureKind::edge ? edges
       : expected.index == 1                ? bases
                                            : sides);
  });
  std::printf("%ld misses, %ld inside, %ld rational, %ld and %ld roots\n", seen.misses, seen.interiors, seen.flats,
              seen.roots, seen.greater);
  std::printf("%ld apexes, %ld rims, %ld bases, %ld sides\n", vertices, edges, bases, sides);
  for (const long n :
       {seen.misses, seen.interiors, seen.flats, seen.roots, seen.greater, vertices, edges, bases, sides})
    EXPECT_GT(n, 0);
}

TEST(FirstHitLozenge, IsThatOfMembership) {
  Seen seen;
  long planes = 0, edges = 0, corners = 0;
  on_shapes(732, 1500, [&](Material& m) {
    const auto lozenge = m.shape<Lozenge3>();
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(lozenge) + " " + text_of(ray);
    const auto hit = first_hit(ray, lozenge);
    const auto t = first_hit_parameter(ray, lozenge);
    ASSERT_EQ(hit.has_value(), meets(ray, lozenge)) << about;
    ASSERT_EQ(t.has_value(), hit.has_value()) << about;
    ASSERT_EQ(hits(ray, lozenge), hit.has_value()) << about;
    if (!hit) {
      ++seen.misses;
      return;
    }
    check_parameter(
        about, ray, *hit, *t, [&](const Coordinates& p) { return where(lozenge, p); }, seen);
    if (hit->feature.kind == FeatureKind::interior) return;
    ++(hit->feature.index < 2 ? planes : hit->feature.index < 6 ? edges : corners);
  });
  std::printf("%ld misses, %ld inside, %ld rational, %ld roots; %ld of planes, %ld of edges, %ld of corners\n",
              seen.misses, seen.interiors, seen.flats, seen.roots, planes, edges, corners);
  for (const long n : {seen.misses, seen.interiors, seen.flats, seen.roots, planes, edges, corners}) EXPECT_GT(n, 0);
}

TEST(FirstHitEllipsoid, IsThatOfMembership) {
  Seen seen;
  long flat = 0, flat_hits = 0;
  on_shapes(733, 1500, [&](Material& m) {
    const auto ellipsoid = m.shape<Ellipsoid3>();
    const AnyRay ray = ray_of(m);
    const std::string about = m.about(ellipsoid) + " " + text_of(ray);
    const auto hit = first_hit(ray, ellipsoid);
    const auto t = first_hit_parameter(ray, ellipsoid);
    ASSERT_EQ(t.has_value(), hit.has_value()) << about;
    ASSERT_EQ(hits(ray, ellipsoid), hit.has_value()) << about;
    if (const Location start = exact::locate(ellipsoid, ray.origin);
        ray.kind != AnyRay::Kind::line && start != Location::outside) {
      ASSERT_TRUE(hit) << about;
      EXPECT_EQ(hit->t, 0) << about;
      EXPECT_EQ(hit->feature.kind, start == Location::inside ? FeatureKind::interior : FeatureKind::face) << about;
    }
    const Path path(ray);
    if (!where(ellipsoid, path.origin)) {
      ++flat;
      flat_hits += hit.has_value();
      // A point of the line that doubles hold is in it, or it is not.
      const bool finite = hit && std::isfinite(hit->point.x + hit->point.y + hit->point.z);
      if (finite && t->square.sign() == Sign::zero && path.at(t->base.value().value) == exact::of(hit->point)) {
        EXPECT_NE(exact::locate(ellipsoid, hit->point), Location::outside) << about;
      }
      return;
    }
    if (!hit) {
      ++seen.misses;
      // The least value along the line: at the foot of the image of the line under the inverse matrix.
      std::vector<Coordinates> columns;
      const double half[] = {ellipsoid.half.x, ellipsoid.half.y, ellipsoid.half.z};
      for (std::size_t i = 0; i < 3; ++i)
        columns.push_back(
            exact::combination(exact::of(Vector3{0, 0, 0}), Rational(half[i]), exact::of(ellipsoid.axes[i])));
      const Coordinates w =
          *exact::solve_columns(columns, exact::difference(path.origin, exact::of(ellipsoid.center))).unknowns;
      const Coordinates d = *exact::solve_columns(columns, path.direction).unknowns;
      std::optional<Rational> from, to;
      if (path.begins) from = 0;
      if (path.ends) to = 1;
      EXPECT_GT(exact::foot(w, d, exact::of(Point3{0, 0, 0}), from, to).squared_distance, 1) << about;
      return;
    }
    check_parameter(
        about, ray, *hit, *t, [&](const Coordinates& p) { return *where(ellipsoid, p); }, seen);
  });
  std::printf("%ld misses, %ld inside, %ld rational, %ld roots; %ld flat, %ld of them hit\n", seen.misses,
              seen.interiors, seen.flats, seen.roots, flat, flat_hits);
  for (const long n : {seen.misses, seen.interiors, seen.roots, flat_hits}) EXPECT_GT(n, 0);
}

/// Of parallel edges.
TEST(FirstHitLozenge, WithoutAreaIsACapsuleOrABall) {
  long hits = 0;
  on_shapes(734, 500, [&](Material& m) {
    const auto capsule = m.shape<Capsule3>();
    const AnyRay ray = ray_of(m);
    const Vector3 along = toward(capsule.a, capsule.b);
    const Lozenge3 lozenge{capsule.a, {{along, {0, 0, 0}}}, capsule.radius};
    if (exact::difference(exact::of(capsule.b), exact::of(capsule.a)) != exact::of(along)) return;
    const std::string about = m.about(capsule) + " " + text_of(ray);
    const auto a = first_hit(ray, lozenge), b = first_hit(ray, capsule);
    ASSERT_EQ(a.has_value(), b.has_value()) << about;
    if (!a) return;
    ++hits;
    EXPECT_EQ(*a, *b) << about;
    EXPECT_TRUE(*first_hit_parameter(ray, lozenge) == *first_hit_parameter(ray, capsule)) << about;
  });
  EXPECT_GT(hits, 20);
}

TEST(FirstHitRoundSolids, ByHand) {
  const Cone3 cone{{0, 0, 4}, {0, 0, 0}, 2};
  EXPECT_EQ(*first_hit(Ray3{{0, 0, 9}, {0, 0, -1}}, cone), (Hit{5, {0, 0, 4}, {FeatureKind::vertex, 0}, {0, 0, 0}}));
  EXPECT_EQ(*first_hit(Ray3{{1, 0, -3}, {0, 0, 1}}, cone), (Hit{3, {1, 0, 0}, {FeatureKind::face, 1}, {0, 0, -4}}));
  EXPECT_EQ(*first_hit(Ray3{{9, 0, 2}, {-1, 0, 0}}, cone), (Hit{8, {1, 0, 2}, {FeatureKind::face, 0}, {1, 0, 0.5}}));
  EXPECT_EQ(first_hit(Ray3{{1, 0, 9}, {0, 0, -1}}, cone)->t, 7);  // steeper than the side
  EXPECT_EQ(first_hit(Ray3{{5, 0, 0}, {-1, 0, 0}}, cone)->feature, (Feature{FeatureKind::edge, 0}));
  EXPECT_FALSE(first_hit(Ray3{{1, 0, 9}, {0, 0, 1}}, cone));  // the other half of the double cone
  EXPECT_FALSE(first_hit(Segment3{{-9, 0, 6}, {9, 0, 6}}, cone));
  EXPECT_EQ(first_hit(Line3{{1, 0, 2}, {-1, 0, 2}}, cone)->point, (Point3{2, 0, 0}));  // along a ruling
  const RayParameter later = *first_hit_parameter(Ray3{{1, 1, 9}, {0, 0, -1}}, cone);  // 5 + sqrt(8)
  EXPECT_TRUE(later.greater);
  EXPECT_TRUE(later > *first_hit_parameter(Ray3{{1, 1, 9}, {0, 0, -0x1.0000000000001p+0}}, cone));

  const Lozenge3 slab{{0, 0, 0}, {{{4, 0, 0}, {0, 2, 0}}}, 1};
  EXPECT_EQ(*first_hit(Ray3{{1, 1, 4}, {0, 0, -1}}, slab), (Hit{3, {1, 1, 1}, {FeatureKind::face, 0}, {0, 0, 8}}));
  EXPECT_EQ(*first_hit(Ray3{{1, 1, -4}, {0, 0, 1}}, slab), (Hit{3, {1, 1, -1}, {FeatureKind::face, 1}, {0, 0, -8}}));
  EXPECT_EQ(*first_hit(Ray3{{9, 1, 0}, {-1, 0, 0}}, slab), (Hit{4, {5, 1, 0}, {FeatureKind::face, 5}, {1, 0, 0}}));
  EXPECT_EQ(*first_hit(Ray3{{1, -9, 0}, {0, 1, 0}}, slab), (Hit{8, {1, -1, 0}, {FeatureKind::face, 2}, {0, -1, 0}}));
  EXPECT_EQ(first_hit(Ray3{{-1, -1, 0}, {1, 1, 0}}, slab)->feature, (Feature{FeatureKind::face, 6}));
  EXPECT_EQ(first_hit(Ray3{{1, 1, 0.5}, {1, 0, 0}}, slab)->feature.kind, FeatureKind::interior);

  const Ellipsoid3 egg{{1, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {2, 1, 4}};
  EXPECT_EQ(*first_hit(Ray3{{-9, 0, 0}, {2, 0, 0}}, egg), (Hit{4, {-1, 0, 0}, {FeatureKind::face, 0}, {-0.5, 0, 0}}));
  EXPECT_EQ(first_hit(Ray3{{1, 1, -9}, {0, 0, 1}}, egg)->t, 9);  // only touches
  const Ellipsoid3 disk{{0, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {1, 1, 0}};
  EXPECT_EQ(*first_hit(Ray3{{0, 1, 3}, {0, 0, -1}}, disk), (Hit{3, {0, 1, 0}, {FeatureKind::face, 0}, {0, 0, 1}}));
  EXPECT_FALSE(first_hit(Ray3{{1, 1, 3}, {0, 0, -1}}, disk));
  EXPECT_EQ(first_hit(Ray3{{-3, 0, 0}, {1, 0, 0}}, disk)->t, 2);
  const Ellipsoid3 needle{{0, 0, 0}, {{{1, 0, 0}, {1, 0, 0}, {0, 0, 0}}}, {3, 4, 1}};  // 5 to both sides
  EXPECT_EQ(first_hit(Ray3{{-9, 0, 0}, {1, 0, 0}}, needle)->t, 4);
  EXPECT_EQ(first_hit(Ray3{{5, 7, 0}, {0, -1, 0}}, needle)->t, 7);
  EXPECT_FALSE(first_hit(Ray3{{0x1.4000000000001p+2, 7, 0}, {0, -1, 0}}, needle));
}

TEST(FirstHitRoundSolids, BadInputIsNamed) {
  const Ray3 ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(text_of<InvalidShape>([&] {
              (void)first_hit(ray, Cone3{{0, 0, 0}, {1, 0, 0}, -1});
            }).find("first_hit: cone.radius is negative"),
            0u);
  EXPECT_THROW((void)first_hit(ray, Cone3{{0, 0, 0}, {1, 0, 0}, -1}), InvalidShape);
  EXPECT_THROW((void)first_hit(ray, Lozenge3{{0, 0, 0}, {}, -1}), InvalidShape);
  EXPECT_THROW((void)first_hit(ray, Lozenge3{{0, NAN, 0}, {}, 1}), NonFinite);
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit(ray, Ellipsoid3{{0, 0, 0}, {{{0, 0, 0}, {0, INFINITY, 0}, {0, 0, 0}}}, {1, 1, 1}});
            }).find("first_hit: ellipsoid.axes[1].y is "),
            0u);
  EXPECT_THROW((void)first_hit(Ray3{{NAN, 0, 0}, {1, 0, 0}}, Ellipsoid3{}), NonFinite);
}

}  // namespace
}  // namespace plumb
