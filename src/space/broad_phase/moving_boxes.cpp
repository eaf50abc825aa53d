#include "plumb/space/broad_phase/moving_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "query/ray/numbers.hpp"
#include "space/broad_phase/asked_boxes.hpp"
#include "space/broad_phase/candidates.hpp"
#include "space/broad_phase/frame_sweep.hpp"
#include "space/broad_phase/pair_order.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace {

using space::Met;

// Nanoseconds, on a machine that others used as well, of which the ratios count: a box that moves; a candidate that is
// asked after its box, or among all in their order; a box that is placed; a box and a candidate when all are made anew;
// a box when pairs are found from scratch, and for each that would be a candidate.
constexpr double of_moved = 80, of_asked = 30, of_asked_in_order = 15, of_placed = 3500, of_box_anew = 400,
                 of_candidate_anew = 40, of_box_found = 130, of_pair_found = 12;

std::string text_of_handle(const BoxHandle& h) {
  return "(slot " + std::to_string(h.slot) + ", generation " + std::to_string(h.generation) + ")";
}

void require_box(std::string_view function, std::string_view name, const Aabb3& box) {
  if (!space::is_sound(box)) space::refuse_box(function, name, box);
}

}  // namespace

struct MovingBoxes::State {
  explicit State(const MovingBoxesOptions& o) : options(o), asked(o.margin) {}

  MovingBoxesOptions options;
  std::vector<Aabb3> boxes;  // of each slot
  std::vector<std::uint32_t> generation;
  std::vector<std::uint8_t> alive, updated;  // updated: since the last call of changes()
  std::vector<std::uint32_t> free, removed, moved;
  std::size_t size = 0;
  space::AskedBoxes asked;
  space::Candidates candidates;
  BoxPairChanges changes;
  // As of the last call of changes(): the boxes of slots that are updated, and which slots there were.
  std::vector<Aabb3> boxes_before;
  std::vector<std::uint8_t> was_alive;
  std::size_t pairs_known = 0;
  // In place of candidates, where all boxes were swept when changes were last told.
  bool is_swept = true;
  space::FrameSweep frames;
  double lost_by_scratch = 0;  // ns
  // How many boxes would have left their fat ones since the last call, had they any; and half of a mean box.
  double escapes_expected = 0;
  Vector3 half_mean{};

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
    if (updated[slot] == 0) moved.push_back(slot), boxes_before[slot] = boxes[slot];
    updated[slot] = 1;
  }

  [[nodiscard]] HandlePair pair(std::uint32_t a, std::uint32_t b) const {
    return {handle(std::min(a, b)), handle(std::max(a, b))};
  }
  [[nodiscard]] HandlePair pair(const space::Candidate& c) const {
    return pair(candidates.slot_of(c.a), candidates.slot_of(c.b));
  }
  /// work(lesser slot, greater slot) of each candidate that met.
  template <class Work>
  void for_each_met(const Work& work) const {
    for (std::size_t c = 0; c < candidates.all().size(); ++c) {
      if (candidates.met()[c] != Met::yes) continue;
      const std::uint32_t a = candidates.slot_of(candidates.all()[c].a), b = candidates.slot_of(candidates.all()[c].b);
      work(std::min(a, b), std::max(a, b));
    }
  }
  [[nodiscard]] std::vector<std::uint32_t> slots_alive() const;
  void expect_escape(const Aabb3& from, const Aabb3& to, std::size_t times);
  void sweep_frames();
  void find_from_scratch();
  void choose(MovingWork& work, std::size_t escaped, std::size_t outside);
  void lose_removed();
  void ask(std::uint32_t c, const space::Candidate& candidate);
  void keep(std::span<const std::uint32_t> escaped);
  void make_anew();
};

