// What does a gzip file hold?
//
// Laws: the members of the file one after the other, each held to its checksum and length; zero bytes after the last
// are padding.  Memory grows with what is unpacked, and stops at the limit: a bomb costs what the limit allows.
// Source: RFC 1951, 1952, by zlib.
// Cost: some 300 MB/s of what is unpacked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumb::surface {

bool is_gzip(std::string_view bytes);

/// Throws MeshFileError, which names the file.
std::string gunzip(std::string_view bytes, std::string_view file, std::uint64_t limit);

}  // namespace plumb::surface
