// What is a tree file with other bytes, whose checksum fits again?
#pragma once

#include <cstring>
#include <span>
#include <string>

#include "space/bvh/kept_file.hpp"

namespace plumb::tree_files {

/// The last eight bytes of the head are the checksum of all others; what ends before them stays as it is.
inline std::string sealed(std::string bytes) {
  if (bytes.size() < space::head_size) return bytes;
  const auto all = std::as_bytes(std::span(bytes));
  space::Checksum checksum;
  checksum.add(all.first(space::checksum_at));
  checksum.add(all.subspan(space::head_size));
  const std::uint64_t value = checksum.value();
  std::memcpy(&bytes[space::checksum_at], &value, sizeof value);
  return bytes;
}

}  // namespace plumb::tree_files
