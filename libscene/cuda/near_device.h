// Threads on the cores near a GPU, so that memory they allocate is near it. CUDA sources only.
#pragma once

#include <sched.h>

namespace masu {

// Binds the thread to those of its cores that are on the NUMA node of the current device, and back to all of
// them at the end. Does nothing where the node isn't known, or none of the thread's cores is on it.
class NearDevice {
public:
  NearDevice();
  ~NearDevice();
  NearDevice(const NearDevice&) = delete;
  NearDevice& operator=(const NearDevice&) = delete;

private:
  cpu_set_t before_{};
  bool bound_ = false;
};

} // namespace masu
