// The face of meshes and their files: everything in plumb/surface/.
#pragma once

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/decimal.hpp"
#include "plumb/surface/mesh_file.hpp"
#include "plumb/surface/read_mesh.hpp"
#include "plumb/surface/section.hpp"
#include "plumb/surface/topology.hpp"
#include "plumb/surface/triangulate.hpp"
#include "plumb/surface/write_mesh.hpp"
