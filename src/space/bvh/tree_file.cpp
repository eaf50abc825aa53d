#include "plumb/space/bvh/tree_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <type_traits>

#include "space/bvh/tree_check.hpp"

namespace plumb {
namespace {

constexpr std::uint32_t this_version = 1;
constexpr std::uint32_t byte_order = 0x01020304;
constexpr char mark[8] = {'p', 'l', 'u', 'm', 'b', 'b', 'v', 'h'};
constexpr std::uint64_t most = std::uint64_t{1} << 32;  // of anything, so that no length overflows

struct Head {
  char mark[8];
  std::uint32_t version, byte_order;
  std::int32_t exponent;
  std::uint32_t unused;
  std::uint64_t nodes, vertices, slots, length;
  std::byte rest[72];
};
static_assert(sizeof(Head) == 128 && std::is_trivially_copyable_v<Head>);

constexpr std::string_view again = "; write it again with write_bvh";

std::string count(std::uint64_t n, const char* what) { return std::to_string(n) + " " + what; }

std::uint64_t length_of(const Head& h) {
  return sizeof(Head) + h.nodes * sizeof(BoxNode) + h.vertices * sizeof(Point3) +
         h.slots * (sizeof(Bvh::Corners) + sizeof(std::uint32_t));
}

Head head_of(const std::string& path, std::span<const std::byte> bytes) {
  const auto fail = [&](BvhFileProblem problem, const std::string& text) {
    throw BvhFileError(problem, path, text + std::string(again));
  };
  Head head;
  if (bytes.size() < sizeof mark || std::memcmp(bytes.data(), mark, sizeof mark) != 0) {
    fail(BvhFileProblem::not_a_tree, "does not begin with \"plumbbvh\", so it is no tree");
  }
  if (bytes.size() < sizeof head) {
    fail(BvhFileProblem::truncated, "ends after " + count(bytes.size(), "bytes, in the head of 128"));
  }
  std::memcpy(&head, bytes.data(), sizeof head);
  if (head.byte_order != byte_order) fail(BvhFileProblem::version, "was written in another byte order");
  if (head.version != this_version) {
    fail(BvhFileProblem::version,
         "is of version " + std::to_string(head.version) + ", and this library reads " + std::to_string(this_version));
  }
  if (head.nodes >= most || head.vertices > most || head.slots >= most) {
    fail(BvhFileProblem::broken_law, "promises more than 2^32 nodes, vertices or slots");
  }
  if (head.length != length_of(head) || head.length != bytes.size()) {
    fail(BvhFileProblem::truncated,
         "has " + count(bytes.size(), "bytes, and its head promises ") + std::to_string(length_of(head)));
  }
  if (head.exponent < -1000 || head.exponent > 1000) {
    fail(BvhFileProblem::broken_law, "has a frame of exponent " + std::to_string(head.exponent));
  }
  return head;
}

// Arrays that lie in these bytes, which `keeps` owns.
Bvh tree_in(const std::string& path, std::span<const std::byte> bytes, std::shared_ptr<const void> keeps) {
  const Head head = head_of(path, bytes);
  const std::byte* at = bytes.data() + sizeof head;
  const auto next = [&]<class T>(std::uint64_t n, KeptArray<T>& array) {
    array = KeptArray<T>(std::span(reinterpret_cast<const T*>(at), static_cast<std::size_t>(n)), keeps);
    at += n * sizeof(T);
  };
  Bvh bvh;
  next(head.nodes, bvh.tree.nodes);
  next(head.vertices, bvh.vertices);
  next(head.slots, bvh.triangles);
  next(head.slots, bvh.tree.items);
  bvh.tree.frame = BoxFrame::of_exponent(head.exponent);
  const std::string broken = space::broken_law(bvh);
  if (!broken.empty()) throw BvhFileError(BvhFileProblem::broken_law, path, broken + std::string(again));
  widen(bvh);
  return bvh;
}

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

void write_bvh(const std::string& path, const Bvh& bvh) {
  Head head{};
  std::memcpy(head.mark, mark, sizeof mark);
  head.version = this_version;
  head.byte_order = byte_order;
  head.exponent = bvh.tree.frame.exponent();
  head.nodes = bvh.tree.nodes.size();
  head.vertices = bvh.vertices.size();
  head.slots = bvh.triangles.size();
  head.length = length_of(head);
  const std::string part = path + ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  const auto put = [&](const void* from, std::size_t size) {
    out.write(static_cast<const char*>(from), static_cast<std::streamsize>(size));
  };
  const auto put_all = [&](const auto& array) { put(array.data(), array.size() * sizeof(array[0])); };
  put(&head, sizeof head);
  put_all(bvh.tree.nodes);
  put_all(bvh.vertices);
  put_all(bvh.triangles);
  put_all(bvh.tree.items);
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(part, path, failed);
  if (!out || failed) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw BvhFileError(BvhFileProblem::unwritable, path, "cannot be written; is there such a folder, with room in it?");
  }
}

Bvh map_bvh(const std::string& path) {
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
  if (size == 0) return tree_in(path, {}, nullptr);
  void* const at = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.file, 0);
  if (at == MAP_FAILED) throw BvhFileError(BvhFileProblem::unreadable, path, std::strerror(errno));
  return tree_in(path, {static_cast<const std::byte*>(at), size}, std::make_shared<const Mapping>(at, size));
}

Bvh read_bvh(const std::string& path) {
  Bvh bvh = map_bvh(path);
  (void)bvh.tree.nodes.writable();
  (void)bvh.tree.items.writable();
  (void)bvh.triangles.writable();
  (void)bvh.vertices.writable();
  return bvh;
}

}  // namespace plumb
