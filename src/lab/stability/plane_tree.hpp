// How are solids commonly united, intersected and subtracted?  By trees of the planes of their faces, over any number.
//
// Laws: none; it is on trial, and decides nothing of ours.  Each solid's faces are polygons in a tree of their planes; one's
// polygons are cut along the planes of the other's tree, and those inside go.  An epsilon is how far a corner may be from a
// plane and still lie in it.  Where a tree grows deeper or there are more polygons than two small solids can have, the
// operation is given up.
// Source: RTCD 8.3.4; Naylor, Amanatides and Thibault, Merging BSP trees yields polyhedral set operations, 1990.
// Cost: n^2 polygons at worst, and no more than are told here.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lab/trial/vec.hpp"

namespace plumb::lab::stability {

enum class SolidOperation : unsigned char { unite, intersect, subtract };

template <class T>
struct SolidFace {
  std::vector<trial::Vec<T>> corners;
  trial::Vec<T> normal;
  T offset;
};

template <class T>
class PlaneTree {
 public:
  using Face = SolidFace<T>;
  using Faces = std::vector<Face>;

  /// The faces of what the operation makes; none where it is given up.
  static std::optional<Faces> made(SolidOperation operation, const Faces& first, const Faces& second,
                                   const T& epsilon) {
    const bool inverts_first = operation != SolidOperation::unite,
               inverts_second = operation == SolidOperation::intersect;
    try {
      PlaneTree a(epsilon), b(epsilon);
      a.add(first, 0);
      b.add(second, 0);
      // What is in both is outside of the union of what is outside of each.
      if (inverts_first) a.invert();
      if (inverts_second) b.invert();
      a.cut_by(b);
      b.cut_by(a);
      b.invert();  // of faces in one plane, those of the first solid stay
      b.cut_by(a);
      b.invert();
      Faces rest;
      b.tell(rest);
      a.add(rest, 0);
      if (inverts_first) a.invert();
      Faces all;
      a.tell(all);
      return all;
    } catch (const GivenUp&) {
      return std::nullopt;
    }
  }

 private:
  struct GivenUp : std::runtime_error {
    GivenUp() : std::runtime_error("a tree of planes without end") {}
  };
  static constexpr int deepest = 200;
  static constexpr std::size_t most_faces = 20'000;

  explicit PlaneTree(const T& epsilon) : epsilon_(epsilon) {}

  void invert() {
    for (Face& face : faces_) turn(face);
    plane_normal_ = plane_normal_ * T(-1);
    plane_offset_ = -plane_offset_;
    std::swap(front_, back_);
    for (const auto& child : {front_.get(), back_.get()}) {
      if (child != nullptr) child->invert();
    }
  }
  static void turn(Face& face) {
    face.corners = {face.corners.rbegin(), face.corners.rend()};
    face.normal = face.normal * T(-1);
    face.offset = -face.offset;
  }

  void tell(Faces& all) const {
    all.insert(all.end(), faces_.begin(), faces_.end());
    for (const auto& child : {front_.get(), back_.get()}) {
      if (child != nullptr) child->tell(all);
    }
  }

  /// Cuts each face along the planes here and keeps those in front.
  Faces outside(Faces faces) const {
    if (!has_plane_) return faces;
    Faces front, back;
    for (const Face& face : faces) split(face, front, back, front, back);
    if (front_ != nullptr) front = front_->outside(std::move(front));
    if (back_ == nullptr) return front;
    for (Face& face : back_->outside(std::move(back))) front.push_back(std::move(face));
    return front;
  }
  void cut_by(const PlaneTree& other) {
    faces_ = other.outside(std::move(faces_));
    for (const auto& child : {front_.get(), back_.get()}) {
      if (child != nullptr) child->cut_by(other);
    }
  }

  void add(const Faces& faces, int depth) {
    if (faces.empty()) return;
    if (depth > deepest || faces.size() > most_faces) throw GivenUp();
    std::size_t next = 0;
    if (!has_plane_) {  // the first face lies in its own plane, whatever numbers say of its corners
      has_plane_ = true;
      plane_normal_ = faces.front().normal;
      plane_offset_ = faces.front().offset;
      faces_.push_back(faces[next++]);
    }
    Faces front, back;
    for (; next < faces.size(); ++next) split(faces[next], faces_, faces_, front, back);
    for (auto& [child, part] : {std::pair(&front_, &front), std::pair(&back_, &back)}) {
      if (part->empty()) continue;
      if (*child == nullptr) child->reset(new PlaneTree(epsilon_));
      (*child)->add(*part, depth + 1);
    }
  }

  /// Faces in the plane go to `along` or `against`, as their normals do.
  void split(const Face& face, Faces& along, Faces& against, Faces& front, Faces& back) const {
    std::vector<T> height;
    bool has_front = false, has_back = false;
    for (const trial::Vec<T>& c : face.corners) {
      const T h = trial::dot(plane_normal_, c) - plane_offset_;
      height.push_back(h > epsilon_ || h < -epsilon_ ? h : T(0));
      has_front = has_front || height.back() > 0;
      has_back = has_back || height.back() < 0;
    }
    if (!has_front && !has_back) {
      (trial::dot(plane_normal_, face.normal) > 0 ? along : against).push_back(face);
    } else if (!has_back) {
      front.push_back(face);
    } else if (!has_front) {
      back.push_back(face);
    } else {
      cut(face, height, front, back);
    }
  }
  static void cut(const Face& face, const std::vector<T>& height, Faces& front, Faces& back) {
    Face before{{}, face.normal, face.offset}, behind = before;
    for (std::size_t i = 0, n = height.size(); i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      if (height[i] >= 0) before.corners.push_back(face.corners[i]);
      if (height[i] <= 0) behind.corners.push_back(face.corners[i]);
      if ((height[i] < 0 && height[next] > 0) || (height[i] > 0 && height[next] < 0)) {
        const T along = height[i] / (height[i] - height[next]);
        const trial::Vec<T> place = face.corners[i] + (face.corners[next] - face.corners[i]) * along;
        before.corners.push_back(place);
        behind.corners.push_back(place);
      }
    }
    if (before.corners.size() >= 3) front.push_back(std::move(before));
    if (behind.corners.size() >= 3) back.push_back(std::move(behind));
  }

  T epsilon_;
  bool has_plane_ = false;
  trial::Vec<T> plane_normal_{};
  T plane_offset_{};
  Faces faces_;
  std::unique_ptr<PlaneTree> front_, back_;
};

}  // namespace plumb::lab::stability
