// What did others record of moving figures?  Queries with exact answers, of the benchmark of Wang et al. 2021.
//
// Eight rows are one query; a row is x, y, z as three pairs of numerator and denominator, and the true answer, 0 or 1.
// In a folder edge-edge: a0, a1, b0, b1 at time 0, then at time 1; elsewhere a vertex and a triangle likewise.
// Laws: (1) every number is read exactly, or refused; (2) what is no such file is an Error that names the line.
// Source: Wang et al. 2021, docs/motion.md.
// Cost: 20 us a query or some.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/query/time_of_impact/continuous_contact.hpp"

namespace plumb::lab::ccd {

struct Query {
  std::string scene;
  bool vertex_face = false;
  std::array<Point3, 4> at_0, at_1;  // vertex, triangle; or two edges
  bool meets = false;

  [[nodiscard]] Moving<Point3> vertex() const { return {at_0[0], at_1[0]}; }
  [[nodiscard]] Moving<Triangle3> triangle() const {
    return {{at_0[1], at_0[2], at_0[3]}, {at_1[1], at_1[2], at_1[3]}};
  }
  [[nodiscard]] Moving<Segment3> edge(std::size_t i) const {
    return {{at_0[2 * i], at_0[2 * i + 1]}, {at_1[2 * i], at_1[2 * i + 1]}};
  }
};

inline bool intersects(const Query& q) {
  return q.vertex_face ? plumb::intersects(q.vertex(), q.triangle()) : plumb::intersects(q.edge(0), q.edge(1));
}
inline std::optional<Contact> first_contact(const Query& q) {
  return q.vertex_face ? plumb::first_contact(q.vertex(), q.triangle()) : plumb::first_contact(q.edge(0), q.edge(1));
}

/// A row of a file, number after number; what it should not be is an Error that names the file and the line.
class Row {
 public:
  Row(const std::filesystem::path& file, std::size_t number, const std::string& text)
      : where_(file.string() + ':' + std::to_string(number)), at_(text.c_str()) {}

  /// A pair of numerator and denominator, whose quotient is a double.
  double quotient() {
    const double n = integer(), d = integer(), q = n / d;
    int exponent = 0;
    if (std::frexp(d, &exponent) != 0.5) refuse("a denominator is no power of two");
    if (q * d != n) refuse("a coordinate is no double");
    return q;
  }
  bool answer() {
    const char c = *at_;
    if ((c != '0' && c != '1') || (at_[1] != '\0' && at_[1] != '\r')) refuse("expected 0 or 1 as its last number");
    return c == '1';
  }

 private:
  double integer() {
    char* end = nullptr;
    const double x = std::strtod(at_, &end);
    std::array<char, 320> digits{};  // the largest double has 309
    std::snprintf(digits.data(), digits.size(), "%.0f", x);
    const std::string_view text(at_, static_cast<std::size_t>(end - at_));
    if (!std::isfinite(x) || text != digits.data() || *end != ',')
      refuse("expected integers that are doubles, and commas between them");
    at_ = end + 1;
    return x;
  }
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(where_ + ": " + why + "; a row is x, y, z as numerator and denominator, and the answer");
  }

  std::string where_;
  const char* at_;
};

inline void read_queries(const std::filesystem::path& file, std::vector<Query>& queries) {
  std::ifstream in(file);
  if (!in) throw Error(file.string() + ": cannot be read");
  std::size_t row = 0;
  for (std::string line; std::getline(in, line); ++row) {
    if (row % 8 == 0) {
      queries.emplace_back();
      queries.back().scene = file.parent_path().parent_path().filename().string();
      queries.back().vertex_face = file.parent_path().filename() == "vertex-face";
    }
    Query& q = queries.back();
    Point3& p = row % 8 < 4 ? q.at_0[row % 4] : q.at_1[row % 4];
    Row numbers(file, row + 1, line);
    p.x = numbers.quotient(), p.y = numbers.quotient(), p.z = numbers.quotient();
    q.meets = numbers.answer();
  }
  if (row % 8 != 0) throw Error(file.string() + ": its last query is cut off; eight rows are one query");
}

/// All that the folder and those in it hold, in the order of their files; none where there is no such folder.
inline std::vector<Query> all_queries(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".csv") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Query> queries;
  for (const std::filesystem::path& file : files) read_queries(file, queries);
  return queries;
}

}  // namespace plumb::lab::ccd
