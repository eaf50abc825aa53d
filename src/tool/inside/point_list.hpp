// Which points are asked about?  Those of words, and of a file that has one a line.
//
//   0.5,0.5,0.5          on a line of its own; blanks may stand for the commas
//
// Laws: (1) empty lines, and what follows '#', are passed over.  (2) A decimal stands for its nearest double, and it is
// told whether that is it.  (3) Other words throw Error, which quotes them and names the file's line.
// Source: none.
// Cost: that of reading the decimals.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::tool {

struct NamedPoint {
  std::string name;  // as given
  Point3 point;
  bool exact;  // no decimal of it was moved
};

/// "0.5,0.5,0.5"; `what` names it in errors.
NamedPoint read_point(const std::string& words, const std::string& what);

/// `name` is the file's in errors.
std::vector<NamedPoint> read_points(std::istream& lines, const std::string& name);

/// Of the file, or of standard input for "-"; throws Error where it cannot be read.
std::vector<NamedPoint> read_points(const std::string& file);

}  // namespace plumb::tool
