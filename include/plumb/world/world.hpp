// Which bodies of a scene meet, where do they touch, and what has begun and ended since the last look?
//
//   CollisionWorld world({.contacts = true});
//   const BodyHandle ball = world.add(Sphere3{{0, 0, 0}, 1}, {.user_id = 7});
//   world.add(Posed{box, RigidPose{{1, 0, 0, 1}, {2, 0, 0}}}, {.user_id = 8, .margin = 0.01});
//   world.move(ball, RigidPose{{}, {1, 0, 0}});
//   const WorldEvents& now = world.commit();    // now.begun, now.kept, now.ended
//   for (const WorldContact& c : world.contacts()) use(c.manifold.corners);
//   world.overlaps(region)                      // of the bodies as they stand now
//
// Laws: (1) after commit() pairs() are exactly the pairs whose relate is not disjoint and that no filter leaves out, as
// if each pair were asked: of compounds and meshes those of which two parts meet.  (2) begun, kept and ended are what these
// and those of the commit before differ by; a pair of a body that was removed has ended.  (3) contacts() are contact() of
// each two parts of such pairs that have one within the sum of both margins, rounded; corners have begun that have not
// been there by their name (ContactId) at the commit before.  (4) Answers ascend by user ids, and where these are equal by
// handles; where user ids differ, the order of insertion changes nothing but handles.  (5) A handle names one body for
// ever; its slot is used again with another generation.  (6) What throws leaves the world as it was.  (7) The answers are
// the same on any number of threads.
// A handle of a body that was removed, or of none, throws StaleHandle.  NonFinite and InvalidShape name the body by its
// user id; Unsupported refuses a figure of the plane or without an end, UnevenPose one under a matrix.
// (8) Rays, distances, casts and motions are those of the figures and triangles themselves, exactly, and answers are
// ordered by exact numbers.
// (9) Proxies change no answer: what misses the proxy of a body, which holds it, is not asked about the body.  A body that
// has no proxy of the kind that is asked for throws InvalidShape.
// Source: RTCD 2.2.2, 2.4.1, 2.4.3.
// Cost: that of MovingBoxes for what has moved, and relate, and contact where it is asked for, for each pair of boxes that
// overlap of which a body has changed.  Nothing is searched but by MovingBoxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/contact/contact.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/time_of_impact/interval_halving.hpp"
#include "plumb/query/time_of_impact/motion.hpp"
#include "plumb/space/broad_phase/moving_boxes.hpp"
#include "plumb/world/any_body.hpp"

namespace plumb {

/// The body of this handle was removed, or never was; the text names the function and the handle.
struct StaleHandle : Error {
  using Error::Error;
};

using BodyHandle = BoxHandle;

/// Two bodies are asked about if each one's mask has a bit of the other's group, and one of them at least is not static.
struct BodyOptions {
  std::uint32_t group = 1, mask = 0xffffffff;
  std::uint64_t user_id = 0;
  double margin = 0;  // contacts begin this far from the body
  bool is_static = false;
  ProxyKind proxy = ProxyKind::none;  // plan() says where one pays (plumb/world/plan.hpp)
};

struct CollisionWorldOptions {
  bool contacts = false;  // beside pairs
  Execution execution = Execution::parallel;
};

/// a comes before b by user id, then by handle.
struct WorldPair {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  Relation relation;  // of a pair that has ended, what it was
  friend bool operator==(const WorldPair&, const WorldPair&) = default;
};

struct WorldEvents {
  std::vector<WorldPair> begun, kept, ended;
};

/// Which part of a body, and of a mesh which triangle, by its number; 0 where there is one alone.
struct BodyPart {
  std::uint32_t part = 0, triangle = 0;
  friend auto operator<=>(const BodyPart&, const BodyPart&) = default;
};

struct WorldContact {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  BodyPart part_a, part_b;
  ContactManifold manifold;
};

/// A corner of a contact by name.
struct WorldCorner {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  BodyPart part_a, part_b;
  ContactId id;
  friend bool operator==(const WorldCorner&, const WorldCorner&) = default;
};

/// All corners of contacts() that have not begun were there before.
struct WorldContactEvents {
  std::vector<WorldCorner> begun, ended;
};

/// What a ray hits of a body first.
struct WorldHit {
  std::uint64_t user_id;
  BodyHandle body;
  BodyPart part;
  Hit hit;
  friend bool operator==(const WorldHit&, const WorldHit&) = default;
};

/// How far a body is; the part that is nearest.
struct WorldNear {
  std::uint64_t user_id;
  BodyHandle body;
  BodyPart part;
  double distance;
  friend bool operator==(const WorldNear&, const WorldNear&) = default;
};

/// How far two bodies are apart; the parts that are nearest, of equal ones those of the lowest numbers.
struct WorldNearPair {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  BodyPart part_a, part_b;
  double distance;
  friend bool operator==(const WorldNearPair&, const WorldNearPair&) = default;
};

/// When what moves comes to a body first; feature_a is that of what moves.
struct WorldCast {
  std::uint64_t user_id;
  BodyHandle body;
  BodyPart part;
  Contact contact;
  friend bool operator==(const WorldCast&, const WorldCast&) = default;
};

/// A body that moves by a vector during time [0, 1].
struct BodyMotion {
  BodyHandle body;
  Vector3 by;
};

/// When two bodies meet first.  Impacts of one rank are at exactly one time.
struct WorldImpact {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  BodyPart part_a, part_b;
  Contact contact;  // its time is rounded down
  std::size_t rank;
  friend bool operator==(const WorldImpact&, const WorldImpact&) = default;
};

/// A body that goes from the rigid pose that it has to another during time [0, 1]: at time t its quaternion is (1 - t)
/// times the first plus t times the last, whatever their lengths and signs are, and its translation likewise.
struct BodyTurn {
  BodyHandle body;
  RigidPose to;
};

struct WorldPlan;
struct WorldPlanOptions;

/// Two bodies that turn do not meet before the span, and may meet in it; do they for certain?
struct WorldContactSpan {
  std::uint64_t id_a, id_b;
  BodyHandle a, b;
  TimeSpan span;
  bool is_certain;
  friend bool operator==(const WorldContactSpan&, const WorldContactSpan&) = default;
};

/// When a figure that turns comes to a body, likewise.
struct WorldCastSpan {
  std::uint64_t user_id;
  BodyHandle body;
  TimeSpan span;
  bool is_certain;
  friend bool operator==(const WorldCastSpan&, const WorldCastSpan&) = default;
};

inline constexpr std::uint32_t every_group = 0xffffffff;

class CollisionWorld {
 public:
  explicit CollisionWorld(const CollisionWorldOptions& options = {});
  CollisionWorld(CollisionWorld&&) noexcept;
  CollisionWorld& operator=(CollisionWorld&&) noexcept;
  ~CollisionWorld();

