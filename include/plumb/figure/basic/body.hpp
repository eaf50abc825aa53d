// What is a figure made of?  Its name and its members, each with what it is: said once, beside the struct.
//
//   template <class Take>
//   constexpr auto body(const Capsule3& s, Take take) {
//     return take("capsule", part::place("a", s.a), part::place("b", s.b), part::length("radius", s.radius));
//   }
//
// Which numbers are looked at, what errors call them, what is moved by a pose and what by a change of scale, and what
// the tests name otherwise or map, follow from it; a figure of your own says itself in the same way, in its namespace.
// Laws: every number of the figure is in one member, in the order of the struct; a list of places is a chain of at least
// three; a length is not negative.
// Source: none; the struct's comment says which set it is.
// Cost: none: take is inlined, and the names are not looked at before they are asked for.
#pragma once

#include <string_view>
#include <type_traits>

#include "plumb/arith/point.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"

namespace plumb {

namespace figure::part {

/// What a member is, and with that what becomes of it where the figure is moved.
enum class Role : unsigned char {
  place,     // a point, or a list of them: is moved, turned and scaled
  way,       // from one place to another, or an array of such ways: turned and scaled
  axis,      // a direction, or an array of them, of which only the line or the side counts: turned
  normal,    // of a plane: what a place x is multiplied by
  offset,    // of a plane: what normal . x is compared with
  length,    // a radius: scaled, and never negative
  multiple,  // of axes: how often, to either side, the magnitude counting
  corner,    // a place that bounds each coordinate by itself: min and max of an axis-aligned box
  figure,    // another figure, or a list of them
  surface,   // a mesh, which has faces
  turn,      // a quaternion, which is not zero
  slabs      // the figure itself: a direction, min and max for each of them
};

template <Role R>
struct RoleIs {};

template <Role R, class Member>
struct Part {
  static constexpr Role role = R;
  std::string_view name;
  const Member& is;
};

template <class Member>
constexpr auto place(std::string_view name, const Member& is) {
  return Part<Role::place, Member>{name, is};
}
template <class Member>
constexpr auto way(std::string_view name, const Member& is) {
  return Part<Role::way, Member>{name, is};
}
template <class Member>
constexpr auto axis(std::string_view name, const Member& is) {
  return Part<Role::axis, Member>{name, is};
}
template <class Member>
constexpr auto normal(std::string_view name, const Member& is) {
  return Part<Role::normal, Member>{name, is};
}
constexpr auto offset(std::string_view name, const double& is) { return Part<Role::offset, double>{name, is}; }
constexpr auto length(std::string_view name, const double& is) { return Part<Role::length, double>{name, is}; }
template <class Member>
constexpr auto multiple(std::string_view name, const Member& is) {
  return Part<Role::multiple, Member>{name, is};
}
template <class Member>
constexpr auto corner(std::string_view name, const Member& is) {
  return Part<Role::corner, Member>{name, is};
}
template <class Member>
constexpr auto figure(std::string_view name, const Member& is) {
  return Part<Role::figure, Member>{name, is};
}
template <class Member>
constexpr auto slabs(const Member& is) {
  return Part<Role::slabs, Member>{"", is};
}
template <class Member>
constexpr auto surface(std::string_view name, const Member& is) {
  return Part<Role::surface, Member>{name, is};
}
template <class Member>
constexpr auto turn(std::string_view name, const Member& is) {
  return Part<Role::turn, Member>{name, is};
}

}  // namespace figure::part

namespace part = figure::part;

template <class Take>
constexpr auto body(const Point2& p, Take take) {
  return take("point", part::place("", p));
}
template <class Take>
constexpr auto body(const Point3& p, Take take) {
  return take("point", part::place("", p));
}

/// No figure, but numbers that are looked at and named in the same way.
template <class Take>
constexpr auto body(const Pose2& s, Take take) {
  return take("pose", part::way("columns", s.columns), part::way("translation", s.translation));
}
template <class Take>
constexpr auto body(const Pose& s, Take take) {
  return take("pose", part::way("columns", s.columns), part::way("translation", s.translation));
}
template <class Take>
constexpr auto body(const Rotation2& s, Take take) {
  return take("turn", part::turn("", s));
}
template <class Take>
constexpr auto body(const Rotation& s, Take take) {
  return take("turn", part::turn("", s));
}
template <class Take>
constexpr auto body(const RigidPose2& s, Take take) {
  return take("pose", part::turn("turn", s.turn), part::way("translation", s.translation));
}
template <class Take>
constexpr auto body(const RigidPose& s, Take take) {
  return take("pose", part::turn("turn", s.turn), part::way("translation", s.translation));
}
template <class Take>
constexpr auto body(const RigidChain2& s, Take take) {
  return take("pose", part::figure("links", s.links));
}
template <class Take>
constexpr auto body(const RigidChain& s, Take take) {
  return take("pose", part::figure("links", s.links));
}

namespace figure {

struct NameOf {
  template <class... Parts>
  constexpr std::string_view operator()(std::string_view name, const Parts&...) const {
    return name;
  }
};
struct AnyBody {
  template <class... Parts>
  constexpr bool operator()(std::string_view, const Parts&...) const {
    return true;
  }
};

}  // namespace figure

/// What has said what it is made of.
template <class Shape>
concept Described = requires(const Shape& s) {
  body(s, figure::AnyBody{});
};

/// f(part::RoleIs<role>{}, member) for each of them in turn, to be changed.
template <Described Shape, class F>
constexpr void change_members(Shape& s, F f) {
  body(static_cast<const Shape&>(s), [&f]<class... Parts>(std::string_view, const Parts&... parts) {
    (f(part::RoleIs<Parts::role>{}, const_cast<std::remove_cvref_t<decltype(parts.is)>&>(parts.is)), ...);
  });
}

/// What errors call it.
template <Described Shape>
constexpr std::string_view name_of_figure(const Shape& s) {
  return body(s, figure::NameOf{});
}

}  // namespace plumb
