// Which triangle of a mesh does a ray hit first?
#include <algorithm>

#include "lab/trial/float_methods.hpp"
#include "lab/trial/mesh_judge.hpp"
#include "lab/trial/mesh_questions.hpp"
#include "lab/trial/plain_tree.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

namespace plumb::lab::trial {
namespace {

/// A multiple of 2^-12 below `most`, in magnitude.
double twelve_bits(Entropy& e, std::int64_t most) { return static_cast<double>(e.within(most * 4096)) / 4096; }

Point3 place_about(Entropy& e) { return {twelve_bits(e, 3), twelve_bits(e, 3), twelve_bits(e, 3)}; }

void set_ray(std::span<double> q, double name, const Point3& o, const Point3& target) {
  const std::array<double, ray_numbers> numbers{name,          0, 1, 2, o.x, o.y, o.z, target.x - o.x, target.y - o.y,
                                                target.z - o.z};
  std::ranges::copy(numbers, q.begin());
}

/// From around a ring to a place in its box; `far` moves both.
void fill_any_ray(std::span<double> q, Entropy& e, double name, double far = 0) {
  const Point3 o = place_about(e);
  Point3 target{twelve_bits(e, 1), twelve_bits(e, 1), twelve_bits(e, 1) * 0.25};
  if (target.x == o.x) target.x += 0x1p-12;  // a direction
  set_ray(q, name, {o.x + far, o.y + far, o.z + far}, {target.x + far, target.y + far, target.z + far});
}

/// At a vertex, or at the middle of an edge.
void fill_aimed_ray(std::span<double> q, Entropy& e, const TriangleMesh& ring, double name, bool turned) {
  const auto& corners = ring.triangles[e.below(ring.triangles.size())];
  const std::size_t i = e.below(3);
  const Point3 &a = ring.vertices[corners[i]], &b = e.coin() ? a : ring.vertices[corners[(i + 1) % 3]];
  Point3 target{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, o = place_about(e);
  if (o == target) o.x += 1;
  if (turned) {
    o = turned_point(o), target = turned_point(target);
  }
  set_ray(q, name, o, target);
}

void fill_integer_ray(std::span<double> q, Entropy& e) {
  const auto small = [&e](std::int64_t most) { return static_cast<double>(e.within(most)); };
  const Point3 o{small(7), small(7), small(7)};
  Vector3 d{small(2), small(2), small(2)};
  if (d == Vector3{0, 0, 0}) d.x = 1;
  set_ray(q, mesh_name(Surface::heap), o, {o.x + d.x, o.y + d.y, o.z + d.z});
}

std::vector<InputClass> closest_hit_classes() {
  const auto shelf = std::make_shared<MeshShelf>();
  const double ring = mesh_name(Surface::ring);
  const double turned = mesh_name(Surface::ring, {.turned = true}), far = mesh_name(Surface::ring, {.far = true});
  return {
      {"generic", "a closed ring of 6,400 triangles, all numbers floats",
       [=](std::span<double> q, Entropy& e) { fill_any_ray(q, e, ring); }},
      {"vertices_and_edges", "the same; each ray at a vertex or the middle of an edge, exactly",
       [=](std::span<double> q, Entropy& e) { fill_aimed_ray(q, e, (*shelf)(ring), ring, false); }},
      {"near_ties", "three closed rings of 2,304 triangles, 2^-20 and 2^-50 apart",
       [](std::span<double> q, Entropy& e) { fill_any_ray(q, e, mesh_name(Surface::shells)); }},
      {"degenerate", "2,000 triangles of small integers, in heaps; rays along their planes and edges",
       [](std::span<double> q, Entropy& e) { fill_integer_ray(q, e); }},
      {"far_away", "as generic, a million from the origin",
       [=](std::span<double> q, Entropy& e) { fill_any_ray(q, e, far, 0x1p20); }},
      {"turned", "as vertices_and_edges, mesh and rays turned alike, and rounded",
       [=](std::span<double> q, Entropy& e) { fill_aimed_ray(q, e, (*shelf)(ring), turned, true); }},
  };
}

template <class T>
Method plain_rays(std::string name, std::string about, T epsilon) {
  struct Cast {
    Vec<T> origin, direction;
  };
  return of_one_mesh<ray_numbers>(
      std::move(name), std::move(about), [=](const TriangleMesh& m) { return PlainTree<T>(m, epsilon); },
      [](std::span<const double> q) {
        return Cast{{T(q[4]), T(q[5]), T(q[6])}, {T(q[7]), T(q[8]), T(q[9])}};
      },
      [](const PlainTree<T>& tree, const Cast& r) { return tree.first(r.origin, r.direction); });
}

/// All rays of a mesh at once.
class RayBatches final : public Round {
 public:
  explicit RayBatches(std::span<const double> questions) : places_(questions.size() / ray_numbers) {
    std::map<MeshKey, std::size_t> numbers;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto q = questions.subspan(i * ray_numbers, ray_numbers);
      const auto [at, is_new] = numbers.emplace(key_of(q), of_mesh_.size());
      if (is_new) of_mesh_.push_back({build_bvh(mesh_of(key_of(q))), {}, {}});
      Batch& batch = of_mesh_[at->second];
      places_[i] = {at->second, batch.rays.size()};
      batch.rays.emplace_back(ray_in(q));
      batch.first.push_back(no_triangle);
    }
  }
  void answer() override {
    for (Batch& b : of_mesh_) first_triangle(b.bvh, b.rays, b.first, {.execution = Execution::serial});
  }
  [[nodiscard]] double given(std::size_t i) const override {
    const std::uint32_t first = of_mesh_[places_[i].first].first[places_[i].second];
    return first == no_triangle ? no_item : first;
  }

 private:
  struct Batch {
    Bvh bvh;
    std::vector<AnyRay> rays;
    std::vector<std::uint32_t> first;
  };
  std::vector<Batch> of_mesh_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
};

/// Hits of equal parameters are equally first.
class HitJudge {
 public:
  double first(std::span<const double> q) {
    const auto number = shelf_(key_of(q)).first(origin(q), direction(q));
    return number ? *number : no_item;
  }
  bool equally_first(std::span<const double> q, double truth, double said) {
    const JudgedMesh& mesh = shelf_(key_of(q));
    if (truth == no_item || said < 0 || said >= static_cast<double>(mesh.size())) return false;
    const auto at = [&](double number) {
      return first_meeting(origin(q), direction(q), mesh.triangle(static_cast<std::uint32_t>(number)));
    };
    const auto hit = at(said);
    return hit && *hit == *at(truth);
  }

