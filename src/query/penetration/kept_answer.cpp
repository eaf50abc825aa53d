#include "query/penetration/kept_answer.hpp"

#include "plumb/query/body/detail/with_figure.hpp"

namespace plumb::query {
namespace {

template <class T, class Take>
void take_list(std::span<const T> list, const Take& take) {
  const std::uint64_t size = list.size();
  take(&size, sizeof size);
  if (size != 0) take(list.data(), size * sizeof(T));
}
template <class T, class Take>
void take_list(const std::vector<T>& list, const Take& take) {
  take_list(std::span<const T>(list), take);
}

template <class Shape, class Take>
void take_shape(const Shape& s, const Take& take) {
  if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
    take_list(s.mesh.vertices, take), take_list(s.mesh.corners, take), take_list(s.mesh.first, take);
    take_list(s.across, take), take_list(s.neighbors, take), take_list(s.first_neighbor, take);
  } else if constexpr (std::is_same_v<Shape, Polygon3>) {
    take_list(s.vertices, take);
  } else if constexpr (std::is_trivially_copyable_v<Shape>) {
    take(&s, sizeof s);
  }  // no other kind is a body
}

template <class Take>
void take_body(const BodyView& v, const Take& take) {
  if (v.is_hull()) {
    take(&v.radius, sizeof v.radius), take_list(v.vertices, take);
  } else {
    with_figure(v.figure, [&](const auto& shape) { take_shape(shape, take); });
  }
  std::visit(
      [&]<class By>(const By& pose) {
        if constexpr (std::is_same_v<By, const RigidChain*>) {
          take_list(pose->links, take);
        } else if constexpr (std::is_same_v<By, const Pose*> || std::is_same_v<By, const RigidPose*>) {
          take(pose, sizeof *pose);
        }
      },
      v.pose.by);
}

/// take(bytes, how many) for all that an answer depends on; which bytes follow is told by those before.
template <class Take>
void take_all(const AskedContact& asked, const Take& take) {
  const auto kind = [](const BodyView& v) {
    return static_cast<std::uint32_t>(v.is_hull() ? 0U : 1U + static_cast<unsigned>(v.figure.kind)) * 16U +
           static_cast<std::uint32_t>(v.pose.by.index());
  };
  const std::array<std::uint32_t, 4> head{static_cast<std::uint32_t>(asked.question), kind(asked.a), kind(asked.b), 0};
  take(&head, sizeof head), take(&asked.options, sizeof asked.options);
  take_body(asked.a, take), take_body(asked.b, take);
}

}  // namespace

std::span<const unsigned char> KeptBytes::answer(const ContactCache& cache, const AskedContact& asked) {
  std::span<const unsigned char> rest(cache.last.bytes_);
  bool is_same = true;
  take_all(asked, [&](const void* bytes, std::size_t count) {
    is_same = is_same && count <= rest.size() && std::memcmp(rest.data(), bytes, count) == 0;
    if (is_same) rest = rest.subspan(count);
  });
  return is_same ? rest : std::span<const unsigned char>();
}

bool KeptBytes::put_question(std::vector<unsigned char>& to, const AskedContact& asked) {
  constexpr std::size_t of_answer = 640;  // with eight corners
  std::size_t size = 0;
  take_all(asked, [&](const void*, std::size_t count) { size += count; });
  if (size > most_kept) return false;
  to.reserve(size + of_answer);
  to.resize(size);
  unsigned char* at = to.data();
  take_all(asked, [&](const void* bytes, std::size_t count) {
    std::memcpy(at, bytes, count);
    at += count;
  });
  return true;
}

}  // namespace plumb::query
