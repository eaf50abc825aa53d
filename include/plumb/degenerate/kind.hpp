// What may a foreign function be asked, and when is its answer right?  A kind of question, as data.
//
// A case is one list of numbers: argument after argument, a count before each argument that may have any number of
// points or triangles.  An answer is a short list of numbers: the sign, 1 or 0 for yes or no, the number, the corners
// of triangles.
// The kinds there are: plumb/query/kinds/kinds.hpp.
// Laws: (1) exact answers are those of real arithmetic for all finite doubles, numbers the nearest double; (2) every
// generator's cases are valid, and the same choices make the same case; (3) judge rounds nothing: how far a number is
// from the nearest double of the exact one is asked exactly.
// Source: RTCD 11 (what goes wrong).
// Cost: an indirect call more than the question itself.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::degenerate {

using Numbers = std::vector<double>;

/// What an argument's numbers are, which says how they may become simpler.
enum class Role : unsigned char {
  points,   // each of `dimension` coordinates
  vector,   // a direction: no point of it moves along when the case is translated
  corners,  // the least and the largest corner of a box, in order
  frame,    // three perpendicular axes of length one, as well as doubles can
  extents,  // lengths, not negative
  soup,     // triangles, three indices each: of the points of the argument before
  surface,  // triangles that close: each edge, as a pair of places, is passed as often in either direction
};
constexpr bool names_points(Role role) { return role == Role::soup || role == Role::surface; }

struct Part {
  Role role;
  int dimension;
  std::size_t count = 1;  // of points, vectors, corners, axes; 1 for extents
};

/// One argument of the C function, in its order: its parts one after the other, or any number of points or triangles.
struct Argument {
  std::string name;
  std::vector<Part> parts;
  std::size_t least = 0;  // where there may be any number; the case then holds their count before them

  [[nodiscard]] bool any_number() const { return least > 0; }
};

struct Generator {
  std::string name, about;
  std::function<void(Numbers& numbers, Entropy& entropy)> make;  // replaces what `numbers` held
};

enum class Outcome : unsigned char { answered, threw, crashed, hung, exited };
constexpr std::string_view name_of(Outcome outcome) {
  constexpr std::array<std::string_view, 5> names = {"answered", "threw", "crashed", "hung", "exited"};
  return names[static_cast<std::size_t>(outcome)];
}

struct Answer {
  Answer() = default;
  Answer(double number) : numbers{number} {}  // NOLINT: a sign, a yes or no, a number is an answer
  explicit Answer(Outcome how, std::string what = {}) : outcome(how), note(std::move(what)) {}

  Outcome outcome = Outcome::answered;
  Numbers numbers;
  std::string note;  // of what did not answer: the exception's text, the signal
};

/// What the user allows of numbers; of decisions nothing is allowed.
struct Tolerance {
  std::uint64_t ulps = 0;  // as many doubles away from the nearest one
  double relative = 0;  // of the largest magnitude among the case's coordinates and lengths; of a hit, of its parameter
};

enum class Verdict : unsigned char { right, unsure, wrong, failed };

struct Judgment {
  Verdict verdict = Verdict::right;
  std::string_view sort;  // of the failure, such as "+ for 0": shrinking keeps it
};

using ForeignFunction = void (*)();

/// An argument as a C function takes it: its numbers, or indices, and how many points or triangles they are.
struct Passed {
  const double* numbers = nullptr;
  const std::size_t* indices = nullptr;
  std::size_t count = 0;
};

/// Where the bytes of an argument shall lie; nullptr: anywhere.
using Room = std::function<void*(std::size_t argument, std::size_t bytes)>;

/// What an answer's numbers are.
enum class AnswerForm : unsigned char {
  sign,       // of one number
  yes_no,     // 1 or 0
  number,     // one
  hit,        // 0, or 1 and the parameter; of a function that leaves the parameter alone, 1
  triangles,  // three indices of points each
};

/// Is the boundary part of a figure?  `any`: the function promises neither, and both answers are right.  Without it a
/// figure is its interior, as figure/basic/relation.hpp says it of overlapping: a segment without its ends, a flat box
/// without its rim.
enum class Boundary : unsigned char { in, out, any };
/// Are the ends of a segment, the origin of a ray, part of it?
enum class Ends : unsigned char { closed, open, any };

/// What users declare where functions differ; the kinds' own is the first of each.
struct Convention {
  Boundary boundary = Boundary::in;
  Ends ends = Ends::closed;
  friend bool operator==(const Convention&, const Convention&) = default;
};

using Exact = std::function<Answer(std::span<const double> numbers)>;

struct Kind {
  std::string name, question;
  std::string signature;   // in C, the function called f
  std::string convention;  // what its answer means
  AnswerForm form;
  std::vector<Argument> arguments;
  std::vector<Generator> generators;
  std::type_index type;  // of the signature: typeid(double(const double*, ...))
  Tolerance tolerance;   // the customary one

  /// Calls a function of that signature (`ask` below).
  Answer (*call)(ForeignFunction function, std::span<const Passed> arguments);
  Exact exact;
  /// For kinds with several right answers; none where the exact one alone is right.
  std::function<Judgment(std::span<const double> numbers, const Answer& given)> judge = {};

  /// Which conventions make a difference, and the exact answer under one without `any` (degenerate/convention.hpp).
  bool has_boundary = false, has_ends = false;
  std::function<Answer(std::span<const double> numbers, const Convention&)> exact_under = {};
  Convention declared = {};
  std::vector<Exact> also_right = {};  // beside `exact`, where a convention is `any`

  /// What counts as degenerate beside figures that are (is_degenerate), for who wants no such cases (Domain).
  std::function<bool(std::span<const double> numbers)> special = {};
};

/// Asks a function of the kind's signature, each argument where `room` says.  What it throws passes through.
Answer ask(const Kind& kind, ForeignFunction function, std::span<const double> numbers, const Room& room = {});

/// Is the answer right?
Judgment judge(const Kind& kind, std::span<const double> numbers, const Answer& given, const Tolerance& tolerance);

/// An answer in words: "+", "yes", "0.5", "12 triangles", "crashed (SIGSEGV)".
std::string words(const Kind& kind, const Answer& answer);

/// Whether the numbers are a case of the kind: as many as the arguments take, finite, boxes and lengths in order,
/// triangles of points that there are, surfaces closed.  What is wrong otherwise, in words; empty for a case.
std::string flaw_of(const Kind& kind, std::span<const double> numbers);

/// Whether one of a case's figures is less than figures of its sort are: a triangle on a line, a ray without direction,
/// a flat box, a surface of triangles that cancel or lie in one plane.
bool is_degenerate(const Kind& kind, std::span<const double> numbers);

}  // namespace plumb::degenerate
