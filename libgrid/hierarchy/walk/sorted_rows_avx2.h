// Eight rows of eight numbers, each sorted, all at once, on a processor with AVX2. Host only.
#pragma once

#include "libscene/base/portable.h"

#include <immintrin.h>

namespace masu {

// Rows become columns.
MASU_ALWAYS_INLINE void transpose(__m256i (&rows)[8]) {
  __m256i pairs[8], fours[8];
  for (int i = 0; i < 8; i += 2) {
    pairs[i] = _mm256_unpacklo_epi32(rows[i], rows[i + 1]);
    pairs[i + 1] = _mm256_unpackhi_epi32(rows[i], rows[i + 1]);
  }
  for (int i = 0; i < 8; i += 4) {
    fours[i] = _mm256_unpacklo_epi64(pairs[i], pairs[i + 2]);
    fours[i + 1] = _mm256_unpackhi_epi64(pairs[i], pairs[i + 2]);
    fours[i + 2] = _mm256_unpacklo_epi64(pairs[i + 1], pairs[i + 3]);
    fours[i + 3] = _mm256_unpackhi_epi64(pairs[i + 1], pairs[i + 3]);
  }
  for (int i = 0; i < 4; ++i) {
    rows[i] = _mm256_permute2x128_si256(fours[i], fours[i + 4], 0x20);
    rows[i + 4] = _mm256_permute2x128_si256(fours[i], fours[i + 4], 0x31);
  }
}

// Each row's signed numbers from the largest to the smallest.
MASU_ALWAYS_INLINE void sort_descending(__m256i (&rows)[8]) {
  transpose(rows);
  const auto order = [&](int larger, int smaller) __attribute__((always_inline)) {
    const __m256i a = rows[larger], b = rows[smaller];
    rows[larger] = _mm256_max_epi32(a, b);
    rows[smaller] = _mm256_min_epi32(a, b);
  };
  const auto order_four = [&](int a, int b, int c, int d, int e, int f, int g, int h)
      __attribute__((always_inline)) {
    order(a, b);
    order(c, d);
    order(e, f);
    order(g, h);
  };
  order_four(0, 1, 2, 3, 4, 5, 6, 7);
  order_four(0, 2, 1, 3, 4, 6, 5, 7);
  order_four(1, 2, 5, 6, 0, 4, 3, 7);
  order(1, 5);
  order(2, 6);
  order_four(1, 4, 3, 6, 2, 4, 3, 5);
  order(3, 4);
  transpose(rows);
}

} // namespace masu
