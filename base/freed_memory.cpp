#include "base/freed_memory.h"

#include <cstdlib>
#include <memory>

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace amble {

void keepFreedMemory([[maybe_unused]] size_t bytes) {
#if defined(__GLIBC__)
  constexpr int kLargest = 32 << 20;  // that glibc lets be kept [bytes]
  mallopt(M_MMAP_THRESHOLD, kLargest);
  mallopt(M_TRIM_THRESHOLD, 4 * kLargest);
#if defined(MADV_HUGEPAGE)
  constexpr size_t kPage = size_t{2} << 20;  // [bytes]
  void* begin = std::malloc(bytes);          // none where the work may not fill so much
  void* const whole = begin;
  size_t size = bytes;
  if (begin && std::align(kPage, bytes - kPage, begin, size))
    madvise(begin, bytes - kPage, MADV_HUGEPAGE);
  std::free(whole);
#endif
#endif
}

void giveBackFreedMemory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace amble
