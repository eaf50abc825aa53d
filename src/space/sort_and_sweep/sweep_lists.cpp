#include "plumb/space/sort_and_sweep/sweep_lists.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <string>
#include <unordered_set>

#include "plumb/arith/error.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/pairs/boxes_meet.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace {

/// Of box e / 2 the start where e is even, the end where it is odd.
using Endpoint = std::uint32_t;
constexpr Endpoint no_endpoint = 0xffffffff;

double coordinate(const Point3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

}  // namespace

struct SweepLists::State {
  SweepListsOptions options;
  std::size_t first_axis = 0;
  std::vector<Aabb3> boxes;
  std::vector<std::uint8_t> there;
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> free;
  std::size_t size = 0, steps = 0;
  struct Links {
    Endpoint before, after;
  };
  std::array<std::vector<Links>, 3> links;  // along each axis
  std::array<Endpoint, 3> last{no_endpoint, no_endpoint, no_endpoint};
  std::unordered_set<std::uint64_t> overlapping;  // along the axes that have lists

  [[nodiscard]] std::size_t axis(int list) const { return (first_axis + static_cast<std::size_t>(list)) % 3; }

  [[nodiscard]] bool overlap_along(std::size_t k, const Aabb3& a, const Aabb3& b) const {
    return space::intervals_meet(coordinate(a.min, k), coordinate(a.max, k), coordinate(b.min, k), coordinate(b.max, k),
                                 options.touching);
  }
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  /// Must x stand behind y?
  [[nodiscard]] bool is_behind(std::size_t k, Endpoint x, Endpoint y) const {
    const auto value = [&](Endpoint e) {
      const Aabb3& box = boxes[e / 2];
      return coordinate(e % 2 == 0 ? box.min : box.max, k);
    };
    const auto rank = [&](Endpoint e) {
      const bool is_end = e % 2 == 1;
      if (options.touching) return is_end ? 1 : 0;
      const Aabb3& box = boxes[e / 2];
      if (coordinate(box.min, k) == coordinate(box.max, k)) return is_end ? 2 : 1;
      return is_end ? 0 : 3;
    };
    const double vx = value(x), vy = value(y);
    return vx > vy || (vx == vy && rank(x) > rank(y));
  }

  // A start and an end have changed places.
  void passed(Endpoint x, Endpoint y) {
    ++steps;
    if (x % 2 == y % 2 || x / 2 == y / 2) return;
    const Aabb3 &a = boxes[x / 2], &b = boxes[y / 2];
    bool overlap = true;
    for (int list = 0; list < options.axes && overlap; ++list) overlap = overlap_along(axis(list), a, b);
    if (overlap) {
      overlapping.insert(key(x / 2, y / 2));
    } else {
      overlapping.erase(key(x / 2, y / 2));
    }
  }

  void unlink(std::size_t k, Endpoint e) {
    const auto [before, after] = links[k][e];
    if (before != no_endpoint) links[k][before].after = after;
    (after != no_endpoint ? links[k][after].before : last[k]) = before;
  }
  void link_between(std::size_t k, Endpoint e, Endpoint before, Endpoint after) {
    links[k][e] = {before, after};
    if (before != no_endpoint) links[k][before].after = e;
    (after != no_endpoint ? links[k][after].before : last[k]) = e;
  }

  void move_back(std::size_t k, Endpoint e) {
    Endpoint before = links[k][e].before, after = e;
    for (; before != no_endpoint && is_behind(k, before, e); before = links[k][before].before) {
      passed(e, before);
      after = before;
    }
    if (after == e) return;
    unlink(k, e);
    link_between(k, e, before, after);
  }
  void move_on(std::size_t k, Endpoint e) {
    Endpoint before = e, after = links[k][e].after;
    for (; after != no_endpoint && is_behind(k, e, after); after = links[k][after].after) {
      passed(e, after);
      before = after;
    }
    if (before == e) return;
    unlink(k, e);
    link_between(k, e, before, after);
  }

