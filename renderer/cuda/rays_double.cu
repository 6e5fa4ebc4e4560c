#include "renderer/cuda/tracing.h"

namespace masu {

template KernelSize queue_batch<WatertightRay<double>>(const DeviceFilesOf<float>&, const SceneView<float>&,
                                                       const GridFile*, const RaysRequest&,
                                                       const RayBatch<double>&);
template KernelSize queue_hits<WatertightRay<double>>(const DeviceFilesOf<float>&, const GridFile*,
                                                      const HitRules&, const RayFilters&,
                                                      const RayBatch<double>&);
template void queue_attributes(const DeviceFilesOf<float>&, const RayBatch<double>&, const RayResults&);
template KernelSize queue_batch<WatertightRay<double>>(const DeviceFilesOf<double>&, const SceneView<double>&,
                                                       const GridFile*, const RaysRequest&,
                                                       const RayBatch<double>&);
template KernelSize queue_hits<WatertightRay<double>>(const DeviceFilesOf<double>&, const GridFile*,
                                                      const HitRules&, const RayFilters&,
                                                      const RayBatch<double>&);
template void queue_attributes(const DeviceFilesOf<double>&, const RayBatch<double>&, const RayResults&);

} // namespace masu
