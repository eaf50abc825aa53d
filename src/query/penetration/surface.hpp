// Expanding polytope: a convex surface of triangles between points of a difference, which grows by one point after the
// other.  Beneath-beyond, in exact signs.
//
// Laws: the triangles are the boundary of the hull of the points taken; each is counterclockwise seen from outside, and
// knows the three beyond its edges; neighbors may lie in one plane.  A triangle that is no longer there keeps its
// number until another takes it.
// Source: van den Bergen 2001, "Proximity queries and penetration depth computation on 3D game objects"; RTCD 9.5;
// Seidel 1981 (beneath-beyond).
// Cost: a sign for each triangle that a point sees and each beside them; 4 KiB of the stack, and what outgrows it.
#pragma once

#include <memory_resource>
#include <vector>

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

struct Facet {
  std::array<std::uint32_t, 3> corner;  // numbers of points
  std::array<std::uint32_t, 3> across;  // the facet beyond the edge from corner[i] to the next
  Vec<Running> normal;
  Running height;                      // of the plane over the origin, times the normal's length
  Running measure;                     // what is to be least; what is certain of it, and a guess
  std::uint32_t passage = 1;           // how a way that is asked for leads through it; 0: none does
  Sign side = Sign::positive;          // of the height
  const Kept* exact_normal = nullptr;  // where it was asked for
  bool is_there = true;
  bool is_supported = false;  // no point of the difference lies before it
};

class Surface {
 public:
  explicit Surface(const Difference& of) : of_(of), points_(&memory_), facets_(&memory_), free_(&memory_) {
    points_.reserve(64), facets_.reserve(160), free_.reserve(160);
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  /// Of four points that are not in one plane.
  void start(const std::array<Ends, 4>& corners);

  [[nodiscard]] std::size_t size() const { return facets_.size(); }
  [[nodiscard]] Facet& operator[](std::size_t f) { return facets_[f]; }
  [[nodiscard]] const Facet& operator[](std::size_t f) const { return facets_[f]; }
  [[nodiscard]] const Ends& ends(std::uint32_t point) const { return points_[point].ends; }

  template <class T>
  [[nodiscard]] Vec<T> at(std::uint32_t point) {
    Point& p = points_[point];
    if constexpr (std::is_same_v<T, Running>) {
      return p.at;
    } else if constexpr (std::is_same_v<T, StackDyadic>) {
      if (p.exact == nullptr) p.exact = kept(of_.at<T>(p.ends));
      return p.exact->get();
    } else {
      return of_.at<T>(p.ends);
    }
  }
  template <class T>
  [[nodiscard]] PlaneOf<T> plane(Facet& f) {
    if constexpr (std::is_same_v<T, Running>) {
      return {f.normal, at<T>(f.corner[0])};
    } else if constexpr (std::is_same_v<T, StackDyadic>) {
      if (f.exact_normal == nullptr) {
        const PlaneOf<T> p(at<T>(f.corner[0]), at<T>(f.corner[1]), at<T>(f.corner[2]));
        f.exact_normal = kept(p.normal);
        return p;
      }
      return {f.exact_normal->get(), at<T>(f.corner[0])};
    } else {
      return {at<T>(f.corner[0]), at<T>(f.corner[1]), at<T>(f.corner[2])};
    }
  }
  [[nodiscard]] Sign height_sign(Facet& f);

  [[nodiscard]] std::array<Ends, 3> ends_of(const Facet& f) const {
    return {ends(f.corner[0]), ends(f.corner[1]), ends(f.corner[2])};
  }
  [[nodiscard]] KnownPlane known_plane(const Facet& f) const { return {of_, ends_of(f)}; }
  [[nodiscard]] bool is_beyond(const Ends& point, Facet& f) {
    return is_beyond(point, of_.at<Running>(point), f, [&]<class T>() { return of_.at<T>(point); });
  }

  /// Takes a point that is beyond the facet; `made` is called with the number of each new facet.
  template <class Made>
  void add(const Ends& point, std::uint32_t beyond, Made made) {
    grow(point, beyond);
    for (const std::uint32_t f : made_) made(f);
  }

 private:
  struct Point {
    Ends ends;
    Vec<Running> at;
    const Kept* exact = nullptr;  // where it was asked for
    std::uint32_t starts = 0;     // the new facet whose first edge starts here, while one point is taken
  };
  struct Edge {
    std::uint32_t from, to, outer;
  };

  /// As long as the surface; nothing is to be destroyed.
  const Kept* kept(const Vec<StackDyadic>& v) {
    return std::pmr::polymorphic_allocator<>(&memory_).new_object<Kept>(v);
  }
  void grow(const Ends& point, std::uint32_t beyond);
  template <class At>
  [[nodiscard]] bool is_beyond(const Ends& point, const Vec<Running>& at, Facet& f, const At& exact) {
    const Unsure<Sign> s = dot(f.normal, at - points_[f.corner[0]].at).sign();
    if (s.certain()) return s.value() == Sign::positive;
    if (known_plane(f).has(point)) return false;
    return exact_sign_of([&]<class T>() -> T { return plane<T>(f).beyond(exact.template operator()<T>()); }) ==
           Sign::positive;
  }
  std::uint32_t make(std::uint32_t p, std::uint32_t q, std::uint32_t r);

  Difference of_;
  std::array<std::byte, 32768> stack_;
  std::pmr::monotonic_buffer_resource memory_{stack_.data(), stack_.size()};
  std::pmr::vector<Point> points_;
  std::pmr::vector<Facet> facets_;
  std::pmr::vector<std::uint32_t> free_, made_{&memory_}, seen_{&memory_};
  std::pmr::vector<Edge> horizon_{&memory_};
};

}  // namespace plumb::query::parting
