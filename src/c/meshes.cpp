#include <algorithm>
#include <cmath>
#include <filesystem>

#include "c/faults.hpp"
#include "c/solids.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "plumb/surface/repair/repair.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

extern "C" {

plumb_status plumb_mesh_create(const double* vertices, std::size_t vertex_count, const std::uint32_t* triangles,
                               std::size_t triangle_count, plumb_mesh** mesh) {
  return guarded("plumb_mesh_create", [&] {
    need(mesh, "mesh");
    need(triangles, triangle_count, "triangles");
    const std::span<const Point3> points = c::items<Point3>(vertices, vertex_count, "vertices");
    TriangleMesh made{{points.begin(), points.end()}, {}};
    for (std::size_t i = 0; i < 3 * vertex_count; ++i) {
      if (!std::isfinite(vertices[i]))
        throw NonFinite("vertices[" + std::to_string(i) + "] is no finite number (vertex " + std::to_string(i / 3) +
                        ")");
    }
    made.triangles.resize(triangle_count);
    for (std::size_t i = 0; i < 3 * triangle_count; ++i) {
      if (triangles[i] >= vertex_count) {
        throw c::InvalidArgument("triangles[" + std::to_string(i) + "] is " + std::to_string(triangles[i]) +
                                 ", but there are " + std::to_string(vertex_count) + " vertices");
      }
      made.triangles[i / 3][i % 3] = triangles[i];
    }
    *mesh = new plumb_mesh{std::move(made)};
  });
}

plumb_status plumb_mesh_read(const char* path, plumb_mesh** mesh) {
  return guarded("plumb_mesh_read", [&] {
    need(path, "path");
    need(mesh, "mesh");
    *mesh = new plumb_mesh{read_mesh(path)};
  });
}

plumb_status plumb_mesh_write(const plumb_mesh* mesh, const char* path, int replace) {
  return guarded("plumb_mesh_write", [&] {
    need(mesh, "mesh");
    need(path, "path");
    if (replace == 0 && std::filesystem::exists(path))
      throw MeshFileError(MeshFileProblem::unwritable, path, {}, {}, "it is there, and `replace` is 0");
    write_mesh(path, mesh->mesh);
  });
}

void plumb_mesh_destroy(plumb_mesh* mesh) { delete mesh; }

plumb_status plumb_mesh_vertices(const plumb_mesh* mesh, const double** vertices, std::size_t* count) {
  return guarded("plumb_mesh_vertices", [&] {
    need(mesh, "mesh");
    need(vertices, "vertices");
    need(count, "count");
    static_assert(sizeof(Point3) == 3 * sizeof(double));
    *vertices = reinterpret_cast<const double*>(mesh->mesh.vertices.data());
    *count = mesh->mesh.vertices.size();
  });
}

plumb_status plumb_mesh_triangles(const plumb_mesh* mesh, const std::uint32_t** triangles, std::size_t* count) {
  return guarded("plumb_mesh_triangles", [&] {
    need(mesh, "mesh");
    need(triangles, "triangles");
    need(count, "count");
    static_assert(sizeof(TriangleMesh::Triangle) == 3 * sizeof(std::uint32_t));
    *triangles = reinterpret_cast<const std::uint32_t*>(mesh->mesh.triangles.data());
    *count = mesh->mesh.triangles.size();
  });
}

plumb_status plumb_mesh_faults(const plumb_mesh* mesh, const plumb_progress* progress, plumb_faults* faults) {
  return guarded("plumb_mesh_faults", [&] {
    need(mesh, "mesh");
    need_size(faults, "faults");
    const SurfaceFaults found = find_faults(mesh->mesh, {.progress = c::progress_of(progress)});
    c::write(faults, c::told_faults(found));
  });
}

plumb_status plumb_mesh_repair(const plumb_mesh* mesh, plumb_mesh** repaired) {
  return guarded("plumb_mesh_repair", [&] {
    need(mesh, "mesh");
    need(repaired, "repaired");
    *repaired = new plumb_mesh{repair(mesh->mesh).mesh};
  });
}

plumb_status plumb_mesh_combine(int operation, const plumb_mesh* const* meshes, std::size_t count, plumb_mesh** result,
                                plumb_solid_report* report) {
  return guarded("plumb_mesh_combine", [&] {
    need(meshes, count, "meshes");
    need(result, "result");
    if (report != nullptr) need_size(report, "report");
    std::vector<TriangleMesh> solids;
    for (std::size_t i = 0; i < count; ++i) {
      need(meshes[i], "a mesh");
      solids.push_back(meshes[i]->mesh);
    }
    const Pieces pieces = c::pieces_of(operation & PLUMB_MERGE_PIECES);
    *result = c::told_solid(round(c::combined(operation & ~PLUMB_MERGE_PIECES, solids, pieces)), report);
  });
}

}  // extern "C"
