// Which names mean something else where a case is pasted?  Keywords of C and C++, and what scripts of Python use.
//
// Source: ISO C 6.4.1, ISO C++ 5.11; The Python Language Reference 2.3.1; cost: a search in a short list.
#pragma once

#include <string_view>

namespace plumb::degenerate {

bool is_keyword_of_c_or_cpp(std::string_view name);

/// Keywords of Python that are none of C or C++, and what a script of paste_python.cpp calls by name.
bool is_taken_in_python(std::string_view name);

}  // namespace plumb::degenerate
