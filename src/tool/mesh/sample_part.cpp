#include "tool/mesh/sample_part.hpp"

#include <map>
#include <optional>

#include "tool/mesh/flange.hpp"

namespace plumb::tool {
namespace {

struct Rotation {
  double c, s;
  explicit Rotation(double t) : c((1 - t * t) / (1 + t * t)), s(2 * t / (1 + t * t)) {}
};

void turn(TriangleMesh& mesh) {
  const Rotation about_z(0.2743), about_x(0.3617);
  for (Point3& p : mesh.vertices) {
    const double x = about_z.c * p.x - about_z.s * p.y, y = about_z.s * p.x + about_z.c * p.y;
    p = {x + 3.7, about_x.c * y - about_x.s * p.z - 11.3, about_x.s * y + about_x.c * p.z + 7.9};
  }
}

/// (a + b) / 2 where that is a double.
std::optional<double> exact_middle(double a, double b) {
  const double sum = a + b, b_part = sum - a, a_part = sum - b_part;
  if ((a - a_part) + (b - b_part) != 0) return std::nullopt;  // the rounding error of the sum, exactly (Knuth)
  return sum / 2;
}

std::optional<Point3> exact_middle(const Point3& a, const Point3& b) {
  const auto x = exact_middle(a.x, b.x), y = exact_middle(a.y, b.y), z = exact_middle(a.z, b.z);
  if (!x || !y || !z) return std::nullopt;
  return Point3{*x, *y, *z};
}

Point3 rounded_middle(const Point3& a, const Point3& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}; }

/// Puts defects into a mesh, no two of them at the same vertex.
class Spoiler {
 public:
  explicit Spoiler(TriangleMesh& mesh) : mesh_(mesh), touched_(mesh.vertices.size(), false) {}

  void keep_clear(const Ring& ring) {
    for (const std::uint32_t v : ring) touched_[v] = true;
  }
  void keep_clear(std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t f = first; f < last; ++f) touch(f);
  }

  /// Faces first..last use copies of the ring's vertices from here on.
  void unmerge(const Ring& ring, std::uint32_t first, std::uint32_t last) {
    std::map<std::uint32_t, std::uint32_t> copy;
    for (const std::uint32_t v : ring) copy[v] = add_vertex(mesh_.vertices[v]);
    for (std::uint32_t f = first; f < last; ++f) {
      for (std::uint32_t& v : mesh_.triangles[f]) {
        if (const auto found = copy.find(v); found != copy.end()) v = found->second;
      }
    }
  }

  /// Splits the side ab of face f at m and closes the gap to the neighbor, which still has the whole side, by (a, b,
  /// m).
  void split(std::uint32_t f, const Point3& m) {
    touch(f);
    const auto [a, b, c] = mesh_.triangles[f];
    const std::uint32_t v = add_vertex(m);
    mesh_.triangles[f] = {a, v, c};
    mesh_.triangles.push_back({v, b, c});
    mesh_.triangles.push_back({a, b, v});
  }

  enum class Where { exactly_on_the_edge, rounded_off_the_edge, at_its_end };

  /// Splits the first sides of `count` untouched faces, going through the mesh in even strides.
  void split_some(int count, Where where) {
    const auto faces = static_cast<std::uint32_t>(mesh_.triangles.size());
    for (std::uint32_t i = 0; count > 0 && i < faces; ++i) {
      at_ = (at_ + 997) % faces;  // prime, so that the stride meets every face in the end
      if (is_touched(at_)) continue;
      const Point3 a = mesh_.vertices[mesh_.triangles[at_][0]], b = mesh_.vertices[mesh_.triangles[at_][1]];
      const auto middle = exact_middle(a, b);
      if (where == Where::at_its_end) {
        split(at_, a);
      } else if (middle && where == Where::exactly_on_the_edge) {
        split(at_, *middle);
      } else if (!middle && where == Where::rounded_off_the_edge) {
        split(at_, rounded_middle(a, b));
      } else {
        continue;
      }
      --count;
    }
  }

  /// A third face on the first side of face f, standing off from its far corner.
  void add_fin(std::uint32_t f) {
    touch(f);
    const auto [a, b, c] = mesh_.triangles[f];
    const Point3 p = mesh_.vertices[a], q = mesh_.vertices[b], r = mesh_.vertices[c];
    const auto beyond = [](double s, double t, double far) { return (s + t) / 2 + ((s + t) / 2 - far) / 2; };
    mesh_.triangles.push_back(
        {a, b, add_vertex({beyond(p.x, q.x, r.x), beyond(p.y, q.y, r.y), beyond(p.z, q.z, r.z)})});
  }

  /// Takes out the next untouched face.
  void remove_one() {
    while (is_touched(at_)) at_ = (at_ + 997) % static_cast<std::uint32_t>(mesh_.triangles.size());
    mesh_.triangles.erase(mesh_.triangles.begin() + at_);
  }

 private:
  std::uint32_t add_vertex(const Point3& p) {
    mesh_.vertices.push_back(p);
    touched_.push_back(true);
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  void touch(std::uint32_t f) {
    for (const std::uint32_t v : mesh_.triangles[f]) touched_[v] = true;
  }
  [[nodiscard]] bool is_touched(std::uint32_t f) const {
    const auto [a, b, c] = mesh_.triangles[f];
    return touched_[a] || touched_[b] || touched_[c];
  }

  TriangleMesh& mesh_;
  std::vector<bool> touched_;
  std::uint32_t at_ = 0;
};

}  // namespace

TriangleMesh sample_part() {
  Flange flange = build_flange();
  TriangleMesh& mesh = flange.mesh;
  turn(mesh);
  Spoiler spoil(mesh);
  spoil.keep_clear(flange.bore_edge);
  for (const std::uint32_t f : flange.cap_faces) spoil.keep_clear(f, f + 1);
  spoil.unmerge(flange.bore_edge, flange.bore_first, flange.bore_last);
  spoil.add_fin(flange.rim_first);
  spoil.split_some(SampleDefects::kExactJunctions, Spoiler::Where::exactly_on_the_edge);
  spoil.split_some(SampleDefects::kRoundedJunctions, Spoiler::Where::rounded_off_the_edge);
  spoil.split_some(SampleDefects::kCollapsedEdges, Spoiler::Where::at_its_end);
  spoil.remove_one();
  return std::move(mesh);
}

}  // namespace plumb::tool
