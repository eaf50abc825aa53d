// Do worlds tell what asking each two bodies tells, whatever sequence of calls has led there?
//
// The bytes are a sequence of additions, moves, replacements, removals, rows of the matrix, commits and questions.  Beside
// the world a list of its bodies is kept; after each commit pairs and events are those of asking each two of them, and
// check() has no word.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/query/variant/questions.hpp"
#include "world/drawn_body.hpp"

namespace plumb::fuzz {
namespace {

using drawn_world::Drawn;
using Ids = std::pair<std::uint64_t, std::uint64_t>;
using Meetings = std::map<Ids, Relation>;

void expect_of_world(bool holds, const std::string& what) {
  if (holds) return;
  std::cerr << "CollisionWorld: " << what << std::endl;
  std::abort();
}

struct Member {
  Drawn drawn;
  BodyOptions options;
  BodyHandle handle;
};

template <class Call>
void each_two_figures(const Member& a, const Member& b, const Call& call) {
  for (const auto& part_a : a.drawn.figures) {
    for (const AnyFigure& p : part_a) {
      for (const auto& part_b : b.drawn.figures) {
        for (const AnyFigure& q : part_b) call(p, q);
      }
    }
  }
}

/// A world, and what is known of it by asking each.
class Replay {
 public:
  explicit Replay(Entropy& e) : e_(e), world_({.contacts = e.coin(), .execution = Execution::serial}) {}

  void run() {
    constexpr std::size_t most_steps = 40;
    for (std::size_t step = 0; step < most_steps && !e_.exhausted(); ++step) take_step();
    commit();
    ask();
  }

 private:
  static constexpr std::size_t most_bodies = 8;

  Member& some() { return std::next(members_.begin(), static_cast<std::ptrdiff_t>(e_.below(members_.size())))->second; }

  void take_step() {
    const std::uint64_t what = e_.below(9);
    if (what < 3 && members_.size() < most_bodies) return add();
    if (members_.empty()) return;
    switch (what) {
      case 3:
        return remove(some());
      case 4: {
        Member& m = some();
        m.drawn = drawn_world::body(e_);
        return world_.replace(m.handle, m.drawn.body);
      }
      case 5:
        return allow(some(), some());
      case 6:
        return commit();
      case 7:
        return ask();
      default: {
        Member& m = some();
        const RigidPose pose = drawn_world::pose(e_);
        m.drawn = m.drawn.under(pose);
        world_.move(m.handle, pose);
      }
    }
  }

  void add() {
    Member m{drawn_world::body(e_), {}, {}};
    m.options = {.group = 1U << e_.below(2),
                 .mask = e_.below(4) == 0 ? 1U : every_group,
                 .user_id = next_,
                 .margin = static_cast<double>(e_.below(2)) / 4,
                 .is_static = e_.below(4) == 0};
    m.handle = world_.add(m.drawn.body, m.options);
    expect_of_world(handles_.insert({m.handle, next_}).second, "a handle is given twice");
    members_.insert({next_++, m});
  }
  void remove(const Member& m) {
    const BodyHandle handle = m.handle;
    world_.remove(handle);
    const std::uint64_t id = m.options.user_id;
    members_.erase(id);
    std::erase_if(allowed_, [&](const auto& row) { return row.first.first == id || row.first.second == id; });
    try {
      world_.remove(handle);
    } catch (const StaleHandle&) {
      return;
    }
    expect_of_world(false, "a handle is removed twice");
  }
  void allow(const Member& a, const Member& b) {
    const Ids ids = std::minmax(a.options.user_id, b.options.user_id);
    const bool is_allowed = e_.coin();
    world_.allow_collision(a.handle, b.handle, is_allowed);
    if (is_allowed) {
      allowed_[ids] = true;
    } else {
      allowed_.erase(ids);
    }
  }

  [[nodiscard]] bool is_asked(const Member& a, const Member& b) const {
    const BodyOptions &p = a.options, &q = b.options;
    return (p.group & q.mask) != 0 && (q.group & p.mask) != 0 && !(p.is_static && q.is_static) &&
           !allowed_.contains({p.user_id, q.user_id});
  }
  template <class Call>
  void each_pair(const Call& call) const {
    for (auto a = members_.begin(); a != members_.end(); ++a) {
      for (auto b = std::next(a); b != members_.end(); ++b) {
        if (is_asked(a->second, b->second)) call(Ids{a->first, b->first}, a->second, b->second);
      }
    }
  }

  static Meetings as_meetings(const std::vector<WorldPair>& pairs) {
    Meetings found;
    for (const WorldPair& p : pairs) found[{p.id_a, p.id_b}] = p.relation;
    expect_of_world(found.size() == pairs.size(), "a pair is told twice");
    return found;
  }
  void commit() {
    Meetings now, begun, kept, ended;
    each_pair([&](const Ids& ids, const Member& a, const Member& b) {
      Relation most = Relation::disjoint;
      each_two_figures(a, b, [&](const AnyFigure& p, const AnyFigure& q) { most = std::max(most, relate(p, q)); });
      if (most != Relation::disjoint) now[ids] = most;
    });
    for (const auto& [ids, r] : now) (before_.contains(ids) ? kept : begun)[ids] = r;
    for (const auto& [ids, r] : before_) {
      if (!now.contains(ids)) ended[ids] = r;
    }
    const WorldEvents& told = world_.commit();
    expect_of_world(as_meetings(told.begun) == begun, "what has begun differs");
    expect_of_world(as_meetings(told.kept) == kept, "what is kept differs");
    expect_of_world(as_meetings(told.ended) == ended, "what has ended differs");
    expect_of_world(as_meetings(world_.pairs()) == now, "the pairs differ");
    expect_of_world(world_.size() == members_.size(), "the number of bodies differs");
    before_ = std::move(now);
    for (const std::string& sentence : world_.check()) expect_of_world(false, "check: " + sentence);
  }

  /// The nearest pair, by exact distances.
  void ask() {
    for (const std::string& sentence : world_.check()) expect_of_world(false, "check: " + sentence);
    std::optional<std::pair<ExactDistance, Ids>> least;
    each_pair([&](const Ids& ids, const Member& a, const Member& b) {
      each_two_figures(a, b, [&](const AnyFigure& p, const AnyFigure& q) {
        const ExactDistance d = exact_distance(p, q);
        if (!least || compare(d, least->first) == Sign::negative) least = {d, ids};
      });
    });
    const std::vector<WorldNearPair> told = world_.nearest_pairs();
    expect_of_world(told.empty() == !least, "there is a nearest pair, or none, otherwise than told");
    if (least) expect_of_world(Ids{told[0].id_a, told[0].id_b} == least->second, "another pair is nearest");
    const AnyFigure region = drawn_world::figure(e_);
    std::vector<BodyHandle> expected;
    for (const auto& [id, m] : members_) {
      const auto meets = [&](const AnyFigure& f) { return intersects(f, region); };
      if (std::ranges::any_of(m.drawn.figures, [&](const auto& part) { return std::ranges::any_of(part, meets); })) {
        expected.push_back(m.handle);
      }
    }
    expect_of_world(world_.overlaps(region) == expected, "what has a point in a figure differs");
  }

  Entropy& e_;
  CollisionWorld world_;
  std::map<std::uint64_t, Member> members_;
  std::map<Ids, bool> allowed_;
  std::map<BodyHandle, std::uint64_t> handles_;
  Meetings before_;
  std::uint64_t next_ = 1;
};

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::Entropy e = plumb::Entropy::from_bytes({data, size});
  plumb::fuzz::Replay(e).run();
  return 0;
}
