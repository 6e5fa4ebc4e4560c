// An analogue Monte Carlo game of particles through nested closed surfaces: a torus of shells, divided into
// sectors as a tokamak is. Every surface is shared by the two regions that it parts, and known by them.
//
// The tally is whole numbers, made by operations that are rounded alike everywhere: no logarithm, no sine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace transport {

using Vector = std::array<double, 3>;
inline constexpr std::uint32_t none = UINT32_MAX;

// --- Geometry

// Region 0 is outside; the others are numbered shell by shell, from the inside, each by its sectors.
struct Geometry {
  static constexpr std::uint32_t shells = 3, sectors = 16, around = 48, along = 8 * sectors; // facets
  struct Surface {
    std::uint32_t front, back; // regions
    std::vector<std::uint32_t> indices;
  };
  std::vector<float> vertices; // on a lattice: whichever machine computed them
  std::vector<Surface> surfaces;

  static std::uint32_t region(std::uint32_t shell, std::uint32_t sector) {
    return shell == shells ? 0 : 1 + shell * sectors + sector % sectors;
  }
  static std::uint32_t region_count() { return 1 + shells * sectors; }

  Geometry() {
    constexpr double turn = 2 * 3.14159265358979323846;
    // Rings about the torus' middle line: ring 0 is that line itself.
    for (std::uint32_t ring = 0; ring <= shells; ++ring)
      for (std::uint32_t i = 0; i < along; ++i)
        for (std::uint32_t k = 0; k < around; ++k) {
          const double radius = ring == 0 ? 0 : 0.4 + 0.2 * ring, about = turn * k / around,
                       phi = turn * i / along;
          const double distance = 3 + radius * std::cos(about);
          for (const double x :
               {distance * std::cos(phi), distance * std::sin(phi), radius * std::sin(about)})
            vertices.push_back(static_cast<float>(std::round(x * 4096) / 4096));
        }
    const auto vertex = [](std::uint32_t ring, std::uint32_t i, std::uint32_t k) {
      return (ring * along + i % along) * around + k % around;
    };
    for (std::uint32_t shell = 0; shell < shells; ++shell)
      for (std::uint32_t sector = 0; sector < sectors; ++sector) {
        Surface skin{region(shell + 1, sector), region(shell, sector), {}};
        const std::uint32_t first = sector * (along / sectors), ring = shell + 1;
        for (std::uint32_t i = first; i < first + along / sectors; ++i)
          for (std::uint32_t k = 0; k < around; ++k) {
            const std::uint32_t a = vertex(ring, i, k), b = vertex(ring, i + 1, k),
                                c = vertex(ring, i + 1, k + 1), d = vertex(ring, i, k + 1);
            skin.indices.insert(skin.indices.end(), {a, b, c, a, c, d});
          }
        surfaces.push_back(skin);
        // The wall at the sector's beginning, whose front is towards the sector before.
        Surface wall{region(shell, sector + sectors - 1), region(shell, sector), {}};
        for (std::uint32_t k = 0; k < around; ++k) {
          const std::uint32_t a = vertex(shell, first, k), b = vertex(shell + 1, first, k),
                              c = vertex(shell + 1, first, k + 1), d = vertex(shell, first, k + 1);
          wall.indices.insert(wall.indices.end(), {a, b, c});
          if (shell > 0) wall.indices.insert(wall.indices.end(), {a, c, d});
        }
        surfaces.push_back(wall);
      }
  }
};

// --- Chance

// Numbers of one particle: the n-th of each depends on nothing else.
struct Chance {
  std::uint64_t particle, n = 0;

  double uniform() { // from 0 to below 1; splitmix64 (Steele, Lea & Flood 2014)
    std::uint64_t x = (particle << 24) + n++ + 1;
    x *= 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27) * 0x94d049bb133111ebU;
    return static_cast<double>((x ^ x >> 31) >> 11) * 0x1p-53;
  }
  // By comparisons alone: von Neumann, Various Techniques Used in Connection with Random Digits, 1951.
  double exponential() {
    for (double whole = 0;; whole += 1) {
      const double first = uniform();
      int run = 1;
      for (double last = first, next; (next = uniform()) < last; last = next)
        ++run;
      if (run % 2 != 0) return whole + first;
    }
  }
  Vector direction() { // Marsaglia, Choosing a Point from the Surface of a Sphere, 1972
    for (;;) {
      const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, s = x * x + y * y;
      if (!(s < 1)) continue;
      const double scale = 2 * std::sqrt(1 - s);
      return {x * scale, y * scale, 1 - 2 * s};
    }
  }
};

// --- The game

struct Particle {
  Chance chance;
  Vector at, along;
  std::uint32_t region, crossed; // the triangle that it is on, or none
  double depth;                  // mean free paths to the next collision
};

// What a particle meets first.
struct Met {
  double t;
  std::uint32_t triangle, surface; // none: nothing
  bool front;
};

struct Tally {
  std::vector<std::uint64_t> collisions = std::vector<std::uint64_t>(Geometry::region_count());
  std::uint64_t crossings = 0, absorbed = 0, leaked = 0, lost = 0;
  bool operator==(const Tally&) const = default;
};

// Plays `count` particles, some at a time. meet(particles, met): fills in what each of them meets.
template <class Meet>
Tally play(const Geometry& geometry, std::uint64_t count, Meet&& meet) {
  constexpr std::uint64_t at_a_time = 1 << 18;
  constexpr double densities[Geometry::shells] = {0.3, 2, 5}, absorption = 0.1;
  Tally tally;
  std::vector<Particle> particles;
  std::vector<Met> met;
  for (std::uint64_t born = 0; born < count || !particles.empty();) {
    // In the middle line's plane, in the innermost shell or beside it: the first thing met tells the region.
    while (born < count && particles.size() < at_a_time) {
      Particle p{{born++}, {}, {}, none, none, 0};
      p.at = {2.5 + p.chance.uniform(), p.chance.uniform() - 0.5, p.chance.uniform() - 0.5};
      p.along = p.chance.direction();
      p.depth = p.chance.exponential();
      particles.push_back(p);
    }
    met.resize(particles.size());
    meet(particles, met);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Particle p = particles[i];
      const Met& m = met[i];
      const bool hits = m.surface != none;
      const std::uint32_t here = !hits     ? 0
                                 : m.front ? geometry.surfaces[m.surface].front
                                           : geometry.surfaces[m.surface].back;
      if (p.region == none) p.region = here;
      if (p.region != here) { // it is in no region that this surface bounds
        ++tally.lost;
        continue;
      }
      const double density = here == 0 ? 0 : densities[(here - 1) / Geometry::sectors];
      const bool collides = hits && density > 0 && p.depth < density * m.t;
      if (!hits) {
        ++tally.leaked;
        continue;
      }
      const double way = collides ? p.depth / density : m.t;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p.at[axis] += way * p.along[axis];
      if (collides) {
        ++tally.collisions[here];
        if (p.chance.uniform() < absorption) {
          ++tally.absorbed;
          continue;
        }
        p.along = p.chance.direction();
        p.depth = p.chance.exponential();
        p.crossed = none;
      } else {
        ++tally.crossings;
        p.depth -= density * m.t;
        p.region = m.front ? geometry.surfaces[m.surface].back : geometry.surfaces[m.surface].front;
        p.crossed = m.triangle;
      }
      particles[kept++] = p;
    }
    particles.resize(kept);
  }
  return tally;
}

} // namespace transport