 private:
  static IntegerVec origin(std::span<const double> q) { return integer_vec(q[4], q[5], q[6]); }
  static IntegerVec direction(std::span<const double> q) { return integer_vec(q[7], q[8], q[9]); }
  JudgedShelf shelf_;
};

}  // namespace

Task closest_hit_task() {
  Task task{"closest-hit",
            "which triangle of a mesh does a ray hit first?",
            ray_numbers,
            AnswerKind::item,
            {},
            {},
            {},
            {},
            4};
  task.classes = closest_hit_classes();
  task.symmetries = {mesh_axes_in_turn(1, 2)};
  const auto judge = std::make_shared<HitJudge>();
  task.judge = [judge](std::span<const double> q) { return judge->first(q); };
  task.accepts = [judge](std::span<const double> q, double truth, double said) {
    return judge->equally_first(q, truth, said);
  };
  task.tallies = {{"missed", "rays that hit a triangle, but none by this method: leaks, where the mesh is closed",
                   [](std::span<const double>, double truth, const Round& round, std::size_t i) {
                     return std::uint64_t{truth != no_item && round.given(i) == no_item};
                   }}};
  task.methods.push_back(plain_rays<float>("float32", "our tree in single precision, of coordinates rounded to it", 0));
  task.methods.push_back(plain_rays<double>("double", "our tree, slabs and triangles as commonly written", 0));
  task.methods.push_back(plain_rays<double>("absolute", "double, with an epsilon of 1e-9", customary_epsilon));
  task.methods.push_back(of_one_mesh<ray_numbers>(
      "exact", "ours, one ray at a time", [](const TriangleMesh& m) { return build_bvh(m); },
      [](std::span<const double> q) { return AnyRay(ray_in(q)); },
      [](const Bvh& bvh, const AnyRay& ray) {
        const auto first = first_triangle(bvh, ray);
        return first ? *first : no_item;
      }));
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            return std::make_unique<RayBatches>(questions);
                          }});
  return task;
}

}  // namespace plumb::lab::trial
