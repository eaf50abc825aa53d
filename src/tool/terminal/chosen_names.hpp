// Which of the known names were asked for?  None given means all; an unknown one is refused with what there is.
//
// Source: none.
// Cost: linear.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

bool is_chosen(const std::vector<std::string>& asked, const std::string& name);

/// Throws Error, one line: "chart: there is no task orient4d; there are orient2d, ...".
void require_known(std::string_view command, std::string_view what, const std::vector<std::string>& asked,
                   const std::vector<std::string>& known);

}  // namespace plumb::tool
