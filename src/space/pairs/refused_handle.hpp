// What is said of a handle that names no box?
#pragma once

#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb::space {

inline std::string text_of_handle(const BoxHandle& h) {
  return "(slot " + std::to_string(h.slot) + ", generation " + std::to_string(h.generation) + ")";
}
[[noreturn]] inline void refuse_handle(std::string_view function, std::string_view name, const BoxHandle& h,
                                       bool was_given) {
  throw InvalidShape(std::string(function) + ": " + std::string(name) + " " + text_of_handle(h) +
                     (was_given ? " was removed" : " names no box that was inserted"));
}

}  // namespace plumb::space
