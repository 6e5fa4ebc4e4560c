// Masu in C++20: RAII and exceptions over the C interface (masu.h says what everything means).
#pragma once

#include "masu.h"

#include <cstdint>
#include <memory>
#include <optional>
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
                        masu_store store = MASU_STORE_AUTO) {
  check(masu_write_scene(path.c_str(), meshes.data(), meshes.size(), store));
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

// The hits of rays in host memory.
struct Hits {
  std::vector<float> t;
  std::vector<std::uint32_t> primitive;
};

// A scene and its grid on a device. Without a grid every ray is tested against every primitive.
class Tracer {
public:
  Tracer(const std::string& scene, const std::optional<std::string>& grid, int device = MASU_CPU) {
    masu_tracer* opened = nullptr;
    check(masu_open(scene.c_str(), grid ? grid->c_str() : nullptr, device, &opened));
    tracer_.reset(opened);
  }
  // On several GPUs, which share queries of rays in host memory; none: on the CPU.
  Tracer(const std::string& scene, const std::optional<std::string>& grid, std::span<const int> gpus) {
    masu_tracer* opened = nullptr;
    check(
        masu_open_devices(scene.c_str(), grid ? grid->c_str() : nullptr, gpus.data(), gpus.size(), &opened));
    tracer_.reset(opened);
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
  void nearest(const masu_ray* rays, std::size_t count, const masu_hits& hits,
               const masu_query& query = {}) const {
    check(masu_nearest(tracer_.get(), rays, count, &query, &hits));
  }
  void occluded(const masu_ray* rays, std::size_t count, std::uint8_t* occluded,
                const masu_query& query = {}) const {
    check(masu_occluded(tracer_.get(), rays, count, &query, occluded));
  }

  // In host memory.
  Hits nearest(std::span<const masu_ray> rays, const masu_query& query = {}) const {
    Hits found{std::vector<float>(rays.size()), std::vector<std::uint32_t>(rays.size())};
    nearest(rays.data(), rays.size(), {found.t.data(), found.primitive.data(), nullptr, nullptr, nullptr},
            query);
    return found;
  }
  std::vector<std::uint8_t> occluded(std::span<const masu_ray> rays, const masu_query& query = {}) const {
    std::vector<std::uint8_t> found(rays.size());
    occluded(rays.data(), rays.size(), found.data(), query);
    return found;
  }

  masu_tracer* get() const { return tracer_.get(); }

private:
  struct Close {
    void operator()(masu_tracer* tracer) const { masu_close(tracer); }
  };
  std::unique_ptr<masu_tracer, Close> tracer_;
};

} // namespace masu
