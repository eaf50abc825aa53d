// The boxes as they lie, and what the search divides them into: cells, walls, and axes along which they are sorted.
#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "tool/drawing/data_view.hpp"
#include "tool/pairs/command.hpp"
#include "tool/pairs/method_names.hpp"
#include "tool/pairs/shown_structure.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view kViewAxes = "xyz";
constexpr std::size_t kMostBoxes = 20'000, kMostParts = 20'000;

constexpr std::string_view kBoxStyle =
    "  rect.alone { fill: #56b4e9; stroke: #0072b2; fill-opacity: 0.12; }\n"
    "  rect.touch { fill: #009e73; stroke: #009e73; fill-opacity: 0.2; }\n"
    "  rect.overlap { fill: #d55e00; stroke: #d55e00; fill-opacity: 0.2; }\n"
    "  .of-b { stroke-dasharray: 4 2; } rect.bar { fill-opacity: 0.8; stroke: none; }\n"
    "  .wall, .cell { stroke: #1f2328; stroke-opacity: 0.65; fill: none; }\n"
    "  @media (prefers-color-scheme: dark) { .wall, .cell { stroke: #e6edf3; } }\n";

struct Corners {
  std::array<double, 3> min{}, max{};
  friend auto operator<=>(const Corners&, const Corners&) = default;
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

/// The axis that is not seen: that of the columns, or the shortest of those that are not sorted.
std::size_t axis_of_view(const PairsReport& r, const ShownStructure& structure, const Corners& all) {
  if (r.is_planar()) return 2;
  if (structure.along) return *structure.along;
  std::array<bool, 3> sorted{};
  for (const std::size_t k : structure.sorted_axes) sorted[k] = structure.sorted_axes.size() < 3;
  const auto length = [&](std::size_t k) { return all.max[k] / 2 - all.min[k] / 2; };
  std::size_t hidden = 2;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::pair(sorted[k], length(k)) < std::pair(sorted[hidden], length(hidden))) hidden = k;
  }
  return hidden;
}

std::string kind_of(Meets meets, std::size_t set) {
  return std::string(meets == Meets::none       ? "alone"
                     : meets == Meets::touching ? "touch"
                                                : "overlap") +
         (set == 0 ? "" : " of-b");
}

/// A box by its set and number.
struct BoxOf {
  std::size_t set, number;
};

/// The row of each interval, so that none meets another of its row: as few rows as there are, at most, at one place.
std::vector<std::size_t> rows_of(const std::vector<std::array<double, 2>>& intervals, std::size_t& rows) {
  std::vector<std::size_t> order(intervals.size()), row(intervals.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return intervals[i][0]; });
  std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>, std::greater<>> ends;
  rows = 0;
  for (const std::size_t i : order) {
    row[i] = rows;
    if (!ends.empty() && ends.top().first < intervals[i][0]) {
      row[i] = ends.top().second;
      ends.pop();
    } else {
      ++rows;
    }
    ends.emplace(intervals[i][1], row[i]);
  }
  return row;
}

class StructureView {
 public:
  explicit StructureView(const PairsReport& r)
      : r_(r), structure_(shown_structure(r)), all_(bounds_of(r)), hidden_(axis_of_view(r, structure_, all_)) {
    for (const BoxInput& set : r_.sets) boxes_ += set.size();
    every_ = std::max<std::size_t>((boxes_ + kMostBoxes - 1) / kMostBoxes, 1);
    // What meets others is drawn last, above the rest.
    for (const Meets meets : {Meets::none, Meets::touching, Meets::overlapping}) {
      for (std::size_t s = 0; s < r_.sets.size(); ++s) {
        for (std::size_t i = 0; i < r_.sets[s].size(); i += every_) {
          if (r_.meets[s][i] == meets) drawn_.push_back({s, i});
        }
      }
    }
  }

  std::string draw() {
    std::string title = "The boxes of " + r_.sets.front().name;
    if (!r_.of_one()) title += " and, dashed, of " + r_.sets.back().name;
    title += ", by " + command_name(method_taken(r_));
    const auto axis = [&](std::size_t k) { return DataAxis{std::string(1, kViewAxes[k]), all_.min[k], all_.max[k]}; };
    constexpr double strip = 96;
    const DataStrips strips{is_sorted(right_) ? strip : 0, is_sorted(up_) ? strip : 0};
    DataView view(title, kBoxStyle, axis(right_), axis(up_), strips);
    view.explain("alone", r_.touching ? "meets no other" : "overlaps no other");
    if (r_.touching) view.explain("touch", "only touches");
    view.explain("overlap", "overlaps another");
    if (!structure_.line.empty()) view.explain(structure_.cells.empty() ? "wall" : "cell", structure_.line);
    std::string says = structure_.says, left_out;
    for (const std::size_t k : structure_.sorted_axes) {
      if (k != hidden_) add_intervals(view, k, says);
    }
    view.begin_group("boxes", boxes_ <= 500 ? 1 : 0.4);
    for (const auto& [set, number] : drawn_) {
      const Corners box = corners_of(r_.sets[set], number);
      view.rectangle(kind_of(r_.meets[set][number], set), seen(box.min), seen(box.max));
    }
    view.end_group();
    add_parts(view, structure_.cells, false, left_out);
    add_parts(view, structure_.walls, true, left_out);
    view.say(counts() + left_out);
    view.say(says);
    return view.text();
  }

