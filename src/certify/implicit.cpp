// Tells what is wrong with an implicit point.
#include "plumb/certify/implicit.hpp"

#include <cmath>
#include <string>

#include "certify/refused_number.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"

namespace plumb::certify::mixed {
namespace {

[[noreturn]] void throw_point(std::string_view predicate, char argument, std::string_view why) {
  std::string text(predicate);
  text.append(": argument ").append(1, argument).append(" has no point: ").append(why);
  throw DegeneratePoint(text);
}

}  // namespace

void require_finite(const Question& question) {
  std::size_t i = 0;
  char argument = 'a';
  for (const auto& parts : question.arguments) {
    for (const PointPart& part : parts) {
      for (int axis = 0; axis < part.numbers; ++axis, ++i) {
        const double x = question.numbers[i];
        if (std::isfinite(x)) continue;
        std::string text(question.predicate);
        text.append(": ").append(1, argument).append(part.name);
        if (part.numbers > 1) text.append(1, '.').append(1, "xyz"[axis]);
        throw_not_a_number(text, x);
      }
    }
    ++argument;
  }
}

void throw_degenerate(std::string_view predicate, char argument, const LineLinePoint2& p) {
  throw_point(predicate, argument,
              p.a == p.b                              ? "its line ab has no length; give different points"
              : p.c == p.d                            ? "its line cd has no length; give different points"
              : orient2d(p.a, p.b, p.c) == Sign::zero ? "its lines ab and cd are the same line"
                                                      : "its lines ab and cd are parallel");
}

void throw_degenerate(std::string_view predicate, char argument, const LinePlanePoint3& p) {
  throw_point(predicate, argument,
              p.p == p.q                                   ? "its line pq has no length; give different points"
              : collinear(p.a, p.b, p.c)                   ? "its points a, b, c are collinear and span no plane"
              : orient3d(p.a, p.b, p.c, p.p) == Sign::zero ? "its line pq lies in the plane abc"
                                                           : "its line pq is parallel to the plane abc");
}

void throw_degenerate(std::string_view predicate, char argument, const ThreePlanePoint3& p) {
  const auto flat = [](const std::array<Point3, 3>& plane) { return collinear(plane[0], plane[1], plane[2]); };
  throw_point(predicate, argument,
              flat(p.first)    ? "the points of its first plane are collinear"
              : flat(p.second) ? "the points of its second plane are collinear"
              : flat(p.third)  ? "the points of its third plane are collinear"
                               : "its three planes are all parallel to one line");
}

}  // namespace plumb::certify::mixed
