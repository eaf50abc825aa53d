#include "world/gpu/shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "plumb/arith/interval.hpp"
#include "world/state.hpp"

namespace plumb::world {
namespace {

class Collector {
 public:
  explicit Collector(DrawnShape& into) : into_(into) {}

  /// The next corners are those of a shape under this pose.
  void start(const AnyPose& pose) {
    pose_ = pose;
    known_.clear();
  }
  std::uint32_t corner(const Point3& p) {
    const auto [at, is_new] = known_.try_emplace(std::tuple(p.x, p.y, p.z), next());
    if (is_new) add({p, p});
    return at->second;
  }
  std::uint32_t corner(const Aabb3& box) {
    add(box);
    return next() - 1;
  }
  void face(std::uint32_t a, std::uint32_t b, std::uint32_t c) { into_.faces.push_back({a, b, c}); }
  void surface(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    face(a, b, c);
    for (const auto& [p, q] : {std::minmax(a, b), std::minmax(b, c), std::minmax(c, a)})
      if (kept_.insert({p, q}).second) into_.edges.push_back({p, q});
  }
  /// The faces of a box whose corner i is beyond the middle along axis k where bit k of i is set.
  void box(std::uint32_t first) {
    constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& s : sides) {
      face(first + s[0], first + s[1], first + s[2]);
      face(first + s[0], first + s[2], first + s[3]);
    }
  }

 private:
  [[nodiscard]] std::uint32_t next() const { return static_cast<std::uint32_t>(into_.corners.size()); }
  void add(const Aabb3& box) {
    into_.corners.push_back(pose_.index() == 0 ? box : box_of_figure(AnyFigure(box).under(pose_)));
  }

  DrawnShape& into_;
  AnyPose pose_;
  std::map<std::tuple<double, double, double>, std::uint32_t> known_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> kept_;  // edges, each of which two faces of a closed mesh have
};

/// The corners of the parallelepiped, nothing where a double may not hold one.
std::optional<std::array<Aabb3, 8>> corners_of(const Obb3& box) {
  std::array<Aabb3, 8> corners{};
  const std::array<double, 3> half{box.half.x, box.half.y, box.half.z};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto along = [&](double middle, double Vector3::*part) {
      Interval at(middle);
      for (std::size_t k = 0; k < 3; ++k) {
        const Interval way = Interval(box.axes[k].*part) * Interval(half[k]);
        at = (i >> k & 1) != 0 ? at + way : at - way;
      }
      return at;
    };
    const Interval x = along(box.center.x, &Vector3::x), y = along(box.center.y, &Vector3::y),
                   z = along(box.center.z, &Vector3::z);
    for (const double bound : {x.lower, x.upper, y.lower, y.upper, z.lower, z.upper})
      if (!std::isfinite(bound)) return {};
    corners[i] = {{x.lower, y.lower, z.lower}, {x.upper, y.upper, z.upper}};
  }
  return corners;
}

/// Are the faces of this figure known?  Else it is drawn as its box.
bool add_flat_faces(const AnyFigure& figure, Collector& to, bool& is_surface) {
  is_surface = false;
  if (const auto* p = get_if<Point3>(figure)) {
    const std::uint32_t at = to.corner(*p);
    to.surface(at, at, at);
    return is_surface = true;
  }
  if (const auto* s = get_if<Segment3>(figure)) {
    const std::uint32_t a = to.corner(s->a), b = to.corner(s->b);
    to.surface(a, b, b);
    return is_surface = true;
  }
  if (const auto* t = get_if<Triangle3>(figure)) {
    to.surface(to.corner(t->a), to.corner(t->b), to.corner(t->c));
    return is_surface = true;
  }
  if (const auto* t = get_if<Tetrahedron3>(figure)) {
    const std::array at{to.corner(t->a), to.corner(t->b), to.corner(t->c), to.corner(t->d)};
    for (std::size_t i = 0; i < 4; ++i) to.face(at[(i + 1) % 4], at[(i + 2) % 4], at[(i + 3) % 4]);
    return true;
  }
  if (const auto* p = get_if<ConvexPolyhedron3>(figure)) {
    for (std::size_t f = 0; f + 1 < p->mesh.first.size(); ++f) {
      const std::span corners =
          std::span(p->mesh.corners).subspan(p->mesh.first[f], p->mesh.first[f + 1] - p->mesh.first[f]);
      const auto at = [&](std::size_t i) { return to.corner(p->mesh.vertices[corners[i]]); };
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) to.face(at(0), at(i), at(i + 1));
    }
    return true;
  }
  std::optional<std::array<Aabb3, 8>> corners;
  if (const auto* box = get_if<Obb3>(figure)) corners = corners_of(*box);
  if (const auto* box = get_if<Aabb3>(figure); box != nullptr && figure.is_posed()) {
    corners.emplace();
    for (std::size_t i = 0; i < 8; ++i) {
      const Point3 at{(i & 1) != 0 ? box->max.x : box->min.x, (i & 2) != 0 ? box->max.y : box->min.y,
                      (i & 4) != 0 ? box->max.z : box->min.z};
      (*corners)[i] = {at, at};
    }
  }
  if (!corners) return false;
  const std::uint32_t first = to.corner((*corners)[0]);
  for (std::size_t i = 1; i < 8; ++i) to.corner((*corners)[i]);
  to.box(first);
  return true;
}

}  // namespace

std::vector<Placed> placed_parts(const AnyBody& body) {
  std::vector<Placed> parts;
  for (const AnyBody::Part& part : body.parts()) parts.push_back(placed(part, body.pose()));
  return parts;
}

DrawnShape drawn_shape(const std::vector<Placed>& parts) {
  DrawnShape shape;
  Collector to(shape);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Aabb3 box = box_of(parts[i]);
    shape.box = i == 0 ? box : joined(shape.box, box);
    if (const auto* mesh = std::get_if<PlacedMesh>(&parts[i])) {
      to.start(mesh->pose());
      const Bvh& bvh = mesh->mesh().bvh();
      for (std::size_t slot = 0; slot < bvh.slots(); ++slot) {
        const Triangle3 t = bvh.triangle(slot);
        to.surface(to.corner(t.a), to.corner(t.b), to.corner(t.c));
      }
      continue;
    }
    const AnyFigure& figure = std::get<AnyFigure>(parts[i]);
    bool is_surface = false;
    to.start(figure.pose());
    if (!add_flat_faces(figure, to, is_surface)) {
      to.start({});
      const std::uint32_t all = to.corner(box);
      to.face(all, all, all);
    }
    shape.is_surface = shape.is_surface && is_surface;
  }
  return shape;
}

}  // namespace plumb::world
