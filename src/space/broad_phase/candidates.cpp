#include "space/broad_phase/candidates.hpp"

#include <algorithm>
#include <utility>

#include "space/broad_phase/swept_columns.hpp"

namespace plumb::space {

void Candidates::grow_to(std::size_t slots) {
  if (first_.size() >= slots) return;
  const std::size_t room = std::max(slots, 2 * first_.size());
  first_.resize(room, Candidate::none);
  fat_.resize(room), now_.resize(room), serial_.resize(room), has_fat_.resize(room);
}

void Candidates::make_anew(std::span<const Aabb3> boxes, std::span<const std::uint32_t> slots, double margin) {
  std::vector<Aabb3> alive;
  alive.reserve(slots.size());
  for (const std::uint32_t slot : slots) alive.push_back(boxes[slot]);
  grow_to(boxes.size());
  std::fill(first_.begin(), first_.end(), Candidate::none);
  std::fill(serial_.begin(), serial_.end(), 0);
  std::fill(has_fat_.begin(), has_fat_.end(), 0);
  all_.clear(), met_.clear();
  dropped_ = 0;
  columns_ = {}, placed_.clear();
  has_map_ = !alive.empty();
  if (alive.empty()) return;

  const BoxSet<Aabb3> set{alive};
  SetBounds bounds;
  find_bounds(set.a, bounds);
  for (std::size_t k = 0; k < 3; ++k) {  // with some space around, for what moves out; a guess
    const double quarter = bounds.max[k] * 0.0625 - bounds.min[k] * 0.0625;
    const double space = quarter > 0 ? quarter : 1;
    const double from = bounds.min[k] - space, to = bounds.max[k] + space;
    if (from - from == 0 && to - to == 0) bounds.min[k] = from, bounds.max[k] = to;
  }
  auto [map, plan] = place_sweep(set, bounds);
  map_ = map;
  map_.expect_others();
  auto sorted = sorted_ordinals(Execution::serial, set, map_);
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < alive.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) lengths[k] += static_cast<double>(sorted[i].high[k] - sorted[i].low[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double wide = margin * lengths[k] / static_cast<double>(alive.size());
    margin_[k] = static_cast<std::int32_t>(std::min(wide, 0x1p29));
  }
  for (std::size_t i = 0; i < alive.size(); ++i) {  // starts move by the same steps, so the order stays
    OrdinalBox& box = sorted[i];
    box.number = static_cast<std::int32_t>(slots[static_cast<std::size_t>(box.number)]);
    now_[static_cast<std::size_t>(box.number)] = box;
    box = fattened(box);
    fat_[static_cast<std::size_t>(box.number)] = box;
    has_fat_[static_cast<std::size_t>(box.number)] = 1;
  }
  const std::size_t n = alive.size();
  strips_ = plan.columns;
  while (!divide_into_columns(Execution::serial, {sorted.get(), n}, strips_, 6 * n + 4096, columns_)) {
    for (auto& strips : strips_) strips = (strips + 1) / 2;
  }
  PairBlock block(&all_, [](void* to, std::span<const BoxPair> pairs) {
    auto& all = *static_cast<std::vector<Candidate>*>(to);
    for (const BoxPair& p : pairs) all.push_back({p.a, p.b, Candidate::none, Candidate::none});
  });
  longest_.assign(columns_.size(), 0);
  placed_.resize(columns_.size());
  SweptBoxes swept;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    for (const OrdinalBox& b : columns_[c]) longest_[c] = std::max(longest_[c], b.high[0] - b.low[0]);
    if (columns_[c].size() < 2) continue;
    swept.assign(columns_[c]);
    sweep(swept, 0, swept.size() - 1, {nullptr, [](const void*, std::int32_t, std::int32_t) { return true; }}, block);
  }
  block.flush();
  met_.assign(all_.size(), Met::no);
  for (std::uint32_t c = 0; c < all_.size(); ++c) {
    Candidate& candidate = all_[c];
    candidate.next_a = std::exchange(first_[candidate.a], c);
    candidate.next_b = std::exchange(first_[candidate.b], c);
  }
}

