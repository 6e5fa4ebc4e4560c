#include "stability/sweeps/picture_sweeps.h"

#include "libgrid/structure/chosen_structure.h"
#include "stability/sweeps/sweep.h"
#include "tests/picture_scenes.h"

namespace masu::stability {
namespace {

constexpr std::int32_t side = 64; // pixels of a picture, with four rays at each one's corners

// --- Scenes ---------------------------------------------------------------------------------------------

Scene from_afar(Chance& chance, double distance) {
  return far_away(chance, distance, side);
}

Scene close_up(Chance& chance, double distance) {
  return from_nearby(chance, {0.25, -0.125, 0}, distance, side); // off the floor's middle
}

// Things of size 1 on a floor.
Scene on_a_floor(Chance& chance, double width) {
  Scene scene = picture_scene({2, -3, 1.8}, {0, 0, 0.3}, {3, 2, 5}, side);
  add_quad(scene, {0, 0, 0}, {width / 2, 0, 0}, {0, width / 2, 0}, picture_gray);
  add_thicket(scene, chance, {0, 0, 0}, 1);
  return scene;
}

// Up to a hundredth as wide as long.
Scene needles(Chance& chance, double length) {
  return needles_on_floor(chance, length, side, [](const Vec3d& aside) { return aside * 0.005; });
}

// So many panes of glass, slightly turned, before a wall with balls on it.
Scene behind_glass(Chance& chance, double panes) {
  Scene scene = picture_scene({0.3, -6, 0.4}, {0, 0, 0}, {2, -4, 3}, side);
  add_quad(scene, {0, 1, 0}, {3, 0, 0}, {0, 0, 3}, picture_gray);
  for (int i = 0; i < 20; ++i)
    add_sphere(scene, {chance.uniform(-1.5, 1.5), 0.9, chance.uniform(-1.5, 1.5)}, 0.15,
               chance.one_in(3) ? mirror() : picture_gray);
  for (int i = 0; i < panes; ++i)
    add_quad(scene, {0, -4 + 4 * i / panes, 0}, {2, chance.uniform(-0.2, 0.2), 0},
             {0, chance.uniform(-0.2, 0.2), 2}, glass(1.5F));
  return scene;
}

// --- Pictures -------------------------------------------------------------------------------------------

// A scene stored, and its grid.
class Stored {
public:
  Stored(const Scene& scene, Store store, const std::optional<Vec3d>& origin)
      : file_(scene_in_memory(scene, store, origin)), grid_(built_in_memory(file_, fast_hierarchy())) {}

  const SceneFile& file() const { return file_; }
  Frame picture(Precision precision) const {
    FrameRequest request;
    request.tracing.precision = precision;
    request.camera = file_.camera();
    request.rules.depth = 12;
    return ResidentTracer(file_, &grid_, Device::cpu).render(request);
  }

private:
  static BuildOptions fast_hierarchy() { // pictures are the same through any grid: one that is built at once
    BuildOptions options;
    options.structure = {.kind = StructureKind::hierarchy, .quality = HierarchyQuality::fast};
    return options;
  }

  SceneFile file_;
  StructureFile grid_;
};

} // namespace

std::vector<PictureSweep> picture_sweeps() {
  return {{"far", "distance of a scene of size 3 from zero", powers_of_ten(0, 9), from_afar},
          {"contrast", "width of the floor under things of size 1", powers_of_ten(1, 9), on_a_floor},
          {"near", "distance of the camera from things as small, on a floor of size 1", powers_of_ten(-7, 0),
           close_up},
          {"needles", "length of needles on a floor of size 2", powers_of_ten(-4, -1), needles, 0.05},
          {"glass", "panes of glass that rays pass", {0, 1, 2, 4, 8}, behind_glass}};
}

void run(const PictureSweep& sweep, std::uint64_t seed,
         const std::function<void(const PictureRow&)>& report) {
  for (const double step : sweep.steps) {
    Chance chance = chance_for(seed, sweep.name, step);
    const Scene scene = sweep.make(chance, step);
    const Frame reference = Stored(scene, Store::float64, {}).picture(Precision::doubled);
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
