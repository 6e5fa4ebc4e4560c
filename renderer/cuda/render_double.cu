#include "renderer/cuda/rendering.h"

namespace masu {

template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<float>&, const FrameRequest&,
                                                      FrameBuffers&, Frame&);
template void render_on_device<WatertightRay<double>>(const DeviceFilesOf<double>&, const FrameRequest&,
                                                      FrameBuffers&, Frame&);

} // namespace masu
