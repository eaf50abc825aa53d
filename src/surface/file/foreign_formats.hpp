// Which known format is this that is not read here, and what makes a mesh of it?
//
// Law: of a file that is none of them, nothing is said.
// Source: the marks that the formats' authors published.
// Cost: a look at the first bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumb::surface {

/// "this is STEP, ...: convert it with ...", by the bytes' mark.
std::optional<std::string> foreign_by_content(std::string_view bytes);
/// The same of packers alone, but for gzip, whose work is read.
std::optional<std::string> packer_by_content(std::string_view bytes);
/// The same by the extension.
std::optional<std::string> foreign_by_extension(const std::filesystem::path& path);

}  // namespace plumb::surface
