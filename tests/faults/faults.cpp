// Preloaded into a tool (LD_PRELOAD): makes one of its calls fail, as where a disk is full, a device breaks,
// or memory is short.
//
//   MASU_FAULT=write:3    the third write fails; write:3+: all from the third on
//   MASU_FAULT_COUNT=FILE the number of calls is written into the file at the end
//   MASU_FAULT=all        nothing fails
//   MASU_FAULT_LOG=FILE   a line a trapped call that succeeds: its name and its file descriptor
//
// System calls are trapped by seccomp wherever they are made, also within the C library, whose stdio doesn't
// call the functions that a preloaded library can replace; allocations are replaced functions. Calls count
// from main() on, in all threads.
#include "tests/faults/write_count.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <ucontext.h>

extern "C" long masu_system_call(long number, long a, long b, long c, long d, long e, long f);
extern "C" const char masu_system_call_end[];
// The only place whose system calls aren't trapped.
asm(R"(
.text
.globl masu_system_call
.type masu_system_call, @function
masu_system_call:
  movq %rdi, %rax
  movq %rsi, %rdi
  movq %rdx, %rsi
  movq %rcx, %rdx
  movq %r8, %r10
  movq %r9, %r8
  movq 8(%rsp), %r9
  syscall
  ret
.globl masu_system_call_end
masu_system_call_end:
)");

namespace {

struct Fault {
  std::string_view name;
  std::array<long, 3> calls; // -1: none
  int error;
};
constexpr Fault faults[] = {
    {"write", {SYS_write, SYS_pwrite64, SYS_writev}, ENOSPC},
    {"fsync", {SYS_fsync, SYS_fdatasync, -1}, EIO},
    {"rename", {SYS_renameat, SYS_renameat2, SYS_rename}, EIO},
    {"link", {SYS_linkat, -1, -1}, EIO},
    {"open", {SYS_openat, SYS_open, -1}, EMFILE},
    {"read", {SYS_read, SYS_pread64, -1}, EIO},
    {"mmap", {SYS_mmap, -1, -1}, ENOMEM},
    {"all", {SYS_write, SYS_fsync, SYS_renameat}, 0},
    {"malloc", {-1, -1, -1}, ENOMEM},
};

const Fault* fault = nullptr;
std::uint64_t failing = 0; // the call that fails, from 1; 0: none
bool all_after = false;
std::atomic<bool> counting{false};
std::atomic<std::uint64_t> calls{0};
__attribute__((tls_model("initial-exec"))) thread_local int spared = 0; // Spares alive

bool fails_now() {
  if (!counting || spared > 0) return false;
  const std::uint64_t call = ++calls;
  return failing > 0 && (call == failing || (all_after && call > failing));
}

int log_file = -1;

void write_log(long number, long descriptor) {
  const char* const name = number == SYS_fsync || number == SYS_fdatasync      ? "fsync"
                           : number == SYS_linkat                              ? "link"
                           : number == SYS_renameat || number == SYS_renameat2 ? "rename"
                                                                               : "write";
  std::array<char, 64> line{};
  const int size = std::snprintf(line.data(), line.size(), "%s %ld\n", name, descriptor);
  masu_system_call(SYS_write, log_file, reinterpret_cast<long>(line.data()), size, 0, 0, 0);
}

void on_system_call(int, siginfo_t* info, void* context) {
  auto& registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
  const long descriptor = registers[REG_RDI];
  const long result =
      fails_now() ? -fault->error
                  : masu_system_call(info->si_syscall, descriptor, registers[REG_RSI], registers[REG_RDX],
                                     registers[REG_R10], registers[REG_R8], registers[REG_R9]);
  if (log_file >= 0 && result >= 0) write_log(info->si_syscall, descriptor);
  registers[REG_RAX] = result;
}

void trap() {
  // From 2.41 on the C library maps its state of random numbers at the first request, with all signals
  // blocked: trapped there, the process would be killed.
  char number = 0;
  if (getrandom(&number, sizeof number, 0) < 0) return;
  struct sigaction action {};
  action.sa_sigaction = on_system_call;
  action.sa_flags = SA_SIGINFO | SA_NODEFER | SA_RESTART;
  sigaction(SIGSYS, &action, nullptr);
  const auto begin = reinterpret_cast<std::uintptr_t>(&masu_system_call),
             end = reinterpret_cast<std::uintptr_t>(masu_system_call_end);
  const auto high = static_cast<std::uint32_t>(begin >> 32);
  // The stub is within one 4 GiB block, or nothing is trapped.
  if (high != end >> 32) return;
  const auto load = [](std::size_t offset) {
    return sock_filter(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
  };
  constexpr std::size_t pointer = offsetof(seccomp_data, instruction_pointer);
  std::array<sock_filter, 48> filter{
      load(pointer + 4),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, high, 0, 4),
      load(pointer),
      BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, static_cast<std::uint32_t>(begin), 0, 2),
      BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, static_cast<std::uint32_t>(end), 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
      load(offsetof(seccomp_data, nr)),
  };
  std::size_t size = 7;
  const bool all = fault->name == "all";
  for (const Fault& other : faults) {
    const bool changes_files = other.error == ENOSPC || (other.error == EIO && other.name != "read");
    if (all ? !changes_files : &other != fault) continue;
    for (const long call : other.calls) {
      if (call < 0) continue;
      filter[size++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1);
      filter[size++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
    }
  }
  filter[size++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  const sock_fprog program{static_cast<unsigned short>(size), filter.data()};
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program);
}

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  if (const char* const wanted = std::getenv("MASU_FAULT")) {
    const std::string_view text = wanted, name = text.substr(0, text.find(':'));
    for (const Fault& known : faults)
      if (known.name == name) fault = &known;
    char* end = nullptr;
    if (name.size() < text.size()) failing = std::strtoull(wanted + name.size() + 1, &end, 10);
    all_after = end != nullptr && *end == '+';
    if (const char* const log = std::getenv("MASU_FAULT_LOG"))
      log_file = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
    if (fault != nullptr && fault->calls[0] >= 0) trap();
    counting = true;
  }
  return real_main(argc, argv, environment);
}

