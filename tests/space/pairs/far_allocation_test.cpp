// Is a moved mesh that is far from another one asked about its whole box alone?  Then no memory is taken, whatever its size.
#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

TEST(PosedPairsAllocations, NoneOfMeshesFarApart) {
  Pose turned{{{{0.8, 0.6, 0}, {-0.36, 0.48, 0.8}, {0.48, -0.64, 0.6}}}, {0.1, 0.2, 0.3}};
  Pose away = turned;
  away.translation.x += 15;
  for (const std::uint32_t n : {3u, 30u}) {
    const Bvh bvh = build_bvh(meshes::ring(n));
    const CompactBvh small = compact(bvh);
    const PairOptions serial{.execution = Execution::serial};
    const int before = allocations;
    EXPECT_FALSE(any_intersecting_pair({bvh, turned}, {bvh, away}, serial).has_value());
    EXPECT_FALSE(any_intersecting_pair({small, turned}, {small, away}, serial).has_value());
    EXPECT_EQ(allocations, before) << n;
    EXPECT_TRUE(any_intersecting_pair({bvh, turned}, bvh, serial).has_value());
    EXPECT_GT(allocations, before);
  }
}

}  // namespace
}  // namespace plumb
