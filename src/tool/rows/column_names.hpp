// Do the columns of a table stand where rows of numbers are read from?  A header says.
//
// Laws: (1) where it has one of the names of a row's numbers, it has all of them and no others, in their order: a table
// of id, x and y holds no points in space, and one of y and x none in the plane.  (2) A header of other names is passed
// over, as it says nothing.
// Names are compared without case, blanks, quotes and the order of letters: "min x" is "Min_X" and "xmin".
// Source: RFC 4180.
// Cost: that of a line.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

/// `names` are those of the numbers of a row; throws Error, which names the columns that there are and that are wanted.
void require_column_names(std::string_view header, std::span<const std::string_view> names, const std::string& place);

/// Are these the header's, all of them in this order?
bool are_column_names(std::string_view header, const std::vector<std::string_view>& names);

}  // namespace plumb::tool
