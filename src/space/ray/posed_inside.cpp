// The crossings of query/ray/crossings.hpp, of posed triangles over any number type.
#include <algorithm>
#include <compare>
#include <string>

#include "certify/carried_errors.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/ray/posed_ray.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb {
namespace space {
namespace {

/// The side of the edge from a to b, seen along x from the point that all is seen from, which is moved in y by far more
/// than in z; zero only where a and b are seen as one point.
template <class T>
Sign moved_side_of(const query::Vec3<T>& a, const query::Vec3<T>& b, CertainSigns& ask) {
  if (const Sign s = ask(a.y * b.z - a.z * b.y); s != Sign::zero) return s;
  if (const Sign s = ask(a.z - b.z); s != Sign::zero) return s;
  return ask(b.y - a.y);
}

/// Which way does the ray from p along x leave through the triangle, which p is not on?  Zero: it does not.
Sign crossing_of(const PosedTriangle& triangle, const Point3& p) {
  return certainly<CarriedErrors<>>([&]<class T>(Carrying<T>& ask) {
    const query::WeightedCorners<T> corners(triangle);
    const query::Vec3<T> from = corners.beside(query::vector_of<T>(p));
    const query::Vec3<T> a = corners.at[0] - from, b = corners.at[1] - from, c = corners.at[2] - from;
    const Sign way = moved_side_of(a, b, ask);
    if (way == Sign::zero || moved_side_of(b, c, ask) != way || moved_side_of(c, a, ask) != way) return Sign::zero;
    return ask(query::dot(a, query::cross(b, c))) == way ? way : Sign::zero;
  });
}

struct PosedCrossing {
  std::uint32_t item;
  std::int32_t outward;
  friend auto operator<=>(const PosedCrossing&, const PosedCrossing&) = default;
};

/// Nothing for a point on a triangle.
template <class Mesh>
std::optional<std::vector<PosedCrossing>> posed_crossings(const PosedMeshOf<Mesh>& mesh, const Point3& p) {
  const auto ahead = [&](const Aabb3& box) {
    return p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z && p.z <= box.max.z;
  };
  const AnyRay point = Segment3{p, p};
  std::vector<PosedCrossing> crossed;
  const auto visit = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const PosedTriangle triangle = mesh.triangle(slot);
      const Aabb3 box = around(triangle);
      if (!ahead(box)) continue;
      if (box.min.x <= p.x && query::hits(point, triangle, HitRule::closed)) return Descent::stop;
      if (const Sign way = crossing_of(triangle, p); way != Sign::zero)
        crossed.push_back({mesh.bvh.number(slot), static_cast<std::int32_t>(way)});
    }
    return Descent::go_on;
  };
  const auto enters = [&](const BoxNode& node) { return ahead(around(mesh, node)); };
  if (descend(mesh.bvh.tree, enters, visit) == Descent::stop) return {};
  std::ranges::sort(crossed);  // an item may be in several slots
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  return crossed;
}

template <class Mesh>
Location located(const PosedMeshOf<Mesh>& mesh, const Point3& p) {
  const auto crossed = posed_crossings(mesh, p);
  if (!crossed) return Location::boundary;
  return crossed->size() % 2 == 1 ? Location::inside : Location::outside;
}

template <class Mesh>
std::optional<std::int64_t> wound(const PosedMeshOf<Mesh>& mesh, const Point3& p) {
  const auto crossed = posed_crossings(mesh, p);
  if (!crossed) return {};
  std::int64_t sum = 0;
  for (const PosedCrossing& one : *crossed) sum += one.outward;
  return sum;
}

template <class Mesh>
void require_posed_point(const char* function, const PosedMeshOf<Mesh>& mesh, const Point3& p) {
  require_pose(function, "mesh", mesh.pose);
  query::require_figure(function, "p", p);
}

template <class Mesh, class Out, class Answer>
void answer_posed_points(const char* function, const PosedMeshOf<Mesh>& mesh, std::span<const Point3> points,
                         std::span<Out> out, Execution execution, const Answer& answer) {
  if (out.size() != points.size()) {
    throw UnequalLengths(std::string(function) + ": out has " + std::to_string(out.size()) + " items, points has " +
                         std::to_string(points.size()));
  }
  for_blocks(execution, points.size(), 16, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      require_posed_point(function, mesh, points[i]);
      out[i] = answer(points[i]);
    }
  });
}

}  // namespace
}  // namespace space

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_POSED_INSIDE(Mesh)                                                                                    \
  Location locate(const Mesh& mesh, const Point3& p) {                                                              \
    space::require_posed_point("locate", mesh, p);                                                                  \
    return space::located(mesh, p);                                                                                 \
  }                                                                                                                 \
  bool contains(const Mesh& mesh, const Point3& p) {                                                                \
    space::require_posed_point("contains", mesh, p);                                                                \
    return space::located(mesh, p) != Location::outside;                                                            \
  }                                                                                                                 \
  std::optional<std::int64_t> winding_number(const Mesh& mesh, const Point3& p) {                                   \
    space::require_posed_point("winding_number", mesh, p);                                                          \
    return space::wound(mesh, p);                                                                                   \
  }                                                                                                                 \
  void locate(const Mesh& mesh, std::span<const Point3> points, std::span<Location> out, Execution execution) {     \
    space::answer_posed_points("locate", mesh, points, out, execution,                                              \
                               [&](const Point3& p) { return space::located(mesh, p); });                           \
  }                                                                                                                 \
  void winding_number(const Mesh& mesh, std::span<const Point3> points, std::span<std::optional<std::int64_t>> out, \
                      Execution execution) {                                                                        \
    space::answer_posed_points("winding_number", mesh, points, out, execution,                                      \
                               [&](const Point3& p) { return space::wound(mesh, p); });                             \
  }
PLUMB_POSED_INSIDE(PosedMesh)
PLUMB_POSED_INSIDE(PosedCompactMesh)
#undef PLUMB_POSED_INSIDE

}  // namespace plumb
