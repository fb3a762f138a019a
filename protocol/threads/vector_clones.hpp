// Marks a function that is compiled once for each vector width of x86-64; the machine's widest is taken when
// the program starts. Products and sums are never contracted, so that all of them give the same bits. What
// such a function calls must be inlined into it.
#pragma once

// A sanitizer is not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ADIT_VECTOR_CLONES [[gnu::target_clones("arch=x86-64-v4", "default")]]
#else
#define ADIT_VECTOR_CLONES
#endif
