// Of which meshes are the tasks on meshes asked?  Generated ones, each named by one number, so that a question of
// plain numbers can name it.
//
// A name says which surface it is, how it was moved, and by which throw of dice.  Beside it go three numbers, 0, 1
// and 2 in some order: which coordinate of the surface stands on each axis.
// Laws: (1) all coordinates are multiples of 2^-50, and so are those of rays and points that are asked; ring, shells
// and blocks are single-precision numbers where they were made, but for the third shell. (2) Rings, shells and blocks
// are closed surfaces. (3) The same name is the same mesh everywhere.
// Source: none.
// Cost: milliseconds a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "lab/trial/vec.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::lab::trial {

enum class Surface : std::uint8_t {
  ring,    // closed and wavy, 6,400 triangles
  band,    // the same, of 1,024
  loop,    // the same, of 256
  shells,  // three rings of 2,304 triangles, the second 2^-20 above the first, the third 2^-50
  blocks,  // of a cube, 5 x 5 unit squares a side, 300 triangles
  die,     // the same, 3 x 3 a side, 108 triangles
  heap,    // 2,000 triangles of small integers, segments and points among them; another heap for each throw of dice
  pile     // the same, of 200
};

/// What was done to it, in this order.
struct Moved {
  bool turned_at_random = false;  // and moved by less than 1; rounded to multiples of 2^-20
  bool stepped = false;           // by integers from -6 to 6
  bool aside = false;             // by 5 to 8 along the first axis, and by integers from -2 to 2
  bool nudged = false;            // each axis by 2^-48 up or down, or not
  bool turned = false;            // by a turn that all meshes have in common; rounded to multiples of 2^-50
  bool far = false;               // by 2^20 along each axis
};

double mesh_name(Surface surface, const Moved& moved = {}, std::uint64_t dice = 0);

/// A name, and which coordinate stands on each axis.
using MeshKey = std::array<double, 4>;
TriangleMesh mesh_of(const MeshKey& key);

/// Meshes that were asked for before are kept.
class MeshShelf {
 public:
  const TriangleMesh& operator()(double name);

 private:
  std::map<double, TriangleMesh> made_;
};

/// The turn that `turned` means, as a matrix of doubles; a direction or place turned by it, rounded.
extern const Pose common_turn;
Point3 turned_point(const Point3& p);

/// Nearest multiple of 2^-bits.
double rounded_to(double x, int bits);

/// The images rounded to doubles, as software does that poses its vertices.
TriangleMesh rounded_image(TriangleMesh mesh, const Pose& pose);

}  // namespace plumb::lab::trial
