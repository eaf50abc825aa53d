// How long does a common set take, beside CGAL's rounded and exact ones and plain doubles, on every class of input?
// And what do integers save on lattices?  `plumb` constructs the exact set; `nearest` rounds its corners as well.
#include <cmath>

#include "bench/measure.hpp"
#include "bench/rivals/intersection_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/query/overlap/lattice2.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t pairs_of_class = 1024;

Point2 point2(const double* c) { return {c[0], c[1]}; }
Point3 point3(const double* c) { return {c[0], c[1], c[2]}; }
void make(Segment2& s, const double* c) { s = {point2(c), point2(c + 2)}; }
void make(Segment3& s, const double* c) { s = {point3(c), point3(c + 3)}; }
void make(Triangle2& t, const double* c) { t = {point2(c), point2(c + 2), point2(c + 4)}; }
void make(Triangle3& t, const double* c) { t = {point3(c), point3(c + 3), point3(c + 6)}; }
void make(Aabb3& b, const double* c) {
  b = {{std::fmin(c[0], c[3]), std::fmin(c[1], c[4]), std::fmin(c[2], c[5])},
       {std::fmax(c[0], c[3]), std::fmax(c[1], c[4]), std::fmax(c[2], c[5])}};
}
template <class Figure>
constexpr std::size_t points_of = std::is_same_v<Figure, Triangle2> || std::is_same_v<Figure, Triangle3> ? 3 : 2;

template <class A, class B>
Pairs<A, B> pairs_of(const std::string& family) {
  constexpr bool flat = std::is_same_v<A, Segment2> || std::is_same_v<A, Triangle2>;
  constexpr std::size_t dimension = flat ? 2 : 3;
  Pairs<A, B> pairs(pairs_of_class);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::vector<double> c(dimension * (points_of<A> + points_of<B>));
    Entropy entropy(2026, i);
    fill_points(*family_named(family), flat ? Degeneracy::collinear : Degeneracy::coplanar, dimension, c, entropy);
    make(pairs[i].first, c.data());
    make(pairs[i].second, c.data() + dimension * points_of<A>);
  }
  return pairs;
}

void add_run(const std::string& name, Run run, double pairs) {
  if (!run) return;
  benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run), pairs](benchmark::State& state) {
    long met = 0;
    for (auto _ : state) benchmark::DoNotOptimize(met = run());
    state.counters["met"] = static_cast<double>(met) / pairs;
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * pairs * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

template <class A, class B, class Ask>
Run each(const Pairs<A, B>& pairs, Ask ask) {
  return [all = std::make_shared<Pairs<A, B>>(pairs), ask] {
    long met = 0;
    for (const auto& [a, b] : *all) met += ask(a, b) ? 1 : 0;
    return met;
  };
}

template <class A, class B>
void register_pair(const std::string& name) {
  for (const FamilyInfo& f : families) {
    const Pairs<A, B> pairs = pairs_of<A, B>(std::string(f.name));
    const std::string start = name + "/" + std::string(f.name) + "/";
    const auto n = static_cast<double>(pairs.size());
    add_run(start + "plumb", each(pairs, [](const A& a, const B& b) { return !intersection(a, b).empty(); }), n);
    add_run(start + "nearest",
            each(pairs, [](const A& a, const B& b) { return !approximate(intersection(a, b)).empty(); }), n);
    if constexpr (points_of<A> == 2) {
      add_run(start + "plain",
              each(pairs,
                   [](const A& a, const B& b) {
                     decltype(A::a) at{};
                     const bool met = crossing_in_doubles(a, b, at);
                     benchmark::DoNotOptimize(at);
                     return met;
                   }),
              n);
    }
    // CGAL's clipping by rounded corners divides by zero on others, and of coplanar triangles erases what is not there.
    const bool plain = f.family == Family::grid || f.family == Family::uniform || f.family == Family::float32;
    const bool exact =
        f.family == Family::degenerate_short ||
        (f.family == Family::degenerate_long && !std::is_same_v<std::pair<A, B>, std::pair<Triangle3, Triangle3>>);
    if (!plain && (!exact || std::is_same_v<A, Triangle2>)) continue;
    add_run(start + "cgal-epick", cgal_rounded(pairs), n);
    add_run(start + "cgal-epeck", cgal_exact(pairs), n);
  }
}

/// A plane across many small triangles, as a mesh is cut.
void register_planes() {
  Pairs<Plane3, Triangle3> planes(cases);
  Pairs<ThreePointPlane3, Triangle3> by_points(cases);
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(2028, i);
    std::array<double, 12> c;
    for (double& x : c) x = signed_unit_coordinate(entropy);
    const auto corner = [&](std::size_t k) {
      return Point3{c[0] + c[k] / 32, c[1] + c[k + 1] / 32, c[2] + c[k + 2] / 32};
    };
    const Triangle3 t{corner(3), corner(6), corner(9)};
    planes[i] = {{{0.25, 0.5, 1}, 0.125}, t};
    by_points[i] = {{{0, 0, 0.125}, {0.5, 0, 0}, {0, 0.25, 0}}, t};
  }
  const auto add_all = [n = static_cast<double>(cases)](const std::string& start, const auto& pairs) {
    add_run(start + "plumb", each(pairs, [](const auto& a, const auto& b) { return !intersection(a, b).empty(); }), n);
    add_run(start + "intersects", each(pairs, [](const auto& a, const auto& b) { return intersects(a, b); }), n);
    add_run(start + "cgal-epick", cgal_rounded(pairs), n);
    add_run(start + "cgal-epeck", cgal_exact(pairs), n);
  };
  add_all("plane3-triangle3/uniform/", planes);
  add_all("three-point-plane3-triangle3/uniform/", by_points);
}

