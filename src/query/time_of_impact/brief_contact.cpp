#include "query/time_of_impact/brief_contact.hpp"

#include "arith/form_root.hpp"
#include "plumb/arith/lattice.hpp"
#include "query/time_of_impact/contact_features.hpp"

namespace plumb::query::moving {
namespace {

using arith::BriefInteger, arith::Form, arith::FormRoot;

/// Along one axis, as integers times a power of two: touching is a question of affine geometry, so that axes need not
/// agree.
std::array<Form, 4> on_lattice(const ContactQuestion& q, double Point3::*axis) {
  ExponentSpan exponents;
  for (const auto* points : {&q.at_0, &q.at_1}) {
    for (const Point3& p : *points) exponents.include(odd_form(p.*axis));
  }
  const int exponent = exponents.lattice().exponent;
  const auto integer = [&](double x) {
    const OddForm f = odd_form(x);
    return f.mantissa == 0 ? BriefInteger() : BriefInteger(f.mantissa) << (f.exponent - exponent);
  };
  std::array<Form, 4> points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = Form(integer(q.at_0[i].*axis), integer(q.at_1[i].*axis));
  return points;
}

/// What is between the points along one axis, in the order of contact_features.hpp: pa, pb, pc, or ac, ad, bc, bd.
constexpr std::array<std::array<std::size_t, 4>, 2> from_point{{{0, 0, 0, 0}, {0, 0, 1, 1}}},
    to_point{{{1, 2, 3, 3}, {2, 3, 2, 3}}}, side_left{{{0, 1, 2, 0}, {0, 2, 0, 1}}},
    side_right{{{1, 2, 0, 0}, {1, 3, 2, 3}}};

class BriefMotion {
 public:
  BriefMotion(const ContactQuestion& question, ContactWanted wanted)
      : wanted_(wanted), edges_(question.kind == MovingKind::edge_edge ? 1 : 0) {
    constexpr std::array axes{&Point3::x, &Point3::y, &Point3::z};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Form, 4> points = on_lattice(question, axes[k]);
      for (std::size_t i = 0; i < side_count(); ++i)
        between_[k][i] = points[to_point[edges_][i]] - points[from_point[edges_][i]];
    }
  }

  BriefContact answer() {
    const auto term = [&](std::size_t k) { return between_[k][2] * need_side(k, 0); };
    const Form cubic = (term(0) + term(1)) + term(2);
    if (cubic.is_lost()) return {};
    if (cubic.is_zero()) return in_one_plane();
    BriefContact found{ContactVerdict::no, {}};
    const bool all = arith::visit_roots(cubic, [&](FormRoot& root) { return visit(root, found); });
    return all || found.verdict == ContactVerdict::yes ? found : BriefContact{};
  }

 private:
  [[nodiscard]] std::size_t side_count() const { return 3 + edges_; }

  Form side(std::size_t axis, std::size_t i) const {
    const auto &s = between_[(axis + 1) % 3], &t = between_[(axis + 2) % 3];
    const std::size_t a = side_left[edges_][i], b = side_right[edges_][i];
    return s[a] * t[b] - t[a] * s[b];
  }
  const Form& need_side(std::size_t axis, std::size_t i) {
    if (!has_side_[axis][i]) side_[axis][i] = side(axis, i), has_side_[axis][i] = true;
    return side_[axis][i];
  }

  /// Goes on where they do not meet.
  bool visit(FormRoot& root, BriefContact& found) {
    const std::optional<FeaturesInContact> features = features_at(root);
    if (root.is_certain() && !features) return true;
    found = {};
    if (!root.is_certain()) return false;
    const double time = wanted_ == ContactWanted::when ? root.rounded_down() : 0;
    if (root.is_certain()) found = {ContactVerdict::yes, {time, features->a, features->b}};
    return false;
  }

