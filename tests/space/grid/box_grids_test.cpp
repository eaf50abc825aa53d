// Does every grid tell the pairs of boxes that brute force tells, each once, while boxes come, go and move?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/static_grid.hpp"
#include "plumb/space/textbook/box_store.hpp"
#include "space/textbook/loose_tree.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;

/// Kinds of sets of boxes; `one_ulp` is a lattice of boxes that touch, or miss or overlap by an ulp.
enum class Set { random, clustered, lattice, one_ulp, equal, nested, sizes, extreme, flat };
constexpr std::array all_sets{Set::random, Set::clustered, Set::lattice, Set::one_ulp, Set::equal,
                              Set::nested, Set::sizes,     Set::extreme, Set::flat};

double moved_by_an_ulp(double x, Entropy& entropy) {
  const int way = static_cast<int>(entropy.below(3));
  return way == 0 ? x : std::nextafter(x, way == 1 ? 1e308 : -1e308);
}

struct Side {
  double min, max;
};

Side side_of(Set set, std::size_t axis, double cluster, Entropy& entropy) {
  const auto unit = [&] { return static_cast<double>(entropy.bits(53)) * 0x1p-53; };
  const auto around = [](double center, double half) { return Side{center - half, center + half}; };
  switch (set) {
    case Set::random:
      return around(unit() * 10 - 5, unit());
    case Set::clustered:
      return around(cluster + unit() * 0.1, unit() * 0.02);
    case Set::lattice: {
      const auto at = static_cast<double>(entropy.within(3));
      return {at, at + static_cast<double>(entropy.below(3))};
    }
    case Set::one_ulp: {
      const double at = static_cast<double>(entropy.within(2)) * 0.1;
      const double a = moved_by_an_ulp(at, entropy), b = moved_by_an_ulp(at + 0.1, entropy);
      return {std::min(a, b), std::max(a, b)};
    }
    case Set::equal:
      return {0.3, 0.7};
    case Set::nested:
      return around(0, std::ldexp(1, static_cast<int>(entropy.within(20))));
    case Set::sizes:
      return around(unit() * 2000, std::exp2(unit() * 20 - 10));
    case Set::extreme: {
      constexpr double most = std::numeric_limits<double>::max();
      constexpr std::array places{-most, -1.0, -0x1p-1074, -0.0, 0.0, 0x1p-1074, 0x1p-1022, 1e-200, 1.0, 1e200, most};
      const double a = places[entropy.below(places.size())], b = places[entropy.below(places.size())];
      return {std::min(a, b), std::max(a, b)};
    }
    case Set::flat:
      if (axis == 0) return {0, 0};
      return entropy.coin() ? around(unit() * 4, 0) : around(std::round(unit() * 4), std::round(unit()));
  }
  return {};
}

template <class Box>
Box box_of(Set set, double cluster, Entropy& entropy) {
  const Side x = side_of(set, 0, cluster, entropy), y = side_of(set, 1, cluster, entropy);
  if constexpr (std::is_same_v<Box, Aabb2>) {
    return {{x.min, y.min}, {x.max, y.max}};
  } else {
    const Side z = side_of(set, 2, cluster, entropy);
    return {{x.min, y.min, z.min}, {x.max, y.max, z.max}};
  }
}

template <class Box>
std::vector<Box> boxes_of(Set set, std::size_t count, Entropy& entropy) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    boxes.push_back(box_of<Box>(set, static_cast<double>(entropy.below(4)) * 3, entropy));
  }
  return boxes;
}

/// By every pair, of the boxes that are there.
template <class Box>
std::vector<BoxPair> by_brute_force(const std::vector<Box>& boxes, const std::vector<char>& there, bool touching) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      if (there[a] == 0 || there[b] == 0) continue;
      const Relation r = relate(boxes[a], boxes[b]);
      if (touching ? r != Relation::disjoint : r == Relation::overlapping) pairs.push_back({a, b});
    }
  }
  return pairs;
}

