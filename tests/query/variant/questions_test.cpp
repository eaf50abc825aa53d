// Figures whose kinds are known at run time: is each question answered as of the kinds themselves, in every pair of its
// table, on degenerate forms, and refused where the table has no pair?
#include "plumb/query/variant/questions.hpp"

#include <gtest/gtest.h>

#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/body/degenerate_forms.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"
#include "query/variant/all_kinds.hpp"
#include "query/variant/outcome.hpp"

namespace plumb::pair_cases {
namespace {

using Some = plumb::AnyFigure;

struct Asked {
  int cases = 0, refused = 0;
  void expect(const std::string& kinds, const std::string& any, const std::string& about) {
    ++cases;
    refused += kinds.find(": ") != std::string::npos;
    EXPECT_EQ(any, kinds) << about;
  }
};

void expect_as_kinds(const PairQuestions& q, const AnyFigure& a, const AnyFigure& b, Asked& asked,
                     const std::string& about) {
  const Some x = some(a), y = some(b);
  asked.expect(outcome([&] { return q.relate(a.shape(), b.shape()); }), outcome([&] { return relate(x, y); }), about);
  asked.expect(outcome([&] { return q.intersects(a.shape(), b.shape()); }), outcome([&] { return intersects(x, y); }),
               about);
  const bool is_measured = q.distance != nullptr;
  const auto unsupported = [&](const std::string& any) {
    EXPECT_TRUE(any.starts_with("Unsupported: ")) << any << about;
  };
  const std::string any_distance = outcome([&] { return distance(x, y); });
  const std::string any_closest = outcome([&] { return closest_points(x, y); });
  const std::string any_exact = outcome([&] { return exact_distance(x, y); });
  if (!is_measured) return unsupported(any_distance), unsupported(any_closest), unsupported(any_exact);
  asked.expect(outcome([&] { return q.distance(a.shape(), b.shape()); }), any_distance, about);
  asked.expect(outcome([&] { return q.any_closest_points(a.shape(), b.shape()); }), any_closest, about);
  asked.expect(outcome([&] { return q.exact_distance(a.shape(), b.shape()); }), any_exact, about);
}

template <class All>
void expect_all_pairs(std::uint64_t start) {
  Asked asked;
  for (const PairRow& pair : pairs_of(All{})) {
    shape_cases::on_shapes(start++, 4, [&](Material& m) {
      const AnyFigure a = m.below(3) == 0 ? figure(*pair.a, m) : degenerate(*pair.a, m);
      AnyFigure b = m.below(3) == 0 ? near_figure(*pair.b, m) : degenerate(*pair.b, m);
      if (m.below(8) == 0) b = spoiled(m, b);
      const std::string about = pair.name() + pair_cases::about(m, a, b);
      expect_as_kinds(pair.forth, a, b, asked, about);
      expect_as_kinds(pair.back, b, a, asked, "back: " + about);
    });
  }
  std::printf("%d answers, %d of them errors\n", asked.cases, asked.refused);
  EXPECT_GT(asked.refused * 50, asked.cases);
  EXPECT_LT(asked.refused * 2, asked.cases);
}
TEST(AnyFigure, AnswersAsTheKindsOfThePlane) { expect_all_pairs<Plane>(100); }
TEST(AnyFigure, AnswersAsTheKindsOfSpace) { expect_all_pairs<Space>(1000); }

template <class Call>
bool is_unsupported(Call call) {
  try {
    call();
  } catch (const Unsupported&) {
    return true;
  } catch (const Error&) {
  }
  return false;
}

// The tables say what is refused, and nothing else is.
TEST(AnyFigure, WhatNoTableHasIsRefused) {
  Material m(7, 0);
  const std::vector<Some> all = all_kinds(m);
  EXPECT_EQ(all.size(), 39U);
  int refused = 0;
  for (const Some& a : all) {
    for (const Some& b : all) {
      const std::string name = to_string(a) + "; " + to_string(b);
      const auto expect = [&](bool is_answered, auto call, const char* question) {
        EXPECT_EQ(is_unsupported(call), !is_answered) << question << ": " << name;
        refused += is_answered ? 0 : 1;
      };
      const bool same = a.dimension() == b.dimension();
      const auto in = [&](const query::QuestionTable& table) {
        return same && table.answers(a.kind(), b.kind(), a.dimension());
      };
      const bool related = same && pair_method(a.kind(), b.kind(), a.dimension()) != PairMethod::absent;
      expect(
          related, [&] { relate(a, b); }, "relate");
      expect(
          related, [&] { intersects(a, b); }, "intersects");
      expect(
          in(query::contains_pairs), [&] { contains(a, b); }, "contains");
      expect(
          in(query::closest_pairs), [&] { distance(a, b); }, "distance");
      expect(
          in(query::closest_pairs), [&] { closest_points(a, b); }, "closest_points");
      expect(
          in(query::hit_pairs), [&] { first_hit(a, b); }, "first_hit");
      expect(
          in(query::hit_pairs), [&] { first_hit_parameter(a, b); }, "first_hit_parameter");
      expect(
          in(query::hit_pairs), [&] { hits(a, b); }, "hits");
      expect(
          in(query::intersection_pairs), [&] { intersection(a, b); }, "intersection");
      const Translating<Some> moving{a, {1, 2, 0}};
      expect(
          in(query::translating_pairs), [&] { first_contact(moving, b); }, "first_contact");
      expect(
          in(query::translating_pairs), [&] { first_contact_time(b, moving); }, "first_contact_time");
      expect(
          in(query::translating_pairs), [&] { intersects(moving, b); }, "intersects");
      const auto is_body = [](const Some& s) { return s.dimension() == 3 && query::is_body_kind(s.kind()); };
      expect(
          is_body(a) && is_body(b), [&] { gjk_intersects(a, b); }, "gjk_intersects");
      expect(
          is_body(a) && is_body(b), [&] { penetration(a, b); }, "penetration");
    }
  }
  EXPECT_GT(refused, 1521 * 7);  // half of all pairs are of two spaces
}

TEST(AnyFigure, IsRefusedByName) {
  const Some ball = Sphere3{{0, 0, 0}, 1}, cylinder = Cylinder3{{0, 0, 0}, {1, 0, 0}, 1}, flat = Circle2{{0, 0}, 1};
  const std::string pages = "; the pages of docs/ list the pairs of each question, and query/body/ holds their tables";
  EXPECT_EQ(outcome([&] { return distance(ball, cylinder); }),
            "Unsupported: distance has no answer for a ball of space and a cylinder of space" + pages);
  EXPECT_EQ(outcome([&] {
              return relate(Point2{0, 0}, ball);
            }),
            "Unsupported: relate has no answer for a point of the plane and a ball of space" + pages);
  EXPECT_EQ(outcome([&] { return compare_distance(ball, cylinder, 1) == Sign::zero; }),
            "Unsupported: compare_distance has no answer for a ball of space and a cylinder of space" + pages);
  EXPECT_EQ(outcome([&] { return gjk_intersects(ball, cylinder); }),
            "Unsupported: what takes convex bodies has no answer for a cylinder of space; docs/figures.md lists the "
            "kinds");
  EXPECT_TRUE(is_unsupported([&] { first_contact(Translating<Some>{flat, {1, 0, 1}}, Point2{4, 0}); }));
  EXPECT_TRUE(is_unsupported([&] { (void)ball.under(Pose2{{{{1, 0}, {0, 1}}}, {0, 0}}); }));
  EXPECT_TRUE(is_unsupported([&] { (void)flat.under(identity_pose); }));
}

// In any mix, posed or not.
TEST(AnyFigure, GoesWithTheKindsThemselves) {
  const Pose tilt{{{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}, {1, 2, 3}};
  const Pose even{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {1, 2, 3}};
  const Aabb3 box{{-1, -2, -1}, {1, 1, 2}};
  const Triangle3 triangle{{0, 0, 0}, {4, 0, 1}, {0, 4, 1}};
  const Sphere3 ball{{3, 1, 1}, 1};
  const Ray3 ray{{-9, 0.5, 0.5}, {1, 0.25, 0}};
  const auto expect = [&](const auto& a, const auto& b) {
    const Some x = a, y = b;
    EXPECT_EQ(relate(x, b), relate(a, b));
    EXPECT_EQ(relate(a, y), relate(a, b));
    EXPECT_EQ(relate(x, y), relate(a, b));
    EXPECT_EQ(intersects(a, y), intersects(a, b));
    EXPECT_EQ(closest_points(x, b), closest_points(a, b));
    EXPECT_EQ(closest_points(a, y), closest_points(a, b));
    EXPECT_EQ(distance(x, y), distance(a, b));
    EXPECT_EQ(compare_distance(x, y, a, b), Sign::zero);
    EXPECT_EQ(compare_distance(x, b, 1.0), compare_distance(a, b, 1.0));
    EXPECT_EQ(first_hit(ray, y), first_hit(ray, b));
    EXPECT_EQ(first_hit(Some(ray), b), first_hit(ray, b));
    EXPECT_EQ(hits(Some(ray), y), hits(ray, b));
    EXPECT_EQ(first_hit_parameter(ray, y), first_hit_parameter(ray, b));
    const Vector3 by{-7, 1, 2};
    EXPECT_EQ(first_contact(Translating{x, by}, b), first_contact(Translating{a, by}, b));
    EXPECT_EQ(first_contact(Translating{a, by}, y), first_contact(Translating{a, by}, b));
    EXPECT_EQ(first_contact(x, Translating{y, by}), first_contact(a, Translating{b, by}));
    EXPECT_EQ(first_contact_time(Translating{x, by}, Translating{y, by}),
              first_contact_time(Translating{a, by}, Translating{b, by}));
    EXPECT_EQ(intersects(Translating{x, by}, b), intersects(Translating{a, by}, b));
    EXPECT_EQ(penetration(x, b), penetration(a, b));
    EXPECT_EQ(gjk_distance(a, y), gjk_distance(a, b));
    EXPECT_EQ(contact(x, b, {.margin = 9}), contact(a, b, {.margin = 9}));
    EXPECT_EQ(contains(x, Point3{1, 1, 1}), contains(a, Point3{1, 1, 1}));
  };
  const auto with_all = [&](const auto& a) {
    expect(a, box), expect(a, triangle), expect(a, ball);
    expect(a, Posed{box, tilt}), expect(a, Posed{triangle, tilt}), expect(a, Posed{ball, even});
  };
  with_all(box), with_all(triangle), with_all(ball);
  with_all(Posed{box, tilt}), with_all(Posed{triangle, even}), with_all(Posed{ball, even});
  EXPECT_EQ(Some(Posed{box, tilt}), Some(box).under(tilt));
}

TEST(AnyFigure, OfThePlaneAnswersInThePlane) {
  const Circle2 disk{{3, 4}, 1};
  const Some any = disk;
  EXPECT_EQ(closest_points(any, Point2{0, 0}).on_a, (Point3{2.4, 3.2, 0}));
  EXPECT_EQ(first_hit(Ray2{{3, 0}, {0, 1}}, any)->point, (Point3{3, 3, 0}));
  EXPECT_EQ(first_contact(Translating<Some>{any, {0, -4, 0}}, Some(Aabb2{{0, 0}, {9, 1}}))->time, 0.5);
  EXPECT_EQ(fit_aabb(any), (Aabb3{{2, 3, 0}, {4, 5, 0}}));
  EXPECT_EQ(support_point(any, {0, 1, 0}).point, (Point3{3, 5, 0}));
  EXPECT_EQ(support_value(any, {0, 1, 0}), 5);
  EXPECT_TRUE(contains(any, {3, 5}));
  EXPECT_EQ(locate(any, Point2{3, 5}), Location::boundary);
  EXPECT_TRUE(is_unsupported([&] { support_point(any, {0, 0, 1}); }));
  EXPECT_TRUE(is_unsupported([&] { (void)contains(any, {3, 5, 0}); }));
}

TEST(AnyFigure, TellsWhatTheKindsHaveInCommon) {
  const Triangle3 a{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, b{{1, 1, -1}, {1, 1, 1}, {3, 1, 1}};
  EXPECT_TRUE(std::get<Intersection3>(intersection(Some(a), b)) == intersection(a, b));
  const Aabb3 box{{0, 0, 0}, {2, 2, 2}};
  const Obb3 other{{2, 2, 2}, {{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}, {1, 1, 1}};
  EXPECT_TRUE(std::get<SolidIntersection3>(intersection(other, Some(box))) == intersection(box, other));
  const Plane3 floor{{0, 0, 1}, 0}, wall{{1, 0, 0}, 2};
  EXPECT_EQ(std::get<FlatIntersection>(intersection(Some(floor), Some(wall))).kind, FlatKind::line);
  const Triangle2 flat{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_TRUE(std::get<Intersection2>(intersection(Some(flat), Aabb2{{1, 1}, {9, 9}})) ==
              intersection(flat, Aabb2{{1, 1}, {9, 9}}));
}

TEST(AnyFigure, IsAValue) {
  static_assert(sizeof(Some) <= 256);
  Polygon3 polygon{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  Some a = polygon;
  const Some b = a;
  polygon.vertices[0].x = 7;
  EXPECT_EQ(get_if<Polygon3>(a)->vertices[0].x, 0);
  a = Some(Sphere3{{1, 2, 3}, 4});
  EXPECT_EQ(a.kind(), FigureKind::ball);
  EXPECT_EQ(a.dimension(), 3);
  EXPECT_EQ(get_if<Sphere3>(a)->radius, 4);
  EXPECT_EQ(get_if<Circle2>(a), nullptr);
  EXPECT_EQ(get_if<Polygon3>(a), nullptr);
  EXPECT_EQ(b, figure_of(*get_if<Polygon3>(b)));
  EXPECT_FALSE(a == b);
  EXPECT_EQ(visit([](const auto& s) { return name_of_figure(s); }, a), "sphere");
  std::vector<Some> scene{Sphere3{{0, 0, 0}, 1}, Posed{Aabb3{{0, 0, 0}, {1, 1, 1}}, identity_pose}, b};
  EXPECT_TRUE(scene[1].is_posed() && !scene[0].is_posed());
  EXPECT_FALSE(scene[1] == Some(Aabb3{{0, 0, 0}, {1, 1, 1}}));
}

TEST(AnyFigure, IsOneLineOfText) {
  EXPECT_EQ(to_string(Sphere3{{1, 2, 3}, 0.5}), "ball3 0x1p+0 0x1p+1 0x1.8p+1 0x1p-1");
  EXPECT_EQ(to_string(Posed{Circle2{{1, 0}, 2}, Pose2{{{{0, 1}, {-1, 0}}}, {3, 0}}}),
            "ball2 0x1p+0 0x0p+0 0x1p+1 pose 0x0p+0 0x1p+0 -0x1p+0 0x0p+0 0x1.8p+1 0x0p+0");
  EXPECT_EQ(to_string(Posed{Sphere3{{1, 2, 3}, 4}, RigidPose{{1, 0, 0, -1}, {8, 0, 0}}}),
            "ball3 0x1p+0 0x1p+1 0x1.8p+1 0x1p+2 rigid 0x1p+0 0x0p+0 0x0p+0 -0x1p+0 0x1p+3 0x0p+0 0x0p+0");
  EXPECT_EQ(to_string(Posed{Point2{1, 2}, RigidChain2{{{{1, 1}, {4, 0}}, {{2, 0}, {0, 1}}}}}),
            "point2 0x1p+0 0x1p+1 chain 0x1p+0 0x1p+0 0x1p+2 0x0p+0 0x1p+1 0x0p+0 0x0p+0 0x1p+0");
  EXPECT_EQ(to_string(Posed{Point3{0, 0, 0}, RigidChain{}}), "point3 0x0p+0 0x0p+0 0x0p+0 chain");
  EXPECT_EQ(parse_figure("aabb3 0 0 0  1 2 0x1p-3  # a slab"), Some(Aabb3{{0, 0, 0}, {1, 2, 0.125}}));
  EXPECT_EQ(parse_figure("  # nothing"), std::nullopt);
  int seen = 0;
  shape_cases::on_shapes(5, 20, [&](Material& m) {
    for (const Some& s : all_kinds(m)) {
      const Pose pose = regular_pose(m);
      const Some posed = s.dimension() == 2 ? s.under(in_plane(pose)) : s.under(pose);
      const RigidCase by = rigid_case(m);
      const auto under = [&s](const auto& there) { return s.under(there); };
      const Some rigid = s.dimension() == 2 ? std::visit(under, by.plane) : std::visit(under, by.space);
      for (const Some& read : {s, posed, rigid}) EXPECT_EQ(parse_figure(to_string(read)), read) << to_string(read);
      ++seen;
    }
  });
  EXPECT_EQ(seen, 20 * 39);
  const auto refusal = [](const std::string& line) {
    try {
      (void)parse_figure(line);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("read");
  };
  EXPECT_EQ(refusal("ball3 1 2 3"), "3 numbers are no ball; give 4");
  EXPECT_EQ(refusal("ball3 1 2 3 x"),
            "'x' is not a number; give a decimal or hexadecimal double, such as 0.1 or 0x1.8p-3");
  EXPECT_EQ(refusal("ball3 1 2 3 4 pose 1"),
            "ball3: 1 numbers are no pose; give 12, the columns and then the translation");
  EXPECT_EQ(refusal("ball3 1 2 3 4 rigid 1 0 0 0"),
            "ball3: 4 numbers are no rigid pose; give 7, the quaternion and then the translation");
  EXPECT_EQ(refusal("ball2 1 2 3 chain 1 0 4"),
            "ball2: 3 numbers are no chain; give 4 for each link, the quaternion and then the translation");
  EXPECT_EQ(refusal("ball2 1 2 3 chain 1 0 4 5 pose"), "ball2: nothing may follow the pose, but here comes 'pose'");
  EXPECT_EQ(refusal("k_dop2 3 1 0"),
            "k_dop2: the line ends too early; query/body/any_figure.hpp says what its numbers are");
  EXPECT_TRUE(refusal("sphere 1 2 3 4").starts_with("there is no figure 'sphere'; there are point2, line2, "));
}

}  // namespace
}  // namespace plumb::pair_cases
