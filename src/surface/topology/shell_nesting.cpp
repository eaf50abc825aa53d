#include "surface/topology/shell_nesting.hpp"

#include <algorithm>
#include <tuple>

#include "figure/basic/lists_by_number.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "query/ray/crossings.hpp"
#include "space/bvh/parts.hpp"
#include "space/ray/along_x.hpp"
#include "surface/topology/middle_crossing.hpp"

namespace plumb::surface {
namespace {

constexpr std::size_t places_of_block = 256;

/// A vertex of a shell, or the middle of one of its triangles.
struct Place {
  std::uint32_t shell;
  std::uint32_t number;
  bool is_vertex;
};

/// At so many places a shell is inside of a closed one, and on it.
struct Sight {
  std::uint32_t shell, around;
  std::uint32_t inside = 0, on = 0;
  [[nodiscard]] auto pair() const { return std::tie(shell, around); }
};

void merge(std::vector<Sight>& sights) {
  std::ranges::sort(sights, {}, &Sight::pair);
  std::size_t kept = 0;
  for (const Sight& s : sights) {
    if (kept > 0 && sights[kept - 1].pair() == s.pair()) {
      sights[kept - 1].inside += s.inside;
      sights[kept - 1].on += s.on;
    } else {
      sights[kept++] = s;
    }
  }
  sights.resize(kept);
}

std::vector<Place> places_on(const TriangleMesh& mesh, const std::vector<std::uint8_t>& at_others,
                             const Shells& found) {
  const figure::ListsByNumber triangles(found.shell_of, found.shells.size());
  std::vector<std::uint32_t> last_shell(mesh.vertices.size(), no_shell);
  std::vector<Place> places;
  for (std::uint32_t s = 0; s < found.shells.size(); ++s) {
    if (!found.shells[s].meets) {
      places.push_back({s, mesh.triangles[found.shells[s].first_triangle][0], true});
      continue;
    }
    for (const std::uint32_t t : triangles[s]) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        if (last_shell[v] == s) continue;
        last_shell[v] = s;
        places.push_back({s, v, true});
      }
      if (at_others[t] != 0) places.push_back({s, t, false});
    }
  }
  return places;
}

/// Looks from one place: which closed shells are around it, which go through it?
class Look {
 public:
  Look(const Bvh& bvh, const TriangleMesh& mesh, const Shells& found) : bvh_(bvh), mesh_(mesh), found_(found) {}

