/// A foot's captured cycle, or several that are blended: of straight walks and of turns.
#pragma once

#include <array>

#include "animation/library/foot_cycle.h"

namespace amble {

/// Refers to cycles that outlive it. What a foot does is linear in its cycle's numbers: blending
/// what each cycle does is as good as blending them.
class FootBlend {
 public:
  FootBlend() = default;
  FootBlend(const FootCycle& cycle) { add(cycle, 1.0); }  // NOLINT: one cycle is a blend of it

  static constexpr int kMost = 4;  ///< two straight walks and two turns
  /// @param share  [0, 1]; all of them are 1 together  @pre fewer than kMost so far
  void add(const FootCycle& cycle, double share) { parts_[count_++] = {&cycle, share}; }

  /// The same as one cycle: where there are several, their numbers summed into `own`, which is to
  /// outlive it. Quicker from a dozen moments on.
  FootBlend asOne(FootCycle& own) const {
    if (count_ == 1) return *this;
    sumInto(own);
    return own;
  }

  /// Sum of what a function of a cycle is, by shares.
  template <typename Of>
  double sum(const Of& of) const {
    if (count_ == 1) return of(*parts_[0].cycle);
    double total = 0.0;
    for (int i = 0; i < count_; ++i) total += parts_[i].share * of(*parts_[i].cycle);
    return total;
  }
  /// As of a FootCycle: a polynomial of the swing at tau [0, 1].
  double polynomial(SwingTerms FootCycle::*terms, double tau) const {
    return sum([&](const FootCycle& cycle) { return swingPolynomial(cycle.*terms, tau); });
  }
  double progress(double tau) const {
    return sum([&](const FootCycle& cycle) { return swingProgress(cycle, tau); });
  }
  /// @param x  [0, 2]
  double pitch(double x) const {
    return sum([&](const FootCycle& cycle) { return footPitch(cycle, x); });
  }
  /// @param x  [0, 2]
  double toeRoll(double x) const {
    return sum([&](const FootCycle& cycle) { return amble::toeRoll(cycle, x); });
  }

 private:
  struct Part {
    const FootCycle* cycle;
    double share;
  };

  void sumInto(FootCycle& own) const {
    own = *parts_[0].cycle;
    const auto sumUp = [&](auto FootCycle::*numbers) {
      for (size_t k = 0; k < (own.*numbers).size(); ++k) {
        (own.*numbers)[k] = sum([&](const FootCycle& cycle) { return (cycle.*numbers)[k]; });
      }
    };
    for (const auto terms : {&FootCycle::progress, &FootCycle::height, &FootCycle::sideways,
                             &FootCycle::roll, &FootCycle::yaw})
      sumUp(terms);
    sumUp(&FootCycle::pitch);
    sumUp(&FootCycle::toes);
  }

  std::array<Part, kMost> parts_ = {};
  int count_ = 0;
};

}  // namespace amble
