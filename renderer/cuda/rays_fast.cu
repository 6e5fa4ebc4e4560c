#include "renderer/cuda/tracing.h"

namespace masu {

template KernelSize queue_batch<TextbookRay>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                             const GridFile*, const RaysRequest&, const RayBatch<float>&);

} // namespace masu
