#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/cross_products.hpp"
#include "plumb/certify/line_triangle.hpp"
#include "plumb/certify/radical.hpp"
#include "plumb/predicates.hpp"
#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/determinant.hpp"
#include "plumb/predicates/in_sphere.hpp"
#include "plumb/predicates/line_triangle.hpp"
#include "plumb/predicates/orient.hpp"
#include "python/sign_question.hpp"

namespace plumb::python {
namespace {

using P2 = Point2;
using P3 = Point3;
using V3 = Vector3;

}  // namespace

std::vector<SignQuestion> orientation_questions() {
  namespace f = predicates;
  return {
      {"orient2d",
       "Do a, b, c turn counterclockwise?  1 if so, -1 clockwise, 0 if they are collinear.",
       {classic_form<f::Orient2d, P2, P2, P2>({"a", "b", "c"}, [](const auto&... p) { return orient2d(p...); })}},
      {"orient3d",
       "On which side of the plane of a, b, c is d?  1 below it, where above is the side that sees a, b, c\n"
       "counterclockwise; 0 if the four are coplanar.",
       {classic_form<f::Orient3d, P3, P3, P3, P3>({"a", "b", "c", "d"},
                                                  [](const auto&... p) { return orient3d(p...); })}},
      {"incircle",
       "Is d inside the circle of a, b, c?  1 inside and -1 outside where a, b, c turn counterclockwise, the opposite\n"
       "where clockwise; 0 if the four are cocircular.",
       {classic_form<f::InCircle, P2, P2, P2, P2>({"a", "b", "c", "d"},
                                                  [](const auto&... p) { return incircle(p...); })}},
      {"insphere",
       "Is e inside the sphere of a, b, c, d?  1 inside and -1 outside where orient3d(a, b, c, d) is 1, the opposite\n"
       "where it is -1; 0 if the five are cospherical.",
       {classic_form<f::InSphere, P3, P3, P3, P3, P3>({"a", "b", "c", "d", "e"},
                                                      [](const auto&... p) { return insphere(p...); })}},
      {"orient_seen_from",
       "Do a, b, c turn counterclockwise for an eye that is infinitely far away in this direction?  For an eye at a "
       "point\n"
       "p it is -orient3d(a, b, c, p).",
       {formula_form<f::OrientSeenFrom, V3, P3, P3, P3>({"direction", "a", "b", "c"})}},
      {"coplanar_orientation",
       "Do a, b, c turn counterclockwise, seen from the side of their plane that the plane alone fixes: from above, of "
       "a\n"
       "vertical plane from the right (+x), of one of constant y from the front (-y)?  With d: are c and d on the "
       "same\n"
       "side of the line ab in their plane?",
       {form<P3, P3, P3>({"a", "b", "c"}, [](const auto&... p) { return coplanar_orientation(p...); }),
        formula_form<f::CoplanarSide, P3, P3, P3, P3>({"a", "b", "c", "d"})}},
      {"line_edge",
       "Does the line from origin along direction pass the edge from a to b on its left, as seen from where the line\n"
       "comes?  1 if so, 0 if they lie in one plane.",
       {formula_form<f::LineEdge, P3, V3, P3, P3>({"origin", "direction", "a", "b"})}},
      {"dot_of_crosses",
       "The sign of (a x b) . (c x d): do the planes that both pairs span turn about an acute angle?",
       {formula_form<f::DotOfCrosses, V3, V3, V3, V3>({"a", "b", "c", "d"})}},
      {"order_along_cross",
       "The sign of (u x v) . (q - p): does q lie farther than p along u x v?",
       {formula_form<f::OrderAlongCross, V3, V3, P3, P3>({"u", "v", "p", "q"})}},
      {"determinant_sign",
       "The sign of the determinant of a matrix of 2 to 5 rows.",
       {form<Rows<2>>({"rows"}, [](const auto& m) { return determinant_sign(m); }),
        form<Rows<3>>({"rows"}, [](const auto& m) { return determinant_sign(m); }),
        form<Rows<4>>({"rows"}, [](const auto& m) { return determinant_sign(m); }),
        form<Rows<5>>({"rows"}, [](const auto& m) { return determinant_sign(m); })}},
      {"sign_of_radicals",
       "The sign of a + b sqrt(c), or of a + b sqrt(c) + d sqrt(e).",
       {form<double, double, double>({"a", "b", "c"}, [](auto... x) { return sign_of_radical(x...); }),
        form<double, double, double, double, double>({"a", "b", "c", "d", "e"},
                                                     [](auto... x) { return sign_of_radicals(x...); })}},
  };
}

}  // namespace plumb::python
