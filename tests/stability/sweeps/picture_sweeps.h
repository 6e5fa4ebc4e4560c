// Sweeps of pictures: each varies one parameter over the range in which pictures begin to be off, and counts
// the pixels that are, against double arithmetic on float64 coordinates.
#pragma once

#include "renderer/tracing_rules.h"
#include "stability/test_scene.h"

#include <functional>
#include <vector>

namespace masu::stability {

struct PictureSweep {
  const char* name;
  const char* parameter; // description
  std::vector<double> steps;
  Scene (*make)(Chance& chance, double step);
  // The share of pixels that may be off: of `double` by coordinates that are rounded to the store, of `auto`
  // besides by shadows and reflections, displaced by the offset of rays that leave a large surface.
  double tolerance = 0.015;
};

std::vector<PictureSweep> picture_sweeps();

// Of one way to store and trace a step's scene: as `--store auto` takes it.
struct PictureRow {
  const char* sweep;
  const char* parameter;
  double step;
  bool local_origin; // the automatic one; else none
  bool float64;      // the store
  Precision precision;
  double pixels_off; // the share of pixels of which a channel is off by more than a fiftieth
};

// Calls report for each step, store with and without the local origin (where there is one), and precision
// that the store allows. The same seed gives the same scenes.
void run(const PictureSweep& sweep, std::uint64_t seed, const std::function<void(const PictureRow&)>& report);

} // namespace masu::stability