  /// A bounded figure of space, a mesh, or a compound of both, as it stands or under a rigid pose or a chain of them.
  BodyHandle add(const AnyBody& body, const BodyOptions& options = {});
  /// The pose takes the place of that which the body had; where it is the same, nothing is asked again.
  void move(const BodyHandle& body, const RigidPose& pose);
  /// Another body, by the same handle, options and events.
  void replace(const BodyHandle& body, const AnyBody& by);
  void remove(const BodyHandle& body);
  void set_proxy(const BodyHandle& body, ProxyKind proxy);

  [[nodiscard]] bool contains(const BodyHandle& body) const;
  [[nodiscard]] std::size_t size() const;
  /// The body where it stands; figure() throws Unsupported where it is a mesh or a compound.
  [[nodiscard]] AnyBody body(const BodyHandle& body) const;
  [[nodiscard]] const AnyFigure& figure(const BodyHandle& body) const;
  [[nodiscard]] const BodyOptions& options(const BodyHandle& body) const;

  /// May these two collide without being told?  A row of the allowed-collision matrix; none is allowed at first.
  void allow_collision(const BodyHandle& a, const BodyHandle& b, bool allowed = true);
  /// Pairs of which filter(a, b), two handles, is false are left out, from the next commit on.  Each is asked in the
  /// order of WorldPair, once a commit; the filter may ask the world and not change it.
  template <class Filter>
  requires requires(Filter& filter, const BodyHandle& a, const BodyHandle& b) { bool(filter(a, b)); }
  void set_filter(Filter filter) {
    keep_filter(std::make_shared<Filter>(std::move(filter)), [](void* of, const BodyHandle& a, const BodyHandle& b) {
      return bool((*static_cast<Filter*>(of))(a, b));
    });
  }
  void clear_filter() { keep_filter(nullptr, nullptr); }

  /// Valid until the next commit.
  const WorldEvents& commit();
  /// All that meet, as of the last commit.
  [[nodiscard]] const std::vector<WorldPair>& pairs() const;
  /// They are those of the last commit, by pair and then by part; two parts that contact() has no answer for have none.
  /// A world that keeps no contacts throws Unsupported.
  [[nodiscard]] const std::vector<WorldContact>& contacts() const;
  [[nodiscard]] const WorldContactEvents& contact_events() const;

  // These ask the bodies as they stand now, whose group has a bit of the mask.
  /// Those that have a point in the figure.
  [[nodiscard]] std::vector<BodyHandle> overlaps(const AnyFigure& figure, std::uint32_t mask = every_group) const;

