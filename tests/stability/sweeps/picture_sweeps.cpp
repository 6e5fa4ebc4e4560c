#include "tests/stability/sweeps/picture_sweeps.h"

#include "libgrid/build/chosen_structure.h"
#include "libscene/file/memory_file.h"
#include "renderer/tracer.h"
#include "tests/stability/sweeps/sweep.h"

#include <memory>

namespace masu::stability {
namespace {

constexpr std::int32_t side = 64; // pixels of a picture, with four rays at each one's corners

// --- Scenes ---------------------------------------------------------------------------------------------

constexpr Material matte{{0.7F, 0.6F, 0.5F}, 1, 0, 0, 0, 1}, mirror{{0, 0, 0}, 0, 1, 1, 0, 1},
    glass{{0, 0, 0}, 0, 0, 1, 1, 1.5F};

// Of these three materials.
class SceneMaker {
public:
  enum Kind : std::uint32_t { of_matte, of_mirror, of_glass };

  SceneMaker(const Vec3d& from, const Vec3d& at) {
    scene.camera = {from, at, {0, 0, 1}, 40, 0.01, side, side};
    scene.has_camera = true;
    scene.background = {0.2F, 0.3F, 0.5F};
    scene.ambient = 0.3F;
    scene.materials = {matte, mirror, glass};
  }

  void light(const Vec3d& at) { scene.lights.push_back({at, {0.7, 0.7, 0.7}}); }
  // A parallelogram about `center`.
  void quad(const Vec3d& center, const Vec3d& u, const Vec3d& v, Kind kind) {
    const Vec3d a = center - u - v, b = center + u - v, c = center + u + v, d = center - u + v;
    const std::uint64_t object = scene.objects.polygons++;
    scene.triangles.push_back({a, object, b, kind, c, no_normals});
    scene.triangles.push_back({a, object, c, kind, d, no_normals});
  }
  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c, Kind kind) {
    scene.triangles.push_back({a, scene.objects.polygons++, b, kind, c, no_normals});
  }
  void sphere(const Vec3d& center, double radius, Kind kind) {
    scene.sphere_surfaces.push_back({0, kind});
    scene.spheres.push_back({center, radius});
    ++scene.objects.spheres;
  }
  void cone(const Vec3d& base, double base_radius, const Vec3d& apex, double apex_radius, Kind kind) {
    scene.cone_surfaces.push_back({0, kind});
    scene.cones.push_back({base, base_radius, apex, apex_radius});
    ++scene.objects.cones;
  }

  Scene scene{};
};

// Balls of glass in each other, and mirrors, on a floor; of size 1 about a point.
Scene far_away(Chance& chance, double distance) {
  const Vec3d at = Vec3d{0.8, -1, 0.55} * distance;
  SceneMaker maker(at + Vec3d{1.5, -2, 1.25}, at);
  maker.light(at + Vec3d{2, -1, 3});
  maker.quad(at + Vec3d{0, 0, -0.5}, {1.5, 0, 0}, {0, 1.5, 0}, SceneMaker::of_matte);
  maker.quad(at + Vec3d{0, 1.5, 0.5}, {1.5, 0, 0}, {0, 0, 1}, SceneMaker::of_mirror);
  for (int i = 0; i < 6; ++i) {
    const Vec3d center =
        at + Vec3d{chance.uniform(-0.7, 0.7), chance.uniform(-0.7, 0.7), chance.uniform(-0.3, 0.5)};
    for (const double radius : {0.2, 0.15, 0.1})
      maker.sphere(center, radius, SceneMaker::of_glass);
  }
  return std::move(maker.scene);
}

// Needles and pebbles of some size about a point of the floor.
void thicket(Chance& chance, const Vec3d& at, double size, SceneMaker& maker) {
  const auto place = [&] { return at + Vec3d{chance.uniform(-size, size), chance.uniform(-size, size), 0}; };
  for (int i = 0; i < 60; ++i) {
    const Vec3d base = place();
    const Vec3d lean{chance.uniform(-0.2, 0.2) * size, chance.uniform(-0.2, 0.2) * size, size};
    maker.cone(base, 0.02 * size, base + lean, chance.one_in(2) ? 0 : 0.02 * size, SceneMaker::of_matte);
  }
  for (int i = 0; i < 10; ++i)
    maker.sphere(place() + Vec3d{0, 0, 0.1 * size}, 0.1 * size,
                 chance.one_in(2) ? SceneMaker::of_glass : SceneMaker::of_mirror);
}

// Things of size 1 on a floor.
Scene on_a_floor(Chance& chance, double width) {
  SceneMaker maker({2, -3, 1.8}, {0, 0, 0.3});
  maker.light({3, 2, 5});
  maker.quad({0, 0, 0}, {width / 2, 0, 0}, {0, width / 2, 0}, SceneMaker::of_matte);
  thicket(chance, {0, 0, 0}, 1, maker);
  return std::move(maker.scene);
}

// Things as small as they are near, off the middle of a floor of size 1.
Scene from_nearby(Chance& chance, double distance) {
  const Vec3d at{0.25, -0.125, 0};
  SceneMaker maker(at + Vec3d{0.5, -0.75, 0.45} * distance, at + Vec3d{0, 0, 0.075} * distance);
  maker.light(at + Vec3d{0.75, 0.5, 1.25} * distance);
  maker.quad({0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, SceneMaker::of_matte);
  thicket(chance, at, 0.25 * distance, maker);
  return std::move(maker.scene);
}

// Upright needles, up to a hundredth as wide as long, off the middle of a floor of size 2.
Scene needles(Chance& chance, double length) {
  const Vec3d at{0.25, -0.125, 0};
  SceneMaker maker(at + Vec3d{2.5, -4, 3} * length, at + Vec3d{0, 0, 0.4} * length);
  maker.light({1, 0.7, 1.5});
  maker.quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, SceneMaker::of_matte);
  for (int i = 0; i < 400; ++i) {
    const auto aside = [&](double by) {
      return Vec3d{chance.uniform(-by, by), chance.uniform(-by, by), 0} * length;
    };
    const Vec3d base = at + aside(2), half = aside(0.005);
    maker.triangle(base - half, base + half, base + aside(0.2) + Vec3d{0, 0, length}, SceneMaker::of_matte);
  }
  return std::move(maker.scene);
}

// So many panes of glass, slightly turned, before a wall with balls on it.
Scene behind_glass(Chance& chance, double panes) {
  SceneMaker maker({0.3, -6, 0.4}, {0, 0, 0});
  maker.light({2, -4, 3});
  maker.quad({0, 1, 0}, {3, 0, 0}, {0, 0, 3}, SceneMaker::of_matte);
  for (int i = 0; i < 20; ++i)
    maker.sphere({chance.uniform(-1.5, 1.5), 0.9, chance.uniform(-1.5, 1.5)}, 0.15,
                 chance.one_in(3) ? SceneMaker::of_mirror : SceneMaker::of_matte);
  for (int i = 0; i < panes; ++i)
    maker.quad({0, -4 + 4 * i / panes, 0}, {2, chance.uniform(-0.2, 0.2), 0},
               {0, chance.uniform(-0.2, 0.2), 2}, SceneMaker::of_glass);
  return std::move(maker.scene);
}

// --- Pictures -------------------------------------------------------------------------------------------

struct Picture {
  std::int32_t columns, rows;
  std::vector<Vec3f> pixels;
};

Picture picture_of(const Frame& frame) {
  Picture picture{frame.columns - 1, frame.rows - 1, {}};
  for (std::int32_t y = 0; y < picture.rows; ++y) {
    for (std::int32_t x = 0; x < picture.columns; ++x) {
      const auto at = [&](std::int32_t column, std::int32_t row) {
        return frame.radiance[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) +
                              static_cast<std::size_t>(column)];
      };
      picture.pixels.push_back((at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) * 0.25F);
    }
  }
  return picture;
}

