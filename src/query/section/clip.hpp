// Clipping (Cyrus-Beck): which piece of an edge lies within a convex set?  The part between the last bound entered and
// the first one left.
//
// Laws: signs at vertices are exact (vertex_sign); where two bounds are crossed, which is met first is asked of the
// numbers T, and nothing is certain where they cannot tell.  Of bounds that are crossed at one place the first is
// named.
// Source: RTCD 5.3.3, 5.3.8 (Cyrus and Beck 1978; Liang and Barsky 1984).
// Cost: linear in the bounds.
#pragma once

#include <optional>

#include "query/convex/bound_value.hpp"

namespace plumb::query::meeting {

/// The signs of one set's bounds at the other's vertices, times the bounds' sides (1 where the side is 0).
class SignTable {
 public:
  /// False: all vertices are beyond one bound.
  template <std::size_t N>
  bool fill(const ConvexSet<N>& bounded_by, const ConvexSet<N>& of) {
    stride_ = of.is_exact() ? of.exact_vertices.size() : of.vertices.size();
    signs_.clear();
    signs_.reserve(stride_ * bounded_by.bounds.size());
    const bool bounded = of.is_bounded();
    for (const Bound<N>& b : bounded_by.bounds) {
      int seen = 0;  // 1: negative, 2: zero, 4: positive
      for (std::size_t v = 0; v < stride_; ++v) {
        const int s = static_cast<int>(vertex_sign(of, v, b)) * (b.side == 0 ? 1 : b.side);
        signs_.push_back(static_cast<signed char>(s));
        seen |= s < 0 ? 1 : s == 0 ? 2 : 4;
      }
      if (bounded && (seen == 4 || (b.side == 0 && seen == 1))) return false;
    }
    return true;
  }
  [[nodiscard]] int at(std::size_t bound, int vertex) const {
    return signs_[bound * stride_ + static_cast<std::size_t>(vertex)];
  }

 private:
  std::vector<signed char> signs_;
  std::size_t stride_ = 0;
};

/// Where a piece ends: at the edge's own end, or where it crosses a bound, at part / whole of the way.
template <class T>
struct End {
  bool own = true;
  int index = infinity;  // of the vertex or the bound
  T part = T(0.0), whole = T(1.0);
};

template <class T>
struct Piece {
  End<T> from, to;
  bool is_point = false;
};

/// Does the edge go up or down along this axis?  Of a set of points as given.
template <std::size_t N>
int direction_sign(const ConvexSet<N>& set, const Edge<N>& e, std::size_t axis) {
  const auto order = [](double from, double to) { return static_cast<int>(from < to) - static_cast<int>(from > to); };
  if (e.is_bounded()) {
    return order(part(set.vertices[static_cast<std::size_t>(e.from)], axis),
                 part(set.vertices[static_cast<std::size_t>(e.to)], axis));
  }
  return e.named ? order(part(e.point, axis), part(e.second, axis)) : order(0, part(e.direction, axis));
}

template <class T, std::size_t N>
Vec<T, N> along(const ConvexSet<N>& set, const Edge<N>& e) {
  if (e.is_bounded()) {
    const auto from = static_cast<std::size_t>(e.from), to = static_cast<std::size_t>(e.to);
    if constexpr (std::is_same_v<T, BigDyadic>) {
      if (set.is_exact()) {
        Vec<T, N> d = set.exact_vertices[to];
        for (std::size_t axis = 0; axis < N; ++axis) d[axis] = d[axis] - set.exact_vertices[from][axis];
        return d;
      }
    }
    return from_to<T>(set.vertices[from], set.vertices[to]);
  }
  return e.named ? from_to<T>(e.point, e.second) : made<T, N>(e.direction);
}

template <class T, std::size_t N>
class Clip {
 public:
  Clip(const ConvexSet<N>& set, const Edge<N>& edge, const ConvexSet<N>& bounded_by, const SignTable& signs,
       CertainSigns& ask)
      : set_(set), edge_(edge), other_(bounded_by), signs_(signs), ask_(ask) {}

