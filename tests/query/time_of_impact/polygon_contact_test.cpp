// Balls and capsules against polygons in space: as the triangles that they are cut into, and where they pass holes.
#include "plumb/query/time_of_impact/polygon_contact.hpp"

#include <gmock/gmock.h>

#include "certify/sanitized.hpp"
#include "figure/basic/shape_cases.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using testing::HasSubstr;
using testing::ThrowsMessage;

double whole(Material& m, std::size_t most) {
  return static_cast<double>(m.below(2 * most + 1)) - static_cast<double>(most);
}

/// A polygon of the plane of two whole vectors, and triangles that make it up.
struct Cut {
  std::vector<Point2> outer, hole;
  std::vector<std::array<Point2, 3>> triangles;
};
const std::vector<Cut>& cuts() {
  static const std::vector<Cut> all{
      {{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},
       {},
       {{{{0, 0}, {4, 0}, {2, 1}}}, {{{4, 0}, {4, 4}, {2, 1}}}, {{{0, 0}, {2, 1}, {0, 4}}}}},
      {{{0, 0}, {6, 0}, {6, 6}, {0, 6}},
       {{1, 1}, {1, 5}, {5, 5}, {5, 1}},
       {{{{0, 0}, {6, 0}, {5, 1}}},
        {{{0, 0}, {5, 1}, {1, 1}}},
        {{{6, 0}, {6, 6}, {5, 5}}},
        {{{6, 0}, {5, 5}, {5, 1}}},
        {{{6, 6}, {0, 6}, {1, 5}}},
        {{{6, 6}, {1, 5}, {5, 5}}},
        {{{0, 6}, {0, 0}, {1, 1}}},
        {{{0, 6}, {1, 1}, {1, 5}}}}},
      {{{0, 0}, {3, 0}, {3, 0}, {1, 3}}, {}, {{{{0, 0}, {3, 0}, {1, 3}}}}},
      {{{0, 0}, {2, 0}, {5, 0}}, {}, {{{{0, 0}, {2, 0}, {5, 0}}}}}};
  return all;
}

template <class Round>
Round drawn_round(Material& m) {
  const Point3 p{whole(m, 4), whole(m, 4), whole(m, 4)};
  const double r = 0.5 * static_cast<double>(m.below(5));
  if constexpr (std::is_same_v<Round, Sphere3>) {
    return {p, r};
  } else {
    return {p, {p.x + whole(m, 2), p.y + whole(m, 2), p.z + whole(m, 2)}, r};
  }
}

template <class Round>
void expect_as_triangles(std::uint64_t start) {
  int met = 0, faces = 0, cases = 0;
  shape_cases::on_shapes(start, battery::sanitized ? 100 : 1000, [&](Material& m) {
    const Cut& cut = cuts()[m.below(cuts().size())];
    const Point3 o{whole(m, 2), whole(m, 2), whole(m, 2)};
    const Vector3 u{whole(m, 1), whole(m, 1), whole(m, 1)}, v{whole(m, 1), whole(m, 1), whole(m, 1)};
    const auto place = [&](const Point2& p) {
      return Point3{o.x + p.x * u.x + p.y * v.x, o.y + p.x * u.y + p.y * v.y, o.z + p.x * u.z + p.y * v.z};
    };
    HoledPolygon3 polygon;
    for (const Point2& p : cut.outer) polygon.outer.vertices.push_back(place(p));
    if (!cut.hole.empty()) polygon.holes.resize(1);
    for (const Point2& p : cut.hole) polygon.holes[0].vertices.push_back(place(p));
    const Translating<Round> round{drawn_round<Round>(m), {whole(m, 12), whole(m, 12), whole(m, 12)}};
    const Vector3 by{whole(m, 2), whole(m, 2), whole(m, 2)};
    const std::string about = m.about(round.shape, o);
    std::optional<Root> wanted;
    for (const auto& [a, b, c] : cut.triangles) {
      const auto t = first_contact_time(round, Translating{Triangle3{place(a), place(b), place(c)}, by});
      if (t && (!wanted || *t < *wanted)) wanted = t;
    }
    const auto time = first_contact_time(round, Translating{polygon, by});
    const auto contact = first_contact(Translating{polygon, by}, round);
    ++cases;
    ASSERT_EQ(time.has_value(), wanted.has_value()) << about;
    EXPECT_EQ(intersects(round, Translating{polygon, by}), wanted.has_value()) << about;
    ASSERT_EQ(contact.has_value(), wanted.has_value()) << about;
    if (!time) return;
    ++met;
    EXPECT_TRUE(*time == *wanted) << about << time->rounded() << " " << wanted->rounded();
    EXPECT_EQ(contact->time, wanted->rounded(Rounding::down) + 0.0) << about;
    faces += contact->feature_a == Feature{FeatureKind::face, 0} ? 1 : 0;
    // A ball, moved exactly, touches what it is said to meet.
    const double t = contact->time;
    const Relation at_start = relate(round.shape, polygon);
    EXPECT_EQ(at_start == Relation::overlapping, contact->feature_a.kind == FeatureKind::interior) << about;
    EXPECT_EQ(at_start != Relation::disjoint, t == 0 && *time == Root(0)) << about;
    if (cut.hole.empty()) {
      EXPECT_EQ(first_contact(round, Translating{polygon.outer, by}), swapped(*contact)) << about;
    }
  });
  EXPECT_GT(met * 10, cases);
  EXPECT_LT(met, cases - 5);
  EXPECT_GT(faces * 40, met);
}

