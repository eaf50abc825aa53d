// Exactly rigid poses, in every pair of the tables: a common one changes no relation, distance, hit or time, whatever
// its numbers; where a matrix of doubles is the same move it tells the same, to the last bit; a chain is its composition.
#include <gtest/gtest.h>

#include "figure/basic/thrown.hpp"
#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/body/hit_pairs.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/ray/posed.hpp"
#include "plumb/query/separation/posed.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"

namespace plumb::pair_cases {
namespace {

using query::PosedView;

struct RigidSeen {
  int cases = 0, measured = 0, apart = 0, shot = 0, hit = 0, moved = 0, met = 0;
  Answers answers;
};

std::optional<double> measured(const PosedView& a, const PosedView& b) {
  try {
    return query::posed_distance(a, b, query::Question::distance);
  } catch (const InvalidShape&) {
    return {};
  }
}

bool same(const std::optional<RayParameter>& a, const std::optional<RayParameter>& b) {
  return a.has_value() == b.has_value() && (!a || (*a <=> *b) == 0);
}

/// One figure moves by a vector of which the image is known without rounding.
struct Way {
  Vector3 before, after;
  Vector2 flat_before, flat_after;
};
query::PosedMotion in_motion(const PosedView& v, const Vector3& by, const Vector2& flat) {
  return {v, v.figure.dimension == 3 ? by : Vector3{flat.x, flat.y, 0}};
}
std::optional<Way> way_under(const RigidCase& by, Material& m) {
  const auto* space = std::get_if<RigidPose>(&by.space);
  if (space == nullptr) return {};
  const auto turn = exact_matrix(space->turn);
  const auto flat = exact_matrix(std::get<RigidPose2>(by.plane).turn);
  if (!turn || !flat) return {};
  const double size = std::ldexp(m.below(2) == 0 ? 1.0 : -1.0, static_cast<int>(m.below(5)) - 1);
  const auto axis = m.below(3);
  const double whole = size * turn->weight;
  Way w{};
  (axis == 0 ? w.before.x : axis == 1 ? w.before.y : w.before.z) = whole;
  const Vector3& c = turn->columns[axis];
  w.after = {c.x * size, c.y * size, c.z * size};
  (axis == 0 ? w.flat_before.x : w.flat_before.y) = size * flat->weight;
  const Vector2& f = flat->columns[axis == 0 ? 0 : 1];
  w.flat_after = {f.x * size, f.y * size};
  return w;
}

/// The same move by a quaternion and by a matrix.
struct SameMove {
  RigidPose rigid;
  Pose matrix;
  RigidPose2 rigid2;
  Pose2 matrix2;
  [[nodiscard]] PosedView by_turn(const query::FigureView& v) const {
    return {v, v.dimension == 3 ? AnyPoseView(&rigid) : AnyPoseView(&rigid2)};
  }
  [[nodiscard]] PosedView by_matrix(const query::FigureView& v) const {
    return {v, v.dimension == 3 ? AnyPoseView(&matrix) : AnyPoseView(&matrix2)};
  }
};
/// One of the 24 turns of a cube, and of the four of a square.
SameMove same_move(Material& m) {
  for (;;) {
    const auto part = [&] { return static_cast<double>(m.below(3)) - 1; };
    const Rotation q{part(), part(), part(), part()};
    const auto t = exact_matrix(q);
    const Rotation2 f{q.w, q.z};
    const auto u = exact_matrix(f);
    if (!t || !u || t->weight == 3) continue;
    const auto over = [](const Vector3& v, double s) { return Vector3{v.x / s, v.y / s, v.z / s}; };
    const double step = static_cast<double>(m.below(9)) - 4;
    const auto& [s, columns] = std::pair(t->weight, t->columns);
    const Vector3 by{step, 0.1 * step, 7};
    return {{q, by},
            {{{over(columns[0], s), over(columns[1], s), over(columns[2], s)}}, by},
            {f, {by.x, by.y}},
            {{{{u->columns[0].x / u->weight, u->columns[0].y / u->weight},
               {u->columns[1].x / u->weight, u->columns[1].y / u->weight}}},
             {by.x, by.y}}};
  }
}

/// The answers, or what is thrown.
template <class Ask>
auto told(const Ask& ask) -> std::pair<std::optional<decltype(ask())>, std::string> {
  try {
    return {ask(), ""};
  } catch (const Error& e) {
    return {std::nullopt, e.what()};
  }
}

void expect_rigid_laws(const PairRow& pair, RigidSeen& seen, std::uint64_t start) {
  const auto answers = [&](const query::QuestionTable& table) {
    return table.answers(pair.a->kind, pair.b->kind, pair.dimension());
  };
  shape_cases::on_shapes(start, battery::sanitized ? 1 : 3, [&](Material& m) {
    const AnyPair drawn = pair_of(pair, m);
    const AnyFigure &a = drawn.a, &b = drawn.b;
    const RigidCase by = rigid_case(m);
    const std::string name = pair.name() + about(m, a, b);
    const PosedView p = by.posed(a.view()), q = by.posed(b.view()), still_a{a.view()}, still_b{b.view()};
    ++seen.cases;
    const SameMove move = same_move(m);
    const PosedView turned = move.by_turn(a.view()), mapped = move.by_matrix(a.view());
    if (pair.is_posed) {
      const Relation r = relate(pair, a, b);
      seen.answers.add(r);
      EXPECT_EQ(query::relate_posed("relate", p, q), r) << name;
      EXPECT_EQ(query::relate_posed("relate", q, p), r) << name;
      EXPECT_EQ(told([&] { return query::relate_posed("relate", turned, still_b); }),
                told([&] { return query::relate_posed("relate", mapped, still_b); }))
          << name;
    }
    if (pair.forth.distance != nullptr) {
      const std::optional<double> plain = measured(still_a, still_b);
      ++seen.measured, seen.apart += plain && *plain > 0 ? 1 : 0;
      EXPECT_EQ(measured(p, q), plain) << name;
      EXPECT_EQ(told([&] { return query::posed_closest_points(turned, still_b); }),
                told([&] { return query::posed_closest_points(mapped, still_b); }))
          << name;
      if (plain && pair.forth.closest_points != nullptr) {
        EXPECT_EQ(query::posed_closest_points(p, q).distance, *plain) << name;
      }
    }
    if (answers(query::hit_pairs)) {
      const auto t = query::posed_first_hit_parameter("first_hit_parameter", still_a, still_b);
      ++seen.shot, seen.hit += t ? 1 : 0;
      EXPECT_TRUE(same(query::posed_first_hit_parameter("first_hit_parameter", p, q), t)) << name;
      const auto hit = query::posed_first_hit(still_a, still_b), of_images = query::posed_first_hit(p, q);
      EXPECT_EQ(of_images.has_value(), hit.has_value()) << name;
      if (hit && of_images) {
        EXPECT_EQ(of_images->t, hit->t) << name;
        EXPECT_EQ(of_images->feature, hit->feature) << name;
      }
      EXPECT_EQ(query::posed_first_hit(turned, still_b), query::posed_first_hit(mapped, still_b)) << name;
    }
    if (answers(query::translating_pairs)) {
      if (const auto way = way_under(by, m)) {
        constexpr Vector3 none{};
        constexpr Vector2 none2{};
        const auto before = told([&] {
          return query::posed_contact(in_motion(still_a, way->before, way->flat_before),
                                      in_motion(still_b, none, none2));
        });
        const auto after = told(
            [&] { return query::posed_contact(in_motion(p, way->after, way->flat_after), in_motion(q, none, none2)); });
        ++seen.moved, seen.met += before.first && *before.first ? 1 : 0;
        EXPECT_EQ(after, before) << name;
        EXPECT_EQ(told([&] {
                    return query::posed_contact(in_motion(turned, way->before, way->flat_before),
                                                in_motion(still_b, none, none2));
                  }),
                  told([&] {
                    return query::posed_contact(in_motion(mapped, way->before, way->flat_before),
                                                in_motion(still_b, none, none2));
                  }))
            << name;
      }
    }
  });
}

template <class All>
void expect_rigid_laws_of_all(std::uint64_t start) {
  RigidSeen seen;
  for (const PairRow& pair : pairs_of(All{})) expect_rigid_laws(pair, seen, start++);
  std::printf(
      "%d cases; disjoint %d, touching %d, overlapping %d; %d measured, %d apart; %d rays, %d hit; %d in motion, %d "
      "met\n",
      seen.cases, seen.answers.of(Relation::disjoint), seen.answers.of(Relation::touching),
      seen.answers.of(Relation::overlapping), seen.measured, seen.apart, seen.shot, seen.hit, seen.moved, seen.met);
  EXPECT_GT(seen.answers.of(Relation::touching) * 20, seen.cases);
  EXPECT_GT(seen.apart * 5, seen.measured);
  EXPECT_GT(seen.hit * 5, seen.shot);
  EXPECT_GT(seen.met * 6, seen.moved);
}

TEST(RigidPoses, LawsHoldForAllPairsOfThePlane) { expect_rigid_laws_of_all<Plane>(6101); }
TEST(RigidPoses, LawsHoldForAllPairsOfSpace) { expect_rigid_laws_of_all<Space>(6401); }

TEST(RigidPoses, BallsStayBalls) {
  const RigidPose turned{{0x1.8p-1, 0x1.4p-2, -0x1p-3, 0x1.2p-3}, {10, 0, 0}};
  const Capsule3 capsule{{0, 0, 0}, {0, 0, 2}, 0.5};
  const Sphere3 ball{{0, 0, 0}, 1};
  EXPECT_EQ(distance(Posed{ball, turned}, ball), 8);
  EXPECT_EQ(distance(Posed{capsule, turned}, Posed{ball, turned}), 0);
  EXPECT_EQ(relate(Posed{Sphere3{{0, 0, 0}, 9}, turned}, ball), Relation::touching);
  EXPECT_EQ(relate(Posed{ball, turned}, Posed{Cylinder3{{0, 0, 1}, {0, 0, 3}, 1}, turned}), Relation::touching);
  EXPECT_TRUE(contains(Posed{Sphere3{{0, 0, 0}, 1}, turned}, Point3{10, 0, 1}));
  EXPECT_TRUE(contains(Posed{capsule, turned}, Posed{Sphere3{{0, 0, 1}, 0.5}, turned}));
  EXPECT_EQ(first_hit(Ray3{{0, 0, 0}, {3, 0, 0}}, Posed{ball, turned})->t, 3);
  EXPECT_EQ(first_contact(Translating{Posed{ball, turned}, {-16, 0, 0}}, ball)->time, 0.5);
  const RigidPose2 flat{{3, 1}, {4, 0}};
  EXPECT_EQ(distance(Posed{Circle2{{0, 0}, 1}, flat}, Circle2{{0, 0}, 1}), 2);
  EXPECT_EQ(first_contact(Translating{Posed{Circle2{{0, 0}, 1}, flat}, Vector2{-4, 0}}, Circle2{{0, 0}, 1})->time, 0.5);
}

TEST(RigidPoses, AChainIsItsComposition) {
  int cases = 0;
  shape_cases::on_shapes(6801, battery::sanitized ? 20 : 100, [&](Material& m) {
    const auto part = [&] { return static_cast<double>(m.below(7)) - 3; };
    const Rotation q{part(), part(), part(), part()};
    if (q == Rotation{0, 0, 0, 0}) return;
    const SameMove outer = same_move(m);
    const RigidPose inner{q, {part(), part(), part()}};
    const auto& [w, x, y, z] = outer.rigid.turn;
    // The matrix holds whole numbers: the translation is a sum of three of them and a tenth.
    const auto& c = outer.matrix.columns;
    const Vector3 t = inner.translation, by = outer.rigid.translation;
    const RigidPose whole{{w * q.w - x * q.x - y * q.y - z * q.z, w * q.x + x * q.w + y * q.z - z * q.y,
                           w * q.y - x * q.z + y * q.w + z * q.x, w * q.z + x * q.y - y * q.x + z * q.w},
                          {c[0].x * t.x + c[1].x * t.y + c[2].x * t.z, c[0].y * t.x + c[1].y * t.y + c[2].y * t.z,
                           c[0].z * t.x + c[1].z * t.y + c[2].z * t.z}};
    const RigidChain chain{{{outer.rigid.turn, {0, 0, 0}}, inner}}, long_chain{{{{1, 0, 0, 0}, by}, whole}},
        all{{{{1, 0, 0, 0}, by}, {outer.rigid.turn, {0, 0, 0}}, inner}};
    ++cases;
    const Capsule3 capsule = figure<Capsule3>(m);
    const Obb3 box = near_figure<Obb3>(m);
    EXPECT_EQ(closest_points(Posed{capsule, chain}, box), closest_points(Posed{capsule, whole}, box))
        << m.about(capsule, box);
    EXPECT_EQ(closest_points(Posed{capsule, long_chain}, box), closest_points(Posed{capsule, all}, box))
        << m.about(capsule, box);
    EXPECT_EQ(relate(Posed{box, chain}, capsule), relate(Posed{box, whole}, capsule)) << m.about(capsule, box);
  });
  EXPECT_GT(cases, 15);
  const Capsule3 capsule{{0, 0, 0}, {1, 0, 0}, 1};
  EXPECT_EQ(closest_points(Posed{capsule, RigidChain{}}, Point3{5, 0, 0}), closest_points(capsule, Point3{5, 0, 0}));
  RigidChain far;  // of more links than running errors follow: 96 eighths of a turn
  for (int i = 0; i < 96; ++i) far.links.push_back({{1, 0, 0, 1}, {1, 0, 0}});
  EXPECT_EQ(relate(Posed{Aabb3{{0, 0, 0}, {1, 1, 1}}, far}, Aabb3{{1, 1, 1}, {2, 2, 2}}), Relation::touching);
}

TEST(RigidPoses, WhatIsNoTurnIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere3 ball{{0, 0, 0}, 1};
  const auto said = [&](const auto& pose) { return text_of<Error>([&] { relate(Posed{ball, pose}, Point3{}); }); };
  EXPECT_EQ(said(RigidPose{{0, 0, 0, 0}, {0, 0, 0}}),
            "relate: sphere.pose.turn is zero, which is no turn; give Rotation{1, 0, 0, 0} for none");
  EXPECT_EQ(said(RigidPose{{1, 0, nan, 0}, {0, 0, 0}}).substr(0, 30), "relate: sphere.pose.turn.y is ");
  EXPECT_EQ(said(RigidChain{{{}, {{1, 0, 0, 0}, {0, nan, 0}}}}).substr(0, 45),
            "relate: sphere.pose.links[1].translation.y is");
}

}  // namespace
}  // namespace plumb::pair_cases
