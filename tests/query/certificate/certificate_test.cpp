// Certificates by hand, of every hard pair of hulls, as they stand and under poses, and of all figures that are bodies:
// they say what relate and distance say, and prove it.
#include "plumb/query/certificate/certificate.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query.hpp"
#include "query/body/posed_cases.hpp"
#include "query/certificate/body_pairs.hpp"
#include "query/certificate/certificate_laws.hpp"

namespace plumb {
namespace {

using body_pairs::Lie, body_pairs::lie_names, body_pairs::OwnedBody, body_pairs::PairMaker;
using certificate_laws::Judge;
using testing::HasSubstr;

/// Whether all three say what is so, and prove it.
void expect_proved(const query::BodyView& a, const query::BodyView& b, const Judge& judge, const std::string& name) {
  const Certificate c = query::certified_relation(a, b);
  EXPECT_EQ(c.claim, claim_of(judge.relation())) << name;
  EXPECT_EQ(query::verdict_on(c, a, b).flaw, "") << name;
  EXPECT_TRUE(judge.is_proof(c)) << name;
  EXPECT_LE(c.pairs.size(), c.claim == Claim::overlapping ? 13U : 4U) << name;

  const bool meet = judge.relation() != Relation::disjoint;
  const Certificate i = query::certified_intersection(a, b);
  EXPECT_EQ(i.claim, meet ? Claim::intersecting : Claim::disjoint) << name;
  EXPECT_EQ(query::verdict_on(i, a, b).flaw, "") << name;
  EXPECT_TRUE(judge.is_proof(i)) << name;

  const DistanceCertificate d = query::certified_distance(a, b);
  EXPECT_EQ(query::verdict_on(d, a, b).flaw, "") << name;
  EXPECT_TRUE(judge.is_proof(d)) << name;
}

TEST(Certificates, OfHardPairsOfHulls) {
  std::map<Lie, std::map<Relation, int>> seen;
  std::map<std::size_t, int> sizes;
  const std::uint64_t cases = battery::fitting(900) * shape_cases::more;
  for (std::uint64_t i = 0; i < cases; ++i) {
    PairMaker maker(31'001, i);
    const OwnedBody a = maker.a(), b = maker.b();
    const Judge judge(a.view(), b.view());
    ++seen[maker.lie()][judge.relation()];
    expect_proved(a.view(), b.view(), judge, maker.about());
    const Certificate c = relate_with_proof(VertexHull3{a.points}, VertexHull3{b.points});
    EXPECT_TRUE(verify(c, VertexHull3{a.points}, VertexHull3{b.points})) << maker.about();
    if (c.claim == Claim::overlapping) ++sizes[c.pairs.size()];
  }
  std::map<Relation, int> all;
  for (const auto& [lie, relations] : seen) {
    for (const auto& [relation, count] : relations) all[relation] += count;
    std::printf("%s: disjoint %d, touching %d, overlapping %d\n", lie_names[static_cast<std::size_t>(lie)].data(),
                seen[lie][Relation::disjoint], seen[lie][Relation::touching], seen[lie][Relation::overlapping]);
  }
  for (const auto& [size, count] : sizes) std::printf("%zu pairs: %d\n", size, count);
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GT(all[r] * 8, static_cast<int>(cases));
  EXPECT_GT(seen[Lie::face][Relation::touching] + seen[Lie::edge][Relation::touching], static_cast<int>(cases / 20));
  EXPECT_GT(seen[Lie::flat][Relation::overlapping], static_cast<int>(cases / 100));
}

// A common pose that is not singular changes no claim; a singular one makes the claim of the flat images.
TEST(Certificates, UnderPoses) {
  int flattened = 0;
  for (std::uint64_t i = 0; i < battery::fitting(400) * shape_cases::more; ++i) {
    PairMaker maker(31'002, i);
    OwnedBody a = maker.a(), b = maker.b();
    const Relation standing =
        certificate_laws::relation_of(certificate_laws::corners_of(a.view()), certificate_laws::corners_of(b.view()));
    const bool regular = maker.material().below(4) != 0;
    a.pose = b.pose = regular ? pair_cases::regular_pose(maker.material()) : pair_cases::whole_pose(maker.material());
    if (maker.material().below(5) == 0) b.pose = pair_cases::whole_pose(maker.material());
    const Judge judge(a.view(), b.view());
    EXPECT_TRUE(judge.relation() == standing || !regular || a.pose != b.pose) << maker.about();
    flattened += pair_cases::determinant(*a.pose) == 0;
    expect_proved(a.view(), b.view(), judge, maker.about());
  }
  EXPECT_GT(flattened, 0);
}

// The same points as a polyhedron, whose corners are found by climbing.
TEST(Certificates, OfPolyhedra) {
  int asked = 0;
  for (std::uint64_t i = 0; i < battery::fitting(400) * shape_cases::more; ++i) {
    PairMaker maker(31'003, i);
    const OwnedBody a = maker.a(), b = maker.b();
    const Hull3 hull = convex_hull(a.points);
    if (hull.dimension != 3) continue;
    ++asked;
    const ConvexPolyhedron3 solid = convex_polyhedron(hull, a.points);
    const query::BodyView view = query::body_view(solid);
    const Judge judge(view, b.view());
    EXPECT_EQ(judge.relation(), Judge(a.view(), b.view()).relation()) << maker.about();
    expect_proved(view, b.view(), judge, maker.about());
    expect_proved(b.view(), view, Judge(b.view(), view), maker.about());
  }
  EXPECT_GT(asked, battery::sanitized ? 3 : 40);
}

TEST(Certificates, OfRoundBodies) {
  std::map<Relation, int> seen;
  for (std::uint64_t i = 0; i < battery::fitting(300) * shape_cases::more; ++i) {
    PairMaker maker(31'004, i);
    pair_cases::Material& m = maker.material();
    const OwnedBody a = maker.a();
    const Sphere3 ball{maker.b().points[0], m.radius()};
    const Capsule3 rod{ball.center, maker.b().points.back(), std::floor(m.radius())};
    const Judge of_ball(a.view(), query::body_view(ball)), of_rod(query::body_view(rod), a.view());
    const Judge of_both(query::body_view(ball), query::body_view(rod));
    for (const Judge* judge : {&of_ball, &of_rod, &of_both}) ++seen[judge->relation()];
    expect_proved(a.view(), query::body_view(ball), of_ball, maker.about());
    expect_proved(query::body_view(rod), a.view(), of_rod, maker.about());
    expect_proved(query::body_view(ball), query::body_view(rod), of_both, maker.about());
  }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GT(seen[r], battery::sanitized ? 2 : 20);
}

template <class Direction>
std::string text_of_direction(const Direction& n) {
  return n ? n->x.text() + " " + n->y.text() + " " + n->z.text() : "none";
}

TEST(Certificates, ByHand) {
  const Aabb3 box{{0, 0, 0}, {4, 4, 4}};
  const auto apart = relate_with_proof(box, Point3{7, 2, 2});
  EXPECT_EQ(apart.claim, Claim::disjoint);
  EXPECT_EQ(text_of_direction(apart.direction), "1/2 0 0");
  const auto corner = relate_with_proof(box, Sphere3{{6, 7, 10}, 7});
  EXPECT_EQ(corner.claim, Claim::touching);
  EXPECT_EQ(text_of_direction(corner.direction), "2 3 6");
  EXPECT_EQ(corner.pairs, (std::vector<WeightedPair>{{7, 0, 1.0}}));
  const auto edge = relate_with_proof(Triangle3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, Segment3{{2, 2, -1}, {2, 2, 1}});
  EXPECT_EQ(edge.claim, Claim::touching);
  EXPECT_EQ(text_of_direction(edge.direction), "1 1 0");
  const auto same = relate_with_proof(Point3{1, 2, 3}, Point3{1, 2, 3});
  EXPECT_EQ(same.claim, Claim::overlapping);
  EXPECT_EQ(same.pairs, (std::vector<WeightedPair>{{0, 0, 1.0}}));
  // In general position it is a tetrahedron around the origin.
  const auto deep = relate_with_proof(Tetrahedron3{{0, 0, 0}, {9, 1, 0}, {0, 8, 1}, {1, 0, 7}}, Point3{1, 1, 1});
  EXPECT_EQ(deep.claim, Claim::overlapping);
  EXPECT_EQ(deep.pairs.size(), 4U);
  const auto far = distance_with_proof(Capsule3{{0, 0, 3}, {4, 0, 3}, 1}, box);
  EXPECT_EQ(far.distance, 0);
  EXPECT_EQ(far.exact.inset, Rational(1));
}

TEST(Certificates, WhatIsNoBodyIsNamed) {
  const std::vector<Point3> none, bad{{0, 0, 0}, {0, NAN, 0}};
  const Point3 p{0, 0, 0};
  const auto refused = [&](auto a) { return text_of<InvalidShape>([&] { (void)relate_with_proof(a, p); }); };
  EXPECT_THAT(refused(VertexHull3{none}), HasSubstr("relate_with_proof: hull is empty"));
  EXPECT_THAT(refused(Aabb3{{1, 0, 0}, {0, 1, 1}}), HasSubstr("is empty"));
  EXPECT_THAT(refused(Sphere3{p, -1}), HasSubstr("relate_with_proof: sphere.radius"));
  EXPECT_THAT(refused(Polygon3{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}}),
              HasSubstr("relate_with_proof: polygon is not convex"));
  EXPECT_THAT(refused(Quadrilateral3{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}), HasSubstr("is not planar"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)distance_with_proof(p, VertexHull3{bad}); }),
              HasSubstr("distance_with_proof: hull.vertices[1].y"));
  const TriangleMesh corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  ConvexPolyhedron3 solid = convex_polyhedron(corner);
  solid.neighbors.pop_back();
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)intersects_with_proof(solid, convex_polyhedron(corner)); }),
              HasSubstr("intersects_with_proof: a: polyhedron.first_neighbor"));
}

}  // namespace
}  // namespace plumb