TEST(PolygonContact, BallsAsTheTriangles) { expect_as_triangles<Sphere3>(6001); }
TEST(PolygonContact, CapsulesAsTheTriangles) { expect_as_triangles<Capsule3>(6002); }

TEST(PolygonContact, FeaturesAndHoles) {
  const HoledPolygon3 floor{{{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}},
                            {{{{1, 1, 0}, {1, 5, 0}, {5, 5, 0}, {5, 1, 0}}}}};
  const auto drop = [&](Point3 from, double r) {
    return first_contact(Translating{Sphere3{from, r}, {0, 0, -10}}, floor);
  };
  const Feature ball{FeatureKind::face, 0};
  EXPECT_FALSE(drop({3, 3, 5}, 1.5));                                           // through the hole
  EXPECT_EQ(drop({3, 3, 5}, 2), (Contact{0.5, ball, {FeatureKind::edge, 4}}));  // all four rims at once
  EXPECT_EQ(drop({0.5, 3, 5}, 0.25), (Contact{0.47499999999999998, ball, {FeatureKind::face, 0}}));
  EXPECT_EQ(drop({-3, -4, 7}, 13), (Contact{0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}));
  EXPECT_EQ(drop({-3, -4, 12}, 13), (Contact{0, ball, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(first_contact(Translating{Capsule3{{0.5, 1, 5}, {0.5, 5, 5}, 1}, {0, 0, -10}}, floor),
            (Contact{0.39999999999999997, {FeatureKind::vertex, 0}, {FeatureKind::face, 0}}));
  const Rectangle3 sheet{{3, 3, 0}, {{{1, 0, 0}, {0, 1, 0}}}, {3, 3}};
  EXPECT_EQ(first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, sheet),
            (Contact{0.5, ball, {FeatureKind::face, 0}}));
  EXPECT_EQ(first_contact(Translating{sheet, {0, 0, 8}}, Sphere3{{6, 7, 5}, 1}),
            (Contact{0.625, {FeatureKind::vertex, 3}, ball}));
  EXPECT_EQ(first_contact(Translating{sheet, {0, 0, 8}}, Sphere3{{5, 7, 5}, 1}),
            (Contact{0.625, {FeatureKind::edge, 1}, ball}));  // along x, at the upper end of y
  const Quadrilateral3 quad{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}};
  EXPECT_EQ(first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, quad),
            (Contact{0.5, ball, {FeatureKind::face, 0}}));
  EXPECT_THAT(
      [&] {
        (void)first_contact(Translating{Sphere3{{3, 3, 5}, -1}, {0, 0, -8}}, quad);
      },
      ThrowsMessage<InvalidShape>(HasSubstr("first_contact: ")));
  EXPECT_THAT(
      [&] {
        (void)first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, NAN}}, quad);
      },
      ThrowsMessage<NonFinite>(HasSubstr("first_contact: the motion of the round figure.z is nan")));
  const Polygon3 bent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}};
  EXPECT_THROW((void)first_contact(Translating{Sphere3{{3, 3, 5}, 1}, {0, 0, -8}}, bent), InvalidShape);
}

}  // namespace
}  // namespace plumb
