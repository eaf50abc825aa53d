// Which of many points is nearest to a place?
#include <algorithm>
#include <memory>

#include "lab/crowd/crowds.hpp"
#include "lab/trial/float_methods.hpp"
#include "lab/trial/mesh_judge.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"

namespace plumb::lab::trial {
namespace {

void set_crowd_place(std::span<double> q, Spread spread, const Point3& p) {
  const std::array<double, place_numbers> numbers{crowd_name(spread), 0, 1, 2, p.x, p.y, p.z};
  std::ranges::copy(numbers, q.begin());
}

/// A multiple of 1/parts from -most to most, away from `from`.
Point3 place_about(Entropy& e, double from, std::int64_t most, double parts) {
  const auto number = [&] { return from + static_cast<double>(e.within(most)) / parts; };
  const double x = number(), y = number(), z = number();
  return {x, y, z};
}

std::vector<InputClass> crowd_place_classes() {
  const auto spread_out = [](Spread spread, double from, std::int64_t most, double parts) {
    return [=](std::span<double> q, Entropy& e) { set_crowd_place(q, spread, place_about(e, from, most, parts)); };
  };
  constexpr std::int64_t half = std::int64_t{1} << 29;
  return {
      {"uniform", "1,024 points in a cube, places in it", spread_out(Spread::uniform, 0.5, half, 0x1p30)},
      {"clustered", "1,024 points in eight clusters", spread_out(Spread::clustered, 0.5, half, 0x1p30)},
      {"near_ties", "1,024 points of a sphere, rounded; places 2^-47 and less from its center",
       spread_out(Spread::sphere, 0, 8, 0x1p50)},
      {"ties", "points of a lattice, places of quarters: often equally near to several",
       spread_out(Spread::touching, 0, 20, 4)},
      {"degenerate", "1,024 points in 125 places, places of halves", spread_out(Spread::degenerate, 0, 6, 2)},
      {"far_away", "as uniform, a million from the origin", spread_out(Spread::far, 0x1p20 + 0.5, half, 0x1p30)},
  };
}

/// Every point, one after the other.
template <class T>
Method each_point(std::string name, std::string about) {
  return of_point_crowds(std::move(name), std::move(about), [](const std::vector<Point3>& points) -> FindNearest {
    const auto rounded = [](const Point3& p) { return Vec<T>{T(p.x), T(p.y), T(p.z)}; };
    std::vector<Vec<T>> made;
    for (const Point3& p : points) made.push_back(rounded(p));
    return [made, rounded](const Point3& place) {
      const Vec<T> from = rounded(place);
      std::size_t best = 0;
      T least = dot(made[0] - from, made[0] - from);
      for (std::size_t i = 1; i < made.size(); ++i) {
        const Vec<T> way = made[i] - from;
        const T square = dot(way, way);
        if (square < least) least = square, best = i;
      }
      return static_cast<std::uint32_t>(best);
    };
  });
}

class PlacesTogether final : public Round {
 public:
  explicit PlacesTogether(std::span<const double> questions) {
    std::map<MeshKey, std::size_t> numbers;
    for (std::size_t i = 0; i < questions.size(); i += place_numbers) {
      const auto q = questions.subspan(i, place_numbers);
      const auto [at, is_new] = numbers.emplace(key_of(q), crowds_.size());
      if (is_new) crowds_.push_back({build_kd_tree(point_crowd(key_of(q))), {}, {}});
      Crowd& crowd = crowds_[at->second];
      where_.push_back({at->second, crowd.places.size()});
      crowd.places.push_back(place_in(q));
      crowd.found.emplace_back();
    }
  }
  void answer() override {
    for (Crowd& c : crowds_) nearest(c.tree, c.places, c.found, Execution::serial);
  }
  [[nodiscard]] double given(std::size_t i) const override {
    return crowds_[where_[i].first].found[where_[i].second].index;
  }

 private:
  struct Crowd {
    KdTree3 tree;
    std::vector<Point3> places;
    std::vector<NearestPoint> found;
  };
  std::vector<Crowd> crowds_;
  std::vector<std::pair<std::size_t, std::size_t>> where_;
};

/// Squares of distances in GMP's integers: of all points; equal ones are equally near.
class CrowdJudge {
 public:
  double nearest(std::span<const double> q) {
    const IntegerVec place = integer_vec(q[4], q[5], q[6]);
    const std::vector<IntegerVec>& all = points(q);
    std::size_t best = 0;
    mpz_class least = square_between(all[0], place);
    for (std::size_t i = 1; i < all.size(); ++i) {
      mpz_class square = square_between(all[i], place);
      if (square < least) least = std::move(square), best = i;
    }
    return static_cast<double>(best);
  }
  bool equally_near(std::span<const double> q, double truth, double said) {
    return is_point(said) && square(q, said) == square(q, truth);
  }
  bool far_off(std::span<const double> q, double truth, double said) {
    const mpz_class in(10'000), most(10'001);
    return !is_point(said) || in * in * square(q, said) > most * most * square(q, truth);
  }

 private:
  static bool is_point(double said) { return said >= 0 && said < 2 * static_cast<double>(crowd_size); }
  static mpz_class square_between(const IntegerVec& a, const IntegerVec& b) {
    const mpz_class x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
  }
  mpz_class square(std::span<const double> q, double number) {
    return square_between(points(q)[static_cast<std::size_t>(number)], integer_vec(q[4], q[5], q[6]));
  }
  const std::vector<IntegerVec>& points(std::span<const double> q) {
    std::vector<IntegerVec>& made = made_[key_of(q)];
    if (made.empty()) {
      for (const Point3& p : point_crowd(key_of(q))) made.push_back(integer_vec(p.x, p.y, p.z));
    }
    return made;
  }
  std::map<MeshKey, std::vector<IntegerVec>> made_;
};

}  // namespace

Task nearest_point_task() {
  Task task{"nearest-point",
            "which of 1,024 points is nearest to a place?",
            place_numbers,
            AnswerKind::item,
            {},
            {},
            {},
            {},
            16};
  task.classes = crowd_place_classes();
  task.symmetries = {mesh_axes_in_turn(1, 1)};
  const auto judge = std::make_shared<CrowdJudge>();
  task.judge = [judge](std::span<const double> q) { return judge->nearest(q); };
  task.accepts = [judge](std::span<const double> q, double truth, double said) {
    return judge->equally_near(q, truth, said);
  };
  task.tallies = {{"far off", "points that are farther than the nearest by more than 1e-4 of its distance",
                   [judge](std::span<const double> q, double truth, const Round& round, std::size_t i) {
                     return std::uint64_t{judge->far_off(q, truth, round.given(i))};
                   }}};
  task.methods.push_back(
      each_point<float>("float32", "every point, in single precision, of coordinates rounded to it"));
  task.methods.push_back(each_point<double>("double", "every point, squares of distances as commonly written"));
  task.methods.push_back(
      of_point_crowds("exact", "ours, one place at a time", [](const std::vector<Point3>& points) -> FindNearest {
        return [tree = build_kd_tree(points)](const Point3& p) { return nearest(tree, p).index; };
      }));
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            return std::make_unique<PlacesTogether>(questions);
                          }});
  return task;
}

}  // namespace plumb::lab::trial
