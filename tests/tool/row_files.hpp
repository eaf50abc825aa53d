// Files of rows, byte by byte, and what a program says of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace plumb::tool {

/// Does it hold all of the parts, and nothing of what is absent?
inline void expect_text(const std::string& text, const std::vector<std::string>& parts,
                        const std::vector<std::string>& absent = {}, const std::string& about = "") {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << about << "\nlacks " << part << "\n" << text;
  for (const std::string& part : absent)
    EXPECT_EQ(text.find(part), std::string::npos) << about << "\nhas " << part << "\n" << text;
}

template <class Number>
std::string bytes_of(Number x, bool big) {
  std::string bytes(sizeof x, '\0');
  std::memcpy(bytes.data(), &x, sizeof x);
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// A NumPy file with this header, of version 1 or 2.
inline std::string npy_with(const std::string& header, const std::string& numbers, char version = 1) {
  const auto length = static_cast<std::uint32_t>(header.size());
  return std::string("\x93NUMPY") + version + '\0' +
         (version == 1 ? bytes_of(static_cast<std::uint16_t>(length), false) : bytes_of(length, false)) + header +
         numbers;
}

}  // namespace plumb::tool