std::vector<BoxPair> sorted(std::vector<BoxPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::string name(Set set, std::size_t i) {
  std::ostringstream out;
  out << "set " << static_cast<int>(set) << ", case " << i;
  return out.str();
}

/// By the numbers of the boxes, which slots are.
std::vector<BoxPair> by_number(std::vector<BoxPair> pairs) { return pairs; }
std::vector<BoxPair> by_number(const std::vector<HandlePair>& pairs) {
  std::vector<BoxPair> numbers;
  for (const HandlePair& p : pairs) numbers.push_back({p.a.slot, p.b.slot});
  return numbers;
}
std::vector<std::uint32_t> by_number(std::vector<std::uint32_t> found) { return found; }
std::vector<std::uint32_t> by_number(const std::vector<BoxHandle>& found) {
  std::vector<std::uint32_t> numbers;
  for (const BoxHandle& h : found) numbers.push_back(h.slot);
  return numbers;
}

template <class Grid, class Box>
void expect_pairs(const Grid& grid, const std::vector<Box>& boxes, const std::vector<char>& there,
                  const std::string& what) {
  for (const bool touching : {true, false}) {
    const std::vector<BoxPair> expected = by_brute_force(boxes, there, touching);
    for (const Execution execution : {Execution::serial, Execution::parallel}) {
      ASSERT_EQ(sorted(by_number(grid.overlapping_pairs({touching, execution}))), expected)
          << what << (touching ? ", touching" : "");
    }
  }
}

template <class Grid, class Box>
void expect_in_box(const Grid& grid, const std::vector<Box>& boxes, const std::vector<char>& there, const Box& box,
                   const std::string& what) {
  for (const bool touching : {true, false}) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t b = 0; b < boxes.size(); ++b) {
      const Relation r = relate(box, boxes[b]);
      if (there[b] != 0 && (touching ? r != Relation::disjoint : r == Relation::overlapping)) expected.push_back(b);
    }
    ASSERT_EQ(by_number(grid.in_box(box, {.touching = touching})), expected) << what;
    if constexpr (requires(VisitBits bits) { grid.in_box(box, bits); }) {
      static VisitStamps stamps;
      static VisitBits bits;
      ASSERT_EQ(by_number(grid.in_box(box, stamps, {.touching = touching})), expected) << what;
      ASSERT_EQ(by_number(grid.in_box(box, bits, {.touching = touching})), expected) << what;
    }
  }
}

/// What a set of boxes was like.
struct Count {
  std::size_t pairs = 0, touching = 0;
};

template <class Box>
Count expect_static(Set set) {
  Count count;
  for (std::size_t i = 0; i < battery::fitting(20u); ++i) {
    Entropy entropy(7140 + static_cast<std::uint64_t>(set), i);
    const std::vector<Box> boxes = boxes_of<Box>(set, 1 + entropy.below(70), entropy);
    const std::vector<char> there(boxes.size(), 1);
    GridOptions options;
    if (i % 3 != 0 && set != Set::extreme && set != Set::sizes && set != Set::nested) {
      options.cell_size = i % 3 == 1 ? 0.7 : 3;
    }
    const StaticGrid<Box> grid(boxes, options);
    expect_pairs(grid, boxes, there, name(set, i));
    expect_in_box(grid, boxes, there, box_of<Box>(set, 0, entropy), name(set, i));
    if (::testing::Test::HasFatalFailure()) break;
    const std::size_t all = by_brute_force(boxes, there, true).size();
    count.pairs += all;
    count.touching += all - by_brute_force(boxes, there, false).size();
  }
  return count;
}

TEST(BoxGrids, StaticGridsTellThePairsOfBruteForce) {
  for (const Set set : all_sets) {
    const Count plane = expect_static<Aabb2>(set), space = expect_static<Aabb3>(set);
    ASSERT_FALSE(HasFatalFailure());
    if (!battery::reaches_rare) continue;
    EXPECT_GT(plane.pairs, 20u) << static_cast<int>(set);
    EXPECT_GT(space.pairs, 20u) << static_cast<int>(set);
    if (set == Set::lattice || set == Set::one_ulp) {
      EXPECT_GT(space.touching, space.pairs / 10) << static_cast<int>(set);
    }
  }
}

