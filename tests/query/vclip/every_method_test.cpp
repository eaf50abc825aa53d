// Every method for convex bodies against every other: GJK with and without a cache, V-Clip, separating vectors (Chung
// and Wang), separating axes, hierarchies of polytopes, certificates and their verifier, relate, distance, and linear
// programs in rationals, on pairs of every kind: that share a vertex, an edge, a face, an ulp from it, contained, flat
// against flat, points, sizes 2^60 apart, repeated points, as they stand and under common poses.
//
// With PLUMB_LONG_TESTS 1,000,000 pairs in 400 pieces, which --gtest_filter runs by their numbers.
#include <gtest/gtest.h>

#include <array>
#include <variant>

#include "arith/rational_lp.hpp"
#include "certify/sanitized.hpp"
#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "query/certificate/body_pairs.hpp"
#include "query/vclip/pairs.hpp"

namespace plumb {
namespace {

using body_pairs::OwnedBody, body_pairs::PairMaker, pair_cases::Material;
using certificate_laws::corners_of, certificate_laws::Corners;

#if defined(PLUMB_LONG_TESTS)
constexpr std::uint64_t pieces = 400, pairs_of_piece = 2500;
#else
const std::uint64_t pieces = 1, pairs_of_piece = battery::fitting(400);
#endif

/// Linear programs over the plane n x = c between two hulls.
class Programs {
 public:
  Programs(const Corners& a, const Corners& b) : a_(a), b_(b) {}

  [[nodiscard]] Relation relation() const {
    if (sgn(greatest_gap()) > 0) return Relation::disjoint;
    return sgn(farthest_of_all()) > 0 ? Relation::touching : Relation::overlapping;
  }

 private:
  /// n of [-1, 1]^3, c and as many others as asked.
  static arith::Constraints directions(std::size_t size) {
    arith::Constraints c;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int way : {1, -1}) {
        arith::RationalVector row(size);
        row[k] = way;
        c.add(std::move(row), 1);
      }
    }
    return c;
  }
  static arith::RationalVector row(const query::Exact3& p, int sign, std::size_t size) {
    arith::RationalVector r(size);
    for (std::size_t k = 0; k < 3; ++k) r[k] = sign * p[k];
    r[3] = -sign;
    return r;
  }
  /// How far all of a can be on one side of a plane, and all of b on the other.
  [[nodiscard]] mpq_class greatest_gap() const {
    arith::Constraints all = directions(5);
    const auto add = [&](const query::Exact3& p, int sign) {
      arith::RationalVector r = row(p, sign, 5);
      r[4] = 1;
      all.add(std::move(r), 0);
    };
    for (const query::Exact3& p : a_.points) add(p, 1);
    for (const query::Exact3& p : b_.points) add(p, -1);
    const arith::Optimum best = arith::maximize({0, 0, 0, 0, 1}, all);
    EXPECT_EQ(best.kind, arith::Optimum::Kind::optimal);
    return best.at[4];
  }
  /// Of all planes between both, the greatest sum of what the corners are off it: zero where the insides meet, for a
  /// plane that is between them holds both then.
  [[nodiscard]] mpq_class farthest_of_all() const {
    arith::Constraints all = directions(4);
    arith::RationalVector sum(4);
    const auto add = [&](const query::Exact3& p, int sign) {
      arith::RationalVector r = row(p, sign, 4);
      for (std::size_t k = 0; k < 4; ++k) sum[k] -= r[k];
      all.add(std::move(r), 0);
    };
    for (const query::Exact3& p : a_.points) add(p, 1);
    for (const query::Exact3& p : b_.points) add(p, -1);
    const arith::Optimum best = arith::maximize(sum, all);
    EXPECT_EQ(best.kind, arith::Optimum::Kind::optimal);
    return arith::dot(sum, best.at);
  }

  const Corners &a_, &b_;
};

