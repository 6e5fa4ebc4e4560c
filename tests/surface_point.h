// Random points of primitives' surfaces: anywhere, and often on edges, corners, poles and rims.
#pragma once

#include "stability/test_scene.h"

namespace masu {

struct SurfacePointSample {
  Vec3d at, outwards; // a direction
};

inline SurfacePointSample on_surface(Chance& chance, const Triangle<double>& t) {
  double v = chance.uniform(0, 1), w = chance.uniform(0, 1);
  if (v + w > 1) v = 1 - v, w = 1 - w;
  if (chance.one_in(4)) v = 0;
  if (chance.one_in(4)) w = chance.one_in(2) ? 0 : 1 - v;
  return {t.a + (t.b - t.a) * v + (t.c - t.a) * w, chance.direction()};
}
inline SurfacePointSample on_surface(Chance& chance, const Sphere<double>& s) {
  Vec3d out = chance.direction();
  if (chance.one_in(4)) { // a pole
    out = {0, 0, 0};
    out.set(chance.whole(0, 2), chance.sign());
  }
  return {s.center + out * std::abs(s.radius), out};
}
inline SurfacePointSample on_surface(Chance& chance, const Cone<double>& c) {
  double z = chance.one_of({0.0, 1.0, chance.uniform(0, 1), chance.uniform(0, 1)});
  if (chance.one_in(4)) z = std::abs(c.base_radius) < std::abs(c.apex_radius) ? 0 : 1;
  const Vec3d axis = c.apex - c.base, out = across(chance, axis);
  const double radius = std::abs(c.base_radius) * (1 - z) + std::abs(c.apex_radius) * z;
  return {c.base + axis * z + out * radius, out};
}

} // namespace masu