  /// The hit of the least parameter, exactly, along a ray, a segment or a line; equal ones are ordered by user id.
  /// Points and segments, which first_hit is not asked about, are never hit.
  [[nodiscard]] std::optional<WorldHit> first_hit(const AnyRay& ray, std::uint32_t mask = every_group) const;
  [[nodiscard]] bool any_hit(const AnyRay& ray, std::uint32_t mask = every_group) const;
  /// Each body that is hit has its first one told, in the order of the ray.
  [[nodiscard]] std::vector<WorldHit> hits(const AnyRay& ray, std::uint32_t mask = every_group) const;
  /// Each ray is answered as if alone; spans of different lengths throw UnequalLengths.
  void first_hit(std::span<const AnyRay> rays, std::span<std::optional<WorldHit>> out,
                 std::uint32_t mask = every_group) const;

  /// The bodies nearest to a bounded figure, as a Point3 is, nearest first: by exact distances, equal ones by user id.
  [[nodiscard]] std::vector<WorldNear> nearest(const AnyFigure& figure, std::size_t k = 1,
                                               std::uint32_t mask = every_group) const;
  /// All whose distance is at most that, in the same order; none is within a negative one.
  [[nodiscard]] std::vector<WorldNear> within(const AnyFigure& figure, double distance,
                                              std::uint32_t mask = every_group) const;

  /// The k pairs of bodies nearest to one another as they stand now, of those that commit() asks about and that are no
  /// farther than `within`: by exact distances, equal ones in the order of pairs.  A filter is asked in any order.
  [[nodiscard]] std::vector<WorldNearPair> nearest_pairs(std::size_t k = 1,
                                                         double within = std::numeric_limits<double>::infinity()) const;

  /// Shape cast: the figure moves by a vector during time [0, 1], the bodies stand still.  The first by exact times, of
  /// equal ones by user id.
  [[nodiscard]] std::optional<WorldCast> first_contact(const AnyFigure& figure, const Vector3& by,
                                                       std::uint32_t mask = every_group) const;
  /// Each body that it comes to is told, in the same order.
  [[nodiscard]] std::vector<WorldCast> contacts_along(const AnyFigure& figure, const Vector3& by,
                                                      std::uint32_t mask = every_group) const;

  /// Continuous motion: all pairs that meet while bodies move at once, the others stand still, with their first time:
  /// those that commit() asks about, of which one moves at least.  In the order of exact times, of equal ones in that of
  /// pairs.  The bodies stay where they are.  A body that is named twice throws InvalidShape.
  [[nodiscard]] std::vector<WorldImpact> first_contacts(std::span<const BodyMotion> motions) const;

  /// What must hold and does not, a sentence each; nothing where all holds.  For debug builds and reports: slots, handles
  /// and the order of what is told are looked at for all bodies; so many of them, evenly taken, are held against all
  /// others by asking again, whether boxes hold them, which are near, how pairs lie and where they touch.
  [[nodiscard]] std::vector<std::string> check(std::size_t samples = 256) const;

  /// Continuous motion that turns: all pairs that may meet while bodies turn at once, the others stand still, each with
  /// the first span of time in which this is not ruled out, by where the spans begin, then in the order of pairs.  Before
  /// its span a pair does not meet, and what is not told never does; nothing tunnels.  A pair that comes nearer than what
  /// it moves in a span of the resolution may be told though it only passes; that it meets is certain where an end of
  /// its span puts both at poses of doubles, and they meet there.  A body under a chain of poses throws UnevenPose, one
  /// that is named twice InvalidShape, a resolution that is not positive Error.
  /// Cost: two distances for each span that cannot be told apart, 2 / resolution at most.
  [[nodiscard]] std::vector<WorldContactSpan> first_contact_spans(std::span<const BodyTurn> turns,
                                                                  const HalvingOptions& options) const;
  [[nodiscard]] std::vector<WorldContactSpan> first_contact_spans(std::span<const BodyTurn> turns) const {
    return first_contact_spans(turns, {.resolution = 0x1p-12});  // a guess of what pays
  }

  friend WorldPlan plan(const CollisionWorld& world, const WorldPlanOptions& options);

  /// Shape cast that turns: the figure goes from its rigid pose to another, as a BodyTurn does, the bodies stand still.  Each
  /// body that it may come to, with the first span of time in which this is not ruled out, as of first_contact_spans; by
  /// where spans begin, then by user id.
  [[nodiscard]] std::vector<WorldCastSpan> contact_spans_along(const AnyFigure& figure, const RigidPose& to,
                                                               std::uint32_t mask = every_group,
                                                               double resolution = 0x1p-12) const;  // a guess, as above

 private:
  using AskFilter = bool (*)(void* filter, const BodyHandle& a, const BodyHandle& b);
  void keep_filter(std::shared_ptr<void> filter, AskFilter ask);

  struct State;
  class Inspection;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
