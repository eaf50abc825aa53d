// Which box of space holds a figure of those that are kept by the thousand?  Those of the plane lie in z = 0.
//
// Law: its numbers are those of the figure.
// Cost: comparisons.
#pragma once

#include "figure/basic/in_space.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {

inline Aabb3 box_in_space(const Triangle3& t) { return box_around(t.a, t.b, t.c); }
inline Aabb3 box_in_space(const Triangle2& t) { return box_in_space(in_space(t)); }
inline Aabb3 box_in_space(const Segment3& s) { return box_around(s.a, s.b, s.b); }
inline Aabb3 box_in_space(const Segment2& s) { return box_in_space(in_space(s)); }
inline const Aabb3& box_in_space(const Aabb3& b) { return b; }
inline Aabb3 box_in_space(const Aabb2& b) { return in_space(b); }

}  // namespace plumb::space
