// Compiles the decisions of the manifest once: code that is not optimized calls them here.
#undef PLUMB_CHECKED  // who looks at the thread compiles them anew (certify/checked.hpp)

#include "plumb/certify/sign_of.hpp"

namespace plumb {

template <Formula F>
requires in_library<F> Sign decide_in_library(const Coordinates<F>& p) { return decide_here<F>(p, NoRecorder{}); }

#define PLUMB_COMPILE(formula) \
  template Sign decide_in_library<predicates::formula>(const Coordinates<predicates::formula>&);
PLUMB_PREDICATES(PLUMB_COMPILE)
#undef PLUMB_COMPILE

template Sign sign_of(predicates::Orient2d, const Point2&, const Point2&, const Point2&);
template Sign sign_of(predicates::Orient3d, const Point3&, const Point3&, const Point3&, const Point3&);
template Sign sign_of(predicates::InCircle, const Point2&, const Point2&, const Point2&, const Point2&);
template Sign sign_of(predicates::InSphere, const Point3&, const Point3&, const Point3&, const Point3&, const Point3&);

}  // namespace plumb
