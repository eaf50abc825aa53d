// What bytes does a URI of a glTF mean?
//
// Laws: (1) base64 as RFC 4648 has it, padded or not; anything else is none.  (2) A file beside the glTF is in its
// folder or below, also after links are followed; a scheme, an absolute path, ".." or a zero byte,
// escaped or not, is none.  (3) Only regular files are read, and no more of them than is asked for.
// Source: RFC 3986, 4648; glTF 2.0, 2.8.
// Cost: linear.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace plumb::surface {

std::optional<std::string> from_base64(std::string_view text);
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& folder, std::string_view uri);
/// The first bytes of a file, as many as asked for or as there are.
std::optional<std::string> bytes_of(const std::filesystem::path& path, std::uint64_t most);

}  // namespace plumb::surface
