#include "query/separation/convex_body.hpp"

#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/posed_radius.hpp"

namespace plumb::query {
namespace {

[[noreturn]] void throw_empty(std::string_view function, std::string_view name) {
  throw InvalidShape(std::string(function).append(": ").append(name).append(
      " is empty, and an empty set has no corner; give one that has a point"));
}

void require_hull(std::string_view function, const std::string& name, const BodyView& body) {
  if (body.vertices.empty()) throw_empty(function, name);
  for (std::size_t i = 0; i < body.vertices.size(); ++i) {
    if (is_real(sum_of(body.vertices[i]))) continue;
    const std::string part = name + ".vertices[" + std::to_string(i) + "]";
    require_finite_parts(function, {part}, body.vertices[i]);
  }
  if (body.radius >= 0 && is_real(body.radius)) return;
  figure::refuse_number(function, name + ".radius", std::array{body.radius});
  figure::refuse_length(function, name + ".radius");
}

/// Throws where the polygon is not planar or not convex; on one line it may be.
void require_convex(std::string_view function, std::string_view name, const FigureView& figure) {
  with_figure(figure, [&]<class Shape>(const Shape& s) {
    PolygonKind kind = PolygonKind::convex;
    if constexpr (std::is_same_v<Shape, Polygon3>) kind = convexity(s).kind;
    if constexpr (std::is_same_v<Shape, Quadrilateral3>) kind = convexity(Polygon3{{s.a, s.b, s.c, s.d}}).kind;
    const auto refuse = [&](const char* what) {
      throw InvalidShape(std::string(function).append(": ").append(name).append(what));
    };
    if (kind == PolygonKind::not_planar) refuse(" is not planar; triangulate it or ask its triangles");
    if (kind == PolygonKind::concave || kind == PolygonKind::self_winding)
      refuse(" is not convex; triangulate it or ask its convex pieces");
  });
}

CoreCorners sound_corners(std::string_view function, std::string_view name, const BodyView& body) {
  if (body.is_hull()) {
    const std::string of_shape = std::string(name).append(!body.pose.stands() ? ".shape" : "");
    require_hull(function, of_shape, body);
    if (!body.pose.stands()) {
      constexpr Point3 origin{};
      require_posed(function, name, {view_of(origin), body.pose});
    }
  } else {
    require_posed(function, name, {body.figure, body.pose});
    const bool may_be_concave = is_one_of(body.figure.kind, {FigureKind::polygon, FigureKind::quadrilateral});
    if (may_be_concave) {
      require_convex(function, std::string(name).append(!body.pose.stands() ? ".shape" : ""), body.figure);
    }
  }
  if (const auto corners = CoreCorners::of(body)) return *corners;
  throw_empty(function, name);
}

std::array<std::string_view, 2> names_of(const BodyView& a, const BodyView& b) {
  const bool alike = a.is_hull() == b.is_hull() && (a.is_hull() || a.figure.kind == b.figure.kind);
  if (alike) return {"a", "b"};
  return {spoken(a), spoken(b)};
}

}  // namespace

std::string_view spoken(const BodyView& body) { return body.is_hull() ? "hull" : spoken(body.figure); }

Body body_of(std::string_view function, std::string_view name, const BodyView& body) {
  const CoreCorners corners = sound_corners(function, name, body);
  const double radius = radius_of(body);
  if (radius == 0 || body.pose.stands()) return {corners, radius};
  const Sphere3 around{{0, 0, 0}, radius};  // each place of a hull
  const PosedView posed{body.is_hull() ? view_of(around) : body.figure, body.pose};
  return {corners, radius_of_image(function, posed, posed_set(posed))};
}

double radius_of(const BodyView& body) {
  return body.is_hull() ? body.radius : is_flat_kind(body.figure.kind) ? 0 : radius_of(body.figure);
}

std::array<CoreCorners, 2> corners_of(std::string_view function, const BodyView& a, const BodyView& b) {
  const auto [name_a, name_b] = names_of(a, b);
  std::array<CoreCorners, 2> corners{sound_corners(function, name_a, a), sound_corners(function, name_b, b)};
  bring_to_one_weight(corners[0], corners[1]);
  return corners;
}

std::array<Body, 2> bodies_of(std::string_view function, const BodyView& a, const BodyView& b) {
  const auto [name_a, name_b] = names_of(a, b);
  std::array<Body, 2> bodies{body_of(function, name_a, a), body_of(function, name_b, b)};
  bring_to_one_weight(bodies[0].corners, bodies[1].corners);
  return bodies;
}

}  // namespace plumb::query