/// Of candidates that are kept.
void MovingBoxes::State::lose_removed() {
  for (const std::uint32_t slot : removed) {
    candidates.for_each_of(slot, [&](std::uint32_t c, const space::Candidate& candidate) {
      if (candidates.met()[c] == Met::yes) changes.lost.push_back(pair(candidate));
    });
    candidates.drop(slot);
  }
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

/// Changes, by all boxes as they were and as they are.
void MovingBoxes::State::sweep_frames() {
  frames.find({boxes, boxes_before, alive, was_alive, updated, options.touching});
  half_mean = frames.half_mean();
  const auto tell = [&](const std::vector<BoxPair>& pairs, std::vector<HandlePair>& to) {
    to.reserve(pairs.size());
    for (const BoxPair& p : pairs) to.push_back({handle(p.a), handle(p.b)});
  };
  tell(frames.lost(), changes.lost);
  tell(frames.added(), changes.added);
}

std::vector<std::uint32_t> MovingBoxes::State::slots_alive() const {
  std::vector<std::uint32_t> slots;
  slots.reserve(size);
  for (std::uint32_t slot = 0; slot < boxes.size(); ++slot) {
    if (alive[slot] != 0) slots.push_back(slot);
  }
  return slots;
}

void MovingBoxes::State::make_anew() {
  sweep_frames();
  frames.clear();
  candidates.make_anew(boxes, slots_alive(), options.margin);
  for (std::size_t c = 0; c < candidates.all().size(); ++c) {
    if (candidates.do_meet(candidates.all()[c], boxes, options.touching)) candidates.met()[c] = Met::yes;
  }
  is_swept = false;
}

/// A guess: one that moves by part of the margin in a frame escapes in as many frames as make it whole.
void MovingBoxes::State::expect_escape(const Aabb3& from, const Aabb3& to, std::size_t times) {
  const auto part_of = [&](double a_min, double b_min, double a_max, double b_max, double half) {
    const double by = std::max(std::abs(b_min - a_min), std::abs(b_max - a_max)), whole = 2 * options.margin * half;
    return by < whole ? by / whole : by > 0 ? 1.0 : 0.0;
  };
  const double of_one = std::max({part_of(from.min.x, to.min.x, from.max.x, to.max.x, half_mean.x),
                                  part_of(from.min.y, to.min.y, from.max.y, to.max.y, half_mean.y),
                                  part_of(from.min.z, to.min.z, from.max.z, to.max.z, half_mean.z)});
  escapes_expected += static_cast<double>(times) * of_one;
}

void MovingBoxes::State::find_from_scratch() {
  sweep_frames();
  if (!is_swept) candidates = {};
  is_swept = true;
}

/// The way that is predicted to take least, where candidates that are kept pay for themselves: they are made once
/// frames without them have taken as much longer than with them as making them does.
void MovingBoxes::State::choose(MovingWork& work, std::size_t escaped, std::size_t outside) {
  const auto all = static_cast<double>(size);
  const auto moving = static_cast<double>(work.moved + (is_swept ? removed.size() : 0));
  const bool is_most = 2 * moved.size() > size;
  // Where there are no candidates, some more than pairs.
  const double kept = is_swept ? 1.7 * static_cast<double>(pairs_known) : static_cast<double>(candidates.size());
  const double of_each = 2 * kept / std::max(all, 1.0);
  const auto to_keep = [&](double out_of_place) {
    return moving * of_moved + out_of_place * (of_placed + of_each * of_asked) +
           (is_most ? (is_swept ? kept : static_cast<double>(candidates.all().size())) * of_asked_in_order
                    : (moving - out_of_place) * of_each * of_asked);
  };
  work.cost_to_make_anew = all * of_box_anew + kept * of_candidate_anew;
  work.cost_from_scratch = all * of_box_found + kept * of_pair_found;
  const double if_kept = to_keep(std::min(escapes_expected, moving));
  if (is_swept) {
    work.cost_to_keep = work.cost_to_make_anew;
  } else {
    const auto out = static_cast<double>(outside);
    work.cost_to_keep =
        to_keep(static_cast<double>(escaped)) + out * (static_cast<double>(candidates.outside()) + out) * of_asked;
  }
  if (moving == 0) return;
  // So many dropped candidates are in the way of all that follows.
  const bool is_worn = candidates.dropped() > 4096 + candidates.size();
  const bool is_kept = !is_swept && !is_worn && work.cost_to_keep <= work.cost_from_scratch;
  lost_by_scratch = is_kept ? 0 : std::max(lost_by_scratch + work.cost_from_scratch - if_kept, 0.0);
  if (is_kept) return;
  work.made_anew = lost_by_scratch > work.cost_to_make_anew;
  work.from_scratch = !work.made_anew;
  if (work.made_anew) lost_by_scratch = 0;
}

MovingBoxes::MovingBoxes(const MovingBoxesOptions& options) {
  if (!(options.margin >= 0 && options.margin <= 100)) {
    throw InvalidShape("MovingBoxes: options.margin is " + std::to_string(options.margin) +
                       ", but it must lie from 0 to 100");
  }
  state_ = std::make_unique<State>(options);
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
    s.boxes_before.emplace_back(), s.was_alive.push_back(0);
  } else {
    slot = s.free.back();
    s.free.pop_back();
    s.boxes[slot] = box;
    s.alive[slot] = 1;
  }
  ++s.size;
  s.escapes_expected += 1;
  s.mark(slot);
  s.frames.note(slot, box);
  s.asked.note_inserted(slot);
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
  s.frames.note_removed(handle.slot);
  s.asked.note_removed(handle.slot);
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
  constexpr std::size_t ahead = 16;
  const std::size_t every = handles.size() < 1024 ? 1 : 16;  // of which it is guessed how many escape, a power of two
  // Where all are told at once those before need not be copied.
  const bool are_all = s.moved.empty() && handles.size() == s.boxes.size();
  if (are_all) s.boxes.swap(s.boxes_before);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const std::uint32_t slot = handles[i].slot;
    if (i + ahead < handles.size()) s.frames.prefetch(handles[i + ahead].slot);
    if (!are_all) {
      s.mark(slot);
    } else {
      s.moved.push_back(slot), s.updated[slot] = 1;
    }
    if (s.is_swept && (i & (every - 1)) == 0) s.expect_escape(s.boxes_before[slot], boxes[i], every);
    s.boxes[slot] = boxes[i];
    s.frames.note(slot, boxes[i]);
    s.asked.note_moved(slot, boxes[i]);
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
  s.changes.added.clear(), s.changes.lost.clear();
  s.changes.work = {};
  std::vector<std::uint32_t> escaped;
  std::size_t outside = 0;
  for (const std::uint32_t slot : s.moved) {
    if (s.is_swept || s.alive[slot] == 0 || s.candidates.move_to(slot, s.boxes[slot])) continue;
    escaped.push_back(slot);
    outside += s.candidates.is_made() && s.candidates.is_outside(s.boxes[slot]) ? 1 : 0;
  }
  MovingWork& work = s.changes.work;
  for (const std::uint32_t slot : s.moved) work.moved += s.alive[slot];
  work.escaped = escaped.size();
  s.choose(work, escaped.size(), outside);
  if (work.made_anew) {
    s.make_anew();
  } else if (work.from_scratch) {
    s.find_from_scratch();
  } else if (!s.is_swept) {
    s.lose_removed();
    if (work.moved != 0) s.keep(escaped);
  }
  for (const std::uint32_t slot : s.moved) s.updated[slot] = 0, s.was_alive[slot] = s.alive[slot];
  for (const std::uint32_t slot : s.removed) {  // a slot is used again only from now on
    s.was_alive[slot] = 0;
    ++s.generation[slot];
    s.free.push_back(slot);
  }
  s.removed.clear();
  s.moved.clear();
  s.escapes_expected = 0;
  work.candidates = s.candidates.size();
  for (std::vector<HandlePair>* const list : {&s.changes.added, &s.changes.lost}) {
    if (!std::is_sorted(list->begin(), list->end())) std::sort(list->begin(), list->end());
  }
  s.pairs_known = s.pairs_known + s.changes.added.size() - s.changes.lost.size();
  return s.changes;
}

