#include "plumb/space/broad_phase/moving_boxes.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "space/broad_phase/candidates.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace {

using space::Met;

// Nanoseconds, on a machine that others used as well, of which the ratios count: a box that moves; a candidate that is
// asked after its box, or among all in their order; a box that is placed; a box and a candidate when all are made anew.
constexpr double of_moved = 80, of_asked = 30, of_asked_in_order = 15, of_placed = 3500, of_box_anew = 400,
                 of_candidate_anew = 40;

std::string text_of_handle(const BoxHandle& h) {
  return "(slot " + std::to_string(h.slot) + ", generation " + std::to_string(h.generation) + ")";
}

void require_box(std::string_view function, std::string_view name, const Aabb3& box) {
  if (!space::is_sound(box)) space::refuse_box(function, name, box);
}

}  // namespace

struct MovingBoxes::State {
  MovingBoxesOptions options;
  std::vector<Aabb3> boxes;  // of each slot
  std::vector<std::uint32_t> generation;
  std::vector<std::uint8_t> alive, updated;  // updated: since the last call of changes()
  std::vector<std::uint32_t> free, removed, moved;
  std::size_t size = 0;
  space::Candidates candidates;
  BoxPairChanges changes;

  [[nodiscard]] bool contains(const BoxHandle& h) const {
    return h.slot < generation.size() && alive[h.slot] != 0 && generation[h.slot] == h.generation;
  }
  [[nodiscard]] BoxHandle handle(std::uint32_t slot) const { return {slot, generation[slot]}; }
  void require(const char* function, const std::string& name, const BoxHandle& h) const {
    if (contains(h)) return;
    const bool was = h.slot < generation.size() &&
                     (h.generation < generation[h.slot] || (h.generation == generation[h.slot] && alive[h.slot] == 0));
    throw InvalidShape(std::string(function) + ": " + name + " " + text_of_handle(h) +
                       (was ? " was removed" : " names no box that was inserted"));
  }
  void mark(std::uint32_t slot) {
    if (updated[slot] == 0) moved.push_back(slot);
    updated[slot] = 1;
  }

  [[nodiscard]] HandlePair pair(std::uint32_t a, std::uint32_t b) const {
    return {handle(std::min(a, b)), handle(std::max(a, b))};
  }
  [[nodiscard]] HandlePair pair(const space::Candidate& c) const {
    return pair(candidates.slot_of(c.a), candidates.slot_of(c.b));
  }
  void lose_removed();
  void ask(std::uint32_t c, const space::Candidate& candidate);
  void keep(std::span<const std::uint32_t> escaped);
  void make_anew();
};

// Their handles are those of the boxes that were: a slot is used again only afterwards.
void MovingBoxes::State::lose_removed() {
  for (const std::uint32_t slot : removed) {
    candidates.for_each_of(slot, [&](std::uint32_t c, const space::Candidate& candidate) {
      if (candidates.met()[c] == Met::yes) changes.lost.push_back(pair(candidate));
    });
    candidates.drop(slot);
  }
  for (const std::uint32_t slot : removed) {
    ++generation[slot];
    free.push_back(slot);
  }
  removed.clear();
}

void MovingBoxes::State::ask(std::uint32_t c, const space::Candidate& candidate) {
  const Met now = candidates.do_meet(candidate, boxes, options.touching) ? Met::yes : Met::no;
  Met& before = candidates.met()[c];
  if (now == before) return;
  before = now;
  (now == Met::yes ? changes.added : changes.lost).push_back(pair(candidate));
}

void MovingBoxes::State::keep(std::span<const std::uint32_t> escaped) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> met_before;
  for (const std::uint32_t slot : escaped) {
    candidates.for_each_of(slot, [&](std::uint32_t c, const space::Candidate& candidate) {
      const std::uint32_t a = candidates.slot_of(candidate.a), b = candidates.slot_of(candidate.b);
      if (candidates.met()[c] == Met::yes) met_before.emplace_back(std::min(a, b), std::max(a, b));
    });
    candidates.drop(slot);
  }
  const auto first_placed = static_cast<std::uint32_t>(candidates.all().size());
  for (const std::uint32_t slot : escaped) candidates.place(slot, boxes[slot]);
  std::sort(met_before.begin(), met_before.end());
  std::vector<std::uint8_t> still(met_before.size());
  for (std::uint32_t c = first_placed; c < candidates.all().size(); ++c) {
    const space::Candidate& candidate = candidates.all()[c];
    if (!candidates.do_meet(candidate, boxes, options.touching)) continue;
    candidates.met()[c] = Met::yes;
    const std::uint32_t a = candidates.slot_of(candidate.a), b = candidates.slot_of(candidate.b);
    const std::pair slots(std::min(a, b), std::max(a, b));
    const auto at = std::lower_bound(met_before.begin(), met_before.end(), slots);
    if (at != met_before.end() && *at == slots) {
      still[static_cast<std::size_t>(at - met_before.begin())] = 1;
    } else {
      changes.added.push_back(pair(slots.first, slots.second));
    }
  }
  for (std::size_t i = 0; i < met_before.size(); ++i) {
    if (still[i] == 0) changes.lost.push_back(pair(met_before[i].first, met_before[i].second));
  }
  // The others: where most boxes move, in the order in which candidates lie in memory.
  if (2 * moved.size() > size) {
    for (std::uint32_t c = 0; c < first_placed; ++c) {
      if (candidates.met()[c] != Met::dropped) ask(c, candidates.all()[c]);
    }
  } else {
    for (const std::uint32_t slot : moved) {
      if (alive[slot] == 0) continue;
      candidates.for_each_of(slot, [&](std::uint32_t c, const space::Candidate& candidate) {
        if (c < first_placed) ask(c, candidate);
      });
    }
  }
}