/// Boxes come, go and move; their slots are the numbers of a list of boxes.
template <class Grid, class Box>
void expect_changes(Grid grid, Set set, std::size_t seed) {
  Entropy entropy(7150 + static_cast<std::uint64_t>(set), seed);
  std::vector<Box> boxes;
  std::vector<char> there;
  std::vector<BoxHandle> handles;
  const auto any = [&] { return static_cast<std::uint32_t>(entropy.below(boxes.size())); };
  const int steps = 120;
  for (int step = 0; step < steps; ++step) {
    const Box box = box_of<Box>(set, static_cast<double>(entropy.below(4)) * 3, entropy);
    const auto choice = entropy.below(step < steps / 2 ? 4 : 7);
    if (choice < 3 || boxes.empty()) {
      const BoxHandle handle = grid.insert(box);
      if (handle.slot == boxes.size()) boxes.push_back(box), there.push_back(0), handles.emplace_back();
      ASSERT_LT(handle.slot, boxes.size());
      ASSERT_EQ(there[handle.slot], 0);
      ASSERT_NE(handle, handles[handle.slot]);  // a handle is never given again
      boxes[handle.slot] = box, there[handle.slot] = 1, handles[handle.slot] = handle;
    } else if (choice < 5) {
      const std::uint32_t i = any();
      if (there[i] != 0) {
        grid.move(handles[i], box);
        boxes[i] = box;
      } else {
        EXPECT_THROW(grid.move(handles[i], box), InvalidShape);
      }
    } else {
      const std::uint32_t i = any();
      if (there[i] != 0) grid.remove(handles[i]);
      there[i] = 0;
      EXPECT_THAT(text_of<InvalidShape>([&] { grid.remove(handles[i]); }),
                  HasSubstr("handle (slot " + std::to_string(i) + ", generation " +
                            std::to_string(handles[i].generation) + ") was removed"));
    }
    if (step % 20 == 19) {
      expect_pairs(grid, boxes, there, name(set, seed));
      expect_in_box(grid, boxes, there, box, name(set, seed));
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_EQ(grid.size(), static_cast<std::size_t>(std::count(there.begin(), there.end(), 1)));
  EXPECT_GT(grid.memory(), 0u);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    ASSERT_EQ(grid.contains(handles[i]), there[i] != 0);
    if (there[i] == 0) continue;
    ASSERT_EQ(grid.box(handles[i]), boxes[i]);
    grid.remove(handles[i]);
  }
  EXPECT_TRUE(grid.overlapping_pairs().empty());
  EXPECT_LE(grid.parts(), 1u);  // of an octree the root alone
}

/// A size of cells of which no box of the set reaches into too many.
double size_for(Set set) {
  if (set == Set::extreme) return 0x1p1023;
  return set == Set::nested ? 0x1p20 : set == Set::sizes ? 500 : 1.5;
}

template <class Box>
Box world() {
  if constexpr (std::is_same_v<Box, Aabb2>) return {{-3, -3}, {3, 3}};
  if constexpr (std::is_same_v<Box, Aabb3>) return {{-3, -3, -3}, {3, 3, 3}};
}

template <class Box>
void expect_dynamic(Set set) {
  for (std::size_t seed = 0; seed < (battery::sanitized ? 1u : 3u); ++seed) {
    const double size = size_for(set);
    expect_changes<HashedGrid<Box>, Box>(HashedGrid<Box>({.cell_size = size}), set, seed);
    expect_changes<LinkedGrid<Box>, Box>(LinkedGrid<Box>({.world = world<Box>()}), set, seed);
    expect_changes<ImplicitGrid<Box>, Box>(ImplicitGrid<Box>({.cell_size = size, .rows = seed == 0 ? 4u : 64u}), set,
                                           seed);
    expect_changes<HierarchicalGrid<Box>, Box>(HierarchicalGrid<Box>(), set, seed);
    expect_changes<HierarchicalGrid<Box>, Box>(HierarchicalGrid<Box>({.least_level = 1}), set, seed);
    expect_changes<RowColumnGrid<Box>, Box>(RowColumnGrid<Box>({.rows = 16}), set, seed);
    expect_changes<LooseCells<Box>, Box>(LooseCells<Box>({.world = world<Box>()}), set, seed);
    using Lists = BoxStore<Box, BoxScheme::sweep_lists>;
    const auto axis = static_cast<SweepAxis>(seed);
    expect_changes<Lists, Box>(Lists({.lists = 1 + static_cast<int>(seed), .first_axis = axis}), set, seed);
    ASSERT_FALSE(::testing::Test::HasFailure()) << name(set, seed);
  }
}

TEST(BoxGrids, GridsThatChangeTellThePairsOfBruteForce) {
  for (const Set set : all_sets) {
    expect_dynamic<Aabb2>(set);
    expect_dynamic<Aabb3>(set);
    ASSERT_FALSE(HasFailure());
  }
}

/// Of many boxes, in many parts.
TEST(BoxGrids, TellTheSamePairsOnAnyNumberOfThreads) {
  Entropy entropy(7160, 0);
  std::vector<Aabb3> boxes = boxes_of<Aabb3>(Set::random, battery::fitting(9000u), entropy);
  for (Aabb3& b : boxes) {
    b.max.x = b.min.x + (b.max.x - b.min.x) / 4, b.max.y = b.min.y + (b.max.y - b.min.y) / 4;
  }
  const StaticGrid3 grid(boxes);
  HierarchicalGrid3 levels;
  ImplicitGrid3 bits({.cell_size = grid.cell_size()});
  RowColumnGrid3 rows;
  HashedGrid3 hashed({.cell_size = grid.cell_size()});
  LooseOctree tree({.world = world<Aabb3>()});
  for (const Aabb3& b : boxes) levels.insert(b), bits.insert(b), rows.insert(b), hashed.insert(b), tree.insert(b);
  const std::vector<BoxPair> serial = grid.overlapping_pairs({.execution = Execution::serial});
  if (battery::reaches_rare) {
    EXPECT_GT(serial.size(), boxes.size() / 2);
  }
  EXPECT_EQ(sorted(by_number(levels.overlapping_pairs())), sorted(serial));
  EXPECT_EQ(sorted(by_number(hashed.overlapping_pairs())), sorted(serial));
  EXPECT_EQ(by_number(bits.overlapping_pairs()), sorted(serial));
  EXPECT_EQ(by_number(rows.overlapping_pairs()), sorted(serial));
  EXPECT_EQ(by_number(tree.overlapping_pairs()), sorted(serial));
  for (const std::size_t threads : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(grid.overlapping_pairs(), serial);
    EXPECT_EQ(levels.overlapping_pairs(), levels.overlapping_pairs({.execution = Execution::serial}));
  }
}

TEST(BoxGrids, OfNothing) {
  const StaticGrid3 none{std::span<const Aabb3>()};
  EXPECT_TRUE(none.overlapping_pairs().empty());
  EXPECT_TRUE(none.in_box({{0, 0, 0}, {1, 1, 1}}).empty());
  EXPECT_TRUE(HashedGrid2().overlapping_pairs().empty());
  EXPECT_TRUE(HierarchicalGrid2().in_box({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(RowColumnGrid2().overlapping_pairs().empty());
  EXPECT_TRUE(ImplicitGrid2().in_box({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(LooseQuadtree().overlapping_pairs().empty());
  EXPECT_EQ(choose_cell_size(std::span<const Aabb2>()).size, 1);
}

/// What throws names the mistake, and changes nothing.
TEST(BoxGrids, NameWhatIsWrongAndStayAsTheyWere) {
  const std::vector<Aabb2> boxes{{{0, 0}, {1, 1}}, {{0, 0}, {1e6, 1e6}}};
  EXPECT_THAT(text_of<InvalidShape>([&] { StaticGrid2(boxes, {.cell_size = 0}); }),
              HasSubstr("cell_size is not above zero"));
  EXPECT_THAT(text_of<NonFinite>([&] { StaticGrid2(boxes, {.cell_size = NAN}); }), HasSubstr("cell_size is nan"));
  EXPECT_THAT(text_of<Error>([&] { StaticGrid2(boxes, {.cell_size = 1e-3}); }), HasSubstr("choose larger cells"));
  EXPECT_THAT(text_of<Error>([&] { StaticGrid2(boxes, {.cell_size = 1e6, .most_memory = 9}); }),
              AllOf(HasSubstr("the grid would take "), HasSubstr(" bytes, but options.most_memory is 9;"),
                    Not(HasSubstr(".0"))));
  const std::vector<Aabb2> inverted{{{0, 0}, {1, 1}}, {{0, 2}, {1, 1}}}, infinite{{{0, 0}, {INFINITY, 1}}};
  EXPECT_THAT(text_of<InvalidShape>([&] { StaticGrid2{inverted}; }), HasSubstr("boxes[1] is empty"));
  EXPECT_THAT(text_of<NonFinite>([&] { StaticGrid2{infinite}; }), HasSubstr("boxes[0].max.x is inf"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)choose_cell_size(std::span(inverted)); }), HasSubstr("boxes[1]"));

  HashedGrid2 grid({.most_memory = 1 << 20});
  const BoxHandle first = grid.insert(boxes[0]);
  EXPECT_THAT(text_of<Error>([&] { grid.insert(boxes[1]); }), HasSubstr("options.most_memory is 1048576"));
  EXPECT_THAT(text_of<Error>([&] { grid.insert(boxes[1]); }),
              HasSubstr("HashedGrid::insert: the grid would take 24000048000120 bytes"));
  EXPECT_THAT(text_of<Error>([&] { grid.move(first, boxes[1]); }), HasSubstr("choose larger cells"));
  EXPECT_THAT(text_of<InvalidShape>([&] { grid.insert(inverted[1]); }), HasSubstr("box is empty"));
  EXPECT_THAT(text_of<NonFinite>([&] { grid.move(first, infinite[0]); }), HasSubstr("box.max.x is inf"));
  EXPECT_EQ(grid.size(), 1u);
  EXPECT_EQ(grid.box(first), boxes[0]);
  EXPECT_EQ(grid.in_box(boxes[1]), std::vector<BoxHandle>{first});
  EXPECT_TRUE(grid.in_box({{0.5, 0.75}, {0.75, 0.5}}).empty());
  EXPECT_TRUE(StaticGrid2(std::span(boxes).first(1)).in_box({{0.5, 0.75}, {0.75, 0.5}}).empty());
  EXPECT_THAT(text_of<NonFinite>([&] { (void)grid.in_box(infinite[0]); }), HasSubstr("in_box: box.max.x is inf"));
  EXPECT_THAT(text_of<InvalidShape>([] { HashedGrid2({.cell_size = 0}); }),
              HasSubstr("HashedGrid: cell_size is not above zero"));
  EXPECT_THAT(text_of<Error>([] {
                LinkedGrid2({.world = {{0, 0}, {1e9, 1e9}}});
              }),
              HasSubstr("LinkedGrid: the grid would take"));

  ImplicitGrid2 bits({.most_memory = 5000});
  for (int i = 0; i < 64; ++i) bits.insert(boxes[0]);
  EXPECT_THAT(text_of<Error>([&] { bits.insert(boxes[0]); }), HasSubstr("choose fewer rows"));
  EXPECT_EQ(bits.overlapping_pairs().size(), 64u * 63 / 2);
  EXPECT_THAT(text_of<InvalidShape>([] { ImplicitGrid2({.rows = 3}); }), HasSubstr("options.rows is 3"));
  EXPECT_THAT(text_of<InvalidShape>([] { RowColumnGrid2({.rows = 0}); }), HasSubstr("options.rows is 0"));
  EXPECT_THAT(text_of<InvalidShape>([] { HierarchicalGrid2({.least_level = 2000}); }),
              HasSubstr("least_level is 2000"));
  EXPECT_THAT(text_of<InvalidShape>([&] { LooseQuadtree({.world = inverted[1]}); }),
              HasSubstr("LooseOctree: world is empty"));
  EXPECT_THAT(text_of<InvalidShape>([] { SweepLists({.lists = 4}); }), HasSubstr("SweepLists: options.lists is 4"));
  EXPECT_THAT(text_of<InvalidShape>([] { SweepLists({.first_axis = SweepAxis::greatest_variance}); }),
              HasSubstr("nobody knows"));
  EXPECT_THAT(text_of<InvalidShape>([] {
                (void)LooseQuadtree().box({7, 0});
              }),
              HasSubstr("LooseOctree::box: handle (slot 7, generation 0) names no box"));
}

/// Any range of sizes: a level for each that there is, none for what has gone.
TEST(BoxGrids, HaveALevelForEachSize) {
  HierarchicalGrid3 grid;
  RowColumnGrid3 rows;
  std::vector<BoxHandle> handles;
  for (int e = -900; e <= 900; e += 100) {
    const double size = std::ldexp(1, e);
    handles.push_back(grid.insert({{0, 0, 0}, {size, size, size}}));
    rows.insert({{0, 0, 0}, {size, size, size}});
  }
  EXPECT_EQ(grid.parts(), handles.size());
  EXPECT_EQ(rows.parts(), handles.size());
  EXPECT_EQ(grid.overlapping_pairs().size(), handles.size() * (handles.size() - 1) / 2);
  for (const BoxHandle& h : handles) grid.remove(h), rows.remove(h);
  EXPECT_EQ(grid.parts(), 0u);
  EXPECT_EQ(rows.parts(), 0u);
}

/// A box across the middle of the world is in a small cell nevertheless.
TEST(BoxGrids, LooseTreesHaveSmallBoxesInSmallCells) {
  const space::LooseTree<Aabb3> tree({"test", {}}, {.world = {{-1, -1, -1}, {1, 1, 1}}});
  for (const double half : {0x1p-4, 0x1p-10, 0x1p-15}) {
    const auto place = tree.place_of({{-half, -half, -half}, {half, half, half}});
    const double side = std::ldexp(tree.frame().unit(), tree.level_of(place));
    EXPECT_LE(side, 2 * half);
    EXPECT_GE(side, half);
  }
}

TEST(ChooseCellSize, IsAPowerOfTwoOfTheBoxesSizes) {
  Entropy entropy(7170, 0);
  for (const Set set : all_sets) {
    const CellSize chosen = choose_cell_size(std::span<const Aabb3>(boxes_of<Aabb3>(set, 50, entropy)));
    EXPECT_EQ(std::ldexp(1, std::ilogb(chosen.size)), chosen.size) << static_cast<int>(set);
    EXPECT_LE(chosen.mean_extent, chosen.largest_extent);
  }
  const std::vector<Aabb2> same(9, Aabb2{{1, 1}, {4, 2}});
  EXPECT_EQ(choose_cell_size(std::span(same)).mean_extent, 3);
  EXPECT_EQ(choose_cell_size(std::span(same)).largest_extent, 3);
}

/// Bits against stamps, whatever was visited before.
TEST(VisitBits, AreASetThatIsEmptiedByEachQuery) {
  Entropy entropy(7171, 0);
  VisitBits bits(200);
  VisitStamps stamps(200);
  for (int query = 0; query < 2000; ++query) {
    for (auto visits = entropy.below(20); visits-- > 0;) {
      const auto i = static_cast<std::size_t>(entropy.below(200));
      ASSERT_EQ(bits.visited(i), stamps.visited(i)) << query;
      ASSERT_EQ(bits.visit(i), stamps.visit(i)) << query;
    }
    if (entropy.below(300) == 0) {
      bits.reset(200), stamps.reset(200);
    } else {
      bits.begin(), stamps.begin();
    }
  }
  EXPECT_EQ(VisitBits().size(), 0u);
}

}  // namespace
}  // namespace plumb
