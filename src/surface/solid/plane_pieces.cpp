#include "surface/solid/plane_pieces.hpp"

#include <algorithm>
#include <numeric>

#include "surface/planar/triangulator.hpp"
#include "surface/solid/divided_segments.hpp"

namespace plumb::surface {
namespace {

class PlaneDivider {
 public:
  PlaneDivider(const FacePool& pool, PointTable& table, const PlaneClass& of, const PlaneView& view)
      : pool_(pool), of_(of), view_(view), points_(table, view) {}

  PlanePieces run() {
    collect_segments();
    const auto along = points_along(points_, segments_);
    rank_points();
    const std::vector<KnownLines> lines = lines_of_points(along);
    auto made = triangulator_of(std::span<const ExactPoint2>(ranked_), lines);
    std::vector<std::array<std::uint32_t, 2>> pieces;
    for (const auto& a : along)
      for (std::size_t k = 1; k < a.size(); ++k) pieces.push_back({rank_[a[k - 1]], rank_[a[k]]});
    (void)made.constrain(pieces);  // which meet in their ends only
    const Triangles& t = made.triangles();
    PlanePieces result;
    std::vector<std::uint32_t> first_cover;  // of each triangle, where several faces may cover it
    if (of_.faces.size() == 1) {
      result.covers.push_back({of_.faces[0], is_opposite_[0]});
    } else {
      result.covers = in_order_of_triangles(cover(made, along), t.end() / 4, first_cover);
    }
    const std::span<const CoveringFace> all(result.covers);
    for (HalfEdge first = 0; first < t.end(); first += 4) {
      if (t.is_ghost(first)) continue;
      const std::size_t at = first / 4;
      PlanePiece piece{{},
                       first_cover.empty() ? all : all.subspan(first_cover[at], first_cover[at + 1] - first_cover[at])};
      if (piece.covers.empty()) continue;
      for (HalfEdge k = 0; k < 3; ++k)
        piece.corners[k] = points_.number_in_table(of_rank_[made.points().label(t.origin(first + k))]);
      result.pieces.push_back(piece);
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_from_above(std::uint32_t face) const {
    const auto& [a, b, c] = pool_.mesh.triangles[face];
    return pool_.points().turn_along(view_.axis(), a, b, c) == Sign::positive;
  }

  // Edges and chords, each once from its smaller number on, then points.
  void collect_segments() {
    struct Use {
      SegmentEnds ends;
      std::uint32_t edge;  // edge k of face i is 3 i + k, counterclockwise as seen
      bool reversed;
    };
    std::vector<Use> uses;
    const auto add = [&](std::uint32_t from, std::uint32_t to, std::uint32_t edge) {
      const std::uint32_t a = points_.add(from), b = points_.add(to);
      uses.push_back({{std::min(a, b), std::max(a, b)}, edge, a > b});
    };
    for (std::uint32_t i = 0; i < of_.faces.size(); ++i) {
      auto corners = pool_.mesh.triangles[of_.faces[i]];
      is_opposite_.push_back(!is_from_above(of_.faces[i]));
      if (is_opposite_[i]) std::swap(corners[1], corners[2]);
      for (std::uint32_t k = 0; k < 3; ++k) add(corners[k], corners[(k + 1) % 3], 3 * i + k);
    }
    for (const auto& [a, b] : of_.chords) add(a, b, none);
    std::ranges::sort(uses, {}, &Use::ends);
    edges_.resize(3 * of_.faces.size());
    for (const Use& use : uses) {
      if (segments_.empty() || segments_.back() != use.ends) segments_.push_back(use.ends);
      if (use.edge != none) edges_[use.edge] = {static_cast<std::uint32_t>(segments_.size() - 1), use.reversed};
    }
    for (const std::uint32_t p : of_.points) segments_.push_back({points_.add(p), points_.add(p)});
  }

  void rank_points() {
    of_rank_.resize(points_.size());
    std::iota(of_rank_.begin(), of_rank_.end(), 0U);
    std::ranges::sort(of_rank_, [&](std::uint32_t l, std::uint32_t r) {
      return compare_xy(points_.seen(l), points_.seen(r)) == Sign::negative;
    });
    rank_.resize(points_.size());
    ranked_.reserve(points_.size());
    for (std::uint32_t r = 0; r < of_rank_.size(); ++r) {
      rank_[of_rank_[r]] = r;
      ranked_.push_back(points_.take_seen(of_rank_[r]));
    }
  }

  /// The segments that each point is on, of the first of them.
  [[nodiscard]] std::vector<KnownLines> lines_of_points(const std::vector<std::vector<std::uint32_t>>& along) const {
    std::vector<KnownLines> lines(rank_.size());
    for (std::size_t i = 0; i < along.size() && i < 64; ++i)
      for (const std::uint32_t p : along[i]) lines[rank_[p]] |= KnownLines{1} << i;
    return lines;
  }

  struct CoveredTriangle {
    HalfEdge triangle;  // its first half-edge / 4
    CoveringFace by;
  };

  static std::vector<CoveringFace> in_order_of_triangles(const std::vector<CoveredTriangle>& covered, std::size_t count,
                                                         std::vector<std::uint32_t>& first_cover) {
    first_cover.assign(count + 1, 0);
    for (const CoveredTriangle& c : covered) ++first_cover[c.triangle + 1];
    for (std::size_t t = 1; t <= count; ++t) first_cover[t] += first_cover[t - 1];
    std::vector<std::uint32_t> next = first_cover;
    std::vector<CoveringFace> covers(covered.size());
    for (const CoveredTriangle& c : covered) covers[next[c.triangle]++] = c.by;
    return covers;
  }

  // Each face covers what is inward of the pieces of its edges, as far as these; faces ascend.
  [[nodiscard]] std::vector<CoveredTriangle> cover(const Triangulator<ExactPoints>& made,
                                                   const std::vector<std::vector<std::uint32_t>>& along) const {
    std::vector<CoveredTriangle> covered;
    const Triangles& t = made.triangles();
    std::unordered_map<std::uint64_t, HalfEdge> edge_at;
    const auto key = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32 | b; };
    for (HalfEdge first = 0; first < t.end(); first += 4) {
      if (t.is_ghost(first)) continue;
      for (HalfEdge e = first; e < first + 3; ++e)
        if (t.is_constrained(e)) edge_at[key(made.points().label(t.origin(e)), made.points().label(t.target(e)))] = e;
    }
    std::vector<std::uint32_t> edge_of(t.end(), none), visited(t.end() / 4, none);
    std::vector<HalfEdge> pending;
    for (std::uint32_t i = 0; i < of_.faces.size(); ++i) {
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
        const auto& points = along[edges_[k].segment];
        for (std::size_t j = 1; j < points.size(); ++j) {
          const std::uint32_t a = rank_[points[j - 1]], b = rank_[points[j]];
          const HalfEdge e = edge_at.at(edges_[k].reversed ? key(b, a) : key(a, b));
          edge_of[e] = i;
          pending.push_back(Triangles::first_of(e));
        }
      }
      const CoveringFace by{of_.faces[i], is_opposite_[i]};
      while (!pending.empty()) {
        const HalfEdge first = pending.back();
        pending.pop_back();
        if (visited[first / 4] == i) continue;
        visited[first / 4] = i;
        covered.push_back({first / 4, by});
        for (HalfEdge e = first; e < first + 3; ++e)
          if (edge_of[e] != i) pending.push_back(Triangles::first_of(t.twin(e)));
      }
    }
    return covered;
  }

  const FacePool& pool_;
  const PlaneClass& of_;
  const PlaneView& view_;
  SeenPoints points_;
  struct EdgeOfFace {
    std::uint32_t segment;
    bool reversed;
  };
  std::vector<SegmentEnds> segments_;
  std::vector<EdgeOfFace> edges_;
  std::vector<bool> is_opposite_;              // of each face
  std::vector<std::uint32_t> rank_, of_rank_;  // lexicographic ranks as seen, and back
  std::vector<ExactPoint2> ranked_;
};

}  // namespace

PlanePieces divide_plane(const FacePool& pool, PointTable& table, const PlaneClass& of, const PlaneView& view) {
  return PlaneDivider(pool, table, of, view).run();
}

}  // namespace plumb::surface