namespace {

/// Pairs of slots, those of one lesser slot after the other.
struct PartnersOf {
  std::vector<std::uint32_t> begin, partner;

  PartnersOf(const space::Candidates& candidates, std::size_t slots) : begin(slots + 2) {
    const auto each = [&](auto work) {
      for (std::size_t c = 0; c < candidates.all().size(); ++c) {
        if (candidates.met()[c] != Met::yes) continue;
        const std::uint32_t a = candidates.slot_of(candidates.all()[c].a),
                            b = candidates.slot_of(candidates.all()[c].b);
        work(std::min(a, b), std::max(a, b));
      }
    };
    each([&](std::uint32_t a, std::uint32_t) { ++begin[a + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    partner.resize(begin.back());
    each([&](std::uint32_t a, std::uint32_t b) { partner[begin[a + 1]++] = b; });
  }
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t slot) const {
    return {partner.data() + begin[slot], begin[slot + 1] - begin[slot]};
  }
};

}  // namespace

void MovingBoxes::State::make_anew() {
  const PartnersOf before(candidates, boxes.size());
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
    if (alive[slot] != 0) slots.push_back(slot);
  }
  candidates.make_anew(boxes, slots, options.margin);
  for (std::size_t c = 0; c < candidates.all().size(); ++c) {
    if (candidates.do_meet(candidates.all()[c], boxes, options.touching)) candidates.met()[c] = Met::yes;
  }
  const PartnersOf now(candidates, boxes.size());
  std::vector<std::uint32_t> seen(boxes.size(), space::Candidates::none);  // by which slot, among its partners before
  constexpr std::uint32_t still = 1u << 31;
  for (const std::uint32_t slot : slots) {
    for (const std::uint32_t other : before.of(slot)) seen[other] = slot;
    for (const std::uint32_t other : now.of(slot)) {
      if (seen[other] == slot) {
        seen[other] = slot | still;
      } else {
        changes.added.push_back(pair(slot, other));
      }
    }
    for (const std::uint32_t other : before.of(slot)) {
      if (seen[other] == slot) changes.lost.push_back(pair(slot, other));
    }
  }
}

MovingBoxes::MovingBoxes(const MovingBoxesOptions& options) : state_(std::make_unique<State>()) {
  if (!(options.margin >= 0 && options.margin <= 100)) {
    throw InvalidShape("MovingBoxes: options.margin is " + std::to_string(options.margin) +
                       ", but it must lie from 0 to 100");
  }
  state_->options = options;
}
MovingBoxes::MovingBoxes(MovingBoxes&&) noexcept = default;
MovingBoxes& MovingBoxes::operator=(MovingBoxes&&) noexcept = default;
MovingBoxes::~MovingBoxes() = default;

BoxHandle MovingBoxes::insert(const Aabb3& box) {
  require_box("MovingBoxes::insert", "box", box);
  State& s = *state_;
  std::uint32_t slot = 0;
  if (s.free.empty()) {
    slot = static_cast<std::uint32_t>(s.boxes.size());
    s.boxes.push_back(box);
    s.generation.push_back(0), s.alive.push_back(1), s.updated.push_back(0);
  } else {
    slot = s.free.back();
    s.free.pop_back();
    s.boxes[slot] = box;
    s.alive[slot] = 1;
  }
  ++s.size;
  s.mark(slot);
  return s.handle(slot);
}

std::vector<BoxHandle> MovingBoxes::insert(std::span<const Aabb3> boxes) {
  space::check_boxes("MovingBoxes::insert", "boxes", boxes);
  std::vector<BoxHandle> handles;
  handles.reserve(boxes.size());
  for (const Aabb3& box : boxes) handles.push_back(insert(box));
  return handles;
}

void MovingBoxes::remove(const BoxHandle& handle) {
  State& s = *state_;
  s.require("MovingBoxes::remove", "handle", handle);
  s.alive[handle.slot] = 0;
  s.removed.push_back(handle.slot);
  --s.size;
}

void MovingBoxes::update(const BoxHandle& handle, const Aabb3& box) {
  update(std::span<const BoxHandle>(&handle, 1), std::span<const Aabb3>(&box, 1));
}

void MovingBoxes::update(std::span<const BoxHandle> handles, std::span<const Aabb3> boxes) {
  State& s = *state_;
  if (handles.size() != boxes.size()) {
    throw UnequalLengths("MovingBoxes::update: handles has " + std::to_string(handles.size()) +
                         " items, but boxes has " + std::to_string(boxes.size()));
  }
  space::check_boxes("MovingBoxes::update", "boxes", boxes);
  constexpr std::uint8_t seen = 2;  // in this call
  const auto forget = [&](std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) s.updated[handles[i].slot] &= 1;
  };
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const BoxHandle& h = handles[i];
    if (!s.contains(h) || (s.updated[h.slot] & seen) != 0) {
      const bool is_twice = s.contains(h);
      forget(i);
      const std::string name = "handles[" + std::to_string(i) + "]";
      if (!is_twice) s.require("MovingBoxes::update", name, h);
      throw InvalidShape("MovingBoxes::update: " + name + " " + text_of_handle(h) + " is there twice");
    }
    s.updated[h.slot] |= seen;
  }
  forget(handles.size());
  for (std::size_t i = 0; i < handles.size(); ++i) {
    s.boxes[handles[i].slot] = boxes[i];
    s.mark(handles[i].slot);
  }
}

