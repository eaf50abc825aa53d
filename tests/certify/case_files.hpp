// Cases that break predicates, ours once or those of others, kept as case lines in tests/cases/.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "certify/case_line.hpp"

namespace plumb::battery {

/// Calls visit(place, line) for every line of every file, in the order of their names.
template <class Visit>
void for_each_case_line(const Visit& visit) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(PLUMB_SOURCE_DIR "/tests/cases")) {
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const auto& path : files) {
    std::ifstream file(path);
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      visit(path.filename().string().append(":").append(std::to_string(number)), line);
    }
  }
}

inline std::vector<CaseLine> known_killers() {
  std::vector<CaseLine> all;
  for_each_case_line([&](const std::string&, const std::string& line) {
    if (auto c = parse_case_line(line)) all.push_back(std::move(*c));
  });
  return all;
}

}  // namespace plumb::battery
