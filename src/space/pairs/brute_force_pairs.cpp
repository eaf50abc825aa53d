// Every pair is asked of relate itself, which knows nothing of the methods that are held against it.
#include "plumb/space/pairs/brute_force_pairs.hpp"

#include "plumb/figure/aabb/relation.hpp"
#include "space/pairs/checked_boxes.hpp"

namespace plumb {
namespace {

const Aabb2& as_doubles(const Aabb2& box) { return box; }
const Aabb3& as_doubles(const Aabb3& box) { return box; }
Aabb2 as_doubles(const FloatBox2& box) { return widened(box); }
Aabb3 as_doubles(const FloatBox3& box) { return widened(box); }

template <class Box>
bool is_pair_by_relate(const Box& a, const Box& b, const BoxPairOptions& options) {
  return relate(as_doubles(a), as_doubles(b)) >= (options.touching ? Relation::touching : Relation::overlapping);
}

template <class Box>
std::vector<BoxPair> pairs_of_one(std::span<const Box> boxes, const BoxPairOptions& options,
                                  std::vector<BoxPair> pairs) {
  space::check_boxes("brute_force_pairs", "boxes", boxes);
  pairs.clear();
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (is_pair_by_relate(boxes[a], boxes[b], options)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

template <class Box>
std::vector<BoxPair> pairs_of_two(std::span<const Box> of_a, std::span<const Box> of_b, const BoxPairOptions& options,
                                  std::vector<BoxPair> pairs) {
  space::check_boxes("brute_force_pairs", "a", of_a);
  space::check_boxes("brute_force_pairs", "b", of_b);
  pairs.clear();
  for (std::uint32_t a = 0; a < of_a.size(); ++a) {
    for (std::uint32_t b = 0; b < of_b.size(); ++b) {
      if (is_pair_by_relate(of_a[a], of_b[b], options)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace

#define PLUMB_PAIRS_BY_BRUTE_FORCE(Box)                                                              \
  std::vector<BoxPair> brute_force_pairs(std::span<const Box> boxes, const BoxPairOptions& options,  \
                                         std::vector<BoxPair> rows) {                                \
    return pairs_of_one(boxes, options, std::move(rows));                                            \
  }                                                                                                  \
  std::vector<BoxPair> brute_force_pairs(std::span<const Box> a, std::span<const Box> b,             \
                                         const BoxPairOptions& options, std::vector<BoxPair> rows) { \
    return pairs_of_two(a, b, options, std::move(rows));                                             \
  }
PLUMB_PAIRS_BY_BRUTE_FORCE(Aabb2)
PLUMB_PAIRS_BY_BRUTE_FORCE(Aabb3)
PLUMB_PAIRS_BY_BRUTE_FORCE(FloatBox2)
PLUMB_PAIRS_BY_BRUTE_FORCE(FloatBox3)
#undef PLUMB_PAIRS_BY_BRUTE_FORCE

}  // namespace plumb
