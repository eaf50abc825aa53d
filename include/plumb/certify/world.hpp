// Adaptive precision: what is the answer to a question of many signs, for certain?  A decision is stated once, and asked
// of one world of numbers after another.
//
//   const bool sees = certainly(ConeSeesBox{}, cone, box);                  // docs/add_a_decision.md
//
// A statement is a function object over a world `w` and its input.  The world makes numbers of what is given
// (`w.difference(a, b)`, `w.number(a)`), they are computed with (+ - *, magnitude, larger, smaller, twice, select), and
// the world judges them (`w.sign(x)`, `w.compare(x, y)`).  The statement branches on what was judged alone.
// Laws: (1) the answer is that of the last world, which is exact, whoever gives it.  (2) An answer counts only where its
// world is certain of each sign that was judged, so it must depend on the input and on those alone; until then a sign
// may be anything, so that a statement must end whatever the signs are.
// A number that is NaN or infinite throws NonFinite, as far as the statement looks at it.
// Source: docs/proof.md, "Tracked errors".
// Cost: as a rule that of plain doubles; a few times as much in pairs; microseconds where rationals answer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "plumb/arith/sign.hpp"
#include "plumb/arith/track.hpp"

namespace plumb {

enum class WorldKind : std::uint8_t { floats, pairs, integers, rationals };

inline constexpr std::array<std::string_view, 4> world_names{"floats", "pairs", "integers", "rationals"};

constexpr std::string_view to_string(WorldKind w) { return world_names[static_cast<std::size_t>(w)]; }

/// What the numbers of the world of doubles are: doubles; doubles of which it is known on which lattice they lie, so that
/// those that are off by less than its unit are not off; pairs of doubles, on a lattice as well.
enum class Precision : std::uint8_t { doubles, lattice, pairs };

/// The number of [0, 1] that a guess is taken for.
constexpr double portion_of(double t) { return t > 0 ? (t < 1 ? t : 1) : 0; }

/// Is told the tracks of what doubles judge (certify/judged_bounds.hpp).  This one does nothing and costs nothing.
struct NoBoundListener {
  static constexpr void judged(const Track&) {}
};

/// Recorder policy: is told which world answered.  This one does nothing and costs nothing.
struct NoWorldRecorder {
  static constexpr void answered(WorldKind) {}
};

/// Recorder policy that counts; not synchronized: one for each thread, added up at the end.
struct WorldCounts {
  std::array<std::uint64_t, world_names.size()> count{};

  constexpr void answered(WorldKind w) { ++count[static_cast<std::size_t>(w)]; }
  [[nodiscard]] constexpr std::uint64_t of(WorldKind w) const { return count[static_cast<std::size_t>(w)]; }
  /// The last of the worlds that answered.
  [[nodiscard]] constexpr WorldKind last() const {
    std::size_t w = 0;
    for (std::size_t i = 0; i < count.size(); ++i) w = count[i] != 0 ? i : w;
    return static_cast<WorldKind>(w);
  }
  [[nodiscard]] constexpr std::uint64_t total() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t c : count) sum += c;
    return sum;
  }
};

}  // namespace plumb
