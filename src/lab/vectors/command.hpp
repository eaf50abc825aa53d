// `plumb-lab vectors`: which cases should everybody's geometry be tried on?  Inputs, exact answers, and who gets them
// wrong.
//
// One text file a task of tool/trial, in it some cases of each input class, of its shapes in each special position
// (degenerate/shape_pair.hpp), and of each generator of the kind of the same name (query/kinds/kinds.hpp) that has as many
// numbers: one line a case, in the form of certify/case_line.hpp,
//
//   ray-triangle 0x1p+0 0x0p+0 ... = yes # touching; wrong: float32 absolute
//
// with the task's name, its numbers, '=' and the answer: + 0 - for signs, yes or no, a number, or the corners' numbers.
// Laws: (1) the same files on every machine and at every time, from the seed alone; (2) answers are the judge's, in
// rationals; (3) marked are the methods of `plumb-lab chart` that answer otherwise: a number counts as wrong when fewer
// than some 20 of its bits are right; (4) of each class there are its first cases, the first of each answer, and the
// first that each of the marked methods gets wrong, as far as there are any.
// Source: RTCD 11.2.
// Cost: some seconds, for the judges.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/trial/tasks.hpp"
#include "tool/manual/command.hpp"
#include "tool/terminal/write_folder.hpp"

namespace plumb::lab {

/// The usual floating-point code, by the names of `plumb-lab chart`.
inline constexpr std::array<std::string_view, 4> marked_methods{"float32", "double", "absolute", "relative"};

struct VectorsOptions {
  std::string out;
  std::uint64_t seed = 2026;
};

int run_vectors(const VectorsOptions& options);

/// Those of the report, and a ray against a mesh.
std::vector<trial::Task> vector_tasks();

/// All files, or those of this task, each named as its task.
std::vector<NamedText> vector_files(std::uint64_t seed, std::string_view only = {});

Command vectors_command(CLI::App& program);
Manual vectors_manual();

}  // namespace plumb::lab
