// Which points are asked about?  Those of words, and of a file that has one a line.
//
//   0.5,0.5,0.5          on a line of its own; blanks may stand for the commas
//
// Laws: those of tool/rows/decimal_rows.hpp: what is passed over, and what is refused with its line;
// and of tool/rows/packed_rows.hpp.
// Source: none.
// Cost: that of reading the decimals.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::tool {

struct NamedPoint {
  std::string name;  // as given
  Point3 point;
  bool exact;  // no decimal of it was moved
};

/// "0.5,0.5,0.5"; `what` names it in errors.
NamedPoint read_point(const std::string& words, const std::string& what);

/// `name` is the text's in errors.
std::vector<NamedPoint> parse_points(std::string_view text, const std::string& name);

/// Of the file, or of standard input for "-"; throws Error where it cannot be read.
std::vector<NamedPoint> read_points(const std::string& file, const ReadOptions& reading);

}  // namespace plumb::tool
