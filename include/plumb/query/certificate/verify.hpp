// Checking certificates: do these numbers prove how two convex bodies lie?
//
//   if (const ProofVerdict verdict = verify(proof, a, b); !verdict) std::cerr << verdict.flaw;
//
// Laws: (1) it holds exactly where the conditions of query/certificate/certificate.hpp do, and what they do not ask for
// is absent.  (2) A certificate of any content is judged: vertices that there are not, weights of any sign, directions
// of zero are flaws, not errors; `flaw` names the first.
// What is no body throws as in query/certificate/certificate.hpp, but that of a polyhedron its vertices alone are
// looked at. src/query/certificate/verify.cpp can be read in two minutes and searches for nothing;
// docs/verify_certificate.py is the same in Python.
// Source: RTCD 9.1; Mehlhorn et al., Checking geometric programs, 1999.
// Cost: rationals: some 2 us a vertex.  Nothing is searched: each vertex is looked at once.
#pragma once

#include <string>

#include "plumb/query/certificate/certificate.hpp"

namespace plumb {

struct ProofVerdict {
  std::string flaw;  // empty: there is none
  explicit operator bool() const { return flaw.empty(); }
};

namespace query {

ProofVerdict verdict_on(const Certificate& certificate, const BodyView& a, const BodyView& b);
ProofVerdict verdict_on(const DistanceCertificate& certificate, const BodyView& a, const BodyView& b);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
ProofVerdict verify(const Certificate& certificate, const A& a, const B& b) {
  return query::verdict_on(certificate, query::body_view(a), query::body_view(b));
}

template <ConvexBody3 A, ConvexBody3 B>
ProofVerdict verify(const DistanceCertificate& certificate, const A& a, const B& b) {
  return query::verdict_on(certificate, query::body_view(a), query::body_view(b));
}

}  // namespace plumb
