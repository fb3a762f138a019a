// Marks a function that is compiled once for each vector width of x86-64. When the program starts, the
// version for the widest vectors of the processor is chosen. All versions give the same bits, because
// products and sums are never contracted (cmake/options.cmake). Functions that it calls must be inlined into
// it.
#pragma once

// The choice is made before a sanitizer is ready, which would then crash.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ADIT_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v4", "default")]]
#else
#define ADIT_VECTOR_CLONES
#endif
