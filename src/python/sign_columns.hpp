// Where do the numbers of each item stand?  Items of several arrays are broadcast against one another, and stand as columns.
//
// Laws: (1) axes before the last ones broadcast as NumPy's do: aligned at their ends, an axis of length 1 repeats.
//       (2) Axes that follow one another in memory, in all arguments, become one run of items.  (3) Where runs would be
//       short, the arguments are laid out anew once, so that there is one.
// Source: NumPy's broadcasting rules.
// Cost: none but the layout of (3).
#pragma once

#include <vector>

#include "python/sign_question.hpp"

namespace plumb::python {

/// An argument as it came, `own` of its axes at the end being one item's.
struct GivenNumbers {
  py::array array;
  std::size_t own;
};

struct SignColumns {
  std::vector<py::ssize_t> shape;                 // of the answer
  std::size_t run = 1;                            // items that columns reach
  std::vector<py::ssize_t> outer;                 // lengths of the axes over runs
  std::vector<certify::batch::Column> columns;    // of the first run
  std::vector<std::vector<py::ssize_t>> strides;  // of each column over the outer axes, in numbers

  [[nodiscard]] std::size_t runs() const;
  /// The columns of run r.
  [[nodiscard]] std::vector<certify::batch::Column> of_run(std::size_t r) const;
};

/// May keep arrays that it lays out in `given`.
SignColumns columns_of(std::vector<GivenNumbers>& given, const SignQuestion& question, const SignForm& form);

}  // namespace plumb::python
