// Every fault that a mesh can have, planted in generated meshes and in every mesh of the models: it is named at its
// place, mended, and nothing is left for the judge, or the reason stands in its row.  What no fault touched stays bit
// for bit and in its order; neither the input's order nor threads change the result.
#include "surface/repair/planted_faults.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/topology/defects.hpp"
#include "surface/repair/meshes_alike.hpp"

namespace plumb {
namespace {

using namespace meshes_alike;

using planted::Ending, planted::Fault, planted::Ground, planted::Plan, planted::Where;

/// Larger models are for PLUMB_LONG_TESTS.
#ifdef PLUMB_LONG_TESTS
constexpr std::size_t most_triangles = 1'000'000;
#else
constexpr std::size_t most_triangles = 25'000;
#endif

/// Where a fault meets sound surface only: triangles whose corners, and theirs, are at closed edges and touch nothing.
class Places {
 public:
  explicit Places(const TriangleMesh& mesh) : mesh_(mesh), around_(mesh.vertices.size()), taken_(mesh.vertices.size()) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.triangles[t]) around_[v].push_back(t);
    std::vector<std::uint32_t> bad;
    const MeshEdges edges = find_edges(mesh);
    for (std::size_t e = 0; e < edges.edges.size(); ++e) {
      const auto uses = edges.uses_of(e);
      if (uses.size() != 2 || uses[0].forward == uses[1].forward)
        bad.insert(bad.end(), edges.edges[e].begin(), edges.edges[e].end());
    }
    const auto all_of = [&](std::uint32_t t) {
      bad.insert(bad.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    };
    for (const TrianglePair& p : intersecting_pairs(build_bvh(mesh))) all_of(p.a), all_of(p.b);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [a, b, c] = mesh.triangles[t];
      if (collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])) all_of(t);
    }
    const auto fans = non_manifold_vertices(mesh, edges);
    bad.insert(bad.end(), fans.begin(), fans.end());
    for (const std::uint32_t v : bad) take(v);
  }

  /// A fault at the triangle keeps away from all that is not sound, and from other faults.
  [[nodiscard]] bool is_free(std::uint32_t t) const {
    return std::ranges::all_of(mesh_.triangles[t], [&](std::uint32_t v) {
      return taken_[v] == 0 && std::ranges::all_of(around_[v], [&](std::uint32_t s) {
               return std::ranges::all_of(mesh_.triangles[s], [&](std::uint32_t w) { return taken_[w] == 0; });
             });
    });
  }
  void take_triangle(std::uint32_t t) {
    std::vector<std::uint32_t> near;
    for (const std::uint32_t v : mesh_.triangles[t])
      for (const std::uint32_t s : around_[v])
        near.insert(near.end(), mesh_.triangles[s].begin(), mesh_.triangles[s].end());
    for (const std::uint32_t v : near) take(v);
  }

 private:
  void take(std::uint32_t v) {
    taken_[v] = 1;
    for (const std::uint32_t s : around_[v])
      for (const std::uint32_t w : mesh_.triangles[s]) taken_[w] = 1;
  }
  const TriangleMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::uint8_t> taken_;
};

struct Sown {
  const Fault* fault;
  std::set<Corner> touched;
};

struct Field {
  TriangleMesh mesh;
  std::vector<Sown> sown;

  [[nodiscard]] bool touches(const Point3& p) const {
    const Corner c = corner_of(p);
    return std::ranges::any_of(sown, [&](const Sown& s) { return s.touched.contains(c); });
  }
};

double step_of(const TriangleMesh& mesh) {
  double greatest = 0;
  for (const Point3& p : mesh.vertices) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::ldexp(1.0, std::ilogb(greatest) - 48);
}

