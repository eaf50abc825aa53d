#include "tool/rows/npy.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <limits>
#include <set>

#include "plumb/arith/error.hpp"
#include "surface/file/byte_reader.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view magic("\x93NUMPY", 6);

struct NpyHeader {
  std::string type;
  bool fortran_order = false;
  std::vector<std::size_t> shape;
};

/// The literal of a Python dictionary, of the three entries that a header has.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

  NpyHeader parse() {
    NpyHeader header;
    std::set<std::string> keys;
    require('{');
    while (!takes("}")) {
      const std::string key = quoted();
      if (!keys.insert(key).second) fail("each entry once");
      require(':');
      if (key == "descr") {
        header.type = type();
      } else if (key == "fortran_order") {
        header.fortran_order = takes("True");
        if (!header.fortran_order && !takes("False")) fail("True or False");
      } else if (key == "shape") {
        header.shape = shape();
      } else {
        fail("descr, fortran_order or shape");
      }
      if (!takes(",")) {
        require('}');
        break;
      }
    }
    if (keys.size() != 3) fail("descr, fortran_order and shape");
    takes("");  // blanks
    if (!rest_.empty()) fail("the end of the header");
    return header;
  }

 private:
  [[noreturn]] void fail(std::string_view expected) const {
    throw Error(
        fmt::format("{}: the header of this NumPy file is broken: expected {} before '{}'; write it again by "
                    "numpy.save",
                    name_, expected, printable(rest_.substr(0, 20))));
  }
  bool takes(std::string_view word) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void require(char c) {
    if (!takes(std::string_view(&c, 1))) fail(std::string(1, c));
  }
  std::string quoted() {
    const std::string_view mark = takes("'") ? "'" : takes("\"") ? "\"" : "";
    const std::size_t end = mark.empty() ? std::string_view::npos : rest_.find(mark);
    if (end == std::string_view::npos) fail("a word in quotes");
    const std::string word(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return word;
  }
  std::string type() {
    if (!takes("[")) return quoted();
    throw Error(
        fmt::format("{}: this NumPy file holds records with fields, expected rows of float64 or float32; save "
                    "numpy.lib.recfunctions.structured_to_unstructured(array)",
                    name_));
  }
  std::vector<std::size_t> shape() {
    std::vector<std::size_t> lengths;
    require('(');
    while (!takes(")")) {
      std::size_t length = 0;
      takes("");  // blanks
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), length);
      if (error != std::errc()) fail("a length");
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      takes("L");  // Python 2
      lengths.push_back(length);
      if (!takes(",")) {
        require(')');
        break;
      }
    }
    return lengths;
  }

  std::string_view rest_, name_;
};

/// How many numbers, of a shape that a file's bytes can fill.
std::size_t count_of(std::span<const std::size_t> shape, std::size_t most) {
  std::size_t count = 1;
  for (const std::size_t length : shape) {
    if (length == 0) return 0;
  }
  for (const std::size_t length : shape) {
    if (count > most / length) return std::numeric_limits<std::size_t>::max();
    count *= length;
  }
  return count;
}

/// The place in C order of each number in Fortran order, where the first index runs fastest.
std::vector<double> in_c_order(const std::vector<double>& values, std::span<const std::size_t> shape) {
  std::vector<double> ordered(values.size());
  std::vector<std::size_t> index(shape.size());
  for (const double value : values) {
    std::size_t place = 0;
    for (std::size_t k = 0; k < shape.size(); ++k) place = place * shape[k] + index[k];
    ordered[place] = value;
    for (std::size_t k = 0; k < shape.size() && ++index[k] == shape[k]; ++k) index[k] = 0;
  }
  return ordered;
}

template <class Number>
std::string written(std::string_view type, std::span<const Number> values, std::span<const std::size_t> shape) {
  constexpr std::size_t fixed = 10, alignment = 64;  // before the header's text
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type, shape_text(shape));
  header.append(alignment - 1 - (fixed + header.size()) % alignment, ' ').append("\n");
  std::string bytes(magic);
  bytes.append({'\x01', '\0', static_cast<char>(header.size() & 0xff), static_cast<char>(header.size() >> 8)});
  bytes += header;
  bytes.reserve(bytes.size() + values.size_bytes());
  for (const Number value : values) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t k = 0; k < sizeof bits; ++k, bits >>= 8) bytes += static_cast<char>(bits & 0xff);
  }
  return bytes;
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(magic); }

std::string shape_text(std::span<const std::size_t> shape) {
  std::string text = "(";
  for (std::size_t k = 0; k < shape.size(); ++k) text += fmt::format("{}{}", k == 0 ? "" : ", ", shape[k]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

NpyArray read_npy(std::string_view bytes, std::string_view name) {
  if (!is_npy(bytes)) {
    throw Error(
        fmt::format("{}: this is no NumPy file: it does not begin with the six bytes that all of them begin "
                    "with; write it by numpy.save",
                    name));
  }
  surface::ByteReader header(bytes, name, magic.size(), std::endian::little);
  const auto major = header.read<std::uint8_t>("the version"), minor = header.read<std::uint8_t>("the version");
  if (major < 1 || major > 3)
    throw Error(fmt::format("{}: version {}.{} of NumPy's format is not known; 1 to 3 are read", name, major, minor));
  const std::uint32_t length = major == 1 ? header.read<std::uint16_t>("the header's length")
                                          : header.read<std::uint32_t>("the header's length");
  header.require(length, 1, "the header");
  const NpyHeader about = HeaderParser(header.rest().substr(0, length), name).parse();

  const std::string_view kind = std::string_view(about.type).substr(about.type.empty() ? 0 : 1);
  const bool is_float = kind == "f4", big = about.type.starts_with('>');
  if ((!is_float && kind != "f8") || about.type.find_first_of("<>") != 0) {
    throw Error(
        fmt::format("{}: this NumPy file holds numbers of type '{}', expected float64 ('<f8') or float32 "
                    "('<f4'); save array.astype(float)",
                    name, printable(about.type)));
  }
  surface::ByteReader numbers(bytes, name, header.offset() + length, big ? std::endian::big : std::endian::little);
  const std::size_t size = is_float ? sizeof(float) : sizeof(double);
  const std::size_t count = count_of(about.shape, bytes.size());
  if (count > bytes.size()) {
    throw Error(
        fmt::format("{}: the array of shape {} is larger than the whole file; it is cut short: fetch or write it "
                    "again",
                    name, shape_text(about.shape)));
  }
  numbers.require(count, size, "the array's numbers");
  if (numbers.left() != count * size) {
    throw Error(fmt::format("{}: {} bytes follow the array of shape {}; write one array into a file, by numpy.save",
                            name, numbers.left() - count * size, shape_text(about.shape)));
  }
  NpyArray array{about.shape, std::vector<double>(count)};
  for (double& value : array.values)
    value = is_float ? double{numbers.read<float>("a number")} : numbers.read<double>("a number");
  if (about.fortran_order) array.values = in_c_order(array.values, array.shape);
  return array;
}

std::string npy_of(std::span<const double> values, std::span<const std::size_t> shape) {
  return written("<f8", values, shape);
}
std::string npy_of(std::span<const std::int64_t> values, std::span<const std::size_t> shape) {
  return written("<i8", values, shape);
}

}  // namespace plumb::tool
