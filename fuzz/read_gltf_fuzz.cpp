// Any bytes as a glTF file, JSON and binary.
#include "mesh_round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return plumb::fuzz::read_and_return(data, size, plumb::MeshFormat::gltf);
}