  std::optional<Piece<T>> operator()() {
    int pinned = infinity;
    bool crosses = false, from_within = true, to_within = true;
    for (std::size_t i = 0; i < other_.bounds.size(); ++i) {
      const bool on = other_.bounds[i].side == 0;
      const auto [first, last] = ends(i);
      if (first * last > 0 && (on || first > 0)) return {};
      if (first * last < 0) {
        crosses = true;
        from_within = from_within && !on && first < 0;
        to_within = to_within && !on && last < 0;
      } else if (first == 0 && last != 0 && (on || last > 0)) {
        if (!pin(pinned, edge_.from)) return {};
      } else if (last == 0 && first != 0 && (on || first > 0)) {
        if (!pin(pinned, edge_.to)) return {};
      }
    }
    if (pinned != infinity) {
      if (!(pinned == edge_.from ? from_within : to_within)) return {};
      return Piece<T>{{true, pinned}, {true, pinned}, true};
    }
    Piece<T> piece{{true, edge_.from}, {true, edge_.to}};
    piece.is_point = edge_.from == edge_.to && edge_.from != infinity;
    for (std::size_t i = 0; i < other_.bounds.size() && crosses; ++i) {
      const auto [first, last] = ends(i);
      if (first * last >= 0) continue;
      const End<T> end = crossing(i, first);
      const bool on = other_.bounds[i].side == 0, enters = first > 0;
      if (on || enters) narrow(piece.from, end, Sign::positive);
      if (on || !enters) narrow(piece.to, end, Sign::negative);
      if (!ask_.certain()) return {};
    }
    if (!piece.from.own && !piece.to.own) {
      const Sign s = piece.from.index == piece.to.index ? Sign::zero : order(piece.from, piece.to);
      if (s == Sign::positive) return {};
      piece.is_point = s == Sign::zero;
    }
    return piece;
  }

 private:
  struct EndSigns {
    int first, last;
  };
  // At infinity: the sign that the value takes in the end.
  EndSigns ends(std::size_t bound) {
    const auto far = [&](int vertex, int way) {
      if (vertex != infinity) return signs_.at(bound, vertex);
      const Bound<N>& b = other_.bounds[bound];
      const int side = b.side == 0 ? 1 : b.side;
      const int s = static_cast<int>(ask_(slope<T, N>(b, along<T, N>(set_, edge_)))) * way;
      return s != 0 ? s * side : static_cast<int>(value_sign(b, edge_.point)) * side;
    };
    return {far(edge_.from, -1), far(edge_.to, 1)};
  }

  bool pin(int& pinned, int vertex) {
    if (pinned != infinity && pinned != vertex) return false;
    pinned = vertex;
    return true;
  }

  // Of a bound whose signs at both ends are opposite: whole > 0.
  End<T> crossing(std::size_t bound, int first) {
    const Bound<N>& b = other_.bounds[bound];
    const int side = b.side == 0 ? 1 : b.side;
    const bool falls = first * side > 0;
    const bool bounded = edge_.is_bounded();
    const T start = bounded ? vertex_value<T, N>(set_, edge_.from, b) : value<T, N>(b, edge_.point);
    const T rise = bounded ? vertex_value<T, N>(set_, edge_.to, b) - start : slope<T, N>(b, along<T, N>(set_, edge_));
    const T zero(0.0);
    return {false, static_cast<int>(bound), falls ? start : zero - start, falls ? zero - rise : rise};
  }

  Sign order(const End<T>& a, const End<T>& b) { return ask_(a.part * b.whole - b.part * a.whole); }

  // A crossing lies strictly between the edge's own ends.
  void narrow(End<T>& end, const End<T>& to, Sign way) {
    if (end.own || order(to, end) == way) end = to;
  }

  const ConvexSet<N>& set_;
  const Edge<N>& edge_;
  const ConvexSet<N>& other_;
  const SignTable& signs_;
  CertainSigns& ask_;
};

}  // namespace plumb::query::meeting
