#include "certify/agreement/agreement.hpp"

namespace plumb::battery {

INSTANTIATE_TEST_SUITE_P(All, Agreement, testing::ValuesIn(parameters_of(Shard::far)), name_of_test);

}  // namespace plumb::battery
