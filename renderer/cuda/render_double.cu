#include "renderer/cuda/rendering.h"

namespace masu {

template void render_on_device<WatertightRay<double>, float>(const DeviceFiles&, const FrameRequest&,
                                                             FrameBuffers&, Frame&);
template void render_on_device<WatertightRay<double>, double>(const DeviceFiles&, const FrameRequest&,
                                                              FrameBuffers&, Frame&);

} // namespace masu
