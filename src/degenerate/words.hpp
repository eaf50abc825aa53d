// How is a double written for people?  The shortest decimal that reads back as the same double.
#pragma once

#include <string>

namespace plumb::degenerate {

std::string decimal(double x);

}  // namespace plumb::degenerate
