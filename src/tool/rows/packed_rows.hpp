// What does a file of rows hold, if it is packed?
//
// Laws: (1) what gzip packed is unpacked, to no more than the options allow.  (2) What another packer made, and an
// archive of several files, throws Error, which names the packer and the mend; so does what is damaged or too large.
// Source: surface/file/gunzip.hpp, surface/file/foreign_formats.hpp.
// Cost: that of unpacking.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::tool {

/// Nothing where they are not packed.  `name` is the file's in errors.
std::optional<std::string> unpacked_rows(std::string_view bytes, const std::string& name, const ReadOptions& reading);

/// Throws Error for a zip archive, by its name or its content.
void require_no_archive(const std::string& file, std::string_view bytes);

/// "points.csv" of "points.csv.gz", and other names as they are.
std::string name_within(const std::string& file);

}  // namespace plumb::tool
