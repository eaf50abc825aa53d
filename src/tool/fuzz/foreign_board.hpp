// Where do the program and the child that calls the foreign code meet?  A piece of memory that both map.
//
// The program writes the cases of a batch, the child the answers, and before each call the child writes which case it
// is: so a crash is laid at the right door.  Foreign code may scribble over all of it: the program keeps the cases it
// wrote, and takes nothing that it reads here for true without a look.
// Laws: (1) what the child writes is read after the child has said that it is done, or is dead; (2) no answer read lies
// outside of the board.
// Source: none.
// Cost: 12 MiB of address space, of which the pages used are real.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace plumb::tool {

struct ForeignBoard {
  static constexpr std::size_t most_cases = 4096, most_numbers = 1 << 19, most_answers = 1 << 20;
  static constexpr std::uint64_t no_case = ~0ull;

  enum class State : std::uint32_t { loading, refused, serving };
  enum class Ended : std::uint8_t { pending, answered, threw };

  std::atomic<State> state;
  std::atomic<std::uint64_t> at;  // the case that is being asked
  std::array<char, 2048> text;    // why the library was refused, or what the last exception said

  std::uint64_t cases;
  std::array<std::uint32_t, most_cases + 1> begin;       // of each case in `numbers`
  std::array<std::uint32_t, most_cases + 1> answer_end;  // of each case in `answers`
  std::array<Ended, most_cases> ended;
  std::array<double, most_numbers> numbers;
  std::array<double, most_answers> answers;
};

}  // namespace plumb::tool