 private:
  [[nodiscard]] bool is_sorted(std::size_t axis) const {
    return std::ranges::find(structure_.sorted_axes, axis) != structure_.sorted_axes.end();
  }
  [[nodiscard]] std::array<double, 2> seen(const std::array<double, 3>& p) const { return {p[right_], p[up_]}; }

  [[nodiscard]] std::string counts() const {
    std::string text =
        fmt::format("{}, {}", plural(boxes_, "box", "boxes"), plural(r_.touch + r_.overlap, "pair", "pairs"));
    if (every_ > 1) text += fmt::format("; one of {} boxes is drawn, so that the picture stays small", every_);
    if (!r_.is_planar()) text += fmt::format("; seen along {}", kViewAxes[hidden_]);
    return text;
  }

  /// Beside the plan, in rows, so that no two of one row meet.
  void add_intervals(DataView& view, std::size_t axis, std::string& says) const {
    std::vector<std::array<double, 2>> intervals;
    for (const auto& [set, number] : drawn_) {
      const Corners box = corners_of(r_.sets[set], number);
      intervals.push_back({box.min[axis], box.max[axis]});
    }
    std::size_t rows = 0;
    const std::vector<std::size_t> row = rows_of(intervals, rows);
    says += fmt::format("; {} how {} lie along {}, up to {} at one place", axis == right_ ? "below" : "left",
                        every_ > 1 ? "those drawn" : "they", kViewAxes[axis], grouped(rows));
    view.begin_group(fmt::format("along-{}", kViewAxes[axis]), 0);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      const auto all = static_cast<double>(rows), from = static_cast<double>(row[i]) / all;
      const std::array<double, 2> across{from, from + 0.75 / all};
      const std::string kind = "bar " + kind_of(r_.meets[drawn_[i].set][drawn_[i].number], drawn_[i].set);
      axis == right_ ? view.bar_below(kind, intervals[i], across) : view.bar_left(kind, intervals[i], across);
    }
    view.end_group();
  }

  /// As far as it is seen, and a little beyond.
  [[nodiscard]] Corners near_plan(const ShownPart& part) const {
    constexpr double most = std::numeric_limits<double>::max();
    const double margin =
        0.04 * std::max(all_.max[right_] / 2 - all_.min[right_] / 2, all_.max[up_] / 2 - all_.min[up_] / 2);
    Corners near{part.min, part.max};
    near.min[hidden_] = near.max[hidden_] = 0;
    for (const std::size_t k : {right_, up_}) {
      near.min[k] = std::max({part.min[k], all_.min[k] - margin, -most});
      near.max[k] = std::min({part.max[k], all_.max[k] + margin, most});
    }
    return near;
  }

  void add_parts(DataView& view, const std::vector<ShownPart>& parts, bool are_walls, std::string& left_out) const {
    std::vector<std::pair<unsigned, Corners>> near;  // each place once, where several are seen as one
    std::size_t square = 0;
    for (const ShownPart& part : parts) {
      if (are_walls && part.min[hidden_] == part.max[hidden_]) {
        ++square;
      } else {
        const Corners seen_part = near_plan(part);
        if (seen_part.min[right_] <= seen_part.max[right_] && seen_part.min[up_] <= seen_part.max[up_])
          near.emplace_back(part.level, seen_part);
      }
    }
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    if (square > 0) left_out += fmt::format("; {} are square to {} and not seen", grouped(square), kViewAxes[hidden_]);
    const unsigned levels = near.empty() ? 0 : near.back().first + 1;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < near.size();) {
      const unsigned level = near[i].first;
      std::size_t end = i;
      while (end < near.size() && near[end].first == level) ++end;
      // What is small is left out, but for a part of what would else be all.
      if (end - i > kMostParts - drawn && drawn >= kMostParts / 4) {
        left_out += fmt::format("; of {} levels {} drawn", levels,
                                level == 1 ? "the first is" : fmt::format("the first {} are", level));
        break;
      }
      const std::size_t step = (end - i + kMostParts - drawn - 1) / (kMostParts - drawn);
      if (step > 1) left_out += fmt::format("; one of {} lines of level {} is drawn", step, level);
      view.begin_cut_group(fmt::format("level-{}", level), std::max((levels > 1 ? 1.7 : 0.8) - 0.25 * level, 0.35));
      for (; i < end; i += step, ++drawn) {
        const auto& [min, max] = near[i].second;
        are_walls ? view.line("wall", seen(min), seen(max)) : view.rectangle("cell", seen(min), seen(max));
      }
      view.end_group();
      i = end;
    }
  }

  const PairsReport& r_;
  ShownStructure structure_;
  Corners all_;
  std::size_t hidden_, right_ = hidden_ == 0 ? 1 : 0, up_ = hidden_ == 2 ? 1 : 2;
  std::size_t boxes_ = 0, every_ = 1;
  std::vector<BoxOf> drawn_;
};

}  // namespace

std::string pairs_svg(const PairsReport& r) { return StructureView(r).draw(); }

}  // namespace plumb::tool
