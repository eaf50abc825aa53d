// Reports about two triangles of space, and about triangles that cross others of their own mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "docs/bugs_of_others/case.hpp"
#include "docs/bugs_of_others/proved.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/intersection_result.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb::docs {
namespace {

std::array<Triangle3, 6> permutations(const Triangle3& t) {
  const auto& [a, b, c] = t;
  return {{{a, b, c}, {a, c, b}, {b, a, c}, {b, c, a}, {c, a, b}, {c, b, a}}};
}

/// However the corners are named, one answer: 36 questions, each with its proof.
std::string of_all_permutations(const Triangle3& s, const Triangle3& t) {
  std::set<std::string> answers;
  for (const Triangle3& p : permutations(s)) {
    for (const Triangle3& q : permutations(t)) answers.insert(proved(p, q));
  }
  return answers.size() == 1 ? *answers.begin() : "several answers";
}

/// Corners of single precision.
Triangle3 narrow(const Triangle3& t) {
  const auto single = [](const Point3& p) {
    return Point3{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  return {single(t.a), single(t.b), single(t.c)};
}

constexpr std::array cases{
    Case{"LokiResearch/fast-triangle-triangle-intersection#3",
         [] {
           return proved(Triangle3{{-1, 0, 0}, {2, 0, -2}, {2, 0, 2}},
                         Triangle3{{0.551, 0, -0.796}, {1.224, 0, 0.326}, {3.469, 0, 1}});
         }},
    Case{"LokiResearch/fast-triangle-triangle-intersection#4",
         [] {
           return proved(Triangle3{{0, 0, 0}, {0, 0, 8}, {8, 0, 0}}, Triangle3{{2, 0, 2}, {1, 0, 4}, {9, 0, 0}});
         }},
    Case{"llnl/axom#152",
         [] {
           return of_all_permutations(
               {{76.648, 54.6752, 15.0012}, {76.648, 54.6752, 14.5542}, {76.582, 54.6752, 14.7879}},
               {{76.6252, 54.6752, 14.892}, {76.582, 54.6752, 14.7879}, {76.5617, 54.6752, 14.7929}});
         }},
    Case{"benardp/contours#1",
         [] {
           return of_all_permutations(
               {{12.3015, -0.253368, 5.49101}, {18.6765, -2.55337, 4.91756}, {12.3015, -2.55337, 4.91756}},
               {{-11.9885, -0.253368, 5.49101}, {1.61448, -0.253368, 5.49101}, {1.61448, -2.55337, 4.91756}});
         }},
    Case{"BrunoLevy/geogram#10",
         [] {
           return proved(Triangle3{{1898.68, 775, 1158.48}, {2000, 775, 1166.7}, {1898.68, 675, 1148.6}},
                         Triangle3{{1966.41, 675, 1163.79}, {1971.63, 675, 1166.95}, {1967.56, 684.554, 1166.67}});
         }},
    Case{"gkjohnson/three-mesh-bvh#655",
         [] {
           return of_all_permutations({{32.22699737548828, 1.2630000114440918, -11.8149995803833},
                                       {31.316997528076172, 1.2630000114440918, -11.739999771118164},
                                       {32.22699737548828, 1.2630000114440918, -11.739999771118164}},
                                      {{31.316997528076172, 1.933000087738037, -7.585000038146973},
                                       {31.316997528076172, -0.8669999837875366, -7.295000076293945},
                                       {31.316997528076172, -0.8669999837875366, -7.585000038146973}});
         }},
    Case{"gkjohnson/three-mesh-bvh#538",
         [] {
           const Triangle3 thin{{-5.781455993652344, -7.291503906249993, -30},
                                {-5.781455993652344, -7.291503906250007, 30},
                                {0, -7.291503906249993, -30}};
           const Triangle3 other{{-5.781455993652344, -7.29150390625, -4.098872661590576},
                                 {-6.386039733886719, -11.163619995117188, -4.485982418060303},
                                 {13.468360900878906, -6.142303466796875, -4.028029918670654}};
           proved(thin, other);
           const Intersection3 common = intersection(thin, other);
           EXPECT_EQ(common.kind, IntersectionKind::segment);
           std::string ends;
           for (const ExactPoint3& v : common.vertices) {
             EXPECT_EQ(orient3d(thin.a, thin.b, thin.c, v), Sign::zero);
             EXPECT_EQ(orient3d(other.a, other.b, other.c, v), Sign::zero);
             ends += (ends.empty() ? "" : " to ") + told(approximate(v));
           }
           return ends;
         }},
    Case{"gkjohnson/three-bvh-csg#56",
         [] {
           const Triangle3 top{{-0.29389262199401855, 0.40450850129127514, 0.4999999999999999},
                               {-0.4755282700061798, -0.1545085012912749, 0.5},
                               {0, 1.1102230246251565e-16, 0.5}};
           const Triangle3 bottom[]{
               {{-1.2246468525851679e-16, -0.5, 0.5}, {-0.4755282700061798, -0.5, 0.15450850129127502}, {0, -0.5, 0}},
               {{-0.4755282700061798, -0.5, 0.15450850129127502},
                {-0.29389262199401855, -0.5, -0.404508501291275},
                {0, -0.5, 0}},
               {{0.4755282700061798, -0.5, 0.15450850129127502}, {0, -0.5, 0.5}, {0, -0.5, 0}}};
           std::string all;
           for (const Triangle3& t : bottom) all += (all.empty() ? "" : ", ") + proved(top, t);
           return all;
         }},
    Case{"libigl/libigl#2381",
         [] {
           const TriangleMesh mesh{{{0.280039012432098, 0.82766300439834595, 0.46377500891685502},
                                    {0.33890101313590998, 0.78804200887680098, 0.48812699317932101},
                                    {0.31805300712585399, 0.76836401224136397, 0.49308800697326699},
                                    {0.30947001278400399, 0.80785250663757346, 0.47595100104808802},
                                    {0.299046009778976, 0.79801350831985496, 0.47843150794506101},
                                    {0.32847701013088199, 0.77820301055908248, 0.490607500076294},
                                    {0.29475451260805097, 0.81775775551795971, 0.46986300498247152},
                                    {0.28954251110553697, 0.81283825635910045, 0.47110325843095802},
                                    {0.32418551295995701, 0.79794725775718722, 0.48203899711370451},
                                    {0.33368901163339598, 0.78312250971794173, 0.48936724662780751},
                                    {0.30854950845241502, 0.78318876028060946, 0.485759757459164},
                                    {0.32326500862836799, 0.77328351140022322, 0.4918477535247805},
                                    {0.30425801128148999, 0.80293300747871421, 0.47719125449657451},
                                    {0.31897351145744302, 0.79302775859832797, 0.48327925056219101},
                                    {0.31376150995492902, 0.78810825943946872, 0.4845195040106775}},
                                   {{2, 11, 10},
                                    {1, 8, 9},
                                    {0, 7, 6},
                                    {3, 12, 13},
                                    {5, 14, 11},
                                    {3, 13, 8},
                                    {4, 12, 7},
                                    {4, 14, 12},
                                    {4, 10, 14},
                                    {5, 9, 13},
                                    {3, 6, 12},
                                    {5, 13, 14},
                                    {14, 10, 11},
                                    {13, 9, 8},
                                    {12, 6, 7},
                                    {14, 13, 12}}};
           return std::to_string(intersecting_pairs(build_bvh(mesh)).size()) + " pairs";
         }},
    Case{"dimforge/parry#75",
         [] {
           const Triangle3 t = narrow({{21.94, 3.7, 0}, {22.255, 3.7, -0.315}, {22.255, 3.5, -0.315}});
           return proved(t, Point3{22.01F, 3.7F, -0.291F});
         }},
};

}  // namespace

std::span<const Case> triangle_cases() { return cases; }

}  // namespace plumb::docs
