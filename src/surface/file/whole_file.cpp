#include "surface/file/whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40;  // as many as Linux follows

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

// Fills the file and closes it: 0, or the error number.
int fill(std::FILE* file, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
  int error = written ? 0 : errno != 0 ? errno : EIO;
  if (std::fclose(file) != 0 && error == 0) error = errno;  // some disks say only now that they are full
  return error;
}

// A file that was not there before, beside the target; its name is short, for the target's may be as long as one gets.
std::FILE* create_beside(const fs::path& target, fs::path& created) {
  for (int k = 0;; ++k) {
    created = target.parent_path() / (".plumb-" + std::to_string(k) + ".part");
    std::FILE* file = std::fopen(created.c_str(), "wbx");
    if (file || errno != EEXIST) return file;
  }
}

// Open streams of this process: what they lead to is somebody else's to replace.
bool is_stream(const fs::path& path) {
  const std::string name = path.string();
  return name.starts_with("/dev/std") || name.starts_with("/dev/fd/") || name.starts_with("/proc/");
}

bool is_refusal(int error) { return error == EACCES || error == EPERM || error == EROFS; }

bool can_be_written(const fs::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "r+b");
  if (file) std::fclose(file);
  return file != nullptr;
}

}  // namespace

fs::path target_of(const fs::path& path) {
  fs::path target = path;
  std::error_code error;
  for (int k = 0; k < most_links && fs::is_symlink(target, error); ++k)
    target = target.parent_path() / fs::read_symlink(target, error);
  return target;
}

StagedFile::StagedFile(const fs::path& path, std::string_view bytes, Replacing replacing)
    : target_(is_stream(path) ? path : target_of(path)), bytes_(bytes), replacing_(replacing) {
  std::error_code error;
  const fs::file_status status = fs::status(target_, error);
  if (fs::is_directory(status)) fail(EISDIR);
  const bool regular = fs::is_regular_file(status);
  if ((fs::exists(status) && !regular) || is_stream(path)) return;
  if (regular && replacing_ == Replacing::no) fail(EEXIST);
  if (regular && !can_be_written(target_)) fail(errno);
  std::FILE* file = create_beside(target_, part_);
  if (!file) {
    part_.clear();
    if (regular && is_refusal(errno)) return;
    fail(errno);
  }
  if (const int failed = fill(file, bytes)) {
    fs::remove(part_, error);
    fail(failed);
  }
  if (regular) fs::permissions(part_, status.permissions(), error);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      part_(std::exchange(other.part_, {})),
      bytes_(other.bytes_),
      replacing_(other.replacing_) {}

StagedFile::~StagedFile() {
  std::error_code ignored;
  if (!part_.empty()) fs::remove(part_, ignored);
}

void StagedFile::keep() {
  if (in_place()) return write_in_place();
  std::error_code error;
  if (replacing_ == Replacing::no) {
    fs::create_hard_link(part_, target_, error);                // unlike a rename, it never replaces
    if (!error) return;                                         // the other name goes with this object
    if (fs::exists(fs::symlink_status(target_))) fail(EEXIST);  // else a file system that knows no links
  }
  fs::rename(part_, target_, error);
  if (!error) {
    part_.clear();
  } else if (can_be_written(target_)) {  // a single file of another file system, say, whose name is held
    write_in_place();
  } else {
    fail(error.value());
  }
}

void StagedFile::write_in_place() const {
  std::FILE* file = std::fopen(target_.c_str(), is_stream(target_) ? "ab" : "wb");
  if (const int failed = file ? fill(file, bytes_) : errno) fail(failed);
}

void write_whole_file(const fs::path& path, std::string_view bytes) try {
  StagedFile(path, bytes).keep();
} catch (const std::system_error& e) {
  fail_at_file(
      MeshFileProblem::unwritable, path.string(),
      "cannot be written: " + e.code().message() + "; check the folder, its permissions and the room on the disk");
}

}  // namespace plumb::surface
