#include "tools/jobs/gpus.h"

#include "tools/common/number_list.h"

#include <numeric>

namespace masu {
namespace {

constexpr const char* devices_option = "--devices";

// 0,2,…
std::vector<int> numbers_in(const std::string& text) {
  std::vector<int> numbers;
  for (const std::string& word : split(text)) {
    const std::optional<int> number = read_number<int>(word);
    if (!number || *number < 0)
      throw Error(ErrorCode::usage, devices_option,
                  fmt::format("'{}' isn't all, cpu or numbers of GPUs such as 0,2", text));
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<int> numbers_below(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<int> gpus_of_machine(const DeviceChoice& choice, Ranks& ranks) {
  const auto& [backend, devices] = choice;
  if (devices.empty()) {
    const bool is_alone = ranks.count() == 1;
    std::uint64_t with_gpu[] = {use_cuda(backend, is_alone) ? 1U : 0U};
    if (is_alone) return with_gpu[0] != 0 ? std::vector<int>{0} : std::vector<int>{};
    ranks.sum(with_gpu);
    return with_gpu[0] == static_cast<std::uint64_t>(ranks.count()) ? numbers_below(cuda_device_count())
                                                                    : std::vector<int>{};
  }
  const bool on_cpu = devices == "cpu";
  std::vector<int> named = on_cpu || devices == "all" ? std::vector<int>{} : numbers_in(devices);
  if (backend != Backend::automatic && on_cpu != (backend == Backend::cpu))
    throw Error(ErrorCode::usage, devices_option, "contradicts --backend: leave one of them out");
  if (on_cpu) return {};
  static_cast<void>(use_cuda(Backend::cuda, named == std::vector<int>{0}));
  const int count = cuda_device_count();
  for (const int gpu : named) {
    if (gpu >= count)
      throw Error(ErrorCode::device, devices_option,
                  fmt::format("GPU {} isn't there: the last of {} is {}", gpu, count, count - 1));
  }
  return named.empty() ? numbers_below(count) : named;
}

} // namespace

std::vector<int> gpus_of(const DeviceChoice& choice, Ranks& ranks) {
  std::vector<int> all = gpus_of_machine(choice, ranks);
  if (all.empty() || ranks.count() == 1) return all;
  const auto rank = static_cast<std::size_t>(ranks.local_rank()),
             count = static_cast<std::size_t>(ranks.local_count());
  if (rank >= all.size()) return {all[rank % all.size()]};
  std::vector<int> mine;
  for (std::size_t i = rank; i < all.size(); i += count)
    mine.push_back(all[i]);
  return mine;
}

} // namespace masu
