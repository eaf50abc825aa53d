// What shapes are there to be tested, and how do their numbers lie in a row?  Kinds, and one shape of a form.
//
// A shape is the numbers of its struct's members in order (`layout`), so that code of any library can read it;
// figure/generated.hpp makes the structs of them.
// Laws: (1) every number is finite, radii and half extents are not negative, boxes not empty; (2) polygons of space are
// exactly planar, axes of boxes and edges of lozenges exactly perpendicular; polygons do not cross themselves, unless
// they are flat.  (3) The same choices give the same shape, bit for bit, everywhere; the choice 0 gives small integers.
// Source: RTCD 11; right angles are those of Pythagoras and of integer quaternions.  Cost: about 1 us.
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
    ShapeKindInfo{ShapeKind::points, "points", "4 to 8 points, whose convex hull or k-DOP is meant", true, true},
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
enum class Form : unsigned char { plain, needle, cap, sliver, flat, straight, speck };

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
};

constexpr std::string_view name_of(Form form) { return forms[static_cast<std::size_t>(form)].name; }

/// Plain in half of the cases, else any.
Form any_form(Entropy& entropy);

/// A shape of the plane (2) or of space (3); for a kind that this space does not have, nothing.
std::vector<double> shape(ShapeKind kind, int dimension, Form form, Entropy& entropy);

/// How many numbers the kind's layout has; 0 where that varies.
std::size_t shape_size(ShapeKind kind, int dimension);

}  // namespace plumb::degenerate
