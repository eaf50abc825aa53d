// Which of two distances is the larger?  Distances of points from points, lines and planes, compared with one another
// or with a number.
//
// A squared distance is a ratio N / D: |ap|^2 / 1 from a point, |ab x ap|^2 / |ab|^2 from a line, (n . ap)^2 / |n|^2
// from a plane with normal n = ab x ac.  The value of a comparison is N1 D2 - N2 D1.
// Laws: swapping the two distances flips the sign; swapping the points that span a line or plane keeps that of an
// unsigned distance; common translation and positive scaling, of a number compared with as well, change nothing.
// A line or plane that its points do not span has D = N = 0: the functions of certify/compare_distance.hpp look for it.
// Source: RTCD 5.1.2.1, 3.3.3, 3.3.5.  Degree 2 to 10.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"
#include "plumb/predicates/direction.hpp"

namespace plumb::predicates {

template <class T>
constexpr auto squared(const T& x) {
  return x * x;
}
template <class T>
constexpr auto squared(const Triple<T>& u) {
  return dot(u, u);
}

template <class T>
struct Pair {
  T x, y;
};
template <class T>
Pair(T, T) -> Pair<T>;

/// From argument number `from` to argument number `to`, in the plane.
template <class T, std::size_t N>
constexpr auto difference2(const std::array<T, N>& p, std::size_t from, std::size_t to) {
  return Pair{p[2 * to] - p[2 * from], p[2 * to + 1] - p[2 * from + 1]};
}
template <class T, class U>
constexpr auto operator+(const Pair<T>& u, const Pair<U>& v) {
  return Pair{u.x + v.x, u.y + v.y};
}
template <class T, class U>
constexpr auto dot(const Pair<T>& u, const Pair<U>& v) {
  return u.x * v.x + u.y * v.y;
}
template <class T, class U>
constexpr auto cross(const Pair<T>& u, const Pair<U>& v) {
  return u.x * v.y - u.y * v.x;
}
template <class T>
constexpr auto squared(const Pair<T>& u) {
  return dot(u, u);
}

/// |ab| against |cd|.
struct CompareDistance2d {
  static constexpr std::string_view name = "compare_distance2d";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return squared(difference2(p, 0, 1)) - squared(difference2(p, 2, 3));
  }
};

struct CompareDistance3d {
  static constexpr std::string_view name = "compare_distance3d";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return squared(difference(p, 0, 1)) - squared(difference(p, 2, 3));
  }
};

/// |ab| against |ac|, whose squares differ by cb . (ab + ac): small when b and c are near to one another.
struct CompareDistanceFrom2d {
  static constexpr std::string_view name = "compare_distance_from2d";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return dot(difference2(p, 2, 1), difference2(p, 0, 1) + difference2(p, 0, 2));
  }
};

struct CompareDistanceFrom3d {
  static constexpr std::string_view name = "compare_distance_from3d";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return dot(difference(p, 2, 1), difference(p, 0, 1) + difference(p, 0, 2));
  }
};

/// |ab| against |c|, for a number c.
struct DistanceAgainst2d {
  static constexpr std::string_view name = "distance_against2d";
  static constexpr std::array arguments{2, 2, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return squared(difference2(p, 0, 1)) - squared(p[4]);
  }
};

struct DistanceAgainst3d {
  static constexpr std::string_view name = "distance_against3d";
  static constexpr std::array arguments{3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 7>& p) const {
    return squared(difference(p, 0, 1)) - squared(p[6]);
  }
};

}  // namespace plumb::predicates
