// Contact manifold: where do two convex bodies touch, or nearly touch, or how deep are they in one another?  The
// normal, the signed distance, and the corners of the contact with names that stay the same from frame to frame.
//
//   ContactCache cache;                                       kept by the caller for each pair, from frame to frame
//   const auto m = contact(box, ground, {.margin = 0.01}, &cache);
//   if (m) for (const ContactCorner& c : m->corners) { c.on_a; c.on_b; c.distance; c.id; }
//   exact_contact(box, ground)                                the same without any rounding
//
// Of each body the feature that faces the other takes part: of the faces that hold what of the body is farthest along
// the normal, the one that is most nearly at right angles to it; a body without faces has an edge or a vertex.  Both
// are seen along the normal.  The corners are those of what they have in common there: a vertex of one within the
// other's face, or two edges that cross; each is a point of each feature's plane, one straight ahead of the other.
// Laws: (1) Every decision is that of real arithmetic; numbers are the exact values, each rounded once.  (2) `distance`
// is below zero where the bodies must move to be parted: it is minus penetration's depth, and the distance of
// distance() where they are disjoint.  `normal` leads from a to b: along the nearest points, or against penetration's
// direction, which also decides between several.  (3) There is no contact where the distance is above the margin. 
// Corners that are farther apart along the normal than the margin are left out; the deepest one is never.  (4) A
// corner's id names a feature of each body: vertex and face, face and vertex, edge and edge; where a vertex lies
// straight before an edge or a vertex, these. Corners ascend by id, and no id occurs twice.  As long as the features
// that face each other and the signs that tell how they lie stay the same, so do the ids; which of the bodies has the
// deepest feature, and which edges or faces gave the normal, is no part of them.  (5) A cache changes no bit of an
// answer, whatever it was used for before: what it tells again it compares, what it guesses it proves.  (6) contact(b,
// a) is the same with both turned round, where penetration's direction is the only one.  A common translation and a
// common power of two change no id.  (7) Round bodies are their cores and a radius: corners are those of the cores,
// moved along the normal by the radii; features have the numbers of the surface.  (8) `at_most` keeps the deepest
// corner, and then each time the one whose rounded place on a is farthest from the nearest of those kept, of several
// the first.  (9) Faces of a polyhedron that lie in one plane are one, by the lowest number; a hull by its vertices
// alone has the feature that is farthest, and no other. Features are numbered as in query/penetration/penetration.hpp.
// NaN and infinity throw NonFinite, an empty body, a negative radius, a polygon that is not planar and convex and a
// negative margin InvalidShape, UnevenPose as for penetration, by name.
// Source: RTCD 9.5.3; Gregorius, Robust Contact Creation for Physics Simulations, 2015, on manifolds by clipping; van
// den Bergen 2001.
// Cost: docs/contacts.md; no allocation up to eight corners where doubles decide.  Bounded by n^2 log n signs for n
// corners of both, on integers as long as the exponents' span.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "plumb/arith/exact_vector.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/query/penetration/penetration.hpp"

namespace plumb {

/// A feature of each body.
struct ContactId {
  Feature a, b;
  friend constexpr bool operator==(const ContactId&, const ContactId&) = default;
  /// Ids are ordered by a's feature, then by b's: vertices before edges before faces, then by number.
  friend constexpr std::strong_ordering operator<=>(const ContactId& p, const ContactId& q) {
    if (const auto order = p.a.kind <=> q.a.kind; order != 0) return order;
    if (const auto order = p.a.index <=> q.a.index; order != 0) return order;
    if (const auto order = p.b.kind <=> q.b.kind; order != 0) return order;
    return p.b.index <=> q.b.index;
  }
};

struct ContactCorner {
  Point3 on_a, on_b;
  double distance;  // from a to b along the normal; below zero where they overlap there
  ContactId id;
  friend bool operator==(const ContactCorner&, const ContactCorner&) = default;
};

/// A list that takes memory beyond eight.
class ContactCorners {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const ContactCorner* begin() const { return size_ <= few_.size() ? few_.data() : many_.data(); }
  [[nodiscard]] const ContactCorner* end() const { return begin() + size_; }
  [[nodiscard]] const ContactCorner& operator[](std::size_t i) const { return begin()[i]; }
  void push_back(const ContactCorner& c) {
    if (size_ < few_.size()) {
      few_[size_] = c;
    } else {
      if (size_ == few_.size()) many_.assign(few_.begin(), few_.end());
      many_.push_back(c);
    }
    ++size_;
  }
  friend bool operator==(const ContactCorners& p, const ContactCorners& q) {
    if (p.size() != q.size()) return false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p[i] != q[i]) return false;
    }
    return true;
  }

 private:
  std::array<ContactCorner, 8> few_;
  std::vector<ContactCorner> many_;
  std::size_t size_ = 0;
};

struct ContactManifold {
  Relation relation;  // overlapping: they must move to be parted
  Vector3 normal;     // from a to b, of length 1, but for rounding
  double distance;
  ContactCorners corners;
  friend bool operator==(const ContactManifold&, const ContactManifold&) = default;
};

struct ExactContactCorner {
  RationalPoint3 on_a, on_b;  // of the cores; of what is not round, the points themselves
  Rational along;             // from the one to the other, as a multiple of the direction
  ContactId id;
};

/// The distance of the deepest corner is along * |direction| - radius_a - radius_b, and of each corner likewise.
struct ExactContact {
  Relation relation;
  ExactVector3 direction;  // integers without a common factor
  Rational along;
  Rational radius_a, radius_b;
  std::vector<ExactContactCorner> corners;
};

struct ContactManifoldOptions {
  double margin = 0;        // bodies no farther apart than this have a contact
  std::size_t at_most = 0;  // corners; 0 for all of them
};

namespace query {

std::optional<ContactManifold> contact_of(const BodyView& a, const BodyView& b, const ContactManifoldOptions& options,
                                          ContactCache* cache);
/// The same of figures whose kinds are known at run time alone; a recorder keeps it (query/variant/question_recorder.hpp).
std::optional<ContactManifold> any_contact_of(const BodyView& a, const BodyView& b,
                                              const ContactManifoldOptions& options, ContactCache* cache);
std::optional<ExactContact> exact_contact_of(const BodyView& a, const BodyView& b, double margin);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
std::optional<ContactManifold> contact(const A& a, const B& b, const ContactManifoldOptions& options = {},
                                       ContactCache* cache = nullptr) {
  if constexpr (std::same_as<A, AnyFigure> || std::same_as<B, AnyFigure>) {
    return query::any_contact_of(query::body_view(a), query::body_view(b), options, cache);
  } else {
    return query::contact_of(query::body_view(a), query::body_view(b), options, cache);
  }
}

template <ConvexBody3 A, ConvexBody3 B>
std::optional<ExactContact> exact_contact(const A& a, const B& b, double margin = 0) {
  return query::exact_contact_of(query::body_view(a), query::body_view(b), margin);
}

}  // namespace plumb
