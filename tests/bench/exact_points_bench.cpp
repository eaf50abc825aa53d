// How long do comparing, orienting and sorting points take that `intersection` returned, beside CGAL's lazy ones?
//
// Names: points2 and points3 / question / kernel.  uniform: segments that cross, segments through triangles; twins: two
// points that are equal, of different figures, at thirds of integers.
#include <array>

#include "bench/measure.hpp"
#include "bench/rivals/exact_points_rival.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb::bench {
namespace {

struct Ours {
  template <class A, class B>
  static const Pairs<A, B>& taken(const Pairs<A, B>& pairs) {
    return pairs;
  }
  template <class A, class B>
  static auto point(const A& a, const B& b) {
    auto common = intersection(a, b);
    if (common.kind != IntersectionKind::point) throw std::logic_error("exact_points_bench: no point");
    return std::move(common.vertices[0]);
  }
  static bool before(const auto& p, const auto& q) { return p < q; }
  static int turn(const ExactPoint2& p, const ExactPoint2& q, const ExactPoint2& r, const ExactPoint2&) {
    return static_cast<int>(orient2d(p, q, r));
  }
  static int turn(const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r, const ExactPoint3& s) {
    return static_cast<int>(orient3d(p, q, r, s));
  }
};

double unit(Entropy& entropy) { return static_cast<double>(entropy.below(1ull << 53)) * 0x1p-53; }

/// Four points of the axes, moved anywhere: the segments cross.
void fill(Pairs<Segment2, Segment2>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Entropy e(2030, i);
    const double x = 8 * unit(e), y = 8 * unit(e);
    const auto at = [&](double dx, double dy) { return Point2{x + dx + unit(e) / 4, y + dy + unit(e) / 4}; };
    pairs[i] = {{at(-1, 0), at(1, 0)}, {at(0, -1), at(0, 1)}};
  }
}
void fill(Pairs<Segment3, Triangle3>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Entropy e(2031, i);
    const double x = 8 * unit(e), y = 8 * unit(e), z = 8 * unit(e);
    const auto at = [&](double dx, double dy, double dz) {
      return Point3{x + dx + unit(e) / 4, y + dy + unit(e) / 4, z + dz + unit(e) / 4};
    };
    pairs[i] = {{at(0, 0, -1), at(0, 0, 1)}, {at(-2, -1, 0), at(2, -1, 0), at(0, 2, 0)}};
  }
}

/// Both of each two pairs meet at a third of the integer point q: on the segment from a to q - 2 a, in the middle of
/// the triangle a, b, q - a - b.
double integer(Entropy& e) { return static_cast<double>(e.below(1ull << 30)) - 0x1p29; }
void fill_twins(Pairs<Segment2, Segment2>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Entropy of_point(2032, i / 2), e(2033, i);
    const Point2 q{integer(of_point), integer(of_point)};
    const auto through = [&] {
      const Point2 a{integer(e), integer(e)};
      return Segment2{a, {q.x - 2 * a.x, q.y - 2 * a.y}};
    };
    const Segment2 s = through();
    pairs[i] = {s, through()};
  }
}
void fill_twins(Pairs<Segment3, Triangle3>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Entropy of_point(2034, i / 2), e(2035, i);
    const Point3 q{integer(of_point), integer(of_point), integer(of_point)};
    const auto any = [&] { return Point3{integer(e), integer(e), integer(e)}; };
    const Point3 a = any(), b = any(), c = any();
    pairs[i] = {{a, {q.x - 2 * a.x, q.y - 2 * a.y, q.z - 2 * a.z}},
                {b, c, {q.x - b.x - c.x, q.y - b.y - c.y, q.z - b.z - c.z}}};
  }
}

void add_question(const std::string& name, Run run, std::size_t questions) {
  benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run), questions](benchmark::State& state) {
    long sum = run();
    for (auto _ : state) benchmark::DoNotOptimize(sum = run());
    state.counters["sum"] = static_cast<double>(sum);
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations() * questions) * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

template <class A, class B>
void register_points(const std::string& name) {
  using enum PointQuestion;
  constexpr std::size_t points = 4096, crossings = 400000;
  Pairs<A, B> uniform(points), twins(points), many(crossings);
  fill(uniform), fill(many), fill_twins(twins);
  const auto add_both = [&](const std::string& question, PointQuestion q, const Pairs<A, B>& pairs) {
    const std::size_t questions = q == equal || q == equal_first ? pairs.size() / 2 : pairs.size();
    add_question(name + "/" + question + "/plumb", point_run<Ours>(q, pairs), questions);
    add_question(name + "/" + question + "/cgal-epeck", cgal_points(q, pairs), questions);
  };
  add_both("construct", construct, uniform);
  add_both("order-first", order_first, uniform);
  add_both("order", order, uniform);
  add_both("turn-first", turn_first, uniform);
  add_both("turn", turn, uniform);
  add_both("construct-twins", construct, twins);
  add_both("equal-first", equal_first, twins);
  add_both("equal", equal, twins);
  add_both("sort-400000", sort, many);
}

[[maybe_unused]] const bool registered = [] {
  register_points<Segment2, Segment2>("points2");
  register_points<Segment3, Triangle3>("points3");
  return true;
}();

}  // namespace
}  // namespace plumb::bench
