// Seidel's algorithm against the simplex method in rationals on programs of every class, and against all corners; its
// proofs, and false ones.
#include "plumb/query/lp/linear_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/query/lp/verify.hpp"
#include "query/lp/linear_oracle.hpp"
#include "query/lp/seidel.hpp"

namespace plumb::linear_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::uint64_t cases = battery::sanitized ? 40 : 200;

template <class Answer>
std::vector<mpq_class> point_of(const Answer& a) {
  std::vector<mpq_class> r;
  for (const Rational& x : proof_of(a).point) r.push_back(mpq(x));
  return r;
}

/// What does not depend on the order of the constraints.
template <class Answer>
void expect_same_points(const Answer& a, const Answer& b, const std::string& about) {
  EXPECT_EQ(a.kind, b.kind) << about;
  EXPECT_EQ(a.is_unique, b.is_unique) << about;
  EXPECT_EQ(a.at, b.at) << about;
  EXPECT_EQ(a.ray, b.ray) << about;
  const LinearProof p = proof_of(a), q = proof_of(b);
  EXPECT_EQ(p.point, q.point) << about;
  EXPECT_EQ(p.ray, q.ray) << about;
}

struct Counts {
  std::array<int, 3> kind{};
  int tied = 0, zero_coordinate = 0, far_from_dimension = 0;
};

template <std::size_t D>
void expect_as_simplex(Class c, Counts& counts) {
  for (std::uint64_t index = 0; index < cases; ++index) {
    Maker maker(c, index);
    const Program<D> p = maker.program<D>();
    const std::string about = maker.about(p);
    const Wanted w = wanted(p);
    const auto answer = maximize(p.direction, p.halfspaces);
    ASSERT_EQ(answer.kind, w.kind) << about;
    ++counts.kind[static_cast<std::size_t>(w.kind)];
    EXPECT_EQ(answer.is_unique, w.is_unique) << about;
    EXPECT_TRUE(verify(p.direction, p.halfspaces, proof_of(answer))) << about;
    if (w.kind != LinearKind::infeasible) {
      EXPECT_EQ(point_of(answer), w.point) << about;
      EXPECT_EQ(answer.at, approximate(exact_point(answer))) << about;
      for (const auto& n : answer.corner) counts.zero_coordinate += n.number == no_constraint ? 1 : 0;
    }
    counts.tied += w.kind == LinearKind::optimal && !w.is_unique ? 1 : 0;
    counts.far_from_dimension += answer.deciding_count < D ? 1 : 0;
    for (const std::uint64_t seed : {1ull, 77ull, ~0ull})
      EXPECT_EQ(maximize(p.direction, p.halfspaces, {seed}), answer) << about;
    Program<D> turned = p;
    for (std::size_t i = turned.halfspaces.size(); i > 1; --i)
      std::swap(turned.halfspaces[i - 1], turned.halfspaces[maker.entropy().below(i)]);
    const auto other = maximize(turned.direction, turned.halfspaces);
    expect_same_points(answer, other, about);
    EXPECT_TRUE(verify(turned.direction, turned.halfspaces, proof_of(other))) << about;
  }
}

template <std::size_t D>
void expect_every_class() {
  Counts all;
  for (const Class c : all_classes) {
    Counts counts;
    expect_as_simplex<D>(c, counts);
    EXPECT_GT(counts.kind[0], static_cast<int>(cases) / 30) << "class " << static_cast<int>(c);
    for (std::size_t k = 0; k < 3; ++k) all.kind[k] += counts.kind[k];
    all.tied += counts.tied, all.zero_coordinate += counts.zero_coordinate;
    all.far_from_dimension += counts.far_from_dimension;
  }
  const int total = static_cast<int>(cases * all_classes.size());
  EXPECT_GT(all.kind[1], total / 10) << "infeasible";
  EXPECT_GT(all.kind[2], total / 10) << "unbounded";
  EXPECT_GT(all.tied, total / 20);
  EXPECT_GT(all.zero_coordinate, total / 50);
  EXPECT_GT(all.far_from_dimension, total / 20);
}

TEST(LinearProgram, InThePlaneIsThatOfTheSimplexMethod) { expect_every_class<2>(); }
TEST(LinearProgram, InSpaceIsThatOfTheSimplexMethod) { expect_every_class<3>(); }

