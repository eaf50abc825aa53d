// How do two bodies that stand on one plane come into space?  The integer map for both, and the normal of the plane.
//
// Laws: aligned shapes among them have their axes where the map makes them those of space; rigid shapes get a
// similarity.
// Source: none.
// Cost: below 100 ns.
#pragma once

#include "degenerate/body.hpp"

namespace plumb::degenerate {

struct FrameOrder {
  int dimension = 3;
  bool rigid = false, aabb = false, k_dop = false;
  bool slabs = false;       // the ground may have a direction of k-DOPs
  int aligned_feature = 0;  // on which the aligned ones are to stand
};

IntMap frame_of(const FrameOrder& order, Entropy& entropy);

/// The axes of space in the body's own coordinates; mirrored for one below the ground.
std::array<Int3, 3> axes_of_space(const IntMap& frame, bool mirrored);

/// Of the image of the ground, toward the image of what is above.
Int3 normal_of(const IntMap& frame, int dimension);

}  // namespace plumb::degenerate
