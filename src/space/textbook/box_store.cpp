#include "plumb/space/textbook/box_store.hpp"

#include <algorithm>
#include <type_traits>

#include "space/pairs/refused_handle.hpp"
#include "space/textbook/bit_cells.hpp"
#include "space/textbook/level_bits.hpp"
#include "space/textbook/level_lists.hpp"
#include "space/textbook/list_cells.hpp"
#include "space/textbook/loose_tree.hpp"
#include "space/textbook/sorted_ends.hpp"

namespace plumb {
namespace {

template <class Box, BoxScheme scheme>
struct SchemeOf;
#define PLUMB_SCHEME(scheme, text, ...)            \
  template <class Box>                             \
  struct SchemeOf<Box, BoxScheme::scheme> {        \
    using type = __VA_ARGS__;                      \
    static constexpr std::string_view name = text; \
  };
PLUMB_SCHEME(linked_grid, "LinkedGrid", space::ListCells<Box, false>)
PLUMB_SCHEME(hashed_grid, "HashedGrid", space::ListCells<Box, true>)
PLUMB_SCHEME(implicit_grid, "ImplicitGrid", space::BitCells<Box>)
PLUMB_SCHEME(hierarchical_grid, "HierarchicalGrid", space::LevelLists<Box>)
PLUMB_SCHEME(row_column_grid, "RowColumnGrid", space::LevelBits<Box>)
PLUMB_SCHEME(loose_octree, "LooseOctree", space::LooseTree<Box>)
PLUMB_SCHEME(sweep_lists, "SweepLists", space::SortedEnds<Box>)
#undef PLUMB_SCHEME

/// Where nothing is remembered.
struct EachOnce {};
void make_fit(EachOnce&, std::size_t) {}
template <class Seen>
void make_fit(Seen& seen, std::size_t size) {
  if (seen.size() < size) {
    seen.reset(size);
  } else {
    seen.begin();
  }
}

}  // namespace

template <class Box, BoxScheme scheme>
struct BoxStore<Box, scheme>::State {
  using Scheme = typename SchemeOf<Box, scheme>::type;

  explicit State(const BoxStoreOptions<Box>& options) : cells(asked_by({}), options) {}

  Scheme cells;
  space::StoredBoxes<Box, typename Scheme::Place> stored;

  static space::AskedFunction asked_by(std::string_view verb) { return {SchemeOf<Box, scheme>::name, verb}; }
  static void require_box(std::string_view verb, const Box& box) {
    if (!space::is_sound_box(box)) space::require_grid_box(asked_by(verb).text(), "box", box);
  }
  void require_held(std::string_view verb, const BoxHandle& h) const {
    if (!stored.boxes.contains(h)) {
      space::refuse_handle(asked_by(verb).text(), "handle", h, stored.boxes.was_given(h));
    }
  }
  void give_up(const typename Scheme::Place& place) {
    if constexpr (requires { cells.give_up(place); }) cells.give_up(place);
  }

