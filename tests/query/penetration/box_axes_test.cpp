// The least of fifteen axes: which bounds were derived, and does a machine confirm them?
#include "query/penetration/box_axes.hpp"

#include <gtest/gtest.h>

#include "certify/golden_statements.hpp"
#include "certify/proved_statements.hpp"
#include "plumb/certify/judged_proofs.hpp"

namespace plumb::query::parting {
namespace {

TEST(LeastBoxAxis, DerivedBoundsAreAsRecordedAndProved) {
  // Deep in one another but for a face of the first, which is nearly met: its normal, of axes 0 and 1, is the least.
  const GivenBox::Ends ten{-5, 5}, one{-0.5, 0.5};
  const GivenBox a{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {ten, ten, one}, {{{-1, 1}, {-1, 1}, {-1, 1}}}};
  const GivenBox b{{{{0.75, 0.5, 0.25}, {-0.5, 0.75, 0.125}, {-0.25, 0.125, 0.75}}},
                   {one, one, one},
                   {{{-1, 1.5}, {-1, 1.25}, {-1, 2}}}};
  const auto bounds = judged_bounds(IsLeastAxis{}, a, b, 0U, 1U);
  FloatWorld<IsLeastAxis> world;
  EXPECT_TRUE(IsLeastAxis{}(world, a, b, 0U, 1U).is_least && world.certain());
  expect_golden("least_box_axis", bounds);
  expect_proved(bounds, judged_proofs("least_box_axis", IsLeastAxis{}, a, b, 0U, 1U));
}

}  // namespace
}  // namespace plumb::query::parting
