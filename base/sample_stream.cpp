#include "base/sample_stream.h"

namespace amble {
namespace {

constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15;  // of the paper, figure 16

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

}  // namespace

SampleStream::SampleStream(std::uint64_t seed, std::uint64_t index)
    : state_(mix(mix(seed + kGoldenGamma) ^ (index * kGoldenGamma))) {}

std::uint64_t SampleStream::bits() { return mix(state_ += kGoldenGamma); }

}  // namespace amble
