// What did others record of moving figures?  Queries with exact answers, of the benchmark of Wang et al. 2021.
//
// Eight rows are one query; a row is x, y, z as three pairs of numerator and denominator, and the true answer, 0 or 1.
// In a folder edge-edge: a0, a1, b0, b1 at time 0, then at time 1; elsewhere a vertex and a triangle likewise.
// Laws: every number is read exactly.  Source: Wang et al. 2021, docs/motion.md; cost: microseconds a query.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "plumb/query/continuous_contact.hpp"

namespace plumb::ccd {

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

/// The number up to the comma at or after `at`, which moves beyond it.
inline double number(const std::string& line, std::size_t& at) {
  const double x = std::strtod(line.c_str() + at, nullptr);
  at = line.find(',', at) + 1;
  return x;
}
/// Numerators are multiples of a power of two with 53 bits at the most, denominators are powers of two: both are
/// doubles, and so is the quotient.
inline double quotient(const std::string& line, std::size_t& at) {
  const double n = number(line, at), d = number(line, at);
  int exponent = 0;
  if (std::frexp(d, &exponent) != 0.5) throw std::runtime_error(line + ": not a power of two below a line");
  return n / d;
}

inline void read_queries(const std::filesystem::path& file, std::vector<Query>& queries) {
  std::ifstream in(file);
  std::size_t row = 0;
  for (std::string line; std::getline(in, line); ++row) {
    if (row % 8 == 0) {
      queries.emplace_back();
      queries.back().scene = file.parent_path().parent_path().filename().string();
      queries.back().vertex_face = file.parent_path().filename() == "vertex-face";
    }
    std::size_t at = 0;
    Query& q = queries.back();
    Point3& p = row % 8 < 4 ? q.at_0[row % 4] : q.at_1[row % 4];
    p.x = quotient(line, at), p.y = quotient(line, at), p.z = quotient(line, at);
    q.meets = line.at(at) == '1';
  }
  if (row % 8 != 0) throw std::runtime_error(file.string() + ": eight rows are one query");
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

}  // namespace plumb::ccd