bool MovingBoxes::contains(const BoxHandle& handle) const { return state_->contains(handle); }

const Aabb3& MovingBoxes::box(const BoxHandle& handle) const {
  state_->require("MovingBoxes::box", "handle", handle);
  return state_->boxes[handle.slot];
}

std::size_t MovingBoxes::size() const { return state_->size; }

const BoxPairChanges& MovingBoxes::changes() {
  State& s = *state_;
  s.changes = {};
  s.lose_removed();
  std::vector<std::uint32_t> escaped;
  std::size_t outside = 0;
  for (const std::uint32_t slot : s.moved) {
    if (s.alive[slot] == 0 || s.candidates.move_to(slot, s.boxes[slot])) continue;
    escaped.push_back(slot);
    outside += s.candidates.is_made() && s.candidates.is_outside(s.boxes[slot]) ? 1 : 0;
  }
  MovingWork& work = s.changes.work;
  for (const std::uint32_t slot : s.moved) work.moved += s.alive[slot];
  work.escaped = escaped.size();
  const auto size = static_cast<double>(s.size), candidates = static_cast<double>(s.candidates.size());
  const double of_each = 2 * candidates / std::max(size, 1.0), stay = static_cast<double>(work.moved - escaped.size());
  work.cost_to_keep = static_cast<double>(work.moved) * of_moved +
                      static_cast<double>(escaped.size()) * (of_placed + of_each * of_asked) +
                      (2 * s.moved.size() > s.size ? static_cast<double>(s.candidates.all().size()) * of_asked_in_order
                                                   : stay * of_each * of_asked);
  work.cost_to_keep += static_cast<double>(outside) * static_cast<double>(s.candidates.outside() + outside) * of_asked;
  work.cost_to_make_anew = size * of_box_anew + candidates * of_candidate_anew;
  // So many dropped candidates are in the way of all that follows.
  const bool is_worn = s.candidates.dropped() > 4096 + s.candidates.size();
  const bool has_work = work.moved != 0;
  work.made_anew = has_work && (!s.candidates.is_made() || is_worn || work.cost_to_keep > work.cost_to_make_anew);
  if (work.made_anew) {
    s.make_anew();
  } else if (has_work) {
    s.keep(escaped);
  }
  for (const std::uint32_t slot : s.moved) s.updated[slot] = 0;
  s.moved.clear();
  work.candidates = s.candidates.size();
  std::sort(s.changes.added.begin(), s.changes.added.end());
  std::sort(s.changes.lost.begin(), s.changes.lost.end());
  return s.changes;
}

std::vector<HandlePair> MovingBoxes::pairs() const {
  std::vector<HandlePair> pairs;
  for (std::size_t c = 0; c < state_->candidates.all().size(); ++c) {
    if (state_->candidates.met()[c] != Met::yes) continue;
    pairs.push_back(state_->pair(state_->candidates.all()[c]));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace plumb
