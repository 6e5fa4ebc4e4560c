// The closest hit of a ray among all primitives of a scene, by brute force in the oracle's 113-bit
// arithmetic.
//
// A tracer with a bounded error may return another primitive than the closest where two are nearly equally
// close, and may hit or miss what a ray touches; so the result is the set of admissible hits, not one hit.
#pragma once

#include "libscene/scene_view.h"
#include "renderer/tracer/tracer.h"
#include "stability/oracle/oracle.h"

#include <span>
#include <vector>

namespace masu::oracle {

// A primitive that may be hit, at a t between `low` and `high`. sure: it must be hit, unless a closer one is.
struct Candidate {
  PrimitiveIndex primitive;
  bool sure;
  Wide low, high;
};

// Every primitive that may be the closest hit. may_miss: none of them is sure, so a miss is admissible.
struct ClosestHit {
  std::vector<Candidate> candidates;
  bool may_miss = true;
  bool sure = true; // all candidates are

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

  // `slack`: the bound on the tracer's error, as a displacement of surfaces.
  ClosestHit closest(const Ray<double>& ray, double slack) const;
  // The t of the ray's hit on one primitive, in 113-bit arithmetic; negative where it is unsure.
  Wide exact_t(const Ray<double>& ray, PrimitiveIndex primitive) const;
  // The first of the primitives that are equal to this one: it wins the tie.
  PrimitiveIndex first_alike(PrimitiveIndex primitive) const { return first_alike_[primitive]; }

private:
  // Primitives whose bounding spheres the ray meets, and between which t: a conservative filter in double.
  struct Near {
    PrimitiveIndex primitive;
    double enter, leave;
  };
  std::vector<Near> near(const Ray<double>& ray, double slack) const;
  Expected expect_one(const Line& line, PrimitiveIndex primitive, Wide slack) const;
  void add_bounding_sphere(const Vec3d& center, double radius);
  void add_blocks();
  std::span<const PrimitiveIndex> block_of(std::size_t block) const;

  std::vector<Triangle<double>> triangles_;
  std::vector<Sphere<double>> spheres_;
  std::vector<Cone<double>> cones_;
  struct BoundingSpheres {
    std::vector<double> x, y, z, radius;
  };
  BoundingSpheres spheres_around_, blocks_; // of primitives; of block_size of them
  std::vector<PrimitiveIndex> in_blocks_;   // one block's after another's
  std::vector<PrimitiveIndex> first_alike_;
};

} // namespace masu::oracle
