// How do trees lie in files, whichever their layout: a head, then arrays as they lie in memory?
//
// Laws: (1) a file appears under its name whole or not at all.  (2) What does not begin as a file of its kind and version
// does, or is shorter or longer than its head says, is refused before anything else is looked at; then what has another
// checksum.
// Errors: BvhFileError, by name.
#pragma once

#include <cstddef>
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
  std::string_view what, writer;  // a call that writes such a file
};

inline constexpr std::uint32_t file_byte_order = 0x01020304;
inline constexpr std::uint64_t most_in_file = std::uint64_t{1} << 32;  // of anything, so that no length overflows
inline constexpr std::size_t head_size = 128, checksum_at = 120;       // the checksum ends the head

/// What a head begins with.
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
/// Throws where a byte is another than was written, as far as the checksum tells; of files that have a whole head.
void require_checksum(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes);
void require_exponent(const FileKind& kind, const std::string& path, std::int32_t exponent);

template <class Head>
Head head_in(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes) {
  static_assert(sizeof(Head) == head_size && offsetof(Head, checksum) == checksum_at);
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

/// Are these the bytes that were written?  64 bits: a CRC-32 and, below it, an Adler-32 of the same bytes, in their order,
/// whatever the pieces in which they are added.  Texts of one length that differ in up to 32 bits in a row have different
/// values.  It is no defense against who means to deceive: a checksum can be made to fit.
/// Source: Peterson and Brown, Cyclic codes for error detection, 1961; RFC 1950, RFC 1952; zlib.
/// Cost: 0.6 ns a byte.
class Checksum {
 public:
  void add(std::span<const std::byte> bytes);
  [[nodiscard]] std::uint64_t value() const { return std::uint64_t{crc_} << 32 | adler_; }

 private:
  std::uint32_t crc_ = 0, adler_ = 1;
};

/// Fills the checksum in.
void seal(std::span<std::byte, head_size> head, std::span<const std::span<const std::byte>> arrays);

/// Writes the head, with the checksum filled in, and the arrays behind it.
void write_file(const std::string& path, std::span<std::byte, head_size> head,
                std::span<const std::span<const std::byte>> arrays);

}  // namespace plumb::space
