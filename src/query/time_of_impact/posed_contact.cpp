#include "query/time_of_impact/posed_contact.hpp"

#include "query/overlap/posed_triangles.hpp"
#include "query/time_of_impact/body_meeting.hpp"

namespace plumb::query {
namespace {

constexpr Vector3 stands_still{0, 0, 0};

PosedTriangle3 triangle_of(const PosedView& v) { return {*static_cast<const Triangle3*>(v.figure.shape), v.pose}; }

Relation posed_at_start(const BodyMotion& a, const BodyMotion& b) {
  return relate(triangle_of(a.shape), triangle_of(b.shape));
}

}  // namespace

std::optional<Contact> first_contact(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b) {
  return body_contact("first_contact", {posed_view(a), &by.shape, &by.pose.columns}, {posed_view(b), &stands_still},
                      posed_at_start);
}

std::optional<Root> first_contact_time(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b) {
  return body_contact_time("first_contact_time", {posed_view(a), &by.shape, &by.pose.columns},
                           {posed_view(b), &stands_still}, posed_at_start);
}

}  // namespace plumb::query
