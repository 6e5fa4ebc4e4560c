// libFuzzer target: the C interface's calls in any order, with any rays, meshes and options: a status each,
// never a fault. Pointers and counts are right, as masu.h demands.
#include "api/masu.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

// Numbers from the input; zeros behind its end.
class Input {
public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  bool is_empty() const { return size_ == 0; }
  template <class T>
  T take() {
    T value{};
    const std::size_t bytes = std::min(sizeof value, size_);
    std::memcpy(&value, data_, bytes);
    data_ += bytes;
    size_ -= bytes;
    return value;
  }

private:
  const std::uint8_t* data_;
  std::size_t size_;
};

// Any value, as C has it.
template <class Enum>
void set(Enum& value, int number) {
  static_assert(sizeof value == sizeof number);
  std::memcpy(&value, &number, sizeof number);
}

// Files of this process, two of each kind.
std::string file(const char* kind, unsigned number) {
  return "/dev/shm/masu-fuzz-" + std::to_string(getpid()) + "-" + kind + std::to_string(number % 2);
}

// A number that is often a sensible one.
float number(Input& input) {
  const auto bits = input.take<std::uint16_t>();
  if (bits % 8 == 0) return input.take<float>();
  return static_cast<float>(static_cast<std::int16_t>(bits)) / 4096;
}

void write_scene(Input& input) {
  std::vector<float> vertices(3 * (input.take<std::uint8_t>() % 16U));
  for (float& v : vertices)
    v = number(input);
  std::vector<std::uint32_t> indices(3 * (input.take<std::uint8_t>() % 16U));
  for (std::uint32_t& i : indices)
    i = input.take<std::uint8_t>() % 17U;
  const std::array<float, 3> color{number(input), number(input), number(input)};
  masu_mesh mesh{};
  mesh.vertices = vertices.data();
  mesh.vertex_count = vertices.size() / 3;
  mesh.indices = indices.data();
  mesh.triangle_count = indices.size() / 3;
  mesh.color = input.take<std::uint8_t>() % 2 == 0 ? color.data() : nullptr;
  const auto kind = input.take<std::uint8_t>(), store = input.take<std::uint8_t>();
  const bool has_origin = input.take<std::uint8_t>() % 2 == 0;
  const std::array origin{input.take<double>(), input.take<double>(), input.take<double>()};
  static_cast<void>(masu_write_scene(file("scene", kind).c_str(), &mesh, 1,
                                     static_cast<masu_store>(store % 4),
                                     has_origin ? origin.data() : nullptr));
}

void build_grid(Input& input) {
  masu_grid_options options;
  masu_default_grid_options(&options);
  set(options.kind, input.take<std::uint8_t>() % 8);
  static constexpr std::array divisions{"auto", "1", "3", "2x5x1", "cleary:1", "woo:1", "x", ""};
  options.division = divisions[input.take<std::uint8_t>() % divisions.size()];
  options.box_overlap = input.take<std::uint8_t>() % 2;
  options.cube_space = input.take<std::uint8_t>() % 2;
  options.target = input.take<std::uint8_t>();
  if (input.take<std::uint8_t>() % 4 == 0) options.alpha = number(input);
  if (input.take<std::uint8_t>() % 4 == 0) options.step_cost = number(input);
  options.threads = input.take<std::uint8_t>() % 3;
  const auto files = input.take<std::uint8_t>();
  static_cast<void>(
      masu_build_grid(file("scene", files).c_str(), file("grid", files / 2U).c_str(), &options));
}

template <class Real>
std::vector<Real> rays_of(Input& input, std::size_t numbers) {
  std::vector<Real> rays(numbers);
  for (Real& r : rays)
    r = static_cast<Real>(number(input));
  return rays;
}

void query(Input& input, const masu_tracer* tracer) {
  const std::size_t count = input.take<std::uint8_t>() % 8U;
  masu_query options{};
  const int format = input.take<std::uint8_t>() % 5;
  set(options.format, format);
  set(options.precision, input.take<std::uint8_t>() % 5);
  options.coherent = input.take<std::uint8_t>() % 2;
  const std::vector<float> rays = rays_of<float>(input, 8 * count);
  const std::vector<double> rays64(rays.begin(), rays.end());
  const bool is_float64 = format == MASU_RAYS_FLOAT64 || format == MASU_RAYS_FLOAT64_6;
  const void* const list = is_float64 ? static_cast<const void*>(rays64.data()) : rays.data();
  std::vector<float> t(count), uv(2 * count), normal(3 * count);
  std::vector<std::uint32_t> primitive(count), object(count), face(count);
  const auto wanted = input.take<std::uint8_t>();
  const masu_hits hits{
      (wanted & 1U) != 0 ? t.data() : nullptr,       (wanted & 2U) != 0 ? primitive.data() : nullptr,
      (wanted & 4U) != 0 ? object.data() : nullptr,  (wanted & 8U) != 0 ? uv.data() : nullptr,
      (wanted & 16U) != 0 ? normal.data() : nullptr, (wanted & 32U) != 0 ? face.data() : nullptr};
  masu_description description{};
  const bool is_known = masu_describe(tracer, &description) == MASU_OK;
  if (masu_nearest(tracer, list, count, &options, &hits) == MASU_OK && is_known && (wanted & 3U) == 3) {
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = std::isfinite(t[i]);
      if (hit != (primitive[i] < description.triangles + description.spheres + description.cones))
        std::abort();
    }
  }
  std::vector<std::uint8_t> occluded(count);
  static_cast<void>(masu_occluded(tracer, list, count, &options, occluded.data()));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  std::array<masu_tracer*, 2> tracers{};
  for (int calls = 0; calls < 24 && !input.is_empty(); ++calls) {
    const auto call = input.take<std::uint8_t>();
    masu_tracer*& tracer = tracers[call / 8U % 2];
    switch (call % 8) {
    case 0:
      write_scene(input);
      break;
    case 1:
      build_grid(input);
      break;
    case 2:
    case 3: {
      masu_close(tracer);
      tracer = nullptr;
      const auto files = input.take<std::uint8_t>();
      const std::string scene = file("scene", files), grid = file("grid", files / 2U);
      const masu_status status =
          files % 8 == 7
              ? masu_open_brute_force(scene.c_str(), nullptr, 0, &tracer)
              : masu_open(scene.c_str(), files % 8 < 4 ? grid.c_str() : nullptr, MASU_CPU, &tracer);
      if (status != MASU_OK && (tracer != nullptr || std::strlen(masu_error()) == 0)) std::abort();
      break;
    }
    case 4:
      masu_close(tracer);
      tracer = nullptr;
      break;
    case 5: {
      masu_primitive primitive{};
      if (tracer != nullptr)
        static_cast<void>(masu_describe_primitive(tracer, input.take<std::uint16_t>(), &primitive));
      break;
    }
    default:
      if (tracer != nullptr) query(input, tracer);
    }
  }
  for (masu_tracer* const tracer : tracers)
    masu_close(tracer);
  for (const char* const kind : {"scene", "grid"})
    for (const unsigned i : {0U, 1U})
      static_cast<void>(unlink(file(kind, i).c_str()));
  return 0;
}
