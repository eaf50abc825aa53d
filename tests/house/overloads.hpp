// Which functions of a name does a public header declare, and for which two arguments?
//
// Laws: functions of namespace plumb alone: neither members, nor what a nested namespace keeps for the library, nor
// calls.  An argument is named by its type, without const, reference, name and default; by its name in the template where
// it is one of its parameters.
// Cost: linear in the text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace plumb::house {

struct Overload {
  std::string function, first, second, header;
  friend auto operator<=>(const Overload&, const Overload&) = default;
};

std::vector<Overload> overloads_in(const std::string& text, const std::string& header,
                                   const std::vector<std::string>& functions);
/// In all headers of include/plumb, sorted, each once.
std::vector<Overload> overloads_of(const std::filesystem::path& tree, const std::vector<std::string>& functions);

}  // namespace plumb::house
