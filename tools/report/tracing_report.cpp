#include "tools/report/tracing_report.h"

namespace masu {

void sum_up(Ranks& ranks, TracingReport& report) {
  std::vector<std::uint64_t> counts{report.totals.rays, report.totals.invalid};
  for_each_count(report.totals.counts, report.totals.counts,
                 [&](std::uint64_t count, std::uint64_t) { counts.push_back(count); });
  ranks.sum(counts);
  report.totals.rays = counts[0];
  report.totals.invalid = counts[1];
  std::size_t i = 2;
  for_each_count(report.totals.counts, report.totals.counts,
                 [&](std::uint64_t& count, std::uint64_t) { count = counts[i++]; });
  std::vector<double> seconds{report.seconds.upload, report.seconds.trace, report.seconds.download,
                              report.write_seconds};
  ranks.sum(seconds);
  report.seconds = {seconds[0], seconds[1], seconds[2]};
  report.write_seconds = seconds[3];
}

} // namespace masu