double pixels_off(const Picture& a, const Picture& b) {
  std::size_t off = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    off += largest_magnitude(a.pixels[i] - b.pixels[i]) <= 0.02F ? 0 : 1; // NaN is off
  return static_cast<double>(off) / static_cast<double>(a.pixels.size());
}

// A scene stored, and its grid.
class Stored {
public:
  Stored(const Scene& scene, Store store, const std::optional<Vec3d>& origin) {
    const MemoryFile scene_memory, grid_memory;
    write_scene(scene, store, scene_memory.path(), origin);
    file_ = std::make_unique<SceneFile>(scene_memory.path());
    const auto write = [&]<class Real>(Real) {
      const auto [grid, provenance, considered] = build_chosen(*cpu_builder(file_->view<Real>()), file_->geometry(), {});
      write_grid(grid, provenance, grid_memory.path());
    };
    file_->is_float64() ? write(double{}) : write(float{});
    grid_ = std::make_unique<GridFile>(grid_memory.path());
  }

  const SceneFile& file() const { return *file_; }
  Picture picture(Precision precision) const {
    FrameRequest request;
    request.tracing.precision = precision;
    request.camera = file_->camera();
    request.rules.depth = 12;
    return picture_of(Tracer(*file_, grid_.get(), Device::cpu).render(request));
  }

private:
  std::unique_ptr<SceneFile> file_;
  std::unique_ptr<GridFile> grid_;
};

} // namespace

std::vector<PictureSweep> picture_sweeps() {
  return {{"far", "distance of a scene of size 3 from zero", powers_of_ten(0, 9), far_away},
          {"contrast", "width of the floor under things of size 1", powers_of_ten(1, 9), on_a_floor},
          {"near", "distance of the camera from things as small, on a floor of size 1", powers_of_ten(-7, 0),
           from_nearby},
          {"needles", "length of needles on a floor of size 2", powers_of_ten(-4, -1), needles, 0.05},
          {"glass", "panes of glass that rays pass", {0, 1, 2, 4, 8}, behind_glass}};
}

void run(const PictureSweep& sweep, std::uint64_t seed,
         const std::function<void(const PictureRow&)>& report) {
  for (const double step : sweep.steps) {
    Chance chance = chance_for(seed, sweep.name, step);
    const Scene scene = sweep.make(chance, step);
    const Picture reference = Stored(scene, Store::float64, {}).picture(Precision::doubled);
    for (const bool local_origin : {true, false}) {
      const Stored stored(scene, Store::automatic, local_origin ? std::optional<Vec3d>() : Vec3d{0, 0, 0});
      if (!local_origin && automatic_origin(scene) == Vec3d{0, 0, 0}) continue;
      const bool float64 = stored.file().is_float64();
      for (const Precision precision :
           {Precision::fast, Precision::robust, Precision::automatic, Precision::doubled}) {
        if (float64 && (precision == Precision::fast || precision == Precision::robust)) continue;
        report({sweep.name, sweep.parameter, step, local_origin, float64, precision,
                pixels_off(stored.picture(precision), reference)});
      }
    }
  }
}

} // namespace masu::stability
