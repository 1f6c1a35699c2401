// Seeds of the fuzzer, and every input that it ever found a fault with, one after the other: refused or
// sound, and soon.
#include "targets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;
using oversketch_fuzz::Target;

namespace
{

struct Corpus : testing::TestWithParam<std::string>
{
};

std::vector<fs::path> filesOf(const std::string& target)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(OVERSKETCH_CORPORA) / target))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> names()
{
  std::vector<std::string> names;
  for (const Target& target : oversketch_fuzz::targets())
  {
    names.push_back(target.name);
  }
  return names;
}

} // namespace

TEST_P(Corpus, IsRefusedOrSound)
{
  const auto& all = oversketch_fuzz::targets();
  const auto target =
    std::find_if(all.begin(), all.end(), [](const Target& one) { return one.name == GetParam(); });
  const std::vector<fs::path> files = filesOf(GetParam());
  ASSERT_GT(files.size(), 0U);
  for (const fs::path& file : files)
  {
    SCOPED_TRACE(file.filename().string());
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(target->take(bytes));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz,
  Corpus,
  testing::ValuesIn(names()),
  [](const testing::TestParamInfo<std::string>& info) { return info.param; });
