#include "query/vclip/clip_input.hpp"

#include <string>

#include "certify/carried_errors.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::query::vclipping {

BodyView body_view(const ClipView& v) { return {.figure = view_of(*v.polyhedron), .pose = v.pose}; }

void require_faces(std::string_view function, std::string_view name, const ClipView& v) {
  if (!v.polyhedron->mesh.corners.empty()) return;
  throw InvalidShape(
      std::string(function).append(": ").append(name).append(" has no faces; make it by convex_polyhedron"));
}

Sign turn_of(const ClipView& v) {
  const auto* pose = std::get_if<const Pose*>(&v.pose.by);
  if (pose == nullptr) return Sign::positive;  // a turn, or none
  return proved_sign([&]<class T>() {
    const auto& c = (*pose)->columns;
    return dot(arith::vec<T>(c[0]), cross(arith::vec<T>(c[1]), arith::vec<T>(c[2])));
  });
}

Rational exact_square(const ClipView& a, const ClipView& b) {
  if (a.pose.stands() && b.pose.stands())
    return exact_distance_of(view_of(*a.polyhedron), view_of(*b.polyhedron), Question::squared_distance_exact).square;
  return posed_exact_distance({view_of(*a.polyhedron), a.pose}, {view_of(*b.polyhedron), b.pose},
                              Question::squared_distance_exact)
      .square;
}

}  // namespace plumb::query::vclipping
