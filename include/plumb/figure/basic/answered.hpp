// What is said to a question about two figures that has no answer here?  One sentence, instead of all that was tried.
//
// Each function below takes whatever no other function of its name takes, and refuses to compile.  So
//   requires { relate(a, b); }
// holds of everything; generic code asks by the concept beside it, once all that may answer is included:
//   if constexpr (Relatable<A, B>) ...
// Cost: compile time only.
#pragma once

#include <concepts>
#include <type_traits>

#include "plumb/figure/basic/relation.hpp"

namespace plumb {

namespace figure {

/// Whatever it is, worse than anything that fits.
struct Anything {
  template <class T>
  Anything(const T&) {}  // NOLINT: the one argument that every call has an overload for
  Anything() = default;
};

/// Stands where an answer of this type would stand, so that the compiler says no more.
template <class T>
struct NoAnswer {
  operator T() const { __builtin_unreachable(); }
};
template <class T>
requires std::is_class_v<T>
struct NoAnswer<T> : T {
};

template <class T>
inline constexpr bool is_no_answer = false;
template <class T>
inline constexpr bool is_no_answer<NoAnswer<T>> = true;

/// The type of an answer, of who asks whether there is one.
template <class T>
concept Answer = !is_no_answer<T>;

template <class>
inline constexpr bool never = false;

}  // namespace figure

template <class T = Relation>
figure::NoAnswer<T> relate(const figure::Anything&, const figure::Anything&, const figure::Anything& = {}) {
  static_assert(
      figure::never<T>,
      "plumb: relate takes two figures of one space, the pairs of docs/overlap.md (include <plumb/query.hpp>); "
      "of a mesh ask its triangles, or a ConvexPolyhedron3");
  __builtin_unreachable();
}

template <class T = bool>
figure::NoAnswer<T> intersects(const figure::Anything&, const figure::Anything&, const figure::Anything& = {}) {
  static_assert(figure::never<T>,
                "plumb: intersects takes two figures of one space, the pairs of docs/overlap.md (include "
                "<plumb/query.hpp>); of a mesh ask its triangles, or a ConvexPolyhedron3");
  __builtin_unreachable();
}

template <class A, class B>
concept Relatable = requires(const A& a, const B& b) {
  { relate(a, b) } -> figure::Answer;
  { intersects(a, b) } -> figure::Answer;
};

template <class T = bool>
figure::NoAnswer<T> contains(const figure::Anything&, const figure::Anything&, const figure::Anything& = {}) {
  static_assert(
      figure::never<T>,
      "plumb: contains takes a figure and a point of its space, or two bounds, the pairs of docs/bounds.md (include "
      "<plumb/query.hpp>)");
  __builtin_unreachable();
}
template <class Outer, class Inner>
concept Containing = requires(const Outer& outer, const Inner& inner) {
  { contains(outer, inner) } -> figure::Answer;
};

}  // namespace plumb
