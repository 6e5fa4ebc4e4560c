// Host and device from one source: what is marked MASU_HD is compiled for both where nvcc reads it.
// Both sides round alike: no contraction of a*b+c anywhere, IEEE division and square roots, denormals kept;
// so the same function gives the same bits on either.
#pragma once

#ifdef __CUDACC__
#define MASU_HD __host__ __device__
#else
#define MASU_HD
#endif
