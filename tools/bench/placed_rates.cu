// Rates of placed meshes on a GPU, beside those of the same scene written out, and how long moving takes:
// medians of some runs.
#include <masu/masu.hpp>

#include <cuda_runtime.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace {

using Matrix = std::array<double, 12>;

struct Mesh {
  std::vector<float> vertices;
  std::vector<std::uint32_t> faces;
};

// A bumpy sphere of about 2 n^2 triangles.
Mesh bumpy_sphere(std::uint32_t n) {
  Mesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const float a = 3.14159265F * static_cast<float>(i) / static_cast<float>(n),
                  b = 2 * 3.14159265F * static_cast<float>(k) / static_cast<float>(n);
      const float r = 1 + 0.1F * std::sin(7 * a) * std::cos(5 * b);
      for (const float c : {r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b), r * std::cos(a)})
        mesh.vertices.push_back(c);
      if (i == n || k == n) continue;
      const std::uint32_t at = i * (n + 1) + k;
      for (const std::uint32_t v : {at, at + n + 1, at + 1, at + 1, at + n + 1, at + n + 2})
        mesh.faces.push_back(v);
    }
  }
  return mesh;
}

std::mt19937_64 engine(1);
double uniform(double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(engine);
}

std::vector<Matrix> random_transforms(std::size_t count, double extent) {
  std::vector<Matrix> transforms(count);
  for (Matrix& m : transforms) {
    const double a = uniform(0, 6.3), b = uniform(0, 6.3), c = std::cos(a), s = std::sin(a), d = std::cos(b),
                 e = std::sin(b);
    m = {c, -s * d, s * e, uniform(-extent, extent), s, c * d, -c * e, uniform(-extent, extent),
         0, e,      d,     uniform(-extent, extent)};
  }
  return transforms;
}

double median_seconds(const std::function<void()>& act) {
  std::vector<double> seconds;
  for (int i = 0; i < 9; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    act();
    if (cudaDeviceSynchronize() != cudaSuccess) std::exit(1);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::ranges::nth_element(seconds, seconds.begin() + 4);
  return seconds[4];
}

struct DeviceRays {
  masu_ray* rays = nullptr;
  float* t = nullptr;
  std::uint8_t* occluded = nullptr;
  std::uint32_t* worlds = nullptr;
  std::size_t count;

  DeviceRays(const std::vector<masu_ray>& host, const std::vector<std::uint32_t>& worlds_)
      : count(host.size()) {
    cudaMalloc(&rays, count * sizeof(masu_ray));
    cudaMalloc(&t, count * sizeof(float));
    cudaMalloc(&occluded, count);
    cudaMemcpy(rays, host.data(), count * sizeof(masu_ray), cudaMemcpyHostToDevice);
    if (worlds_.empty()) return;
    cudaMalloc(&worlds, count * sizeof(std::uint32_t));
    cudaMemcpy(worlds, worlds_.data(), count * sizeof(std::uint32_t), cudaMemcpyHostToDevice);
  }
};

// Rays between random points within the extent; for the camera's from one point through a grid of pixels.
std::vector<masu_ray> rays_within(double extent, std::size_t count, bool camera) {
  std::vector<masu_ray> rays(count);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  for (std::size_t i = 0; i < count; ++i) {
    masu_ray& ray = rays[i];
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] =
          static_cast<float>(camera ? (axis == 2 ? 2.5 * extent : 0.0) : uniform(-extent, extent));
      ray.direction[axis] = static_cast<float>(uniform(-extent, extent)) - ray.origin[axis];
    }
    if (camera) {
      ray.direction[0] = static_cast<float>(i % side) / static_cast<float>(side) - 0.5F;
      ray.direction[1] = static_cast<float>(i / side) / static_cast<float>(side) - 0.5F;
      ray.direction[2] = -1;
    }
    ray.tmin = 0;
    ray.tmax = INFINITY;
  }
  return rays;
}

void print_rates(const char* name, const masu::Tracer& tracer, double extent,
                 const std::vector<std::uint32_t>& worlds = {}) {
  constexpr std::size_t count = std::size_t{1} << 22;
  std::printf("%-44s", name);
  for (const bool camera : {true, false}) {
    std::vector<std::uint32_t> of_ray(worlds.empty() ? 0 : count);
    for (std::size_t i = 0; i < of_ray.size(); ++i)
      of_ray[i] = worlds[i * worlds.size() / count];
    static std::vector<masu_ray> kept[2];
    if (kept[camera].empty()) kept[camera] = rays_within(1, count, camera);
    std::vector<masu_ray> rays = kept[camera];
    for (masu_ray& ray : rays)
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] *= static_cast<float>(extent);
        ray.direction[axis] *= static_cast<float>(extent);
      }
    const DeviceRays there(rays, of_ray);
    auto hits = masu::sized<masu_hits>();
    hits.t = there.t;
    masu::QueryOptions options;
    options.worlds = there.worlds;
    options.coherent = camera;
    const double nearest = median_seconds([&] { tracer.nearest(there.rays, count, hits, options); });
    const double any = median_seconds([&] { tracer.occluded(there.rays, count, there.occluded, options); });
    std::printf("  %8.1f %8.1f", count / nearest * 1e-6, count / any * 1e-6);
  }
  std::printf("\n");
}

std::size_t used_memory() {
  std::size_t free = 0, all = 0;
  cudaMemGetInfo(&free, &all);
  return all - free;
}

masu::Scene scene_of(const std::vector<Mesh>& meshes, const std::vector<masu_placement>& placements) {
  std::vector<masu_mesh> views;
  for (const Mesh& mesh : meshes)
    views.push_back(masu::mesh(mesh.vertices, mesh.faces));
  return masu::Scene(views, placements);
}

