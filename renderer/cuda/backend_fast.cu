#include "renderer/cuda/tracing.h"

namespace masu {

template void render_on_device<TextbookRay>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                            const GridFile*, const FrameRequest&, FrameBuffers&, Frame&);
template KernelSize queue_batch<TextbookRay>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                             const GridFile*, const RaysRequest&, const RayBatch<float>&);

} // namespace masu
