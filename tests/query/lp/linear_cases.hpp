// Which linear programs must every solver get right?  Small ones of every kind, degenerate ones above all.
//
// Laws: case `index` of a class is the same on every machine; its line replays a failure.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "plumb/arith/gmp.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/lp/linear_program.hpp"

namespace plumb::linear_cases {

enum class Class : unsigned char {
  lattice,
  parallel,
  repeated,
  through_one_point,
  tangent_to_one_sphere,
  uniform,
  extreme_exponents,
  thin,  // slabs that are an ulp thick, or an ulp less than nothing
  boxed
};
inline constexpr std::array all_classes{Class::lattice,
                                        Class::parallel,
                                        Class::repeated,
                                        Class::through_one_point,
                                        Class::tangent_to_one_sphere,
                                        Class::uniform,
                                        Class::extreme_exponents,
                                        Class::thin,
                                        Class::boxed};

template <std::size_t D>
struct Types;
template <>
struct Types<2> {
  using Vector = Vector2;
  using Halfspace = Halfspace2;
};
template <>
struct Types<3> {
  using Vector = Vector3;
  using Halfspace = Halfspace3;
};

inline Vector2 vector_of(const std::array<double, 2>& n) { return {n[0], n[1]}; }
inline Vector3 vector_of(const std::array<double, 3>& n) { return {n[0], n[1], n[2]}; }
inline std::array<double, 2> array_of(const Vector2& v) { return {v.x, v.y}; }
inline std::array<double, 3> array_of(const Vector3& v) { return {v.x, v.y, v.z}; }

template <std::size_t D>
struct Program {
  typename Types<D>::Vector direction{};
  std::vector<typename Types<D>::Halfspace> halfspaces;
};

class Maker {
 public:
  Maker(Class c, std::uint64_t index)
      : class_(c), index_(index), entropy_(9400 + static_cast<std::uint64_t>(c), index) {}

  template <std::size_t D>
  Program<D> program() {
    Program<D> p;
    const std::size_t n = static_cast<std::size_t>(entropy_.below(4) == 0 ? entropy_.below(4) : 2 + entropy_.below(9));
    const std::array<double, D> center = lattice_vector<D>(3);
    for (std::size_t i = 0; i < n; ++i) add(p, center);
    if (class_ == Class::boxed || (class_ == Class::uniform && entropy_.coin())) {
      for (std::size_t k = 0; k < D; ++k) {
        for (const double way : {-1.0, 1.0}) {
          std::array<double, D> axis{};
          axis[k] = way;
          p.halfspaces.push_back({vector_of(axis), static_cast<double>(2 + entropy_.below(3))});
        }
      }
    }
    const std::uint64_t which = entropy_.below(8);
    std::array<double, D> d = class_ == Class::uniform ? uniform_vector<D>() : lattice_vector<D>(2);
    if (which == 0) d = {};
    if (which == 1 && !p.halfspaces.empty()) d = array_of(p.halfspaces[0].normal);
    p.direction = vector_of(d);
    return p;
  }

  Entropy& entropy() { return entropy_; }

  /// The line that replays a failure.
  template <std::size_t D>
  [[nodiscard]] std::string about(const Program<D>& p) const {
    std::ostringstream out;
    out << "class " << static_cast<int>(class_) << " index " << index_ << std::hexfloat << "\ndirection";
    for (const double x : array_of(p.direction)) out << ' ' << x;
    for (const auto& h : p.halfspaces) {
      out << "\n ";
      for (const double x : array_of(h.normal)) out << ' ' << x;
      out << " <= " << h.offset;
    }
    return out.str();
  }

 private:
  double lattice(std::int64_t most) { return static_cast<double>(entropy_.within(most)); }
  double uniform() { return static_cast<double>(entropy_.bits(53)) * 0x1p-52 - 1; }
  template <std::size_t D>
  std::array<double, D> lattice_vector(std::int64_t most) {
    std::array<double, D> r{};
    for (double& x : r) x = lattice(most);
    return r;
  }
  template <std::size_t D>
  std::array<double, D> uniform_vector() {
    std::array<double, D> r{};
    for (double& x : r) x = uniform();
    return r;
  }
  /// Of a whole length.
  template <std::size_t D>
  std::array<double, D> pythagorean(double& length) {
    static constexpr std::array<std::array<double, 4>, 5> in_space{
        {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {3, 4, 0, 5}, {1, 0, 0, 1}}};
    static constexpr std::array<std::array<double, 3>, 3> in_plane{{{3, 4, 5}, {5, 12, 13}, {1, 0, 1}}};
    std::array<double, D> r{};
    if constexpr (D == 3) {
      const auto& q = in_space[entropy_.below(in_space.size())];
      r = {q[0], q[1], q[2]}, length = q[3];
    } else {
      const auto& q = in_plane[entropy_.below(in_plane.size())];
      r = {q[0], q[1]}, length = q[2];
    }
    for (std::size_t k = D; k-- > 1;) std::swap(r[k], r[entropy_.below(k + 1)]);
    for (double& x : r) x = entropy_.coin() ? -x : x;
    return r;
  }

  template <std::size_t D>
  void add(Program<D>& p, const std::array<double, D>& center) {
    std::array<double, D> n = lattice_vector<D>(2);
    double offset = lattice(3);
    double length = 0;
    const bool is_first = p.halfspaces.empty();
    const auto dot = [&] {
      double sum = 0;
      for (std::size_t k = 0; k < D; ++k) sum += n[k] * center[k];
      return sum;
    };
    switch (class_) {
      case Class::lattice:
        break;
      case Class::parallel:
        if (!is_first) {
          n = array_of(p.halfspaces[entropy_.below(std::min<std::size_t>(2, p.halfspaces.size()))].normal);
          const double by = lattice(2);
          for (double& x : n) x *= by;
          if (entropy_.coin()) offset += 6;
        }
        break;
      case Class::repeated:
        if (!is_first && entropy_.below(3) != 0) {
          const auto& h = p.halfspaces[entropy_.below(p.halfspaces.size())];
          const double by = static_cast<double>(1 + entropy_.below(3));
          n = array_of(h.normal);
          for (double& x : n) x *= by;
          offset = h.offset * by;
        }
        break;
      case Class::through_one_point:
        offset = dot();
        break;
      case Class::tangent_to_one_sphere:
        n = pythagorean<D>(length);
        offset = dot() + 2 * length;
        break;
      case Class::uniform:
        n = uniform_vector<D>();
        offset = uniform() + (entropy_.coin() ? 1 : 0);
        break;
      case Class::extreme_exponents: {
        const int e = static_cast<int>(entropy_.within(900)), f = static_cast<int>(entropy_.within(60));
        for (double& x : n) x = std::ldexp(x, e);
        offset = std::ldexp(offset, e + f);
        break;
      }
      case Class::thin:
        if (entropy_.coin() && !is_first) {
          const auto& h = p.halfspaces[entropy_.below(p.halfspaces.size())];
          n = array_of(h.normal);
          for (double& x : n) x = -x;
          offset = -std::nextafter(h.offset, entropy_.below(3) == 0 ? -1e9 : 1e9);
        } else {
          offset = uniform();
        }
        break;
      case Class::boxed:
        n = lattice_vector<D>(3);
        offset = lattice(5);
        break;
    }
    p.halfspaces.push_back({vector_of(n), offset});
  }

  Class class_;
  std::uint64_t index_;
  Entropy entropy_;
};

}  // namespace plumb::linear_cases
