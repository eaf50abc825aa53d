#include "space/bvh/kept_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace plumb::space {
namespace {

struct Closed {
  int file;
  explicit Closed(int f) : file(f) {}
  Closed(const Closed&) = delete;
  Closed& operator=(const Closed&) = delete;
  ~Closed() {
    if (file >= 0) ::close(file);
  }
};

struct Mapping {
  void* at;
  std::size_t size;
  Mapping(void* a, std::size_t s) : at(a), size(s) {}
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;
  ~Mapping() { ::munmap(at, size); }
};

}  // namespace

// Both sums walk over one piece before the next, so that the second one finds it in the cache.
void Checksum::add(std::span<const std::byte> bytes) {
  constexpr std::size_t piece = std::size_t{1} << 16;
  while (!bytes.empty()) {
    const auto now = bytes.first(std::min(piece, bytes.size()));
    const auto* const data = reinterpret_cast<const Bytef*>(now.data());
    const auto size = static_cast<uInt>(now.size());
    crc_ = static_cast<std::uint32_t>(crc32(crc_, data, size));
    adler_ = static_cast<std::uint32_t>(adler32(adler_, data, size));
    bytes = bytes.subspan(now.size());
  }
}

FileOpening opening_of(const FileKind& kind) {
  FileOpening opening{{}, kind.version, file_byte_order};
  std::memcpy(opening.mark, kind.mark.data(), sizeof opening.mark);
  return opening;
}

void refuse_file(const FileKind& kind, const std::string& path, BvhFileProblem problem, const std::string& text) {
  throw BvhFileError(problem, path, text + "; write it again with " + std::string(kind.writer));
}

void require_opening(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes) {
  const auto fail = [&](BvhFileProblem problem, const std::string& text) { refuse_file(kind, path, problem, text); };
  if (bytes.size() < kind.mark.size() || std::memcmp(bytes.data(), kind.mark.data(), kind.mark.size()) != 0) {
    fail(BvhFileProblem::not_a_tree,
         "does not begin with \"" + std::string(kind.mark) + "\", so it is no " + std::string(kind.what));
  }
  if (bytes.size() < head_size) {
    fail(BvhFileProblem::truncated, "ends after " + std::to_string(bytes.size()) + " bytes, in the head of 128");
  }
  FileOpening opening;
  std::memcpy(&opening, bytes.data(), sizeof opening);
  if (opening.byte_order != file_byte_order) fail(BvhFileProblem::version, "was written in another byte order");
  if (opening.version != kind.version) {
    fail(BvhFileProblem::version, "is of version " + std::to_string(opening.version) + ", and this library reads " +
                                      std::to_string(kind.version));
  }
}

void require_length(const FileKind& kind, const std::string& path, std::size_t size, std::uint64_t said,
                    std::uint64_t promised) {
  if (said == promised && promised == size) return;
  refuse_file(kind, path, BvhFileProblem::truncated,
              "has " + std::to_string(size) + " bytes, and its head promises " + std::to_string(promised));
}

void require_checksum(const FileKind& kind, const std::string& path, std::span<const std::byte> bytes) {
  std::uint64_t written = 0;
  std::memcpy(&written, bytes.data() + checksum_at, sizeof written);
  Checksum checksum;
  checksum.add(bytes.first(checksum_at));
  checksum.add(bytes.subspan(head_size));
  if (checksum.value() == written) return;
  refuse_file(kind, path, BvhFileProblem::damaged, "is damaged: its bytes have another checksum than was written");
}

void require_exponent(const FileKind& kind, const std::string& path, std::int32_t exponent) {
  if (exponent >= -1000 && exponent <= 1000) return;
  refuse_file(kind, path, BvhFileProblem::broken_law, "has a frame of exponent " + std::to_string(exponent));
}

FileBytes map_file(const std::string& path) {
  const Closed file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.file < 0) {
    if (errno == ENOENT) throw BvhFileError(BvhFileProblem::missing, path, "there is no such file");
    throw BvhFileError(BvhFileProblem::unreadable, path, std::strerror(errno));
  }
  struct stat about {};
  if (::fstat(file.file, &about) != 0 || !S_ISREG(about.st_mode)) {
    throw BvhFileError(BvhFileProblem::unreadable, path, "is no regular file; name a tree's");
  }
  const auto size = static_cast<std::size_t>(about.st_size);
  if (size == 0) return {};
  void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.file, 0);
  if (at == MAP_FAILED) throw BvhFileError(BvhFileProblem::unreadable, path, std::strerror(errno));
  return {{static_cast<const std::byte*>(at), size}, std::make_shared<const Mapping>(at, size)};
}

void seal(std::span<std::byte, head_size> head, std::span<const std::span<const std::byte>> arrays) {
  Checksum checksum;
  checksum.add(head.first(checksum_at));
  for (const auto& bytes : arrays) checksum.add(bytes);
  const std::uint64_t value = checksum.value();
  std::memcpy(head.data() + checksum_at, &value, sizeof value);
}

void write_file(const std::string& path, std::span<std::byte, head_size> head,
                std::span<const std::span<const std::byte>> arrays) {
  seal(head, arrays);
  const std::string part = path + ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  const auto put = [&](std::span<const std::byte> bytes) {
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  };
  put(head);
  for (const auto& bytes : arrays) put(bytes);
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, path, failed);
  if (!out || failed) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw BvhFileError(BvhFileProblem::unwritable, path, "cannot be written; is there such a folder, with room in it?");
  }
}

}  // namespace plumb::space
