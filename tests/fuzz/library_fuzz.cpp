// libFuzzer target: the C interface's calls in any order, with any rays, meshes and options: a status each,
// never a fault; and rays of a list hit what each hits alone. Pointers and counts are right, as masu.h
// demands.
#include "api/masu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>
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

// A number that is often a sensible one.
float number(Input& input) {
  const auto bits = input.take<std::uint16_t>();
  if (bits % 8 == 0) return input.take<float>();
  return static_cast<float>(static_cast<std::int16_t>(bits)) / 4096;
}

std::vector<float> numbers_of(Input& input, std::size_t count) {
  std::vector<float> numbers(count);
  for (float& v : numbers)
    v = number(input);
  return numbers;
}

template <class Struct>
Struct sized(Input& input) {
  Struct made{};
  made.size = input.take<std::uint8_t>() == 255 ? input.take<std::uint8_t>() % sizeof made : sizeof made;
  return made;
}

masu_scene* created_scene(Input& input) {
  const auto vertices = numbers_of(input, 3 * (input.take<std::uint8_t>() % 16U));
  std::vector<std::uint32_t> indices(3 * (input.take<std::uint8_t>() % 16U));
  const std::size_t corners = vertices.size() / 3 + (input.take<std::uint8_t>() % 8 == 0 ? 1 : 0);
  for (std::uint32_t& i : indices)
    i = corners > 0 ? static_cast<std::uint32_t>(input.take<std::uint8_t>() % corners) : 0;
  const std::array<float, 3> color{number(input), number(input), number(input)};
  auto mesh = sized<masu_mesh>(input);
  mesh.vertices = vertices.data();
  mesh.vertex_count = vertices.size() / 3;
  const auto has = input.take<std::uint8_t>();
  mesh.indices = (has & 1U) != 0 ? indices.data() : nullptr;
  mesh.triangle_count = indices.size() / 3;
  mesh.color = (has & 2U) != 0 ? color.data() : nullptr;
  const auto numbers = numbers_of(input, 8 * (input.take<std::uint8_t>() % 4U));
  auto quadrics = sized<masu_quadrics>(input);
  quadrics.values = numbers.data();
  quadrics.count = numbers.size() / 8;
  const std::array origin{input.take<double>(), input.take<double>(), input.take<double>()};
  auto geometry = sized<masu_geometry>(input);
  geometry.meshes = &mesh;
  geometry.mesh_count = 1;
  geometry.spheres = geometry.cones = &quadrics;
  geometry.sphere_count = (has & 4U) != 0 ? 1 : 0;
  geometry.cone_count = (has & 8U) != 0 ? 1 : 0;
  geometry.origin = (has & 16U) != 0 ? origin.data() : nullptr;
  set(geometry.store, input.take<std::uint8_t>() % 4);
  masu_scene* scene = nullptr;
  static_cast<void>(masu_scene_create(&geometry, &scene));
  return scene;
}

masu_grid* built_grid(Input& input, const masu_scene* scene) {
  masu_build_options options{};
  options.size = sizeof options;
  if (masu_default_build_options(&options) != MASU_OK) std::abort();
  set(options.structure, input.take<std::uint8_t>() % 4);
  set(options.merge, input.take<std::uint8_t>() % 6);
  static constexpr std::array divisions{"auto", "1", "3", "2x5x1", "cleary:1", "woo:1", "x", ""};
  options.division = divisions[input.take<std::uint8_t>() % divisions.size()];
  options.box_overlap = input.take<std::uint8_t>() % 2;
  options.cube_space = input.take<std::uint8_t>() % 2;
  options.target = input.take<std::uint8_t>();
  if (input.take<std::uint8_t>() % 4 == 0) options.alpha = number(input);
  if (input.take<std::uint8_t>() % 4 == 0) options.step_cost = number(input);
  options.threads = input.take<std::uint8_t>() % 3;
  set(options.quality, input.take<std::uint8_t>() % 3);
  masu_grid* grid = nullptr;
  static_cast<void>(masu_grid_build(scene, &options, &grid));
  return grid;
}

