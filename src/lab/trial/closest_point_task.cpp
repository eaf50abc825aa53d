// Which triangle of a mesh is nearest to a point?
#include <algorithm>

#include "lab/trial/float_methods.hpp"
#include "lab/trial/mesh_judge.hpp"
#include "lab/trial/mesh_questions.hpp"
#include "lab/trial/plain_tree.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"

namespace plumb::lab::trial {
namespace {

void set_place(std::span<double> q, double name, const Point3& p) {
  const std::array<double, place_numbers> numbers{name, 0, 1, 2, p.x, p.y, p.z};
  std::ranges::copy(numbers, q.begin());
}

double quarter(Entropy& e, std::int64_t most) { return static_cast<double>(e.within(4 * most)) / 4; }

/// Within the ring's box, on a lattice of single-precision numbers.
Point3 place_near_ring(Entropy& e) {
  const auto number = [&e](std::int64_t most) { return static_cast<double>(e.within(most)) / 65536; };
  return {number(105'000), number(105'000), number(40'000)};
}

std::vector<InputClass> closest_point_classes() {
  const double ring = mesh_name(Surface::ring), blocks = mesh_name(Surface::blocks);
  return {
      {"generic", "a closed ring of 6,400 triangles, points in its box, all numbers floats",
       [=](std::span<double> q, Entropy& e) { set_place(q, ring, place_near_ring(e)); }},
      {"vertices_and_edges", "a cube of unit squares, points of quarters: often equally near to several",
       [=](std::span<double> q, Entropy& e) {
         set_place(q, blocks, {3 + quarter(e, 4), 3 + quarter(e, 4), 3 + quarter(e, 4)});
       }},
      {"near_ties", "three closed rings of 2,304 triangles, 2^-20 and 2^-50 apart",
       [](std::span<double> q, Entropy& e) { set_place(q, mesh_name(Surface::shells), place_near_ring(e)); }},
      {"degenerate", "2,000 triangles of small integers, in heaps; points of halves",
       [](std::span<double> q, Entropy& e) {
         const auto half = [&e] { return static_cast<double>(e.within(18)) / 2; };
         const double x = half(), y = half(), z = half();
         set_place(q, mesh_name(Surface::heap), {x, y, z});
       }},
      {"far_away", "as generic, a million from the origin",
       [](std::span<double> q, Entropy& e) {
         const Point3 p = place_near_ring(e);
         set_place(q, mesh_name(Surface::ring, {.far = true}), {p.x + 0x1p20, p.y + 0x1p20, p.z + 0x1p20});
       }},
      {"turned", "as vertices_and_edges, mesh and points turned alike, and rounded",
       [](std::span<double> q, Entropy& e) {
         const double x = 3 + quarter(e, 4), y = 3 + quarter(e, 4), z = 3 + quarter(e, 4);
         set_place(q, mesh_name(Surface::blocks, {.turned = true}), turned_point({x, y, z}));
       }},
  };
}

template <class T>
Method plain_places(std::string name, std::string about) {
  return of_one_mesh<place_numbers>(
      std::move(name), std::move(about), [](const TriangleMesh& m) { return PlainTree<T>(m, 0); },
      [](std::span<const double> q) {
        return Vec<T>{T(q[4]), T(q[5]), T(q[6])};
      },
      [](const PlainTree<T>& tree, const Vec<T>& p) { return tree.nearest(p); });
}

class PlaceBatches final : public Round {
 public:
  explicit PlaceBatches(std::span<const double> questions) : places_(questions.size() / place_numbers) {
    std::map<MeshKey, std::size_t> numbers;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto q = questions.subspan(i * place_numbers, place_numbers);
      const auto [at, is_new] = numbers.emplace(key_of(q), of_mesh_.size());
      if (is_new) of_mesh_.push_back({build_bvh(mesh_of(key_of(q))), {}, {}});
      Batch& batch = of_mesh_[at->second];
      places_[i] = {at->second, batch.points.size()};
      batch.points.push_back(place_in(q));
      batch.nearest.emplace_back();
    }
  }
  void answer() override {
    for (Batch& b : of_mesh_) closest_on_mesh(b.bvh, b.points, b.nearest, {.execution = Execution::serial});
  }
  [[nodiscard]] double given(std::size_t i) const override {
    return of_mesh_[places_[i].first].nearest[places_[i].second].triangle;
  }

 private:
  struct Batch {
    Bvh bvh;
    std::vector<Point3> points;
    std::vector<ClosestOnMesh> nearest;
  };
  std::vector<Batch> of_mesh_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;
};

/// Squares of distances, exactly: equal ones are equally near.
class NearestJudge {
 public:
  double nearest(std::span<const double> q) { return shelf_(key_of(q)).nearest(place(q)); }
  bool equally_near(std::span<const double> q, double truth, double said) {
    return is_triangle(q, said) && square(q, said) == square(q, truth);
  }
  bool far_off(std::span<const double> q, double truth, double said) {
    const mpq_class more = 1 + mpq_class(1, 10'000);
    return !is_triangle(q, said) || square(q, said) > more * more * square(q, truth);
  }

 private:
  static IntegerVec place(std::span<const double> q) { return integer_vec(q[4], q[5], q[6]); }
  bool is_triangle(std::span<const double> q, double said) {
    return said >= 0 && said < static_cast<double>(shelf_(key_of(q)).size());
  }
  mpq_class square(std::span<const double> q, double number) {
    return square_distance(place(q), shelf_(key_of(q)).triangle(static_cast<std::uint32_t>(number)));
  }
  JudgedShelf shelf_;
};

}  // namespace

Task closest_point_task() {
  Task task{"closest-point-on-mesh",
            "which triangle of a mesh is nearest to a point?",
            place_numbers,
            AnswerKind::item,
            {},
            {},
            {},
            {},
            8};
  task.classes = closest_point_classes();
  task.symmetries = {mesh_axes_in_turn(1, 1)};
  const auto judge = std::make_shared<NearestJudge>();
  task.judge = [judge](std::span<const double> q) { return judge->nearest(q); };
  task.accepts = [judge](std::span<const double> q, double truth, double said) {
    return judge->equally_near(q, truth, said);
  };
  task.tallies = {{"far off", "triangles that are farther than the nearest by more than 1e-4 of its distance",
                   [judge](std::span<const double> q, double truth, const Round& round, std::size_t i) {
                     return std::uint64_t{judge->far_off(q, truth, round.given(i))};
                   }}};
  task.methods.push_back(plain_places<float>("float32", "our tree in single precision, of coordinates rounded to it"));
  task.methods.push_back(plain_places<double>("double", "our tree, distances as commonly written"));
  task.methods.push_back(of_one_mesh<place_numbers>(
      "exact", "ours, one point at a time", [](const TriangleMesh& m) { return build_bvh(m); }, place_in,
      [](const Bvh& bvh, const Point3& p) { return static_cast<double>(closest_on_mesh(bvh, p)->triangle); }));
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            return std::make_unique<PlaceBatches>(questions);
                          }});
  return task;
}

}  // namespace plumb::lab::trial
