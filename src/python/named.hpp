// Which value does a word stand for, where Python's users choose by a word?
//
// Source: none.
// Cost: none.
#pragma once

#include <array>
#include <utility>

#include "python/numbers.hpp"

namespace plumb::python {

/// Throws ValueError where it is none of the words, and names them: "weld: rule is 'x'; give 'clusters' or 'chains'".
template <class Value, std::size_t n>
Value named(const Asked& asked, const std::string& word, const std::pair<std::string_view, Value> (&words)[n]) {
  std::string text = std::string(asked.function).append(": ").append(asked.argument);
  text.append(" is '").append(word).append("'; give ");
  for (std::size_t k = 0; k < n; ++k) {
    if (word == words[k].first) return words[k].second;
    text.append(k == 0 ? "" : k + 1 == n ? " or " : ", ").append("'").append(words[k].first).append("'");
  }
  throw py::value_error(text);
}

}  // namespace plumb::python
