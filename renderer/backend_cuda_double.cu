#include "renderer/tracing_cuda.h"

namespace masu {

template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                      const GridFile*, const FrameRequest&, Frame&);
template void trace_on_device<WatertightRay<double>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                     const GridFile*, const ResidentRays&, const RaysRequest&,
                                                     RayHits&);

template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<double>&, const SceneView<double>&,
                                                      const GridFile*, const FrameRequest&, Frame&);
template void trace_on_device<WatertightRay<double>>(const DeviceFilesOf<double>&, const SceneView<double>&,
                                                     const GridFile*, const ResidentRays&, const RaysRequest&,
                                                     RayHits&);

} // namespace masu
