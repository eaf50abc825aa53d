// Which of the known words was probably meant by one that is not known?
//
// Law: one that is a single letter or swap of two neighbors away, else the first that the word begins, else the nearest
// by such changes, at most one for every three letters; the earliest of equally near ones.
// Source: optimal string alignment (Damerau 1964).
// Cost: the product of the lengths for each known word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

/// Nothing where none is near.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// " (did you mean check?)", or nothing.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace plumb::tool
