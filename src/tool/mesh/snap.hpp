// What does a coarser lattice do to a mesh?  Every coordinate goes to the nearest multiple of a power of two.
//
// Laws: (1) no coordinate moves by more than half a step, ties go to the even multiple, and `greatest_move` is the
// largest move itself, not a rounded one: the difference of a double and its multiple is a double; (2) what merges,
// collapses and turns over is decided exactly, before and after: points merge that were distinct and now are equal, a
// triangle collapses whose area was positive and now is zero, and is turned over when its normal turned by more than a
// right angle; (3) a step at which a coordinate would leave the doubles gives nothing.
// Source: RTCD 11.4, 11.5.1.
// Cost: about 100 ns a triangle that moved.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/arith/lattice.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::tool {

/// The multiple of 2^exponent nearest to a finite x; infinite beyond the largest double.  Never -0.
double nearest_multiple(double x, int exponent);

struct SnapDamage {
  Lattice lattice;                                    // of the snapped coordinates
  double greatest_move = 0;                           // of a coordinate, exactly
  double greatest_distance = 0;                       // of a vertex, the nearest double
  std::vector<std::array<std::uint32_t, 2>> merged;   // a vertex, and the first one that it now equals
  std::vector<std::uint32_t> collapsed, turned_over;  // triangles
};

/// Of one mesh, to multiples of 2^exponent; nothing where a coordinate would overflow.
std::optional<SnapDamage> snap_damage(const TriangleMesh& mesh, int exponent);

/// The least exponent at which the snapped coordinates take at most so many bits; nothing where none does.
std::optional<int> exponent_for_bits(std::span<const std::span<const Point3>> scene, const Lattice& lattice, int bits);

}  // namespace plumb::tool
