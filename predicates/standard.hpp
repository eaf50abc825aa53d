// Is this compiled as C++20?  Older standards are refused in one sentence, instead of thousands of lines.
//
// Every header that includes nothing else of ours includes this one, so that whichever is included first meets it before
// it says anything.  The sentence is the name of a file that there is not, because compilers end where a file is missing
// and go on after #error.
// Cost: none.
#pragma once

#if __cplusplus <= 201703L
#include <plumb needs C++20: compile with -std=c++20, or in CMake with cxx_std_20>
#endif
