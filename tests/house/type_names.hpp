// Does each name of a namespace mean one type?  Two types of one name are one to the linker, which keeps the functions of
// either; no compiler sees both.
//
// Laws: what a namespace without a name holds is the room's, whose files are compiled as one.  An alias may be written
// again; a type may not, nor an alias beside a type.  What a preprocessor chooses is not looked at, nor what is nested.
// Cost: reads every source file of the libraries and programs once.
#pragma once

#include "house/rules.hpp"

namespace plumb::house {

std::vector<Breach> types_named_twice(const std::filesystem::path& tree);

}  // namespace plumb::house
