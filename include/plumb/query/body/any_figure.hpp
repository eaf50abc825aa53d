// Which figure is it, where that is known at run time alone?  A shape of any kind, as it stands or under a pose, as a
// value.
//
//   std::vector<AnyFigure> scene{Sphere3{{0, 0, 0}, 1}, Posed{box, pose}, polygon};
//   relate(scene[0], scene[1]);  distance(scene[2], Segment3{a, b});      as of the kinds themselves
//   if (const Sphere3* ball = get_if<Sphere3>(scene[0])) ...              the shape, without its pose
//   visit([](const auto& shape) { ... }, scene[1]);
//   parse_figure(to_string(scene[1])) == scene[1]
//
// Laws: (1) every question takes one at both places, together with the kinds themselves, posed or not, and answers as for
// the kinds, bit for bit (query/variant/questions.hpp); of a figure of the plane an answer lies in the plane z = 0.
// (2) A pair that the question's table has not, and figures of the plane and of space together, throw Unsupported, which
// names the question and both kinds.  (3) Copies are equal and independent; a shape of lists (a polygon, a k-DOP,
// halfspaces, a polyhedron) is shared between copies and never changes.  (4) Text is one line: the kind and its dimension,
// then the numbers in hexadecimal, in the order of degenerate/shape.hpp, then where it stands: `pose` and the columns and
// the translation, `rigid` and the quaternion and the translation, or `chain` and as much of each link.  Of a k-DOP there
// are its directions before the bounds, and before these how many; a polyhedron is how many vertices, these, and of each
// face how many corners and which; a cap is its ball and its halfspace.
// Source: RTCD 2.3.
// Cost: 248 bytes; no allocation but for shapes of lists and chains of poses.  A question costs two jumps more than of
// the kinds.  Nothing is searched.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "plumb/arith/error.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb {

/// No answer is known for figures of these kinds; the text names the question, the kinds, and what tells all pairs.
struct Unsupported : Error {
  using Error::Error;
};

class AnyFigure {
 public:
  template <PosedOrNot Shape>
  AnyFigure(const Shape& s) {  // NOLINT: made of a figure without a word
    if constexpr (query::is_posed<Shape>) {
      hold(s.shape);
      pose_ = s.pose;
    } else {
      hold(s);
    }
  }

  [[nodiscard]] FigureKind kind() const { return kind_; }
  /// 2 of the plane, 3 of space.
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] const AnyPose& pose() const { return pose_; }
  [[nodiscard]] bool is_posed() const { return pose_.index() != 0; }

  /// The same shape elsewhere; a pose of the other space throws Unsupported.
  [[nodiscard]] AnyFigure under(const AnyPose& pose) const;

  /// The shape without its pose.
  [[nodiscard]] query::FigureView figure() const {
    return {kind_, dimension_, there_ != nullptr ? there_.get() : static_cast<const void*>(here_.data())};
  }
  [[nodiscard]] query::PosedView view() const { return {figure(), pose_}; }

  /// Are kind, numbers and pose the same?
  friend bool operator==(const AnyFigure& a, const AnyFigure& b);

 private:
  static constexpr std::size_t room = 15 * sizeof(double);  // an Obb3

  template <class Shape>
  void hold(const Shape& s) {
    kind_ = figure_kind<Shape>;
    dimension_ = figure_dimension<Shape>;
    if constexpr (std::is_trivially_copyable_v<Shape> && sizeof(Shape) <= room) {
      __builtin_memcpy(here_.data(), &s, sizeof(Shape));
    } else {
      there_ = std::make_shared<const Shape>(s);
    }
  }

  FigureKind kind_{};
  int dimension_ = 0;
  alignas(double) std::array<std::byte, room> here_{};
  std::shared_ptr<const void> there_;
  AnyPose pose_;
};

template <PosedOrNot Shape>
AnyFigure figure_of(const Shape& s) {
  return AnyFigure(s);
}

/// f of the shape as the struct that it is, without its pose.
template <class F>
decltype(auto) visit(F&& f, const AnyFigure& figure) {
  return query::with_figure(figure.figure(), f);
}

/// The shape without its pose; nullptr where it is of another type.
template <Figure Shape>
const Shape* get_if(const AnyFigure& figure) {
  const query::FigureView v = figure.figure();
  if (v.kind != figure_kind<Shape> || v.dimension != figure_dimension<Shape>) return nullptr;
  return static_cast<const Shape*>(v.shape);
}

std::string to_string(const AnyFigure& figure);

/// Nothing for a blank line or a comment; throws Error for a word that is no number, InvalidShape for numbers that are no
/// figure.
std::optional<AnyFigure> parse_figure(std::string_view line);

namespace query {

/// Throws Unsupported.
[[noreturn]] void refuse_pair(std::string_view question, const FigureView& a, const FigureView& b);
[[noreturn]] void refuse_figure(std::string_view question, const FigureView& figure);

}  // namespace query

}  // namespace plumb
