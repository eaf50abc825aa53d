#include "tool/terminal/chosen_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plumb/arith/error.hpp"
#include "tool/terminal/suggestion.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

bool is_chosen(const std::vector<std::string>& asked, const std::string& name) {
  return asked.empty() || std::ranges::find(asked, name) != asked.end();
}

void require_known(std::string_view command, std::string_view what, const std::vector<std::string>& asked,
                   const std::vector<std::string>& known) {
  for (const std::string& name : asked) {
    if (std::ranges::find(known, name) != known.end()) continue;
    std::string all;
    for (const std::string& k : known) all.append(all.empty() ? "" : ", ").append(k);
    throw Error(fmt::format("{}: there is no {} {}{}; there are {}", command, what, printable(name),
                            suggestion(name, known), all));
  }
}

}  // namespace plumb::tool
