// Masu in C++20: RAII and exceptions over the C interface (masu.h says what everything means).
#pragma once

#include "masu.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace masu {

class Exception : public std::runtime_error {
public:
  Exception(masu_status code, const char* message) : std::runtime_error(message), status(code) {}
  masu_status status;
};

// Throws what masu_error() says.
inline void check(masu_status status) {
  if (status != MASU_OK) throw Exception(status, masu_error());
}

inline int gpu_count() {
  int count = 0;
  check(masu_gpu_count(&count));
  return count;
}

inline void write_scene(const std::string& path, std::span<const masu_mesh> meshes,
                        masu_store store = MASU_STORE_AUTO,
                        const std::optional<std::array<double, 3>>& origin = std::nullopt) {
  check(
      masu_write_scene(path.c_str(), meshes.data(), meshes.size(), store, origin ? origin->data() : nullptr));
}

inline masu_grid_options default_grid_options() {
  masu_grid_options options;
  masu_default_grid_options(&options);
  return options;
}

inline void build_grid(const std::string& scene, const std::string& grid,
                       const masu_grid_options& options = default_grid_options()) {
  check(masu_build_grid(scene.c_str(), grid.c_str(), &options));
}

// The format of rays is that of their type. Those of six numbers are an origin and a direction.
template <class T>
concept Ray = std::same_as<T, masu_ray> || std::same_as<T, masu_ray64> ||
    std::same_as<T, std::array<float, 6>> || std::same_as<T, std::array<double, 6>>;
template <Ray R>
constexpr masu_ray_format format_of() {
  if (std::same_as<R, masu_ray>) return MASU_RAYS_FLOAT32;
  if (std::same_as<R, masu_ray64>) return MASU_RAYS_FLOAT64;
  return std::same_as<R, std::array<float, 6>> ? MASU_RAYS_FLOAT32_6 : MASU_RAYS_FLOAT64_6;
}
template <class T> // a vector, an array, a span
concept RayRange = std::ranges::contiguous_range<T> && Ray<std::ranges::range_value_t<T>>;

// As masu_query, but for the format.
struct QueryOptions {
  masu_precision precision = MASU_PRECISION_AUTO;
  bool coherent = false;
  void* stream = nullptr; // of rays in device memory
  bool relative = false;  // to the scene's origin
};

// The hits of rays in host memory.
struct Hits {
  std::vector<float> t;
  std::vector<std::uint32_t> primitive;
};

// A scene and its grid on a device.
class Tracer {
public:
  // Without a grid file a grid is built and kept in memory, as masu_open() says.
  explicit Tracer(const std::string& scene, const std::optional<std::string>& grid = std::nullopt,
                  int device = MASU_CPU)
      : Tracer(scene, grid, std::span<const int>(&device, device == MASU_CPU ? 0 : 1)) {}
  // On several GPUs, which share queries of rays in host memory; none: on the CPU.
  Tracer(const std::string& scene, const std::optional<std::string>& grid, std::span<const int> gpus) {
    masu_tracer* opened = nullptr;
    check(
        masu_open_devices(scene.c_str(), grid ? grid->c_str() : nullptr, gpus.data(), gpus.size(), &opened));
    tracer_.reset(opened);
  }
  // Tests every ray against every primitive.
  static Tracer brute_force(const std::string& scene, std::span<const int> gpus = {}) {
    Tracer tracer;
    masu_tracer* opened = nullptr;
    check(masu_open_brute_force(scene.c_str(), gpus.data(), gpus.size(), &opened));
    tracer.tracer_.reset(opened);
    return tracer;
  }

  masu_description describe() const {
    masu_description description;
    check(masu_describe(tracer_.get(), &description));
    return description;
  }
  masu_primitive primitive(std::uint32_t index) const {
    masu_primitive primitive;
    check(masu_describe_primitive(tracer_.get(), index, &primitive));
    return primitive;
  }

  // In host memory, or all in memory of one of the tracer's GPUs.
  template <Ray R>
  void nearest(const R* rays, std::size_t count, const masu_hits& hits,
               const QueryOptions& options = {}) const {
    const masu_query query = query_of<R>(options);
    check(masu_nearest(tracer_.get(), rays, count, &query, &hits));
  }
  template <Ray R>
  void occluded(const R* rays, std::size_t count, std::uint8_t* occluded,
                const QueryOptions& options = {}) const {
    const masu_query query = query_of<R>(options);
    check(masu_occluded(tracer_.get(), rays, count, &query, occluded));
  }

  // In host memory.
  template <RayRange Rays>
  Hits nearest(const Rays& rays, const QueryOptions& options = {}) const {
    const std::size_t count = std::ranges::size(rays);
    Hits found{std::vector<float>(count), std::vector<std::uint32_t>(count)};
    masu_hits hits{};
    hits.t = found.t.data();
    hits.primitive = found.primitive.data();
    nearest(std::ranges::data(rays), count, hits, options);
    return found;
  }
  template <RayRange Rays>
  std::vector<std::uint8_t> occluded(const Rays& rays, const QueryOptions& options = {}) const {
    std::vector<std::uint8_t> found(std::ranges::size(rays));
    occluded(std::ranges::data(rays), found.size(), found.data(), options);
    return found;
  }

  masu_tracer* get() const { return tracer_.get(); }

private:
  Tracer() = default;
  template <Ray R>
  static masu_query query_of(const QueryOptions& options) {
    return {format_of<R>(), options.precision, options.coherent ? 1 : 0, options.stream,
            options.relative ? 1 : 0};
  }

  struct Close {
    void operator()(masu_tracer* tracer) const { masu_close(tracer); }
  };
  std::unique_ptr<masu_tracer, Close> tracer_;
};

} // namespace masu
