// The boxes as they lie, seen along the axis of the sweep, and the columns that the search divides them into.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "tool/drawing/data_view.hpp"
#include "tool/pairs/command.hpp"
#include "tool/pairs/sweep_structure.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view kAxes = "xyz";
constexpr std::size_t kMostBoxes = 20'000;

constexpr std::string_view kBoxStyle =
    "  rect.alone { fill: #56b4e9; stroke: #0072b2; fill-opacity: 0.12; }\n"
    "  rect.touch { fill: #009e73; stroke: #009e73; fill-opacity: 0.2; }\n"
    "  rect.overlap { fill: #d55e00; stroke: #d55e00; fill-opacity: 0.2; }\n"
    "  .of-b { stroke-dasharray: 4 2; }\n"
    "  .wall { stroke: #1f2328; stroke-dasharray: 1.5 2.5; }\n"
    "  @media (prefers-color-scheme: dark) { .wall { stroke: #e6edf3; } }\n";

struct Corners {
  std::array<double, 3> min{}, max{};
};
Corners corners_of(const BoxInput& set, std::size_t i) {
  if (set.is_planar) return {{set.plane[i].min.x, set.plane[i].min.y, 0}, {set.plane[i].max.x, set.plane[i].max.y, 0}};
  const auto& [min, max] = set.space[i];
  return {{min.x, min.y, min.z}, {max.x, max.y, max.z}};
}

Corners bounds_of(const PairsReport& r) {
  constexpr double most = std::numeric_limits<double>::max();
  Corners all{{most, most, most}, {-most, -most, -most}};
  for (const BoxInput& set : r.sets) {
    for (std::size_t i = 0; i < set.size(); ++i) {
      const Corners box = corners_of(set, i);
      for (std::size_t k = 0; k < 3; ++k) {
        all.min[k] = std::min(all.min[k], box.min[k]);
        all.max[k] = std::max(all.max[k], box.max[k]);
      }
    }
  }
  return all.min[0] <= all.max[0] ? all : Corners{};
}

/// The axis that is not seen.
std::size_t axis_of_view(const PairsReport& r, const std::optional<SweepStructure>& structure, const Corners& all) {
  if (r.is_planar()) return 2;
  if (structure && structure->columns > 1) return structure->axis;
  std::size_t shortest = 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = all.max[k] / 2 - all.min[k] / 2;
    const bool swept = structure && structure->axis == k;
    if (!swept &&
        (length < all.max[shortest] / 2 - all.min[shortest] / 2 || (structure && structure->axis == shortest)))
      shortest = k;
  }
  return shortest;
}

std::string kind_of(Meets meets, std::size_t set) {
  return std::string(meets == Meets::none       ? "alone"
                     : meets == Meets::touching ? "touch"
                                                : "overlap") +
         (set == 0 ? "" : " of-b");
}

std::string structure_text(const PairsReport& r, const std::optional<SweepStructure>& s, std::size_t boxes) {
  if (!s && method_taken(r) == BroadPhaseMethod::brute_force) return "each pair is compared: nothing divides the boxes";
  if (!s) return fmt::format("by the method {}, of which nothing is drawn", r.method);
  if (s->columns == 1) return fmt::format("swept along {}, without columns", kAxes[s->axis]);
  return fmt::format("swept along {} in {} columns (dotted), in which a box stands {:.3g} times on the average",
                     kAxes[s->axis], grouped(s->columns), static_cast<double>(s->copies) / static_cast<double>(boxes));
}

void add_walls(DataView& view, const SweepStructure& structure, const Corners& all, std::size_t right, std::size_t up) {
  view.begin_group("columns", 1.4);
  for (const double wall : structure.walls[right]) view.line("wall", {wall, all.min[up]}, {wall, all.max[up]});
  for (const double wall : structure.walls[up]) view.line("wall", {all.min[right], wall}, {all.max[right], wall});
  view.end_group();
}

}  // namespace

std::string pairs_svg(const PairsReport& r) {
  const std::optional<SweepStructure> structure = sweep_structure(r);
  const Corners all = bounds_of(r);
  const std::size_t hidden = axis_of_view(r, structure, all);
  const std::size_t right = hidden == 0 ? 1 : 0, up = hidden == 2 ? 1 : 2;
  std::string title = "The boxes of " + r.sets.front().name;
  if (!r.of_one()) title += " and, dashed, of " + r.sets.back().name;
  DataView view(title, kBoxStyle, {std::string(1, kAxes[right]), all.min[right], all.max[right]},
                {std::string(1, kAxes[up]), all.min[up], all.max[up]});

  std::size_t boxes = 0;
  for (const BoxInput& set : r.sets) boxes += set.size();
  const std::size_t every = std::max<std::size_t>((boxes + kMostBoxes - 1) / kMostBoxes, 1);
  std::string counts =
      fmt::format("{}, {}", plural(boxes, "box", "boxes"), plural(r.touch + r.overlap, "pair", "pairs"));
  if (every > 1) counts += fmt::format("; one of {} boxes is drawn, so that the picture stays small", every);
  if (!r.is_planar()) counts += fmt::format("; seen along {}", kAxes[hidden]);
  view.say(counts);
  view.say(structure_text(r, structure, boxes));
  view.explain("alone", r.touching ? "meets no other" : "overlaps no other");
  if (r.touching) view.explain("touch", "only touches");
  view.explain("overlap", "overlaps another");

  view.begin_group("boxes", boxes <= 500 ? 1 : 0.4);
  // What meets others is drawn last, above the rest.
  for (const Meets meets : {Meets::none, Meets::touching, Meets::overlapping}) {
    for (std::size_t s = 0; s < r.sets.size(); ++s) {
      for (std::size_t i = 0; i < r.sets[s].size(); i += every) {
        if (r.meets[s][i] != meets) continue;
        const Corners box = corners_of(r.sets[s], i);
        view.rectangle(kind_of(meets, s), {box.min[right], box.min[up]}, {box.max[right], box.max[up]});
      }
    }
  }
  view.end_group();
  if (structure && structure->columns > 1) add_walls(view, *structure, all, right, up);
  return view.text();
}

}  // namespace plumb::tool
