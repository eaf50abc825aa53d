// `plumb sign`: what is the exact sign, and which stage decided it?
//
// Prints one line a case: the sign '+', '0' or '-' and the stage.  A case that states its expected sign ("... = +") and
// does not have it is reported.
// Laws: (1) a case given as arguments and as a line of standard input has the same answer; (2) a bad case throws Error,
// naming the line of standard input; (3) exit code 1 when an expected sign was not met, else 0.
// Source: RTCD 3.1.6.
// Cost: that of reading the numbers.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace plumb::tool {

/// The words of one case; without words the cases are read from `lines`.
int run_sign(const std::vector<std::string>& words, std::istream& lines);

}  // namespace plumb::tool
