#include "stability/sweeps/sweep.h"

#include <cmath>
#include <ostream>

namespace masu::stability {

void PrintTo(const Sweep& sweep, std::ostream* out) {
  *out << sweep.name;
}

std::vector<Sweep> all_sweeps() {
  std::vector<Sweep> all = place_sweeps();
  for (const auto& more : {shape_sweeps(), grid_sweeps(), body_sweeps(), store_sweeps()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

Sweep triangles_alone(Sweep sweep, decltype(Sweep::float32) triangles) {
  sweep.name += "-triangles";
  sweep.parameter += ", triangles alone";
  sweep.float32 = triangles;
  sweep.float64_steps.clear();
  sweep.float64 = nullptr;
  return sweep;
}

Chance chance_for(std::uint64_t seed, std::string_view sweep, double parameter) {
  // FNV-1a.
  std::uint64_t hash = 0xcbf29ce484222325U ^ seed;
  const auto add = [&](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3U; };
  for (const char c : std::string(sweep) + std::to_string(std::bit_cast<std::uint64_t>(parameter)))
    add(static_cast<unsigned char>(c));
  return Chance(RandomSeed(hash));
}

template <class Stored>
Ray<double> ray_along(const Vec3d& from, const Vec3d& direction) {
  const bool is_zero = !(largest_magnitude(direction) > 0);
  return unbounded_ray(kept<Stored>(from),
                       is_zero ? Vec3d{0, 0, 1} : kept<Stored>(scaled_to_one(direction) * 2.0));
}
template Ray<double> ray_along<float>(const Vec3d&, const Vec3d&);
template Ray<double> ray_along<double>(const Vec3d&, const Vec3d&);

template <class Stored>
Ray<double> ray_towards(const Vec3d& from, const Vec3d& to) {
  return ray_along<Stored>(from, to - kept<Stored>(from));
}
template Ray<double> ray_towards<float>(const Vec3d&, const Vec3d&);
template Ray<double> ray_towards<double>(const Vec3d&, const Vec3d&);

std::vector<double> powers_of_ten(int from, int to, int by) {
  std::vector<double> powers;
  for (int exponent = from; exponent <= to; exponent += by)
    powers.push_back(std::pow(10.0, exponent));
  return powers;
}
std::vector<double> zero_and_powers_of_ten(int from, int to, int by) {
  std::vector<double> steps = powers_of_ten(from, to, by);
  steps.insert(steps.begin(), 0);
  return steps;
}

template <class Stored>
TestScene<Stored> random_scene(Chance& chance, const Vec3d& at, double size, Kinds kinds) {
  TestScene<Stored> scene;
  const auto place = [&](double half) { return at + chance.in_cube(half * size); };
  for (int i = 0; i < (kinds == Kinds::all ? 12 : 40); ++i) {
    const Vec3d around = place(0.6);
    const auto corner = [&] { return around + chance.in_cube(0.4 * size); };
    scene.add(triangle_of<Stored>(corner(), corner(), corner()));
  }
  if (kinds == Kinds::triangles) return scene;
  for (int i = 0; i < 8; ++i) {
    const double radius = size * chance.uniform(0.05, 0.4);
    scene.add(sphere_of<Stored>(place(0.6), chance.one_in(8) ? -radius : radius));
  }
  for (int i = 0; i < 6; ++i) {
    const Vec3d base = place(0.6);
    const double inside = chance.one_in(8) ? -1 : 1;
    add_cone(scene, cone_of<Stored>(base, inside * size * chance.uniform(0.05, 0.25),
                                    base + chance.in_cube(0.4 * size),
                                    inside * size * chance.one_of({0.0, 0.1, chance.uniform(0.02, 0.25)})));
  }
  return scene;
}
template TestScene<float> random_scene(Chance&, const Vec3d&, double, Kinds);
template TestScene<double> random_scene(Chance&, const Vec3d&, double, Kinds);

template <class Stored>
std::vector<Ray<double>> rays_around(Chance& chance, const Vec3d& at, double size, std::size_t count) {
  std::vector<Ray<double>> rays;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d from = chance.one_in(3) ? at + chance.in_cube(size)
                                        : at + chance.direction() * (size * chance.uniform(2, 5));
    rays.push_back(ray_towards<Stored>(from, at + chance.in_cube(0.8 * size)));
  }
  return rays;
}
template std::vector<Ray<double>> rays_around<float>(Chance&, const Vec3d&, double, std::size_t);
template std::vector<Ray<double>> rays_around<double>(Chance&, const Vec3d&, double, std::size_t);

} // namespace masu::stability
