#include "renderer/cuda/rays/tracing.h"

namespace masu {

template KernelSize launch_batch<WatertightRay<float>>(const DeviceFilesOf<float>&, const RaysRequest&,
                                                       const RayBatch<float>&);
template KernelSize launch_hits<WatertightRay<float>>(const DeviceFilesOf<float>&, const HitRules&,
                                                      const RayFilters&, const RayBatch<float>&);
template KernelSize launch_batch<TextbookRay>(const DeviceFilesOf<float>&, const RaysRequest&,
                                              const RayBatch<float>&);
template void launch_attributes(const DeviceFilesOf<float>&, const RayBatch<float>&, const RayResults&);

} // namespace masu
