// Selection: what is divided in two halves by a key, and where?
//
// Laws: after select(first, middle, last, less) the item at middle is the one that sorting by `less`, a total order,
// would put there, and none before it comes after it.
// Source: Floyd and Rivest 1975, whose sample is a guess; branch-free partition after Lomuto.  Where samples fail,
// std::nth_element.
// Cost: some 1.5 n comparisons; n log n at the worst.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace plumb::space::kd {

/// Items less than the pivot, which is at `first`, come before it; the pivot's place.  No branch depends on an item.
template <class Item, class Less>
Item* partition_by_first(Item* first, Item* last, const Less& less) {
  const Item pivot = *first;
  Item* end = first + 1;
  for (Item* i = first + 1; i != last; ++i) {
    const Item x = *i;
    *i = *end;
    *end = x;
    end += less(x, pivot) ? 1 : 0;
  }
  --end;
  *first = *end;
  *end = pivot;
  return end;
}

/// A guess at a pivot near the middle, put first: of few items the median of some, of many that of a sample.
template <class Item, class Less>
void guess_pivot(Item* first, Item* middle, Item* last, const Less& less);

template <class Item, class Less>
void select(Item* first, Item* middle, Item* last, const Less& less) {
  constexpr std::ptrdiff_t few = 4;
  for (int rounds = 0; last - first > few; ++rounds) {
    if (rounds == 64) break;
    guess_pivot(first, middle, last, less);
    Item* const pivot = partition_by_first(first, last, less);
    if (pivot == middle) return;
    if (pivot < middle) {
      first = pivot + 1;
    } else {
      last = pivot;
    }
  }
  std::nth_element(first, middle, last, less);
}

template <class Item, class Less>
void guess_pivot(Item* first, Item* middle, Item* last, const Less& less) {
  const std::ptrdiff_t n = last - first;
  if (n > 512) {
    // Of a sample about the middle, the item whose rank is that share of it, or a little nearer to the longer side.
    const double size = static_cast<double>(n), rank = static_cast<double>(middle - first), z = std::log(size),
                 sample = 0.5 * std::exp(2 * z / 3),
                 off = 0.5 * std::sqrt(z * sample * (size - sample) / size) * (rank < size / 2 ? -1 : 1);
    const auto at_least = std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(rank - rank * sample / size + off));
    const auto at_most =
        std::min<std::ptrdiff_t>(n - 1, static_cast<std::ptrdiff_t>(rank + (size - rank) * sample / size + off));
    select(first + std::min(at_least, middle - first), middle, first + std::max(at_most, middle - first) + 1, less);
    std::swap(*first, *middle);
    return;
  }
  const auto median = [&](Item* a, Item* b, Item* c) {
    const bool ab = less(*a, *b), bc = less(*b, *c), ac = less(*a, *c);
    return ab == bc ? b : (ab == ac ? c : a);
  };
  const std::ptrdiff_t step = n / 8;
  Item* pivot = median(first, first + n / 2, last - 1);
  if (n > 40) {
    pivot = median(median(first, first + step, first + 2 * step),
                   median(first + 3 * step, first + 4 * step, first + 5 * step),
                   median(first + 6 * step, first + 7 * step, last - 1));
  }
  std::swap(*first, *pivot);
}

}  // namespace plumb::space::kd
