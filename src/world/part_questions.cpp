#include "world/part_questions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "plumb/query/body/hit_pairs.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/ray/mesh_ray.hpp"
#include "query/body/upright_box.hpp"
#include "world/grown_box.hpp"

namespace plumb::world {
namespace {

AnyFigure figure_of_ray(const AnyRay& ray) {
  if (ray.kind == AnyRay::Kind::segment) return Segment3{ray.origin, ray.end};
  if (ray.kind == AnyRay::Kind::line) return Line3{ray.origin, ray.direction};
  return Ray3{ray.origin, ray.direction};
}

/// Points and segments are thinner than what rays are asked about.
bool is_asked_by_rays(const AnyFigure& figure) {
  return query::hit_pairs.answers(FigureKind::ray, figure.kind(), figure.dimension());
}

/// The same box without its pose, where doubles say where it stands: the same point set by numbers that need no rationals.
AnyFigure standing(const AnyFigure& figure) {
  const auto* pose = std::get_if<RigidPose>(&figure.pose());
  if (pose == nullptr || !(pose->turn == Rotation{})) return figure;
  const auto box = query::upright_box(figure.view());
  if (!box) return figure;
  const auto is_double = [](const query::FacePlace& p) { return p.is_finite() && p.rest == 0; };
  if (!std::ranges::all_of(box->low, is_double) || !std::ranges::all_of(box->high, is_double)) return figure;
  return Aabb3{{box->low[0].nearest, box->low[1].nearest, box->low[2].nearest},
               {box->high[0].nearest, box->high[1].nearest, box->high[2].nearest}};
}

/// The figure itself, or a triangle of the mesh.
AnyFigure figure_at(const Placed& part, std::uint32_t triangle) {
  if (const auto* figure = std::get_if<AnyFigure>(&part)) return standing(*figure);
  return std::get<PlacedMesh>(part).triangle(triangle);
}

/// The figures of a part that may come to a box, with their numbers.
std::vector<std::pair<std::uint32_t, AnyFigure>> figures_near(const Placed& part, const Aabb3& box) {
  std::vector<std::pair<std::uint32_t, AnyFigure>> all;
  if (const auto* figure = std::get_if<AnyFigure>(&part)) {
    all.emplace_back(0, standing(*figure));
    return all;
  }
  const PlacedMesh& mesh = std::get<PlacedMesh>(part);
  for (const std::uint32_t t : mesh.near(box)) all.emplace_back(t, mesh.triangle(t));
  return all;
}

Root time_of(const AnyFigure& a, const Vector3& by_a, const AnyFigure& b, const Vector3& by_b) {
  return *first_contact_time(Translating<AnyFigure>{a, by_a}, Translating<AnyFigure>{b, by_b});
}

}  // namespace

std::optional<PartHit> first_hit(const Placed& part, const AnyRay& ray) {
  if (const auto* figure = std::get_if<AnyFigure>(&part)) {
    if (!is_asked_by_rays(*figure)) return {};
    const auto hit = query::any_first_hit(figure_of_ray(ray).view(), standing(*figure).view());
    if (!hit) return {};
    return PartHit{0, *hit};
  }
  const auto hit = plumb::first_hit(std::get<PlacedMesh>(part).view(), ray);
  if (!hit) return {};
  return PartHit{hit->index, hit->hit};
}

RayParameter hit_parameter(const Placed& part, std::uint32_t triangle, const AnyRay& ray) {
  return *query::any_first_hit_parameter(figure_of_ray(ray).view(), figure_at(part, triangle).view());
}

bool is_hit(const Placed& part, const AnyRay& ray) {
  if (const auto* mesh = std::get_if<PlacedMesh>(&part)) return any_hit(mesh->view(), ray);
  const AnyFigure& figure = std::get<AnyFigure>(part);
  return is_asked_by_rays(figure) && query::any_hits(figure_of_ray(ray).view(), standing(figure).view());
}

PartDistance distance_to(const Placed& part, const AnyFigure& figure) {
  if (const auto* own = std::get_if<AnyFigure>(&part)) return {0, distance(standing(*own), figure)};
  const PlacedMesh& mesh = std::get<PlacedMesh>(part);
  const std::uint32_t some = mesh.mesh().bvh().number(0);
  // No triangle that is nearer lies wholly out of that reach.
  const double reach = std::nextafter(distance(mesh.triangle(some), figure), std::numeric_limits<double>::infinity());
  std::optional<PartDistance> best;
  for (const std::uint32_t t : mesh.near(grown(box_of_figure(figure), reach))) {
    const double d = distance(mesh.triangle(t), figure);
    const auto is_nearer = [&] {
      return compare(exact_distance_to(part, t, figure), exact_distance_to(part, best->triangle, figure)) ==
             Sign::negative;
    };
    if (!best || d < best->distance || (d == best->distance && is_nearer())) best = {t, d};
  }
  return *best;
}

ExactDistance exact_distance_to(const Placed& part, std::uint32_t triangle, const AnyFigure& figure) {
  return exact_distance(figure_at(part, triangle), figure);
}

PartsDistance distance_of_parts(const Placed& a, const Placed& b) {
  if (const auto* figure = std::get_if<AnyFigure>(&b)) {
    const PartDistance found = distance_to(a, *figure);
    return {found.triangle, 0, found.distance};
  }
  if (const auto* figure = std::get_if<AnyFigure>(&a)) {
    const PartDistance found = distance_to(b, *figure);
    return {0, found.triangle, found.distance};
  }
  const auto found =
      closest_triangles(std::get<PlacedMesh>(a).bvh_view(), std::get<PlacedMesh>(b).bvh_view(), {.first = true});
  return {found->a, found->b, found->closest.distance};
}

ExactDistance exact_distance_of_parts(const Placed& a, std::uint32_t triangle_a, const Placed& b,
                                      std::uint32_t triangle_b) {
  return exact_distance(figure_at(a, triangle_a), figure_at(b, triangle_b));
}

std::optional<PartTime> first_contact(const PartInMotion& a, const PartInMotion& b) {
  const Aabb3 way_of_a = swept(box_of(a.part), a.by), way_of_b = swept(box_of(b.part), b.by);
  // Triangles are asked where they begin: by the box of what may come to them.
  const auto backwards = [](const Aabb3& box, const Vector3& by) { return swept(box, {-by.x, -by.y, -by.z}); };
  std::optional<PartTime> best;
  const auto of_b = figures_near(b.part, backwards(way_of_a, b.by));
  for (const auto& [i, p] : figures_near(a.part, backwards(way_of_b, a.by))) {
    for (const auto& [j, q] : of_b) {
      const auto c = plumb::first_contact(Translating<AnyFigure>{p, a.by}, Translating<AnyFigure>{q, b.by});
      if (!c) continue;
      const PartTime found{i, j, *c};
      const bool is_before = !best || c->time < best->contact.time ||
                             (c->time == best->contact.time && contact_time(a, b, found) < contact_time(a, b, *best));
      if (is_before) best = found;
    }
  }
  return best;
}

Root contact_time(const PartInMotion& a, const PartInMotion& b, const PartTime& of) {
  return time_of(figure_at(a.part, of.triangle_a), a.by, figure_at(b.part, of.triangle_b), b.by);
}

Aabb3 swept(const Aabb3& b, const Vector3& by) {
  constexpr double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const auto low = [&](double x, double d) { return d < 0 ? std::max(std::nextafter(x + d, -infinity), -most) : x; };
  const auto high = [&](double x, double d) { return d > 0 ? std::min(std::nextafter(x + d, infinity), most) : x; };
  return {{low(b.min.x, by.x), low(b.min.y, by.y), low(b.min.z, by.z)},
          {high(b.max.x, by.x), high(b.max.y, by.y), high(b.max.z, by.z)}};
}

}  // namespace plumb::world
