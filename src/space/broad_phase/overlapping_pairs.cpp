#include "plumb/space/broad_phase/overlapping_pairs.hpp"

#include "space/broad_phase/indexed_pairs.hpp"
#include "space/broad_phase/swept_columns.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace space {

std::vector<std::size_t> groups_of(const Columns& columns) {
  constexpr std::size_t enough = 1 << 13;
  std::vector<std::size_t> groups{0};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns.begin[c + 1] - columns.begin[groups.back()] >= enough) groups.push_back(c + 1);
  }
  if (groups.back() != columns.size()) groups.push_back(columns.size());
  return groups;
}

namespace {

/// Each pair, of few.
template <class Box>
void compare_each(const BoxSet<Box>& set, const PairTaker& to) {
  PairBlock block(const_cast<PairTaker*>(&to), [](void* context, std::span<const BoxPair> pairs) {
    const auto& taker = *static_cast<const PairTaker*>(context);
    taker.take(taker.to, pairs, 1);
  });
  const std::size_t n = set.size(), of_a = set.b.empty() ? n : set.a.size();
  for (std::size_t a = 0; a < of_a; ++a) {
    for (std::size_t b = set.b.empty() ? a + 1 : of_a; b < n; ++b) {
      if (!boxes_meet(set[a], set[b], set.touching)) continue;
      *block.room() = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
      block.added(1);
    }
  }
  block.flush();
}

template <class Box>
void by_index(const BoxSet<Box>& set, const PairTaker& to, const BroadPhaseOptions& options) {
  if constexpr (std::is_same_v<Box, Aabb2> || std::is_same_v<Box, Aabb3>) {
    find_by_index(options, set.a, set.b, to);
  } else {
    using Wide = decltype(widened(Box{}));
    std::vector<Wide> all;
    all.reserve(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) all.push_back(widened(set[i]));
    const std::span<const Wide> wide(all);
    find_by_index(options, wide.first(set.a.size()), wide.subspan(set.a.size()), to);
  }
}

template <class Box>
void find_pairs(const BoxSet<Box>& set, bool is_two, const PairTaker& to, const BroadPhaseOptions& options) {
  SetBounds bounds, of_b;
  if (!find_bounds(set.a, bounds)) check_boxes("overlapping_pairs", is_two ? "a" : "boxes", set.a);
  if (!find_bounds(set.b, of_b)) check_boxes("overlapping_pairs", "b", set.b);
  if (set.size() < 2 || (is_two && (set.a.empty() || set.b.empty()))) return;
  for (std::size_t k = 0; k < axes_of<Box> && is_two; ++k) {
    bounds.min[k] = std::min(bounds.min[k], of_b.min[k]);
    bounds.max[k] = std::max(bounds.max[k], of_b.max[k]);
  }
  if (options.method > BroadPhaseMethod::brute_force) return by_index(set, to, options);
  const BroadPhaseMethod method = method_taken(options.method, set.size());
  if (method == BroadPhaseMethod::brute_force) return compare_each(set, to);
  if (method == BroadPhaseMethod::sort_and_sweep) {
    return find_by_sweep(options.execution, set, bounds, widest_axis(set, bounds), to);
  }
  find_by_columns(options.execution, set, bounds, to);
}

/// Numbers of the second set begin at 0 again.
template <class Box>
void tell_pairs(std::span<const Box> a, std::span<const Box> b, bool is_two, const BroadPhaseOptions& options,
                const PairTaker& to) {
  const BoxSet<Box> set{a, b, options.touching};
  if (!is_two) return find_pairs(set, false, to, options);
  struct Shifted {
    const PairTaker* to;
    std::uint32_t by;
    std::vector<BoxPair> pairs;
  } shifted{&to, static_cast<std::uint32_t>(a.size()), {}};
  const PairTaker shift{&shifted, [](void* context, std::span<const BoxPair> block, double done) {
                          auto& s = *static_cast<Shifted*>(context);
                          s.pairs.assign(block.begin(), block.end());
                          for (BoxPair& p : s.pairs) p.b -= s.by;
                          s.to->take(s.to->to, s.pairs, done);
                        }};
  find_pairs(set, true, shift, options);
}

template <class Box>
void tell_sink(std::span<const Box> a, std::span<const Box> b, bool is_two, const BoxPairSink& sink,
               const BroadPhaseOptions& options) {
  const PairTaker to{const_cast<BoxPairSink*>(&sink), [](void* context, std::span<const BoxPair> block, double) {
                       (*static_cast<const BoxPairSink*>(context))(block);
                     }};
  tell_pairs(a, b, is_two, options, to);
}

template <class Box>
std::vector<BoxPair> collect(std::span<const Box> a, std::span<const Box> b, bool is_two,
                             const BroadPhaseOptions& options, std::vector<BoxPair> pairs) {
  pairs.clear();
  // Grows to as many as there will be, if the rest of the work finds as many as that which is done.
  const PairTaker to{&pairs, [](void* context, std::span<const BoxPair> block, double done) {
                       auto& kept = *static_cast<std::vector<BoxPair>*>(context);
                       const std::size_t now = kept.size() + block.size();
                       if (now > kept.capacity()) {
                         const auto expected = static_cast<double>(now) / std::max(done, 0.02) * 1.05;
                         kept.reserve(std::max(now + now / 2, static_cast<std::size_t>(expected)));
                       }
                       kept.insert(kept.end(), block.begin(), block.end());
                     }};
  tell_pairs(a, b, is_two, options, to);
  return pairs;
}

}  // namespace
}  // namespace space

std::string_view name_of(BroadPhaseMethod method) {
  constexpr std::array<std::string_view, broad_phase_methods.size()> names = {
      "automatic",       "swept_columns",     "sort_and_sweep", "brute_force",       "static_grid",
      "linked_grid",     "hashed_grid",       "implicit_grid",  "hierarchical_grid", "row_column_grid",
      "octree",          "octree_of_leaves",  "loose_octree",   "box_tree",          "lists_along_one",
      "lists_along_two", "lists_along_three", "kd_tree"};
  const auto number = static_cast<std::size_t>(method);
  return number < names.size() ? names[number] : "of no name";
}

#define PLUMB_PAIRS_OF(Box)                                                                                     \
  std::vector<BoxPair> overlapping_pairs(std::span<const Box> boxes, const BroadPhaseOptions& options,          \
                                         std::vector<BoxPair> rows) {                                           \
    return space::collect(boxes, {}, false, options, std::move(rows));                                          \
  }                                                                                                             \
  std::vector<BoxPair> overlapping_pairs(std::span<const Box> a, std::span<const Box> b,                        \
                                         const BroadPhaseOptions& options, std::vector<BoxPair> rows) {         \
    return space::collect(a, b, true, options, std::move(rows));                                                \
  }                                                                                                             \
  void overlapping_pairs(std::span<const Box> boxes, const BoxPairSink& to, const BroadPhaseOptions& options) { \
    space::tell_sink(boxes, {}, false, to, options);                                                            \
  }                                                                                                             \
  void overlapping_pairs(std::span<const Box> a, std::span<const Box> b, const BoxPairSink& to,                 \
                         const BroadPhaseOptions& options) {                                                    \
    space::tell_sink(a, b, true, to, options);                                                                  \
  }
PLUMB_PAIRS_OF(Aabb2)
PLUMB_PAIRS_OF(Aabb3)
PLUMB_PAIRS_OF(FloatBox2)
PLUMB_PAIRS_OF(FloatBox3)
#undef PLUMB_PAIRS_OF

}  // namespace plumb
