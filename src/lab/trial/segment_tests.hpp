// Do two segments meet, and where do they cross?  The two ways of textbooks, over any number.
//
// Laws: (1) over a number that does not round, and without an epsilon, meet_by_signs is right about all segments; (2)
// meet_by_parameters and crossing are right about all that are not parallel, and say no of parallel ones, as such code
// does.  What is at most epsilon counts as zero.
// Source: RTCD 5.1.9.1.
// Cost: tens of operations.
#pragma once

#include <array>
#include <optional>

namespace plumb::lab::trial {

template <class T>
struct Place {
  T x, y;
  friend bool operator<(const Place& a, const Place& b) { return a.x < b.x || (!(b.x < a.x) && a.y < b.y); }
};

template <class T>
struct Segment {
  Place<T> a, b;
};

/// Twice the area of a, b, c, positive when they turn left.
template <class T>
T area(const Place<T>& a, const Place<T>& b, const Place<T>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

template <class T>
int side(const Segment<T>& s, const Place<T>& p, const T& epsilon) {
  const T x = area(s.a, s.b, p);
  return static_cast<int>(x > epsilon) - static_cast<int>(x < -epsilon);
}

/// Of a point on its line: is it on the segment?
template <class T>
bool within_box(const Segment<T>& s, const Place<T>& p) {
  const auto between = [](const T& x, const T& y, const T& z) { return !((z < x && z < y) || (x < z && y < z)); };
  return between(s.a.x, s.b.x, p.x) && between(s.a.y, s.b.y, p.y);
}

template <class T>
bool meet_by_signs(const Segment<T>& s, const Segment<T>& t, const T& epsilon) {
  const int sa = side(s, t.a, epsilon), sb = side(s, t.b, epsilon), ta = side(t, s.a, epsilon),
            tb = side(t, s.b, epsilon);
  if (sa * sb < 0 && ta * tb < 0) return true;
  return (sa == 0 && within_box(s, t.a)) || (sb == 0 && within_box(s, t.b)) || (ta == 0 && within_box(t, s.a)) ||
         (tb == 0 && within_box(t, s.b));
}

/// How far along s and along t the lines cross, 0 and 1 being the ends; none where they are parallel.
template <class T>
std::optional<std::array<T, 2>> parameters(const Segment<T>& s, const Segment<T>& t, const T& epsilon) {
  const T rx = s.b.x - s.a.x, ry = s.b.y - s.a.y, qx = t.b.x - t.a.x, qy = t.b.y - t.a.y;
  const T d = rx * qy - ry * qx;
  if (!(d > epsilon) && !(d < -epsilon)) return std::nullopt;
  const T wx = t.a.x - s.a.x, wy = t.a.y - s.a.y;
  return std::array<T, 2>{T((wx * qy - wy * qx) / d), T((wx * ry - wy * rx) / d)};
}

template <class T>
bool meet_by_parameters(const Segment<T>& s, const Segment<T>& t, const T& epsilon) {
  const auto at = parameters(s, t, epsilon);
  if (!at) return false;
  const T end = T(1) + epsilon;
  return !((*at)[0] < -epsilon) && !(end < (*at)[0]) && !((*at)[1] < -epsilon) && !(end < (*at)[1]);
}

/// Where the lines cross, if they are not parallel.
template <class T>
std::optional<Place<T>> crossing(const Segment<T>& s, const Segment<T>& t, const T& epsilon) {
  const auto at = parameters(s, t, epsilon);
  if (!at) return std::nullopt;
  return Place<T>{T(s.a.x + (*at)[0] * (s.b.x - s.a.x)), T(s.a.y + (*at)[0] * (s.b.y - s.a.y))};
}

}  // namespace plumb::lab::trial
