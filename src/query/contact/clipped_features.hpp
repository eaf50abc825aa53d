// What have two features in common, seen along a direction?  The corners of the intersection of two convex polygons,
// edges or points, by signs alone: which vertex is on which side of the line through which edge.
//
// Laws: exact where the signs are certain.  Of each corner it is known which vertex of one lies within which feature of
// the other, or which two edges cross.  No corner twice.
// Source: O'Rourke, Computational Geometry in C, 1998, 7.6, on the intersection of convex polygons.
// Cost: a sign for each vertex of one and each edge of the other.
#pragma once

#include <algorithm>
#include <vector>

#include "query/contact/facing.hpp"

namespace plumb::query::touching {

enum class CornerKind : unsigned char { vertex_of_a, vertex_of_b, both_vertices, edges };

/// i and j are places in the lists of Facing: of vertices, or of the first ends of edges.
struct Found {
  CornerKind kind;
  Index i, j;
  ContactId id;
};
using FoundCorners = parting::ShortList<Found, 16>;

/// Some values, each computed when it is first asked for: many a number type has no default.
template <class T>
class Once {
 public:
  explicit Once(std::size_t size) {
    if (size > few_.size()) many_.resize(size);
  }
  template <class Make>
  const T& operator()(std::size_t i, const Make& make) {
    std::optional<T>& value = slot(i);
    if (!value) value.emplace(make());
    return *value;
  }
  /// What was asked for before.
  [[nodiscard]] const T& operator[](std::size_t i) const { return *(many_.empty() ? few_[i] : many_[i]); }

 private:
  [[nodiscard]] std::optional<T>& slot(std::size_t i) { return many_.empty() ? few_[i] : many_[i]; }

  std::array<std::optional<T>, 8> few_;
  std::vector<std::optional<T>> many_;
};

/// A feature over a number type, seen along the direction that leads out of its body.  What is cheap is computed at once, so
// that there is one place in the code that does it; else where it is asked for.
template <class T>
class View {
 public:
  const Seen& seen;
  const Facing& f;

  View(const Seen& s, const Facing& facing)
      : seen(s), f(facing), is_side_(s.core.is_sum() && size() == 4), places_(size()), ways_(edges()) {
    if constexpr (is_cheap) {
      for (std::size_t i = 0; i < size(); ++i) {
        if (is_side_ && i < 2) ways_(i, [&] { return edge_between(i, i + 1); });
        if (is_side_ && i > 1) ways_(i, [&] { return back(ways_[i - 2]); });
        places_(i, [&] { return is_side_ && i > 0 ? places_[i - 1] + ways_[i - 1] : place(i); });
      }
      for (std::size_t i = 0; i < edges() && !is_side_; ++i) ways_(i, [&] { return places_[next(i)] - places_[i]; });
    }
  }
  [[nodiscard]] std::size_t size() const { return f.corners.size(); }
  /// Is it the side of a box, a parallelogram?
  [[nodiscard]] bool is_side() const { return is_side_; }
  [[nodiscard]] const Vec<T>& at(std::size_t i) const {
    if constexpr (is_cheap) {
      return places_[i];
    } else {
      return places_(i, [&] { return new_place(i); });
    }
  }
  [[nodiscard]] std::size_t edges() const { return f.edges.size(); }
  [[nodiscard]] const Vec<T>& edge(std::size_t i) const {
    if constexpr (is_cheap) {
      return ways_[i];
    } else {
      return ways_(i, [&] { return new_way(i); });
    }
  }

 private:
  static constexpr bool is_cheap = std::is_same_v<T, Approximate>;

  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] Vec<T> place(std::size_t i) const { return parting::corner_of<T>(seen.core, f.corners[i]); }
  [[nodiscard]] Vec<T> edge_between(std::size_t i, std::size_t k) const {
    return parting::between<T>(seen.core, f.corners[i], f.corners[k]);
  }
  static Vec<T> back(const Vec<T>& v) {
    if constexpr (requires { -v.x; }) {
      return {-v.x, -v.y, -v.z};
    } else {
      return Vec<T>{T(0.0), T(0.0), T(0.0)} - v;
    }
  }
  // Neither is inlined where it is asked for: they are long, and asked for at many places.
  [[nodiscard]] [[gnu::noinline]] Vec<T> new_place(std::size_t i) const {
    if (!is_side_ || i == 0 || seen.core.is_aligned()) return place(i);
    return at(i == 3 ? 0 : i - 1) + edge(i == 3 ? 1 : i - 1);  // which is less to be computed
  }
  [[nodiscard]] [[gnu::noinline]] Vec<T> new_way(std::size_t i) const {
    if (!is_side_) return at(next(i)) - at(i);
    return i < 2 ? edge_between(i, i + 1) : back(edge(i - 2));
  }

  bool is_side_;
  mutable Once<Vec<T>> places_, ways_;
};

