#include "plumb/space/ray/inside.hpp"

#include <algorithm>
#include <compare>
#include <vector>

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/crossings.hpp"
#include "space/bvh/blocks.hpp"
#include "space/bvh/equal_lengths.hpp"
#include "space/ray/along_x.hpp"

namespace plumb {
namespace {

constexpr std::size_t points_of_block = 256;

/// A triangle that is crossed, and which way.
struct CrossedItem {
  std::uint32_t item;
  std::int32_t outward;
  friend auto operator<=>(const CrossedItem&, const CrossedItem&) = default;
};

/// Nothing for a point on a triangle.  An item may be in several slots.
template <class Mesh>
std::optional<query::Crossings> tree_crossings(std::string_view function, const Mesh& bvh, const Point3& p) {
  query::require_figure(function, "p", p);
  std::vector<CrossedItem> crossed;
  const bool on_one =
      descend(bvh.tree, space::AlongX(bvh.tree.frame, p), [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          query::Crossings one;
          if (!one.take(bvh.triangle(slot), p)) return Descent::stop;
          if (one.count != 0) crossed.push_back({bvh.number(slot), static_cast<std::int32_t>(one.outward)});
        }
        return Descent::go_on;
      }) == Descent::stop;
  if (on_one) return {};
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  query::Crossings found;
  found.count = crossed.size();
  for (const CrossedItem& one : crossed) found.outward += one.outward;
  return found;
}

template <class Out, class Answer>
void answer_points(std::string_view function, std::span<const Point3> points, std::span<Out> out, Execution execution,
                   const Answer& answer) {
  space::require_equal_lengths(function, "out", out.size(), "points", points.size());
  space::for_blocks(execution, points.size(), points_of_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) out[i] = answer(points[i]);
  });
}

}  // namespace

// Each question of the mesh's tree in its usual and in its compact form.
#define PLUMB_INSIDE(Mesh)                                                                                            \
  Location locate(const Mesh& bvh, const Point3& p) {                                                                 \
    const auto found = tree_crossings("locate", bvh, p);                                                              \
    if (!found) return Location::boundary;                                                                            \
    return found->count % 2 == 1 ? Location::inside : Location::outside;                                              \
  }                                                                                                                   \
  bool contains(const Mesh& bvh, const Point3& p) { return locate(bvh, p) != Location::outside; }                     \
  std::optional<std::int64_t> winding_number(const Mesh& bvh, const Point3& p) {                                      \
    const auto found = tree_crossings("winding_number", bvh, p);                                                      \
    if (!found) return {};                                                                                            \
    return found->outward;                                                                                            \
  }                                                                                                                   \
  void locate(const Mesh& bvh, std::span<const Point3> points, std::span<Location> out, Execution execution) {        \
    answer_points("locate", points, out, execution, [&](const Point3& p) { return locate(bvh, p); });                 \
  }                                                                                                                   \
  void winding_number(const Mesh& bvh, std::span<const Point3> points, std::span<std::optional<std::int64_t>> out,    \
                      Execution execution) {                                                                          \
    answer_points("winding_number", points, out, execution, [&](const Point3& p) { return winding_number(bvh, p); }); \
  }
PLUMB_INSIDE(Bvh)
PLUMB_INSIDE(CompactBvh)
#undef PLUMB_INSIDE

}  // namespace plumb
