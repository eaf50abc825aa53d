// Are the searches bounded whatever the exponents are?  Instructions are counted, since times differ from run to run:
// for nine points of ordinary exponents, and for nine whose exponents span all that doubles have.
//
// The processor's counter is asked where there is one, else callgrind runs this program again.  Each row of the table
// says what its question may take; what the headers say of cost is held here.
#include <gtest/gtest.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define PLUMB_HAS_CALLGRIND 1
#else
#define PLUMB_HAS_CALLGRIND 0
#endif

#include "plumb/degenerate.hpp"
#include "plumb/plumb.hpp"

#if defined(__SANITIZE_ADDRESS__)
#error "instructions are counted of what users run: without sanitizers"
#endif

namespace plumb {
namespace {

/// Two sets of points, and what is made of them before counting.
struct Cloud {
  std::vector<Point3> a, b;
  std::vector<Point2> flat;
  ConvexPolyhedron3 p, q;
  TriangleMesh mesh, other;
};

enum class Exponents { ordinary, of_points, of_coordinates };

Cloud cloud(Exponents exponents, std::uint64_t index) {
  Entropy entropy(501, index);
  const auto any_exponent = [&] { return static_cast<int>(entropy.below(1429)) - 801; };
  const auto set = [&] {
    std::vector<Point3> points(9);
    for (Point3& p : points) {
      const int common = exponents == Exponents::of_points ? any_exponent() : 0;
      const auto number = [&] {
        return std::ldexp(signed_unit_coordinate(entropy),
                          exponents == Exponents::of_coordinates ? any_exponent() : common);
      };
      p = {number(), number(), number()};
    }
    return points;
  };
  const auto mesh_of = [](const std::vector<Point3>& points) {
    TriangleMesh mesh{points, {}};
    for (std::uint32_t i = 0; i + 2 < points.size(); ++i) mesh.triangles.push_back({i, i + 1, i + 2});
    return mesh;
  };
  Cloud c{set(), set(), {}, {}, {}, {}, {}};
  for (const Point3& p : c.a) c.flat.push_back({p.x, p.y});
  c.p = convex_polyhedron(convex_hull(c.a), c.a);
  c.q = convex_polyhedron(convex_hull(c.b), c.b);
  c.mesh = mesh_of(c.a), c.other = mesh_of(c.b);
  return c;
}
std::vector<Halfspace3> halfspaces(const std::vector<Point3>& points) {
  std::vector<Halfspace3> all;
  for (const Point3& p : points) all.push_back({{p.x, p.y, p.z}, std::fabs(p.x)});
  return all;
}
std::vector<Halfspace2> halfplanes(const std::vector<Point3>& points) {
  std::vector<Halfspace2> all;
  for (const Point3& p : points) all.push_back({{p.x, p.y}, std::fabs(p.z)});
  return all;
}
std::vector<Sphere3> balls(const std::vector<Point3>& points) {
  std::vector<Sphere3> all;
  for (std::size_t i = 0; i < points.size(); ++i) all.push_back({points[i], std::fabs(points[(i + 1) % 9].y)});
  return all;
}
Tetrahedron3 tetrahedron(const std::vector<Point3>& p) { return {p[0], p[1], p[2], p[3]}; }
Vector3 vector(const Point3& p) { return {p.x, p.y, p.z}; }

struct Row {
  const char* name;
  void (*ask)(const Cloud&);
  double most;               // millions of instructions for all the clouds of one kind
  std::uint64_t clouds = 4;  // of each kind
};

const Row rows[]{
    {"convex_hull, plane", [](const Cloud& c) { (void)convex_hull(c.flat); }, 1},
    {"convex_hull, plane, quickhull",
     [](const Cloud& c) { (void)convex_hull(c.flat, {.method = Hull2Method::quickhull}); }, 1},
    {"convex_hull", [](const Cloud& c) { (void)convex_hull(c.a); }, 10},
    {"convex_hull, incremental", [](const Cloud& c) { (void)convex_hull(c.a, {.method = HullMethod::incremental}); },
     10},
    {"minimum_circle", [](const Cloud& c) { (void)minimum_circle(c.flat); }, 5},
    {"minimum_sphere", [](const Cloud& c) { (void)minimum_sphere(c.a); }, 50},
    {"minimum_sphere of balls", [](const Cloud& c) { (void)minimum_sphere(balls(c.a)); }, 200},
    {"minimum_obb, plane", [](const Cloud& c) { (void)minimum_obb(c.flat); }, 5},
    {"minimum_obb", [](const Cloud& c) { (void)minimum_obb(c.a); }, 150},
    {"fit_obb_brute_force", [](const Cloud& c) { (void)fit_obb_brute_force(c.a); }, 100},
    {"fit_capsule", [](const Cloud& c) { (void)fit_capsule(c.a); }, 20},
    {"fit_lozenge", [](const Cloud& c) { (void)fit_lozenge(c.a); }, 50},
    {"fit_cylinder", [](const Cloud& c) { (void)fit_cylinder(c.a); }, 5},
    {"merge of capsules",
     [](const Cloud& c) {
       (void)merge(Capsule3{c.a[0], c.a[1], std::fabs(c.a[2].x)}, Capsule3{c.b[0], c.b[1], std::fabs(c.b[2].x)});
     },
     5},
    {"merge of boxes",
     [](const Cloud& c) {
       (void)merge(Obb3{c.a[0], {vector(c.a[1]), vector(c.a[2]), vector(c.a[3])}, {1, 1, 1}},
                   Obb3{c.b[0], {vector(c.b[1]), vector(c.b[2]), vector(c.b[3])}, {1, 1, 1}});
     },
     20},
    {"relate of k-DOPs", [](const Cloud& c) { (void)relate(fit_k_dop(c.a, 14), fit_k_dop(c.b, 14)); }, 1},
    {"tighten", [](const Cloud& c) { (void)tighten(fit_k_dop(c.a, 14)); }, 50},
    {"minkowski_sum", [](const Cloud& c) { (void)minkowski_sum(c.p, c.q); }, 100},
    {"gjk_intersects", [](const Cloud& c) { (void)gjk_intersects(c.p, c.q); }, 50},
    {"gjk", [](const Cloud& c) { (void)gjk(c.p, c.q); }, 200},
    {"distance", [](const Cloud& c) { (void)distance(c.p, c.q); }, 50},
    {"vclip", [](const Cloud& c) { (void)vclip(c.p, c.q); }, 20},
    {"separating_vector", [](const Cloud& c) { (void)separating_vector(c.p, c.q); }, 50},
    {"separating_axis", [](const Cloud& c) { (void)separating_axis(c.p, c.q); }, 100},
    {"penetration", [](const Cloud& c) { (void)penetration(c.p, c.q); }, 200},
    {"penetration of cones",
     [](const Cloud& c) {
       (void)penetration(Cone3{c.a[0], c.a[1], std::fabs(c.a[2].x)}, Cone3{c.b[0], c.b[1], std::fabs(c.b[2].x)});
     },
     100},
    {"contact", [](const Cloud& c) { (void)contact(c.p, c.q, {.margin = 100}); }, 200},
    {"maximize, plane",
     [](const Cloud& c) {
       (void)maximize(Vector2{c.b[0].x, c.b[0].y}, halfplanes(c.a));
     },
     1},
    {"maximize", [](const Cloud& c) { (void)maximize(vector(c.b[0]), halfspaces(c.a)); }, 2},
    {"nearest_feasible", [](const Cloud& c) { (void)nearest_feasible(c.b[0], halfspaces(c.a)); }, 100},
    {"greatest_margin", [](const Cloud& c) { (void)greatest_margin(c.a, c.b); }, 50},
    {"first_contact, point and triangle",
     [](const Cloud& c) {
       (void)first_contact(Moving<Point3>{c.a[0], c.a[1]},
                           Moving<Triangle3>{{c.b[0], c.b[1], c.b[2]}, {c.b[3], c.b[4], c.b[5]}});
     },
     50},
    {"first_contact, segments",
     [](const Cloud& c) {
       (void)first_contact(Moving<Segment3>{{c.a[0], c.a[1]}, {c.a[2], c.a[3]}},
                           Moving<Segment3>{{c.b[0], c.b[1]}, {c.b[2], c.b[3]}});
     },
     50},
    {"first_contact within a separation",
     [](const Cloud& c) {
       (void)first_contact(Moving<Point3>{c.a[0], c.a[1]},
                           Moving<Triangle3>{{c.b[0], c.b[1], c.b[2]}, {c.b[3], c.b[4], c.b[5]}},
                           {.separation = std::fabs(c.a[2].x)});
     },
     1000},
    {"first_contact_time",
     [](const Cloud& c) {
       (void)first_contact_time(Moving<Point3>{c.a[0], c.a[1]},
                                Moving<Triangle3>{{c.b[0], c.b[1], c.b[2]}, {c.b[3], c.b[4], c.b[5]}});
     },
     50},
    {"first_contact, translating",
     [](const Cloud& c) {
       (void)first_contact(Translating<Tetrahedron3>{tetrahedron(c.a), vector(c.a[4])}, tetrahedron(c.b));
     },
     100},
    {"build_polytope_hierarchy",
     [](const Cloud& c) { (void)distance(build_polytope_hierarchy(c.p), build_polytope_hierarchy(c.q)); }, 50},
    {"nearest in a kd-tree",
     [](const Cloud& c) {
       const KdTree3 tree = build_kd_tree(c.a);
       for (const Point3& p : c.b) (void)nearest(tree, p);
     },
     1},
    {"first_hit of a mesh",
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : c.b) (void)first_hit(Ray3{c.b[0], vector(p)}, bvh);
     },
     100},
    {"closest_on_mesh",
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : c.b) (void)closest_on_mesh(bvh, p);
     },
     500},
    {"closest_triangles", [](const Cloud& c) { (void)closest_triangles(build_bvh(c.mesh), build_bvh(c.other)); }, 500},
    {"hausdorff_distance",
     [](const Cloud& c) {
       (void)hausdorff_distance(build_bvh(c.mesh), build_bvh(c.other), {.execution = Execution::serial});
     },
     500},
};

