/// Seeded random numbers, one stream a sample: the result of a search depends on the seed and the
/// index of a sample, not on who draws it (DESIGN.md, section 8).
///
/// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014), started from a hash of seed and index. Reals are made here too, since the standard
/// library's distributions differ between implementations.
#pragma once

#include <cstdint>

namespace amble {

class SampleStream {
 public:
  SampleStream(std::uint64_t seed, std::uint64_t index);

  std::uint64_t bits();
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }  ///< [0, 1)
  /// [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  int below(int count) { return static_cast<int>(uniform() * count); }  ///< 0 .. count - 1

 private:
  std::uint64_t state_;
};

}  // namespace amble