  /// The pairs are those of slots.
  [[nodiscard]] std::vector<BoxPair> pairs(const BoxPairOptions& options) const {
    if constexpr (requires { cells.pairs(options, stored); }) {
      return cells.pairs(options, stored);
    } else {
      std::vector<space::SweptBox<Box>> boxes;
      std::vector<int> levels;
      for (std::uint32_t i = 0; i < stored.boxes.numbers(); ++i) {
        if (!stored.boxes.contains(i)) continue;
        boxes.push_back({stored.boxes[i], i});
        levels.push_back(cells.level_of(stored.places[i]));
      }
      const auto row_of = [&](const space::SweptBox<Box>& b, int level) {
        return cells.row_of(b, stored.places[b.number], level);
      };
      return space::LevelJoin<Box>(options.execution, boxes, levels).pairs(options.touching, row_of, {});
    }
  }
};

template <class Box, BoxScheme scheme>
BoxStore<Box, scheme>::BoxStore(const BoxStoreOptions<Box>& options) : state_(std::make_unique<State>(options)) {}
template <class Box, BoxScheme scheme>
BoxStore<Box, scheme>::BoxStore(BoxStore&&) noexcept = default;
template <class Box, BoxScheme scheme>
BoxStore<Box, scheme>& BoxStore<Box, scheme>::operator=(BoxStore&&) noexcept = default;
template <class Box, BoxScheme scheme>
BoxStore<Box, scheme>::~BoxStore() = default;

template <class Box, BoxScheme scheme>
BoxHandle BoxStore<Box, scheme>::insert(const Box& box) {
  State& s = *state_;
  s.require_box("insert", box);
  const auto place = s.cells.place_of(box);
  const BoxHandle handle = s.stored.boxes.next();
  s.cells.make_room(s.asked_by("insert"), handle.slot, place);
  if (handle.slot == s.stored.places.size()) s.stored.places.push_back(place);
  s.stored.boxes.add(box);
  s.stored.places[handle.slot] = place;
  s.cells.put(handle.slot, place);
  return handle;
}

template <class Box, BoxScheme scheme>
void BoxStore<Box, scheme>::remove(const BoxHandle& handle) {
  State& s = *state_;
  s.require_held("remove", handle);
  s.cells.take(handle.slot, s.stored.places[handle.slot]);
  s.give_up(s.stored.places[handle.slot]);
  s.stored.boxes.release(handle.slot);
}

template <class Box, BoxScheme scheme>
void BoxStore<Box, scheme>::move(const BoxHandle& handle, const Box& box) {
  State& s = *state_;
  s.require_held("move", handle);
  s.require_box("move", box);
  const auto place = s.cells.place_of(box);
  if (place != s.stored.places[handle.slot]) {
    s.cells.make_room(s.asked_by("move"), handle.slot, place);
    if constexpr (requires { s.cells.move(handle.slot, place); }) {
      s.cells.move(handle.slot, place);
    } else {
      s.cells.take(handle.slot, s.stored.places[handle.slot]);
      s.cells.put(handle.slot, place);
    }
    s.give_up(s.stored.places[handle.slot]);
  }
  s.stored.places[handle.slot] = place;
  s.stored.boxes[handle.slot] = box;
}

template <class Box, BoxScheme scheme>
std::vector<HandlePair> BoxStore<Box, scheme>::overlapping_pairs(const BoxPairOptions& options,
                                                                 std::vector<HandlePair> rows) const {
  const auto& stored = state_->stored;
  const std::vector<BoxPair> pairs = state_->pairs(options);
  rows.clear();
  rows.reserve(pairs.size());
  for (const BoxPair& p : pairs) rows.push_back({stored.boxes.handle(p.a), stored.boxes.handle(p.b)});
  return rows;
}

template <class Box, BoxScheme scheme>
template <class Seen>
std::vector<BoxHandle> BoxStore<Box, scheme>::found(const Box& box, const InBoxOptions& options, Seen& seen,
                                                    std::vector<BoxHandle> rows) const {
  const State& s = *state_;
  rows.clear();
  if (!space::is_sound_box(box) && !space::may_hold(s.asked_by("in_box").text(), box)) return rows;
  make_fit(seen, s.stored.boxes.numbers());
  constexpr bool once = std::is_same_v<Seen, EachOnce>;
  s.cells.visit_near(box, once, s.stored, [&](std::uint32_t slot) {
    if constexpr (!once) {
      if (!seen.visit(slot)) return;
    }
    if (space::is_pair(box, s.stored.boxes[slot], options.touching)) rows.push_back(s.stored.boxes.handle(slot));
  });
  std::sort(rows.begin(), rows.end(), [](const BoxHandle& a, const BoxHandle& b) { return a.slot < b.slot; });
  return rows;
}

template <class Box, BoxScheme scheme>
std::vector<BoxHandle> BoxStore<Box, scheme>::in_box(const Box& box, const InBoxOptions& options,
                                                     std::vector<BoxHandle> rows) const {
  EachOnce nothing;
  return found(box, options, nothing, std::move(rows));
}
template <class Box, BoxScheme scheme>
std::vector<BoxHandle> BoxStore<Box, scheme>::in_box(const Box& box, VisitStamps& seen, const InBoxOptions& options,
                                                     std::vector<BoxHandle> rows) const {
  return found(box, options, seen, std::move(rows));
}
template <class Box, BoxScheme scheme>
std::vector<BoxHandle> BoxStore<Box, scheme>::in_box(const Box& box, VisitBits& seen, const InBoxOptions& options,
                                                     std::vector<BoxHandle> rows) const {
  return found(box, options, seen, std::move(rows));
}

template <class Box, BoxScheme scheme>
std::size_t BoxStore<Box, scheme>::size() const {
  return state_->stored.boxes.size();
}
template <class Box, BoxScheme scheme>
bool BoxStore<Box, scheme>::contains(const BoxHandle& handle) const {
  return state_->stored.boxes.contains(handle);
}
template <class Box, BoxScheme scheme>
const Box& BoxStore<Box, scheme>::box(const BoxHandle& handle) const {
  state_->require_held("box", handle);
  return state_->stored.boxes[handle.slot];
}
template <class Box, BoxScheme scheme>
std::size_t BoxStore<Box, scheme>::parts() const {
  return state_->cells.parts();
}
template <class Box, BoxScheme scheme>
std::size_t BoxStore<Box, scheme>::memory() const {
  const auto& [cells, stored] = *state_;
  return stored.boxes.memory() + stored.places.capacity() * sizeof(stored.places[0]) + cells.memory();
}

#define PLUMB_INSTANTIATE(scheme)                    \
  template class BoxStore<Aabb2, BoxScheme::scheme>; \
  template class BoxStore<Aabb3, BoxScheme::scheme>;
PLUMB_INSTANTIATE(linked_grid)
PLUMB_INSTANTIATE(hashed_grid)
PLUMB_INSTANTIATE(implicit_grid)
PLUMB_INSTANTIATE(hierarchical_grid)
PLUMB_INSTANTIATE(row_column_grid)
PLUMB_INSTANTIATE(loose_octree)
PLUMB_INSTANTIATE(sweep_lists)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
