// What is fuzzed: each target takes bytes from outside and refuses them, or makes something sound of them.
#ifndef oversketch_testing_fuzz_targets_h
#define oversketch_testing_fuzz_targets_h

#include <functional>
#include <string>
#include <vector>

namespace oversketch_fuzz
{

struct Target
{
  std::string name; // of its folder of seeds
  std::function<void(const std::string& bytes)>
    take; // throws std::logic_error where what comes of them is not right
};

// Also keeps VTK's messages off the terminal and its work on one thread.
const std::vector<Target>& targets();

} // namespace oversketch_fuzz
#endif
