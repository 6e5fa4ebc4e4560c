#include "renderer/cuda/rendering.h"

namespace masu {

template void render_on_device<WatertightRay<float>>(const DeviceFilesOf<float>&, const FrameRequest&,
                                                     FrameBuffers&, Frame&);
template void render_on_device<TextbookRay>(const DeviceFilesOf<float>&, const FrameRequest&, FrameBuffers&,
                                            Frame&);

} // namespace masu
