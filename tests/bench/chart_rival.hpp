// Who else answers the tasks of `plumb chart`?  CGAL's kernels, as methods.
//
// The program plumb-bench is plumb with these; it is not installed.
#pragma once

#include <vector>

#include "tool/trial/task.hpp"

namespace plumb::bench {

std::vector<tool::trial::Rival> chart_rivals();

}  // namespace plumb::bench
