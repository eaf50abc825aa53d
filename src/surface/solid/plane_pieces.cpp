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

  std::vector<PlanePiece> run() {
    collect_segments();
    const auto along = points_along(points_, segments_);
    rank_points();
    auto made = triangulator_of(std::span<const ExactPoint2>(ranked_));
    std::vector<std::array<std::uint32_t, 2>> pieces;
    for (const auto& a : along)
      for (std::size_t k = 1; k < a.size(); ++k) pieces.push_back({rank_[a[k - 1]], rank_[a[k]]});
    (void)made.constrain(pieces);  // which meet in their ends only
    const Triangles& t = made.triangles();
    std::vector<std::vector<CoveringFace>> covers(t.end() / 4);
    if (of_.faces.size() == 1) {
      for (auto& c : covers) c.push_back({of_.faces[0], is_opposite_[0]});
    } else {
      cover(made, along, covers);
    }
    std::vector<PlanePiece> result;
    for (HalfEdge first = 0; first < t.end(); first += 4) {
      if (t.is_ghost(first) || covers[first / 4].empty()) continue;
      PlanePiece piece{{}, std::move(covers[first / 4])};
      for (HalfEdge k = 0; k < 3; ++k)
        piece.corners[k] = points_.number_in_table(of_rank_[made.points().label(t.origin(first + k))]);
      result.push_back(std::move(piece));
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

  // From the pieces of each face's edges inward, as far as these.
  void cover(const Triangulator<ExactPoints>& made, const std::vector<std::vector<std::uint32_t>>& along,
             std::vector<std::vector<CoveringFace>>& covers) const {
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
        covers[first / 4].push_back(by);
        for (HalfEdge e = first; e < first + 3; ++e)
          if (edge_of[e] != i) pending.push_back(Triangles::first_of(t.twin(e)));
      }
    }
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

std::vector<PlanePiece> divide_plane(const FacePool& pool, PointTable& table, const PlaneClass& of,
                                     const PlaneView& view) {
  return PlaneDivider(pool, table, of, view).run();
}

}  // namespace plumb::surface
