// Expanding polytope (EPA): a guess, in doubles, of a surface around the origin whose nearest facet is one of the
// difference.
//
// It begins at four points that are far out in four directions, or at four that are given; while the origin lies before
// a facet, that one is the nearest.
// Laws: nothing is certain of where it lies, nor that it is closed; of its numbers the world knows how far off they are,
// where the corners of both bodies are doubles as given.  It ends: each point of finitely many is taken once.
// Source: van den Bergen 2001.
// Cost: some 100 ns a step, 5 to 20 of them for hulls of 8 to 128 corners; some KiB of the stack, and what outgrows them.
#pragma once

#include <memory_resource>
#include <vector>

#include "query/gjk/quick_hull.hpp"
#include "query/penetration/difference.hpp"
#include "query/penetration/triangle_plane.hpp"

namespace plumb::query::parting {

class GuessedSurface {
 public:
  using World = FloatWorld<PassesBeyond>;
  using Number = decltype(std::declval<World&>().difference(0.0, 0.0));
  using Corners = std::array<std::uint32_t, 3>;
  struct Facet {
    Corners corner;
    Corners twin;  // of the edge from corner[k] to the next: the other facet's number times four, and the edge's there
    TrianglePlane<Number> plane;
    double doubt;  // what is no further beyond the plane, times the normal's length, is taken to lie in it
    bool is_there;

    Facet() {}  // NOLINT: it is made of numbers that are not yet known
  };
  struct Point {
    Ends ends;
    std::array<Number, 3> at;
    std::uint32_t starts;  // the new facet whose first edge starts here, while one point is taken
  };

  explicit GuessedSurface(const Difference& d);
  GuessedSurface(const GuessedSurface&) = delete;
  GuessedSurface& operator=(const GuessedSurface&) = delete;

  /// From points far out.
  void grow_from_far();
  /// From four points that are not in one plane.
  void grow_from(const std::array<Ends, 4>& start);

  /// Is it a surface, and the origin likely within?
  [[nodiscard]] bool is_sound() const { return is_sound_; }
  /// Has each edge of each triangle another one along it, the other way round?
  [[nodiscard]] bool is_closed() const;
  /// The square of the least distance of a facet that is likely one of the difference; below zero where the origin is
  /// likely before it.
  [[nodiscard]] double least_square() const { return best_; }
  [[nodiscard]] std::span<const Facet> facets() const { return facets_; }
  [[nodiscard]] std::array<Ends, 3> ends_of(const Facet& f) const {
    return {points_[f.corner[0]].ends, points_[f.corner[1]].ends, points_[f.corner[2]].ends};
  }

  /// Where this is so the world's judgements of the facets' numbers hold.
  [[nodiscard]] bool is_given() const { return a_.is_given() && b_.is_given(); }
  [[nodiscard]] World& world() { return world_; }
  [[nodiscard]] const QuickHull& hull(std::size_t body) const { return body == 0 ? a_ : b_; }

 private:
  struct Edge {
    std::uint32_t from, to, outer, made;
  };
  void begin();
  void run();
  [[nodiscard]] std::uint32_t nearest() const;
  [[nodiscard]] Ends farthest(const arith::Plain& n, const Ends& from) const {
    return {farthest(a_, n, from[0]), farthest(b_, n * -1, from[1])};
  }
  /// Of many corners it is near to one of the facet.
  [[nodiscard]] static std::uint32_t farthest(const QuickHull& h, const arith::Plain& n, std::uint32_t from) {
    constexpr std::uint32_t many = 64;  // a guess
    return h.size() > many ? h.farthest_from(n, from) : h.farthest(n, from);
  }
  [[nodiscard]] arith::Plain plain(const Ends& e) const { return a_.at(e[0]) - b_.at(e[1]); }
  void take(const Ends& e);
  std::uint32_t make(std::uint32_t p, std::uint32_t q, std::uint32_t r);
  void remove(std::uint32_t f);
  [[nodiscard]] bool has(const Ends& e) const;
  void grow(const Ends& ends, const arith::Plain& at, std::uint32_t beyond);

  QuickHull a_, b_;
  World world_;
  std::array<std::byte, 24576> stack_;
  std::pmr::monotonic_buffer_resource memory_{stack_.data(), stack_.size()};
  std::pmr::vector<Point> points_{&memory_};
  std::pmr::vector<Facet> facets_{&memory_};
  std::pmr::vector<double> rank_{
      &memory_};  // the distance's square, with its sign; infinity where nothing is to be done
  std::pmr::vector<std::uint32_t> free_{&memory_}, seen_{&memory_};
  std::pmr::vector<Edge> horizon_{&memory_};
  double size_ = 0;  // the largest coordinate
  double best_ = 0;
  bool is_sound_ = true;
};

}  // namespace plumb::query::parting
