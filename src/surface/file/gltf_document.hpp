// What does a glTF say, and where are its numbers?  Its JSON, its buffers, and the accessors into them.
//
// Laws: a number of the file is believed only within what is there; a buffer beside the file is looked for in the
// file's own folder and below, by no link out of it.  Errors name the element as JSON does: accessors[3].
// Source: glTF 2.0 (ISO/IEC 12113).
// Cost: linear.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "surface/file/assembly.hpp"

namespace plumb::surface {

class GltfDocument {
 public:
  using Json = nlohmann::json;

  GltfDocument(Parse& parse, Assembly& assembly);

  [[nodiscard]] const Json& root() const { return root_; }
  [[noreturn]] void fail(MeshFileProblem problem, const std::string& where, const std::string& text) const;

  /// root[list][index], which must be an object.
  const Json& element(const std::string& list, std::uint64_t index, const std::string& named_by) const;
  /// How long a list of the root is; 0 where it is not there.
  std::uint64_t size(const std::string& list) const;
  /// A whole number, which is `otherwise` where it is missing and may be.
  std::uint64_t whole(const Json& of, const std::string& key, const std::string& where,
                      std::optional<std::uint64_t> otherwise = {}) const;
  /// A list of so many numbers, or nothing where it is missing.
  template <std::size_t N>
  std::optional<std::array<double, N>> numbers(const Json& of, const std::string& key, const std::string& where) const {
    const auto at = of.find(key);
    if (at == of.end()) return std::nullopt;
    bool good = at->is_array() && at->size() == N;
    for (std::size_t i = 0; good && i < N; ++i) good = (*at)[i].is_number();
    if (!good)
      fail(MeshFileProblem::syntax, where, key + " is no list of " + std::to_string(N) + " numbers; export it again");
    std::array<double, N> x{};
    for (std::size_t i = 0; i < N; ++i) x[i] = (*at)[i].template get<double>();
    return x;
  }

  /// The points of an accessor of float32 triples, the whole numbers of one of scalars.
  std::vector<Point3> points(std::uint64_t accessor, const std::string& named_by);
  std::vector<std::uint32_t> indices(std::uint64_t accessor, const std::string& named_by);

 private:
  /// Elements of `size` bytes, `stride` apart; none where the accessor has no view, which means zeros.
  struct Elements {
    std::string_view bytes;
    std::uint64_t stride = 0;
    [[nodiscard]] const char* at(std::uint64_t i) const { return bytes.data() + i * stride; }
  };
  void read_json(std::string_view text);
  void read_glb();
  std::string_view buffer(std::uint64_t index);
  /// As much as there is of that length, or more.
  std::string read_uri(const std::string& uri, const std::string& where, std::uint64_t length);
  Elements elements(const Json& of, const std::string& view_key, std::uint64_t count, std::uint64_t size,
                    const std::string& where);
  void fill_sparse(const Json& accessor, std::uint64_t count, const std::string& where, std::vector<Point3>& points);
  [[nodiscard]] std::vector<std::uint32_t> scalars(const Elements& from, std::uint64_t count, std::uint64_t type) const;

  Parse& parse_;
  Assembly& assembly_;
  Json root_;
  std::optional<std::string_view> binary_;  // the GLB's own buffer
  std::map<std::uint64_t, std::string> buffers_;
};

}  // namespace plumb::surface
