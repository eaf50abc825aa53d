// The same statements over exact numbers: a vector of space whose numbers are integers or rationals, an axis a lane.
//
// Laws: every sign is certain.  What certify/three_axes.hpp has for lanes of doubles these have, number by number.
// Source: none needed.
// Cost: that of the numbers.
#pragma once

#include <array>
#include <stdexcept>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/certify/world.hpp"

namespace plumb::certify::exact_axes {

template <class T>
struct Axes {
  T x, y, z;
};
template <class T>
Axes(T, T, T) -> Axes<T>;

template <class T, class F>
auto each(const Axes<T>& a, F f) {
  return Axes{f(a.x), f(a.y), f(a.z)};
}
template <class T, class U, class F>
auto each(const Axes<T>& a, const Axes<U>& b, F f) {
  return Axes{f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}

template <class T, class U>
auto operator+(const Axes<T>& a, const Axes<U>& b) {
  return each(a, b, [](const T& s, const U& t) { return s + t; });
}
template <class T, class U>
auto operator-(const Axes<T>& a, const Axes<U>& b) {
  return each(a, b, [](const T& s, const U& t) { return s - t; });
}
template <class T, class U>
auto operator*(const Axes<T>& a, const Axes<U>& b) {
  return each(a, b, [](const T& s, const U& t) { return s * t; });
}
template <class S, class T, class U>
auto plus_product(const Axes<S>& sum, const Axes<T>& a, const Axes<U>& b) {
  return sum + a * b;
}
template <class S, class T, class U>
auto minus_product(const Axes<S>& sum, const Axes<T>& a, const Axes<U>& b) {
  return sum - a * b;
}
template <class T, class TT, class U, class UT>
auto crossed(const Axes<T>& a, const Axes<TT>& a_turned, const Axes<U>& b, const Axes<UT>& b_turned) {
  return a * b_turned - a_turned * b;
}
template <class T>
Axes<T> magnitude(const Axes<T>& a) {
  return each(a, [](const T& s) { return magnitude(s); });
}
template <class T>
Axes<T> negated(const Axes<T>& a) {
  return each(a, [](const T& s) {
    if constexpr (requires { -s; }) {
      return -s;
    } else {
      return (s - s) - s;
    }
  });
}
template <class T>
auto twice(const Axes<T>& a) {
  return a + a;
}
template <class T>
Axes<T> turned(const Axes<T>& a) {
  return {a.y, a.z, a.x};
}
template <class T>
Axes<T> turned_back(const Axes<T>& a) {
  return {a.z, a.x, a.y};
}
template <class T>
auto total(const Axes<T>& a) {
  const auto sum = a.x + a.y + a.z;
  return Axes{sum, sum, sum};
}
template <int lane, class T>
Axes<T> spread(const Axes<T>& a) {
  const T& one = lane == 0 ? a.x : lane == 1 ? a.y : a.z;
  return {one, one, one};
}
template <class T>
struct ColumnsOf {
  Axes<T> x, y, z;
};
template <class T>
ColumnsOf<T> transposed(const Axes<T>& a, const Axes<T>& b, const Axes<T>& c) {
  return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
}
/// Lane by lane: of doubles as given, of signs, of what is judged.
template <class T>
bool is_less(const T& a, const T& b) {
  if constexpr (requires { a < b; }) {
    return a < b;
  } else {
    return (a - b).sign() == Sign::negative;
  }
}
template <class T>
Axes<T> larger(const Axes<T>& a, const Axes<T>& b) {
  return each(a, b, [](const T& s, const T& t) { return is_less(s, t) ? t : s; });
}
template <class T>
Axes<T> smaller(const Axes<T>& a, const Axes<T>& b) {
  return each(a, b, [](const T& s, const T& t) { return is_less(t, s) ? t : s; });
}
inline Axes<bool> operator&(const Axes<bool>& a, const Axes<bool>& b) { return {a.x && b.x, a.y && b.y, a.z && b.z}; }
/// Bit i: axis i.
inline unsigned bits(const Axes<bool>& a) { return (a.x ? 1U : 0U) | (a.y ? 2U : 0U) | (a.z ? 4U : 0U); }

/// N is made of a double.  Where its numbers have a range, nothing is certain of what left it.
template <class N, WorldKind which>
class ExactAxes {
 public:
  ExactAxes() {
    if constexpr (requires { N::clear_range(); }) N::clear_range();
  }
  static constexpr WorldKind kind = which;
  static constexpr bool on_lattice = true;
  using Given = Axes<double>;

  static Given given(const Point3& p) { return {p.x, p.y, p.z}; }
  static Given given(const Vector3& v) { return {v.x, v.y, v.z}; }
  static Given given(double x, double y, double z) { return {x, y, z}; }
  template <std::size_t scale = 0>
  static Axes<N> number(const Given& a) {
    return each(a, [](double x) { return N(x); });
  }
  template <std::size_t scale = 0>
  static Axes<N> difference(const Given& b, const Given& a) {
    return number(b) - number(a);
  }
  /// Throws std::logic_error where it is not so.
  template <std::size_t scale = 0>
  static Axes<N> difference_within(const Given& b, const Given& a, const Axes<N>& c, const Axes<N>& d) {
    const Axes<N> between = difference(b, a);
    const bool is_beyond = &c == &d || is_any(negative((magnitude(c) + magnitude(d)) - magnitude(between)));
    if (is_beyond && is_in_range())
      throw std::logic_error("a difference is larger than the two that it is said to lie within");
    return between;
  }
  template <std::size_t scale = 0>
  static Axes<N> number(const Vector3& v) {
    return number(given(v));
  }
  template <std::size_t over>
  static Axes<N> weight(const Given& a) {
    return number(a);
  }
  static Axes<Sign> order(const Given& b, const Given& a) {
    return each(b, a, [](double s, double t) { return static_cast<Sign>((s > t) - (s < t)); });
  }
  static Axes<Sign> unless(const Axes<bool>& is_so, const Axes<Sign>& x) {
    return each(is_so, x, [](bool so, Sign s) { return so ? Sign::negative : s; });
  }

  static Axes<Sign> signs(const Axes<N>& a) {
    return each(a, [](const N& x) { return x.sign(); });
  }
  static Axes<Sign> signs(const Axes<Sign>& a) { return a; }
  static Axes<bool> positive(const auto& a) {
    return each(signs(a), [](Sign s) { return s == Sign::positive; });
  }
  static Axes<bool> negative(const auto& a) {
    return each(signs(a), [](Sign s) { return s == Sign::negative; });
  }
  static Axes<bool> zero(const auto& a) {
    return each(signs(a), [](Sign s) { return s == Sign::zero; });
  }
  static bool is_any(const Axes<bool>& a) { return a.x || a.y || a.z; }
  static bool is_all(const Axes<bool>& a) { return a.x && a.y && a.z; }

  static Axes<bool> not_negative(const auto& a) {
    return each(signs(a), [](Sign s) { return s != Sign::negative; });
  }
  static Axes<bool> is_real(const auto&) { return {true, true, true}; }
  void require(const Axes<bool>& a) { open_ = open_ || !is_all(a); }
  void leave_open() { open_ = true; }
  [[nodiscard]] bool certain() const { return !open_ && is_in_range(); }

  class Gaps {
   public:
    explicit Gaps(ExactAxes& world) : world_(world) {}

    void heed(const auto& gap, const auto&... parts) {
      const Axes<Sign> s = signs(gap);
      Axes<bool> is_none{false, false, false};
      if constexpr (sizeof...(parts) != 0) is_none = (zero(parts) & ...);
      heed_one(s.x, is_none.x), heed_one(s.y, is_none.y), heed_one(s.z, is_none.z);
    }
    void heed_from(const auto& gap, const auto& way, const auto&...) {
      const Axes<Sign> s = signs(gap);
      const Axes<bool> is_none = zero(way);
      heed_one(s.x, is_none.x), heed_one(s.y, is_none.y), heed_one(s.z, is_none.z);
    }
    void heed_ahead(const auto& way, const auto& up, const auto& down) {
      const Axes<Sign> at = signs(way), u = signs(up), d = signs(down);
      heed_ahead_one(at.x, u.x, d.x), heed_ahead_one(at.y, u.y, d.y), heed_ahead_one(at.z, u.z, d.z);
    }
    /// Axes that are zero were passed over, and those left are all only if this is so.
    void need(const Axes<bool>& have_inside) {
      if (!apart_) world_.require(have_inside);
    }
    void heed_above(const auto& gap) { apart_ = apart_ || is_any(positive(gap)); }
    [[nodiscard]] bool is_apart() const { return apart_; }

    template <class Answer>
    Answer relation(const auto&... have_inside) {
      if (apart_) return static_cast<Answer>(-1);
      if (!level_) return static_cast<Answer>(1);
      if (!(is_all(positive(have_inside)) && ...)) world_.leave_open();
      return static_cast<Answer>(0);
    }

   private:
    void heed_ahead_one(Sign way, Sign up, Sign down) {
      if (way != Sign::negative) heed_one(up, false);
      if (way != Sign::positive) heed_one(down, false);
    }
    void heed_one(Sign s, bool is_none) {
      apart_ = apart_ || s == Sign::positive;
      level_ = level_ || (s == Sign::zero && !is_none);
    }

    ExactAxes& world_;
    bool apart_ = false, level_ = false;
  };
  Gaps gaps() { return Gaps(*this); }

 private:
  static bool is_in_range() {
    if constexpr (requires { N::left_range(); }) return !N::left_range();
    return true;
  }

  bool open_ = false;
};

}  // namespace plumb::certify::exact_axes
