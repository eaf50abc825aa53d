// Certificates with one thing changed: verify refuses each, but for those that another arithmetic shows to be proofs as
// well.
#include "query/certificate/mutants.hpp"

#include <gtest/gtest.h>

#include <map>

#include "certify/sanitized.hpp"
#include "query/certificate/body_pairs.hpp"
#include "query/certificate/certificate_laws.hpp"

namespace plumb {
namespace {

using body_pairs::OwnedBody, body_pairs::PairMaker;
using certificate_laws::Judge, certificate_laws::MutantsOf;

struct Seen {
  int refused = 0, proofs = 0;
  std::map<std::string, int> flaws, other_proofs;
};

template <class Proof>
void expect_judged(const Proof& proof, const query::BodyView& a, const query::BodyView& b, const Judge& judge,
                   const std::string& about, Seen& seen) {
  ASSERT_TRUE(query::verdict_on(proof, a, b)) << about;
  const MutantsOf mutants(proof);
  for (const auto& [name, mutant] : mutants.all()) {
    const ProofVerdict verdict = query::verdict_on(mutant, a, b);
    EXPECT_EQ(bool(verdict), judge.is_proof(mutant)) << about << ": " << name << ": " << verdict.flaw;
    ++(verdict ? seen.proofs : seen.refused);
    if (verdict) {
      ++seen.other_proofs[name.substr(name.find(": ") == name.npos ? 0 : name.find(": ") + 2)];
    } else {
      ++seen.flaws[verdict.flaw.starts_with("pair ") ? verdict.flaw.substr(verdict.flaw.find(' ', 5)) : verdict.flaw];
    }
  }
}

void print(const Seen& seen) {
  std::printf("%d refused, %d proofs\n", seen.refused, seen.proofs);
  for (const auto& [flaw, count] : seen.flaws) std::printf("  %6d %s\n", count, flaw.c_str());
  for (const auto& [name, count] : seen.other_proofs) std::printf("  a proof: %6d %s\n", count, name.c_str());
}

TEST(MutantCertificates, AreRefusedUnlessTheyAreProofs) {
  Seen seen, of_distance;
  for (std::uint64_t i = 0; i < battery::fitting(300) * shape_cases::more; ++i) {
    PairMaker maker(32'001, i);
    OwnedBody a = maker.a(), b = maker.b();
    if (i % 4 == 0) a.pose = b.pose = pair_cases::whole_pose(maker.material());
    const Judge judge(a.view(), b.view());
    const std::string about = maker.about();
    expect_judged(query::certified_relation(a.view(), b.view()), a.view(), b.view(), judge, about, seen);
    expect_judged(query::certified_intersection(a.view(), b.view()), a.view(), b.view(), judge, about, seen);
    expect_judged(query::certified_distance(a.view(), b.view()), a.view(), b.view(), judge, about, of_distance);
  }
  print(seen), print(of_distance);
  EXPECT_GT(seen.refused, seen.proofs * 3);
  EXPECT_GT(seen.proofs, 0);
  EXPECT_GE(seen.flaws.size(), 13U);
  EXPECT_GT(of_distance.refused, of_distance.proofs * 3);
}

TEST(MutantCertificates, OfRoundBodies) {
  Seen seen;
  for (std::uint64_t i = 0; i < battery::fitting(150) * shape_cases::more; ++i) {
    PairMaker maker(32'002, i);
    const OwnedBody a = maker.a();
    const Capsule3 rod{maker.b().points[0], maker.b().points.back(), maker.material().radius()};
    const query::BodyView b = query::body_view(rod);
    const Judge judge(a.view(), b);
    expect_judged(query::certified_relation(a.view(), b), a.view(), b, judge, maker.about(), seen);
    expect_judged(query::certified_intersection(a.view(), b), a.view(), b, judge, maker.about(), seen);
    expect_judged(query::certified_distance(a.view(), b), a.view(), b, judge, maker.about(), seen);
  }
  // Three, four and five away from the core, of a radius that a nudge makes too short or too long.
  const Aabb3 box{{0, 0, 0}, {1, 1, 1}};
  for (const double r : {5.0, std::nextafter(5.0, 0), std::nextafter(5.0, 9)}) {
    const Sphere3 ball{{4, 5, 0.5}, r};
    const query::BodyView v = query::body_view(box), w = query::body_view(ball);
    expect_judged(query::certified_relation(v, w), v, w, Judge(v, w), "ball", seen);
    expect_judged(query::certified_distance(w, v), w, v, Judge(w, v), "ball", seen);
  }
  print(seen);
  EXPECT_GT(seen.refused, seen.proofs * 3);
}

}  // namespace
}  // namespace plumb
