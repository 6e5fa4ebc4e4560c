#include "renderer/cuda/rays/tracing.h"

namespace masu {

template LaunchRays launch_list<WatertightRay<float>, float>;
template LaunchRays launch_list<TextbookRay, float>;

} // namespace masu