/// On which side of each edge of one feature is each vertex of another?  Of a segment its two ends are lines, too.
/// `is_on(i, k, j)`: is corner j of the other known to be on the line through i and k?
class Sides {
 public:
  template <class T, class IsOn>
  Sides(const View<T>& of, const Vec<T>& out, const View<T>& other, const IsOn& is_on, CertainSigns& ask)
      : lines_(of.size() == 2 ? 3 : of.edges()), vertices_(other.size()), is_segment_(of.size() == 2) {
    std::optional<Vec<T>> first, second;  // of a box's side the others lead the other way
    for (std::size_t l = 0; l < of.edges(); ++l) {
      std::optional<Vec<T>>& before = l % 2 == 0 ? first : second;
      const Vec<T> inward = of.is_side() && l > 1 ? back(*before) : sparse_cross(out, of.edge(l));
      if (l < 2) before = inward;
      const Index from = of.f.corners[l], to = of.f.corners[l + 1 == of.size() ? 0 : l + 1];
      for (std::size_t j = 0; j < vertices_; ++j) {
        const bool is_known = is_on(from, to, other.f.corners[j]);
        sign_.push_back(is_known ? Sign::zero : ask(along_way(inward, of.at(l), other.at(j))));
      }
    }
    if (of.size() != 2) return;
    const Vec<T> along = sparse_cross(sparse_cross(out, of.edge(0)), out);
    for (std::size_t end = 0; end < 2; ++end) {
      for (std::size_t j = 0; j < vertices_; ++j) {
        const Sign s = ask(along_way(along, of.at(end), other.at(j)));
        sign_.push_back(end == 0 ? s : -s);
      }
    }
  }
  /// Takes the signs of two parallelograms, edge by edge of the one.
  explicit Sides(const std::array<Sign, 16>& sign) : lines_(4), vertices_(4), is_segment_(false) {
    for (const Sign s : sign) sign_.push_back(s);
  }
  [[nodiscard]] Sign operator()(std::size_t line, std::size_t vertex) const { return sign_[line * vertices_ + vertex]; }
  /// Is a vertex on the outer side of any line?
  [[nodiscard]] bool has_outer() const {
    return std::any_of(sign_.begin(), sign_.end(), [](Sign s) { return s == Sign::negative; });
  }

  /// Which part of the feature a vertex is before: nothing if none.
  struct Place {
    FeatureKind kind;
    std::size_t index;
  };
  [[nodiscard]] std::optional<Place> place(std::size_t vertex) const {
    const auto is = [&](std::size_t line) { return (*this)(line, vertex); };
    if (lines_ == 0) return Place{FeatureKind::vertex, 0};
    if (is_segment_) {
      if (is(0) != Sign::zero || is(1) == Sign::negative || is(2) == Sign::negative) return {};
      if (is(1) == Sign::zero) return Place{FeatureKind::vertex, 0};
      if (is(2) == Sign::zero) return Place{FeatureKind::vertex, 1};
      return Place{FeatureKind::edge, 0};
    }
    std::size_t on = lines_, first = lines_;
    for (std::size_t l = 0; l < lines_; ++l) {
      if (is(l) == Sign::negative) return {};
      if (is(l) != Sign::zero) continue;
      if (on == lines_) {
        on = first = l;
      } else {
        on = l;
      }
    }
    if (on == lines_) return Place{FeatureKind::face, 0};
    if (on == first) return Place{FeatureKind::edge, on};
    return Place{FeatureKind::vertex, first == 0 && on + 1 == lines_ ? 0 : on};  // between both edges
  }

 private:
  template <class T>
  static Vec<T> back(const Vec<T>& v) {
    return Vec<T>{T(0.0), T(0.0), T(0.0)} - v;
  }
  /// n . (q - p), of which what is times zero is not computed.
  template <class T>
  static T along_way(const Vec<T>& n, const Vec<T>& p, const Vec<T>& q) {
    const auto part = [](const T& a, const T& from, const T& to) {
      return certainly_zero(a) ? T(0.0) : sparse_product(a, to - from);
    };
    return sparse_sum(sparse_sum(part(n.x, p.x, q.x), part(n.y, p.y, q.y)), part(n.z, p.z, q.z));
  }

  std::size_t lines_, vertices_;
  bool is_segment_;
  parting::ShortList<Sign, 32> sign_;
};

/// A feature of a body.
struct SeenFeature {
  const Seen& seen;
  const Facing& f;

  [[nodiscard]] std::size_t size() const { return f.corners.size(); }
  [[nodiscard]] std::size_t edges() const { return f.edges.size(); }
  [[nodiscard]] Feature vertex(std::size_t i) const { return surface_feature(seen, FeatureKind::vertex, f.corners[i]); }
  [[nodiscard]] Feature at(const Sides::Place& place) const {
    if (place.kind == FeatureKind::face) return f.face;
    return place.kind == FeatureKind::edge ? f.edges[place.index] : vertex(place.index);
  }
};

/// `on_a` tells on which side of each edge of a the corners of b are, `on_b` the other way round.
FoundCorners found_corners(const SeenFeature& a, const SeenFeature& b, const Sides& on_a, const Sides& on_b);

/// `normal` leads from a to b, back along the way.
template <class T>
FoundCorners common_corners(const View<T>& a, const View<T>& b, const Vec<T>& normal, const Way& way,
                            CertainSigns& ask) {
  const Vec<T> back = Vec<T>{T(0.0), T(0.0), T(0.0)} - normal;
  const auto is_on = [&](std::size_t body) {
    return [&way, body](Index i, Index k, Index j) { return way.is_before(body, i, k, j); };
  };
  const Sides on_a(a, normal, b, is_on(0), ask), on_b(b, back, a, is_on(1), ask);
  return found_corners({a.seen, a.f}, {b.seen, b.f}, on_a, on_b);
}

}  // namespace plumb::query::touching
