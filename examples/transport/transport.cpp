// Particles through a tokamak's shells and sectors: `transport [PARTICLES [DEVICE]]`, DEVICE a GPU's number
// or -1 for the CPU. Prints the tally, which is the same on every machine, and how many particles were lost;
// where Embree is there, the same game through it, whose rays start an epsilon off what they leave.
#include "game.h"

#include <masu/masu.hpp>

#include <cstdlib>
#include <iostream>

#ifdef HAS_EMBREE
#include "embree_surfaces.h"
#endif

namespace {

using namespace transport;

// The next surface from where a particle is, but for the triangle that it is on.
class MasuSurfaces {
public:
  MasuSurfaces(const Geometry& geometry, int device) : tracer_(scene_of(geometry), device) {}

  void operator()(const std::vector<Particle>& particles, std::vector<Met>& met) {
    const std::size_t n = particles.size();
    rays_.resize(n);
    exclude_.resize(n);
    t_.resize(n);
    triangle_.resize(n);
    surface_.resize(n);
    front_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& [at, along] = std::pair(particles[i].at, particles[i].along);
      rays_[i] = {at[0], at[1], at[2], along[0], along[1], along[2]};
      exclude_[i] = particles[i].crossed;
    }
    auto hits = masu::sized<masu_hits>();
    hits.t64 = t_.data();
    hits.primitive = triangle_.data();
    hits.object = surface_.data();
    hits.front = front_.data();
    masu::QueryOptions options;
    options.precision = MASU_PRECISION_DOUBLE;
    options.exclude = exclude_.data();
    tracer_.nearest(rays_.data(), n, hits, options);
    for (std::size_t i = 0; i < n; ++i)
      met[i] = {t_[i], triangle_[i], surface_[i], front_[i] != 0};
  }

private:
  static masu::Scene scene_of(const Geometry& geometry) {
    std::vector<masu_mesh> meshes;
    for (const Geometry::Surface& surface : geometry.surfaces)
      meshes.push_back(masu::mesh(geometry.vertices, surface.indices));
    return masu::Scene(meshes);
  }

  masu::Tracer tracer_;
  std::vector<std::array<double, 6>> rays_;
  std::vector<double> t_;
  std::vector<std::uint32_t> exclude_, triangle_, surface_;
  std::vector<std::uint8_t> front_;
};

void print(const char* name, std::uint64_t count, const Tally& tally) {
  std::uint64_t collisions = 0, hash = 1469598103934665603U; // FNV-1a of the regions' tallies
  for (const std::uint64_t n : tally.collisions) {
    collisions += n;
    hash = (hash ^ n) * 1099511628211U;
  }
  std::cout << name << ": " << count << " particles, " << tally.crossings << " crossings, " << collisions
            << " collisions, " << tally.absorbed << " absorbed, " << tally.leaked << " leaked, " << tally.lost
            << " lost; tally " << std::hex << hash << std::dec << "\n";
}

} // namespace

int main(int argc, char** argv) try {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20000;
  const int device = argc > 2 ? std::atoi(argv[2]) : MASU_CPU;
  const Geometry geometry;
  const Tally tally = play(geometry, count, MasuSurfaces(geometry, device));
  print("masu", count, tally);
#ifdef HAS_EMBREE
  print("embree", count, play(geometry, count, EmbreeSurfaces(geometry)));
#endif
  return tally.lost == 0 ? 0 : 1;
} catch (const masu::Exception& error) {
  std::cerr << "transport: " << error.what() << "\n";
  return error.status;
}
