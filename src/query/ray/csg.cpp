// Each leaf has one stretch in common with the ray; the tree is asked where stretches begin and end, from the start on.
#include "plumb/query/ray/csg.hpp"

#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "figure/k_dop/sets.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/basic/rounded_points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/overlap/ellipsoid.hpp"
#include "plumb/query/overlap/restated.hpp"
#include "plumb/query/ray/restated.hpp"

namespace plumb {
namespace query {
namespace {

/// Of the ray in a leaf: from the start or before, to the end or beyond, where there is no number.
struct Stretch {
  bool is_empty = true;
  std::optional<RayParameter> from, to;
  bool is_inside = false;  // between its ends
};

RayParameter one_less(const RayParameter& t) { return {Rational(1.0) - t.base, t.square, !t.greater}; }
RayParameter opposite(const RayParameter& t) { return {-t.base, t.square, !t.greater}; }

Line3 turned_back(const Ray3& ray) { return {ray.origin, negated(ray.direction)}; }
Segment3 turned_back(const Segment3& segment) { return {segment.b, segment.a}; }
const Point3& start_of(const Ray3& ray) { return ray.origin; }
const Point3& start_of(const Segment3& segment) { return segment.a; }

/// Does it never come out again?
template <class Shape>
bool goes_on_in(const Shape& s, const Vector3& d) {
  if (d == Vector3{}) return true;
  if constexpr (std::is_same_v<Shape, Halfspace3>) {
    return dot_sign(s.normal, d) != Sign::positive;
  } else if constexpr (std::is_same_v<Shape, Slab3>) {
    return dot_sign(s.normal, d) == Sign::zero;
  } else if constexpr (std::is_same_v<Shape, KDop3>) {
    return std::ranges::all_of(s.directions.all(), [&](const Vector3& n) { return dot_sign(n, d) == Sign::zero; });
  } else {
    return false;
  }
}

template <class Shape>
bool has_inside(const Shape& s) {
  return is_regular(s);
}
bool has_inside(const KDop3& s) {
  const arith::Constraints all = figure::halfspaces(s);
  return arith::feasible(all, std::vector<bool>(all.rows.size(), true)).slack > 0;
}
bool has_inside(const ConvexPolyhedron3& s) {
  const std::vector<Point3>& v = s.mesh.vertices;
  std::size_t b = 1, c = 2;
  while (b < v.size() && v[b] == v[0]) ++b;
  while (c < v.size() && collinear(v[0], v[b], v[c])) ++c;
  return c < v.size() &&
         std::ranges::any_of(v, [&](const Point3& p) { return orient3d(v[0], v[b], v[c], p) != Sign::zero; });
}

template <class Ray, class Shape>
Stretch stretch_in(const Ray& ray, const Shape& s, bool is_complemented) {
  const auto first = first_hit_parameter(ray, s);
  if (!first) return {};
  Stretch all{false, first, {}, false};
  if (first->sign() == Sign::zero && locate(s, start_of(ray)) == Location::inside) all.from.reset();
  if constexpr (std::is_same_v<Ray, Segment3>) {
    const auto back = first_hit_parameter(turned_back(ray), s);
    if (back->sign() != Sign::zero || locate(s, ray.b) != Location::inside) all.to = one_less(*back);
  } else {
    if (!goes_on_in(s, ray.direction)) all.to = opposite(*first_hit_parameter(turned_back(ray), s));
  }
  all.is_inside = is_complemented && relate(ray, s) == Relation::overlapping && has_inside(s);
  return all;
}

/// How leaves of a type are asked.
template <class Ray>
struct LeafMethod {
  const void* type;
  Stretch (*stretch)(const void* shape, const Ray& ray, bool is_complemented);
  std::optional<Hit> (*enter)(const void* shape, const Ray& ray);
  std::optional<Hit> (*leave)(const void* shape, const Ray& ray);  // as it is seen from there
};

template <class Ray, class Shape>
constexpr LeafMethod<Ray> method_of_leaf() {
  return {&figure::shape_tag<Shape>,
          [](const void* s, const Ray& ray, bool c) { return stretch_in(ray, *static_cast<const Shape*>(s), c); },
          [](const void* s, const Ray& ray) { return first_hit(ray, *static_cast<const Shape*>(s)); },
          [](const void* s, const Ray& ray) { return first_hit(turned_back(ray), *static_cast<const Shape*>(s)); }};
}
template <class Ray, class... Shapes>
constexpr auto methods_of() {
  return std::array{method_of_leaf<Ray, Shapes>()...};
}
template <class Ray>
inline constexpr auto leaf_methods =
    methods_of<Ray, Aabb3, Sphere3, Obb3, Cylinder3, Halfspace3, Capsule3, Cone3, Tetrahedron3, ConvexPolyhedron3,
               Lozenge3, Ellipsoid3, KDop3, Slab3, AabbCenter3>();

bool is_before(const RayParameter& a, const RayParameter& b) { return (a <=> b) < 0; }
bool is_in(const Stretch& s, const RayParameter& t, bool complemented) {
  if (!complemented) return !s.is_empty && !(s.from && is_before(t, *s.from)) && !(s.to && is_before(*s.to, t));
  return s.is_empty || !s.is_inside || (s.from && !is_before(*s.from, t)) || (s.to && !is_before(t, *s.to));
}

template <class Ray>
class TreeShot {
 public:
  TreeShot(std::string_view function, const Ray& ray, const Csg3& tree) : ray_(ray), tree_(tree) {
    if constexpr (std::is_same_v<Ray, Ray3>) {
      require_finite_parts(function, {"ray.origin", "ray.direction"}, ray.origin, ray.direction);
    } else {
      require_finite_parts(function, {"segment.a", "segment.b"}, ray.a, ray.b);
    }
    complemented_.resize(tree.leaf_count());
    static_cast<void>(tree.holds_what([&](std::size_t i, bool c) { return complemented_[i] = c, c; }));
    for (std::size_t i = 0; i < tree.leaf_count(); ++i) {
      const auto& leaf = tree.leaf(i);
      const auto* m = std::ranges::find(leaf_methods<Ray>, leaf.type, &LeafMethod<Ray>::type);
      if (m == leaf_methods<Ray>.end()) {
        throw InvalidShape(std::string(function)
                               .append(": leaf ")
                               .append(std::to_string(i))
                               .append(" of the tree is none that a line has one stretch in common with; give a convex "
                                       "solid of query/ray/csg.hpp"));
      }
      methods_.push_back(m);
      stretches_.push_back(m->stretch(leaf.shape.get(), ray, complemented_[i]));
    }
  }

