// The thread's current device, for a while. CUDA sources only.
#pragma once

namespace masu {

// Makes a device the thread's current one, and leaves the thread as it was: with the context that it had, or
// with none, for to set the device before again would open a context on a GPU that the host program may never
// use. Throws Error(device).
class DeviceScope {
public:
  explicit DeviceScope(int device);
  ~DeviceScope();
  DeviceScope(const DeviceScope&) = delete;
  DeviceScope& operator=(const DeviceScope&) = delete;
};

// Calls act() with the device current, where it can be: for destructors. What act() doesn't give back is lost
// with the device.
template <class Act>
void on_device_if_possible(int device, const Act& act) noexcept {
  try {
    const DeviceScope scope(device);
    act();
  } catch (...) { // there is nobody to tell
  }
}

} // namespace masu