/// Segments that end near one another, by the general test on doubles and by the plan's.
void register_lattice(int bits, bool degenerate) {
  const std::string start =
      std::string("lattice-segments/") + (degenerate ? "degenerate-" : "random-") + std::to_string(bits) + "/";
  const auto given = std::make_shared<Pairs<Segment2, Segment2>>();
  const auto kernel = std::make_shared<Kernel>(plan(Lattice{0, bits}));
  const auto s = std::make_shared<std::vector<LatticeSegment2>>(), t = std::make_shared<std::vector<LatticeSegment2>>();
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(2027, i);
    std::array<double, 8> c;
    if (degenerate) {
      fill_exact(Degeneracy::collinear, 2, bits, c, entropy);
    } else {
      for (double& x : c) x = grid_coordinate(entropy, bits);
    }
    given->push_back({{point2(&c[0]), point2(&c[2])}, {point2(&c[4]), point2(&c[6])}});
    const auto taken = [&](const Point2& p) { return kernel->point(p); };
    s->push_back({taken(given->back().first.a), taken(given->back().first.b)});
    t->push_back({taken(given->back().second.a), taken(given->back().second.b)});
  }
  const auto n = static_cast<double>(cases);
  add_run(start + "general", each(*given, [](const Segment2& a, const Segment2& b) { return intersects(a, b); }), n);
  add_run(start + "plain",
          each(*given,
               [](const Segment2& a, const Segment2& b) {
                 Point2 at{};
                 return crossing_in_doubles(a, b, at);
               }),
          n);
  add_run(
      start + "plan",
      [kernel, s, t, out = std::make_shared<std::vector<Relation>>(cases)] {
        LatticeTests2(*kernel).relate(*s, *t, *out);
        return static_cast<long>(cases) - std::ranges::count(*out, Relation::disjoint);
      },
      n);
  add_run(
      start + "plan-each",
      [kernel, s, t] {
        long met = 0;
        const LatticeTests2 tests(*kernel);
        for (std::size_t i = 0; i < cases; ++i) met += tests.intersects((*s)[i], (*t)[i]) ? 1 : 0;
        return met;
      },
      n);
}

[[maybe_unused]] const bool registered = [] {
  register_pair<Segment2, Segment2>("segment2-segment2");
  register_pair<Triangle2, Triangle2>("triangle2-triangle2");
  register_pair<Segment3, Triangle3>("segment3-triangle3");
  register_pair<Triangle3, Triangle3>("triangle3-triangle3");
  register_pair<Triangle3, Aabb3>("triangle3-aabb3");
  register_planes();
  for (const int bits : {8, 16, 25, 31, 40, 53}) {
    register_lattice(bits, false);
    if (bits <= 40) register_lattice(bits, true);
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench
