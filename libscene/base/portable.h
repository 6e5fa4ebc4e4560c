// Host and device code from one source: nvcc compiles functions marked MASU_HD for both.
// Both round alike (no contraction of a*b+c, IEEE division and square roots, denormals kept), so that a
// function gives the same bits on either.
#pragma once

#ifdef __CUDACC__
#define MASU_HD __host__ __device__
#else
#define MASU_HD
#endif

// A lambda that is called for each of many items, by passes (libscene/passes/executor.h) and checks
// (libscene/file/record_checker.h): compiled for the device where nvcc reads it.
#ifdef __CUDACC__
#define MASU_PASS __device__
#else
#define MASU_PASS
#endif

// For functions of a few instructions. Left to itself the compiler calls some of them in large loops, and a
// call returns three floats packed into two registers: CPU renders then take 10 to 30 % longer, a sphere test
// six times as long.
#define MASU_ALWAYS_INLINE MASU_HD __attribute__((always_inline)) inline

// Host code may use intrinsics of AVX2 and FMA.
#if !defined(__CUDACC__) && defined(__AVX2__) && defined(__FMA__)
#define MASU_HOST_AVX2
#endif

namespace masu {
inline constexpr int lanes_per_warp = 32; // of every CUDA GPU
}
