// How do trees lie in files, whichever their layout: a head, then arrays as they lie in memory?
//
// Laws: (1) a file appears under its name whole or not at all.  (2) What does not begin as a file of its kind and version
// does, or is shorter or longer than its head says, is refused before anything else is looked at.
// Errors: BvhFileError, by name.
#pragma once

#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "plumb/space/bvh/tree_file.hpp"

namespace plumb::space {

struct FileKind {
  std::string_view mark;  // eight letters
  std::uint32_t version;
  std::string_view what, writer;
};

inline constexpr std::uint32_t file_byte_order = 0x01020304;
inline constexpr std::uint64_t most_in_file = std::uint64_t{1} << 32;  // of anything, so that no length overflows

/// What a head of 128 bytes begins with.
struct FileOpening {
  char mark[8];
  std::uint32_t version, byte_order;
};

FileOpening opening_of(const FileKind& kind);

[[noreturn]] void refuse_file(const FileKind& kind, const std::string& path, BvhFileProblem problem,
                              const std::string& text);

/// Throws where the file is not of this kind, or ends in its head.
void require_opening(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes);
/// Throws where the length is another than the head says, or than what it promises takes.
void require_length(const FileKind& kind, const std::string& path, std::size_t size, std::uint64_t said,
                    std::uint64_t promised);
void require_exponent(const FileKind& kind, const std::string& path, std::int32_t exponent);

template <class Head>
Head head_in(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes) {
  static_assert(sizeof(Head) == 128);
  require_opening(kind, path, bytes);
  Head head;
  std::memcpy(&head, bytes.data(), sizeof head);
  return head;
}

/// A file's bytes, and what keeps them.
struct FileBytes {
  std::span<const std::byte> bytes;
  std::shared_ptr<const void> keeps;
};
FileBytes map_file(const std::string& path);

/// Arrays that lie behind one another.
class FileArrays {
 public:
  FileArrays(const FileBytes& from, std::size_t at) : from_(from), at_(at) {}
  template <class T>
  KeptArray<T> next(std::uint64_t n) {
    const T* const first = reinterpret_cast<const T*>(from_.bytes.data() + at_);
    at_ += static_cast<std::size_t>(n) * sizeof(T);
    return KeptArray<T>(std::span(first, static_cast<std::size_t>(n)), from_.keeps);
  }

 private:
  const FileBytes& from_;
  std::size_t at_;
};

void write_file(const std::string& path, std::span<const std::span<const std::byte>> parts);

}  // namespace plumb::space
