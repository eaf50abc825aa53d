#include "world/proxy_around.hpp"

#include <array>

#include "plumb/arith/error.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/obb/fits.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "world/placed.hpp"

namespace plumb {
namespace {

void add_corners_of_box(const Aabb3& box, std::vector<Point3>& to) {
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) to.push_back({x, y, z});
}

/// Nothing of figures that are not the hull of corners in doubles.
std::vector<Point3> own_corners(const AnyFigure& figure) {
  if (const auto* t = get_if<Triangle3>(figure)) return {t->a, t->b, t->c};
  if (const auto* t = get_if<Tetrahedron3>(figure)) return {t->a, t->b, t->c, t->d};
  if (const auto* p = get_if<Polygon3>(figure)) return {p->vertices.begin(), p->vertices.end()};
  if (const auto* p = get_if<ConvexPolyhedron3>(figure)) return p->mesh.vertices;
  return {};
}

std::optional<AnyFigure> fitted(const std::vector<Point3>& points, ProxyKind kind) {
  switch (kind) {
    case ProxyKind::none:
      break;
    case ProxyKind::sphere:
      return AnyFigure(minimum_sphere(points).sphere);
    case ProxyKind::obb:
      return AnyFigure(fit_obb_around_principal(points));
    case ProxyKind::hull:
      if (const Hull3 hull = convex_hull(points); hull.dimension == 3)
        return AnyFigure(convex_polyhedron(hull, points));
      break;
  }
  return {};
}

}  // namespace

namespace world {

std::vector<Point3> points_around(const AnyBody::Part& part) {
  const bool is_posed = part.pose.index() != 0;
  std::vector<Point3> points;
  if (const auto* mesh = std::get_if<SharedMesh>(&part.shape)) {
    const Bvh& bvh = mesh->bvh();
    for (std::size_t slot = 0; slot < bvh.slots(); ++slot) {
      const Triangle3 t = bvh.triangle(slot);
      if (!is_posed) points.insert(points.end(), {t.a, t.b, t.c});
      if (is_posed) add_corners_of_box(box_of(placed({AnyFigure(t), {}}, part.pose)), points);
    }
    return points;
  }
  const AnyFigure& figure = std::get<AnyFigure>(part.shape);
  if (!figure.is_posed()) points = own_corners(figure);
  if (points.empty()) add_corners_of_box(box_of(placed(part, {})), points);
  return points;
}

std::optional<AnyFigure> proxy_around(const std::vector<Point3>& points, ProxyKind kind) {
  try {
    return fitted(points, kind);
  } catch (const BeyondDoubles&) {  // there is none
    return {};
  }
}

}  // namespace world

std::string_view name_of(ProxyKind kind) {
  constexpr std::array<std::string_view, proxy_kinds> names{"none", "sphere", "box", "hull"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<AnyFigure> proxy_of(const AnyBody& body, ProxyKind kind) {
  if (kind == ProxyKind::none) return {};
  if (body.parts().size() == 1 && body.parts()[0].pose.index() == 0) {
    if (const auto* mesh = std::get_if<SharedMesh>(&body.parts()[0].shape)) return mesh->proxy(kind);
  }
  std::vector<Point3> points;
  for (const AnyBody::Part& part : body.parts()) {
    const std::vector<Point3> around = world::points_around(part);
    points.insert(points.end(), around.begin(), around.end());
  }
  return world::proxy_around(points, kind);
}

}  // namespace plumb
