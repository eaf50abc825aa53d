#include "degenerate/shrink_mesh.hpp"

#include <algorithm>
#include <bit>
#include <set>

namespace plumb::degenerate {

namespace {

using Corners = std::array<std::size_t, 3>;

/// Closes a hole by triangles from the first of its corners to each of its edges.
void close(MeshCase& mesh) {
  const std::vector<OpenEdge> open = open_edges(mesh);
  for (const OpenEdge& e : open) {
    const std::size_t top = open[0].from;
    if (e.from == top || e.to == top) continue;
    for (int i = 0; i < e.times; ++i) mesh.triangles.push_back({e.to, e.from, top});
  }
}

/// Without the points that no triangle names, of those chosen.
template <class Chosen>
MeshCase without_unused(const MeshCase& mesh, const Chosen& chosen) {
  constexpr std::size_t unused = ~std::size_t{0};
  std::vector<std::size_t> number(mesh.points.size(), unused);
  for (const Corners& t : mesh.triangles) {
    for (const std::size_t i : t) number[i] = 0;
  }
  MeshCase fewer;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (number[i] == unused && chosen(i)) continue;
    number[i] = fewer.points.size();
    fewer.points.push_back(mesh.points[i]);
  }
  for (const Corners& t : mesh.triangles) fewer.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return fewer;
}

class MeshShrinker {
 public:
  MeshShrinker(MeshCase mesh, bool closed, const std::function<bool(const MeshCase&)>& attempt)
      : mesh_(std::move(mesh)), closed_(closed), attempt_(attempt) {}

  void shrink() {
    for (bool improved = true; improved;) {
      improved = lose_blocks();
      if (closed_) {
        improved |= lose_covered();
        improved |= collapse_edges();
      }
      improved |= weld();
      improved |= lose_points();
    }
  }

 private:
  bool take(MeshCase candidate) {
    if (candidate.triangles.empty() || !attempt_(candidate)) return false;
    mesh_ = std::move(candidate);
    return true;
  }
  bool take_smaller(MeshCase candidate) {
    return candidate.triangles.size() < mesh_.triangles.size() && take(std::move(candidate));
  }

  bool lose_blocks() {
    bool improved = false;
    for (std::size_t block = (mesh_.triangles.size() + 1) / 2; block > 0; block /= 2) {
      for (std::size_t first = 0; first < mesh_.triangles.size();) {
        MeshCase fewer = mesh_;
        const auto at = fewer.triangles.begin() + static_cast<std::ptrdiff_t>(first);
        fewer.triangles.erase(at, at + static_cast<std::ptrdiff_t>(std::min(block, fewer.triangles.size() - first)));
        if (closed_) close(fewer);
        const bool lost = take_smaller(std::move(fewer));
        improved |= lost;
        first += lost ? 0 : block;  // what was patched stands at the end
      }
    }
    return improved;
  }

  /// A triangle and its reverse, by places.
  bool lose_covered() {
    bool improved = false;
    const std::vector<std::size_t> places = places_of(mesh_);
    const auto turned = [&](const Corners& t, std::size_t a, std::size_t b, std::size_t c) {
      return std::array{places[t[a]], places[t[b]], places[t[c]]};
    };
    for (std::size_t i = 1; i < mesh_.triangles.size(); ++i) {
      for (std::size_t j = 0; j < i && i < mesh_.triangles.size(); ++j) {
        const Corners &s = mesh_.triangles[i], &t = mesh_.triangles[j];
        const auto reverse = turned(t, 2, 1, 0);
        if (turned(s, 0, 1, 2) != reverse && turned(s, 1, 2, 0) != reverse && turned(s, 2, 0, 1) != reverse) continue;
        MeshCase fewer = mesh_;
        fewer.triangles.erase(fewer.triangles.begin() + static_cast<std::ptrdiff_t>(i));
        fewer.triangles.erase(fewer.triangles.begin() + static_cast<std::ptrdiff_t>(j));
        improved |= take(std::move(fewer));
      }
    }
    return improved;
  }

  bool collapse_edges() {
    bool improved = false;
    const std::vector<std::size_t> places = places_of(mesh_);
    std::set<std::array<std::size_t, 2>> edges;
    for (const Corners& t : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) edges.insert({places[t[i]], places[t[(i + 1) % 3]]});
      for (std::size_t i = 0; i < 3; ++i) edges.insert({places[t[(i + 1) % 3]], places[t[i]]});
    }
    for (const auto& [from, to] : edges) {
      MeshCase fewer = mesh_;
      for (std::array<double, 3>& p : fewer.points) {
        if (p == mesh_.points[from]) p = mesh_.points[to];
      }
      const std::vector<std::size_t> now = places_of(fewer);
      std::erase_if(fewer.triangles, [&](const Corners& t) {
        return now[t[0]] == now[t[1]] || now[t[1]] == now[t[2]] || now[t[2]] == now[t[0]];
      });
      improved |= take_smaller(std::move(fewer));
    }
    return improved;
  }

  /// Equal points become the first of them: everywhere, or in one place.
  bool weld() {
    const std::vector<std::size_t> places = places_of(mesh_);
    const auto welded = [&](const auto& chosen) {
      MeshCase fewer = mesh_;
      for (Corners& t : fewer.triangles) {
        for (std::size_t& i : t) i = chosen(places[i]) ? places[i] : i;
      }
      return fewer.triangles != mesh_.triangles && take(without_unused(fewer, [](std::size_t) { return true; }));
    };
    if (welded([](std::size_t) { return true; })) return true;
    for (const std::size_t place : std::set(places.begin(), places.end())) {
      if (welded([&](std::size_t p) { return p == place; })) return true;
    }
    return false;
  }

  bool lose_points() {
    MeshCase fewer = without_unused(mesh_, [](std::size_t) { return true; });
    if (fewer.points.size() == mesh_.points.size()) return false;
    if (take(std::move(fewer))) return true;
    for (std::size_t i = mesh_.points.size(); i > 0; --i) {
      fewer = without_unused(mesh_, [&](std::size_t k) { return k == i - 1; });
      if (fewer.points.size() < mesh_.points.size() && take(std::move(fewer))) return true;
    }
    return false;
  }

  MeshCase mesh_;
  const bool closed_;
  const std::function<bool(const MeshCase&)>& attempt_;
};

}  // namespace

void shrink_mesh(MeshCase mesh, bool closed, const std::function<bool(const MeshCase&)>& attempt) {
  MeshShrinker(std::move(mesh), closed, attempt).shrink();
}

}  // namespace plumb::degenerate
