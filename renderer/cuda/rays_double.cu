#include "renderer/cuda/tracing.h"

namespace masu {

template KernelSize queue_batch<WatertightRay<double>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                       const StructureFile*, const RaysRequest&,
                                                       const RayBatch<double>&);
template KernelSize queue_hits<WatertightRay<double>>(const DeviceFilesOf<float>&, const StructureFile*,
                                                      const HitRules&, const RayFilters&,
                                                      const RayBatch<double>&);
template void queue_attributes(const DeviceFilesOf<float>&, const RayBatch<double>&, const RayResults&);
template KernelSize queue_batch<WatertightRay<double>>(const DeviceFilesOf<double>&, const SceneView<double>&,
                                                       const StructureFile*, const RaysRequest&,
                                                       const RayBatch<double>&);
template KernelSize queue_hits<WatertightRay<double>>(const DeviceFilesOf<double>&, const StructureFile*,
                                                      const HitRules&, const RayFilters&,
                                                      const RayBatch<double>&);
template void queue_attributes(const DeviceFilesOf<double>&, const RayBatch<double>&, const RayResults&);

} // namespace masu
