// Host and device from one source: what is marked MASU_HD is compiled for both where nvcc reads it.
// Both sides round alike: no contraction of a*b+c anywhere, IEEE division and square roots, denormals kept;
// so the same function gives the same bits on either.
#pragma once

#ifdef __CUDACC__
#define MASU_HD __host__ __device__
#else
#define MASU_HD
#endif

// For functions of a few instructions. A compiler that has much to inline calls some of them instead, and
// three floats come back in halves of two registers: on a CPU pictures then take 10 to 30 % longer, and a
// test of a sphere takes six times as long.
#define MASU_SMALL MASU_HD __attribute__((always_inline)) inline
