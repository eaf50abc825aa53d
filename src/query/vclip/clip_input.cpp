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
  if (v.pose == nullptr) return Sign::positive;
  return proved_sign([&]<class T>() {
    const auto& c = v.pose->columns;
    return dot(arith::vec<T>(c[0]), cross(arith::vec<T>(c[1]), arith::vec<T>(c[2])));
  });
}

Rational exact_square(const ClipView& a, const ClipView& b) {
  if (a.pose == nullptr && b.pose == nullptr)
    return exact_distance_of(view_of(*a.polyhedron), view_of(*b.polyhedron), Question::squared_distance_exact).square;
  const auto posed = [](const ClipView& v) {
    return Posed{*v.polyhedron, v.pose != nullptr ? *v.pose : identity_pose};
  };
  return squared_distance_exact(posed(a), posed(b));
}

}  // namespace plumb::query::vclipping
