#include "query/separation/proved_corners.hpp"

#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"
#include "query/separation/corner_search.hpp"
#include "query/separation/exact_corners.hpp"

namespace plumb::query {
namespace {

template <class T>
std::optional<Sign> gap_in(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners,
                           double radius_a, double radius_b) {
  CertainSigns ask;
  const auto n = nearest_of<T, Sought::square>(a, b, corners, ask);
  const T reach = (T(radius_a) + T(radius_b)) * a.scale<T>();
  const Sign gap = ask(n.square - reach * reach * n.square_whole);
  return ask.certain() ? std::optional(gap) : std::nullopt;
}

}  // namespace

NamedCorners named(const DifferenceCorners& corners, std::size_t which) {
  NamedCorners n;
  for (std::size_t i = 0; i < corners.size; ++i) {
    const std::uint32_t c = corners.ends[i][which];
    if (std::ranges::find(n.all(), c) == n.all().end()) n.index[n.size++] = c;
  }
  return n;
}

std::optional<ProvedCorners> proved_nearest(const CoreCorners& a, const CoreCorners& b) {
  return proved_nearest(a, b, guessed_nearest(a, b));
}

std::optional<ProvedCorners> proved_nearest(const CoreCorners& a, const CoreCorners& b,
                                            const DifferenceCorners& guess) {
  if (const auto j = judged<Running>(a, b, guess); j && j->holds) return j->proved;
  if (!a.is_finite() || !b.is_finite()) return {};
  if (const auto j = judged<ShortDyadic>(a, b, guess); j && j->holds) return j->proved;
  return settled<ShortDyadic>(a, b, guess, [](const DifferenceCorners&) {});
}

ProvedCorners certainly_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& guess,
                                std::vector<DifferenceCorners>* seen) {
  DifferenceCorners last = guess;
  const auto see = [&](const DifferenceCorners& corners) {
    last = corners;
    if (seen != nullptr) seen->push_back(corners);
  };
  if (const auto proved = settled<ShortDyadic>(a, b, guess, see)) return *proved;
  if (seen != nullptr && !seen->empty()) seen->pop_back();  // will be seen again
  return *settled<BigDyadic>(a, b, last, see);
}

Sign gap_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners, double radius_a,
            double radius_b) {
  const auto gap = gap_in<ShortDyadic>(a, b, corners, radius_a, radius_b);
  return gap ? *gap : *gap_in<BigDyadic>(a, b, corners, radius_a, radius_b);
}

}  // namespace plumb::query
