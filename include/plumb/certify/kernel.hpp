// What is the sign at points of a known lattice?  The predicates with the arithmetic that the lattice's plan says.
//
//   const Kernel kernel(plan(lattice_of(coordinates)));
//   const std::vector<LatticePoint<3>> p = kernel.points(vertices);   // checked here, once
//   kernel.orient3d(p[0], p[1], p[2], p[3]);                          // exact, at about the cost of the bare formula
//   kernel.orient3d(vertices[0], vertices[1], vertices[2], query);    // checks its coordinates itself
//   kernel.with<predicates::Orient3d>([&](auto orient) { ... });      // for a loop: the arithmetic is chosen outside
//
// Laws: the sign is that of decide for the same coordinates.  Coordinates off the lattice throw OffLattice, NaN and
// infinity NonFinite, and points that another lattice's kernel took in OffLattice, naming the argument: no wrong input
// gets an answer.  Kernels of equal lattices may exchange points.
// Source: RTCD 11.4, 11.5.1.
// Cost: docs/plans.md; in a loop within `with` 1.1 to 1.4 times the bare formula up to degree 4, and at most a ns more for
// choosing at every call.
#pragma once

#include <tuple>
#include <vector>

#include "plumb/certify/detail/planned_sign.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

class Kernel {
 public:
  explicit Kernel(const Plan& plan) : intake_(plan.lattice()) {}
  /// Throws Error for a lattice that no double fits (certify/plan.hpp).
  explicit Kernel(const Lattice& lattice) : intake_(lattice) {}

  [[nodiscard]] const Lattice& lattice() const { return intake_.lattice(); }

  /// Takes it in.
  template <HasCoordinates Argument>
  [[nodiscard]] auto point(const Argument& argument) const {
    const auto x = coordinates(argument);
    LatticePoint<std::tuple_size_v<std::remove_const_t<decltype(x)>>> taken;
    if (!intake_.take(x, taken)) [[unlikely]]
      intake_.refuse("point", std::array{static_cast<int>(x.size())}, x);
    return taken;
  }
  /// All of them; what is refused is named by its index.
  [[nodiscard]] std::vector<LatticePoint<2>> points(std::span<const Point2> points) const;
  [[nodiscard]] std::vector<LatticePoint<3>> points(std::span<const Point3> points) const;

  /// action(sign), where sign is F in the arithmetic of this lattice: for loops that ask one question often.  The
  /// action is compiled for each arithmetic that F may need, without a branch on the lattice in it.
  template <Formula F, class Action>
  decltype(auto) with(Action&& action) const {
    static_assert(is_polynomial<F>());
    static_assert(use_all_coordinates<F>());
    return certify::planned::dispatch<F>(
        intake_, [&]<class Way>(Way) -> decltype(auto) { return action(PlannedPredicate<F, Way>(intake_)); });
  }

  /// The sign of F at points taken in, one for each argument.
  template <Formula F, std::size_t... N>
  [[nodiscard]] [[gnu::always_inline]] Sign sign(const LatticePoint<N>&... p) const {
    static_assert(is_polynomial<F>());
    static_assert(use_all_coordinates<F>());
    return certify::planned::dispatch<F>(intake_,
                                         [&]<class Way>(Way) { return PlannedPredicate<F, Way>(intake_)(p...); });
  }
  /// The sign of F at points, vectors and numbers as given, which are checked.
  template <Formula F, HasCoordinates... Arguments>
  [[nodiscard]] Sign sign(const Arguments&... arguments) const {
    const auto p =
        std::apply([](auto... x) { return Coordinates<F>{x...}; }, std::tuple_cat(coordinates(arguments)...));
    LatticePoint<arity<F>> taken;
    if (!intake_.take(p, taken)) [[unlikely]]
      intake_.refuse(F::name, plumb::arguments<F>, p);
    return sign<F>(taken);
  }

  // Points are all LatticePoint<2> or all Point2; in space LatticePoint<3> or Point3.
  template <class Point>
  [[nodiscard]] Sign orient2d(const Point& a, const Point& b, const Point& c) const {
    return sign<predicates::Orient2d>(a, b, c);
  }
  template <class Point>
  [[nodiscard]] Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) const {
    return sign<predicates::Orient3d>(a, b, c, d);
  }
  template <class Point>
  [[nodiscard]] Sign incircle(const Point& a, const Point& b, const Point& c, const Point& d) const {
    return sign<predicates::InCircle>(a, b, c, d);
  }
  template <class Point>
  [[nodiscard]] Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) const {
    return sign<predicates::InSphere>(a, b, c, d, e);
  }

 private:
  LatticeIntake intake_;
};

}  // namespace plumb
