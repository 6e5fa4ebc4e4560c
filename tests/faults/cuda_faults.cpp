// Calls of the CUDA driver fail, as where a GPU is lost or its memory is short. Linked to a test
// (cuda_faults.h), or preloaded into a tool (LD_PRELOAD):
//
//   MASU_CUDA_FAULT=3            the third call fails; 3+: all from the third on
//   MASU_CUDA_FAULT_COUNT=FILE   the number of calls is written into the file at the end
//
// CUDA's runtime is linked statically. It asks dlsym() for the driver's cuGetProcAddress, and that for every
// other function: so dlsym() is replaced, and what it finds leads through the functions below.
#include "tests/faults/cuda_faults.h"

#include "tests/faults/write_count.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <utility>

namespace masu {
namespace {

constexpr int out_of_memory = 2, launch_failed = 719, unknown_error = 999; // CUresult

// Functions whose names begin so. Left out is what gives memory back, for its errors are ignored, and what
// asks for properties.
struct Failing {
  std::string_view begin;
  int error;
};
constexpr Failing failing_functions[] = {
    {"cuMemAlloc", out_of_memory},
    {"cuMemHostAlloc", out_of_memory},
    {"cuMemHostRegister", out_of_memory},
    {"cuLaunch", launch_failed},
    {"cuMemcpy", unknown_error},
    {"cuMemset", unknown_error},
    {"cuInit", unknown_error},
    {"cuDevicePrimaryCtxRetain", unknown_error},
    {"cuDeviceGetDefaultMemPool", unknown_error},
    {"cuMemPoolSetAttribute", unknown_error},
    {"cuModuleLoad", unknown_error},
    {"cuLibraryLoad", unknown_error},
    {"cuLibraryGet", unknown_error},
    {"cuModuleGetFunction", unknown_error},
    {"cuKernelGetFunction", unknown_error},
    {"cuFuncGetAttribute", unknown_error},
    {"cuKernelGetAttribute", unknown_error},
    {"cuOccupancy", unknown_error},
    {"cuStreamCreate", unknown_error},
    {"cuStreamSynchronize", unknown_error},
    {"cuEventCreate", unknown_error},
    {"cuEventRecord", unknown_error},
    {"cuEventSynchronize", unknown_error},
    {"cuEventElapsedTime", unknown_error},
    {"cuCtxSynchronize", unknown_error},
};

constinit std::atomic<std::uint64_t> first_failing{0}, calls{0};
constinit std::atomic<bool> all_fail_after{false};

bool fails_now() {
  const std::uint64_t call = ++calls, first = first_failing;
  return first > 0 && (call == first || (all_fail_after && call > first));
}

// No function of the driver has more arguments, and all are integers and pointers: each is a word.
using Word = std::uintptr_t;
using Function = int (*)(Word, Word, Word, Word, Word, Word, Word, Word, Word, Word, Word, Word);

// The driver's functions that are replaced.
struct Replaced {
  Function function;
  int error;
};
constexpr std::size_t most_replaced = 512;
constinit std::array<Replaced, most_replaced> replaced{};
constinit std::size_t replaced_count = 0;
constinit std::mutex replaced_mutex;

// Stands for replaced[i].
template <std::size_t i>
int call_or_fail(Word a, Word b, Word c, Word d, Word e, Word f, Word g, Word h, Word j, Word k, Word l,
                 Word m) {
  return fails_now() ? replaced[i].error : replaced[i].function(a, b, c, d, e, f, g, h, j, k, l, m);
}
constexpr auto replacements = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array<Function, most_replaced>{call_or_fail<i>...};
}
(std::make_index_sequence<most_replaced>());

using GetProcAddress = int (*)(const char*, void**, int, std::uint64_t, void*);
constinit std::array<std::atomic<GetProcAddress>, 2> found_get_proc_address{};

void* replacement(std::string_view name, void* found);

// Stands for cuGetProcAddress, which has no fifth argument, and cuGetProcAddress_v2.
template <std::size_t version>
int get_proc_address(const char* name, void** found, int cuda_version, std::uint64_t flags, void* status) {
  const int result = found_get_proc_address[version].load()(name, found, cuda_version, flags, status);
  constexpr int second_since = 12000;
  const std::string_view wanted = name;
  const bool is_second = wanted == "cuGetProcAddress" && cuda_version >= second_since;
  if (result == 0 && found != nullptr && *found != nullptr)
    *found = replacement(is_second ? "cuGetProcAddress_v2" : wanted, *found);
  return result;
}

// What is called instead of a function that was found by its name.
void* replacement(std::string_view name, void* found) {
  if (name == "cuGetProcAddress_v2" || name == "cuGetProcAddress") {
    const bool is_second = name.ends_with("_v2");
    found_get_proc_address[is_second ? 1 : 0] = reinterpret_cast<GetProcAddress>(found);
    return reinterpret_cast<void*>(is_second ? get_proc_address<1> : get_proc_address<0>);
  }
  const auto* const failing = std::ranges::find_if(
      failing_functions, [&](const Failing& function) { return name.starts_with(function.begin); });
  if (failing == std::end(failing_functions)) return found;
  const std::lock_guard lock(replaced_mutex);
  const auto function = reinterpret_cast<Function>(found);
  const auto known = static_cast<std::size_t>(
      std::ranges::find(replaced.data(), replaced.data() + replaced_count, function, &Replaced::function) -
      replaced.data());
  if (known == most_replaced) std::abort(); // there are more functions than places for them
  if (known == replaced_count) replaced[replaced_count++] = {function, failing->error};
  return reinterpret_cast<void*>(replacements[known]);
}

__attribute__((constructor)) void read_fault() {
  const char* const wanted = std::getenv("MASU_CUDA_FAULT");
  if (wanted == nullptr) return;
  char* end = nullptr;
  const std::uint64_t n = std::strtoull(wanted, &end, 10);
  fail_cuda_call(n, *end == '+');
}

__attribute__((destructor)) void at_end() {
  write_count("MASU_CUDA_FAULT_COUNT", calls);
}

} // namespace

void fail_cuda_call(std::uint64_t n, bool all_after) {
  first_failing = 0;
  calls = 0;
  all_fail_after = all_after;
  first_failing = n;
}

std::uint64_t cuda_calls() {
  return calls;
}

} // namespace masu

// A caller that asks for RTLD_NEXT gets what follows here: nobody does who is tested.
extern "C" __attribute__((visibility("default"))) void* dlsym(void* library, const char* name) noexcept {
  using Dlsym = void* (*)(void*, const char*);
  static const auto original = reinterpret_cast<Dlsym>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34"));
  void* const found = original(library, name);
  return found != nullptr ? masu::replacement(name, found) : nullptr;
}
