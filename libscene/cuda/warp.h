// What the lanes of a warp tell each other (CUDA sources only).
#pragma once

#include "libscene/geometry/ray.h"

#include <cstdint>

namespace masu {

inline constexpr unsigned all_lanes = 0xffffffffU;

// How many of a warp's `lanes`, a bit each, come before `lane`.
__device__ inline unsigned rank_among(unsigned lanes, unsigned lane) {
  return static_cast<unsigned>(__popc(lanes & ((1U << lane) - 1)));
}

// A lane's value, of a type that is made of words, to all of `lanes`: each `width` of them have their own.
template <class T>
__device__ inline T from_lane(const T& value, int lane, unsigned lanes = all_lanes, int width = 32) {
  struct Words {
    std::uint32_t words[sizeof(T) / 4];
  };
  static_assert(sizeof(Words) == sizeof(T));
  Words moved = __builtin_bit_cast(Words, value);
#pragma unroll
  for (std::uint32_t& word : moved.words)
    word = __shfl_sync(lanes, word, lane, width);
  return __builtin_bit_cast(T, moved);
}

// A hit in the order of is_nearer: t is not negative, so its bits rise with it.
__device__ inline std::uint64_t hit_key(const Hit<float>& hit) {
  return std::uint64_t{__float_as_uint(hit.t)} << 32 | hit.primitive;
}
__device__ inline Hit<float> hit_of(std::uint64_t key) {
  return {__uint_as_float(static_cast<std::uint32_t>(key >> 32)), static_cast<PrimitiveIndex>(key)};
}

} // namespace masu
