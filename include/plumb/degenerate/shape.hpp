// What shapes are there to be tested, and how do their numbers lie in a row?  Kinds, and one shape of a form.
//
// A shape is the numbers of its struct's members in order (`layout`), so that code of any library can read it;
// figure/generated/generated.hpp makes the structs of them.
// Laws: (1) every number is finite, radii and half extents are not negative, nothing is empty but by the form of that
// name; (2) polygons of space are exactly planar, axes of boxes and rectangles exactly perpendicular, none of them
// zero, and so are edges of lozenges that are not zero; polygons do not cross themselves, unless they are flat, and
// holes cross neither the outer chain nor one another; meshes are closed, each edge passed once in either direction.
// (3) The same choices give the same shape, bit for bit, everywhere; the choice 0 gives small integers.
// Source: RTCD 11; right angles are those of Pythagoras and of integer quaternions.
// Cost: about 1 us.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::degenerate {

enum class ShapeKind : unsigned char {
  point,
  line,
  ray,
  segment,
  plane,
  halfspace,
  triangle,
  polygon,
  rectangle,
  tetrahedron,
  aabb,
  obb,
  ball,
  capsule,
  lozenge,
  cylinder,
  cone,
  points,
  three_point_plane,
  slab,
  quadrilateral,
  holed_polygon,
  k_dop,
  halfspaces,
  mesh,
  ellipsoid,
};

struct ShapeKindInfo {
  ShapeKind kind;
  std::string_view name;
  std::string_view layout;
  bool in_plane, in_space;
};

inline constexpr std::array shape_kinds = {
    ShapeKindInfo{ShapeKind::point, "point", "the point", true, true},
    ShapeKindInfo{ShapeKind::line, "line", "point, direction", true, true},
    ShapeKindInfo{ShapeKind::ray, "ray", "origin, direction", true, true},
    ShapeKindInfo{ShapeKind::segment, "segment", "a, b", true, true},
    ShapeKindInfo{ShapeKind::plane, "plane", "normal, offset: normal . x = offset", false, true},
    ShapeKindInfo{ShapeKind::halfspace, "halfspace", "normal, offset: normal . x <= offset", true, true},
    ShapeKindInfo{ShapeKind::triangle, "triangle", "a, b, c", true, true},
    ShapeKindInfo{ShapeKind::polygon, "polygon", "3 to 8 vertices in order", true, true},
    ShapeKindInfo{ShapeKind::rectangle, "rectangle", "center, two axes, two half extents", false, true},
    ShapeKindInfo{ShapeKind::tetrahedron, "tetrahedron", "a, b, c, d", false, true},
    ShapeKindInfo{ShapeKind::aabb, "aabb", "min, max", true, true},
    ShapeKindInfo{ShapeKind::obb, "obb", "center, axes one after the other, half extents", true, true},
    ShapeKindInfo{ShapeKind::ball, "ball", "center, radius", true, true},
    ShapeKindInfo{ShapeKind::capsule, "capsule", "a, b, radius", true, true},
    ShapeKindInfo{ShapeKind::lozenge, "lozenge", "corner, two edges, radius", false, true},
    ShapeKindInfo{ShapeKind::cylinder, "cylinder", "a, b, radius", false, true},
    ShapeKindInfo{ShapeKind::cone, "cone", "apex, base, radius", false, true},
    ShapeKindInfo{ShapeKind::points, "points", "4 to 8 points, whose convex hull is meant", true, true},
    ShapeKindInfo{ShapeKind::three_point_plane, "three_point_plane", "three points of a plane", false, true},
    ShapeKindInfo{ShapeKind::slab, "slab", "normal, min, max: min <= normal . x <= max", true, true},
    ShapeKindInfo{ShapeKind::quadrilateral, "quadrilateral", "a, b, c, d in order, convex or a dart", true, true},
    ShapeKindInfo{ShapeKind::holed_polygon, "holed_polygon",
                  "how many chains, then of each how many vertices, and these; the outer chain first", true, true},
    ShapeKindInfo{ShapeKind::k_dop, "k_dop", "min along the axes and the diagonals, then max along them", true, true},
    ShapeKindInfo{ShapeKind::halfspaces, "halfspaces", "normal, offset of each halfspace; what lies in all of them",
                  true, true},
    ShapeKindInfo{ShapeKind::mesh, "mesh", "how many vertices, these, and three indices a triangle", false, true},
    ShapeKindInfo{ShapeKind::ellipsoid, "ellipsoid", "center, axes one after the other, half extents", false, true},
};

constexpr std::string_view name_of(ShapeKind kind) { return shape_kinds[static_cast<std::size_t>(kind)].name; }

/// The kind of a name, if there is one.
constexpr std::optional<ShapeKind> shape_kind_named(std::string_view name) {
  for (const ShapeKindInfo& info : shape_kinds) {
    if (info.name == name) return info.kind;
  }
  return std::nullopt;
}

constexpr bool is_kind_of(ShapeKind kind, int dimension) {
  const ShapeKindInfo& info = shape_kinds[static_cast<std::size_t>(kind)];
  return dimension == 2 ? info.in_plane : dimension == 3 && info.in_space;
}

/// How long a shape is in each direction: a triangle that is a needle has one short edge, a cap has one low vertex, a
/// tetrahedron that is a sliver four vertices near one plane.
enum class Form : unsigned char { plain, needle, cap, sliver, flat, straight, speck, empty };

struct FormInfo {
  Form form;
  std::string_view name;
  std::string_view about;
};

inline constexpr std::array forms = {
    FormInfo{Form::plain, "plain", "about as long in every direction"},
    FormInfo{Form::needle, "needle", "long in one direction, away from what it stands on"},
    FormInfo{Form::cap, "cap", "long in one direction, along what it stands on"},
    FormInfo{Form::sliver, "sliver", "long in two directions, thin in the third"},
    FormInfo{Form::flat, "flat", "in one plane (on one line)"},
    FormInfo{Form::straight, "straight", "on one line"},
    FormInfo{Form::speck, "speck", "one point"},
    FormInfo{Form::empty, "empty", "no point at all: boxes, slabs, k-DOPs and halfspaces out of order"},
};

constexpr std::string_view name_of(Form form) { return forms[static_cast<std::size_t>(form)].name; }

/// Only these can be empty.
constexpr bool can_be_empty(ShapeKind kind) {
  return kind == ShapeKind::aabb || kind == ShapeKind::slab || kind == ShapeKind::k_dop ||
         kind == ShapeKind::halfspaces;
}

/// Plain in half of the cases, else any but empty.
Form any_form(Entropy& entropy);

/// A shape of the plane (2) or of space (3); for a kind that this space does not have, or that cannot be empty,
/// nothing.
std::vector<double> shape(ShapeKind kind, int dimension, Form form, Entropy& entropy);

/// How many numbers the kind's layout has; 0 where that varies.
std::size_t shape_size(ShapeKind kind, int dimension);

/// The normals of a k-DOP, in the order of its layout: the axes, and the diagonals of a square or a cube.
std::vector<std::array<int, 3>> k_dop_normals(int dimension);

}  // namespace plumb::degenerate
