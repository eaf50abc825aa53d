// How is a failing case handed on?  As one line, as a C++ test, as a script of Python's and as OBJ.
//
// The line is that of certify/case_line.hpp, for every kind: its name, the numbers in hexadecimal, '=' and the exact
// answer in words.
// Laws: (1) parse_case(kind, line) gives back the numbers, bit for bit; (2) what is pasted holds the same doubles in
// hexadecimal, and beside them in decimal (17 digits).  (3) OBJ holds decimals, which its readers take; coordinates
// beyond its readers' floats are written all the same, corners beyond the doubles at the largest, and the plane's
// points have z = 0.
// Source: RTCD 11.
// Cost: none that counts.
#pragma once

#include "plumb/degenerate/check.hpp"

namespace plumb::degenerate {

/// "orient3d 0x0p+0 ... = +"
std::string case_line(const Kind& kind, std::span<const double> numbers);

/// Nothing for blank lines, comments and cases of other kinds.  Throws Error, which says what is no case and why.  An
/// answer may be missing; one that is there is of the kind's form, but need not be right: conventions differ.
std::optional<Numbers> parse_case(const Kind& kind, std::string_view line);

/// Argument by argument: "a = (0.1, 2, 3)", decimals that read back.
std::string decimal_text(const Kind& kind, std::span<const double> numbers);

/// A GoogleTest that asks `function`, whose signature is the kind's, and expects the exact answer.
std::string cpp_text(const Kind& kind, std::span<const double> numbers, std::string_view function);

struct PythonOptions {
  std::string library = {};  // a path; empty: "lib<function>.so".  The script takes another as its argument
  double timeout = 1;        // seconds that the call may take
  std::optional<Tolerance> tolerance = {};  // nothing: the kind's
};

/// A script that runs by itself, on Python 3 and its standard library: it loads the library, asks `function` in a
/// process of its own, each argument at the end of readable memory, and exits with 0 where the answer is right, with 1
/// where it is wrong or none comes, with 2 where there is no such function.
std::string python_text(const Kind& kind, std::span<const double> numbers, std::string_view function,
                        const PythonOptions& options = {});

/// Points, edges and faces of the figures, to look at.
std::string obj_text(const Kind& kind, std::span<const double> numbers);

/// All findings in words: shares by generator, then each smallest case with its line.
std::string text(const Kind& kind, const Findings& findings);

}  // namespace plumb::degenerate
