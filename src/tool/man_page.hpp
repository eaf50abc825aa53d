// How does --help look?  Like a manual page: name, synopsis, description, options, exit status, examples.
//
// Law: every option that the parser knows is on its command's page: program.cpp takes them from the parser itself, so
// that the page cannot fall behind; the rest of the text stands in help_text.hpp.
// Source: man-pages(7); cost: none worth a word.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "terminal.hpp"

namespace plumb::tool {

struct Section {
  std::string_view title;
  std::string text;  // lines of at most 73 characters; a leading line break is passed over
};

struct Manual {
  std::string_view name, purpose;  // "plumb sign", "decide one sign exactly"
  std::vector<std::string_view> synopsis;
  std::vector<Section> before_options, after_options;
};

struct ShownOption {
  std::vector<std::string> names;  // "-h", "--help"; "MESH"
  std::string value, description;  // "FILE", or nothing
};

std::string manual_page(const Manual& manual, std::span<const ShownOption> options, const Style& style);

}  // namespace plumb::tool
