#include <optional>

#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull3_faces.hpp"
#include "figure/hull/hull3_methods.hpp"
#include "figure/hull/hull3_start.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"

namespace plumb {

using namespace figure::hull3;

struct Hull3Builder::State {
  std::vector<Point3> points;
  int dimension = -1;
  std::array<Id, 4> simplex{none, none, none, none};  // points that span the affine hull
  Extents extents{};                                  // at least those of the points
  std::optional<Surface> surface;                     // in space

  const Point3& base(std::size_t i) const { return points[simplex[i]]; }

  bool raises_dimension(const Point3& p) const {
    switch (dimension) {
      case -1:
        return true;
      case 0:
        return p != base(0);
      case 1:
        return !collinear(base(0), base(1), p);
      case 2:
        return orient3d(base(0), base(1), base(2), p) != Sign::zero;
      default:
        return false;
    }
  }

  /// Extents grow by their own width at least, so that faces are seldom measured again.
  void reach(const Point3& p) {
    const auto grow = [](double& min, double& max, double x) {
      if (min <= x && x <= max) return false;
      const double width = max - min;
      x < min ? min = std::min(x, x - width) : max = std::max(x, x + width);
      return true;
    };
    if (points.empty()) extents = {p, p};
    const bool x = grow(extents.min.x, extents.max.x, p.x), y = grow(extents.min.y, extents.max.y, p.y),
               z = grow(extents.min.z, extents.max.z, p.z);
    if ((x || y || z) && surface) surface->widen(extents);
  }

  void go_into_space() {
    std::vector<Node> nodes;
    for (const Point3& p : points) nodes.push_back({p, none, static_cast<Id>(nodes.size())});
    surface.emplace(std::move(nodes), extents);
    grow_quickhull(*surface, simplex, true);
  }

  bool insert_in_space(const Point3& p) {
    Id flat = none;
    for (Id f = 0; f < surface->faces().size(); ++f) {
      const Face& face = surface->faces()[f];
      if (!face.alive()) continue;
      const int side = surface->side(f, p);
      if (side > 0) continue;
      if (side < 0) {
        surface->nodes().push_back({p, none, static_cast<Id>(points.size() - 1)});
        surface->look(f, p);
        const auto cone = surface->cone(static_cast<Id>(surface->nodes().size() - 1));
        hand_on_flat(*surface, cone);
        surface->drop_visible();
        return true;
      }
      for (const Id v : face.vertex) {
        if (surface->point(v) == p) return false;
      }
      flat = f;
    }
    if (flat != none) {
      Face& face = surface->faces()[flat];
      surface->nodes().push_back({p, face.flat, static_cast<Id>(points.size() - 1)});
      face.flat = static_cast<Id>(surface->nodes().size() - 1);
    }
    return false;
  }

  /// In the affine hull of lower dimension: outside of the hull so far?
  bool is_outside(const Point3& p) const {
    if (dimension == 0) return false;
    std::vector<Point3> with = points;
    with.push_back(p);
    const Hull3 hull = convex_hull(with);
    return std::ranges::binary_search(hull.vertices, static_cast<std::uint32_t>(points.size()));
  }
};

Hull3Builder::Hull3Builder() : state_(std::make_unique<State>()) {}
Hull3Builder::~Hull3Builder() = default;
Hull3Builder::Hull3Builder(Hull3Builder&&) noexcept = default;
Hull3Builder& Hull3Builder::operator=(Hull3Builder&&) noexcept = default;

bool Hull3Builder::insert(const Point3& point) {
  State& s = *state_;
  require_finite_parts("Hull3Builder::insert", std::array<std::string_view, 1>{"point"}, point);
  if (s.points.size() >= std::size_t{1} << 29)
    throw InvalidShape("Hull3Builder::insert: it holds 2^29 points, and no more");
  s.reach(point);
  if (s.raises_dimension(point)) {
    s.points.push_back(point);
    s.simplex[static_cast<std::size_t>(++s.dimension)] = static_cast<Id>(s.points.size() - 1);
    if (s.dimension == 3) s.go_into_space();
    return true;
  }
  if (s.dimension < 3) {
    const bool outside = s.is_outside(point);
    s.points.push_back(point);
    return outside;
  }
  s.points.push_back(point);
  return s.insert_in_space(point);
}

std::span<const Point3> Hull3Builder::points() const { return state_->points; }
int Hull3Builder::dimension() const { return state_->dimension; }

Hull3 Hull3Builder::hull(const HullOptions& options) const {
  const State& s = *state_;
  if (s.dimension < 3) return convex_hull(s.points, options);
  return options.all_boundary_points ? faces_with_all_points(*s.surface, s.points.size(), options.triangulate)
                                     : faces_of(*s.surface, s.points.size(), options);
}

}  // namespace plumb
