// Bounding volume (capsule, lozenge): where might the core of a swept sphere lie that holds these balls?  In plain
// doubles; radii are found for certain later.
//
// Source: RTCD 4.5; Larsen and others 1999: the core may end before the outermost balls, by what the radius reaches.
// Cost: two passes.
#pragma once

#include <string_view>
#include <vector>

#include "figure/measures/local_frame.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::swept {

/// In local coordinates of the frame.
struct LocalBall {
  Vector3 center;
  double radius;
};

/// With radius 0: along the first axis, and in the plane of the first two, with ends of several kinds.
Capsule3 guess_capsule(const figure::LocalFrame& frame, const std::vector<LocalBall>& balls);
std::vector<Lozenge3> guess_lozenges(const figure::LocalFrame& frame, const std::vector<LocalBall>& balls);

/// A guess of the plane, which roundings may have lifted out of it.
inline Capsule2 flattened(const Capsule3& c) { return {{c.a.x, c.a.y}, {c.b.x, c.b.y}, c.radius}; }

/// Are all its numbers finite?
bool is_finite(const Capsule3& c);
bool is_finite(const Lozenge3& l);

/// The one of least volume, about; the first of those that are equally large.  Throws BeyondDoubles for none.
Capsule3 smallest(std::string_view function, const std::vector<Capsule3>& candidates);
Lozenge3 smallest(std::string_view function, const std::vector<Lozenge3>& candidates);

}  // namespace plumb::figure::swept
