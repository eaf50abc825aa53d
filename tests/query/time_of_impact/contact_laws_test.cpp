// The laws of first_contact, first_contact_time and intersects of figures that move along lines, for every pair of the
// table (query/body/contact_pairs.hpp) and every degenerate form of every kind.
//
// Laws: what is not disjoint at the start meets at time 0, and starts inside exactly where it overlaps; what is not
// disjoint at a time has met by then; at the first time figures are not disjoint, and before it they are; neither
// swapping them nor a common pose changes the time.
#include <gtest/gtest.h>

#include <cmath>

#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "query/body/boundary.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"

namespace plumb::pair_cases {
namespace {

/// What is told of two figures in motion.
struct Told {
  std::optional<Root> time;
  std::optional<Contact> contact;
  bool meet = false;
};

template <class Shape>
Translating<Shape> moving(const void* s, const Vector3& by) {
  if constexpr (figure_dimension<Shape> == 2) {
    return {*static_cast<const Shape*>(s), {by.x, by.y}};
  } else {
    return {*static_cast<const Shape*>(s), by};
  }
}
using Asked = Told (*)(const void* a, const Vector3& by_a, const void* b, const Vector3& by_b);
template <class A, class B>
Told told(const void* a, const Vector3& by_a, const void* b, const Vector3& by_b) {
  const auto p = moving<A>(a, by_a);
  const auto q = moving<B>(b, by_b);
  return {first_contact_time(p, q), first_contact(p, q), intersects(p, q)};
}

/// By the compiler's word, which tests/query/body/pair_table_test.cpp holds against the table.
struct MovingRow {
  FigureKind a, b;
  Asked ask;
};
template <class A, class B>
consteval MovingRow row() {
  if constexpr (Collidable<Translating<A>, Translating<B>>) {
    return {figure_kind<A>, figure_kind<B>, &told<A, B>};
  } else {
    return {figure_kind<A>, figure_kind<B>, nullptr};
  }
}
template <class A, class... Bs>
constexpr std::array<MovingRow, sizeof...(Bs)> rows_of_first{row<A, Bs>()...};
template <class... Shapes>
Asked asked(Types<Shapes...>, FigureKind a, FigureKind b) {
  for (const std::span<const MovingRow> first : {std::span<const MovingRow>(rows_of_first<Shapes, Shapes...>)...}) {
    for (const MovingRow& r : first) {
      if (r.a == a && r.b == b) return r.ask;
    }
  }
  return nullptr;
}

struct Motion {
  AnyFigure a, b;
  Vector3 by_a, by_b;

