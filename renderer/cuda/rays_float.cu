#include "renderer/cuda/tracing.h"

namespace masu {

template KernelSize queue_batch<WatertightRay<float>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                      const StructureFile*, const RaysRequest&,
                                                      const RayBatch<float>&);
template KernelSize queue_hits<WatertightRay<float>>(const DeviceFilesOf<float>&, const StructureFile*,
                                                     const HitRules&, const RayFilters&,
                                                     const RayBatch<float>&);
template KernelSize queue_batch<TextbookRay>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                             const StructureFile*, const RaysRequest&,
                                             const RayBatch<float>&);
template void queue_attributes(const DeviceFilesOf<float>&, const RayBatch<float>&, const RayResults&);

} // namespace masu
