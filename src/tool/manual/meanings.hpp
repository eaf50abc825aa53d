// What does the sign of each predicate mean?  One sentence each, for the help and for docs/predicates.md.
//
// Law: every predicate of the catalog has one; tests/tool/predicate_table_test.cpp looks.
// Cost: none.
#pragma once

#include <string_view>

namespace plumb::tool {

/// Empty for a name that is no predicate.
std::string_view meaning_of(std::string_view predicate);

}  // namespace plumb::tool