  void from(const Place& place, std::vector<Sight>& sights) {
    crossed_.clear();
    on_.clear();
    if (place.is_vertex) {
      const Point3& p = mesh_.vertices[place.number];
      descend_along(place.shell, space::AlongX(bvh_.tree.frame, p), [&](const Triangle3& t) {
        query::Crossings one;
        if (!one.take(t, p)) return MiddleCrossing::on_triangle;
        return one.count != 0 ? MiddleCrossing::crossed : MiddleCrossing::none;
      });
    } else {
      const auto& [a, b, c] = mesh_.triangles[place.number];
      const Triangle3 own{mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
      const Aabb3 box = box_around(own);
      descend_along(place.shell, space::AlongX(bvh_.tree.frame, box.min, box.max),
                    [&](const Triangle3& t) { return crossing_from_middle(own, t); });
    }
    add_to(place.shell, sights);
  }

 private:
  static Aabb3 box_around(const Triangle3& t) {
    const query::CoordinateRange x(t.a.x, t.b.x, t.c.x), y(t.a.y, t.b.y, t.c.y), z(t.a.z, t.b.z, t.c.z);
    return {{x.least, y.least, z.least}, {x.most, y.most, z.most}};
  }

  template <class Cross>
  void descend_along(std::uint32_t own, const space::AlongX& ray, const Cross& cross) {
    descend(bvh_.tree, ray, [&](std::uint32_t first, std::uint32_t count) {
      for (std::uint32_t slot = first; slot < first + count; ++slot) {
        const std::uint32_t triangle = bvh_.number(slot), shell = found_.shell_of[triangle];
        if (shell == own || shell == no_shell || !found_.shells[shell].closed) continue;
        const MiddleCrossing c = cross(bvh_.triangle(slot));
        if (c == MiddleCrossing::on_triangle) on_.push_back(shell);
        if (c == MiddleCrossing::crossed) crossed_.emplace_back(shell, triangle);
      }
    });
  }

  void add_to(std::uint32_t own, std::vector<Sight>& sights) {
    std::ranges::sort(on_);
    on_.erase(std::unique(on_.begin(), on_.end()), on_.end());
    for (const std::uint32_t shell : on_) sights.push_back({own, shell, 0, 1});
    std::ranges::sort(crossed_);
    crossed_.erase(std::unique(crossed_.begin(), crossed_.end()), crossed_.end());  // a triangle may be in two slots
    for (auto from = crossed_.begin(); from != crossed_.end();) {
      const std::uint32_t shell = from->first;
      const auto to = std::find_if(from, crossed_.end(), [&](const auto& c) { return c.first != shell; });
      if ((to - from) % 2 == 1 && !std::ranges::binary_search(on_, shell)) sights.push_back({own, shell, 1, 0});
      from = to;
    }
  }

  const Bvh& bvh_;
  const TriangleMesh& mesh_;
  const Shells& found_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossed_;  // shell and triangle
  std::vector<std::uint32_t> on_;
};

std::vector<Sight> look_around(const Bvh& bvh, const TriangleMesh& mesh, std::span<const Place> places,
                               Execution execution, const Shells& found) {
  std::vector<std::vector<Sight>> of_block(space::blocks_of(places.size(), places_of_block));
  space::for_blocks(execution, places.size(), places_of_block, [&](std::size_t b, std::size_t from, std::size_t to) {
    Look look(bvh, mesh, found);
    for (std::size_t i = from; i < to; ++i) look.from(places[i], of_block[b]);
    merge(of_block[b]);
  });
  std::vector<Sight> all;
  for (const auto& block : of_block) all.insert(all.end(), block.begin(), block.end());
  merge(all);
  return all;
}

}  // namespace

void nest_shells(const Bvh& bvh, const TriangleMesh& mesh, const std::vector<std::uint8_t>& at_others,
                 Execution execution, Shells& found) {
  std::vector<Shell>& shells = found.shells;
  if (shells.size() < 2 || std::ranges::none_of(shells, &Shell::closed)) return;
  const std::vector<Place> places = places_on(mesh, at_others, found);
  std::vector<std::uint32_t> looked(shells.size());
  for (const Place& place : places) ++looked[place.shell];
  std::vector<Sight> sights = look_around(bvh, mesh, places, execution, found);
  // What is seen on both sides crosses; so do two that are each seen inside of the other alone.
  std::erase_if(sights, [](const Sight& s) { return s.inside == 0; });
  const auto in_whole = [&](const Sight& s) { return s.inside + s.on == looked[s.shell]; };
  const auto is_mutual = [&](const Sight& s) {
    const auto back = std::ranges::lower_bound(sights, std::tie(s.around, s.shell), {}, &Sight::pair);
    return back != sights.end() && back->pair() == std::tie(s.around, s.shell) && in_whole(*back);
  };
  for (const Sight& s : sights) {
    if (!in_whole(s) || is_mutual(s)) {
      found.crossing.push_back(std::minmax(s.shell, s.around));
      shells[s.shell].crosses = shells[s.around].crosses = true;
    }
  }
  std::ranges::sort(found.crossing);
  found.crossing.erase(std::unique(found.crossing.begin(), found.crossing.end()), found.crossing.end());
  std::erase_if(sights, [&](const Sight& s) {
    return std::ranges::binary_search(found.crossing,
                                      ShellPair(std::min(s.shell, s.around), std::max(s.shell, s.around)));
  });
  for (const Sight& s : sights) ++shells[s.shell].depth;
  for (const Sight& s : sights) {
    std::optional<std::uint32_t>& parent = shells[s.shell].parent;
    if (!parent || shells[*parent].depth < shells[s.around].depth) parent = s.around;
  }
}

}  // namespace plumb::surface
