#include <nlohmann/json.hpp>

#include "tool/intersect/command.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json in_common_json(const Intersection3& common) {
  json corners = json::array();
  for (const Point3& p : approximate(common)) corners.push_back({p.x, p.y, p.z});
  return {{"kind", word_of(common.kind)}, {"corners", std::move(corners)}};
}

/// Those of one side that do so in a pair.
std::vector<std::uint32_t> triangles_of(const std::vector<TrianglePair>& pairs, Relation relation,
                                        std::uint32_t TrianglePair::*side) {
  std::vector<std::uint32_t> triangles;
  for (const TrianglePair& p : pairs) {
    if (p.relation == relation) triangles.push_back(p.*side);
  }
  return triangles;
}

void append(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

json intersect_json(const IntersectReport& r) {
  json said = report_on("plumb intersect", r.meshes);
  said["meet"] = r.many() != 0;
  if (r.complete) {
    said["overlapping"] = r.found.overlapping;
    if (!r.overlapping) said["touching"] = r.found.touching;
  }
  if (!r.pairs) return said;
  json& pairs = said["pairs"] = json::array();
  for (std::size_t i = 0; i < r.pairs->size(); ++i) {
    const TrianglePair& p = (*r.pairs)[i];
    json pair{{"a", p.a}, {"b", p.b}, {"relation", p.relation == Relation::touching ? "touching" : "overlapping"}};
    if (r.in_common) pair["in_common"] = in_common_json((*r.in_common)[i]);
    pairs.push_back(std::move(pair));
  }
  return said;
}

std::string intersect_obj(const IntersectReport& r) {
  std::vector<TriangleGroup> groups;
  const auto add = [&](const char* overlapping, const char* touching, const AskedMesh& mesh,
                       std::vector<std::uint32_t> overlap, std::vector<std::uint32_t> touch) {
    overlap = distinct(std::move(overlap));
    touch = distinct(std::move(touch));
    std::erase_if(touch, [&](std::uint32_t t) { return std::binary_search(overlap.begin(), overlap.end(), t); });
    groups.push_back({overlapping, &mesh.mesh, std::move(overlap)});
    groups.push_back({touching, &mesh.mesh, std::move(touch)});
  };
  const auto of_a = [&](Relation relation) { return triangles_of(*r.pairs, relation, &TrianglePair::a); };
  const auto of_b = [&](Relation relation) { return triangles_of(*r.pairs, relation, &TrianglePair::b); };
  std::string about = "plumb intersect: the triangles of " + r.meshes.front().name;
  if (r.of_one()) {
    auto overlap = of_a(Relation::overlapping), touch = of_a(Relation::touching);
    append(overlap, of_b(Relation::overlapping));
    append(touch, of_b(Relation::touching));
    add("overlapping", "touching", r.meshes.front(), std::move(overlap), std::move(touch));
    about += " that meet one another";
  } else {
    add("a-overlapping", "a-touching", r.meshes.front(), of_a(Relation::overlapping), of_a(Relation::touching));
    add("b-overlapping", "b-touching", r.meshes.back(), of_b(Relation::overlapping), of_b(Relation::touching));
    about += " (a) and " + r.meshes.back().name + " (b) that meet";
  }
  return triangles_obj(about, groups);
}

}  // namespace plumb::tool