/// One that proves nothing any more.
template <std::size_t D>
void expect_false_proofs_refused(Class c, std::array<int, 3>& refused) {
  for (std::uint64_t index = 0; index < cases / 4; ++index) {
    Maker maker(c, index);
    const Program<D> p = maker.program<D>();
    const LinearProof proof = proof_of(maximize(p.direction, p.halfspaces));
    const auto direction = array_of(p.direction);
    const bool has_direction = std::ranges::any_of(direction, [](double x) { return x != 0; });
    const auto refuse = [&](const LinearProof& mutant, const char* what) {
      ++refused[static_cast<std::size_t>(proof.kind)];
      EXPECT_FALSE(verify(p.direction, p.halfspaces, mutant)) << what << '\n' << maker.about(p);
    };
    for (std::size_t i = 0; i < proof.weights.size(); ++i) {
      LinearProof m = proof;
      m.weights[i].constraint = p.halfspaces.size();
      refuse(m, "constraint");
      const auto normal = array_of(p.halfspaces[proof.weights[i].constraint].normal);
      if (std::ranges::any_of(normal, [](double x) { return x != 0; })) {
        m = proof, m.weights[i].weight = m.weights[i].weight + 1;
        refuse(m, "weight");
        m = proof, m.weights.erase(m.weights.begin() + static_cast<std::ptrdiff_t>(i));
        refuse(m, "left out");
      }
      m = proof, m.weights.push_back({proof.weights[i].constraint, -1}),
      m.weights.push_back({proof.weights[i].constraint, 1});
      refuse(m, "negative");
    }
    LinearProof m = proof;
    if (proof.kind == LinearKind::optimal && has_direction) {
      for (std::size_t k = 0; k < D; ++k) m.point[k] = m.point[k] + Rational(direction[k]);
      refuse(m, "better point");
      m = proof, m.kind = LinearKind::infeasible;
      refuse(m, "kind");
      m = proof, m.point.pop_back();
      refuse(m, "too few");
    }
    if (proof.kind == LinearKind::unbounded) {
      for (Rational& x : m.ray) x = -x;
      refuse(m, "ray");
      m = proof, m.ray = std::vector<Rational>(D);
      refuse(m, "no ray");
      m = proof, m.kind = LinearKind::optimal;
      refuse(m, "kind");
    }
    if (proof.kind == LinearKind::infeasible) {
      m.kind = LinearKind::optimal;
      refuse(m, "kind");
      m = proof, m.weights.clear();
      refuse(m, "nothing");
    }
  }
}

TEST(LinearProgram, FalseProofsAreRefused) {
  std::array<int, 3> refused{};
  for (const Class c : all_classes) {
    expect_false_proofs_refused<2>(c, refused);
    expect_false_proofs_refused<3>(c, refused);
  }
  for (const int n : refused) EXPECT_GT(n, 50);
}

/// The point of three planes, where they have one.
std::vector<mpq_class> meeting(const std::array<Halfspace3, 3>& h) {
  const auto minor = [&](std::size_t i, std::size_t j, std::size_t u, std::size_t v) {
    const auto a = array_of(h[i].normal), b = array_of(h[j].normal);
    return mpq_class(mpq_class(a[u]) * b[v] - mpq_class(a[v]) * b[u]);
  };
  const auto first = array_of(h[0].normal);
  mpq_class whole;
  for (std::size_t k = 0; k < 3; ++k) whole += first[k] * minor(1, 2, (k + 1) % 3, (k + 2) % 3);
  if (sgn(whole) == 0) return {};
  std::vector<mpq_class> r;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    r.emplace_back(
        (h[0].offset * minor(1, 2, u, v) + h[1].offset * minor(2, 0, u, v) + h[2].offset * minor(0, 1, u, v)) / whole);
  }
  return r;
}
mpq_class value(const Vector3& v, const std::vector<mpq_class>& at) {
  return mpq_class(v.x * at[0] + v.y * at[1] + v.z * at[2]);
}

TEST(LinearProgram, InABoxIsTheFirstOfTheBestCorners) {
  int solved = 0;
  for (std::uint64_t index = 0; index < cases / 4; ++index) {
    Maker maker(Class::boxed, index);
    const Program<3> p = maker.program<3>();
    const auto& h = p.halfspaces;
    std::vector<mpq_class> best;
    for (std::size_t i = 0; i < h.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          std::vector<mpq_class> at = meeting({h[i], h[j], h[k]});
          if (at.empty() || std::ranges::any_of(h, [&](const auto& c) { return value(c.normal, at) > c.offset; }))
            continue;
          const int order = best.empty() ? 1 : cmp(value(p.direction, at), value(p.direction, best));
          if (order > 0 || (order == 0 && at < best)) best = std::move(at);
        }
      }
    }
    const LinearAnswer3 answer = maximize(p.direction, h);
    EXPECT_EQ(answer.kind, best.empty() ? LinearKind::infeasible : LinearKind::optimal) << maker.about(p);
    if (best.empty()) continue;
    EXPECT_EQ(point_of(answer), best) << maker.about(p);
    ++solved;
  }
  EXPECT_GT(solved, static_cast<int>(cases) / 20);
}