/// Each of the faults once, as far as there is a place.
Field sow(const TriangleMesh& whole, bool closed, const std::vector<const Fault*>& faults, std::mt19937& random) {
  Field field{whole, {}};
  Places places(whole);
  std::vector<std::uint32_t> gone;
  for (const Fault* fault : faults) {
    Ground ground{field.mesh, 0, step_of(whole), closed};
    bool done = false;
    for (int attempt = 0; attempt < 4000 && !done; ++attempt) {
      const auto t = static_cast<std::uint32_t>(random() % whole.triangles.size());
      ground.triangle = t;
      if (fault->where != Where::triangle) {
        done = fault->plant(ground);
        break;
      }
      if (!places.is_free(t)) continue;
      ground.touched.clear();
      ground.touch(whole.triangles[t]);
      done = fault->plant(ground);
      if (done) places.take_triangle(t);
    }
    if (!done) continue;
    gone.insert(gone.end(), ground.gone.begin(), ground.gone.end());
    field.sown.push_back({fault, {}});
    for (const Point3& p : ground.touched) field.sown.back().touched.insert(corner_of(p));
  }
  std::ranges::sort(gone, std::greater<>());
  for (const std::uint32_t t : gone) field.mesh.triangles.erase(field.mesh.triangles.begin() + t);
  return field;
}

using Bits = std::array<std::uint64_t, 3>;
Bits bits_of(const Point3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y), std::bit_cast<std::uint64_t>(p.z)};
}

/// The vertices, and the corners of the triangles, that no fault touched, as they stand.
std::vector<Bits> untouched(const TriangleMesh& mesh, const Field& field) {
  std::vector<std::uint8_t> out(mesh.vertices.size());
  std::vector<Bits> all;
  for (std::size_t v = 0; v < out.size(); ++v) {
    out[v] = field.touches(mesh.vertices[v]);
    if (out[v] == 0) all.push_back(bits_of(mesh.vertices[v]));
  }
  for (const auto& t : mesh.triangles) {
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return out[v] != 0; })) continue;
    for (const std::uint32_t v : t) all.push_back(bits_of(mesh.vertices[v]));
  }
  return all;
}

std::multiset<Corners> triangles_at(const TriangleMesh& mesh, const std::set<Corner>& places) {
  std::multiset<Corners> all;
  for (const auto& t : mesh.triangles)
    if (std::ranges::any_of(t, [&](std::uint32_t v) { return places.contains(corner_of(mesh.vertices[v])); }))
      all.insert(corners_of(mesh, t));
  return all;
}

bool tells(const Repaired& done, ChangeKind kind, const Sown& s) {
  return std::ranges::any_of(done.changes, [&](const RepairChange& c) {
    return c.kind == kind && (is_left(kind) || c.step == s.fault->step) && s.touched.contains(corner_of(c.place));
  });
}

std::array<std::uint64_t, 10> counts_of(const SurfaceFaults& f) {
  return {f.met.touching,       f.met.overlapping,
          f.degenerate,         f.inside_out_shells,
          f.internal_walls,     f.open_edges,
          f.non_manifold_edges, f.non_manifold_vertices,
          f.vertices_on_edges,  f.duplicate_triangles + f.opposite_triangles};
}

/// How often each fault was planted, and how often its hole stayed, for its filling would have met the surface, or another
/// one has exactly the same area.
struct Score {
  std::map<std::string_view, int> planted, kept;
};

