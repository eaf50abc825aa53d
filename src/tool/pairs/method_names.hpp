// How are the methods of the broad phase called on a command line?  As the library names them, with hyphens.
//
// Law: each of broad_phase_methods has one name.
// Source: none.
// Cost: none.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::tool {

inline std::string command_name(BroadPhaseMethod method) {
  std::string name(name_of(method));
  std::ranges::replace(name, '_', '-');
  return name;
}

/// Of a name that is among them.
inline BroadPhaseMethod broad_phase_method(std::string_view name) {
  return *std::ranges::find(broad_phase_methods, name, command_name);
}

}  // namespace plumb::tool