/// Searched in the order given, without a guess: a later constraint, which ended a plane, bounds a line of it below.
TEST(LinearProgram, WhatSeidelNamesContradictsItself) {
  struct Case {
    query::Numbers<3> direction;
    std::vector<Halfspace3> halfspaces;
  };
  const std::vector<Case> all{{{0, -2, -1},
                               {{{1, 1, 1}, 3},
                                {{-1, 3, 2}, 1},
                                {{3, 2, 3}, -2},
                                {{3, 1, 1}, -1},
                                {{-3, 1, 0}, 1},
                                {{3, 0, -2}, -3},
                                {{-2, -3, -3}, -1}}},
                              {{1, -2, -2},
                               {{{-2, 0, 1}, 1},
                                {{1, 2, -1}, -2},
                                {{2, -1, 2}, 3},
                                {{2, -1, 1}, 1},
                                {{1, 2, 1}, -1},
                                {{0, -1, 0}, 0},
                                {{-2, 1, -2}, 1},
                                {{1, 1, 2}, 3}}}};
  for (const auto& [direction, halfspaces] : all) {
    std::vector<NamedHalfspace3> named;
    for (const Halfspace3& h : halfspaces) named.push_back({h, static_cast<std::uint32_t>(named.size())});
    query::Seidel<3> search({direction}, named);
    ASSERT_FALSE(search.solve());
    std::vector<Halfspace3> contradiction;
    for (const auto& p : search.contradiction()) {
      if (p.number < halfspaces.size()) contradiction.push_back(halfspaces[p.number]);
    }
    EXPECT_EQ(maximize(Vector3{0, 0, 0}, contradiction).kind, LinearKind::infeasible);
  }
}

TEST(LinearProgram, OfAPyramid) {
  // The planes x + z <= 1 and their like through (0, 0, 1).
  const std::vector<Halfspace3> pyramid{
      {{1, 0, 1}, 1}, {{-1, 0, 1}, 1}, {{0, 1, 1}, 1}, {{0, -1, 1}, 1}, {{0, 0, -1}, 0}};
  const LinearAnswer3 top = maximize(Vector3{0, 0, 1}, pyramid);
  EXPECT_EQ(top.kind, LinearKind::optimal);
  EXPECT_TRUE(top.is_unique);
  EXPECT_EQ(top.at, (Point3{0, 0, 1}));
  EXPECT_EQ(top.deciding_count, 2u);
  const LinearAnswer3 down = maximize(Vector3{0, 0, -1}, pyramid);  // the base: its first corner
  EXPECT_FALSE(down.is_unique);
  EXPECT_EQ(down.at, (Point3{-1, -1, 0}));
  EXPECT_EQ(down.deciding_count, 1u);
  EXPECT_EQ(down.deciding[0].number, 4u);
  const LinearAnswer3 out = maximize(Vector3{0, 0, -1}, std::span(pyramid).first(4));
  EXPECT_EQ(out.kind, LinearKind::unbounded);
  EXPECT_EQ(out.ray, (Vector3{-1, -1, -1}));
}

TEST(LinearProgram, WhereNoneComesFirst) {
  // Nothing, a halfspace, a slab: the optimal points are planes or all of space.
  const LinearAnswer3 space = maximize(Vector3{0, 0, 0}, std::span<const Halfspace3>{});
  EXPECT_EQ(space.kind, LinearKind::optimal);
  EXPECT_FALSE(space.is_unique);
  EXPECT_EQ(space.at, (Point3{0, 0, 0}));
  const std::vector<Halfspace3> slab{{{0, 0, 1}, 3}, {{0, 0, -1}, -2}, {{-1, 0, 0}, 5}};
  EXPECT_EQ(maximize(Vector3{0, 0, 2}, slab).at, (Point3{-5, 0, 3}));
  EXPECT_EQ(maximize(Vector3{0, 0, 0}, slab).at, (Point3{-5, 0, 2}));
  EXPECT_EQ(maximize(Vector3{0, 1, 0}, slab).kind, LinearKind::unbounded);
  const std::vector<Halfspace2> right{{{1, 0}, 7}};
  EXPECT_EQ(maximize(Vector2{0, 0}, right).at, (Point2{7, 0}));  // x has no least
}

