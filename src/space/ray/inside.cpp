#include "plumb/space/ray/inside.hpp"

#include <algorithm>
#include <compare>
#include <vector>

#include "certify/carried_errors.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/crossings.hpp"
#include "query/ray/posed_triangle.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/parts.hpp"
#include "space/ray/along_x.hpp"

namespace plumb {
namespace space {
namespace {

/// A triangle that is crossed, and which way.
struct CrossedItem {
  std::uint32_t item;
  std::int32_t outward;
  friend auto operator<=>(const CrossedItem&, const CrossedItem&) = default;
};

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

/// May the ray from p along x meet the box?
bool is_ahead(const Aabb3& box, const Point3& p) {
  return p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y && box.min.z <= p.z && p.z <= box.max.z;
}

/// How often a triangle is crossed outward; nothing where the point is on it.
std::optional<Sign> crossed(const Triangle3& triangle, const Point3& p) {
  query::Crossings one;
  if (!one.take(triangle, p)) return {};
  return static_cast<Sign>(one.outward);
}
std::optional<Sign> crossed(const PosedTriangle& triangle, const Point3& p) {
  const Aabb3 box = around(triangle);
  if (!is_ahead(box, p)) return Sign::zero;
  if (box.min.x <= p.x && query::hits(Segment3{p, p}, triangle, HitRule::closed)) return {};
  return crossing_of(triangle, p);
}

template <class Source>
auto entered_along_x(const Source& source, const Point3& p) {
  if constexpr (is_posed_source<Source>) {
    return [&source, p](const BoxNode& node) { return is_ahead(around(source, node), p); };
  } else {
    return AlongX(source.tree.frame, p);
  }
}

/// Nothing for a point on a triangle.
template <class Source>
std::optional<query::Crossings> crossings(const Source& source, const Point3& p) {
  std::vector<CrossedItem> all;
  const auto& mesh = mesh_of(source);
  const auto visit = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const auto way = crossed(source.triangle(slot), p);
      if (!way) return Descent::stop;
      if (*way != Sign::zero) all.push_back({mesh.number(slot), static_cast<std::int32_t>(*way)});
    }
    return Descent::go_on;
  };
  if (descend(mesh.tree, entered_along_x(source, p), visit) == Descent::stop) return {};
  std::ranges::sort(all);  // an item may be in several slots
  all.erase(std::unique(all.begin(), all.end()), all.end());
  query::Crossings found;
  found.count = all.size();
  for (const CrossedItem& one : all) found.outward += one.outward;
  return found;
}

Location location_of(const std::optional<query::Crossings>& found) {
  if (!found) return Location::boundary;
  return found->count % 2 == 1 ? Location::inside : Location::outside;
}
std::optional<std::int64_t> winding_of(const std::optional<query::Crossings>& found) {
  if (!found) return {};
  return found->outward;
}

std::optional<query::Crossings> crossings_of(const char* function, const MeshView& mesh, const Point3& p) {
  return with_source(function, "mesh", mesh, [&](const auto& source) {
    query::require_figure(function, "p", p);
    return crossings(source, p);
  });
}

template <class Out, class Answer>
void answer_points(const char* function, const MeshView& mesh, std::span<const Point3> points, std::span<Out> out,
                   Execution execution, const Answer& answer) {
  require_equal_lengths(function, "out", out.size(), "points", points.size());
  with_source(function, "mesh", mesh, [&]<class Source>(const Source& source) {
    constexpr std::size_t points_of_block = is_posed_source<Source> ? 16 : 256;
    for_blocks(execution, points.size(), points_of_block, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        query::require_figure(function, "p", points[i]);
        out[i] = answer(crossings(source, points[i]));
      }
    });
  });
}

}  // namespace
}  // namespace space

Location locate(const MeshView& mesh, const Point3& p) {
  return space::location_of(space::crossings_of("locate", mesh, p));
}
bool contains(const MeshView& mesh, const Point3& p) {
  return space::location_of(space::crossings_of("contains", mesh, p)) != Location::outside;
}
std::optional<std::int64_t> winding_number(const MeshView& mesh, const Point3& p) {
  return space::winding_of(space::crossings_of("winding_number", mesh, p));
}

void locate(const MeshView& mesh, std::span<const Point3> points, std::span<Location> out, Execution execution) {
  space::answer_points("locate", mesh, points, out, execution, space::location_of);
}
void winding_number(const MeshView& mesh, std::span<const Point3> points, std::span<std::optional<std::int64_t>> out,
                    Execution execution) {
  space::answer_points("winding_number", mesh, points, out, execution, space::winding_of);
}

}  // namespace plumb
