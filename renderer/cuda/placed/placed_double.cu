#include "renderer/cuda/placed/placed_rays.h"

namespace masu {

template KernelSize launch_placed<WatertightRay<double>>(const DeviceFilesOf<float>&, const RayList&,
                                                         const RaysRequest&, const RayBatch<double>&,
                                                         const RayResults&);
template KernelSize launch_placed<WatertightRay<double>>(const DeviceFilesOf<double>&, const RayList&,
                                                         const RaysRequest&, const RayBatch<double>&,
                                                         const RayResults&);

} // namespace masu
