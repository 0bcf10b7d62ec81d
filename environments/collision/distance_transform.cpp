#include "environments/collision/distance_transform.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>

#include "base/parallel.h"
#include "base/processor.h"

namespace amble {
namespace {

// So many voxels at a time, which compilers keep in registers.
constexpr size_t kBlock = 32;

// Rows are read where they are: a block that is copied first is stored in halves and waited for.

// One step up: of a row of voxels, steps to the nearest occupied one below, `far` at most.
AMBLE_FOR_EACH_PROCESSOR
void stepUp(const uint8_t* __restrict below, uint8_t* __restrict at, size_t length, uint8_t far) {
  const auto steps = [&](size_t x) {
    const uint8_t next = std::min(far, static_cast<uint8_t>(below[x] + 1));
    return at[x] ? uint8_t{0} : next;
  };
  size_t x = 0;
  for (; x + kBlock <= length; x += kBlock)
    for (size_t k = 0; k < kBlock; ++k) at[x + k] = steps(x + k);
  for (; x < length; ++x) at[x] = steps(x);
}

// One step down: to the nearest above, too.
AMBLE_FOR_EACH_PROCESSOR
void stepDown(const uint8_t* __restrict above, uint8_t* __restrict at, size_t length) {
  const auto steps = [&](size_t x) { return std::min(at[x], static_cast<uint8_t>(above[x] + 1)); };
  size_t x = 0;
  for (; x + kBlock <= length; x += kBlock)
    for (size_t k = 0; k < kBlock; ++k) at[x + k] = steps(x + k);
  for (; x < length; ++x) at[x] = steps(x);
}

// Steps along z to the nearest occupied voxel of each, window + 1 where none is so near.
void measureAlongZ(std::vector<uint8_t>& voxels, const Eigen::Vector3i& count, int window) {
  const size_t nx = count.x(), plane = nx * count.y();
  const uint8_t far = static_cast<uint8_t>(window + 1);
  const std::vector<uint8_t> nothing(nx, far);
  parallelFor(count.y(), usualThreads(), [&](int j, int) {
    uint8_t* const row = &voxels[j * nx];
    for (int k = 0; k < count.z(); ++k)
      stepUp(k > 0 ? row + (k - 1) * plane : nothing.data(), row + k * plane, nx, far);
    for (int k = count.z() - 1; k-- > 0;) stepDown(row + (k + 1) * plane, row + k * plane, nx);
  });
}

// Squares of steps less one; what is over at the row's end is far.
AMBLE_FOR_EACH_PROCESSOR
void squareRow(const uint8_t* __restrict steps, size_t length, size_t blocks, int16_t far,
               int16_t* __restrict out) {
  const auto square = [&](size_t x) {
    const int16_t apart = static_cast<int16_t>(std::max<int16_t>(steps[x], 1) - 1);
    return static_cast<int16_t>(apart * apart);
  };
  size_t x = 0;
  for (; x + kBlock <= length; x += kBlock)
    for (size_t k = 0; k < kBlock; ++k) out[x + k] = square(x + k);
  for (; x < length; ++x) out[x] = square(x);
  std::fill(out + x, out + blocks * kBlock, far);
}

// By block of a row whether all of it is `far`, which nothing is farther than.
AMBLE_FOR_EACH_PROCESSOR
void findFar(const int16_t* in, size_t blocks, int16_t far, uint8_t* is_far) {
  for (size_t b = 0; b < blocks; ++b) {
    int16_t least = far;
    for (size_t k = 0; k < kBlock; ++k) least = std::min(least, in[b * kBlock + k]);
    is_far[b] = least == far;
  }
}

// A row of `out`: the least of `in` over a window of voxels that are `stride` numbers apart, with
// the squares added that points of two voxels are apart at least.
// @param first  of each block: steps before which it gains nothing, beyond the window if never
AMBLE_FOR_EACH_PROCESSOR
void spreadRow(const int16_t* in, int16_t* out, size_t blocks, size_t stride, const uint8_t* first,
               int window) {
  const int16_t far = static_cast<int16_t>(window * window);
  constexpr int kLook = 3;  // steps from one look at what can still gain to the next; by trial
  for (size_t b = 0; b < blocks; ++b) {
    const int16_t* const own = in + b * kBlock;
    std::array<int16_t, kBlock> least;
    for (size_t k = 0; k < kBlock; ++k) least[k] = std::min(own[k], far);
    for (int d = std::max<int>(1, first[b]); d <= window;) {
      int16_t most = 0;
      for (size_t k = 0; k < kBlock; ++k) most = std::max(most, least[k]);
      if (most <= (d - 1) * (d - 1)) break;
      for (const int end = std::min(window, d + kLook - 1); d <= end; ++d) {
        const int16_t add = static_cast<int16_t>((d - 1) * (d - 1));
        const int16_t *const below = own - d * stride, *const above = own + d * stride;
        for (size_t k = 0; k < kBlock; ++k) {
          const int16_t sum = static_cast<int16_t>(std::min(below[k], above[k]) + add);
          least[k] = std::min(least[k], sum);
        }
      }
    }
    std::copy_n(least.data(), kBlock, out + b * kBlock);
  }
}

// The voxels of one height, along y and then along x, with far ones around them.
class Plane {
 public:
  Plane(const Eigen::Vector3i& count, int window)
      : nx_(count.x()),
        ny_(count.y()),
        blocks_((nx_ + kBlock - 1) / kBlock),
        reach_((window + kBlock - 1) / kBlock),
        window_(window),
        far_(static_cast<int16_t>(window * window)),
        squares_((ny_ + 2 * window) * blocks_ * kBlock, far_),
        line_((blocks_ + 2 * reach_) * kBlock, far_),
        done_(blocks_ * kBlock),
        first_(ny_ * blocks_),
        is_far_(blocks_),
        first_of_line_(blocks_) {}

