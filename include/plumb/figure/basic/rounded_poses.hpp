// Where do two poses lead one after the other, which pose undoes one, and where is one part as seen from another?
//
//   const Pose seen = *rounded_relative(camera, part);  // of the poses as they are; not two roundings in a row
//
// A decision about moved shapes takes Posed figures, which are not rounded: what is made here is for files, for pictures
// and for poses that are kept from frame to frame.  exact_composition and exact_image give their answer only where
// doubles hold it.
// Laws: (1) each number is the exact one of the arguments, rounded once to the nearest double, ties to even; zero is
// never -0.  (2) A pose has an inverse exactly where its matrix is regular; of a rounded inverse no more is promised than
// (1): composed with the pose it is the identity but for roundings.  (3) rounded_relative(a, b) is a's inverse after b
// from one rounding of the exact numbers; of a and a it is the identity.  (4) The image of a vector is not translated.
// (5) keeps_lengths says of the numbers as they are that no distance changes under them: a turn by a quarter does, one by
// thirty degrees, which doubles do not hold, does not.  A RigidPose always does (figure/basic/rigid_poses.hpp).
// NaN and infinity throw NonFinite, a number beyond the doubles BeyondDoubles; both by name.
// Source: RTCD 3.1.1, 3.1.5, 3.2.
// Cost: some 20 ns a number of a composition, some 100 ns of an image or an inverse.  Nothing is searched.
#pragma once

#include <optional>

#include "plumb/arith/no_answer.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/pose_view.hpp"

namespace plumb {

/// The pose is a matrix, a rigid pose or a chain.
Point2 rounded_image(PoseView2 pose, const Point2& p);
Point3 rounded_image(PoseView pose, const Point3& p);
Vector2 rounded_image(PoseView2 pose, const Vector2& v);
Vector3 rounded_image(PoseView pose, const Vector3& v);

/// Nothing where a coordinate would have to be rounded.
std::optional<Point2> exact_image(PoseView2 pose, const Point2& p);
std::optional<Point3> exact_image(PoseView pose, const Point3& p);

/// First `inner`, then `outer`.
Pose2 rounded_composition(const Pose2& outer, const Pose2& inner);
Pose rounded_composition(const Pose& outer, const Pose& inner);

/// Nothing where a number would have to be rounded.
std::optional<Pose2> exact_composition(const Pose2& outer, const Pose2& inner);
std::optional<Pose> exact_composition(const Pose& outer, const Pose& inner);

/// Nothing exactly where the matrix is singular.
std::optional<Pose2> rounded_inverse(const Pose2& pose);
std::optional<Pose> rounded_inverse(const Pose& pose);

/// What `of` is in the frame of `in`: its own pose undone by that of `in`.  Nothing where the matrix of `in` is singular.
std::optional<Pose2> rounded_relative(const Pose2& in, const Pose2& of);
std::optional<Pose> rounded_relative(const Pose& in, const Pose& of);

/// Of the matrix's determinant: negative for mirrors, zero for what flattens.
Sign handedness(const Pose2& pose);
Sign handedness(const Pose& pose);

/// Is the matrix orthogonal, exactly?
bool keeps_lengths(const Pose2& pose);
bool keeps_lengths(const Pose& pose);

PLUMB_NO_ANSWER_TYPE(Pose,
                     "plumb: no operator * of poses: rounded_composition(outer, inner); of a point "
                     "rounded_image(pose, p), of a figure Posed{figure, pose}, which nothing rounds")
operator*(PoseView, const arith::Anything&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Pose2,
                     "plumb: no operator * of poses: rounded_composition(outer, inner); of a point "
                     "rounded_image(pose, p), of a figure Posed{figure, pose}, which nothing rounds")
operator*(PoseView2, const arith::Anything&) PLUMB_DELETED;

}  // namespace plumb
