#include "query/body/weighted_pose.hpp"

namespace plumb::query {

PLUMB_ALL_LINKS()

}  // namespace plumb::query