std::vector<HandlePair> MovingBoxes::pairs() const {
  const State& s = *state_;
  std::vector<BoxPair> all, other;
  if (s.is_swept) {
    std::vector<std::uint32_t> slots;
    std::vector<Aabb3> then;
    for (std::uint32_t slot = 0; slot < s.boxes.size(); ++slot) {
      if (s.was_alive[slot] == 0) continue;
      slots.push_back(slot), then.push_back(s.updated[slot] != 0 ? s.boxes_before[slot] : s.boxes[slot]);
    }
    all = overlapping_pairs(then, BroadPhaseOptions{s.options.touching, Execution::serial});
    for (BoxPair& p : all) p = {slots[p.a], slots[p.b]};
  } else {
    s.for_each_met([&](std::uint32_t a, std::uint32_t b) { all.push_back({a, b}); });
  }
  space::sort_pairs(all, other);
  std::vector<HandlePair> pairs;
  pairs.reserve(all.size());
  for (const BoxPair& p : all) pairs.push_back(s.pair(p.a, p.b));
  return pairs;
}

std::vector<BoxHandle> MovingBoxes::in_box(const Aabb3& box, const InBoxOptions& options) const {
  const State& s = *state_;
  figure::require_finite_parts<Point3, Point3>("MovingBoxes::in_box", {"box.min", "box.max"}, box.min, box.max);
  if (is_empty(box)) return {};
  std::vector<BoxHandle> handles;
  for (const std::uint32_t slot : s.asked.in_box({s.boxes, s.alive}, box, options.touching)) {
    handles.push_back(s.handle(slot));
  }
  return handles;
}

std::optional<HandleHit> MovingBoxes::first_hit(const AnyRay& ray) const {
  const State& s = *state_;
  if (!query::is_sound(ray)) query::require_ray("MovingBoxes::first_hit", ray);
  const auto hit = s.asked.first_hit({s.boxes, s.alive}, ray);
  if (!hit) return {};
  return HandleHit{s.handle(hit->slot), hit->hit};
}

}  // namespace plumb