  /// Where part * by is a vector of doubles, of both.
  [[nodiscard]] bool is_exact_at(double time) const {
    const auto is_exact = [time](double x) {
      return std::isfinite(time * x) && mpq_class(time * x) == mpq_class(time) * mpq_class(x);
    };
    return is_exact(by_a.x) && is_exact(by_a.y) && is_exact(by_a.z) && is_exact(by_b.x) && is_exact(by_b.y) &&
           is_exact(by_b.z);
  }
  /// Of the figures moved by time * by.
  [[nodiscard]] Relation at(double time) const {
    const Vector3 p{time * by_a.x, time * by_a.y, time * by_a.z}, q{time * by_b.x, time * by_b.y, time * by_b.z};
    if (a.row().dimension == 2) {
      const Pose2 of_a{{{{1, 0}, {0, 1}}}, {p.x, p.y}}, of_b{{{{1, 0}, {0, 1}}}, {q.x, q.y}};
      return query::relate_posed("test", {a.view(), &of_a}, {b.view(), &of_b});
    }
    constexpr std::array<Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Pose of_a{axes, p}, of_b{axes, q};
    return query::relate_posed("test", {a.view(), &of_a}, {b.view(), &of_b});
  }
  /// Of both under one pose, which turns them by a quarter and makes them twice as large.
  [[nodiscard]] Told posed() const {
    const auto turned = [](const Vector3& v) { return Vector3{-2 * v.y, 2 * v.x, 2 * v.z}; };
    const Vector3 p = turned(by_a), q = turned(by_b);
    const auto tell = [](const query::PosedMotion& x, const query::PosedMotion& y) {
      return Told{query::posed_contact_time(x, y), query::posed_contact(x, y), query::posed_bodies_meet(x, y)};
    };
    if (a.row().dimension == 2) {
      const Pose2 pose{{{{0, 2}, {-2, 0}}}, {3, 0}};
      return tell({{a.view(), &pose}, p}, {{b.view(), &pose}, q});
    }
    const Pose pose{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {3, 0, -1}};
    return tell({{a.view(), &pose}, p}, {{b.view(), &pose}, q});
  }
};

/// From one thing that was drawn towards another and beyond, or not at all; often four times a number, so that a quarter
/// of it is exact.
Vector3 motion(Material& m, int dimension) {
  if (m.below(4) == 0) return {0, 0, 0};
  const auto probe = [&] {
    if (dimension == 3) return m.probe3();
    const Point2 p = m.probe2();
    return Point3{p.x, p.y, 0};
  };
  const Point3 p = probe(), q = probe();
  const double far = m.below(3) == 0 ? 1 : 4;
  const Vector3 by{far * (p.x - q.x), far * (p.y - q.y), far * (p.z - q.z)};
  const auto fits = [](double x) { return std::isfinite(2 * x); };  // under a pose that makes it twice as large
  return fits(by.x) && fits(by.y) && fits(by.z) ? by : Vector3{0, 0, 0};
}

/// A pair of the table in the order in which it is asked: a polygon second, for of what meets at once under poses the
/// features of the other count first.
struct MovingPairRow {
  const FigureRow *a, *b;
  Relation (*relate)(const void*, const void*);
};
MovingPairRow in_order(const PairRow& pair) {
  const bool turned =
      query::is_one_of(pair.a->kind, query::polygon_kinds) && !query::is_one_of(pair.b->kind, query::polygon_kinds);
  return turned ? MovingPairRow{pair.b, pair.a, pair.back.relate} : MovingPairRow{pair.a, pair.b, pair.forth.relate};
}
Motion drawn(const MovingPairRow& pair, Material& m) {
  const auto one = [&m](const FigureRow& row, bool plain) { return plain ? near_figure(row, m) : degenerate(row, m); };
  const std::size_t form = m.below(4);
  AnyFigure a = one(*pair.a, form == 0), b = one(*pair.b, form == 1);
  const Vector3 by_a = motion(m, pair.a->dimension), by_b = motion(m, pair.b->dimension);
  return {std::move(a), std::move(b), by_a, by_b};
}

struct Seen {
  int cases = 0, never = 0, at_start = 0, inside = 0, later = 0, exact_later = 0;
};

void expect_alike(const Told& told, const Told& other, const std::string& about) {
  EXPECT_EQ(told.meet, other.meet) << about;
  EXPECT_EQ(told.time.has_value(), other.time.has_value()) << about;
  if (told.time && other.time) {
    EXPECT_TRUE(*told.time == *other.time) << about;
  }
  EXPECT_EQ(told.contact.has_value(), other.contact.has_value()) << about;
  if (told.contact && other.contact) {
    EXPECT_EQ(told.contact->time, other.contact->time) << about;
  }
}

constexpr Feature inside{FeatureKind::interior, 0};

void expect_laws(const Motion& motion, Relation start, const Told& told, const std::string& about, Seen& seen) {
  const auto& [time, contact, meet] = told;
  ASSERT_TRUE(meet == time.has_value() && meet == contact.has_value()) << about;
  EXPECT_EQ(start != Relation::disjoint, time && *time == Rational(0)) << about;
  EXPECT_EQ(start == Relation::overlapping, contact && contact->feature_a == inside && contact->feature_b == inside)
      << about;
  for (const double t : {0.25, 0.5, 0.75, 1.0}) {
    if (!motion.is_exact_at(t) || motion.at(t) == Relation::disjoint) continue;
    EXPECT_TRUE(time && *time <= Rational(t)) << about << " at " << t;
  }
  ++seen.cases;
  if (!time) {
    ++seen.never;
    return;
  }
  EXPECT_TRUE(*time >= Rational(0) && *time <= Rational(1)) << about;
  EXPECT_EQ(contact->time, time->rounded(Rounding::down) + 0.0) << about;
  ++(start == Relation::disjoint ? seen.later : seen.at_start);
  seen.inside += start == Relation::overlapping;
  const double t = contact->time;
  if (start != Relation::disjoint || !(*time == Rational(t)) || !motion.is_exact_at(t)) return;
  ++seen.exact_later;
  EXPECT_NE(motion.at(t), Relation::disjoint) << about;
  if (motion.is_exact_at(t / 2)) {
    EXPECT_EQ(motion.at(t / 2), Relation::disjoint) << about;
  }
}

/// Cases of each pair, of which the long run takes fifty times as many.
const std::uint64_t cases_of_motion = battery::sanitized ? 2 : 12;

template <class All>
void expect_laws_of_all(All all, std::uint64_t start) {
  Seen seen;
  for (const PairRow& of_table : pairs_of(all)) {
    if (!query::translating_pairs.answers(of_table.a->kind, of_table.b->kind, of_table.dimension())) continue;
    const MovingPairRow pair = in_order(of_table);
    const Asked forth = asked(all, pair.a->kind, pair.b->kind), back = asked(all, pair.b->kind, pair.a->kind);
    ASSERT_TRUE(forth != nullptr && back != nullptr) << of_table.name();
    shape_cases::on_shapes(start++, cases_of_motion, [&](Material& m) {
      const Motion motion = drawn(pair, m);
      const auto& [a, b, by_a, by_b] = motion;
      const std::string about = of_table.name() + ", " + pair_cases::about(m, a, b);
      const Told told = forth(a.shape(), by_a, b.shape(), by_b);
      expect_laws(motion, pair.relate(a.shape(), b.shape()), told, about, seen);
      expect_alike(told, back(b.shape(), by_b, a.shape(), by_a), "swapped: " + about);
      const Told posed = motion.posed();
      expect_alike(told, posed, "posed: " + about);
      if (told.contact && posed.contact) {
        EXPECT_EQ(*told.contact, *posed.contact) << "posed: " << about;
      }
    });
  }
  std::printf("%d cases: %d never meet, %d from the start, %d of them inside, %d later, %d of these at a double\n",
              seen.cases, seen.never, seen.at_start, seen.inside, seen.later, seen.exact_later);
  EXPECT_GT(seen.never * 8, seen.cases);
  EXPECT_GT(seen.at_start * 8, seen.cases);
  EXPECT_GT(seen.later * 20, seen.cases);
  EXPECT_GT(seen.exact_later * 8, seen.later);
  EXPECT_GT(seen.at_start, seen.inside);
}

TEST(ContactLaws, HoldForAllPairsOfThePlane) { expect_laws_of_all(Plane{}, 9100); }
TEST(ContactLaws, HoldForAllPairsOfSpace) { expect_laws_of_all(Space{}, 10300); }

// An edge that bounds no inside is of the figure all the same.
TEST(ContactLaws, SpikesPierce) {
  const Feature face{FeatureKind::face, 0};
  const auto edge = [](std::uint32_t i) { return Feature{FeatureKind::edge, i}; };
  const Polygon3 needle{{{0, 0, -2}, {1, 0, -1}, {0, 0, -1}, {0, 0, 1}, {0, 0, -1}}};
  const Plane3 floor{{0, 0, 1}, 0};
  EXPECT_EQ(first_contact(Translating{needle, {0, 0, 0}}, floor), (Contact{0, edge(2), face}));
  EXPECT_TRUE(first_contact_time(needle, Translating{floor, {0, 0, 3}}) == Root(0));
  const Polygon3 spiked{{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  const Triangle3 sail{{6, -1, -1}, {6, 1, -1}, {6, 0, 2}};
  EXPECT_EQ(first_contact(Translating{spiked, {1, 0, 0}}, sail), (Contact{0, edge(1), face}));
  EXPECT_EQ(first_contact(Translating{sail, {1, 0, 0}}, spiked), (Contact{0, face, edge(1)}));
  // What is all inside a box reaches none of its faces.
  const HoledPolygon3 shut{{{{9, 9, 9}, {12, 9, 9}, {9, 12, 9}}}, {{{{1, 1, 9}, {2, 2, 9}, {1, 1, 9}}}}};
  EXPECT_EQ(first_contact(Translating{shut, {0, 0, 1}}, Aabb3{{0, 0, 8}, {3, 3, 10}}),
            (Contact{0, {FeatureKind::vertex, 3}, inside}));
}

}  // namespace
}  // namespace plumb::pair_cases
