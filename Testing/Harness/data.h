// Where the shared test data lie: models that are not shipped. Header-only; OVERSKETCH_SOURCE_FOLDER is the
// source tree.
#ifndef oversketch_testing_harness_data_h
#define oversketch_testing_harness_data_h

#include <cstdlib>
#include <filesystem>
#include <string>

namespace oversketch_test
{

// The path of a file of the shared data, e.g. "meshes/bunny_5k.obj", or an empty string where it is absent.
// Looked for in the environment variable OVERSKETCH_DATA, else in ../shared/data beside the source tree.
inline std::string sharedData(const std::string& name)
{
  const char* folder = std::getenv("OVERSKETCH_DATA");
  const std::filesystem::path beside =
    std::filesystem::path(OVERSKETCH_SOURCE_FOLDER).parent_path() / "shared" / "data";
  const std::filesystem::path path = (folder ? std::filesystem::path(folder) : beside) / name;
  return std::filesystem::exists(path) ? path.string() : std::string();
}

} // namespace oversketch_test
#endif
