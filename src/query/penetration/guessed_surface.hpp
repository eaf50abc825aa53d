// Expanding polytope (EPA): a guess, in doubles, of a surface around the origin whose nearest facet is one of the
// difference.
//
// Laws: nothing is certain of it, neither where it lies nor that it is closed.  It ends: each point of finitely many is
// taken once.
// Source: van den Bergen 2001.
// Cost: some 100 ns a step; a few KiB of the stack, and what outgrows them.
#pragma once

#include <memory_resource>
#include <vector>

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

class GuessedSurface {
 public:
  struct Facet {
    std::array<std::uint32_t, 3> corner, across;  // as those of query/penetration/surface.hpp
    arith::Plain normal;
    double offset, doubt;  // the plane's, times the normal's length; what is no further beyond it is taken to lie in it
    double distance;       // from the origin, below zero where that is before it
    bool is_there, is_done;
  };
  struct Point {
    Ends ends;
    arith::Plain at;
    std::uint32_t starts;  // the new facet whose first edge starts here, while one point is taken
  };

  /// From four points that are not in one plane.
  GuessedSurface(const Difference& d, const std::array<Ends, 4>& start);
  GuessedSurface(const GuessedSurface&) = delete;
  GuessedSurface& operator=(const GuessedSurface&) = delete;

  /// Is it closed?  Where the guess of what a point sees went astray it is none.
  [[nodiscard]] bool is_sound() const { return is_sound_; }
  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
  [[nodiscard]] std::span<const Point> points() const { return points_; }
  [[nodiscard]] std::array<Ends, 3> ends_of(const Facet& f) const {
    return {points_[f.corner[0]].ends, points_[f.corner[1]].ends, points_[f.corner[2]].ends};
  }

 private:
  void run();
  void take(const Ends& e, const arith::Plain& at);
  void make(std::uint32_t p, std::uint32_t q, std::uint32_t r);
  [[nodiscard]] static bool sees(const arith::Plain& at, const Facet& f) {
    return dot(f.normal, at) - f.offset > f.doubt;
  }
  [[nodiscard]] bool has(const Ends& e) const;
  void grow(const Ends& ends, const arith::Plain& at, std::uint32_t beyond);

  const Difference& of_;
  std::array<std::byte, 24576> stack_;
  std::pmr::monotonic_buffer_resource memory_{stack_.data(), stack_.size()};
  std::pmr::vector<Point> points_{&memory_};
  std::pmr::vector<Facet> facets_{&memory_};
  std::pmr::vector<std::uint32_t> seen_{&memory_};
  struct Edge {
    std::uint32_t from, to, outer, made;
  };
  std::pmr::vector<Edge> horizon_{&memory_};
  double size_ = 0;  // the largest coordinate
  bool is_sound_ = true;
};

}  // namespace plumb::query::parting
