// How large is what is round under a pose?  The radius of the image, where the image is as round.
//
// Laws: exact; zero of what is flat.  A pose whose columns are not at right angles and of one length, which is rational,
// throws UnevenPose.
// Source: RTCD 3.2.
// Cost: GMP; two integer roots.
#pragma once

#include "query/convex/posed_set.hpp"

namespace plumb::query {

/// `s` is posed_set(figure).
mpq_class radius_of_image(std::string_view function, const PosedView& figure, const PosedSet& s);

}  // namespace plumb::query
