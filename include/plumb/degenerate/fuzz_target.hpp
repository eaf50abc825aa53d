// How do libFuzzer and AFL++ test a geometric function?  Bytes that stand for cases, and what is done with one.
//
//   extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
//     static const auto& kind = plumb::degenerate::kind_named("orient3d");
//     return plumb::degenerate::fuzz_target(kind, my_orient3d, {data, size});
//   }
//
// Bytes: the first is even, and the rest are the numbers as they lie in memory, a count as one byte before them, an
// index as two, the lower first; or it is odd, the next names a generator of the kind, and the rest are its choices.
// What is missing is 0.
// Laws: (1) the same bytes are the same case on every machine of the same byte order; (2) numbers_from(kind,
// bytes_of(kind, numbers)) are the numbers, if they are a case with at most 255 points or triangles more than the
// least; (3) a wrong answer is told with the case as a line, in decimals and as a C++ test, and the program aborts.
// What a function throws passes through.
// Source: RTCD 11.
// Cost: that of the exact answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/degenerate/check.hpp"

namespace plumb::degenerate {

using Bytes = std::span<const std::uint8_t>;

/// The case that bytes stand for; nothing where the numbers are none.
std::optional<Numbers> numbers_from(const Kind& kind, Bytes bytes);

/// Bytes that stand for these numbers.
std::vector<std::uint8_t> bytes_of(const Kind& kind, std::span<const double> numbers);

/// Returns 0, or writes what is wrong to the standard error and aborts.
int fuzz_target(const Kind& kind, const Callable& function, Bytes bytes, std::optional<Tolerance> tolerance = {});

/// For a pointer to a function of the kind's C signature; throws Error naming the signature where it has another.
template <class R, class... A>
requires(!std::is_same_v<R, Answer>)  //
    int fuzz_target(const Kind& kind, R (*function)(A...), Bytes bytes, std::optional<Tolerance> tolerance = {}) {
  return fuzz_target(kind, callable_of(kind, function), bytes, tolerance);
}

/// Hands the bytes of each file named, or of the standard input, to the target.  Returns 2 where one cannot be read.
int fuzz_files(int argc, char** argv, int (*target)(const std::uint8_t* data, std::size_t size));

/// Seeds of a corpus: `each` cases of each generator, as their numbers, so that fuzzers can splice them.
std::vector<std::vector<std::uint8_t>> fuzz_seeds(const Kind& kind, std::size_t each, std::uint64_t seed = 2026);

/// Writes them into a folder, which is made, a file each; throws Error naming the file that cannot be written.
void write_fuzz_seeds(const Kind& kind, const std::string& folder, std::size_t each = 3, std::uint64_t seed = 2026);

/// A dictionary for -dict= of libFuzzer and -x of AFL++: doubles that are hard on geometry, as they lie in memory.
std::string fuzz_dictionary();

}  // namespace plumb::degenerate
