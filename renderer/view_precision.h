// Which arithmetic a picture needs: `--precision auto` follows the view.
#pragma once

#include "renderer/tracer.h"

#include <string>

namespace masu {

// What was taken for a view, and why.
struct ViewPrecision {
  Precision precision = Precision::robust; // or doubled
  bool is_stored = false;                  // doubled, since the scene's store leaves no choice
  double error_bound = 0;                  // of robust across a ray (margin.h), in scene units
  double pixel = 0; // a pixel's side at the nearest surface in the picture; infinity where there is none
};

// Robust where its error bound across a ray is at most a sixteenth of a pixel at the nearest surface that a
// sample of camera rays meets, else doubled: nearer than that its errors can be seen. The sample
// (Sampling::sparse) is traced in double; where the distance of the scene's bounds decides already, none is.
// Independent of the grid and of the device, and of the part of the picture that is traced.
ViewPrecision view_precision(const Tracer& tracer, const FrameRequest& request);

// Of a picture: the requested one, or for automatic its view's.
inline Precision picture_precision(const Tracer& tracer, const FrameRequest& request) {
  const Precision wanted = request.tracing.precision;
  return wanted == Precision::automatic ? view_precision(tracer, request).precision : wanted;
}

// "robust", or "double: …" with the reason.
std::string description_of(const ViewPrecision& chosen);

} // namespace masu
