/// One function compiled for several kinds of processor, chosen from when the program starts.
#pragma once

// In front of a function whose loops gain from wide registers. Its results are the same for all: no
// operations are fused (cmake/AmbleBuild.cmake). What it calls has to be inlined into it. Under a
// sanitizer there is one kind only: the choice comes before that has begun.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define AMBLE_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define AMBLE_FOR_EACH_PROCESSOR
#endif