  // The end is moved first where the box moves on, so that its start does not pass it; else the start.
  void settle(std::uint32_t number) {
    const Endpoint start = 2 * number, end = start + 1;
    for (int list = 0; list < options.axes; ++list) {
      const std::size_t k = axis(list);
      move_on(k, end);
      move_back(k, start);
      move_on(k, start);
      move_back(k, end);
    }
  }
  void require_there(const char* function, std::uint32_t number) const {
    if (number < there.size() && there[number] != 0) return;
    throw InvalidShape(std::string(function) + ": there is no box " + std::to_string(number));
  }
};

SweepLists::SweepLists(const SweepListsOptions& options) : state_(std::make_unique<State>()) {
  if (options.axes < 1 || options.axes > 3) {
    throw InvalidShape("SweepLists: options.axes is " + std::to_string(options.axes) + ", but it must lie from 1 to 3");
  }
  if (options.first_axis == SweepAxis::greatest_variance) {
    throw InvalidShape(
        "SweepLists: options.first_axis is greatest_variance, which nobody knows before there are boxes");
  }
  state_->options = options;
  state_->first_axis = static_cast<std::size_t>(options.first_axis);
}
SweepLists::SweepLists(SweepLists&&) noexcept = default;
SweepLists& SweepLists::operator=(SweepLists&&) noexcept = default;
SweepLists::~SweepLists() = default;

std::uint32_t SweepLists::insert(const Aabb3& box) {
  if (!space::is_sound(box)) space::refuse_box("SweepLists::insert", "box", box);
  State& s = *state_;
  std::uint32_t number = 0;
  if (s.free.empty()) {
    number = static_cast<std::uint32_t>(s.boxes.size());
    s.boxes.push_back(box), s.there.push_back(1);
    for (auto& links : s.links) links.resize(2 * s.boxes.size());
  } else {
    number = s.free.top();
    s.free.pop();
    s.boxes[number] = box, s.there[number] = 1;
  }
  ++s.size;
  for (int list = 0; list < s.options.axes; ++list) {
    const std::size_t k = s.axis(list);
    s.link_between(k, 2 * number, s.last[k], no_endpoint);
    s.link_between(k, 2 * number + 1, s.last[k], no_endpoint);
    s.move_back(k, 2 * number);
    s.move_back(k, 2 * number + 1);
  }
  return number;
}

void SweepLists::move(std::uint32_t number, const Aabb3& box) {
  if (!space::is_sound(box)) space::refuse_box("SweepLists::move", "box", box);
  state_->require_there("SweepLists::move", number);
  state_->boxes[number] = box;
  state_->settle(number);
}

void SweepLists::remove(std::uint32_t number) {
  State& s = *state_;
  s.require_there("SweepLists::remove", number);
  std::erase_if(s.overlapping,
                [&](std::uint64_t key) { return key >> 32 == number || static_cast<std::uint32_t>(key) == number; });
  for (int list = 0; list < s.options.axes; ++list) {
    s.unlink(s.axis(list), 2 * number);
    s.unlink(s.axis(list), 2 * number + 1);
  }
  s.there[number] = 0;
  s.free.push(number);
  --s.size;
}

bool SweepLists::contains(std::uint32_t number) const {
  return number < state_->there.size() && state_->there[number] != 0;
}
std::size_t SweepLists::size() const { return state_->size; }
std::size_t SweepLists::steps() const { return state_->steps; }

std::vector<BoxPair> SweepLists::overlapping_pairs(std::vector<BoxPair> rows) const {
  const State& s = *state_;
  rows.clear();
  for (const std::uint64_t key : s.overlapping) {
    const auto a = static_cast<std::uint32_t>(key >> 32), b = static_cast<std::uint32_t>(key);
    if (space::boxes_meet(s.boxes[a], s.boxes[b], s.options.touching)) rows.push_back({a, b});
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace plumb