  std::optional<FeaturesInContact> features_at(FormRoot& root) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<int, 4> signs{};
      int all = 0;
      for (std::size_t i = 0; i < side_count(); ++i) {
        const Form& side = need_side(axis, i);
        signs[i] = &side == zero_ ? 0 : root.sign_of(side);
        if (!root.is_certain() || are_apart(signs)) return {};
        all |= signs[i];
      }
      if (all != 0) return edges_ != 0 ? edge_features(signs) : triangle_features(signs);
    }
    return features_on_line(root);
  }
  /// What meets has projections that meet: do the first signs, and zeros for the rest, tell that they do not?
  [[nodiscard]] bool are_apart(const std::array<int, 4>& s) const {
    return edges_ != 0 ? s[0] * s[1] > 0 || s[2] * s[3] > 0 : s[0] * s[1] < 0 || s[1] * s[2] < 0 || s[2] * s[0] < 0;
  }

  // All points are on one line, or the triangle is and p is anywhere, or the edges are parallel.
  std::optional<FeaturesInContact> features_on_line(FormRoot& root) {
    const auto vertex = [](std::size_t i) { return Feature{FeatureKind::vertex, static_cast<std::uint32_t>(i)}; };
    const auto edge = [](std::size_t i) { return Feature{FeatureKind::edge, static_cast<std::uint32_t>(i)}; };
    for (std::size_t i = 0; i < side_count(); ++i) {
      bool meet = true;
      for (std::size_t k = 0; meet && k < 3; ++k) meet = root.sign_of(between_[k][i]) == 0;
      if (meet)
        return edges_ != 0 ? FeaturesInContact{vertex(i / 2), vertex(i % 2)} : FeaturesInContact{vertex(0), vertex(i)};
    }
    for (std::size_t i = 0; i < side_count(); ++i) {
      if (!is_on_edge(root, i)) continue;
      if (edges_ == 0) return FeaturesInContact{vertex(0), edge(i)};
      return i < 2 ? FeaturesInContact{vertex(i), edge(0)} : FeaturesInContact{edge(0), vertex(i - 2)};
    }
    return {};
  }
  /// Is the point of side i on its line, and between the ends?
  bool is_on_edge(FormRoot& root, std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (root.sign_of(need_side(k, i)) != 0) return false;
    }
    const std::size_t a = side_left[edges_][i], b = side_right[edges_][i];
    for (std::size_t k = 0; k < 3; ++k) {
      const int to_a = root.sign_of(between_[k][a]), to_b = root.sign_of(between_[k][b]);
      if (to_a != 0 || to_b != 0) return to_a * to_b <= 0;
    }
    return true;
  }

  BriefContact in_one_plane() {
    BriefContact found{ContactVerdict::no, {}};
    FormRoot start(BriefInteger(1), BriefInteger(0));
    if (!visit(start, found)) return found;
    bool has_side = false;
    for (std::size_t i = 0; i < side_count(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (need_side(k, i).is_zero()) continue;
        has_side = true;
        zero_ = &side_[k][i];
        if (!take_first(side_[k][i], found)) return found;
        break;
      }
    }
    zero_ = nullptr;
    for (std::size_t i = 0; !has_side && i < side_count(); ++i) {  // on one line the whole time
      for (std::size_t k = 0; k < 3; ++k) {
        if (between_[k][i].is_zero()) continue;
        if (!take_first(between_[k][i], found)) return found;
        break;
      }
    }
    return found;
  }
  /// The first of the form's roots at which they meet, if it is before what was found.  False: done.
  bool take_first(const Form& form, BriefContact& found) {
    BriefContact next{ContactVerdict::no, {}};
    const bool all = arith::visit_roots(form, [&](FormRoot& root) {
      const bool is_late = found.verdict == ContactVerdict::yes && root.is_above_next(found.contact.time);
      return is_late ? false : visit(root, next);
    });
    if (!all && next.verdict != ContactVerdict::yes) next.verdict = ContactVerdict::unsure;
    if (next.verdict == ContactVerdict::no) return true;
    if (next.verdict == ContactVerdict::unsure || wanted_ == ContactWanted::whether) {
      found = next;
      return false;
    }
    const bool is_first = found.verdict == ContactVerdict::no || next.contact.time < found.contact.time;
    const bool is_tie = !is_first && next.contact.time == found.contact.time;
    if (is_tie &&
        !(next.contact == found.contact)) {  // times between two doubles, of which nobody knows which is first
      found = {};
      return false;
    }
    if (is_first) found = next;
    return true;
  }

  ContactWanted wanted_;
  std::size_t edges_;
  std::array<std::array<Form, 4>, 3> between_, side_;
  std::array<std::array<bool, 4>, 3> has_side_{};
  const Form* zero_ = nullptr;  // the side of which a root is looked at
};

}  // namespace

BriefContact brief_contact(const ContactQuestion& question, ContactWanted wanted) {
  return BriefMotion(question, wanted).answer();
}

}  // namespace plumb::query::moving
