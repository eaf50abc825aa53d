// How does a file come to hold these bytes, all of them or none?
//
// Laws: (1) a regular file is written under a name of its own beside its place, then renamed, with the permissions of
// the one that it replaces; a link is followed; a device, a pipe or an open stream (/dev/stdout, /dev/fd/3) is written
// in place, and so is a file that can be written in a folder that takes no new one; (2) what is not kept, or fails,
// leaves nothing behind; (3) what shall be new replaces nothing, not even what appeared meanwhile.
// Source: none.
// Cost: that of writing the bytes.
#pragma once

#include <filesystem>
#include <string_view>

namespace plumb::surface {

enum class Replacing : bool { no, yes };

/// Bytes beside their place, until they are kept; they must outlive it.
class StagedFile {
 public:
  /// Throws std::system_error.
  StagedFile(const std::filesystem::path& path, std::string_view bytes, Replacing replacing = Replacing::yes);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();

  /// Nothing is beside: keep() writes in place, and may wait for who reads.
  [[nodiscard]] bool in_place() const { return part_.empty(); }
  /// Into its place; throws std::system_error.
  void keep();

 private:
  void write_in_place() const;

  std::filesystem::path target_, part_;
  std::string_view bytes_;
  Replacing replacing_;
};

/// The file that the path means: links followed, also where the last leads to nothing yet.
std::filesystem::path target_of(const std::filesystem::path& path);

/// Throws MeshFileError.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace plumb::surface