void query(Input& input, const masu_tracer* tracer, std::uint64_t primitives, std::uint64_t objects) {
  // Mostly a few; of eight and more eight are traced at a time.
  const auto length = input.take<std::uint8_t>();
  const std::size_t count = length < 160 ? length % 8U : length % 32U;
  auto options = sized<masu_query>(input);
  const int format = input.take<std::uint8_t>() % 5;
  set(options.format, format);
  set(options.precision, input.take<std::uint8_t>() % 5);
  options.coherent = input.take<std::uint8_t>() % 2;
  set(options.faces, input.take<std::uint8_t>() % 4);
  set(options.loop, format);
  const std::vector<std::uint32_t> excluded(count, input.take<std::uint8_t>());
  if (input.take<std::uint8_t>() % 2 != 0) options.exclude = excluded.data();
  const std::vector<std::uint32_t> object_masks(objects, input.take<std::uint8_t>()), &ray_masks = excluded;
  const auto masked = input.take<std::uint8_t>();
  if (masked % 2 != 0) {
    options.object_masks = object_masks.data();
    options.object_count = masked < 250 ? objects : masked;
  }
  if (masked % 4 > 1) options.ray_masks = ray_masks.data();
  const std::vector<float> rays = numbers_of(input, 8 * count);
  const std::vector<double> rays64(rays.begin(), rays.end());
  const bool is_float64 = format == MASU_RAYS_FLOAT64 || format == MASU_RAYS_FLOAT64_6;
  const void* const list = is_float64 ? static_cast<const void*>(rays64.data()) : rays.data();
  const std::uint32_t limit = input.take<std::uint8_t>() % 5U;
  const std::size_t room = count * std::max(limit, 1U);
  std::vector<float> t(room), uv(2 * room), normal(3 * room), shading(3 * room);
  std::vector<double> t64(room), position(3 * room);
  std::vector<std::uint32_t> primitive(room), object(room), face(room), counts(count), all(count);
  std::vector<std::uint8_t> front(room);
  const auto wanted = input.take<std::uint8_t>();
  const masu_hits hits{sizeof hits,
                       (wanted & 1U) != 0 ? t.data() : nullptr,
                       (wanted & 2U) != 0 ? primitive.data() : nullptr,
                       (wanted & 4U) != 0 ? object.data() : nullptr,
                       (wanted & 8U) != 0 ? uv.data() : nullptr,
                       (wanted & 16U) != 0 ? normal.data() : nullptr,
                       (wanted & 32U) != 0 ? face.data() : nullptr,
                       (wanted & 64U) != 0 ? t64.data() : nullptr,
                       (wanted & 128U) != 0 ? front.data() : nullptr,
                       (wanted & 8U) != 0 ? position.data() : nullptr,
                       (wanted & 16U) != 0 ? shading.data() : nullptr};
  if (masu_nearest(tracer, list, count, &options, &hits) == MASU_OK && (wanted & 3U) == 3) {
    for (std::size_t i = 0; i < count; ++i) {
      const bool hit = std::isfinite(t[i]);
      if (hit != (primitive[i] < primitives)) std::abort();
      if (count < 8 || (wanted & 192U) != 0 || options.size != sizeof options) continue;
      // Alone, a ray is none of eight, and hits the same.
      const std::size_t numbers = format == MASU_RAYS_FLOAT32_6 || format == MASU_RAYS_FLOAT64_6 ? 6 : 8,
                        ray_bytes = numbers * (is_float64 ? sizeof(double) : sizeof(float));
      float own_t = 0;
      std::uint32_t own_primitive = 0;
      masu_hits own{};
      own.size = sizeof own;
      own.t = &own_t;
      own.primitive = &own_primitive;
      const masu_status status =
          masu_nearest(tracer, static_cast<const char*>(list) + i * ray_bytes, 1, &options, &own);
      if (status != MASU_OK || own_primitive != primitive[i] || std::memcmp(&own_t, &t[i], sizeof own_t) != 0)
        std::abort();
    }
  }
  std::vector<std::uint8_t> occluded(count);
  static_cast<void>(masu_occluded(tracer, list, count, &options, occluded.data()));
  static_cast<void>(masu_inside(tracer, list, count, &options, occluded.data()));
  static_cast<void>(masu_winding(tracer, list, count, &options, 0.5, t64.data(), occluded.data()));
  if (masu_all_hits(tracer, list, count, &options, limit, &hits, counts.data()) == MASU_OK &&
      masu_count_hits(tracer, list, count, &options, all.data()) == MASU_OK) {
    for (std::size_t i = 0; i < count; ++i)
      if (counts[i] != std::min(all[i], limit)) std::abort();
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  std::array<masu_scene*, 2> scenes{};
  std::array<masu_grid*, 2> grids{};
  masu_tracer* tracer = nullptr;
  std::uint64_t primitives = 0, objects = 0; // of the tracer's scene
  for (int calls = 0; calls < 24 && !input.is_empty(); ++calls) {
    const auto call = input.take<std::uint8_t>();
    masu_scene*& scene = scenes[call / 8U % 2];
    masu_grid*& grid = grids[call / 16U % 2];
    switch (call % 8) {
    case 0:
      masu_scene_free(scene);
      scene = created_scene(input);
      break;
    case 1: {
      masu_grid* const old = std::exchange(grid, nullptr);
      if (input.take<std::uint8_t>() % 4 == 0)
        static_cast<void>(masu_grid_refit(old, scene, &grid));
      else
        grid = built_grid(input, scene);
      masu_grid_free(old);
      break;
    }
    case 2:
    case 3: {
      masu_tracer_free(tracer);
      const auto choice = input.take<std::uint8_t>();
      auto options = sized<masu_tracer_options>(input);
      options.brute_force = choice % 8 == 7 ? 1 : 0;
      const masu_status status =
          masu_tracer_create(scene, choice % 8 < 4 ? grid : nullptr, &options, &tracer);
      if (status != MASU_OK && (tracer != nullptr || std::strlen(masu_error()) == 0)) std::abort();
      masu_scene_description description{};
      description.size = sizeof description;
      if (tracer != nullptr && masu_scene_describe(scene, &description) != MASU_OK) std::abort();
      objects = description.objects;
      primitives = std::uint64_t{description.triangles} + description.spheres + description.cones;
      break;
    }
    case 4:
      masu_tracer_free(tracer);
      tracer = nullptr;
      break;
    case 5: {
      auto moved = sized<masu_vertices>(input);
      moved.count = input.take<std::uint8_t>() % 16U; // as created_scene() has them
      const std::vector<float> values = numbers_of(input, 3 * moved.count);
      moved.values = values.data();
      if (tracer != nullptr) static_cast<void>(masu_tracer_update(tracer, &moved));
      auto primitive = sized<masu_primitive>(input);
      static_cast<void>(masu_scene_primitive(scene, input.take<std::uint16_t>(), &primitive));
      auto check = sized<masu_mesh_check>(input);
      static_cast<void>(masu_scene_check(scene, &check));
      break;
    }
    default:
      if (tracer != nullptr) query(input, tracer, primitives, objects);
    }
  }
  for (masu_scene* const scene : scenes)
    masu_scene_free(scene);
  for (masu_grid* const grid : grids)
    masu_grid_free(grid);
  masu_tracer_free(tracer);
  return 0;
}