/// The figure of as many points, or the hull where it is solid; nothing of others.
using AnyFigure = std::variant<std::monostate, Point3, Segment3, Triangle3, Tetrahedron3, ConvexPolyhedron3>;
AnyFigure figure_of(const std::vector<Point3>& p) {
  switch (p.size()) {
    case 1:
      return p[0];
    case 2:
      return Segment3{p[0], p[1]};
    case 3:
      return Triangle3{p[0], p[1], p[2]};
    case 4:
      return Tetrahedron3{p[0], p[1], p[2], p[3]};
    default:
      break;
  }
  const Hull3 hull = convex_hull(p);
  if (hull.dimension < 3) return {};
  return convex_polyhedron(hull, p);
}

struct Seen {
  std::array<int, 3> relations{};
  int pairs = 0, figures = 0, solids = 0, posed = 0;
};

/// What all have to say of a pair.
struct Told {
  Relation relation;
  double distance;
  [[nodiscard]] bool meet() const { return relation != Relation::disjoint; }
};

class Methods {
 public:
  explicit Methods(Seen& seen) : seen_(seen) {}

  void ask(const OwnedBody& a, const OwnedBody& b, const std::string& name) {
    const query::BodyView va = a.view(), vb = b.view();
    const Corners ca = corners_of(va), cb = corners_of(vb);
    const Told told{Programs(ca, cb).relation(), certified(va, vb, name)};
    ++seen_.pairs, ++seen_.relations[static_cast<std::size_t>(static_cast<int>(told.relation) + 1)];
    ASSERT_EQ(query::certified_relation(va, vb).claim, claim_of(told.relation)) << name;
    of_gjk(va, vb, told, name);
    if (testing::Test::HasFailure()) return;
    if ((a.pose || b.pose) && !(a.pose && b.pose && *a.pose == *b.pose && pair_cases::determinant(*a.pose) != 0))
      return;
    const AnyFigure p = figure_of(a.points), q = figure_of(b.points);
    std::visit([&](const auto& x, const auto& y) { of_figures(x, y, a.pose ? &*a.pose : nullptr, told, name); }, p, q);
  }
  void ask(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b, const std::string& name) {
    const query::BodyView va = query::body_view(a), vb = query::body_view(b);
    const Corners ca = corners_of(va), cb = corners_of(vb);
    const Told told{Programs(ca, cb).relation(), certified(va, vb, name)};
    ++seen_.pairs, ++seen_.relations[static_cast<std::size_t>(static_cast<int>(told.relation) + 1)];
    of_figures(a, b, nullptr, told, name);
  }

 private:
  /// The distance that a certificate proves.
  static double certified(const query::BodyView& a, const query::BodyView& b, const std::string& name) {
    const Certificate c = query::certified_relation(a, b), i = query::certified_intersection(a, b);
    const DistanceCertificate d = query::certified_distance(a, b);
    EXPECT_EQ(query::verdict_on(c, a, b).flaw, "") << name;
    EXPECT_EQ(query::verdict_on(i, a, b).flaw, "") << name;
    EXPECT_EQ(query::verdict_on(d, a, b).flaw, "") << name;
    EXPECT_EQ(i.claim == Claim::disjoint, c.claim == Claim::disjoint) << name;
    // Not of the distance: an ulp of zero, seen at an angle, rounds to zero.
    EXPECT_EQ(d.exact.square.sign() == Sign::positive, c.claim == Claim::disjoint) << name;
    return d.distance;
  }
  void of_gjk(const query::BodyView& a, const query::BodyView& b, const Told& told, const std::string& name) {
    ASSERT_EQ(query::gjk_meets(a, b, {}), told.meet()) << name;
    ASSERT_EQ(query::gjk_meets(a, b, {.cache = &cache_}), told.meet()) << name;
    ASSERT_EQ(query::gjk_meets(a, b, {.cache = &cache_}), told.meet()) << name;
    ASSERT_EQ(query::gjk_apart_by(a, b, {}), told.distance) << name;
    ASSERT_EQ(query::gjk_apart_by(a, b, {.cache = &cache_}), told.distance) << name;
    if (seen_.pairs % 8 != 0) return;  // which face of many points holds a common point takes milliseconds
    const GjkAnswer answer = query::gjk_answer(a, b, {.cache = &cache_});
    ASSERT_EQ(answer.meets, told.meet()) << name;
    ASSERT_EQ(answer.closest.distance, told.distance) << name;
  }

