// How does a part of a body stand that is itself under a pose?  Under both, as a chain.
//
// Laws: exact; the pose of the body comes last.
// Source: plumb/arith/rigid_pose.hpp.
// Cost: a copy of the links.
#pragma once

#include <string>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/world/any_body.hpp"

namespace plumb::world {

/// Of a rigid pose, a chain of them, or none; others throw UnevenPose.
inline std::vector<RigidPose> links_of(const char* function, const AnyPose& pose) {
  if (std::holds_alternative<std::monostate>(pose)) return {};
  if (const auto* rigid = std::get_if<RigidPose>(&pose)) return {*rigid};
  if (const auto* chain = std::get_if<RigidChain>(&pose)) return chain->links;
  throw UnevenPose(std::string(function) + ": a pose that is no RigidPose and no RigidChain");
}

inline AnyPose pose_of_links(std::vector<RigidPose> links) {
  if (links.empty()) return {};
  if (links.size() == 1) return links[0];
  return RigidChain{std::move(links)};
}

/// The inner pose, and then the outer one.
inline AnyPose composed(const char* function, const AnyPose& outer, const AnyPose& inner) {
  if (std::holds_alternative<std::monostate>(inner)) return outer;
  if (std::holds_alternative<std::monostate>(outer)) return inner;
  std::vector<RigidPose> links = links_of(function, outer);
  for (const RigidPose& link : links_of(function, inner)) links.push_back(link);
  return pose_of_links(std::move(links));
}

inline AnyBody::Part part_under(const char* function, const AnyBody::Part& part, const AnyPose& pose) {
  const auto* figure = std::get_if<AnyFigure>(&part.shape);
  const AnyPose both = composed(function, pose, figure != nullptr ? figure->pose() : part.pose);
  static_cast<void>(links_of(function, both));
  if (figure != nullptr) return {figure->under(both), {}};
  return {part.shape, both};
}

}  // namespace plumb::world
