#include "renderer/cuda/rays/tracing.h"

namespace masu {

template KernelSize launch_batch<WatertightRay<double>>(const DeviceFilesOf<float>&, const RaysRequest&,
                                                        const RayBatch<double>&);
template KernelSize launch_hits<WatertightRay<double>>(const DeviceFilesOf<float>&, const HitRules&,
                                                       const RayFilters&, const RayBatch<double>&);
template void launch_attributes(const DeviceFilesOf<float>&, const RayBatch<double>&, const RayResults&);
template KernelSize launch_batch<WatertightRay<double>>(const DeviceFilesOf<double>&, const RaysRequest&,
                                                        const RayBatch<double>&);
template KernelSize launch_hits<WatertightRay<double>>(const DeviceFilesOf<double>&, const HitRules&,
                                                       const RayFilters&, const RayBatch<double>&);
template void launch_attributes(const DeviceFilesOf<double>&, const RayBatch<double>&, const RayResults&);

} // namespace masu
