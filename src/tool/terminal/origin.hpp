// Where and when was a report made?  What every JSON report of measured or counted things begins with.
//
// Law: the date is in UTC, as ISO 8601 writes it; what the system does not tell is "unknown".
// Source: none.
// Cost: reading /proc/cpuinfo.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb::tool {

/// program, version, compiler, flags, machine, instruction_sets, date: now.
nlohmann::json origin_json(const std::string& program);

}  // namespace plumb::tool
