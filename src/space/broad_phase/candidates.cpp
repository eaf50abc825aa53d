#include "space/broad_phase/candidates.hpp"

#include <algorithm>
#include <utility>

#include "space/broad_phase/swept_columns.hpp"

namespace plumb::space {

std::uint32_t Candidates::place_for(std::uint32_t slot) {
  if (place_of_.size() <= slot) place_of_.resize(std::size_t{slot} + 1, none);
  if (place_of_[slot] != none) return place_of_[slot];
  place_of_[slot] = static_cast<std::uint32_t>(slot_of_.size());
  slot_of_.push_back(slot), serial_.push_back(0), fat_.emplace_back(), now_.emplace_back();
  has_fat_.push_back(0), is_listed_.push_back(0), first_added_.push_back(none);
  return place_of_[slot];
}

void Candidates::make_anew(std::span<const Aabb3> boxes, std::span<const std::uint32_t> slots, double margin) {
  std::vector<Aabb3> alive;
  alive.reserve(slots.size());
  for (const std::uint32_t slot : slots) alive.push_back(boxes[slot]);
  place_of_.assign(boxes.size(), none);
  slot_of_.clear(), serial_.clear(), fat_.clear(), now_.clear(), has_fat_.clear(), is_listed_.clear();
  first_added_.clear(), next_added_.clear(), all_.clear(), met_.clear();
  listed_.clear(), listed_from_.clear(), placed_.clear();
  dropped_ = 0, made_ = 0, outside_ = 0;
  columns_ = {};
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
  bounds_ = bounds;
  map_.expect_others();
  auto ordinals = ordinals_of(Execution::serial, set, map_);
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < alive.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) lengths[k] += static_cast<double>(ordinals[i].high[k] - ordinals[i].low[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double wide = margin * lengths[k] / static_cast<double>(alive.size());
    margin_[k] = static_cast<std::int32_t>(std::min(wide, 0x1p29));
  }
  std::vector<OrdinalBox> here(boxes.size());  // of each slot
  for (std::size_t i = 0; i < alive.size(); ++i) {
    OrdinalBox& box = ordinals[i];
    box.number = static_cast<std::int32_t>(slots[static_cast<std::size_t>(box.number)]);
    here[static_cast<std::size_t>(box.number)] = box;
    box = fattened(box);
  }
  const std::size_t n = alive.size();
  strips_ = plan.columns;
  while (!divide_into_columns(Execution::serial, {ordinals.get(), n}, strips_, 6 * n + 4096, columns_)) {
    for (auto& strips : strips_) strips = (strips + 1) / 2;
  }
  sort_columns(columns_);
  // Places in the order of columns.
  for (std::uint32_t i = 0; i < columns_.begin.back(); ++i) {
    OrdinalBox& copy = columns_.boxes[i];
    if (copy.marks != 0) continue;  // it has begun in another column
    const std::uint32_t own = place_for(static_cast<std::uint32_t>(copy.number));
    now_[own] = here[slot_of_[own]];
    fat_[own] = copy;
    has_fat_[own] = is_listed_[own] = 1;
  }
  for (std::uint32_t i = 0; i < columns_.begin.back(); ++i) {
    OrdinalBox& copy = columns_.boxes[i];
    copy.number = static_cast<std::int32_t>(place_of_[static_cast<std::size_t>(copy.number)]);
  }
  PairBlock block(&all_, [](void* to, std::span<const BoxPair> pairs) {
    auto& all = *static_cast<std::vector<Candidate>*>(to);
    for (const BoxPair& p : pairs) all.push_back({p.a, p.b});
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
  list_made();
}

void Candidates::list_made() {
  made_ = static_cast<std::uint32_t>(all_.size());
  met_.assign(all_.size(), Met::no);
  listed_from_.assign(slot_of_.size() + 2, 0);
  for (const auto& [a, b] : all_) ++listed_from_[a + 2], ++listed_from_[b + 2];
  for (std::size_t i = 2; i < listed_from_.size(); ++i) listed_from_[i] += listed_from_[i - 1];
  listed_.resize(2 * all_.size());
  for (std::uint32_t c = 0; c < made_; ++c) {
    const auto& [a, b] = all_[c];
    listed_[listed_from_[a + 1]++] = {b, c};
    listed_[listed_from_[b + 1]++] = {a, c};
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
  if (!has_map_) return false;
  const std::uint32_t own = place_for(slot);
  const OrdinalBox here = map_(box, own, 0);
  now_[own] = here;
  const OrdinalBox& fat = fat_[own];
  bool within = has_fat_[own] != 0;
  for (std::size_t k = 0; k < 3; ++k) within &= fat.low[k] <= here.low[k] && here.high[k] <= fat.high[k];
  return within;
}

void Candidates::drop(std::uint32_t slot) {
  const std::uint32_t own = slot < place_of_.size() ? place_of_[slot] : none;
  if (own == none) return;
  for_each_of(slot, [&](std::uint32_t c, const Candidate&) { met_[c] = Met::dropped, ++dropped_; });
  first_added_[own] = none;
  is_listed_[own] = has_fat_[own] = 0;
  ++serial_[own];
}

void Candidates::add(std::uint32_t a, std::uint32_t b) {
  const auto c = static_cast<std::uint32_t>(all_.size());
  all_.push_back({a, b});
  met_.push_back(Met::no);
  next_added_.push_back({first_added_[a], first_added_[b]});
  first_added_[a] = first_added_[b] = c;
}

void Candidates::place(std::uint32_t slot, const Aabb3& box) {
  outside_ += is_outside(box) ? 1 : 0;
  const std::uint32_t own = place_of_[slot];
  OrdinalBox fat = fattened(now_[own]);
  fat.number = static_cast<std::int32_t>(own);
  fat_[own] = fat;
  has_fat_[own] = 1;
  const std::uint32_t from1 = strip_of(fat.low[1], strips_[0]), from2 = strip_of(fat.low[2], strips_[1]);
  const std::uint32_t to1 = strip_of(fat.high[1], strips_[0]), to2 = strip_of(fat.high[2], strips_[1]);
  for (std::uint32_t s = from1; s <= to1; ++s) {
    for (std::uint32_t t = from2; t <= to2; ++t) {
      const std::size_t column = std::size_t{s} * strips_[1] + t;
      const std::int32_t begun = (s != from1 ? 1 : 0) | (t != from2 ? 2 : 0);
      const auto consider = [&](const OrdinalBox& b) {
        bool apart = (b.marks & begun) != 0;
        for (std::size_t k = 0; k < 3; ++k) apart |= fat.low[k] > b.high[k] || b.low[k] > fat.high[k];
        if (!apart && is_current(b)) add(own, static_cast<std::uint32_t>(b.number));
      };
      const std::span<const OrdinalBox> standing = columns_[column];
      auto at = std::partition_point(standing.begin(), standing.end(),
                                     [&](const OrdinalBox& b) { return b.low[0] < fat.low[0] - longest_[column]; });
      for (; at != standing.end() && at->low[0] <= fat.high[0]; ++at) consider(*at);
      for (const OrdinalBox& b : placed_[column]) consider(b);
      placed_[column].push_back(fat);
      placed_[column].back().marks = static_cast<std::int32_t>(serial_[own] << 2) | begun;
    }
  }
}

}  // namespace plumb::space
