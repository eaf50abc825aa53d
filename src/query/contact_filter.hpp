// Do they meet while they move?  Plain doubles with proved bounds, for nearly all that is asked.
//
// Laws: (1) yes and no are certain; unsure says nothing.  NaN and infinities end as unsure, as do overflows.
// Every decision is a sign of products of two or three of the differences between a vertex of one figure and a vertex
// of the other.  Over a piece of time the products' Bernstein coefficients bound them: all of one sign decide.  Pieces
// are halved, at most some eighty times.  A piece is left where, along some axis, the projections of the figures stay
// apart; or where the cubic has no root.  They meet in it where the cubic has a root and the projections cross strictly
// throughout.  Coefficients come with one absolute bound for each product. Source: RTCD 5.5, 11.2; Bernstein
// polynomials and polar forms (Farouki 2012); bounds: contact_filter.cpp. Cost: 20 ns where coordinates stay apart, 60
// ns where the cubic has one sign, some 50 ns a piece.
#pragma once

#include <span>

#include "plumb/arith/point.hpp"
#include "query/feature_pairs.hpp"

namespace plumb::query::moving {

enum class Verdict : unsigned char { no, yes, unsure };

Verdict contact_filter(MovingKind kind, std::span<const Point3, 4> at_0, std::span<const Point3, 4> at_1);

}  // namespace plumb::query::moving