void expect_mended(const TriangleMesh& whole, const SurfaceFaults& judged, const std::vector<const Fault*>& faults,
                   std::mt19937& random, Score& score) {
  const std::vector<RepairStep> steps = planted::steps_of(faults[0]->plan, step_of(whole));
  const Field field = sow(whole, judged.closed, faults, random);
  if (field.sown.empty()) return;
  const Repaired done = repair(field.mesh, steps);
  std::set<std::string_view> left;
  bool as_sound = true;
  for (const Sown& s : field.sown) {
    SCOPED_TRACE(s.fault->name);
    ++score.planted[s.fault->name];
    left.insert(s.fault->left.begin(), s.fault->left.end());
    as_sound = as_sound && s.fault->ending != Ending::some_left;
    const bool named = !s.fault->change || tells(done, *s.fault->change, s);
    const bool kept = !named && s.fault->change == ChangeKind::filled_hole &&
                      (tells(done, ChangeKind::kept_hole, s) || tells(done, ChangeKind::tied_hole, s));
    const bool is_wall =  // in a cavity with holes, which is no solid's outside
        s.fault->ending == Ending::some_left && std::ranges::any_of(done.changes, [&](const RepairChange& c) {
          return c.kind == ChangeKind::removed_wall && s.touched.contains(corner_of(c.place));
        });
    EXPECT_TRUE(named || kept || is_wall);
    if (kept) ++score.kept[s.fault->name], left.insert("open"), as_sound = false;
    if (s.fault->ending == Ending::as_before && s.fault->where == Where::triangle && !kept) {
      EXPECT_TRUE(triangles_at(done.mesh, s.touched) == triangles_at(whole, s.touched)) << "as it was before";
    } else if (s.fault->ending == Ending::as_before) {
      EXPECT_TRUE(field.sown.size() > 1 || triangles_of(done.mesh) == triangles_of(whole)) << "as it was before";
    }
  }
  EXPECT_TRUE(untouched(done.mesh, field) == untouched(whole, field)) << "what no fault touched, bit for bit";
  for (const std::string_view defect : surface_defects)
    EXPECT_TRUE(!done.faults.has(defect) || judged.has(defect) || left.contains(defect)) << defect;
  if (as_sound) {
    EXPECT_EQ(counts_of(done.faults), counts_of(judged));
  }
  EXPECT_TRUE(triangles_of(repair(shuffled(field.mesh, random), steps, {.execution = Execution::serial}).mesh) ==
              triangles_of(done.mesh))
      << "in whatever order, on however many threads";
}

std::vector<const Fault*> rows(Plan plan, bool some_left, bool everywhere) {
  std::vector<const Fault*> all;
  for (const Fault& f : planted::faults)
    if (f.plan == plan && (f.ending == Ending::some_left) == some_left && (f.where == Where::everywhere) == everywhere)
      all.push_back(&f);
  return all;
}

TEST(PlantedFaults, TheTableHasEachDefectStepAndChange) {
  const auto any = [](auto is) { return std::ranges::any_of(planted::faults, is); };
  for (const std::string_view defect : surface_defects)
    EXPECT_TRUE(any([&](const Fault& f) { return std::ranges::count(f.defects, defect) != 0; }))
        << "no fault is planted that is told as " << defect;
  for (std::size_t k = 0; k < repair_kinds; ++k)
    EXPECT_TRUE(any([&](const Fault& f) { return f.step == static_cast<RepairKind>(k); }))
        << "no fault is planted for step " << name_of(static_cast<RepairKind>(k));
  for (std::size_t k = 0; k < change_kinds; ++k) {
    const auto kind = static_cast<ChangeKind>(k);
    if (is_left(kind)) continue;
    EXPECT_TRUE(any([&](const Fault& f) { return f.change == kind; })) << "no fault asks for '" << text_of(kind) << "'";
  }
  for (const Fault& f : planted::faults)
    EXPECT_EQ(f.why.empty(), f.ending != Ending::some_left) << f.name << ": what stays has its reason";
}

TEST(PlantedFaults, EachIsFoundAndMendedInGeneratedMeshes) {
  Score score;
  const std::vector<TriangleMesh> meshes{grid_box(3), solids::hollow_torus(4, 1, 12, 9), solids::torus(3, 1, 14, 11)};
  for (const Fault& fault : planted::faults) {
    SCOPED_TRACE(fault.name);
    for (std::uint32_t seed = 0; seed < (battery::sanitized ? 3u : 9u); ++seed) {
      SCOPED_TRACE(seed);
      const TriangleMesh& mesh = meshes[seed % meshes.size()];
      const TriangleMesh whole =  // with as few triangles as it takes, where more are a fault
          fault.plan == Plan::merge_coplanar ? repair(mesh, planted::steps_of(fault.plan, 0)).mesh : mesh;
      const SurfaceFaults judged = find_faults(whole);
      std::mt19937 random(seed);
      const SurfaceFaults found =
          find_faults(sow(whole, true, {&fault}, random).mesh, {.nearer_than = 2 * step_of(whole)});
      for (const std::string_view defect : fault.defects) EXPECT_TRUE(found.has(defect)) << defect;
      random.seed(seed);
      expect_mended(whole, judged, {&fault}, random, score);
    }
    EXPECT_GT(score.planted[fault.name], battery::sanitized ? 1 : 5);
  }
  for (const auto& [fault, kept] : score.kept)
    EXPECT_TRUE(fault == "hole of all triangles at a vertex" && kept < 5) << fault;
}

