#include "surface/file/gunzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {
namespace {

constexpr int gzip_window = 15 + 16;  // zlib's way to say: the largest window, and gzip's header

class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream_, gzip_window) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  z_stream& operator*() { return stream_; }

 private:
  z_stream stream_{};
};

bool all_zero(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) { return c == '\0'; });
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(std::string_view bytes, std::string_view file, std::uint64_t limit) {
  Inflater inflater;
  z_stream& z = *inflater;
  std::string unpacked;
  std::vector<Bytef> room(std::size_t{1} << 18);
  constexpr std::size_t most_at_once = std::numeric_limits<uInt>::max() / 2;
  for (std::size_t at = 0;;) {
    const std::string_view left = bytes.substr(at, most_at_once);
    z.next_in = reinterpret_cast<z_const Bytef*>(const_cast<char*>(left.data()));  // zlib only reads there
    z.avail_in = static_cast<uInt>(left.size());
    z.next_out = room.data();
    z.avail_out = static_cast<uInt>(room.size());
    const int said = inflate(&z, Z_NO_FLUSH);
    at += left.size() - z.avail_in;
    const std::size_t got = room.size() - z.avail_out;
    if (got > limit - unpacked.size())
      fail_at_file(MeshFileProblem::too_large, file,
                   "unpacks to more than " + std::to_string(limit) + " bytes from " + std::to_string(bytes.size()) +
                       ", expected no more; unpack it by hand, or raise the limit if you trust it");
    unpacked.append(reinterpret_cast<const char*>(room.data()), got);
    if (said == Z_STREAM_END) {
      const std::string_view rest = bytes.substr(at);
      if (all_zero(rest)) return unpacked;
      if (!is_gzip(rest))
        fail_at_byte(MeshFileProblem::syntax, file, at,
                     "something follows the gzip data, expected another gzip member or the end; pack it again");
      inflateReset(&z);
    } else if (said != Z_OK && said != Z_BUF_ERROR) {
      fail_at_byte(MeshFileProblem::syntax, file, at,
                   std::string("the gzip data are damaged (") + (z.msg ? z.msg : "no reason told") +
                       "), expected what gzip writes; fetch or pack it again");
    } else if (at == bytes.size() && got < room.size()) {
      fail_at_byte(MeshFileProblem::truncated, file, at,
                   "the gzip data end here, expected their checksum; the file is cut short: fetch or pack it again");
    }
  }
}

}  // namespace plumb::surface
