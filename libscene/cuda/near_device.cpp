#include "libscene/cuda/near_device.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <string>

namespace masu {
namespace {

// Of the current device; -1: not known.
int numa_node() {
  int device = 0, node = -1;
  char bus[32] = {};
  if (cudaGetDevice(&device) != cudaSuccess || cudaDeviceGetPCIBusId(bus, sizeof bus, device) != cudaSuccess)
    return -1;
  std::string id = bus;
  std::ranges::transform(id, id.begin(), [](unsigned char c) { return std::tolower(c); });
  std::ifstream("/sys/bus/pci/devices/" + id + "/numa_node") >> node;
  return node;
}

// The cores of a node, of a list such as 0-15,32-47. Empty where it can't be read.
cpu_set_t cores_of(int node) {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  std::ifstream list("/sys/devices/system/node/node" + std::to_string(node) + "/cpulist");
  for (int first = 0; list >> first;) {
    int last = first;
    if (list.peek() == '-') list.ignore() >> last;
    for (int core = first; core <= last && core < CPU_SETSIZE; ++core)
      CPU_SET(static_cast<std::size_t>(core), &cores);
    list.ignore(); // the comma
  }
  return cores;
}

} // namespace

NearDevice::NearDevice() {
  const int node = numa_node();
  if (node < 0 || sched_getaffinity(0, sizeof before_, &before_) != 0) return;
  const cpu_set_t near = cores_of(node);
  cpu_set_t both;
  CPU_AND(&both, &before_, &near);
  bound_ = CPU_COUNT(&both) > 0 && sched_setaffinity(0, sizeof both, &both) == 0;
}

NearDevice::~NearDevice() {
  if (bound_) static_cast<void>(sched_setaffinity(0, sizeof before_, &before_));
}

} // namespace masu
