#include "plumb/space/bsp/bsp_ray.hpp"

#include <algorithm>
#include <string>

#include "certify/finite.hpp"
#include "plumb/arith/error.hpp"
#include "space/bsp/face_figure.hpp"
#include "space/bsp/ray_planes.hpp"

namespace plumb {
namespace {

using space::RayPassage;
using space::RayPlace;
using space::RayPlanes;

/// What of the ray is in a closed cell.
struct CellSpan {
  BspChild child;
  RayPlace from, to;
};

/// The first places in closed leaves that are solid, and in those that are not.
struct FirstPlaces {
  std::optional<RayPlace> solid, empty;
  std::uint32_t solid_leaf = 0;
};

class SolidWalk {
 public:
  SolidWalk(const BspTree& tree, const AnyRay& ray) : tree_(tree), planes_(tree, ray) {}

  [[nodiscard]] FirstPlaces first_places() {
    todo_.push_back({tree_.root, planes_.begin(), planes_.end()});
    while (!todo_.empty()) {
      const CellSpan span = todo_.back();
      todo_.pop_back();
      if (found_.solid && found_.empty && !comes_first(span.from, last_of_both())) continue;
      if (span.child.is_leaf()) {
        take(span);
      } else {
        divide(span);
      }
    }
    return found_;
  }

  [[nodiscard]] RayPlace last_of_both() const {
    return comes_first(*found_.solid, *found_.empty) ? *found_.empty : *found_.solid;
  }
  [[nodiscard]] bool comes_first(const RayPlace& a, const RayPlace& b) const {
    return planes_.compare(a, b) == Sign::negative;
  }
  [[nodiscard]] const RayPlanes& planes() const { return planes_; }

 private:
  void take(const CellSpan& span) {
    std::optional<RayPlace>& first = span.child.is_solid() ? found_.solid : found_.empty;
    if (first && !comes_first(span.from, *first)) return;
    first = span.from;
    if (span.child.is_solid()) found_.solid_leaf = span.child.index();
  }

  /// The nearer part is done first.
  void divide(const CellSpan& span) {
    const BspNode& node = tree_.nodes[span.child.index()];
    const RayPassage p = planes_.passage(node);
    if (p.heading == Sign::zero) {
      if (p.from != Sign::negative) todo_.push_back({node.front, span.from, span.to});
      if (p.from != Sign::positive) todo_.push_back({node.back, span.from, span.to});
      return;
    }
    const BspChild far = p.heading == Sign::positive ? node.front : node.back;
    const BspChild near = p.heading == Sign::positive ? node.back : node.front;
    const Sign after_begin = planes_.compare(p.place, span.from);
    if (after_begin == Sign::negative) {
      todo_.push_back({far, span.from, span.to});
      return;
    }
    if (after_begin == Sign::zero) {
      todo_.push_back({far, span.from, span.to});
      todo_.push_back({near, span.from, span.from});
      return;
    }
    const Sign after_end = planes_.compare(p.place, span.to);
    if (after_end == Sign::positive) {
      todo_.push_back({near, span.from, span.to});
      return;
    }
    todo_.push_back({far, p.place, span.to});
    todo_.push_back({near, span.from, p.place});
  }

  const BspTree& tree_;
  RayPlanes planes_;
  std::vector<CellSpan> todo_;
  FirstPlaces found_;
};

struct FaceThere {
  std::uint32_t face;
  bool is_parallel;
  friend bool operator<(const FaceThere& a, const FaceThere& b) { return a.face < b.face; }
};

/// Of the nodes in whose planes the place is.
std::vector<FaceThere> faces_near(const BspTree& tree, const RayPlanes& planes, const RayPlace& place) {
  std::vector<FaceThere> faces;
  std::vector<BspChild> todo{tree.root};
  while (!todo.empty()) {
    const BspChild at = todo.back();
    todo.pop_back();
    if (at.is_leaf()) continue;
    const BspNode& node = tree.nodes[at.index()];
    const RayPassage p = planes.passage(node);
    const Sign s = planes.side(p, place);
    if (s != Sign::negative) todo.push_back(node.front);
    if (s != Sign::positive) todo.push_back(node.back);
    if (s != Sign::zero) continue;
    for (std::uint32_t i = tree.first_piece[at.index()]; i < tree.first_piece[at.index() + 1]; ++i)
      faces.push_back({tree.pieces[i].face, p.heading == Sign::zero});
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The exact parameter of a place.
Rational parameter_of(const BspTree& tree, const AnyRay& ray, const RayPlace& place) {
  if (place.plane == space::ray_begin) return Rational(0);
  const auto [a, b, c] = tree.points_of_plane(place.plane);
  const auto vec = [](const Point3& q, const Point3& p) {
    return std::array{Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y), Rational(q.z) - Rational(p.z)};
  };
  const bool is_segment = ray.kind == AnyRay::Kind::segment;
  const Vector3& d = ray.direction;
  const auto along = is_segment ? vec(ray.end, ray.origin) : std::array{Rational(d.x), Rational(d.y), Rational(d.z)};
  const auto u = vec(b, a), v = vec(c, a), w = vec(a, ray.origin);
  Rational above(0), below(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Rational normal = u[i] * v[j] - u[j] * v[i];
    above = above + normal * w[k];
    below = below + normal * along[k];
  }
  return above / below;
}

void require_ray(std::string_view function, const BspTree& tree, const AnyRay& ray) {
  if (tree.kind != BspKind::solid_leaf) {
    throw InvalidShape(
        std::string(function).append(": the tree has no solid leaves; build_bsp with BspKind::solid_leaf"));
  }
  if (ray.kind == AnyRay::Kind::segment) {
    require_finite(function, ray.origin, ray.end);
  } else {
    require_finite(function, ray.origin, ray.direction);
  }
}

}  // namespace

bool any_hit(const BspTree& tree, const AnyRay& ray) {
  require_ray("any_hit", tree, ray);
  const FirstPlaces found = SolidWalk(tree, ray).first_places();
  return found.solid && found.empty;
}

std::optional<BspHit> first_hit(const BspTree& tree, const AnyRay& ray) {
  require_ray("first_hit", tree, ray);
  SolidWalk walk(tree, ray);
  const FirstPlaces found = walk.first_places();
  if (!found.solid || !found.empty) return {};
  const RayPlace place = walk.last_of_both();
  const bool from_inside = walk.comes_first(*found.solid, *found.empty);
  std::optional<Rational> t;
  for (const FaceThere& f : faces_near(tree, walk.planes(), place)) {
    if (f.is_parallel) {  // it may have been hit before, where it is no boundary
      if (!t) t = parameter_of(tree, ray, place);
      const auto first =
          space::ask_face(tree, f.face, [&](const auto& face) { return first_hit_parameter(ray, face); });
      if (!first || *first != RayParameter{*t}) continue;
    }
    const auto hit =
        space::ask_face(tree, f.face, [&](const auto& face) -> std::optional<Hit> { return first_hit(ray, face); });
    if (hit) return BspHit{f.face, *hit, found.solid_leaf, from_inside};
  }
  return {};
}

}  // namespace plumb
