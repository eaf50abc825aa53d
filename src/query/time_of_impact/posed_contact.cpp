#include "query/time_of_impact/posed_contact.hpp"

#include "query/overlap/posed_triangles.hpp"
#include "query/time_of_impact/body_meeting.hpp"

namespace plumb::query {
namespace {

constexpr Vector3 stands_still{0, 0, 0};

Relation posed_at_start(const BodyShape& a, const BodyShape& b) {
  return relate(*std::get<const PosedTriangle3*>(a), *std::get<const PosedTriangle3*>(b));
}

}  // namespace

std::optional<Contact> first_contact(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b) {
  return body_contact("first_contact", {&a, &by.shape, &by.pose.columns}, {&b, &stands_still}, posed_at_start);
}

std::optional<Root> first_contact_time(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b) {
  return body_contact_time("first_contact_time", {&a, &by.shape, &by.pose.columns}, {&b, &stands_still},
                           posed_at_start);
}

}  // namespace plumb::query
