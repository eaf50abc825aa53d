// What do the questions about pairs of convex polyhedra refuse, and what does a pose do to them?
#pragma once

#include "plumb/query/vclip/vclip.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query::vclipping {

BodyView body_view(const ClipView& v);

/// Throws InvalidShape where there are no faces.
void require_faces(std::string_view function, std::string_view name, const ClipView& v);

/// Of the pose's matrix: negative of a mirrored solid, zero of a flattened one.
Sign turn_of(const ClipView& v);

/// Of the distance, by the exact search of any two.
Rational exact_square(const ClipView& a, const ClipView& b);

}  // namespace plumb::query::vclipping
