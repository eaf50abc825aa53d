// Every point on the boundary: those within an edge become corners of both polygons at it, those within a polygon
// corners of its triangles.
#include <tuple>

#include "figure/basic/plane_of_points.hpp"
#include "figure/hull/hull3_faces.hpp"

namespace plumb::figure::hull3 {
namespace {

/// One polygon of the hull, seen in a plane.
struct Outline {
  Look look = Look::along_z;
  bool flipped = false;    // seen from inside the hull
  std::vector<Id> corner;  // nodes at which it turns, counterclockwise from outside
  std::vector<Id> within;  // nodes of the input that lie strictly within it
};

/// A node strictly within the edge between two corners.
struct OnEdge {
  Id from, to;  // corners, the smaller first
  Id node;
};

class AllPoints {
 public:
  explicit AllPoints(const Surface& surface) : surface_(surface), outlines_(surface) {
    number_polygons();
    for (Id f = 0; f < surface.faces().size(); ++f) {
      const Face& face = surface.faces()[f];
      if (!face.alive()) continue;
      for (Id q = face.flat; q != none; q = surface.nodes()[q].next) place(q, polygon_[f]);
      for (const Id v : face.vertex) {
        if (outlines_.degree(v) < 3 && !placed_[v]) place(v, polygon_[f]);
      }
    }
    std::ranges::sort(on_edges_, [this](const OnEdge& a, const OnEdge& b) {
      if (a.from != b.from || a.to != b.to) return std::tie(a.from, a.to) < std::tie(b.from, b.to);
      return before(a.node, b.node);
    });
    on_edges_.erase(std::unique(on_edges_.begin(), on_edges_.end(),
                                [this](const OnEdge& a, const OnEdge& b) {
                                  return a.from == b.from && a.to == b.to && point(a.node) == point(b.node);
                                }),
                    on_edges_.end());
    for (Outline& outline : outline_) {
      std::ranges::sort(outline.within, [this](Id a, Id b) { return before(a, b); });
      const auto same = std::unique(outline.within.begin(), outline.within.end(),
                                    [this](Id a, Id b) { return point(a) == point(b); });
      outline.within.erase(same, outline.within.end());
    }
  }

  Hull3 hull(std::size_t input_size, bool triangulate) const {
    FaceList faces;
    IndexSet vertices(input_size);
    std::vector<Id> polygon;
    for (const Outline& outline : outline_) {
      trace(outline, polygon);
      for (const Id q : polygon) vertices.insert(surface_.nodes()[q].index);
      for (const Id q : outline.within) vertices.insert(surface_.nodes()[q].index);
      if (triangulate) {
        polygon.insert(polygon.end(), outline.within.begin(), outline.within.end());
        cut(outline, polygon, faces);
      } else {
        for (const Id q : polygon) faces.corner(surface_.nodes()[q].index);
        faces.close();
      }
    }
    Hull3 hull;
    hull.dimension = 3;
    hull.vertices = vertices.ascending();
    faces.move_to(hull);
    return hull;
  }

 private:
  const Point3& point(Id node) const { return surface_.point(node); }
  bool before(Id a, Id b) const {
    const Node &p = surface_.nodes()[a], &q = surface_.nodes()[b];
    return std::tie(p.point.x, p.point.y, p.point.z, p.index) < std::tie(q.point.x, q.point.y, q.point.z, q.index);
  }

