# Flags of our own code. Targets opt in by linking adit::options, so that generated and foreign code
# is compiled without our warnings.
add_library(adit_options INTERFACE)
add_library(adit::options ALIAS adit_options)
target_compile_options(adit_options INTERFACE -Wall -Wextra -Werror)
# GCC 12 warns of overlapping copies inside its own std::string (GCC bug 105651).
target_compile_options(adit_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Clang does not know `GCC ivdep`, by which GCC makes vector code of a loop.
target_compile_options(adit_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-pragmas>)
target_include_directories(adit_options INTERFACE ${PROJECT_SOURCE_DIR})

set(ADIT_SANITIZE "" CACHE STRING "sanitizers, comma separated: address,undefined or thread")
if(ADIT_SANITIZE)
  add_compile_options(-fsanitize=${ADIT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${ADIT_SANITIZE})
endif()

# Kernels are vectorized with AVX2, and never contract a*b+c into a fused operation: the same source then gives
# the same bits on any x86-64 machine, whatever the compiler finds to fuse.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  set(ADIT_ARCH "x86-64-v3" CACHE STRING "value of -march; empty: the compiler's default")
  if(ADIT_ARCH)
    add_compile_options(-march=${ADIT_ARCH})
  endif()
endif()
add_compile_options(-ffp-contract=off)
