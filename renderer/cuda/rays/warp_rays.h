// What the lanes of a warp share: rays, walks along segments of them, and how these are divided (CUDA sources
// only).
#pragma once

#include "libgrid/grid/grid_walk.h"
#include "libscene/cuda/warp.h"
#include "renderer/cuda/kernel.h"

namespace masu {

inline constexpr int rays_per_block = 128;

// Of so many lanes that have something to be shared out, each gets 2^n lanes for it.
__device__ inline int lanes_log2_for_each(int having) {
  return having > lanes_per_warp / 2 ? 0 : __clz(having - 1) - 27;
}

// What is needed of a ray when it is begun and ended.
template <class Real>
struct RayEnds {
  Real scale, skipped, t_min, t_max;
  std::uint32_t number; // in the list
};

// What a lane has for others to help with: a list of its ray's, or a walk.
struct SharedOut {
  std::uint32_t ray, list;
};

// A ray's nearest hit so far, in shared memory: as NearestHit (libgrid/trace/trace.h) has it.
template <class Real>
class SharedHit {
public:
  __device__ Hit<Real> get() const { return hit_; }
  __device__ void set(const Hit<Real>& hit) { hit_ = hit; }
  // For all lanes of a warp at once, of which several may have hit with one ray: the nearest hit remains.
  __device__ void lower(bool has_hit, const Hit<Real>& hit) {
    for (unsigned left = __ballot_sync(all_lanes, has_hit); left != 0; left &= left - 1) {
      if (static_cast<int>(threadIdx.x % lanes_per_warp) == __ffs(left) - 1 &&
          is_nearer(hit.t, hit.primitive, hit_))
        hit_ = hit;
      __syncwarp();
    }
  }

private:
  Hit<Real> hit_;
};
template <>
class SharedHit<float> {
public:
  __device__ Hit<float> get() const { return hit_of(key_); }
  __device__ void set(const Hit<float>& hit) { key_ = hit_key(hit); }
  __device__ void lower(bool has_hit, const Hit<float>& hit) {
    if (has_hit) atomicMin(&key_, static_cast<unsigned long long>(hit_key(hit)));
    __syncwarp();
  }

private:
  unsigned long long key_;
};

// The rays of a warp, in shared memory: any lane may work on any of them. A lane's own ray has the lane's
// number.
template <class TestRay>
struct WarpRays {
  using Real = typename TestRay::Real;
  TestRay tests[lanes_per_warp];
  SharedHit<Real> nearest[lanes_per_warp];
  RayEnds<Real> ends[lanes_per_warp];
  SharedOut shared_out[lanes_per_warp]; // one after another
};

// A lane's walk: along its own ray, or a segment of any ray.
template <class Real, class Structure>
struct LaneWalk {
  Walk<Real, Structure> walk;
  Real end;          // of the segment
  std::uint32_t ray; // whose segment it is
  bool under_way;
};

// Cuts what the walks under way have still to go, as far as a hit may still be nearer, into as many segments
// of equal length as there are lanes for each; but into none shorter than a voxel. There are at most half as
// many walks as lanes.
template <class TestRay, class Structure>
__device__ inline void split_segments(const Structure& grid, unsigned under_way, WarpRays<TestRay>& rays,
                                      LaneWalk<typename TestRay::Real, Structure>& own) {
  using Real = typename TestRay::Real;
  const unsigned lane = threadIdx.x % lanes_per_warp;
  const int walks = __popc(under_way), log2 = lanes_log2_for_each(walks);
  __syncwarp(); // what was shared out before has been read
  if (own.under_way) rays.shared_out[rank_among(under_way, lane)].ray = lane;
  __syncwarp();
  const int of = static_cast<int>(lane) >> log2, segment = static_cast<int>(lane) & ((1 << log2) - 1);
  const int source = static_cast<int>(rays.shared_out[of < walks ? of : 0].ray);
  Walk<Real, Structure>& walk = own.walk;
  own.ray = __shfl_sync(all_lanes, own.ray, source);
  own.end = from_lane(own.end, source);
  walk.x = from_lane(walk.x, source);
  walk.y = from_lane(walk.y, source);
  walk.z = from_lane(walk.z, source);
  walk.exit = from_lane(walk.exit, source);
  own.under_way = of < walks;
  const Real from = walk.exit,
             to = fast_min(own.end, fast_min(walk.end(grid), rays.nearest[own.ray].get().t)),
             step = (to - from) / static_cast<Real>(1 << log2);
  if (!(step * walk.speed() > 1)) {
    own.under_way = own.under_way && segment == 0;
    return;
  }
  if (segment + 1 < 1 << log2) own.end = fma(step, static_cast<Real>(segment + 1), from);
  if (segment > 0) walk.begin_at(grid, fma(step, static_cast<Real>(segment), from));
}

} // namespace masu
