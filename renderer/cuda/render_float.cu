#include "renderer/cuda/rendering.h"

namespace masu {

template void render_on_device<WatertightRay<float>, float>(const DeviceFiles&, const FrameRequest&,
                                                            FrameBuffers&, Frame&);
template void render_on_device<TextbookRay, float>(const DeviceFiles&, const FrameRequest&, FrameBuffers&,
                                                   Frame&);

} // namespace masu
