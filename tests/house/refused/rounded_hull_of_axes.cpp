// What is made of axes is no hull of its places.
// refused: plumb: a rounded hull is made of places
#include "plumb/plumb.hpp"

struct Wedge {
  plumb::Point3 a, b;
  plumb::Vector3 axis;
};
template <class Take>
constexpr auto body(const Wedge& s, Take take) {
#ifdef MENDED
  return take("wedge", plumb::part::place("a", s.a), plumb::part::place("b", s.b));
#else
  return take("wedge", plumb::part::place("a", s.a), plumb::part::place("b", s.b), plumb::part::axis("axis", s.axis));
#endif
}
template <>
inline constexpr bool plumb::is_rounded_hull<Wedge> = plumb::hull_of_places<Wedge>();
