// How does a C function fail?  By a status and a text, whatever was thrown below it.
//
// Laws: nothing is thrown past guarded().  What is written through pointers is written last, so that nothing is if it fails.
// Source: none.
// Cost: none where nothing fails.
#pragma once

#include <concepts>
#include <cstring>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/plumb.h"

namespace plumb::c {

/// An argument that no C++ caller could give: a null pointer, a size from the future.
struct InvalidArgument : Error {
  using Error::Error;
};

/// The status of what is being handled, whose text it keeps for plumb_last_error.
plumb_status status_of_current_exception(const char* function) noexcept;

template <std::invocable Work>
plumb_status guarded(const char* function, const Work& work) noexcept {
  try {
    work();
    return PLUMB_OK;
  } catch (...) {
    return status_of_current_exception(function);
  }
}

/// Throws InvalidArgument that names the argument where it is NULL.
inline void need(const void* pointer, const char* argument) {
  if (pointer == nullptr) throw InvalidArgument(std::string(argument) + " is NULL");
}
/// An array may be NULL where it is empty.
inline void need(const void* array, std::size_t count, const char* argument) {
  if (count != 0) need(array, argument);
}

/// A choice comes as an int, and is one of those from 0 to the last.
inline void need_choice(int given, int last, const char* argument) {
  if (given >= 0 && given <= last) return;
  throw InvalidArgument(std::string(argument) + " " + std::to_string(given) + " is none of 0 to " +
                        std::to_string(last));
}

/// Is the size that a caller says one that this version knows?
template <class Struct>
void need_size(const Struct* given, const char* argument) {
  need(given, argument);
  if (given->size == sizeof(Struct)) return;
  throw InvalidArgument(std::string(argument) + "->size is " + std::to_string(given->size) +
                        ", but this version of Plumb knows " + std::to_string(sizeof(Struct)) +
                        ": set it to sizeof, and use a library as new as the header");
}

template <class Struct>
void write(Struct* to, Struct answer) {
  answer.size = to->size;
  *to = answer;
}

template <std::size_t n, class Point>
void copy(double (&to)[n], const Point& from) {
  static_assert(sizeof(to) == sizeof(from));
  std::memcpy(&to, &from, sizeof(to));
}

}  // namespace plumb::c
