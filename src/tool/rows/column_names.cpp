#include "tool/rows/column_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "plumb/arith/error.hpp"
#include "surface/file/text_lines.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// Parted by commas or semicolons, else by tabs, else by blanks.
std::vector<std::string_view> columns_of(std::string_view header) {
  std::string_view separators = ",;";
  if (header.find_first_of(separators) == header.npos) separators = "\t";
  if (header.find_first_of(separators) == header.npos) separators = " ";
  std::vector<std::string_view> columns;
  for (std::size_t at = 0; at <= header.size();) {
    const std::size_t end = std::min(header.find_first_of(separators, at), header.size());
    columns.push_back(header.substr(at, end - at));
    at = end + 1;
  }
  if (separators == " ") std::erase(columns, std::string_view());
  return columns;
}

/// The same for all spellings of a name; '_' is a blank, but not before a name.
std::string key_of(std::string_view name) {
  std::string key = surface::lower_case(name);
  std::erase_if(key, [](char c) { return std::string_view(" \t\r\"'").find(c) != std::string_view::npos; });
  if (!key.starts_with('_')) std::erase(key, '_');
  std::ranges::sort(key);
  return key;
}

std::vector<std::string> keys_of(const std::vector<std::string_view>& columns) {
  std::vector<std::string> keys;
  for (const std::string_view column : columns) keys.push_back(key_of(column));
  return keys;
}

}  // namespace

bool are_column_names(std::string_view header, const std::vector<std::string_view>& names) {
  return keys_of(columns_of(header)) == keys_of(names);
}

void require_column_names(std::string_view header, std::span<const std::string_view> names, const std::string& place) {
  const std::vector<std::string_view> columns = columns_of(header);
  const std::vector<std::string> keys = keys_of(columns);
  if (std::ranges::equal(keys, names, {}, {}, key_of)) return;
  const auto is_column = [&](std::string_view name) { return std::ranges::find(keys, key_of(name)) != keys.end(); };
  if (std::ranges::none_of(names, is_column)) return;
  throw Error(fmt::format("{}: the columns are named '{}', and are read as '{}'; leave these, in this order", place,
                          printable(fmt::format("{}", fmt::join(columns, ","))), fmt::join(names, ",")));
}

}  // namespace plumb::tool
