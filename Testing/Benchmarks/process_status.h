// What the system says of this process. Header-only.
#ifndef oversketch_testing_benchmarks_process_status_h
#define oversketch_testing_benchmarks_process_status_h

#include <fstream>
#include <string>

namespace oversketch_bench
{

// A line of /proc/self/status [bytes]; 0 where there is none.
inline double status(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind(key + ":", 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(key.size() + 1));
    }
  }
  return 0.0;
}

} // namespace oversketch_bench
#endif
