#include "query/penetration/aims.hpp"

namespace plumb::query::parting {
namespace {

bool is_independent(const ConePart& part, std::span<const Vector3> all) {
  return sign_of([&]<class T>() -> T { return InPart<T>(part, all, no_way<T>()).whole; }) != Sign::zero;
}

}  // namespace

InCone::InCone(std::span<const Vector3> directions) : directions_(directions) {
  const auto n = static_cast<std::uint32_t>(directions.size());
  for (std::uint32_t i = 0; i < n; ++i) parts_.push_back({{i, 0, 0}, 1});
  const auto take = [&](const ConePart& part) {
    if (is_independent(part, directions)) parts_.push_back(part);
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) take({{i, j, 0}, 2});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      for (std::uint32_t k = j + 1; k < n; ++k) take({{i, j, k}, 3});
    }
  }
}

}  // namespace plumb::query::parting
