// What do gzip and zip make of these bytes?
#pragma once

#include <zlib.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace plumb::surface_test {

/// Deflated by the window that zlib's manual tells: 31 for gzip, -15 for bare data as in zip.
inline std::string deflated(std::string_view bytes, int window) {
  z_stream z{};
  if (deflateInit2(&z, Z_BEST_COMPRESSION, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("deflateInit2");
  std::string packed(deflateBound(&z, static_cast<uLong>(bytes.size())), '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  const int said = deflate(&z, Z_FINISH);
  packed.resize(packed.size() - z.avail_out);
  deflateEnd(&z);
  if (said != Z_STREAM_END) throw std::runtime_error("deflate");
  return packed;
}

inline std::string gzipped(std::string_view bytes) { return deflated(bytes, 31); }

}  // namespace plumb::surface_test
