// Bounding boxes, separating plane: is a polygon certainly apart from another figure?  By boxes around both, and by the
// polygon's plane.
//
// Law: where the answer is yes they are disjoint; otherwise nothing is known.
// Source: RTCD 4.2.1, 5.2.2.
// Cost: some ns a vertex.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// Three of its vertices that are not on one line, where there are such.
using SpanOfPolygon = std::optional<std::array<Point3, 3>>;

bool are_surely_apart(const FlatView& polygon, const SpanOfPolygon& span, const FlatView& other);

}  // namespace plumb::query
