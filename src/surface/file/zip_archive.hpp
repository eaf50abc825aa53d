// What files does a zip archive hold?
//
// Laws: the bytes of an entry are held to their checksum; all entries read together unpack to no more than the limit,
// whatever the archive claims.  Names are compared without case, as 3MF wants it.
// Source: APPNOTE 6.3.4 by minizip; ISO/IEC 29500-2.
// Cost: a look through the directory, once.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace plumb::surface {

class ZipArchive {
 public:
  /// The bytes must outlive the archive; `file` names it in errors.
  ZipArchive(std::string_view bytes, std::string_view file, std::uint64_t limit);
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;
  ~ZipArchive();

  /// What the entry holds; nothing where there is none of that name.  Throws MeshFileError.
  std::optional<std::string> entry(const std::string& name);

 private:
  struct Reading;
  std::unique_ptr<Reading> reading_;
};

}  // namespace plumb::surface
