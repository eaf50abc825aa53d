// How is a text given to a caller in C?  Whole or not at all, with its length.
//
// Source: snprintf of C 1999.
// Cost: a copy.
#pragma once

#include <string>

#include "c/guarded.hpp"

namespace plumb::c {

/// With the ending 0, where the capacity is enough for all of it.
inline void write_text(const std::string& from, char* text, std::size_t capacity, std::size_t* length) {
  if (text != nullptr && from.size() < capacity) std::memcpy(text, from.c_str(), from.size() + 1);
  *length = from.size();
}

/// Before a question is asked whose answer is a text.
inline void need_text(const char* text, std::size_t capacity, const std::size_t* length) {
  need(text, capacity, "text");
  need(length, "length");
}

}  // namespace plumb::c
