// Expanding polytope algorithm (EPA): which planes around a difference of two bodies are nearest to the origin, for
// certain?
//
// A surface between points of the difference grows beyond its facet nearest to the origin until that one has no point
// of the difference before it.  What is within the surface is within the difference, and so no way out is shorter than
// that to the surface's nearest facet; a facet without a point before it is a way out.  How near a facet is says an
// aim: every way, along one direction, or within a cone of them.
// Laws: (1) the surface is convex, by exact signs, and a facet counts as nearest only where it is compared exactly with
// all others; which facet is looked at next is a guess.  (2) It ends: each step finds a facet without points before it,
// or a point of finitely many that lies outside of the surface so far.  (3) Of an origin inside of the difference all
// nearest planes are told; of one on its boundary all facets through it; of one outside nothing.
// Source: van den Bergen 2001; RTCD 9.3.8.
// Cost: some 300 ns a step; 8 to 40 steps for bodies of 8 to 128 corners.  Of every way this is what is left where
// query/penetration/proved_surface.hpp proves nothing.
#pragma once

#include "query/penetration/basis.hpp"
#include "query/penetration/furthest.hpp"
#include "query/penetration/short_list.hpp"
#include "query/penetration/surface.hpp"

namespace plumb::query::parting {

/// What measures a way out: above / below is to be least.
template <class T>
struct Fraction {
  T above, below;
};

/// The square of a plane's distance.
struct EveryWay {
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t) const {
    const T h = plane.height();
    return {h * h, dot(plane.normal, plane.normal)};
  }
  /// How does this aim lead out through such a plane?  0: not at all.
  template <class PlaneIn>
  [[nodiscard]] std::uint32_t passage(const PlaneIn&) const {
    return 1;
  }
};

enum class Origin : unsigned char { outside, on_boundary, inside };

/// Facets by three points of the difference each, counterclockwise seen from outside.
struct NearestPlanes {
  Origin origin = Origin::outside;
  ShortList<std::array<Ends, 3>, 8> facets;
  std::optional<std::array<LevelCorners, 2>> level{};  // of each body what lies in the plane, where it is one and known
  Basis flat{};                                        // where the difference has no inside
};

/// Is a facet in the plane of one of these, as far as that is known without arithmetic?
inline bool is_known_in(const Difference& d, std::span<const std::array<Ends, 3>> planes,
                        const std::array<Ends, 3>& facet) {
  return std::ranges::any_of(planes, [&](const std::array<Ends, 3>& of) {
    const KnownPlane plane(d, of);
    return std::ranges::all_of(facet, [&](const Ends& e) { return plane.has(e); });
  });
}

template <class Aim>
class Search {
 public:
  Search(const Difference& of, const Aim& aim) : of_(of), aim_(aim), surface_(of) {}

  /// From four points that are not in one plane; `around`: known to have the origin strictly inside.
  NearestPlanes run(const std::array<Ends, 4>& start, bool around) {
    surface_.start(start);
    around_ = around;
    for (std::uint32_t f = 0; f < 4; ++f) look(f);
    if (!around_ && !takes_in_origin()) return told_;
    while (const auto f = next()) step(*f);
    told_.origin = Origin::inside;
    for (std::uint32_t f = 0; f < surface_.size(); ++f) {
      if (is_found(f) && (f == *best_ || compare(f, *best_) == Sign::zero)) tell(f);
    }
    return told_;
  }

 private:
  [[nodiscard]] bool is_found(std::uint32_t f) const { return surface_[f].is_there && surface_[f].is_supported; }
  [[nodiscard]] bool is_open(std::uint32_t f) const { return surface_[f].is_there && !surface_[f].is_supported; }
  void tell(std::uint32_t f) {
    const std::array<Ends, 3> ends = surface_.ends_of(surface_[f]);
    if (is_known_in(of_, told_.facets, ends)) return;  // another part of it
    told_.facets.push_back(ends);
  }

  /// What is to be known of a new facet.
  void look(std::uint32_t f) {
    Facet& facet = surface_[f];
    if (around_) {
      facet.passage = aim_.passage([&]<class T>() { return surface_.plane<T>(facet); });
      if (facet.passage == 0) return;
      const Fraction<Running> m = aim_.measure(surface_.plane<Running>(facet), facet.passage);
      facet.measure = quotient(m.above, m.below);
    } else {
      const Fraction<Running> m = EveryWay().measure(surface_.plane<Running>(facet), 1);
      facet.measure = quotient(m.above, m.below);
      facet.side = surface_.height_sign(facet);
      if (facet.height.value < 0) facet.measure.value = -facet.measure.value;
    }
  }

