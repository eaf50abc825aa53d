// In which words are reports expected?  Those of JSON and of Google's matchers that tests of the program use most.
#pragma once

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace plumb::tool {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

}  // namespace plumb::tool
