// Where do the numbers of a case stand?  The parts of its arguments, one after the other.
//
// Law: of a case without a flaw every number is in one field, or is the count before one.
// Cost: linear in the fields.
#pragma once

#include <span>
#include <vector>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

struct Field {
  Role role;
  std::size_t argument, dimension, first, count;  // dimension * count numbers from `first`

  [[nodiscard]] std::size_t size() const { return dimension * count; }
};

/// Numbers of an argument; of one that may have any number of points or triangles, of each.
std::size_t numbers_in(const Argument& argument);

std::vector<Field> fields_of(const Kind& kind, std::span<const double> numbers);

/// All but frames and indices: those that a scaling multiplies.
std::vector<Field> lengths_of(const Kind& kind, std::span<const double> numbers);

/// All numbers of one argument, without the count.
struct Given {
  const Argument& argument;
  std::span<const double> numbers;
  std::size_t count;  // of points or triangles, where there may be any number
};
std::vector<Given> given(const Kind& kind, std::span<const double> numbers);

/// What a figure spans, and what such figures span unless they are degenerate: triangles, directions, boxes, polygons,
/// surfaces; of a soup the least of its triangles.  Single points and sets of any number of points are never
/// degenerate.
struct Span {
  int dimension, most;
};
std::vector<Span> spans_of(const Kind& kind, std::span<const double> numbers);

/// Corners in order, lengths not negative, indices those of points that there are.
void put_in_order(const Kind& kind, std::span<double> numbers);

/// One to three small moves, some of which keep what is exactly so: a case that may have any number of points or
/// triangles may have one more or less.  What would open a surface is not done.
void mutate(const Kind& kind, Numbers& numbers, Entropy& entropy);

/// Names a case: the same numbers have the same.
std::uint64_t fingerprint(std::span<const double> numbers);

/// The coordinates of all points one after the other, and back.
Numbers gathered(std::span<const double> numbers, std::span<const Field> fields);
void scatter(std::span<const double> coordinates, std::span<const Field> fields, std::span<double> numbers);

}  // namespace plumb::degenerate