  template <class A, class B>
  void of_figures(const A& a, const B& b, const Pose* pose, const Told& told, const std::string& name) {
    if constexpr (!std::is_same_v<A, std::monostate> && !std::is_same_v<B, std::monostate>) {
      ++seen_.figures;
      ASSERT_EQ(relate(a, b), told.relation) << name;  // which a common pose does not change
      ASSERT_EQ(intersects(a, b), told.meet()) << name;
      if (pose != nullptr) {
        ++seen_.posed;
        of_shapes(Posed{a, *pose}, Posed{b, *pose}, told, name);
      } else {
        of_shapes(a, b, told, name);
      }
      if constexpr (std::is_same_v<A, ConvexPolyhedron3> && std::is_same_v<B, ConvexPolyhedron3>) {
        if (pose == nullptr) of_hierarchies(a, b, told, name);
      }
    }
  }
  template <class A, class B>
  void of_shapes(const A& a, const B& b, const Told& told, const std::string& name) {
    ASSERT_EQ(relate(a, b), told.relation) << name;
    ASSERT_EQ(distance(a, b), told.distance) << name;
    ASSERT_NO_FATAL_FAILURE(of_gjk(query::body_view(a), query::body_view(b), told, name));
    if constexpr (query::ClipBody<A> && query::ClipBody<B>) {
      ++seen_.solids;
      const VClipResult clipped = vclip(a, b);
      ASSERT_EQ(clipped.meet, told.meet()) << name;
      ASSERT_EQ(clipped.closest.distance, told.distance) << name;
      ASSERT_EQ(separating_vector(a, b).disjoint, !told.meet()) << name;
      const auto axis = separating_axis(a, b);
      ASSERT_EQ(axis ? axis->relation : Relation::overlapping, told.relation) << name;
    }
  }
  static void of_hierarchies(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b, const Told& told,
                             const std::string& name) {
    const PolytopeHierarchy p = build_polytope_hierarchy(a), q = build_polytope_hierarchy(b);
    ASSERT_EQ(intersects(p, q), told.meet()) << name;
    ASSERT_EQ(distance(p, q), told.distance) << name;
  }

  Seen& seen_;
  GjkCache cache_;  // of whatever pair was before
};

class EveryMethod : public testing::TestWithParam<std::uint64_t> {};

TEST_P(EveryMethod, SaysTheSame) {
  Seen seen;
  Methods methods(seen);
  for (std::uint64_t k = 0; k < pairs_of_piece && !HasFailure(); ++k) {
    const std::uint64_t index = GetParam() * pairs_of_piece + k;
    if (index % 4 == 3) {
      const auto [a, b, name] = clip_cases::pair_of(97, index);
      methods.ask(a, b, name);
      continue;
    }
    PairMaker maker(36'001, index - index / 4);
    OwnedBody a = maker.a(), b = maker.b();
    Material& m = maker.material();
    if (index % 3 == 0) a.pose = b.pose = m.below(4) != 0 ? pair_cases::regular_pose(m) : pair_cases::whole_pose(m);
    if (index % 30 == 0) b.pose = pair_cases::whole_pose(m);
    methods.ask(a, b, maker.about());
  }
  const auto [disjoint, touching, overlapping] = seen.relations;
  std::printf("%d pairs: %d disjoint, %d touching, %d overlapping; %d of figures, %d of them posed, %d solids\n",
              seen.pairs, disjoint, touching, overlapping, seen.figures, seen.posed, seen.solids);
  for (const int seen_so : seen.relations) EXPECT_GT(seen_so * 8, seen.pairs);
  EXPECT_GT(seen.solids * 5, seen.pairs);
  EXPECT_GT(seen.posed * 20, seen.pairs);
}

INSTANTIATE_TEST_SUITE_P(Pieces, EveryMethod, testing::Range(std::uint64_t{0}, pieces));

}  // namespace
}  // namespace plumb
