#include "tool/terminal/origin.hpp"

#include <array>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "plumb/certify/environment.hpp"

namespace plumb::tool {
namespace {

/// As the system names it; "unknown" where it does not.
std::string processor() {
  std::ifstream about("/proc/cpuinfo");
  for (std::string line; std::getline(about, line);) {
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace

nlohmann::json origin_json(const std::string& program) {
  const Environment e = check_environment();
  return {{"program", program}, {"version", e.version},   {"compiler", e.compiler},
          {"flags", e.build},   {"machine", processor()}, {"instruction_sets", e.instruction_sets},
          {"date", now()}};
}

}  // namespace plumb::tool