TEST(PlantedFaults, ManyAtOnce) {
  const std::vector<const Fault*> faults = rows(Plan::printable, false, false);
  for (std::uint32_t seed = 0; seed < battery::fitting(40u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    TriangleMesh mesh = grid_box(4);
    for (int i = 0; i < 6; ++i) {  // wherever, on one another too
      const auto t = static_cast<std::uint32_t>(random() % mesh.triangles.size());
      Ground ground{mesh, t, 0x1p-40, i == 0};
      faults[random() % faults.size()]->plant(ground);
      std::ranges::sort(ground.gone, std::greater<>());
      for (const std::uint32_t s : ground.gone) mesh.triangles.erase(mesh.triangles.begin() + s);
    }
    const Repaired done = repair(mesh);
    if (done.faults.any()) {
      EXPECT_TRUE(std::ranges::any_of(done.changes, [](const RepairChange& c) { return is_left(c.kind); }))
          << "what stays is told";
    }
    EXPECT_EQ(triangles_of(repair(shuffled(mesh, random)).mesh), triangles_of(done.mesh));
    EXPECT_EQ(triangles_of(repair(done.mesh).mesh), triangles_of(done.mesh));
  }
}

TEST(PlantedFaults, AreFoundAndMendedInTheModels) {
  const std::filesystem::path folder(PLUMB_SHARED_DIR "/models");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "there is no " << folder << ": the models are not here";
  Score score;
  std::size_t models = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files) {
    if (file.extension() == ".md") continue;
    const std::string name = file.filename().string();
    SCOPED_TRACE(name);
    const TriangleMesh read = read_mesh(file.string());
    if (read.triangles.size() > (battery::sanitized ? most_triangles / 10 : most_triangles)) {
      std::cout << name << ": " << read.triangles.size() << " triangles are for PLUMB_LONG_TESTS\n";
      continue;
    }
    ++models;
    const Repaired first = repair(read);
    const TriangleMesh& whole = first.mesh;
    std::vector<std::vector<const Fault*>> batches{rows(Plan::printable, false, false),
                                                   rows(Plan::printable, true, false)};
    for (const Fault* f : rows(Plan::printable, false, true)) batches.push_back({f});
    for (const Plan plan : {Plan::with_tolerance, Plan::slivers, Plan::small_components, Plan::merge_coplanar})
      batches.push_back(rows(plan, false, false));
    for (const auto& batch : batches) {
      SCOPED_TRACE(batch[0]->name);
      const Repaired again = repair(whole, planted::steps_of(batch[0]->plan, step_of(whole)));
      if (again.mesh.triangles != whole.triangles || again.mesh.vertices != whole.vertices) {
        std::cout << name << ": " << batch[0]->name << ": the plan finds more than what is planted\n";
        continue;
      }
      std::mt19937 random(7);
      expect_mended(whole, first.faults, batch, random, score);
    }
  }
  ASSERT_GT(models, 0U);
  for (const Fault& f : planted::faults) {
    if (battery::reaches_rare) {
      EXPECT_GT(score.planted[f.name], 0) << f.name << " has no place in any model";
    }
    std::cout << f.name << ": in " << score.planted[f.name] << " of " << models << " models";
    if (score.kept[f.name] != 0) std::cout << ", left open for a reason that is told in " << score.kept[f.name];
    std::cout << "\n";
  }
}

}  // namespace
}  // namespace plumb
