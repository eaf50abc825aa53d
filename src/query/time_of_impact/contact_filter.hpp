// Continuous collision detection: do they meet while they move?  Plain doubles with proved bounds, for nearly all that
// is asked.
//
// Laws, of finite coordinates: (1) yes and no are certain; unsure says nothing.  What overflows ends as unsure.
// (2) The time of a first contact is in its ball.
// Every decision is a sign of products of two or three of the differences between a vertex of one figure and a vertex
// of the other.  Over a piece of time the products' Bernstein coefficients bound them: all of one sign decide.  Pieces
// are halved, at most some eighty times.  A piece is left where, along some axis, the projections of the figures stay
// apart, or where the cubic has no root.  They meet in it where the cubic has a root and the projections cross strictly
// throughout.  A root that is alone in a small piece is looked at closely (contact_at_root.hpp).
// Source: RTCD 5.5, 11.2; Bernstein polynomials and polar forms (Farouki 2012); bounds: swept_signs.hpp.
// Cost: 20 ns where coordinates stay apart, 60 ns where the cubic has one sign, some 50 ns a piece, 2 us a close look.
#pragma once

#include <optional>
#include <span>

#include "plumb/arith/ball.hpp"
#include "query/time_of_impact/contact_at_root.hpp"

namespace plumb::query::moving {

struct ContactQuestion {
  MovingKind kind;
  std::array<Point3, 4> at_0, at_1;
};

enum class ContactVerdict : unsigned char { no, yes, unsure };

ContactVerdict contact_filter(const ContactQuestion& question);

/// Of a yes, the first contact: strictly within the triangle's face, or within both edges.
struct FilteredContact {
  ContactVerdict verdict;
  std::optional<Ball> time;
};
FilteredContact first_contact_filter(const ContactQuestion& question);

}  // namespace plumb::query::moving
