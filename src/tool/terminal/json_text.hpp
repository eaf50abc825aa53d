// How does JSON leave the program?  Indented by one space, and always UTF-8: a file's name may be any bytes.
//
// Source: RFC 8259.
// Cost: linear.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb::tool {

/// With a line break at its end; bytes that are no UTF-8 become the replacement character.
std::string json_text(const nlohmann::json& report);

}  // namespace plumb::tool
