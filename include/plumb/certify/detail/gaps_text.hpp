// Are two convex sets apart along one of several axes?  The gaps of lanes of doubles, and the question asked of worlds.
//
// The end of certify/detail/floats_text.hpp, which includes it.
// Laws: those of certify/world.hpp.
// Source: docs/proof.md, "Tracked errors"; src/figure/obb/fifteen_axes.hpp for when a gap of zero is level.
// Cost: a few comparisons a gap.
#ifdef PLUMB_GAPS_TEXT  // alone it is nothing
#undef PLUMB_GAPS_TEXT

/// The gaps of two convex sets along axes, lane by lane: apart along one, below zero along all, or level along some.
template <class World>
class Gaps {
 public:
  [[gnu::always_inline]] constexpr explicit Gaps(World& world) : world_(world) {}

  /// Along an axis; with parts along that which they make, where they are not all exactly zero.
  [[gnu::always_inline]] constexpr void heed(const auto& gap, const auto&... parts) {
    const Truth below = world_.negative(gap);
    apart_.either(world_.positive(gap));
    if constexpr (World::on_lattice) strictly_.both(below);
    if constexpr (sizeof...(parts) == 0) {
      below_.both(below);
      settled_.both(below | world_.zero(gap));
    } else {
      const Truth none = (world_.zero(parts) & ...);
      below_.both(below | none);
      if constexpr (World::on_lattice) {
        const Truth some = ((world_.positive(parts) | world_.negative(parts)) | ...);
        settled_.both(below | none | (world_.zero(gap) & some));
      } else {
        settled_.both(below | none);
      }
    }
  }
  /// Along an axis, with how far apart two centers are along it.  A gap of zero is level only where they are; an axis
  /// that is zero, or along which both are flat and as far, tells nothing.
  [[gnu::always_inline]] constexpr void heed_from(const auto& gap, const auto& way) {
    heed_from(gap, way, [] { return std::false_type(); });
  }
  /// Likewise, where more is known of axes that are zero.
  [[gnu::always_inline]] constexpr void heed_from(const auto& gap, const auto& way, const auto& is_none) {
    apart_.either(world_.positive(gap));
    if constexpr (World::on_lattice) {
      const Truth zero = world_.zero(gap), strictly = world_.negative(gap);
      Truth below = strictly | (zero & world_.zero(way));
      strictly_.both(strictly);
      if constexpr (!std::is_same_v<decltype(is_none()), std::false_type>) below = below | is_none();
      below_.both(below);
      settled_.both(below | (zero & world_.positive(way)));
    } else {
      const Truth below = world_.negative(gap);
      below_.both(below), settled_.both(below);
    }
  }
  /// Of what goes on that way for ever: where the way is up the first gap counts, where it is down the second, else
  /// both.
  [[gnu::always_inline]] constexpr void heed_ahead(const auto& way, const auto& up, const auto& down) {
    const Truth is_up = world_.positive(way), is_down = world_.negative(way);
    const Truth below_up = world_.negative(up), below_down = world_.negative(down);
    const Truth below = ((below_up & is_up) | (below_down & is_down)) | (below_up & below_down);
    apart_.either((world_.positive(up) & is_up) | (world_.positive(down) & is_down));
    below_.both(below);
    if constexpr (World::on_lattice) {
      strictly_.both(below);
      const Truth level_up = below_up | world_.zero(up), level_down = below_down | world_.zero(down);
      settled_.both(below | (level_up & is_up) | (level_down & is_down) | (level_up & level_down & world_.zero(way)));
      // Neither up nor down, either gap tells.
      apart_.either((world_.positive(up) | world_.positive(down)) & world_.zero(way));
    } else {
      settled_.both(below);
    }
  }
  /// If axes that are zero were passed over, those left are all only if this is so.  Doubles pass over no axis whose
  /// parts are computed.
  [[gnu::always_inline]] constexpr void need(const Truth& t) {
    if constexpr (World::on_lattice) needed_.both(t);
  }
  /// Along what may be no axis: only a gap tells.
  [[gnu::always_inline]] constexpr void heed_above(const auto& gap) { apart_.either(world_.positive(gap)); }
  [[gnu::always_inline]] constexpr bool is_apart() const { return any(apart_.truth()); }

  /// For sets of which touching is told where a gap is zero, if they have an inside.
  template <class Answer>
  [[gnu::always_inline]] constexpr Answer relation(const auto&... have_inside) {
    const int apart = any(apart_.truth()), below = all(below_.truth());
    if constexpr (World::on_lattice) {  // which pass over axes that are zero
      if (apart != 0) return static_cast<Answer>(-1);
      if (all(strictly_.truth())) return static_cast<Answer>(1);
      if (needed_.is_some() && !all(needed_.truth())) world_.leave_open();
      if (!all(settled_.truth()) || !(all(world_.positive(have_inside)) && ...)) world_.leave_open();
      return static_cast<Answer>(below);
    }
    // Never both: one comparison of the two, for a branch on either alone could not be predicted.
    const int told = below - apart;
    if (told != 0) [[likely]]
      return static_cast<Answer>(told);
    if (!all(settled_.truth()) || !(all(world_.positive(have_inside)) && ...)) world_.leave_open();
    return static_cast<Answer>(0);
  }

 private:
  World& world_;
  Merged apart_, below_, settled_, needed_, strictly_;
};

/// The answer of the first of these worlds that is certain; of the last one in any case.
template <class First, class... Rest, class Recorder, class Statement, class... Input>
[[gnu::always_inline]] constexpr auto ask_worlds(Recorder&& recorder, const Statement& statement,
                                                 const Input&... input) {
  First world;
  auto answer = statement(world, input...);
  if constexpr (sizeof...(Rest) != 0) {
    if (!world.certain()) [[unlikely]]
      return ask_worlds<Rest...>(recorder, statement, input...);
  }
  recorder.answered(First::kind);
  return answer;
}

/// The answer of the first of these worlds that is certain, if one is.
template <class First, class... Rest, class Recorder, class Statement, class... Input>
[[gnu::always_inline]] constexpr auto told_by_worlds(Recorder&& recorder, const Statement& statement,
                                                     const Input&... input) {
  First world;
  const auto answer = statement(world, input...);
  if (world.certain()) [[likely]] {
    recorder.answered(First::kind);
    return std::optional(answer);
  }
  if constexpr (sizeof...(Rest) != 0) {
    return told_by_worlds<Rest...>(recorder, statement, input...);
  } else {
    return std::optional<std::remove_cv_t<decltype(answer)>>();
  }
}

#endif
