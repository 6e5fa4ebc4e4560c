#include "tools/bench/gnuplot.h"

#include "libscene/base/error.h"
#include "libscene/file/output_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <list>
#include <memory>
#include <vector>

namespace masu {

bool draw_charts(const std::string& script, const std::string& folder, const std::string& data,
                 const std::vector<std::string>& names) {
  if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) return false;
  const auto path_of = [](FILE* file) { return fmt::format("/proc/{}/fd/{}", getpid(), fileno(file)); };
  const std::string path = fmt::format("{}/{}", folder, data);
  const std::unique_ptr<FILE, int (*)(FILE*)> rows(std::fopen(path.c_str(), "re"), std::fclose);
  if (rows == nullptr) throw Error(ErrorCode::output, path, "can't be read");
  std::list<OutputFile> charts;
  std::string outputs;
  for (const std::string& name : names)
    outputs += name + " " + path_of(charts.emplace_back(fmt::format("{}/{}", folder, name)).stream()) + " ";
  // In a UTF-8 locale: in others gnuplot warns of characters that they lack.
  FILE* const gnuplot = popen("LC_ALL=C.UTF-8 exec gnuplot", "we");
  if (gnuplot == nullptr) throw Error(ErrorCode::output, "gnuplot", "can't be started");
  fmt::print(gnuplot, "data = '{}'\noutputs = '{}'\n{}", path_of(rows.get()), outputs, script);
  if (pclose(gnuplot) != 0)
    throw Error(ErrorCode::output, "gnuplot",
                "fails on the data in " + folder + ": see its own message above");
  for (OutputFile& chart : charts) {
    struct stat state {};
    if (fstat(fileno(chart.stream()), &state) == 0 && state.st_size > 0) chart.commit();
  }
  return true;
}

} // namespace masu
