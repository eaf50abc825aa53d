// What is done while memory is waited for?  Descents by turns.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_BY_TURNS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BY_TURNS
#undef PLUMB_BY_TURNS
#else
#define PLUMB_BY_TURNS
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <new>

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

/// Walks, of which so many go together: one looks while memory brings what the others asked for, and while the processor
/// is not done with what it looked at before: nodes come after nodes and leaves after leaves, so that it guesses well.
template <class Walk, std::size_t together>
class ByTurns {
 public:
  ByTurns() = default;
  ~ByTurns() = default;
  ByTurns(const ByTurns&) = delete;
  ByTurns& operator=(const ByTurns&) = delete;

  /// begin(memory) makes the next walk there; are there any?
  template <class Begin>
  void run(const Begin& begin) {
    const auto start = [&](std::size_t place) {
      if (begin(memory_ + place * sizeof(Walk))) at_nodes_.places[at_nodes_.size++] = place;
    };
    const auto go_on = [&](std::size_t place) HWY_ATTR {
      if (!at(place)->go_on()) return start(place);
      // Into both: no branch is to be guessed.
      const bool leaf = at(place)->at_leaf();
      at_nodes_.places[at_nodes_.size] = at_leaves_.places[at_leaves_.size] = place;
      at_nodes_.size += leaf ? 0 : 1;
      at_leaves_.size += leaf ? 1 : 0;
    };
    for (std::size_t i = 0; i < together; ++i) start(i);
    while (at_nodes_.size + at_leaves_.size > 0) {
      for (std::size_t i = 0; i < at_leaves_.size; ++i) at(at_leaves_.places[i])->fetch_vertices();
      const Places nodes = at_nodes_, leaves = at_leaves_;
      at_nodes_.size = at_leaves_.size = 0;
      for (std::size_t i = 0; i < nodes.size; ++i) {
        at(nodes.places[i])->open_node();
        go_on(nodes.places[i]);
      }
      for (std::size_t i = 0; i < leaves.size; ++i) {
        at(leaves.places[i])->visit_leaf();
        go_on(leaves.places[i]);
      }
    }
  }

 private:
  struct Places {
    std::size_t size = 0;
    std::array<std::size_t, together + 1> places;
  };

  Walk* at(std::size_t place) { return std::launder(reinterpret_cast<Walk*>(memory_)) + place; }

  Places at_nodes_, at_leaves_;
  alignas(Walk) std::byte memory_[together * sizeof(Walk)];
};

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
