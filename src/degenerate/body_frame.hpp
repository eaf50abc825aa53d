// How do two bodies that stand on one plane come into space?  The integer map for both, and the normal of the plane.
//
// Laws: an aabb among them has its axes where the map makes them those of space; rigid shapes get a similarity.
// Source: none.  Cost: below 100 ns.
#pragma once

#include "degenerate/body.hpp"

namespace plumb::degenerate {

struct FrameOrder {
  int dimension = 3;
  bool rigid = false, aabb = false;
  bool slabs = false;    // the ground may have the directions of a k-DOP
  int aabb_feature = 0;  // on which it is to stand
};

IntMap frame_of(const FrameOrder& order, Entropy& entropy);

/// The axes of an aabb in the body's own coordinates; mirrored for one below the ground.
std::array<Int3, 3> aabb_axes(const IntMap& frame, bool mirrored);

/// Of the image of the ground, toward the image of what is above.
Int3 normal_of(const IntMap& frame, int dimension);

}  // namespace plumb::degenerate