std::vector<Mesh> written_out(const std::vector<Mesh>& meshes,
                              const std::vector<masu_placement>& placements) {
  std::vector<Mesh> written;
  for (const masu_placement& p : placements) {
    Mesh mesh = meshes[p.mesh];
    for (std::size_t v = 0; v < mesh.vertices.size(); v += 3) {
      double w[3];
      for (int row = 0; row < 3; ++row)
        w[row] = p.transform[4 * row] * mesh.vertices[v] + p.transform[4 * row + 1] * mesh.vertices[v + 1] +
                 p.transform[4 * row + 2] * mesh.vertices[v + 2] + p.transform[4 * row + 3];
      for (int row = 0; row < 3; ++row)
        mesh.vertices[v + static_cast<std::size_t>(row)] = static_cast<float>(w[row]);
    }
    written.push_back(std::move(mesh));
  }
  return written;
}

// Moving all vertices of a scene that is written out, on the device, and refitting its hierarchy.
void print_update(masu::Tracer& tracer, const std::vector<Mesh>& meshes) {
  std::vector<float> vertices;
  for (const Mesh& mesh : meshes)
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  auto moved = masu::sized<masu_vertices>();
  moved.count = vertices.size() / 3;
  float* there = nullptr;
  cudaMalloc(&there, vertices.size() * sizeof(float));
  cudaMemcpy(there, vertices.data(), vertices.size() * sizeof(float), cudaMemcpyHostToDevice);
  moved.values = there;
  std::printf("written out: all vertices moved in %.3f ms from device memory\n",
              median_seconds([&] { tracer.update(moved); }) * 1e3);
  cudaFree(there);
}

void move_all(const std::vector<Mesh>& meshes, std::size_t count, std::uint32_t worlds) {
  const double extent = 2 * std::cbrt(static_cast<double>(count));
  std::vector<masu_placement> placements;
  for (const Matrix& m : random_transforms(count, extent))
    placements.push_back(masu::placement(static_cast<std::uint32_t>(placements.size() % meshes.size()), m,
                                         static_cast<std::uint32_t>(placements.size() % worlds)));
  masu::Tracer tracer(scene_of(meshes, placements), 0);
  const std::vector<Matrix> moved = random_transforms(count, extent);
  Matrix* there = nullptr;
  cudaMalloc(&there, count * sizeof(Matrix));
  cudaMemcpy(there, moved.data(), count * sizeof(Matrix), cudaMemcpyHostToDevice);
  auto moves = masu::sized<masu_transforms>();
  moves.values64 = there->data();
  moves.count = count;
  const double from_device = median_seconds([&] { tracer.place(moves); });
  const double from_host = median_seconds([&] { tracer.place(std::span<const Matrix>(moved)); });
  std::printf(
      "%7zu placements of %zu meshes in %u worlds moved: %.3f ms from device memory, %.3f from the host's\n",
      count, meshes.size(), worlds, from_device * 1e3, from_host * 1e3);
}

} // namespace

int main() try {
  std::printf("%-44s  %17s  %17s\n%-44s  %8s %8s  %8s %8s\n", "million rays per second", "camera", "random",
              "", "nearest", "any", "nearest", "any");
  {
    const std::vector<Mesh> one{bumpy_sphere(500)};
    const Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    Matrix turned = random_transforms(1, 0)[0];
    print_rates("one mesh, unplaced", masu::Tracer(scene_of(one, {}), 0), 1);
    print_rates("one mesh, placed by the identity",
                masu::Tracer(scene_of(one, {masu::placement(0, identity)}), 0), 1);
    print_rates("one mesh, turned", masu::Tracer(scene_of(one, {masu::placement(0, turned)}), 0), 1);
  }
  {
    std::vector<Mesh> meshes;
    for (std::uint32_t i = 0; i < 30; ++i)
      meshes.push_back(bumpy_sphere(16 + i));
    std::vector<masu_placement> placements, worlds;
    for (const Matrix& m : random_transforms(10000, 40))
      placements.push_back(masu::placement(static_cast<std::uint32_t>(placements.size() % 30), m));
    std::size_t before = used_memory();
    {
      const masu::Tracer tracer(scene_of(meshes, placements), 0);
      std::printf("(%.0f MB) ", static_cast<double>(used_memory() - before) * 1e-6);
      print_rates("10000 placements", tracer, 40);
    }
    before = used_memory();
    {
      const std::vector<Mesh> written = written_out(meshes, placements);
      masu::Tracer tracer(scene_of(written, {}), 0);
      std::printf("(%.0f MB) ", static_cast<double>(used_memory() - before) * 1e-6);
      print_rates("10000 written out", tracer, 40);
      print_update(tracer, written);
    }
    // 14 in each of 4096 worlds, all at one place.
    const std::vector<Matrix> fourteen = random_transforms(14, 3);
    std::vector<masu_placement> alone;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t world = 0; world < 4096; ++world) {
      numbers.push_back(world);
      for (std::uint32_t i = 0; i < 14; ++i)
        worlds.push_back(masu::placement(i, fourteen[i], world));
    }
    for (std::uint32_t i = 0; i < 14; ++i)
      alone.push_back(masu::placement(i, fourteen[i]));
    print_rates("14 placements, one world", masu::Tracer(scene_of(meshes, alone), 0), 4);
    print_rates("14 placements in each of 4096 worlds", masu::Tracer(scene_of(meshes, worlds), 0), 4,
                numbers);
    for (const std::uint32_t of : {1U, 256U}) {
      move_all(meshes, 4096, of);
      move_all(meshes, 131072, of);
    }
  }
  return 0;
} catch (const masu::Exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
