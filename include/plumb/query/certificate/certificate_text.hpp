// Certificates as text: JSON that holds a certificate and both of its bodies, to be kept, sent, and checked by other
// programs.
//
//   const std::string text = certificate_text(relate_with_proof(a, b), a, b);       one line
//   verify(read_certificate(text));                                                 or: docs/verify_certificate.py FILE
//
//   {"claim": "touching", "direction": ["2", "3", "6"], "pairs": [{"a": 7, "b": 0, "weight": "1"}],
//    "a": {"min": [...], "max": [...]}, "b": {"vertices": [[...]], "radius": "0x1.cp+2"}}
//
// Numbers are texts: fractions "-3/8", integers "5", or hexadecimal doubles "0x1.8p-3"; those of bodies are doubles.  A
// body is its "vertices"; or these, one or two, and a "radius"; a box from "min" to "max"; the "center", "axes" and
// "half" of an oriented box or a rectangle; the "corner", "edges" and "radius" of a lozenge; each with a "pose" of
// "columns" and "translation" where it stands under one, or of "turn" and "translation", or of "links" that are such.  A distance has the claim "distance", its "square" and
// "inset", and the "distance" rounded, "infinity" beyond all doubles.  docs/convex.md has the grammar.
// Laws: (1) what is read says the same as what was written: the same numbers, corners by the same numbers, the same
// verdict. (2) A text of any content is read or refused; what is not of the grammar is refused, members that are not
// known or given twice among it.  (3) docs/verify_certificate.py proves the same texts and refuses the same.
// A text that is no certificate throws Error, which names its place: "read_certificate: pairs[2].weight is ...".  What
// is no body throws InvalidShape or NonFinite, as in query/certificate/certificate.hpp.
// Source: RFC 8259; RTCD 9.1.
// Cost: some microseconds a number.  Nothing is searched.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "plumb/query/certificate/verify.hpp"

namespace plumb {

/// A body as it was read; the first of these is a hull.
struct RecordedBody {
  std::variant<std::vector<Point3>, Sphere3, Capsule3, Lozenge3, Aabb3, Obb3, Rectangle3> shape;
  AnyPose pose;
};

struct RecordedProof {
  std::variant<Certificate, DistanceCertificate> proof;
  RecordedBody a, b;
};

RecordedProof read_certificate(std::string_view text);
ProofVerdict verify(const RecordedProof& recorded);

namespace query {

std::string text_of_proof(const Certificate& certificate, const BodyView& a, const BodyView& b);
std::string text_of_proof(const DistanceCertificate& certificate, const BodyView& a, const BodyView& b);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
std::string certificate_text(const Certificate& certificate, const A& a, const B& b) {
  return query::text_of_proof(certificate, query::body_view(a), query::body_view(b));
}

template <ConvexBody3 A, ConvexBody3 B>
std::string certificate_text(const DistanceCertificate& certificate, const A& a, const B& b) {
  return query::text_of_proof(certificate, query::body_view(a), query::body_view(b));
}

}  // namespace plumb
