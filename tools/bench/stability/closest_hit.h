// The closest hit of a ray among all primitives of a scene, by brute force with the oracle's 113 bits.
//
// Arithmetic that is allowed an error may pick another primitive than the closest where two are nearly as
// near, and may see or miss what a ray touches; so the answer is what may be found, not one hit.
#pragma once

#include "libscene/scene_view.h"
#include "renderer/tracer.h"
#include "tools/bench/stability/oracle.h"

#include <span>
#include <vector>

namespace masu::oracle {

// A primitive that may be found, and at which t: sure to be met between these, or perhaps met.
struct Candidate {
  PrimitiveIndex primitive;
  bool sure;
  Wide low, high;
};

// Every primitive that may be the closest. Nothing may be found where none of them is sure.
struct ClosestHit {
  std::vector<Candidate> candidates;
  bool may_miss = true;
  bool sure = true; // no candidate is in doubt

  const Candidate* find(PrimitiveIndex primitive) const {
    for (const Candidate& candidate : candidates)
      if (candidate.primitive == primitive) return &candidate;
    return nullptr;
  }
};

// A scene's primitives, as they are stored.
class SceneOracle {
public:
  template <class Stored>
  explicit SceneOracle(const SceneView<Stored>& scene);

  // `slack`: how far from where they should be the tracer may see surfaces.
  ClosestHit closest(const ListedRay& ray, double slack) const;
  // The t of the ray's hit on one primitive, as exactly as can be; negative where that is in doubt.
  Wide exact_t(const ListedRay& ray, PrimitiveIndex primitive) const;
  // The first primitive that is the same as this one, which wins the tie.
  PrimitiveIndex first_alike(PrimitiveIndex primitive) const { return first_alike_[primitive]; }

private:
  // Primitives whose bounding spheres the ray comes near, and between which t it does: a filter in double,
  // rounded generously outwards.
  struct Near {
    PrimitiveIndex primitive;
    double enter, leave;
  };
  std::vector<Near> near(const ListedRay& ray, double slack) const;
  Expected expect_one(const Line& line, PrimitiveIndex primitive, Wide slack) const;
  void add_bounding_sphere(const Vec3d& center, double radius);

  std::vector<Triangle<double>> triangles_;
  std::vector<Sphere<double>> spheres_;
  std::vector<Cone<double>> cones_;
  std::vector<double> x_, y_, z_, radius_; // of the bounding spheres
  std::vector<PrimitiveIndex> first_alike_;
};

} // namespace masu::oracle
