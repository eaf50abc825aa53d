// Which numbers is a box given by: as it stands, and under a pose?
//
// Under a pose twice a corner is 2 at + (columns local + the axes, each times its length up or down) / weight, so that boxes
// of two poses, all of it times both weights, are sums of products of given numbers, and nothing is divided.
// Laws: exact; of what is told nothing was rounded.
// Source: RTCD 4.4; query/body/weighted_pose.hpp.
// Cost: none.
#pragma once

#include <array>

#include "plumb/arith/point.hpp"

namespace plumb::query {

/// A box by numbers as given, everything times two.
struct GivenBox {
  struct Ends {
    double from, to;  // their difference is meant
  };
  static constexpr double weight = 1;
  std::array<Vector3, 3> axes;
  std::array<Ends, 3> length, middle;
};

/// And under a pose; `axes` are its own by the matrix, of which the columns are.
struct PosedBox {
  using Ends = GivenBox::Ends;
  std::array<Vector3, 3> axes, columns;
  std::array<Ends, 3> length, local;
  Vector3 at{0, 0, 0},
      center{0, 0, 0};  // a corner is at + (columns center + axes, times one end each of their lengths) / weight
  double weight = 1;
  std::array<int, 3>
      along{};  // a coordinate of space that is one of the body's, from 1 on, or its opposite, below zero
};

}  // namespace plumb::query
