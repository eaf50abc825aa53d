// Certificates of figures: every pair of kinds that are bodies, hard ones, as they stand and under poses, says what
// relate, intersects and distance say of it, and is verified.
#include <gtest/gtest.h>

#include "plumb/query/certificate/verify.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/separation/posed.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

using Bodies = Types<Point3, Segment3, Triangle3, Quadrilateral3, Polygon3, Rectangle3, Tetrahedron3, Sphere3, Aabb3,
                     Obb3, Capsule3, Lozenge3, ConvexPolyhedron3>;

/// False where one of them is no body: empty, or a polygon that is not convex.
template <class A, class B>
bool expect_agrees(const A& a, const B& b, const std::string& about, Answers& answers) {
  try {
    const Certificate c = relate_with_proof(a, b);
    const Relation relation = relate(a, b);
    answers.add(relation);
    EXPECT_EQ(c.claim, claim_of(relation)) << about;
    EXPECT_EQ(verify(c, a, b).flaw, "") << about;
    const Certificate i = intersects_with_proof(a, b);
    EXPECT_EQ(i.claim != Claim::disjoint, intersects(a, b)) << about;
    EXPECT_EQ(verify(i, a, b).flaw, "") << about;
    const DistanceCertificate d = distance_with_proof(a, b);
    EXPECT_EQ(d.distance, distance(a, b)) << about;
    EXPECT_EQ(compare(d.exact, exact_distance(a, b)), Sign::zero) << about;
    EXPECT_EQ(verify(d, a, b).flaw, "") << about;
    return true;
  } catch (const InvalidShape&) {
    return false;
  }
}

TEST(CertificatesOfFigures, SayWhatRelateAndDistanceSay) {
  std::uint64_t start = 34'000;
  AnswersByKind by_kind{};
  int asked = 0, refused = 0;
  on_pairs(Bodies{}, [&]<class A, class B>(const A*, const B*) {
    Answers answers;
    shape_cases::on_shapes(start++, battery::sanitized ? 4 : 20, [&](Material& m) {
      const auto [a, b] = pair_of<A, B>(m);
      const std::string about = pair_name<A, B>() + m.about(a, b);
      const bool is_pair = expect_agrees(a, b, about, answers) && expect_agrees(b, a, about, answers);
      ++(is_pair ? asked : refused);
    });
    add_to_kinds<A, B>(by_kind, answers);
  });
  if (!battery::sanitized) expect_every_answer(by_kind);  // a fifth of the cases does not reach all
  std::printf("%d pairs, and %d of which one is no body\n", asked, refused);
  EXPECT_GT(asked, refused);
}

TEST(CertificatesOfFigures, UnderPoses) {
  std::uint64_t start = 35'000;
  Answers answers;
  int uneven = 0;
  on_pairs(Types<Segment3, Triangle3, Sphere3, Aabb3, Capsule3, ConvexPolyhedron3>{},
           [&]<class A, class B>(const A*, const B*) {
             shape_cases::on_shapes(start++, battery::sanitized ? 4 : 16, [&](Material& m) {
               const auto [a, b] = pair_of<A, B>(m);
               const Pose pose = m.below(2) == 0 ? regular_pose(m) : whole_pose(m),
                          quarter{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {m.number(), 1, 0}};
               const std::string about = "posed " + pair_name<A, B>() + m.about(a, b, pose);
               expect_agrees(Posed{a, quarter}, Posed{b, quarter}, about, answers);
               try {
                 expect_agrees(Posed{a, pose}, b, about, answers);
               } catch (const UnevenPose&) {
                 ++uneven;
               }
             });
           });
  EXPECT_GT(uneven, 0);
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GT(answers.of(r) * 20, answers.all());
}

}  // namespace
}  // namespace plumb::pair_cases
