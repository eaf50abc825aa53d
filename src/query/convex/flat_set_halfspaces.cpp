// The double description method: generators of a cone, one halfspace after another.  A set in space is the cone's
// section at w = 1: a halfspace is normal . x <= offset w, and w >= 0 comes first.
#include <algorithm>

#include "query/convex/flat_set.hpp"

namespace plumb::query {
namespace {

using Exact4 = std::array<mpq_class, 4>;

struct Extreme {
  Exact4 at;
  std::vector<bool> tight;  // halfspaces whose boundary it lies on
};

mpq_class dot4(const Exact4& u, const Exact4& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2] + u[3] * v[3]; }

/// s u + t v.
Exact4 combination(const mpq_class& s, const Exact4& u, const mpq_class& t, const Exact4& v) {
  Exact4 sum;
  for (std::size_t k = 0; k < 4; ++k) sum[k] = s * u[k] + t * v[k];
  return sum;
}

/// Divided by the size of a coordinate, the last if it can be: numbers stay as long as the generator's own.
void shorten(Exact4& v) {
  for (std::size_t k = 4; k-- > 0;) {
    if (sgn(v[k]) == 0) continue;
    const mpq_class by = abs(v[k]);
    for (mpq_class& x : v) x /= by;
    return;
  }
}

class Cone {
 public:
  Cone() {
    for (std::size_t k = 0; k < 4; ++k) {
      Exact4 unit{0, 0, 0, 0};
      unit[k] = 1;
      lines_.push_back(unit);
    }
  }

  /// What of the cone has row . x <= 0.
  void cut(const Exact4& row) {
    const auto crossing = std::ranges::find_if(lines_, [&](const Exact4& line) { return sgn(dot4(row, line)) != 0; });
    if (crossing != lines_.end()) {
      Exact4 inward = *crossing;
      lines_.erase(crossing);
      cut_across(row, std::move(inward));
    } else {
      cut_extremes(row);
    }
    ++rows_;
  }

  [[nodiscard]] const std::vector<Exact4>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<Extreme>& extremes() const { return extremes_; }

 private:
  // Everything is moved along the line onto the boundary, and the line becomes a ray that leaves it.
  void cut_across(const Exact4& row, Exact4 inward) {
    mpq_class at = dot4(row, inward);
    if (sgn(at) > 0) {
      for (mpq_class& x : inward) x = -x;
      at = -at;
    }
    const auto onto = [&](Exact4& v) {
      const mpq_class from = dot4(row, v);
      if (sgn(from) == 0) return;
      v = combination(1, v, -from / at, inward);
    };
    for (Exact4& line : lines_) onto(line);
    for (Extreme& e : extremes_) {
      onto(e.at);
      shorten(e.at);
      e.tight.push_back(true);
    }
    std::vector<bool> tight(rows_, true);
    tight.push_back(false);
    shorten(inward);
    extremes_.push_back({std::move(inward), std::move(tight)});
  }

  void cut_extremes(const Exact4& row) {
    std::vector<mpq_class> at;
    for (const Extreme& e : extremes_) at.push_back(dot4(row, e.at));
    std::vector<Extreme> kept;
    for (std::size_t i = 0; i < extremes_.size(); ++i) {
      if (sgn(at[i]) <= 0) {
        kept.push_back(extremes_[i]);
        kept.back().tight.push_back(sgn(at[i]) == 0);
        continue;
      }
      for (std::size_t j = 0; j < extremes_.size(); ++j) {
        if (sgn(at[j]) >= 0 || !adjacent(i, j)) continue;
        Extreme between{combination(at[i], extremes_[j].at, -at[j], extremes_[i].at), both_tight(i, j)};
        shorten(between.at);
        between.tight.push_back(true);
        kept.push_back(std::move(between));
      }
    }
    extremes_ = std::move(kept);
  }

  [[nodiscard]] std::vector<bool> both_tight(std::size_t i, std::size_t j) const {
    std::vector<bool> both(rows_);
    for (std::size_t r = 0; r < rows_; ++r) both[r] = extremes_[i].tight[r] && extremes_[j].tight[r];
    return both;
  }
  /// Do they span a face of their own?  No third one lies on all boundaries that both lie on.
  [[nodiscard]] bool adjacent(std::size_t i, std::size_t j) const {
    const std::vector<bool> both = both_tight(i, j);
    for (std::size_t k = 0; k < extremes_.size(); ++k) {
      if (k == i || k == j) continue;
      bool on_all = true;
      for (std::size_t r = 0; r < rows_ && on_all; ++r) on_all = !both[r] || extremes_[k].tight[r];
      if (on_all) return false;
    }
    return true;
  }

  std::vector<Exact4> lines_;
  std::vector<Extreme> extremes_;
  std::size_t rows_ = 0;
};

}  // namespace

// They are the dual cone of the set's own: a halfspace is (normal, -offset), a generator what it must not be beyond.
std::vector<ExactHalfspace> halfspaces_of(const FlatSet& s) {
  Cone cone;
  for (const Exact3& p : s.points) cone.cut({p[0], p[1], p[2], 1});
  for (const Exact3& d : s.directions) cone.cut({d[0], d[1], d[2], 0});
  for (const Exact3& l : s.lines) {
    cone.cut({l[0], l[1], l[2], 0});
    cone.cut({-l[0], -l[1], -l[2], 0});
  }
  std::vector<ExactHalfspace> all;
  for (const Extreme& e : cone.extremes()) all.push_back({{e.at[0], e.at[1], e.at[2]}, -e.at[3]});
  for (const auto& [x, y, z, w] : cone.lines()) {
    all.push_back({{x, y, z}, -w});
    all.push_back({{-x, -y, -z}, w});
  }
  return all;
}

FlatSet flat_set(const std::vector<ExactHalfspace>& halfspaces) {
  Cone cone;
  cone.cut({0, 0, 0, -1});
  for (const auto& [normal, offset] : halfspaces) cone.cut({normal[0], normal[1], normal[2], -offset});
  FlatSet s;
  for (const Extreme& e : cone.extremes()) {
    const auto& [x, y, z, w] = e.at;
    if (sgn(w) == 0) {
      s.directions.push_back({x, y, z});
    } else {
      s.points.push_back({x, y, z});  // w is 1: shortened
    }
  }
  if (s.points.empty()) return {};
  for (const auto& [x, y, z, w] : cone.lines()) s.lines.push_back({x, y, z});
  return s;
}

}  // namespace plumb::query
