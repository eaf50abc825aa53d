// Time of impact: when do two triangles under poses first meet, one of them moving along a line?  Their corners are not
// rounded, nor is the motion.
//
// Laws: those of first_contact(Translating<Triangle3>, Triangle3), of the exact images; the poses may differ, be
// singular, and lead beyond the largest double.  The first triangle moves by the image of a vector: its pose's matrix
// times it, without the translation.
// Source: RTCD 3.2, 5.5.2.
// Cost: some microseconds, tens where several features meet at once.
#pragma once

#include <optional>

#include "plumb/arith/root.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// Of finite numbers, as what follows.
std::optional<Contact> first_contact(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b);
std::optional<Root> first_contact_time(const PosedTriangle3& a, const Posed<Vector3>& by, const PosedTriangle3& b);

}  // namespace plumb::query
