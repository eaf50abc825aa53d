// Do two convex figures meet, with a proof?
//
// Laws: proved(a, b) is what relate tells, in words; a certificate of the same claim is looked for and verified, which
// takes nothing but the corners, and the figures the other way round must be answered alike.  `in_space` is the figure of
// the plane as one of space, at z = 0.
#pragma once

#include <gtest/gtest.h>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/certificate/certificate.hpp"
#include "plumb/query/certificate/verify.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"

namespace plumb::docs {

template <class A, class B>
std::string proved(const A& a, const B& b) {
  const Relation relation = relate(a, b);
  EXPECT_EQ(relate(b, a), relation);
  const Certificate proof = relate_with_proof(a, b);
  const auto verdict = verify(proof, a, b);
  EXPECT_TRUE(verdict) << verdict.flaw;
  EXPECT_EQ(name_of(proof.claim), told(relation));
  return told(relation);
}

inline Point3 in_space(const Point2& p) { return {p.x, p.y, 0}; }
inline Segment3 in_space(const Segment2& s) { return {in_space(s.a), in_space(s.b)}; }
inline Triangle3 in_space(const Triangle2& t) { return {in_space(t.a), in_space(t.b), in_space(t.c)}; }

/// The same of figures of the plane.
template <class A, class B>
std::string proved_flat(const A& a, const B& b) {
  EXPECT_EQ(told(relate(a, b)), proved(in_space(a), in_space(b)));
  return told(relate(a, b));
}

}  // namespace plumb::docs