  /// As far as that is known without arithmetic.
  [[nodiscard]] bool are_in_one_plane(const Facet& f, const Facet& g) const {
    const KnownPlane plane = surface_.known_plane(f);
    return std::ranges::all_of(surface_.ends_of(g), [&](const Ends& e) { return plane.has(e); });
  }
  [[nodiscard]] Sign compare(std::uint32_t f, std::uint32_t g) {
    Facet &p = surface_[f], &q = surface_[g];
    if (p.measure.lower() > q.measure.upper()) return Sign::positive;
    if (p.measure.upper() < q.measure.lower()) return Sign::negative;
    if (are_in_one_plane(p, q)) return Sign::zero;
    return sign_of([&]<class T>() -> T {
      const Fraction<T> x = aim_.measure(surface_.plane<T>(p), p.passage),
                        y = aim_.measure(surface_.plane<T>(q), q.passage);
      return x.above * y.below - y.above * x.below;
    });
  }

  /// Finds a point before the facet, and grows to it, or that there is none.  Did it grow?
  bool step(std::uint32_t f) {
    Facet& facet = surface_[f];
    const Ends& from = surface_.ends(facet.corner[0]);
    const arith::Plain n{facet.normal.x.value, facet.normal.y.value, facet.normal.z.value};
    Ends e{guessed_furthest(of_.a, n, from[0]), guessed_furthest(of_.b, n * -1, from[1])};
    if (!surface_.is_beyond(e, facet)) {
      const auto exact = beyond(facet);
      if (!exact) {
        facet.is_supported = true;
        if (around_ && (!best_ || compare(f, *best_) == Sign::negative)) best_ = f;
        return false;
      }
      e = *exact;
    }
    surface_.add(e, f, [&](std::uint32_t made) { look(made); });
    return true;
  }
  [[nodiscard]] std::optional<Ends> beyond(Facet& f) {
    Normal normal([&]<class T>() -> Vec<T> {
      if constexpr (std::is_same_v<T, Running>) {
        return f.normal;
      } else {
        return surface_.plane<T>(f).normal;
      }
    });
    const Ends& from = surface_.ends(f.corner[0]);
    const KnownPlane known = surface_.known_plane(f);
    const auto on_a = any_further(of_.a, normal, Sign::positive, from[0], known.a),
               on_b = any_further(of_.b, normal, Sign::negative, from[1], known.b);
    if (!on_a && !on_b) return {};
    return Ends{on_a.value_or(from[0]), on_b.value_or(from[1])};
  }

  /// Grows until the origin is strictly inside; false where it never will be.
  bool takes_in_origin() {
    for (;;) {
      std::optional<std::uint32_t> least;
      for (std::uint32_t f = 0; f < surface_.size(); ++f) {
        if (!is_open(f) || surface_[f].side == Sign::positive) continue;
        if (!least || surface_[f].measure.value < surface_[*least].measure.value) least = f;
      }
      if (!least) break;
      if (step(*least)) continue;
      if (surface_[*least].side == Sign::negative) return false;
      told_.origin = Origin::on_boundary;
    }
    if (told_.origin == Origin::on_boundary) {
      for (std::uint32_t f = 0; f < surface_.size(); ++f) {
        if (is_found(f)) tell(f);
      }
      return false;
    }
    around_ = true;
    for (std::uint32_t f = 0; f < surface_.size(); ++f) {
      if (surface_[f].is_there) look(f);
    }
    return true;
  }

  /// The facet to look at; nothing where the best is nearest for certain.
  [[nodiscard]] std::optional<std::uint32_t> next() {
    constexpr double nearly = 1 + 0x1p-20;  // a guess: what is as near may be a tie
    std::optional<std::uint32_t> least;
    for (std::uint32_t f = 0; f < surface_.size(); ++f) {
      if (!is_open(f) || surface_[f].passage == 0) continue;
      if (!least || surface_[f].measure.value < surface_[*least].measure.value) least = f;
    }
    if (!least || !best_) return least;
    if (!(surface_[*least].measure.value > surface_[*best_].measure.value * nearly)) return least;
    for (std::uint32_t f = 0; f < surface_.size(); ++f) {
      if (is_open(f) && surface_[f].passage != 0 && compare(f, *best_) != Sign::positive) return f;
    }
    return {};
  }

  Difference of_;
  const Aim& aim_;
  Surface surface_;
  NearestPlanes told_;
  std::optional<std::uint32_t> best_;
  bool around_ = false;
};

}  // namespace plumb::query::parting
