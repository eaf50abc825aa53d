#include "plumb/space/broad_phase/moving_boxes.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "query/ray/numbers.hpp"
#include "space/broad_phase/asked_boxes.hpp"
#include "space/broad_phase/frame_sweep.hpp"
#include "space/broad_phase/pair_order.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/pairs/checked_boxes.hpp"
#include "space/pairs/refused_handle.hpp"

namespace plumb {
namespace {

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
  BoxPairChanges changes;
  // As of the last call of changes(): the boxes of slots that are updated, and which slots there were.
  std::vector<Aabb3> boxes_before;
  std::vector<std::uint8_t> was_alive;
  space::FrameSweep frames;

  [[nodiscard]] bool contains(const BoxHandle& h) const {
    return h.slot < generation.size() && alive[h.slot] != 0 && generation[h.slot] == h.generation;
  }
  [[nodiscard]] BoxHandle handle(std::uint32_t slot) const { return {slot, generation[slot]}; }
  void require(const char* function, const std::string& name, const BoxHandle& h) const {
    if (contains(h)) return;
    const bool was = h.slot < generation.size() &&
                     (h.generation < generation[h.slot] || (h.generation == generation[h.slot] && alive[h.slot] == 0));
    space::refuse_handle(function, name, h, was);
  }
  void mark(std::uint32_t slot) {
    if (updated[slot] == 0) moved.push_back(slot), boxes_before[slot] = boxes[slot];
    updated[slot] = 1;
  }
};

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
  s.mark(slot);
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
  s.mark(handle.slot);
  s.alive[handle.slot] = 0;
  s.removed.push_back(handle.slot);
  --s.size;
  s.asked.note_removed(handle.slot);
}

void MovingBoxes::move(const BoxHandle& handle, const Aabb3& box) {
  move(std::span<const BoxHandle>(&handle, 1), std::span<const Aabb3>(&box, 1));
}

void MovingBoxes::move(std::span<const BoxHandle> handles, std::span<const Aabb3> boxes) {
  State& s = *state_;
  if (handles.size() != boxes.size()) {
    throw UnequalLengths("MovingBoxes::move: handles has " + std::to_string(handles.size()) + " items, but boxes has " +
                         std::to_string(boxes.size()));
  }
  space::check_boxes("MovingBoxes::move", "boxes", boxes);
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
      if (!is_twice) s.require("MovingBoxes::move", name, h);
      throw InvalidShape("MovingBoxes::move: " + name + " " + space::text_of_handle(h) + " is there twice");
    }
    s.updated[h.slot] |= seen;
  }
  forget(handles.size());
  // Where all are told at once those before need not be copied.
  const bool are_all = s.moved.empty() && handles.size() == s.boxes.size();
  if (are_all) s.boxes.swap(s.boxes_before);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const std::uint32_t slot = handles[i].slot;
    if (!are_all) {
      s.mark(slot);
    } else {
      s.moved.push_back(slot), s.updated[slot] = 1;
    }
    s.boxes[slot] = boxes[i];
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
  const space::FrameWork done =
      s.frames.find({s.boxes, s.boxes_before, s.alive, s.was_alive, s.updated, s.moved, s.options.touching});
  const auto tell = [&](const std::vector<BoxPair>& pairs, std::vector<HandlePair>& to) {
    to.clear();
    to.reserve(pairs.size());
    for (const BoxPair& p : pairs) to.push_back({s.handle(p.a), s.handle(p.b)});
  };
  tell(s.frames.lost(), s.changes.lost);
  tell(s.frames.added(), s.changes.added);
  s.changes.work = {done.planned_anew, done.all_swept, 0, done.cost_of_each, done.cost_of_all};
  for (const std::uint32_t slot : s.moved) {
    s.changes.work.moved += s.alive[slot];
    s.updated[slot] = 0, s.was_alive[slot] = s.alive[slot];
  }
  for (const std::uint32_t slot : s.removed) {  // a slot is used again only from now on
    ++s.generation[slot];
    s.free.push_back(slot);
  }
  s.removed.clear();
  s.moved.clear();
  return s.changes;
}

std::vector<HandlePair> MovingBoxes::overlapping_pairs(std::vector<HandlePair> rows) const {
  const State& s = *state_;
  std::vector<std::uint32_t> slots;
  std::vector<Aabb3> then;
  for (std::uint32_t slot = 0; slot < s.boxes.size(); ++slot) {
    if (s.was_alive[slot] == 0) continue;
    slots.push_back(slot), then.push_back(s.updated[slot] != 0 ? s.boxes_before[slot] : s.boxes[slot]);
  }
  std::vector<BoxPair> all = plumb::overlapping_pairs(then, BroadPhaseOptions{s.options.touching, Execution::serial}),
                       other;
  space::sort_pairs(all, other);  // as those of slots, which ascend
  rows.clear();
  rows.reserve(all.size());
  for (const BoxPair& p : all) rows.push_back({s.handle(slots[p.a]), s.handle(slots[p.b])});
  return rows;
}

std::vector<BoxHandle> MovingBoxes::in_box(const Aabb3& box, const InBoxOptions& options,
                                           std::vector<BoxHandle> rows) const {
  const State& s = *state_;
  figure::require_finite_parts<Point3, Point3>("MovingBoxes::in_box", {"box.min", "box.max"}, box.min, box.max);
  rows.clear();
  if (is_empty(box)) return rows;
  for (const std::uint32_t slot : s.asked.in_box({s.boxes, s.alive}, box, options.touching)) {
    rows.push_back(s.handle(slot));
  }
  return rows;
}

std::optional<HandleHit> MovingBoxes::first_hit(const AnyRay& ray) const {
  const State& s = *state_;
  if (!query::is_sound(ray)) query::require_ray("MovingBoxes::first_hit", ray);
  const auto hit = s.asked.first_hit({s.boxes, s.alive}, ray);
  if (!hit) return {};
  return HandleHit{s.handle(hit->slot), hit->hit};
}

void MovingBoxes::visit_along(const AnyRay& ray, const AskEachBox& most) const {
  const State& s = *state_;
  if (!query::is_sound(ray)) query::require_ray("MovingBoxes::visit_along", ray);
  s.asked.along({s.boxes, s.alive}, ray, [&](std::uint32_t slot) { return most(s.handle(slot)); });
}

void MovingBoxes::visit_near(const Aabb3& box, double within, const AskEachBox& most) const {
  const State& s = *state_;
  figure::require_finite_parts<Point3, Point3>("MovingBoxes::visit_near", {"box.min", "box.max"}, box.min, box.max);
  if (!(within >= 0)) return;
  s.asked.near({s.boxes, s.alive}, box, within, [&](std::uint32_t slot) { return most(s.handle(slot)); });
}

}  // namespace plumb