OrdinalBox Candidates::fattened(OrdinalBox box) const {
  constexpr std::int32_t last = (1 << ordinal_bits) - 1;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = std::max(box.low[k] - margin_[k], 0);
    box.high[k] = std::min(box.high[k] + margin_[k], last);
  }
  return box;
}

bool Candidates::move_to(std::uint32_t slot, const Aabb3& box) {
  grow_to(std::size_t{slot} + 1);
  if (!has_map_) return false;
  const OrdinalBox here = map_(box, slot, 0);
  now_[slot] = here;
  const OrdinalBox& fat = fat_[slot];
  bool within = has_fat_[slot] != 0;
  for (std::size_t k = 0; k < 3; ++k) within &= (fat.low[k] <= here.low[k]) & (here.high[k] <= fat.high[k]);
  return within;
}

void Candidates::drop(std::uint32_t slot) {
  if (slot >= first_.size()) return;
  for_each_of(slot, [&](std::uint32_t c) { met_[c] = Met::dropped, ++dropped_; });
  first_[slot] = Candidate::none;
  has_fat_[slot] = 0;
  ++serial_[slot];
}

void Candidates::add(std::uint32_t a, std::uint32_t b) {
  const auto c = static_cast<std::uint32_t>(all_.size());
  all_.push_back({a, b, first_[a], first_[b]});
  met_.push_back(Met::no);
  first_[a] = first_[b] = c;
}

void Candidates::place(std::uint32_t slot) {
  OrdinalBox fat = fattened(now_[slot]);
  fat.number = static_cast<std::int32_t>(slot);
  fat_[slot] = fat;
  has_fat_[slot] = 1;
  const std::uint32_t from1 = strip_of(fat.low[1], strips_[0]), from2 = strip_of(fat.low[2], strips_[1]);
  const std::uint32_t to1 = strip_of(fat.high[1], strips_[0]), to2 = strip_of(fat.high[2], strips_[1]);
  for (std::uint32_t s = from1; s <= to1; ++s) {
    for (std::uint32_t t = from2; t <= to2; ++t) {
      const std::size_t column = std::size_t{s} * strips_[1] + t;
      const std::int32_t begun = (s != from1 ? 1 : 0) | (t != from2 ? 2 : 0);
      const auto consider = [&](const OrdinalBox& b) {
        bool apart = (b.marks & begun) != 0;
        for (std::size_t k = 0; k < 3; ++k) apart |= (fat.low[k] > b.high[k]) | (b.low[k] > fat.high[k]);
        if (!apart && is_current(b)) add(slot, static_cast<std::uint32_t>(b.number));
      };
      const std::span<const OrdinalBox> standing = columns_[column];
      auto at = std::partition_point(standing.begin(), standing.end(),
                                     [&](const OrdinalBox& b) { return b.low[0] < fat.low[0] - longest_[column]; });
      for (; at != standing.end() && at->low[0] <= fat.high[0]; ++at) consider(*at);
      for (const OrdinalBox& b : placed_[column]) consider(b);
      placed_[column].push_back(fat);
      placed_[column].back().marks = static_cast<std::int32_t>(serial_[slot] << 2) | begun;
    }
  }
}

bool Candidates::do_meet(const Candidate& c, std::span<const Aabb3> boxes, bool touching) const {
  const OrdinalBox &a = now_[c.a], &b = now_[c.b];
  bool apart = false, equal = false;
  for (std::size_t k = 0; k < 3; ++k) {
    apart |= (a.low[k] > b.high[k]) | (b.low[k] > a.high[k]);
    equal |= (a.low[k] == b.high[k]) | (b.low[k] == a.high[k]);
  }
  if (apart) return false;
  return equal ? boxes_meet(boxes[c.a], boxes[c.b], touching) : true;
}

}  // namespace plumb::space
