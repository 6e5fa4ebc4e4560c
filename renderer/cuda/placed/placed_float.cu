#include "renderer/cuda/placed/placed_rays.h"

namespace masu {

template KernelSize launch_placed<WatertightRay<float>>(const DeviceFilesOf<float>&, const RayList&,
                                                        const RaysRequest&, const RayBatch<float>&,
                                                        const RayResults&);

} // namespace masu
