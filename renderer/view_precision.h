// Which arithmetic a picture needs: `--precision auto` follows the view.
#pragma once

#include "renderer/tracer/tracer.h"

#include <string>

namespace masu {

// What was taken for a view, and why.
struct ViewPrecision {
  Precision precision = Precision::robust; // or doubled
  bool is_stored = false;                  // doubled, since the scene's store leaves no choice
  double error = 0;  // of robust across a ray at the nearest surface, at most, in scene units
  double pixel = 0;  // a pixel's side there; infinity where there is no surface
  int differing = 0; // of the sample's rays: their colours aren't those of double
};

// Doubled where at the nearest surface of the picture robust's error across a ray may be more than a
// sixteenth of a pixel: nearer than that its errors can be seen. Doubled as well where more than a few rays
// of a sample see other colours by robust with an enlarged offset of secondary rays: as through sheets that
// lie closer to each other than that, and where surfaces are within the error of each other. Else robust. The
// sample (Sampling::sparse) is shaded as the request says, in double and, where the bound doesn't decide, in
// robust. Independent of the grid, of the device but for what pow() rounds differently there, and of the part
// of the picture that is traced.
ViewPrecision view_precision(const ResidentTracer& tracer, const FrameRequest& request);

// Of a picture: the requested one, or for automatic its view's.
inline Precision picture_precision(const ResidentTracer& tracer, const FrameRequest& request) {
  const Precision wanted = request.tracing.precision;
  return wanted == Precision::automatic ? view_precision(tracer, request).precision : wanted;
}

// "robust: …" or "double: …", with the reason.
std::string description_of(const ViewPrecision& chosen);

} // namespace masu
