#include "plumb/query/overlap/lattice2.hpp"

#include <algorithm>
#include <bit>
#include <string>

namespace plumb {
namespace {

using P = LatticePoint<2>;

/// The tests over one orient2d, whose arithmetic is chosen, and over the order of words.
template <class Orient>
class Tests {
 public:
  Tests(const Orient& orient, int bits)
      : orient_(orient), words_are_doubles_(bits > arith::lattice_word::double_bits) {}

  Relation relate(const LatticeSegment2& s, const LatticeSegment2& t) const {
    const Sign c = orient_(s.a, s.b, t.a), d = orient_(s.a, s.b, t.b);
    if (c * d == Sign::positive) return Relation::disjoint;
    const Sign a = orient_(t.a, t.b, s.a), b = orient_(t.a, t.b, s.b);
    if (a * b == Sign::positive) return Relation::disjoint;
    if (c != Sign::zero || d != Sign::zero || a != Sign::zero || b != Sign::zero) {
      // A point off the other line was parted from it above: its two signs are the same.
      return c * d == Sign::negative && a * b == Sign::negative ? Relation::overlapping : Relation::touching;
    }
    return relate_on_line(s, t);
  }

  Location locate(const LatticeSegment2& s, const P& p) const {
    if (orient_(s.a, s.b, p) != Sign::zero) return Location::outside;
    return within(p, s.a, s.b) ? Location::boundary : Location::outside;
  }

  Location locate(const LatticeTriangle2& t, const P& p) const {
    const Sign turn = orient_(t.a, t.b, t.c);
    const Sign a = orient_(t.b, t.c, p), b = orient_(t.c, t.a, p), c = orient_(t.a, t.b, p);
    if (turn == Sign::zero) {
      if (a != Sign::zero || b != Sign::zero || c != Sign::zero) return Location::outside;
      const bool on = within(p, t.a, t.b) || within(p, t.b, t.c) || within(p, t.c, t.a);
      return on ? Location::boundary : Location::outside;
    }
    if (a * turn == Sign::negative || b * turn == Sign::negative || c * turn == Sign::negative)
      return Location::outside;
    return a == Sign::zero || b == Sign::zero || c == Sign::zero ? Location::boundary : Location::inside;
  }

  Location locate(std::span<const P> chain, const P& p) const {
    require_stamps(chain, p);
    bool odd = false;
    const P* a = &chain.back();
    for (const P& b : chain) {
      const int from = compare(*a, p, 1), to = compare(b, p, 1);
      if (from == 0 && to == 0) {
        if (compare(*a, p, 0) * compare(b, p, 0) <= 0) return Location::boundary;
      } else if (from * to <= 0) {
        const Sign side = orient_(*a, b, p);
        if (side == Sign::zero) return Location::boundary;
        if ((from <= 0) != (to <= 0)) odd ^= (side == Sign::positive) == (from <= 0);
      }
      a = &b;
    }
    return odd ? Location::inside : Location::outside;
  }

 private:
  [[nodiscard]] int compare(const P& a, const P& b, std::size_t axis) const {
    const std::uint64_t x = a.words()[axis], y = b.words()[axis];
    const auto order = [](auto u, auto v) { return static_cast<int>(u > v) - static_cast<int>(u < v); };
    if (words_are_doubles_) return order(std::bit_cast<double>(x), std::bit_cast<double>(y));
    return order(arith::lattice_word::integer(x), arith::lattice_word::integer(y));
  }
  [[nodiscard]] int order(const P& a, const P& b) const {
    const int x = compare(a, b, 0);
    return x != 0 ? x : compare(a, b, 1);
  }
  /// Of points of one line: is p between a and b, or one of them?
  [[nodiscard]] bool within(const P& p, const P& a, const P& b) const { return order(a, p) * order(p, b) >= 0; }
  /// Edges beside the point are passed over without a sign: the sign looks at the stamps otherwise.
  void require_stamps(std::span<const P> chain, const P& p) const {
    (void)orient_(p, p, p);
    for (const P& v : chain) {
      if (v.stamp() != p.stamp()) (void)orient_(v, v, p);
    }
  }

  Relation relate_on_line(const LatticeSegment2& s, const LatticeSegment2& t) const {
    const auto least = [&](const LatticeSegment2& x) { return order(x.a, x.b) <= 0 ? x.a : x.b; };
    const auto most = [&](const LatticeSegment2& x) { return order(x.a, x.b) <= 0 ? x.b : x.a; };
    const P from = order(least(s), least(t)) < 0 ? least(t) : least(s);
    const P to = order(most(s), most(t)) < 0 ? most(s) : most(t);
    const int way = order(from, to);
    if (way != 0) return way < 0 ? Relation::overlapping : Relation::disjoint;
    const auto holds_inside = [&](const LatticeSegment2& x) {  // a point is its own inside
      return order(x.a, x.b) == 0 || (order(x.a, from) != 0 && order(x.b, from) != 0);
    };
    return holds_inside(s) && holds_inside(t) ? Relation::overlapping : Relation::touching;
  }

  const Orient& orient_;
  bool words_are_doubles_;
};

template <class Ask>
auto ask(const Kernel& kernel, const Ask& question) {
  return kernel.with<predicates::Orient2d>(
      [&](const auto& orient) { return question(Tests(orient, kernel.lattice().bits)); });
}

void require_chain(std::span<const P> polygon) {
  if (polygon.size() >= 3) return;
  throw InvalidShape(std::string("LatticeTests2::locate: polygon has ")
                         .append(std::to_string(polygon.size()))
                         .append(" vertices; a polygon has three at least"));
}
void require_equal(std::string_view name, std::size_t have, std::size_t out) {
  if (have == out) return;
  throw UnequalLengths(std::string("LatticeTests2: ")
                           .append(name)
                           .append(" has ")
                           .append(std::to_string(have))
                           .append(" elements, out has ")
                           .append(std::to_string(out)));
}

}  // namespace

Relation LatticeTests2::relate(const LatticeSegment2& s, const LatticeSegment2& t) const {
  return ask(*kernel_, [&](const auto& tests) { return tests.relate(s, t); });
}
Location LatticeTests2::locate(const LatticeSegment2& segment, const P& p) const {
  return ask(*kernel_, [&](const auto& tests) { return tests.locate(segment, p); });
}
Location LatticeTests2::locate(const LatticeTriangle2& triangle, const P& p) const {
  return ask(*kernel_, [&](const auto& tests) { return tests.locate(triangle, p); });
}
Location LatticeTests2::locate(std::span<const P> polygon, const P& p) const {
  require_chain(polygon);
  return ask(*kernel_, [&](const auto& tests) { return tests.locate(polygon, p); });
}

void LatticeTests2::relate(std::span<const LatticeSegment2> s, std::span<const LatticeSegment2> t,
                           std::span<Relation> out) const {
  require_equal("s", s.size(), out.size());
  require_equal("t", t.size(), out.size());
  ask(*kernel_, [&](const auto& tests) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = tests.relate(s[i], t[i]);
  });
}
void LatticeTests2::locate(const LatticeTriangle2& triangle, std::span<const P> p, std::span<Location> out) const {
  require_equal("p", p.size(), out.size());
  ask(*kernel_, [&](const auto& tests) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = tests.locate(triangle, p[i]);
  });
}
void LatticeTests2::locate(std::span<const P> polygon, std::span<const P> p, std::span<Location> out) const {
  require_chain(polygon);
  require_equal("p", p.size(), out.size());
  ask(*kernel_, [&](const auto& tests) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = tests.locate(polygon, p[i]);
  });
}

}  // namespace plumb
