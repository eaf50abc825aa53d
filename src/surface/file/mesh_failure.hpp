// How does a reader or writer say what is wrong?  One call for each kind of place: a line, a byte, the whole file.
//
// Law: text found in a file is quoted, cut short and freed of control characters before it is shown.
#pragma once

#include <string>

#include "plumb/surface/file/mesh_file.hpp"

namespace plumb::surface {

std::string in_quotes(std::string_view found);

[[noreturn]] void fail_at_line(MeshFileProblem problem, std::string_view file, std::uint64_t line,
                               const std::string& text);
[[noreturn]] void fail_at_byte(MeshFileProblem problem, std::string_view file, std::uint64_t byte,
                               const std::string& text);
[[noreturn]] void fail_at_file(MeshFileProblem problem, std::string_view file, const std::string& text);

}  // namespace plumb::surface
