// How does a file come to hold these bytes, all of them or none?
//
// Laws: a regular file is written under a name of its own beside its place, then renamed, with the permissions of the
// one that it replaces; a link is followed; a device or pipe is written in place.  What fails leaves nothing behind.
#pragma once

#include <filesystem>
#include <string_view>

namespace plumb::surface {

/// Throws MeshFileError.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace plumb::surface
