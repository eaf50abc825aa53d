// What does a zip archive of these files look like?  Written here by hand, so that it can also be written wrongly.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

#include "surface/file/gzipped.hpp"

namespace plumb::surface_test {

struct ZipEntry {
  std::string name, bytes;
  std::uint16_t flags = 0, method = 8;  // deflated; 0 is stored
};

inline std::string zipped(const std::vector<ZipEntry>& entries) {
  const auto number = [](std::uint64_t x, int bytes) {
    std::string s;
    for (int i = 0; i < bytes; ++i) s += static_cast<char>(x >> (8 * i) & 0xFF);
    return s;
  };
  std::string files, directory;
  for (const ZipEntry& e : entries) {
    const std::string packed = e.method == 0 ? e.bytes : deflated(e.bytes, -15);
    const auto check = crc32(0, reinterpret_cast<const Bytef*>(e.bytes.data()), static_cast<uInt>(e.bytes.size()));
    const std::string about = number(20, 2) + number(e.flags, 2) + number(e.method, 2) + number(0, 4) +
                              number(check, 4) + number(packed.size(), 4) + number(e.bytes.size(), 4) +
                              number(e.name.size(), 2) + number(0, 2);
    directory += "PK\1\2" + number(20, 2) + about + number(0, 8) + number(0, 2) + number(files.size(), 4) + e.name;
    files += "PK\3\4" + about + e.name + packed;
  }
  return files + directory + "PK\5\6" + number(0, 4) + number(entries.size(), 2) + number(entries.size(), 2) +
         number(directory.size(), 4) + number(files.size(), 4) + number(0, 2);
}

}  // namespace plumb::surface_test
