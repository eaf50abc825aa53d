#include "tool/terminal/json_text.hpp"

#include <nlohmann/json.hpp>

namespace plumb::tool {

std::string json_text(const nlohmann::json& report) {
  return report.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace plumb::tool