  /// The first of the start and of where the set can begin, at which it holds the ray.
  [[nodiscard]] std::optional<RayParameter> first() const {
    std::vector<RayParameter> starts{RayParameter{}};
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      const auto& start = complemented_[i] ? stretches_[i].to : stretches_[i].from;
      if (!stretches_[i].is_empty && start && start->sign() == Sign::positive) starts.push_back(*start);
    }
    std::ranges::sort(starts, is_before);
    for (const RayParameter& t : starts) {
      if (tree_.holds_what([&](std::size_t i, bool c) { return is_in(stretches_[i], t, c); })) return t;
    }
    return {};
  }

  [[nodiscard]] CsgHit hit_at(const RayParameter& t) const {
    const Point3& start = start_of(ray_);
    const bool at_start = t.sign() == Sign::zero;
    const auto none = static_cast<std::uint32_t>(stretches_.size());
    const CsgHit in_all{{0, {start.x + 0.0, start.y + 0.0, start.z + 0.0}, {FeatureKind::interior, 0}, {0, 0, 0}},
                        none};
    if (at_start && tree_.locate(start) == Location::inside) return in_all;
    for (std::uint32_t i = 0; i < none; ++i) {
      const auto& leaf = tree_.leaf(i);
      if (at_start) {
        if (leaf.locate(leaf.shape.get(), start) != Location::boundary) continue;
        return {turned_if(complemented_[i], *methods_[i]->enter(leaf.shape.get(), ray_)), i};
      }
      const Stretch& s = stretches_[i];
      if (s.is_empty) continue;
      if (!complemented_[i] && s.from == t) return {*methods_[i]->enter(leaf.shape.get(), ray_), i};
      if (complemented_[i] && s.is_inside && s.to == t) {
        Hit hit = *methods_[i]->leave(leaf.shape.get(), ray_);
        hit.t = t.rounded() + 0.0;
        return {turned_if(true, hit), i};
      }
    }
    return in_all;
  }

 private:
  static Hit turned_if(bool turn, Hit hit) {
    if (turn) hit.normal = {0.0 - hit.normal.x, 0.0 - hit.normal.y, 0.0 - hit.normal.z};
    return hit;
  }

  const Ray& ray_;
  const Csg3& tree_;
  std::vector<bool> complemented_;
  std::vector<const LeafMethod<Ray>*> methods_;
  std::vector<Stretch> stretches_;
};

template <class Ray>
std::optional<CsgHit> hit_of_tree(const Ray& ray, const Csg3& tree) {
  const TreeShot<Ray> shot("first_hit", ray, tree);
  const auto t = shot.first();
  return t ? std::optional(shot.hit_at(*t)) : std::nullopt;
}

}  // namespace
}  // namespace query

std::optional<CsgHit> first_hit(const Ray3& ray, const Csg3& tree) { return query::hit_of_tree(ray, tree); }
std::optional<CsgHit> first_hit(const Segment3& segment, const Csg3& tree) { return query::hit_of_tree(segment, tree); }
std::optional<RayParameter> first_hit_parameter(const Ray3& ray, const Csg3& tree) {
  return query::TreeShot<Ray3>("first_hit_parameter", ray, tree).first();
}
std::optional<RayParameter> first_hit_parameter(const Segment3& segment, const Csg3& tree) {
  return query::TreeShot<Segment3>("first_hit_parameter", segment, tree).first();
}
bool hits(const Ray3& ray, const Csg3& tree) { return query::TreeShot<Ray3>("hits", ray, tree).first().has_value(); }
bool hits(const Segment3& segment, const Csg3& tree) {
  return query::TreeShot<Segment3>("hits", segment, tree).first().has_value();
}

}  // namespace plumb
