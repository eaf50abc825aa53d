// orient3d and insphere of points as given, line-plane and three-plane points, points on segments and posed points: a
// broad sample of mixes, each kind in each place.  Against rationals and CGAL, which construct the points.
#include "certify/implicit/cases.hpp"

namespace plumb::implicit_cases {
namespace {

using E = Point3;
using L = LinePlanePoint3;
using T = ThreePlanePoint3;
using S = SegmentPoint3;
using P = Posed<Point3>;

#if defined(PLUMB_LONG_TESTS)
constexpr std::uint64_t cases = 200'000;
#else
const std::uint64_t cases = battery::fitting<std::uint64_t>(2'000);
#endif

template <class A, class B, class C, class D>
void orient() {
  check_all<A, B, C, D>(
      Question::orient, [](const auto& a, const auto& b, const auto& c, const auto& d) { return orient3d(a, b, c, d); },
      cases);
}

template <class A, class B, class C, class D, class F>
void sphere() {
  check_all<A, B, C, D, F>(
      Question::in_sphere,
      [](const auto& a, const auto& b, const auto& c, const auto& d, const auto& e) { return insphere(a, b, c, d, e); },
      cases);
}

TEST(ImplicitSpace, Orient3dOfOneAmongPointsAsGiven) {
  orient<L, E, E, E>();
  orient<E, T, E, E>();
  orient<E, E, S, E>();
  orient<E, E, E, P>();
  orient<E, E, E, L>();
  orient<T, E, E, E>();
  orient<E, S, E, E>();
  orient<E, E, P, E>();
}

TEST(ImplicitSpace, Orient3dOfTwoKinds) {
  orient<L, L, E, E>();
  orient<E, E, L, L>();
  orient<T, E, T, E>();
  orient<E, S, E, L>();
  orient<P, E, E, P>();
  orient<S, T, E, E>();
  orient<L, L, S, S>();
  orient<P, P, L, L>();
}

TEST(ImplicitSpace, Orient3dOfNoneAsGiven) {
  orient<L, L, L, L>();
  orient<T, T, T, T>();
  orient<S, S, S, S>();
  orient<P, P, P, P>();
  orient<L, T, L, T>();
  orient<S, L, T, P>();
  orient<P, S, L, T>();
  orient<T, P, S, L>();
  orient<L, T, P, S>();
}

TEST(ImplicitSpace, InSphereWithPointsAsGiven) {
  sphere<L, E, E, E, E>();
  sphere<E, T, E, E, E>();
  sphere<E, E, S, E, E>();
  sphere<E, E, E, P, E>();
  sphere<E, E, E, E, L>();
  sphere<E, S, L, T, P>();
  sphere<L, L, L, L, E>();
}

TEST(ImplicitSpace, InSphereOfNoneAsGiven) {
  sphere<L, L, L, L, L>();
  sphere<T, T, T, T, T>();
  sphere<S, S, S, S, S>();
  sphere<P, P, P, P, P>();
  sphere<T, L, T, L, S>();
  sphere<L, T, T, P, L>();
}

}  // namespace
}  // namespace plumb::implicit_cases
