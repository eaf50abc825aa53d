// What is a shape before its numbers are doubles?  Integer points and a radius, which integer maps carry anywhere.
//
// Laws: a body stands on the plane z = 0: it has no point below, and the origin lies in the feature asked for.  The
// plane is told as the plane y = 0 of space: z is up there as well.  All members are below 2^30, and every map of ours
// takes that into account.  Directions, axes and edges are kept as the points they lead to.
// Source: none.
// Cost: below 1 us a body.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/degenerate/shape.hpp"

namespace plumb::degenerate {

using Int = std::int64_t;
using Int3 = std::array<Int, 3>;

inline Int3 operator+(const Int3& a, const Int3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Int3 operator-(const Int3& a, const Int3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Int3 operator*(Int s, const Int3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Int dot(const Int3& a, const Int3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Int3 cross(const Int3& a, const Int3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A linear map of integers by its columns; where it is a similarity, `stretch` is by how much, else 0.
struct IntMap {
  std::array<Int3, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Int stretch = 1;

  Int3 operator()(const Int3& p) const { return p[0] * columns[0] + p[1] * columns[1] + p[2] * columns[2]; }
  [[nodiscard]] Int3 row(std::size_t i) const { return {columns[0][i], columns[1][i], columns[2][i]}; }
};

IntMap any_permutation(int dimension, Entropy& entropy);  // of the axes, with signs
IntMap turned_about_x(Entropy& entropy);
IntMap turned_about_y(Entropy& entropy);  // in the plane, where y is no axis
IntMap turned_about_z(Entropy& entropy);
IntMap any_turn(Entropy& entropy);
IntMap after(const IntMap& second, const IntMap& first);

/// In the order of the layout.  Lines and rays: a point and one further along; planes: three points; halfspaces one
/// more, within, and of several halfspaces four each; slabs: three and one of the other plane; boxes, rectangles and
/// ellipsoids: the center and the points that its axes lead to, `half` being the half extents; lozenges: the corner and
/// its neighbors; k-DOPs: of each direction a point of the plane below and one of the plane above.
struct Body {
  ShapeKind kind;
  std::vector<Int3> points;
  Int radius = 0;
  std::vector<Int> half{};
  std::vector<std::size_t> parts{};  // points of each chain of a holed polygon; corners of a mesh's triangles

  /// From the center to the middle of a face, or the tip.
  [[nodiscard]] Int3 arm(std::size_t i) const { return half[i] * (points[i + 1] - points[0]); }

  void map(const IntMap& by);
  void move(const Int3& by);
  void multiply(Int by);
};

struct BodyOrder {
  ShapeKind kind;
  int dimension = 3;
  int feature = 0;             // 0, 1, 2: a vertex, edge or face lies on the ground
  Int3 extent{1, 1, 1};        // about how long, in x, y and z
  Int shared = 0;              // the feature has this size, if not 0, and no turn
  bool upright = false;        // it stands at a right angle
  bool across = false;         // an edge that boxes have to choose leads along y instead of x
  bool around = false;         // of what planes bound and of meshes: the origin is inside instead
  bool bounded = false;        // halfspaces leave no direction open
  std::array<Int3, 3> axes{};  // of an aligned shape: those of space
};

/// The features that a kind can stand on: bit f for feature f.
unsigned features_of(ShapeKind kind, int dimension);
/// Whether edges and faces have corners, which shapes can have in common.
bool has_corners(ShapeKind kind);
/// Center, axes and half extents; whether it is a box or an ellipsoid.
bool has_axes(ShapeKind kind);
bool is_box(ShapeKind kind);
bool is_round(ShapeKind kind);
/// One chain or several in one plane.
bool is_chain(ShapeKind kind);
/// Its faces have directions of space's own: aabb, k_dop.
bool is_aligned(ShapeKind kind);
/// Whether only similarities keep it a shape of its kind, and one with perpendicular axes.
bool is_rigid(ShapeKind kind);

/// The normals of a k-DOP where the axes of space are these.
std::vector<Int3> k_dop_normals(int dimension, const std::array<Int3, 3>& axes);

Body body_of(const BodyOrder& order, Entropy& entropy);

/// Holds all within a cube of this half edge about the origin; `loose` where an aabb's axes are not the cube's.
Body body_around(const BodyOrder& order, Int half, bool loose);

/// Moves a body so that a point of its relative interior is the origin.
void put_middle_at_origin(Body& body);

/// The extents of a form, up to 2^bits.
Int3 extent_of(Form form, int bits, Entropy& entropy);

/// Where integers lie among the doubles: (base + scale x) 2^exponent.
struct Placement {
  Int3 base{};
  Int scale = 1;
  int exponent = 0;
};

/// Nothing where some number has more than 53 bits.
std::optional<std::vector<double>> written(const Body& body, int dimension, const Placement& placement);

/// A placement for numbers below 2^bits: small, far from the origin, with long mantissas, or of any exponent; `longest`
/// asks for coordinates as long as doubles are.
Placement any_placement(int bits, bool longest, Entropy& entropy);

/// Bits of the greatest coordinate or length.
int bits_of(const Body& body);

}  // namespace plumb::degenerate
