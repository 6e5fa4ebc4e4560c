#include "tools/common/cli.h"

#include "libscene/base/printable.h"
#include "libscene/base/processor.h"
#include "libscene/file/output_file.h"
#include "libscene/file/scene_file.h"
#include "libscene/file/temporary_name.h"
#include "tools/common/number_list.h"
#include "tools/common/version.h"

#include <fcntl.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>
#include <thread>

namespace masu {

void check_files(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
  std::vector<std::string> written{"/dev/stdout"}; // results and reports
  if (std::ranges::count_if(outputs, is_standard_output) > 1)
    throw Error(ErrorCode::usage, "-", "would be written twice: name a file for one of them");
  for (const std::string& output : outputs) {
    if (output.empty() || is_standard_output(output)) continue;
    for (const std::string& other : written) {
      if (is_same_file(output, other))
        throw Error(ErrorCode::usage, output, "would be written twice: give each output a name of its own");
    }
    written.push_back(output);
  }
  for (const std::string& input : inputs) {
    for (const std::string& output : written) {
      if (!input.empty() && is_same_file(input == "-" ? "/dev/stdin" : input, output))
        throw Error(ErrorCode::usage, output,
                    fmt::format("is the input {} itself: give the output another name", input));
    }
  }
}

bool is_scene_file(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return false;
  std::ifstream stream(path, std::ios::binary);
  auto magic = scene_file_kind.magic;
  return stream.read(magic.data(), static_cast<std::streamsize>(magic.size())) &&
         magic == scene_file_kind.magic;
}

void check_scene_input(const std::string& path) {
  constexpr std::string_view meshes[] = {".3ds", ".3mf", ".blend", ".dae", ".fbx", ".glb", ".gltf", ".lwo",
                                         ".obj", ".off", ".ply",   ".stl", ".x3d", ".ase", ".dxf",  ".ms3d"};
  const std::filesystem::path file(path);
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool is_mesh = std::ranges::find(meshes, ending) != std::end(meshes);
  std::error_code failed;
  if ((!is_mesh && ending != ".nff") || !std::filesystem::is_regular_file(file, failed)) return;
  if (!std::ifstream(path).is_open() || is_scene_file(path)) return;
  throw Error(ErrorCode::input, path,
              fmt::format("isn't a scene file but {}: convert it first: {} {} -o {}",
                          is_mesh ? "a mesh" : "NFF text", is_mesh ? "mesh2bin" : "nff2bin", path,
                          std::filesystem::path(file).replace_extension(".scene").string()));
}

namespace {

constexpr const char* no_memory = "memory: there isn't enough: choose a smaller scene or a coarser grid";

// Destructors of libraries (nlohmann's JSON, TBB) allocate memory, and TBB's threads start others: where
// there is none, they end the process.
void end_with_reason() {
  const char* const name = program_invocation_short_name;
  try {
    // There is none where not even memory for an exception could be had.
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
  } catch (const std::exception& error) {
    end_with_line({name, ": ", error.what()});
  } catch (...) {
    end_with_line({name, ": an unknown error"});
  }
  end_with_line({name, ": ", no_memory});
}

// A folder is what can't be read or written, not even by a name of the descriptor (/dev/stdin), which opens
// it anew.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) { // each is the lowest that is free
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    if (stream == STDERR_FILENO && open("/dev/null", O_WRONLY) >= 0) continue;
    static_cast<void>(open("/", O_PATH));
  }
}

} // namespace

void prepare_process() {
  open_closed_streams();
  std::set_terminate(end_with_reason);
}

int run_tool(const char* name, const char* description, int argc, char** argv, const ToolBody& body,
             const Printing& prints) {
  // Where no memory is left for the line, it says that.
  const auto report = [&](ErrorCode code, std::string_view line) {
    std::string text;
    try {
      text = printable(line);
    } catch (const std::bad_alloc&) {
    }
    claim_last_line();
    if (prints.error())
      static_cast<void>(std::fprintf(stderr, "%s: %s\n", name, text.empty() ? no_memory : text.c_str()));
    return static_cast<int>(code);
  };
  // A closed pipe and a file-size limit are write errors like any other.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  remove_temporary_names_on_signals();
  prepare_process();
  try {
    check_processor();
    const CommandLine command(name, description, fmt::format("{}, {}", name, program_name()));
    try {
      body(command, [&] { command.parse(argc, argv, prints.help); });
    } catch (const CommandLine::HelpGiven&) {
    }
    flush_standard_output();
    claim_last_line(); // success needs none
    return 0;
  } catch (const Error& error) {
    return report(error.code(), error.text());
  } catch (const std::bad_alloc&) {
    return report(ErrorCode::input, {});
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return report(ErrorCode::output, "standard output: can't be written");
    return report(ErrorCode::input, error.what());
  } catch (...) {
    return report(ErrorCode::input, "an unknown error");
  }
}

ThreadLimit limit_threads(std::size_t threads) {
  return std::make_shared<const tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
}
std::size_t allowed_threads() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}
std::size_t all_cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

void see_first_gpu_alone() {
  setenv("CUDA_VISIBLE_DEVICES", "0", 0);
}

Camera resized(Camera camera, const std::string& size) {
  if (size.empty()) return camera;
  std::array<std::int32_t, 2> sides{};
  if (!read_numbers(size, 'x', sides) ||
      !std::ranges::all_of(sides, [](std::int32_t side) { return side >= 1 && side <= 65536; }))
    throw Error(ErrorCode::usage, "--size", fmt::format("'{}' isn't WxH with 1 to 65536 pixels each", size));
  camera.width = sides[0];
  camera.height = sides[1];
  return camera;
}

} // namespace masu
