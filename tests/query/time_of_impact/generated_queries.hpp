// Which queries of moving figures can be asked where ../shared/ccd is not?  Generated ones, in files of the same form.
//
// The motions of tool/trial/moving_cases.hpp, on small grids and moved off them, answered by Sturm sequences in
// rationals; tool/stability/ccd_queries.hpp says what a row is.
// Laws: the same files on every machine.
// Cost: some milliseconds a query.
#pragma once

#include <gmpxx.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "lab/trial/contact_judge.hpp"
#include "lab/trial/moving_cases.hpp"

namespace plumb::lab::moving_cases {

/// A folder of them, laid out as ../shared/ccd is; gone with this object.
class GeneratedQueries {
 public:
  static constexpr std::uint64_t each = 40;  // of a kind, as vertices and faces, and as edges
  static constexpr std::uint64_t queries = (kinds.size() - 1) * 2 * each;

  GeneratedQueries() {
    std::uint64_t start = 0;
    for (const Kind kind : kinds) {
      if (kind == Kind::family) continue;  // magnitudes that leave no room for the judge's powers of them
      for (const bool vertex_face : {true, false}) {
        const auto scene = path_ / name_of(kind) / (vertex_face ? "vertex-face" : "edge-edge");
        std::filesystem::create_directories(scene);
        std::ofstream out(scene / "data.csv");
        for (std::uint64_t i = 0; i < each; ++i) {
          Entropy entropy(2030 + start, i);
          write(out, query(kind, vertex_face, entropy));
        }
        ++start;
      }
    }
  }
  GeneratedQueries(const GeneratedQueries&) = delete;
  GeneratedQueries& operator=(const GeneratedQueries&) = delete;
  ~GeneratedQueries() { std::filesystem::remove_all(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  /// Every second one with coordinates that are no small integers: times a third, as rounded, for each axis another.
  static Case query(Kind kind, bool vertex_face, Entropy& entropy) {
    Case c = make(kind, vertex_face, entropy);
    if (entropy.coin()) return c;
    for (auto* points : {&c.at_0, &c.at_1}) {
      for (Point3& p : *points) p = {p.x / 3, p.y / 5 + 1, p.z * 0x1p-40};
    }
    return c;
  }

  static void write(std::ostream& out, const Case& c) {
    const bool meets = !lab::contact_judge::contacts(c.vertex_face, c.at_0, c.at_1, 0).empty();
    for (const auto* points : {&c.at_0, &c.at_1}) {
      for (const Point3& p : *points) {
        for (const double x : {p.x, p.y, p.z}) {
          const mpq_class q(x);
          out << q.get_num() << ',' << q.get_den() << ',';
        }
        out << meets << '\n';
      }
    }
  }

  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("plumb_generated_queries_" + std::to_string(::getpid()));
};

}  // namespace plumb::lab::moving_cases
