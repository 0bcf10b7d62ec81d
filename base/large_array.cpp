#include "base/large_array.h"

#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace amble {
namespace {

// What is smaller than a few large pages has no use of them [bytes].
constexpr size_t kLeastMapped = size_t{4} << 20;

}  // namespace

void* takeZeroed(size_t bytes) {
  if (bytes < kLeastMapped) {
    void* const memory = std::calloc(std::max<size_t>(1, bytes), 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  madvise(memory, bytes, MADV_HUGEPAGE);  // where it cannot be, small pages do
  return memory;
}

void giveBack(void* memory, size_t bytes) noexcept {
  if (bytes < kLeastMapped) {
    std::free(memory);
  } else if (memory != nullptr) {
    munmap(memory, bytes);
  }
}

}  // namespace amble