  /// Of which polygon is each triangle a part?
  void number_polygons() {
    polygon_.assign(surface_.faces().size(), none);
    placed_.assign(surface_.nodes().size(), false);
    outlines_.each([&](std::span<const Id> loop) {
      const auto id = static_cast<Id>(outline_.size());
      Outline& outline = outline_.emplace_back();
      for (const Id h : loop) {
        if (outlines_.degree(surface_.start_of(h)) >= 3) outline.corner.push_back(surface_.start_of(h));
      }
      const Point3 &a = point(outline.corner[0]), &b = point(outline.corner[1]), &c = point(outline.corner[2]);
      outline.look = look_at_plane(a, b, c);
      outline.flipped = turn(outline, a, b, c) == Sign::negative;
      std::vector<Id> stack;
      for (const Id h : loop) stack.push_back(h / 3);
      while (!stack.empty()) {
        const Id f = stack.back();
        stack.pop_back();
        if (polygon_[f] != none) continue;
        polygon_[f] = id;
        for (Id h = 3 * f; h < 3 * f + 3; ++h) {
          if (outlines_.inner(h)) stack.push_back(surface_.twin(h) / 3);
        }
      }
    });
  }

  /// Counterclockwise from outside is positive, once `flipped` is known.
  Sign turn(const Outline& o, const Point3& a, const Point3& b, const Point3& c) const {
    const Sign s = sign_of(predicates::Orient2d{}, projected(o.look, a), projected(o.look, b), projected(o.look, c));
    return o.flipped ? -s : s;
  }

  /// Puts a node that lies in the polygon within it or on its edge: the fan from the first corner is searched for the
  /// triangle that holds it.
  void place(Id q, Id polygon) {
    placed_[q] = true;
    Outline& o = outline_[polygon];
    const Point3& p = point(q);
    const auto side = [&](std::size_t a, std::size_t b) { return turn(o, point(o.corner[a]), point(o.corner[b]), p); };
    const std::size_t last = o.corner.size() - 1;
    std::size_t low = 1, high = last;  // p is left of, or on, the line to corner low, and right of, or on, that to high
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (side(0, middle) == Sign::negative ? high : low) = middle;
    }
    if (side(low, high) == Sign::zero) return add_on_edge(o.corner[low], o.corner[high], q);
    if (low == 1 && side(0, 1) == Sign::zero) return add_on_edge(o.corner[0], o.corner[1], q);
    if (high == last && side(0, last) == Sign::zero) return add_on_edge(o.corner[0], o.corner[last], q);
    o.within.push_back(q);
  }

  void add_on_edge(Id a, Id b, Id q) { on_edges_.push_back({std::min(a, b), std::max(a, b), q}); }

  /// The corners of the polygon with what lies on its edges.
  void trace(const Outline& outline, std::vector<Id>& polygon) const {
    polygon.clear();
    const auto edge_of = [](const OnEdge& e) { return std::pair(e.from, e.to); };
    for (std::size_t i = 0; i < outline.corner.size(); ++i) {
      const Id a = outline.corner[i], b = outline.corner[i + 1 == outline.corner.size() ? 0 : i + 1];
      polygon.push_back(a);
      const std::pair<Id, Id> edge = std::minmax(a, b);
      const std::size_t old = polygon.size();
      for (auto e = std::ranges::lower_bound(on_edges_, edge, {}, edge_of); e != on_edges_.end() && edge_of(*e) == edge;
           ++e) {
        polygon.push_back(e->node);
      }
      if (!precedes(point(a), point(b)))
        std::reverse(polygon.begin() + static_cast<std::ptrdiff_t>(old), polygon.end());
    }
  }
  static bool precedes(const Point3& a, const Point3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

  void cut(const Outline& outline, std::span<const Id> nodes, FaceList& faces) const {
    std::vector<figure::hull2::Indexed> seen;
    for (const Id q : nodes) seen.push_back({projected(outline.look, point(q)), surface_.nodes()[q].index});
    figure::hull2::sort_distinct(seen);
    sweep(seen, outline.flipped, faces);
  }

  const Surface& surface_;
  Outlines outlines_;
  std::vector<Outline> outline_;
  std::vector<Id> polygon_;
  std::vector<bool> placed_;
  std::vector<OnEdge> on_edges_;
};

}  // namespace

Hull3 faces_with_all_points(const Surface& surface, std::size_t input_size, bool triangulate) {
  return AllPoints(surface).hull(input_size, triangulate);
}

}  // namespace plumb::figure::hull3
