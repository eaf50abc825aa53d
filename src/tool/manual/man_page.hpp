// How does --help look?  Like a manual page: name, synopsis, description, options, exit status, examples; and the same
// for man(1).
//
// Laws: (1) every option that the parser knows is on its command's page: parsed_options.hpp takes them from the parser
// itself, so that the page cannot fall behind; the rest of the text stands in help_text.hpp; (2) what man shows has the
// same words; lines that are no table may flow.
// Source: man-pages(7).
// Cost: none worth a word.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct ManualSection {
  std::string_view title;
  std::string text;  // lines of at most 73 characters; a leading line break is passed over
};

struct Manual {
  std::string_view name, purpose;  // "plumb sign", "decide one sign exactly"
  std::vector<std::string_view> synopsis;
  std::vector<ManualSection> before_options, after_options;
};

struct ShownOption {
  std::vector<std::string> names;      // "-h", "--help"; "MESH"
  std::string value, description;      // "FILE", or nothing
  std::vector<std::string> choices{};  // for the shells: what the value may be, where that is known
  bool repeats = false;
  bool value_optional = false;

  /// " FILE", " [FILE]", or nothing: what stands behind the names.
  [[nodiscard]] std::string shown_value() const;
};

std::string manual_page(const Manual& manual, std::span<const ShownOption> options, const Style& style);

/// The page as troff's source, for man(1).
std::string roff_page(const Manual& manual, std::span<const ShownOption> options, std::string_view version,
                      std::span<const std::string> see_also);

}  // namespace plumb::tool
