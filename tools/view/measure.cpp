#include "tools/view/measure.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "tools/common/repeated.h"
#include "tools/view/answers.h"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

namespace masu {
namespace {

using Json = nlohmann::ordered_json;

// "trace;dur=1.5, rows;dur=0.1" by name.
std::map<std::string, double> timing(const std::string& header) {
  std::map<std::string, double> values;
  std::istringstream entries(header);
  for (std::string entry; std::getline(entries, entry, ',');) {
    const std::size_t first = entry.find_first_not_of(' '), middle = entry.find(";dur=");
    if (middle != std::string::npos)
      values[entry.substr(first, middle - first)] = std::stod(entry.substr(middle + 5));
  }
  return values;
}

std::string query(std::size_t grid, const Camera& camera, const char* quality) {
  const auto text = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
  return fmt::format(
      "/api/"
      "picture?grid={}&from={}&at={}&up={}&angle={}&width={}&height={}&depth=5&channel=shaded&quality={}",
      grid, text(camera.from), text(camera.at), text(camera.up), camera.angle, camera.width, camera.height,
      quality);
}

struct Sample {
  std::map<std::string, double> stages; // ms
  double bytes = 0;
};

// So many pictures, by so many clients at once; each takes the next view.
std::vector<Sample> fetch(int port, const std::vector<std::string>& queries, std::size_t pictures,
                          int clients) {
  std::vector<Sample> samples(pictures);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  std::vector<std::thread> threads;
  const auto work = [&] {
    httplib::Client client("127.0.0.1", port);
    client.set_keep_alive(true);
    client.set_tcp_nodelay(true);
    client.set_read_timeout(600);
    for (std::size_t i = 0; (i = next++) < pictures;) {
      const Stopwatch watch;
      const auto reply = client.Get(queries[i % queries.size()]);
      const double total = watch.seconds() * 1e3;
      if (!reply || reply->status != 200)
        throw Error(ErrorCode::device, "measurement", reply ? reply->body : "no reply over loopback");
      samples[i].stages = timing(reply->get_header_value("Server-Timing"));
      double rest = total;
      for (const auto& [name, milliseconds] : samples[i].stages)
        rest -= milliseconds;
      samples[i].stages["http"] = rest;
      samples[i].stages["total"] = total;
      samples[i].bytes = static_cast<double>(reply->body.size());
    }
  };
  threads.reserve(static_cast<std::size_t>(clients));
  for (int i = 0; i < clients; ++i) {
    threads.emplace_back([&] {
      try {
        work();
      } catch (...) {
        const std::lock_guard lock(mutex);
        failure = std::current_exception();
      }
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  if (failure) std::rethrow_exception(failure);
  return samples;
}

} // namespace

Json measure(const Viewer& viewer, const MeasureSettings& settings) {
  HttpServer server({}, [&viewer](const HttpRequest& request) { return answer(viewer, request); });
  std::thread serving([&] { server.serve(); });
  Camera camera = viewer.scene().camera();
  camera.width = settings.width;
  camera.height = settings.height;
  Json rows = Json::array();
  try {
    for (std::size_t grid = 0; grid < viewer.grids(); ++grid) {
      for (const char* const quality : {"moving", "still"}) {
        std::vector<std::string> queries;
        for (const View& view : turntable(camera, 60))
          queries.push_back(query(grid, view.camera, quality));
        for (const int clients : {1, 2}) {
          fetch(server.port(), queries, static_cast<std::size_t>(settings.warm_up), clients);
          const Stopwatch watch;
          const auto samples =
              fetch(server.port(), queries, static_cast<std::size_t>(settings.repeat), clients);
          const double seconds = watch.seconds();
          const auto median_of = [&](const auto& get) {
            std::vector<double> values(samples.size());
            std::ranges::transform(samples, values.begin(), get);
            return median(std::move(values));
          };
          Json stages;
          for (const char* const stage : {"wait", "trace", "copy", "rows", "encode", "http", "total"})
            stages[stage] = median_of([&](const Sample& sample) { return sample.stages.at(stage); });
          rows.push_back({{"scene", viewer.scene().path()},
                          {"grid", viewer.grid(grid).file.path()},
                          {"size", {settings.width, settings.height}},
                          {"quality", quality},
                          {"in_flight", clients},
                          {"pictures", settings.repeat},
                          {"pictures_per_second", settings.repeat / seconds},
                          {"median_ms", stages},
                          {"median_bytes", median_of([](const Sample& sample) { return sample.bytes; })}});
        }
      }
    }
  } catch (...) {
    server.stop();
    serving.join();
    throw;
  }
  server.stop();
  serving.join();
  return rows;
}

} // namespace masu
