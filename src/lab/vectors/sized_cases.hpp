// Test vectors of questions about any number of points: one file a kind, with cases of every generator that it has.
//
//   hull-of-any-size 4 ...
//
// Laws: (1) the same files on every machine, from the seed alone; (2) a count stands before the points or triangles that it
// counts, and is a number like the others; (3) answers are computed in rationals, by ways that share nothing with the
// library's; (4) of each generator there are its first two cases, and the first of each answer among those that are looked at.
// Source: query/kinds/kinds.hpp.
// Cost: some seconds, for the judges.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/degenerate/kind.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::lab {

/// What is asked of any number of points, and in which form the file answers.
struct SizedTask {
  std::string_view kind;  // of query/kinds/kinds.hpp
  std::string_view question;
  std::string_view numbers;  // in words
  std::string_view answer;   // in words
  std::string (*judge)(const degenerate::Kind& kind, std::span<const double> numbers);
};
std::span<const SizedTask> sized_tasks();

/// "hull-of-any-size": the first word of its lines, and without ".txt" its file.
std::string sized_name(const SizedTask& task);

std::vector<NamedText> sized_files(std::uint64_t seed);

}  // namespace plumb::lab
