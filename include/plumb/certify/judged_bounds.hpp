// What was derived from my statement?  The bound of each number that it judged, in words.
//
//   for (const std::string& line : judged_bounds(IsBeyond{}, p, q, r, s)) std::puts(line.c_str());
//
// A line is the constant that the code multiplies, and the powers of the scales that it multiplies it by: "0x1.8p-52 s0^2
// s1".  A scale of which there is a number for each axis has the powers of its own axis, the next and the one after,
// "s0(1,1,0)"; a sum of two such products has a plus between them.
// Laws: the lines are those of what the statement judges on this input, each once, in order; they depend on nothing else.
// Source: docs/proof.md, "Tracked errors".
// Cost: microseconds.
#pragma once

#include <string>
#include <vector>

#include "plumb/certify/certainly.hpp"

namespace plumb {

/// One line as above.
std::string to_string(const Track& track);

/// Keeps what is judged in this thread.
struct BoundListener {
  static void judged(const Track& track);
  /// What was judged since this was asked last.
  static std::vector<std::string> taken();
};

/// Of what the statement judges on this input, over doubles.
template <class Statement, class... Input>
std::vector<std::string> judged_bounds(const Statement& statement, const Input&... input) {
  certify::one_lane::Floats<double, highest_power<Statement>, scales_of<Statement>, BoundListener> world;
  BoundListener::taken();
  static_cast<void>(statement(world, input...));
  return BoundListener::taken();
}

}  // namespace plumb