__attribute__((destructor)) void at_end() {
  counting = false;
  log_file = -1;
  masu::write_count("MASU_FAULT_COUNT", calls);
}

// Where one of their own small allocations or mappings fails, TBB waits for ever while it starts, Fontconfig
// and pixman fault, and Cairo may leave out a part of what it draws: theirs don't, here.
bool is_spared(const void* caller) {
  Dl_info info{};
  if (dladdr(caller, &info) == 0 || info.dli_fname == nullptr) return false;
  for (const char* const library : {"libtbb", "libfontconfig", "libcairo", "libpixman"})
    if (std::strstr(info.dli_fname, library) != nullptr) return true;
  return false;
}

// While it lives no call fails, if so wanted.
class Spares {
public:
  explicit Spares(bool wanted) : wanted_(wanted) { spared += wanted_ ? 1 : 0; }
  ~Spares() { spared -= wanted_ ? 1 : 0; }
  Spares(const Spares&) = delete;
  Spares& operator=(const Spares&) = delete;

private:
  bool wanted_;
};

// Fontconfig goes on without the fonts that it can't read, and prints lines of its own: its calls don't fail,
// here.
template <class Function, class... Arguments>
auto call_of_fontconfig(Function*, const char* name, Arguments... arguments) {
  const Spares spares(true);
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name))(arguments...);
}

bool is_fault_of_allocations() {
  return fault != nullptr && fault->calls[0] < 0;
}

// The memory of allocate(), or none.
template <class Allocate>
void* allocated(const void* caller, const Allocate& allocate) {
  const Spares spares(counting && is_spared(caller));
  if (is_fault_of_allocations() && fails_now()) {
    errno = ENOMEM;
    return nullptr;
  }
  return allocate();
}

} // namespace

#define MASU_PRELOADED __attribute__((visibility("default")))

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

MASU_PRELOADED void* malloc(std::size_t size) {
  return allocated(__builtin_return_address(0), [&] { return __libc_malloc(size); });
}
MASU_PRELOADED void* calloc(std::size_t count, std::size_t size) {
  return allocated(__builtin_return_address(0), [&] { return __libc_calloc(count, size); });
}
MASU_PRELOADED void* realloc(void* memory, std::size_t size) {
  return allocated(__builtin_return_address(0), [&] { return __libc_realloc(memory, size); });
}
MASU_PRELOADED void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return allocated(__builtin_return_address(0), [&] { return __libc_memalign(alignment, size); });
}
MASU_PRELOADED int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = allocated(__builtin_return_address(0), [&] { return __libc_memalign(alignment, size); });
  return *memory != nullptr ? 0 : ENOMEM;
}

// To know who calls it.
MASU_PRELOADED void* mmap(void* address, std::size_t size, int protection, int flags, int file,
                          off_t offset) {
  const Spares spares(counting && is_spared(__builtin_return_address(0)));
  return reinterpret_cast<void*>(syscall(SYS_mmap, address, size, protection, flags, file, offset));
}
MASU_PRELOADED void* mmap64(void*, std::size_t, int, int, int, off_t) __attribute__((alias("mmap")));

// As on a machine of eight cores, by which TBB counts: only from four on do its threads start others.
MASU_PRELOADED int sched_getaffinity(pid_t, std::size_t size, cpu_set_t* cores) noexcept {
  std::memset(cores, 0, size);
  *reinterpret_cast<unsigned char*>(cores) = 0xff;
  return 0;
}
MASU_PRELOADED long sysconf(int name) noexcept {
  if (name == _SC_NPROCESSORS_ONLN) return 8;
  return reinterpret_cast<decltype(&sysconf)>(dlsym(RTLD_NEXT, "sysconf"))(name);
}

// What Cairo calls of Fontconfig to find a font.
MASU_PRELOADED void* FcConfigGetCurrent() {
  return call_of_fontconfig(FcConfigGetCurrent, "FcConfigGetCurrent");
}
MASU_PRELOADED int FcInitBringUptoDate() {
  return call_of_fontconfig(FcInitBringUptoDate, "FcInitBringUptoDate");
}
MASU_PRELOADED int FcConfigSubstitute(void* config, void* pattern, int kind) {
  return call_of_fontconfig(FcConfigSubstitute, "FcConfigSubstitute", config, pattern, kind);
}
MASU_PRELOADED void FcDefaultSubstitute(void* pattern) {
  call_of_fontconfig(FcDefaultSubstitute, "FcDefaultSubstitute", pattern);
}
MASU_PRELOADED void* FcFontMatch(void* config, void* pattern, int* result) {
  return call_of_fontconfig(FcFontMatch, "FcFontMatch", config, pattern, result);
}
MASU_PRELOADED int FcPatternGetFTFace(void* pattern, const char* object, int number, void** face) {
  return call_of_fontconfig(FcPatternGetFTFace, "FcPatternGetFTFace", pattern, object, number, face);
}

MASU_PRELOADED int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                                     void (*rtld_fini)(), void* stack_end) {
  real_main = main;
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

} // extern "C"

// Of their own, to know who calls them.
MASU_PRELOADED void* operator new(std::size_t size) {
  void* const memory = allocated(__builtin_return_address(0), [&] { return __libc_malloc(size); });
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
MASU_PRELOADED void* operator new[](std::size_t size) {
  void* const memory = allocated(__builtin_return_address(0), [&] { return __libc_malloc(size); });
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