/// Instructions of this thread by the processor's counter.
class Counter {
 public:
  Counter() {
    perf_event_attr what{};
    what.type = PERF_TYPE_HARDWARE;
    what.size = sizeof what;
    what.config = PERF_COUNT_HW_INSTRUCTIONS;
    what.exclude_kernel = 1;
    what.exclude_hv = 1;
    file_ = static_cast<int>(::syscall(SYS_perf_event_open, &what, 0, -1, -1, 0));
  }
  ~Counter() {
    if (file_ >= 0) ::close(file_);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;
  [[nodiscard]] bool counts() const { return file_ >= 0 && now() > 0; }
  [[nodiscard]] double now() const {
    std::uint64_t count = 0;
    return ::read(file_, &count, sizeof count) == sizeof count ? static_cast<double>(count) : 0;
  }

 private:
  int file_ = -1;
};

/// Asks every question of every cloud, between calls of `before` and `after`.
template <class Before, class After>
void ask_all(const Before& before, const After& after) {
  for (const Row& row : rows) {
    for (const Exponents kind : {Exponents::ordinary, Exponents::of_points, Exponents::of_coordinates}) {
      std::vector<Cloud> asked;
      for (std::uint64_t i = 0; i < row.clouds; ++i) asked.push_back(cloud(kind, i));
      before();
      for (const Cloud& c : asked) {
        try {
          row.ask(c);
        } catch (const Error&) {  // what doubles do not hold
        }
      }
      after();
    }
  }
}

constexpr const char* under_callgrind = "PLUMB_COUNTS_UNDER_CALLGRIND";

std::vector<double> by_processor(const Counter& counter) {
  std::vector<double> counts;
  double start = 0;
  ask_all([&] { start = counter.now(); }, [&] { counts.push_back(counter.now() - start); });
  return counts;
}

void run_under_callgrind() {
#if PLUMB_HAS_CALLGRIND
  ask_all([] { CALLGRIND_ZERO_STATS; }, [] { CALLGRIND_DUMP_STATS_AT("counted"); });
#endif
}

/// By this program again; nothing where valgrind is not there.
std::vector<double> by_callgrind() {
  std::vector<double> counts;
#if PLUMB_HAS_CALLGRIND
  std::string folder = (std::filesystem::temp_directory_path() / "plumb_cost_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return counts;
  const std::string out = "--callgrind-out-file=" + folder + "/counts";
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv(under_callgrind, "1", 1);
    ::execlp("valgrind", "valgrind", "--quiet", "--tool=callgrind", "--dump-line=no", out.c_str(), self.c_str(),
             "--gtest_filter=Cost.*", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  for (int i = 1; WIFEXITED(status) && WEXITSTATUS(status) == 0; ++i) {
    std::ifstream file(folder + "/counts." + std::to_string(i));
    bool is_counted = false;
    double total = -1;
    for (std::string line; std::getline(file, line);) {
      is_counted = is_counted || line.ends_with("counted");
      if (line.starts_with("totals: ")) total = std::stod(line.substr(8));
    }
    if (!is_counted || total < 0) break;
    counts.push_back(total);
  }
  std::filesystem::remove_all(folder);
#endif
  return counts;
}

TEST(Cost, IsBoundedWhateverTheExponentsAre) {
  if (std::getenv(under_callgrind) != nullptr) return run_under_callgrind();
  const Counter counter;
  const std::vector<double> counts = counter.counts() ? by_processor(counter) : by_callgrind();
  if (counts.empty())
    GTEST_SKIP() << "instructions cannot be counted here: the processor's counter is not to be had; install valgrind "
                    "(with its headers) and build again";
  ASSERT_EQ(counts.size(), 3 * std::size(rows));
  constexpr double million = 1e6;
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    const double ordinary = counts[3 * i] / million, points = counts[3 * i + 1] / million,
                 coordinates = counts[3 * i + 2] / million;
    std::cout << std::setw(34) << rows[i].name << std::fixed << std::setprecision(2) << std::setw(10) << ordinary
              << std::setw(10) << points << std::setw(10) << coordinates << "  of " << rows[i].most << "\n";
    EXPECT_GT(ordinary, 0) << rows[i].name;
    EXPECT_LE(std::max({ordinary, points, coordinates}), rows[i].most) << rows[i].name;
  }
}

}  // namespace
}  // namespace plumb
