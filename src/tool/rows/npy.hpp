// Which numbers does a NumPy file (.npy) hold, and how is an array written as one?
//
// Laws: (1) read are arrays of float64 and float32, in either byte order, in C and in Fortran order, of versions 1 to
// 3; float32 widens exactly.  (2) Others, and files that are shorter or longer than they say, throw Error, which says
// what was found and how it is mended.  (3) What is written is little endian, in C order, of version 1, and its numbers
// begin at a multiple of 64 bytes, as NumPy's own.
// Source: NumPy Enhancement Proposal 1; numpy.lib.format.
// Cost: linear; nothing is held that the file does not hold.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::tool {

struct NpyArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;  // in C order: the last index runs fastest
};

/// Does it begin as such files do?
bool is_npy(std::string_view bytes);

/// `name` is the file's in errors.
NpyArray read_npy(std::string_view bytes, std::string_view name);

/// "(3, 4)", as Python writes it.
std::string shape_text(std::span<const std::size_t> shape);

/// As many values as the shape says.
std::string npy_of(std::span<const double> values, std::span<const std::size_t> shape);
std::string npy_of(std::span<const std::int64_t> values, std::span<const std::size_t> shape);

}  // namespace plumb::tool
