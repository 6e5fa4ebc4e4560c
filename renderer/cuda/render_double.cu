#include "renderer/cuda/rendering.h"

namespace masu {

template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                      const StructureFile*, const FrameRequest&,
                                                      FrameBuffers&, Frame&);
template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<double>&, const SceneView<double>&,
                                                      const StructureFile*, const FrameRequest&,
                                                      FrameBuffers&, Frame&);

} // namespace masu
