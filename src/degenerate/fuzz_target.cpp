#include "plumb/degenerate/fuzz_target.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>

#include "degenerate/fields.hpp"
#include "degenerate/kept_environment.hpp"
#include "plumb/degenerate/paste.hpp"

namespace plumb::degenerate {

namespace {

/// Takes numbers from the front of bytes.
class Reader {
 public:
  explicit Reader(Bytes bytes) : bytes_(bytes) {}

  std::size_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// Of up to 65535 points.
  std::size_t index() {
    const std::size_t low = byte();
    return low + 256 * byte();
  }
  double number() {
    double value = 0;
    const std::size_t taken = std::min(bytes_.size(), sizeof value);
    if (taken != 0) std::memcpy(&value, bytes_.data(), taken);
    bytes_ = bytes_.subspan(taken);
    return value;
  }

 private:
  Bytes bytes_;
};

Numbers stored(const Kind& kind, Bytes bytes) {
  Reader reader(bytes);
  Numbers numbers;
  for (const Argument& argument : kind.arguments) {
    std::size_t points = 1;
    if (argument.any_number()) {
      points = argument.least + reader.byte();
      numbers.push_back(static_cast<double>(points));
    }
    const bool named = names_points(argument.parts[0].role);
    for (std::size_t left = points * numbers_in(argument); left > 0; --left) {
      numbers.push_back(named ? static_cast<double>(reader.index()) : reader.number());
    }
  }
  put_in_order(kind, numbers);
  return numbers;
}

}  // namespace

std::optional<Numbers> numbers_from(const Kind& kind, Bytes bytes) {
  if (bytes.empty()) return std::nullopt;
  Numbers numbers;
  if (bytes[0] % 2 == 0) {
    numbers = stored(kind, bytes.subspan(1));
  } else {
    Entropy entropy = Entropy::from_bytes(bytes.subspan(1));
    kind.generators[entropy.below(kind.generators.size())].make(numbers, entropy);
  }
  if (!flaw_of(kind, numbers).empty()) return std::nullopt;
  return numbers;
}

std::vector<std::uint8_t> bytes_of(const Kind& kind, std::span<const double> numbers) {
  std::vector<std::uint8_t> bytes{0};
  std::size_t at = 0;
  for (const Argument& argument : kind.arguments) {
    std::size_t points = 1;
    if (argument.any_number()) {
      points = static_cast<std::size_t>(numbers[at++]);
      bytes.push_back(static_cast<std::uint8_t>(points - argument.least));
    }
    for (std::size_t left = points * numbers_in(argument); left > 0; --left, ++at) {
      if (names_points(argument.parts[0].role)) {
        const auto index = static_cast<std::size_t>(numbers[at]);
        bytes.insert(bytes.end(), {static_cast<std::uint8_t>(index % 256), static_cast<std::uint8_t>(index / 256)});
        continue;
      }
      std::array<std::uint8_t, sizeof(double)> stored_number{};
      std::memcpy(stored_number.data(), &numbers[at], sizeof(double));
      bytes.insert(bytes.end(), stored_number.begin(), stored_number.end());
    }
  }
  return bytes;
}

int fuzz_target(const Kind& kind, const Callable& function, Bytes bytes, std::optional<Tolerance> tolerance) {
  const std::optional<Numbers> numbers = numbers_from(kind, bytes);
  if (!numbers) return 0;
  const Answer given = [&] {
    const KeptEnvironment kept;
    return function(*numbers);
  }();
  const Judgment judgment = judge(kind, *numbers, given, tolerance.value_or(kind.tolerance));
  if (judgment.verdict == Verdict::right || judgment.verdict == Verdict::unsure) return 0;
  std::cerr << kind.name << " answered " << words(kind, given) << ", exactly it is "
            << words(kind, kind.exact(*numbers)) << "\n"
            << case_line(kind, *numbers) << "\n"
            << decimal_text(kind, *numbers) << "\n"
            << cpp_text(kind, *numbers, "my_function") << std::endl;
  std::abort();
}

int fuzz_files(int argc, char** argv, int (*target)(const std::uint8_t* data, std::size_t size)) {
  const auto all_of = [&](std::istream& in) {
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  };
  if (argc < 2) all_of(std::cin);
  for (int i = 1; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    if (!file) {
      std::cerr << argv[i] << ": cannot be read; give files of bytes, or bytes on the standard input\n";
      return 2;
    }
    all_of(file);
  }
  return 0;
}

std::vector<std::vector<std::uint8_t>> fuzz_seeds(const Kind& kind, std::size_t each, std::uint64_t seed) {
  std::vector<std::vector<std::uint8_t>> seeds;
  for (const Generator& generator : kind.generators) {
    for (std::size_t i = 0; i < each; ++i) {
      seeds.push_back(bytes_of(kind, case_of(kind, generator.name, seed, i)));
    }
  }
  return seeds;
}

void write_fuzz_seeds(const Kind& kind, const std::string& folder, std::size_t each, std::uint64_t seed) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  std::size_t number = 0;
  for (const std::vector<std::uint8_t>& bytes : fuzz_seeds(kind, each, seed)) {
    const std::string path = folder + "/" + kind.generators[number / each].name + "_" + std::to_string(number % each);
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) throw Error("write_fuzz_seeds: " + path + " cannot be written; name a folder that can");
    ++number;
  }
}

std::string fuzz_dictionary() {
  using Limits = std::numeric_limits<double>;
  struct Entry {
    std::string_view name;
    double value;
  };
  const std::array entries = {Entry{"zero", 0.0},
                              Entry{"negative_zero", -0.0},
                              Entry{"one", 1.0},
                              Entry{"minus_one", -1.0},
                              Entry{"two", 2.0},
                              Entry{"half", 0.5},
                              Entry{"above_half", std::nextafter(0.5, 1.0)},
                              Entry{"below_half", std::nextafter(0.5, 0.0)},
                              Entry{"above_one", std::nextafter(1.0, 2.0)},
                              Entry{"below_one", std::nextafter(1.0, 0.0)},
                              Entry{"twelve", 12.0},
                              Entry{"twenty_four", 24.0},
                              Entry{"tenth", 0.1},
                              Entry{"third", 1.0 / 3},
                              Entry{"largest_odd", 0x1.fffffffffffffp52},
                              Entry{"last_integer", 0x1p53},
                              Entry{"least", Limits::denorm_min()},
                              Entry{"least_normal", Limits::min()},
                              Entry{"largest", Limits::max()},
                              Entry{"root_of_largest", 0x1p511},
                              Entry{"root_of_least", 0x1p-537}};
  std::string text = "# Doubles that are hard on geometry, as they lie in memory.\n";
  for (const Entry& entry : entries) {
    text.append(entry.name).append("=\"");
    std::array<unsigned char, sizeof(double)> bytes{};
    std::memcpy(bytes.data(), &entry.value, sizeof(double));
    for (const unsigned char byte : bytes) {
      std::array<char, 8> digits{};
      std::snprintf(digits.data(), digits.size(), "\\x%02X", byte);
      text.append(digits.data());
    }
    text.append("\"\n");
  }
  return text;
}

}  // namespace plumb::degenerate
