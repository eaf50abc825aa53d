#include "lab/trial/exact_meet.hpp"

#include <algorithm>

namespace plumb::lab::trial {
namespace {

bool is_zero(const IntegerVec& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

IntegerVec normal_of(const IntegerTriangle& t) { return cross(IntegerVec(t[1] - t[0]), IntegerVec(t[2] - t[0])); }

/// Neither does one turn left and another right.
bool unmixed(int a, int b, int c) { return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0); }

/// Signs of the volumes that the line through p along d spans with the three edges: it passes through, or beside.
bool line_passes(const IntegerVec& p, const IntegerVec& d, const IntegerTriangle& t) {
  const IntegerVec a = t[0] - p, b = t[1] - p, c = t[2] - p;
  return unmixed(sgn(dot(d, cross(a, b))), sgn(dot(d, cross(b, c))), sgn(dot(d, cross(c, a))));
}

/// Of a point in the plane of a triangle with the normal n, which is not zero.
bool holds(const IntegerTriangle& t, const IntegerVec& n, const IntegerVec& p) { return line_passes(p, n, t); }

std::optional<Quotient> first_meeting(const IntegerVec& o, const IntegerVec& d, const IntegerVec& p,
                                      const IntegerVec& q) {
  const IntegerVec u = q - p, w = p - o, m = cross(d, u);
  if (!is_zero(m)) {
    if (dot(w, m) != 0) return {};
    const mpz_class whole = dot(m, m), t = dot(cross(w, u), m), s = dot(cross(w, d), m);
    if (t < 0 || s < 0 || s > whole) return {};
    return Quotient{t, whole};
  }
  if (!is_zero(cross(d, w))) return {};
  const mpz_class a = dot(w, d), b = dot(IntegerVec(q - o), d);
  if (a < 0 && b < 0) return {};
  return Quotient{a < 0 || b < 0 ? mpz_class(0) : std::min(a, b), dot(d, d)};
}

bool segments_meet(const IntegerVec& p, const IntegerVec& q, const IntegerVec& r, const IntegerVec& s) {
  const IntegerVec u = q - p, v = s - r, w = r - p, m = cross(u, v);
  if (!is_zero(m)) {
    if (dot(w, m) != 0) return false;
    const mpz_class whole = dot(m, m), along_u = dot(cross(w, v), m), along_v = dot(cross(w, u), m);
    return along_u >= 0 && along_u <= whole && along_v >= 0 && along_v <= whole;
  }
  const IntegerVec line = is_zero(u) ? v : u;
  if (is_zero(line)) return is_zero(w);
  if (!is_zero(cross(w, line))) return false;
  const mpz_class to_q = dot(u, line), to_r = dot(w, line), to_s = dot(IntegerVec(s - p), line);
  const mpz_class zero = 0;
  return std::max(std::min(zero, to_q), std::min(to_r, to_s)) <= std::min(std::max(zero, to_q), std::max(to_r, to_s));
}

bool meets_an_edge(const IntegerVec& p, const IntegerVec& q, const IntegerTriangle& t) {
  return segments_meet(p, q, t[0], t[1]) || segments_meet(p, q, t[1], t[2]) || segments_meet(p, q, t[2], t[0]);
}

bool segment_meets(const IntegerVec& p, const IntegerVec& q, const IntegerTriangle& t, const IntegerVec& n) {
  if (is_zero(n)) return meets_an_edge(p, q, t);
  const int sp = sgn(dot(n, IntegerVec(p - t[0]))), sq = sgn(dot(n, IntegerVec(q - t[0])));
  if (sp * sq > 0) return false;
  if (sp == 0 && sq == 0) return holds(t, n, p) || meets_an_edge(p, q, t);
  return line_passes(p, q - p, t);
}

RationalVec rational(const IntegerVec& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

}  // namespace

std::optional<Quotient> first_meeting(const IntegerVec& o, const IntegerVec& d, const IntegerTriangle& t) {
  const IntegerVec n = normal_of(t);
  const mpz_class rise = dot(n, d), height = dot(n, IntegerVec(t[0] - o));
  if (rise != 0) {
    if (sgn(height) * sgn(rise) < 0 || !line_passes(o, d, t)) return {};
    return rise > 0 ? Quotient{height, rise} : Quotient{-height, -rise};
  }
  if (height != 0) return {};
  if (!is_zero(n) && holds(t, n, o)) return Quotient{0, 1};
  std::optional<Quotient> least;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto at = first_meeting(o, d, t[i], t[(i + 1) % 3]);
    if (at && (!least || *at < *least)) least = at;
  }
  return least;
}

// Where they meet, an edge of one meets the other: the ends of what they have in common lie on edges, or one is within
// the other.
bool triangles_meet(const IntegerTriangle& a, const IntegerTriangle& b) {
  const IntegerVec n = normal_of(a), m = normal_of(b);
  const auto beside = [](const IntegerTriangle& t, const IntegerVec& normal, const IntegerTriangle& other) {
    const int first = sgn(dot(normal, IntegerVec(other[0] - t[0])));
    return first != 0 && first == sgn(dot(normal, IntegerVec(other[1] - t[0]))) &&
           first == sgn(dot(normal, IntegerVec(other[2] - t[0])));
  };
  if (beside(a, n, b) || beside(b, m, a)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_meets(a[i], a[(i + 1) % 3], b, m) || segment_meets(b[i], b[(i + 1) % 3], a, n)) return true;
  }
  return false;
}

mpq_class square_distance(const IntegerVec& p, const IntegerTriangle& t) {
  return square_distance(rational(p), rational(t[0]), rational(t[1]), rational(t[2]));
}

mpq_class square_distance(const IntegerTriangle& a, const IntegerTriangle& b) {
  if (triangles_meet(a, b)) return 0;
  mpq_class least = square_distance(a[0], b);
  const auto take = [&least](const mpq_class& square) {
    if (square < least) least = square;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    take(square_distance(a[i], b));
    take(square_distance(b[i], a));
    for (std::size_t k = 0; k < 3; ++k) {
      take(square_distance_of_segments(rational(a[i]), rational(a[(i + 1) % 3]), rational(b[k]),
                                       rational(b[(k + 1) % 3])));
    }
  }
  return least;
}

}  // namespace plumb::lab::trial
