#include "renderer/cuda/rays/tracing.h"

namespace masu {

template LaunchRays launch_list<WatertightRay<double>, float>;
template LaunchRays launch_list<WatertightRay<double>, double>;

} // namespace masu
