#include "plumb/certify/power.hpp"
#include "plumb/certify/smallest_sphere.hpp"
#include "python/sign_question.hpp"

namespace plumb::python {
namespace {

using P2 = Point2;
using P3 = Point3;
using W2 = WeightedPoint2;
using W3 = WeightedPoint3;

}  // namespace

std::vector<SignQuestion> sphere_questions() {
  const auto circle = [](const auto&... p) { return in_smallest_circle(p...); };
  const auto sphere = [](const auto&... p) { return in_smallest_sphere(p...); };
  const auto power = [](const auto&... p) { return power_sign(p...); };
  const auto compared = [](const auto&... p) { return compare_power(p...); };
  return {
      {"in_smallest_circle",
       "Is p inside the circle that has the segment ab as its diameter, or with c inside that through a, b, c?  1 "
       "inside,\n"
       "0 on it, whatever the turn of a, b, c.",
       {form<P2, P2, P2>({"a", "b", "c"}, circle), form<P2, P2, P2, P2>({"a", "b", "c", "d"}, circle)}},
      {"in_smallest_sphere",
       "Is p inside the sphere that has the segment ab as its diameter, or with c inside that through a, b, c whose "
       "center\n"
       "is in their plane?  1 inside, 0 on it.",
       {form<P3, P3, P3>({"a", "b", "c"}, sphere), form<P3, P3, P3, P3>({"a", "b", "c", "d"}, sphere)}},
      {"in_power_circle",
       "Is d nearer to the circle orthogonal to the weighted points a, b, c than its weight allows?  For "
       "counterclockwise\n"
       "a, b, c; the last number of a point is its weight.",
       {form<W2, W2, W2, W2>({"a", "b", "c", "d"}, [](const auto&... p) { return in_power_circle(p...); })}},
      {"in_power_sphere",
       "Is e nearer to the sphere orthogonal to the weighted points a, b, c, d than its weight allows?  For\n"
       "orient3d(a, b, c, d) = 1; the last number of a point is its weight.",
       {form<W3, W3, W3, W3, W3>({"a", "b", "c", "d", "e"}, [](const auto&... p) { return in_power_sphere(p...); })}},
      {"compare_power",
       "The power of p from the weighted point a against that from b; the last number of a and b is a weight.",
       {form<P2, W2, W2>({"p", "a", "b"}, compared), form<P3, W3, W3>({"p", "a", "b"}, compared)}},
      {"power_sign",
       "The sign of p's power from the weighted point a: -1 inside its circle or sphere, 0 on it.  Of two weighted "
       "points,\n"
       "whose last number is the weight: |ab|^2 against the sum of both, 0 if the circles or spheres are orthogonal.",
       {form<P2, W2>({"a", "b"}, power), form<P3, W3>({"a", "b"}, power), form<W2, W2>({"a", "b"}, power),
        form<W3, W3>({"a", "b"}, power)}},
  };
}

}  // namespace plumb::python
