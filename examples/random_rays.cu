// Which share of random rays hits: `random_rays SCENE GRID`. Rays are made, traced and counted on a GPU,
// queued on one stream, and only the count leaves it.
#include <masu/masu.hpp>

#include <cstdio>
#include <cuda_runtime.h>

namespace {

constexpr unsigned ray_count = 1 << 22;

__device__ float random_number(unsigned& state) { // PCG: O'Neill (2014), as a hash (Jarzynski & Olano 2020)
  state = state * 747796405u + 2891336453u;
  const unsigned word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
  return static_cast<float>((word >> 22) ^ word) * 0x1p-32f;
}

// From a point of the box to another.
__global__ void make_rays(masu_ray* rays, masu_scene_description scene) {
  unsigned state = blockIdx.x * blockDim.x + threadIdx.x;
  masu_ray& ray = rays[state] = {{}, 0, {}, 1};
  for (int i = 0; i < 3; ++i) {
    const float low = static_cast<float>(scene.bounds_min[i]), high = static_cast<float>(scene.bounds_max[i]);
    ray.origin[i] = low + random_number(state) * (high - low);
    ray.direction[i] = low + random_number(state) * (high - low) - ray.origin[i];
  }
}

__global__ void count_hits(const std::uint8_t* occluded, unsigned* hits) {
  if (occluded[blockIdx.x * blockDim.x + threadIdx.x]) atomicAdd(hits, 1u);
}

void check(cudaError_t error) {
  if (error != cudaSuccess) throw masu::Exception(MASU_ERROR_DEVICE, cudaGetErrorString(error));
}

} // namespace

int main(int argc, char** argv) try {
  if (argc != 3) return std::fputs("usage: random_rays SCENE GRID\n", stderr), MASU_ERROR_USAGE;
  const masu::Scene scene = masu::Scene::read(argv[1]);
  const masu::Tracer tracer(scene, masu::Grid::read(argv[2]), 0);
  cudaStream_t stream;
  masu_ray* rays;
  std::uint8_t* occluded;
  unsigned *hits, hit_count;
  check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  check(cudaMallocAsync(&rays, sizeof(masu_ray) * ray_count, stream));
  check(cudaMallocAsync(&occluded, ray_count, stream));
  check(cudaMallocAsync(&hits, sizeof(unsigned), stream));
  check(cudaMemsetAsync(hits, 0, sizeof(unsigned), stream));
  make_rays<<<ray_count / 256, 256, 0, stream>>>(rays, scene.describe());
  tracer.occluded(rays, ray_count, occluded, {.stream = stream});
  count_hits<<<ray_count / 256, 256, 0, stream>>>(occluded, hits);
  check(cudaMemcpyAsync(&hit_count, hits, sizeof(unsigned), cudaMemcpyDeviceToHost, stream));
  check(cudaStreamSynchronize(stream));
  std::printf("%u of %u rays hit\n", hit_count, ray_count);
} catch (const masu::Exception& error) {
  std::fprintf(stderr, "random_rays: %s\n", error.what());
  return error.status;
}
