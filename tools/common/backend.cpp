#include "tools/common/backend.h"

#include <fstream>

namespace masu {

void add_backend(const CommandLine& command, Backend& backend) {
  command.add_choice("--backend", backend,
                     {{"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"cuda", Backend::cuda}},
                     "cpu, cuda, or auto: cuda where there is a usable GPU, else cpu");
}

const std::map<std::string, Precision> all_precisions{{"auto", Precision::automatic},
                                                      {"fast", Precision::fast},
                                                      {"robust", Precision::robust},
                                                      {"double", Precision::doubled}};

void add_precision(const CommandLine& command, Precision& precision) {
  command.add_choice(
      "--precision", precision, all_precisions,
      "arithmetic of intersection and traversal: fast (float32, textbook formulas, for comparison), robust "
      "(float32, watertight triangles, error-bounded), double, or auto: robust, and double where the "
      "scene is stored in float64, or of pictures where float32's errors could be seen");
}

void add_first_cell_hit(const CommandLine& command, StopRule& stop) {
  command.add_flag(
      "--first-cell-hit", [&stop] { stop = StopRule::first_cell; },
      "terminate at the first cell in which anything is hit, even if the hit lies beyond it: the rule of the "
      "2012 thesis, which misses closer hits; for comparison");
}

bool use_cuda(Backend backend, bool first_gpu_alone) {
  if (first_gpu_alone) see_first_gpu_alone();
  std::string why;
  const bool available = backend != Backend::cpu && cuda_available(why);
  if (backend == Backend::cuda && !available)
    throw Error(ErrorCode::device, "cuda", why + ": use --backend cpu");
  return available;
}

std::string why_no_gpu(Backend backend) {
  std::string why;
  if (backend != Backend::automatic || !built_with_cuda() || cuda_available(why)) return "";
  return "no usable GPU: " + why;
}

std::string device_name(bool cuda) {
  if (cuda) return cuda_device_name();
  std::ifstream file("/proc/cpuinfo");
  std::string name = "a CPU";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name") || line.find(": ") == std::string::npos) continue;
    name = line.substr(line.find(": ") + 2);
    break;
  }
  const std::size_t threads = allowed_threads();
  return fmt::format("{} ({} {})", name, threads, threads == 1 ? "thread" : "threads");
}

} // namespace masu