  // Steps along z become the values of squares.
  void transform(uint8_t* voxels, std::span<const uint8_t> of_square) {
    const size_t stride = blocks_ * kBlock;
    int16_t* const squares = &squares_[window_ * stride];
    int16_t* const line = &line_[reach_ * kBlock];
    for (size_t j = 0; j < ny_; ++j) {
      squareRow(voxels + j * nx_, nx_, blocks_, far_, squares + j * stride);
      findFar(squares + j * stride, blocks_, far_, &first_[j * blocks_]);
    }
    findFirst();
    for (size_t j = 0; j < ny_; ++j) {
      spreadRow(squares + j * stride, line, blocks_, stride, &first_[j * blocks_], window_);
      findFirstOfLine(line);
      spreadRow(line, done_.data(), blocks_, 1, first_of_line_.data(), window_);
      uint8_t* const out = voxels + j * nx_;
      for (size_t b = 0; b < blocks_; ++b) {
        const size_t begin = b * kBlock, end = std::min(nx_, begin + kBlock);
        if (first_of_line_[b] > window_)
          std::fill(out + begin, out + end, of_square.back());
        else
          for (size_t x = begin; x < end; ++x) out[x] = of_square[done_[x]];
      }
    }
  }

 private:
  // Whether blocks are far becomes steps along y to the nearest that is not.
  void findFirst() {
    const uint8_t never = static_cast<uint8_t>(window_ + 1);
    for (size_t at = 0; at < first_.size(); ++at) {
      const uint8_t before = at < blocks_ ? never : first_[at - blocks_];
      first_[at] = first_[at] ? std::min(never, static_cast<uint8_t>(before + 1)) : 0;
    }
    for (size_t at = first_.size() - blocks_; at-- > 0;)
      first_[at] = std::min(first_[at], static_cast<uint8_t>(first_[at + blocks_] + 1));
  }

  // By block of a line: it gains something where any near it is not far.
  void findFirstOfLine(const int16_t* line) {
    findFar(line, blocks_, far_, is_far_.data());
    for (size_t b = 0; b < blocks_; ++b) {
      const auto near = is_far_.begin() + static_cast<ptrdiff_t>(b - std::min(b, reach_));
      const auto end = is_far_.begin() + static_cast<ptrdiff_t>(std::min(blocks_, b + reach_ + 1));
      const bool gains = std::find(near, end, 0) != end;
      first_of_line_[b] = gains ? 1 : static_cast<uint8_t>(window_ + 1);
    }
  }

  size_t nx_, ny_, blocks_, reach_;  // blocks_: of a row; reach_: blocks that a window lies over
  int window_;
  int16_t far_;
  std::vector<int16_t> squares_;      // [row][x]
  std::vector<int16_t> line_, done_;  // a row, spread along y; along x too
  std::vector<uint8_t> first_;        // [row][block]
  std::vector<uint8_t> is_far_, first_of_line_;
};

}  // namespace

void transformDistances(std::vector<uint8_t>& voxels, const Eigen::Vector3i& count, int window,
                        std::span<const uint8_t> of_square) {
  assert(window >= 1 && window <= kLongestWindow);
  assert(of_square.size() == static_cast<size_t>(window) * window + 1);
  measureAlongZ(voxels, count, window);
  const size_t plane = static_cast<size_t>(count.x()) * count.y();
  std::vector<std::unique_ptr<Plane>> planes(usualThreads());
  parallelFor(count.z(), usualThreads(), [&](int k, int thread) {
    if (!planes[thread]) planes[thread] = std::make_unique<Plane>(count, window);
    planes[thread]->transform(&voxels[k * plane], of_square);
  });
}

}  // namespace amble
