#include "query/separation/cores.hpp"

#include <algorithm>

#include "query/convex/chains.hpp"
#include "query/convex/core.hpp"

namespace plumb::query {
namespace {

/// Convex pieces; of a polygon its edges, and its plane where it has an inside.
struct Pieces {
  std::vector<FlatSet> sets;
  SpannedChains chains;
  std::optional<FlatSet> plane;
};

void move(std::vector<Exact3>& points, const FigureAt& f) {
  if (f.map != nullptr) {
    for (Exact3& p : points) p = image(*f.map, p);
  }
  if (f.time == 0) return;
  const Exact3 way = mpq_class(f.time) * Exact3{f.by.x, f.by.y, f.by.z};
  for (Exact3& p : points) p = p + way;
}

FlatSet moved_core(const FigureAt& f) {
  FlatSet set = core_of(f.figure);
  if (f.map != nullptr) return image(*f.map, set);
  move(set.points, f);
  return set;
}

Pieces pieces_of(const FigureAt& f) {
  Pieces all;
  if (!is_polygon(f.figure)) {
    all.sets.push_back(moved_core(f));
    return all;
  }
  all.chains = chains_of(f.figure);
  move(all.chains.vertices, f);
  if (f.map != nullptr) all.chains.span = spanning(all.chains.vertices);
  const auto& [vertices, next, span] = all.chains;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    FlatSet edge{{vertices[i]}, {}, {}};
    if (vertices[next[i]] != vertices[i]) edge.points.push_back(vertices[next[i]]);
    all.sets.push_back(std::move(edge));
  }
  if (span.size() == 3) {
    const Exact3& from = vertices[span[0]];
    all.plane = FlatSet{{from}, {}, {vertices[span[1]] - from, vertices[span[2]] - from}};
  }
  return all;
}

/// No more than the square of the distance: that of the boxes around both, of sets that end.
mpq_class square_of_gap(const FlatSet& a, const FlatSet& b) {
  mpq_class square = 0;
  if (!a.directions.empty() || !a.lines.empty() || !b.directions.empty() || !b.lines.empty()) return square;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto by_axis = [k](const Exact3& p) -> const mpq_class& { return p[k]; };
    const auto [least_a, most_a] = std::ranges::minmax_element(a.points, {}, by_axis);
    const auto [least_b, most_b] = std::ranges::minmax_element(b.points, {}, by_axis);
    const mpq_class above = (*least_a)[k] - (*most_b)[k], below = (*least_b)[k] - (*most_a)[k];
    if (sgn(above) > 0) square += above * above;
    if (sgn(below) > 0) square += below * below;
  }
  return square;
}

/// The nearest pair of those that it sees; of equally near ones the first.
class NearestOfPairs {
 public:
  [[nodiscard]] bool can_be_nearer(const FlatSet& a, const FlatSet& b) const {
    return !best_ || square_of_gap(a, b) <= best_->square;
  }
  void see(NearestPair pair) {
    if (best_ && (pair.square > best_->square || (pair.square == best_->square && !comes_first(pair)))) return;
    best_ = std::move(pair);
  }
  [[nodiscard]] std::optional<NearestPair> best() && { return std::move(best_); }

 private:
  [[nodiscard]] bool comes_first(const NearestPair& pair) const {
    const auto places = [](const NearestPair& p) { return std::minmax(p.on_a, p.on_b); };
    const auto [first, last] = places(pair);
    const auto [best_first, best_last] = places(*best_);
    if (pair.is_first != best_->is_first) return pair.is_first;
    return first != best_first ? first < best_first : last != best_last ? last < best_last : pair.on_a < best_->on_a;
  }

  std::optional<NearestPair> best_;
};

NearestPair turned(NearestPair p) {
  std::swap(p.on_a, p.on_b);
  return p;
}

/// What is nearest inside of the polygon.  Pairs that go on lead across an edge, and are those of edges.
template <class See>
void see_inside(const Pieces& polygon, const Pieces& other, WhichPair which, const See& see) {
  if (!polygon.plane) return;
  for (const FlatSet& piece : other.sets) {
    NearestPair pair = *nearest_pair(*polygon.plane, piece, which);
    if (pair.is_first && holds_inside(polygon.chains, pair.on_a)) see(std::move(pair));
  }
}

std::optional<NearestPair> nearest_of_pieces(const FigureAt& a, const FigureAt& b, WhichPair which) {
  const Pieces p = pieces_of(a), q = pieces_of(b);
  if (p.sets[0].points.empty() || q.sets[0].points.empty()) return {};
  NearestOfPairs nearest;
  see_inside(p, q, which, [&](NearestPair pair) { nearest.see(std::move(pair)); });
  see_inside(q, p, which, [&](NearestPair pair) { nearest.see(turned(std::move(pair))); });
  for (const FlatSet& one : p.sets) {
    for (const FlatSet& other : q.sets) {
      if (nearest.can_be_nearer(one, other)) nearest.see(*nearest_pair(one, other, which));
    }
  }
  return std::move(nearest).best();
}

/// Numbers of sets that go on, for an order of two of one kind.
bool is_before(const FlatSet& a, const FlatSet& b) {
  if (a.points != b.points) return a.points < b.points;
  if (a.directions != b.directions) return a.directions < b.directions;
  return a.lines < b.lines;
}

}  // namespace

std::optional<NearestPair> nearest_of_cores(const FigureAt& a, const FigureAt& b, WhichPair which) {
  if (is_polygon(a.figure) || is_polygon(b.figure)) return nearest_of_pieces(a, b, which);
  const FlatSet p = moved_core(a), q = moved_core(b);
  auto pair = nearest_pair(p, q, which);
  if (!pair || pair->is_first) return pair;
  const bool in_order = a.figure.kind != b.figure.kind ? a.figure.kind < b.figure.kind : !is_before(q, p);
  return in_order ? pair : turned(*nearest_pair(q, p, which));
}

}  // namespace plumb::query
