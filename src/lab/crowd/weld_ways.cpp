#include "lab/crowd/weld_ways.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace plumb::lab::trial {
namespace {

template <class Key, class KeyOf>
WeldInto first_of_key(const WeldCloud& cloud, KeyOf key_of) {
  std::map<Key, std::uint32_t> first;
  WeldInto into;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) into.push_back(first.emplace(key_of(cloud[i]), i).first->second);
  return into;
}

}  // namespace

WeldInto by_grid(const WeldCloud& cloud) {
  return first_of_key<std::array<double, 3>>(cloud, [](const Point3& p) {
    return std::array{std::round(p.x / weld_tolerance), std::round(p.y / weld_tolerance),
                      std::round(p.z / weld_tolerance)};
  });
}

WeldInto by_hashing(const WeldCloud& cloud) {
  return first_of_key<std::array<std::uint64_t, 3>>(cloud, [](const Point3& p) {
    return std::array{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                      std::bit_cast<std::uint64_t>(p.z)};
  });
}

WeldInto by_first_come(const WeldCloud& cloud) {
  WeldInto into;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    std::uint32_t k = 0;
    while (k < i && !(into[k] == k && are_near<double>(cloud[k], cloud[i]))) ++k;
    into.push_back(k);
  }
  return into;
}

WeldInto by_sorting(const WeldCloud& cloud) {
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return static_cast<float>(cloud[i].x); });
  WeldInto into(order.begin(), order.end());
  std::iota(into.begin(), into.end(), 0U);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i; k-- > 0;) {
      const std::uint32_t v = order[i], w = order[k];
      if (static_cast<float>(cloud[v].x) - static_cast<float>(cloud[w].x) > static_cast<float>(weld_tolerance)) break;
      if (into[w] != w || !are_near<float>(cloud[v], cloud[w])) continue;
      into[v] = w;
      break;
    }
  }
  return into;
}

}  // namespace plumb::lab::trial
