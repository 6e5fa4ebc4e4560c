#include "tools/jobs/tracing_report.h"

namespace masu {

void sum_up(Ranks& ranks, TracingReport& report) {
  std::vector<std::uint64_t> totals;
  for_each_total(report.totals, report.totals,
                 [&](std::uint64_t total, std::uint64_t) { totals.push_back(total); });
  ranks.sum(totals);
  std::size_t i = 0;
  for_each_total(report.totals, report.totals,
                 [&](std::uint64_t& total, std::uint64_t) { total = totals[i++]; });
  std::vector<double> seconds{report.seconds.upload, report.seconds.trace, report.seconds.download,
                              report.write_seconds};
  ranks.sum(seconds);
  report.seconds = {seconds[0], seconds[1], seconds[2]};
  report.write_seconds = seconds[3];
}

} // namespace masu
