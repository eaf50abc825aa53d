// How are the methods of the broad phase called on a command line?
//
// Law: each method that the program offers has one name here, and the table is all that the program knows of them.
// Source: none.
// Cost: none.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::tool {

struct NamedMethod {
  BroadPhaseMethod method;
  std::string_view name;
};

inline constexpr std::array broad_phase_methods{NamedMethod{BroadPhaseMethod::automatic, "automatic"},
                                                NamedMethod{BroadPhaseMethod::swept_columns, "swept-columns"},
                                                NamedMethod{BroadPhaseMethod::sort_and_sweep, "sort-and-sweep"},
                                                NamedMethod{BroadPhaseMethod::brute_force, "brute-force"}};

/// Of a name that is among them.
constexpr BroadPhaseMethod broad_phase_method(std::string_view name) {
  for (const NamedMethod& m : broad_phase_methods) {
    if (m.name == name) return m.method;
  }
  return BroadPhaseMethod::automatic;
}

}  // namespace plumb::tool