TEST(LinearProgram, ZeroNormalsHoldEverywhereOrNowhere) {
  const std::vector<Halfspace2> all{{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 1}};
  EXPECT_EQ(maximize(Vector2{1, 1}, all).at, (Point2{1, 1}));
  const std::vector<Halfspace2> none{{{1, 0}, 1}, {{0, -0.0}, -0x1p-1074}};
  const LinearAnswer2 answer = maximize(Vector2{1, 1}, none);
  EXPECT_EQ(answer.kind, LinearKind::infeasible);
  EXPECT_TRUE(verify(Vector2{1, 1}, none, proof_of(answer)));
  EXPECT_THAT([&] { (void)exact_point(answer); }, ThrowsMessage<DegeneratePoint>(HasSubstr("infeasible")));
}

TEST(LinearProgram, OfAnUlp) {
  const double third = 1.0 / 3;
  const auto slab = [&](double most) {
    return std::vector<Halfspace3>{{{3, 1, 0}, most}, {{-3, 0, 0}, -1}, {{0, -1, 0}, 0}, {{0, 0, 1}, third}};
  };
  EXPECT_EQ(maximize(Vector3{0, 0, 1}, slab(1)).kind, LinearKind::optimal);
  const LinearAnswer3 none = maximize(Vector3{0, 0, 1}, slab(std::nextafter(1, 0)));
  EXPECT_EQ(none.kind, LinearKind::infeasible);
  EXPECT_EQ(none.deciding_count, 3u);
  EXPECT_TRUE(verify(Vector3{0, 0, 1}, slab(std::nextafter(1, 0)), proof_of(none)));
  EXPECT_FALSE(verify(Vector3{0, 0, 1}, slab(1), proof_of(none)));
}

TEST(LinearProgram, ManyConstraintsOfOneSphere) {
  // Tangent planes of whole normals, all through one point but one; the simplex method judges.
  Program<3> p{{1, 2, 3}, {}};
  Entropy entropy(9420);
  const auto number = [&] { return static_cast<double>(entropy.within(1000)); };
  for (int i = 0; i < (battery::sanitized ? 100 : 600); ++i) {
    const Vector3 n{number(), number(), number()};
    p.halfspaces.push_back({n, n.x * 5 + n.y * 7 - n.z * 11 + (i % 2 == 0 ? 0 : 1)});
  }
  const Wanted w = wanted(p);
  const LinearAnswer3 answer = maximize(p.direction, p.halfspaces);
  ASSERT_EQ(answer.kind, w.kind);
  EXPECT_EQ(point_of(answer), w.point);
  for (const std::uint64_t seed : {3ull, 4ull}) EXPECT_EQ(maximize(p.direction, p.halfspaces, {seed}), answer);
  std::vector<NamedHalfspace3> scratch;
  EXPECT_EQ(maximize(p.direction, p.halfspaces, scratch), answer);
  EXPECT_EQ(maximize(p.direction, p.halfspaces, scratch), answer);
}

TEST(LinearProgram, NumbersThatAreNoneThrow) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const std::vector<Halfspace3> good{{{1, 0, 0}, 1}};
  EXPECT_THAT(
      [&] {
        (void)maximize(Vector3{0, nan, 0}, good);
      },
      ThrowsMessage<NonFinite>(HasSubstr("maximize: direction")));
  const std::vector<Halfspace3> bad{{{1, 0, 0}, 1}, {{0, 1, 0}, infinite}};
  EXPECT_THAT(
      [&] {
        (void)maximize(Vector3{0, 0, 1}, bad);
      },
      ThrowsMessage<NonFinite>(HasSubstr("maximize: constraints[1].offset is inf")));
  const std::vector<Halfspace2> flat{{{1, nan}, 1}};
  EXPECT_THAT(
      [&] {
        (void)maximize(Vector2{0, 1}, flat);
      },
      ThrowsMessage<NonFinite>(HasSubstr("maximize: constraints[0].normal.y is nan")));
  EXPECT_THAT([&] { (void)linear_system(flat); }, ThrowsMessage<NonFinite>(HasSubstr("linear_system: halfspaces[0]")));
  const double most = std::numeric_limits<double>::max();  // whose sums are no doubles
  const std::vector<Halfspace3> large{{{most, most, most}, most}, {{-most, most, 0}, most}};
  EXPECT_TRUE(verify(Vector3{most, most, most}, large, proof_of(maximize(Vector3{most, most, most}, large))));
}

}  // namespace
}  // namespace plumb::linear_cases
