#include "plumb/space/kd_tree/split_ray.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "plumb/arith/interval.hpp"
#include "space/kd_tree/kept_figures.hpp"
#include "space/kd_tree/passed_by.hpp"
#include "space/kd_tree/plane_walk.hpp"

namespace plumb {
namespace space::kd {
namespace {

template <class Figure>
struct SplitPlanes {
  static constexpr std::size_t root = 0;
  std::span<const SplitNode> nodes;

  [[nodiscard]] bool is_leaf(std::size_t node) const { return nodes[node].is_leaf(); }
  [[nodiscard]] std::size_t leaf(std::size_t node) const { return nodes[node].link; }
  [[nodiscard]] std::uint8_t axis(std::size_t node) const { return static_cast<std::uint8_t>(nodes[node].axis); }
  [[nodiscard]] double plane(std::size_t node) const { return nodes[node].plane; }
  [[nodiscard]] static std::size_t lower(std::size_t node) { return node + 1; }
  [[nodiscard]] std::size_t upper(std::size_t node) const { return nodes[node].link; }
};

template <class Figure>
using SplitWalk = PlaneWalk<SplitPlanes<Figure>, SplitTree<Figure>::dimension>;

template <class Figure, class Way>
std::vector<std::uint32_t> split_cells(const SplitTree<Figure>& tree, const Way& way, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  rows.clear();
  const auto path = checked_path("cells_along", way);
  if (tree.nodes.empty()) return rows;
  return SplitWalk<Figure>({tree.nodes}, path, cells).leaves(std::move(rows));
}

/// Is the parameter, which rounds to t, certainly less than that of the place?
template <std::size_t d>
bool is_surely_before(const Path<d>& path, double t, const Place& place) {
  if (place.kind != Place::Kind::crossing) return false;
  const Interval from(path.from[place.axis]), to(path.to[place.axis]), way = path.is_ray ? to : to - from;
  const Interval most(std::nextafter(t, std::numeric_limits<double>::infinity()));
  const Interval gone = most * way, left = Interval(place.plane) - from;
  return path.way(place.axis) > 0 ? gone.upper < left.lower : gone.lower > left.upper;
}

template <class Figure, class Way>
std::optional<FigureHit<Figure>> first_hit_along(const SplitTree<Figure>& tree, const Way& way) {
  const auto path = checked_path("first_hit", way);
  std::optional<FigureHit<Figure>> best;
  if (tree.nodes.empty()) return best;
  std::optional<RayParameter> exactly;  // of the best, once it is asked for
  std::array<std::uint32_t, 32> asked;
  asked.fill(0xffffffff);
  const auto is_before = [&](const FigureHit<Figure>& h) {
    if (!best || h.hit.t != best->hit.t) return !best || h.hit.t < best->hit.t;
    const Figure &figure = tree.figures[h.index], &other = tree.figures[best->index];
    if (std::memcmp(&figure, &other, sizeof(Figure)) == 0) return h.index < best->index;
    if (!exactly) exactly = first_hit_parameter(way, other);
    const auto order = *first_hit_parameter(way, figure) <=> *exactly;
    return order < 0 || (order == 0 && h.index < best->index);
  };
  SplitWalk<Figure>({tree.nodes}, path, WalkedCells::half_open).each_leaf([&](std::size_t leaf, const Place& entry) {
    if (best && is_surely_before(path, best->hit.t, entry)) return Descent::stop;
    for (const std::uint32_t i : tree.items_in(leaf)) {
      std::uint32_t& before = asked[i % asked.size()];  // what lies in several leaves is asked once, as a rule
      if (std::exchange(before, i) == i || is_passed_by(path, tree.figures[i])) continue;
      const auto hit = first_hit(way, tree.figures[i]);
      if (!hit) continue;
      const FigureHit<Figure> found{i, *hit};
      if (is_before(found)) best = found, exactly.reset();
    }
    return Descent::go_on;
  });
  return best;
}

template <class Figure, class Way>
bool hits_along(const SplitTree<Figure>& tree, const Way& way) {
  const auto path = checked_path("any_hit", way);
  bool found = false;
  if (tree.nodes.empty()) return found;
  SplitWalk<Figure>({tree.nodes}, path, WalkedCells::half_open).each_leaf([&](std::size_t leaf, const Place&) {
    for (const std::uint32_t i : tree.items_in(leaf)) {
      found = !is_passed_by(path, tree.figures[i]) && first_hit_parameter(way, tree.figures[i]).has_value();
      if (found) return Descent::stop;
    }
    return Descent::go_on;
  });
  return found;
}

}  // namespace
}  // namespace space::kd

template <KeptFigure Figure>
std::vector<std::uint32_t> cells_along(const SplitTree<Figure>& tree,
                                       const typename SplitTree<Figure>::Segment& segment, WalkedCells cells,
                                       std::vector<std::uint32_t> rows) {
  return space::kd::split_cells(tree, segment, cells, std::move(rows));
}
template <KeptFigure Figure>
std::vector<std::uint32_t> cells_along(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray,
                                       WalkedCells cells, std::vector<std::uint32_t> rows) {
  return space::kd::split_cells(tree, ray, cells, std::move(rows));
}
template <ShotAtFigure Figure>
std::optional<FigureHit<Figure>> first_hit(const SplitTree<Figure>& tree,
                                           const typename SplitTree<Figure>::Segment& segment) {
  return space::kd::first_hit_along(tree, segment);
}
template <ShotAtFigure Figure>
std::optional<FigureHit<Figure>> first_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray) {
  return space::kd::first_hit_along(tree, ray);
}
template <ShotAtFigure Figure>
bool any_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Segment& segment) {
  return space::kd::hits_along(tree, segment);
}
template <ShotAtFigure Figure>
bool any_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray) {
  return space::kd::hits_along(tree, ray);
}

#define PLUMB_INSTANTIATE(F)                                                                                      \
  template std::vector<std::uint32_t> cells_along(const SplitTree<F>&, const SplitTree<F>::Segment&, WalkedCells, \
                                                  std::vector<std::uint32_t>);                                    \
  template std::vector<std::uint32_t> cells_along(const SplitTree<F>&, const SplitTree<F>::Ray&, WalkedCells,     \
                                                  std::vector<std::uint32_t>);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE
#define PLUMB_INSTANTIATE(F)                                                                         \
  template std::optional<FigureHit<F>> first_hit(const SplitTree<F>&, const SplitTree<F>::Segment&); \
  template std::optional<FigureHit<F>> first_hit(const SplitTree<F>&, const SplitTree<F>::Ray&);     \
  template bool any_hit(const SplitTree<F>&, const SplitTree<F>::Segment&);                          \
  template bool any_hit(const SplitTree<F>&, const SplitTree<F>::Ray&);
PLUMB_INSTANTIATE(Aabb2)
PLUMB_INSTANTIATE(Segment2) PLUMB_INSTANTIATE(Triangle2) PLUMB_INSTANTIATE(Aabb3) PLUMB_INSTANTIATE(Triangle3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
