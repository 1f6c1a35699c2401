#include "OpenCL/device.h"
#include "OpenCL/device_test_cl.h"
#include "OpenCL/program_cache.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>

#include <stdlib.h> // mkdtemp

using namespace oversketch;
namespace fs = std::filesystem;

namespace
{

constexpr char options[] = "-cl-std=CL1.2";

// A cache folder of the test's own.
class ProgramCache : public testing::Test
{
protected:
  void SetUp() override
  {
    this->ClDevice = Device::instance();
    if (!this->ClDevice)
    {
      GTEST_SKIP() << "no OpenCL device";
    }
    std::string folder = testing::TempDir() + "oversketch-cache-XXXXXX";
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    this->Folder = folder;
    const char* before = std::getenv("XDG_CACHE_HOME");
    this->Before = before ? before : "";
    this->use(this->Folder);
    this->Key = programKey(this->device(), device_test_cl, options);
  }

  void TearDown() override
  {
    if (this->Before.empty())
    {
      unsetenv("XDG_CACHE_HOME");
    }
    else
    {
      this->use(this->Before);
    }
    if (!this->Folder.empty())
    {
      fs::remove_all(this->Folder);
    }
  }

  static void use(const fs::path& folder) { setenv("XDG_CACHE_HOME", folder.c_str(), 1); }

  cl::Device device() const { return this->ClDevice->context().getInfo<CL_CONTEXT_DEVICES>().front(); }

  // Builds and runs the program; true when it came from its source.
  bool compiles() const
  {
    bool compiled = false;
    cl::Program program =
      buildProgram(this->ClDevice->context(), this->device(), device_test_cl, options, compiled);
    cl::Kernel kernel(program, "saxpy");
    const std::vector<float> x{ 1, 2, 3, 4 };
    std::vector<float> y{ 10, 20, 30, 40 };
    const cl::Buffer xs = toDevice(*this->ClDevice, x);
    const cl::Buffer ys(this->ClDevice->context(),
      CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
      y.size() * sizeof(float),
      y.data());
    const cl::Buffer sizes = onDevice<int>(*this->ClDevice, 4);
    kernel.setArg(0, 2.0f);
    kernel.setArg(1, xs);
    kernel.setArg(2, ys);
    kernel.setArg(3, sizes);
    this->ClDevice->queue().enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(4), cl::NDRange(2));
    this->ClDevice->queue().enqueueReadBuffer(ys, CL_TRUE, 0, 4 * sizeof(float), y.data());
    EXPECT_EQ(y, (std::vector<float>{ 12, 24, 36, 48 }));
    return compiled;
  }

  // Drivers have caches of their own beside ours.
  std::ptrdiff_t files() const
  {
    return std::distance(fs::directory_iterator(this->Folder / "oversketch"), fs::directory_iterator());
  }

  std::shared_ptr<Device> ClDevice;
  fs::path Folder;
  std::string Before, Key;
};

std::string contents(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

void overwrite(const fs::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

// The program of another process, started now and read later.
class Probe
{
public:
  Probe()
    : Pipe(popen(OVERSKETCH_PROGRAM_CACHE_PROBE, "r"))
  {
  }
  std::string answer()
  {
    std::array<char, 256> line{};
    const bool read = std::fgets(line.data(), int(line.size()), this->Pipe) != nullptr;
    return pclose(this->Pipe) == 0 && read ? line.data() : "failed";
  }

private:
  FILE* Pipe;
};

} // namespace

TEST_F(ProgramCache, CompilesColdAndNeverAgain)
{
  EXPECT_TRUE(this->compiles());
  EXPECT_EQ(this->files(), 1);
  EXPECT_FALSE(this->compiles());
  EXPECT_FALSE(this->compiles());
  EXPECT_EQ(this->files(), 1);
}

TEST_F(ProgramCache, LivesWhereTheEnvironmentSays)
{
  EXPECT_EQ(programFile(this->Key).parent_path(), this->Folder / "oversketch");
  const char* home = std::getenv("HOME");
  const std::string before = home ? home : "";
  setenv("HOME", "/home/of/nobody", 1);
  for (const char* cache : { "", "not/absolute" })
  {
    this->use(cache);
    EXPECT_EQ(programFile(this->Key).parent_path(), "/home/of/nobody/.cache/oversketch");
  }
  unsetenv("HOME");
  EXPECT_TRUE(programFile(this->Key).empty());
  EXPECT_TRUE(this->compiles()); // no place at all
  if (home)
  {
    setenv("HOME", before.c_str(), 1);
  }
}

TEST_F(ProgramCache, KnowsDeviceSourceAndOptions)
{
  EXPECT_NE(this->Key, programKey(this->device(), device_test_cl, "-cl-std=CL1.1"));
  EXPECT_NE(this->Key, programKey(this->device(), std::string(device_test_cl) + ' ', options));
  const std::string name = this->device().getInfo<CL_DEVICE_NAME>().c_str();
  const std::string driver = this->device().getInfo<CL_DRIVER_VERSION>().c_str();
  EXPECT_NE(this->Key.find('\n' + name + '\n'), std::string::npos);
  EXPECT_NE(this->Key.find('\n' + driver + '\n'), std::string::npos);
  EXPECT_NE(programFile(this->Key), programFile(this->Key + ' '));
}

TEST_F(ProgramCache, AnyDamagedByteIsNoticedAndRepaired)
{
  EXPECT_TRUE(this->compiles());
  const fs::path path = programFile(this->Key);
  const std::string whole = contents(path);
  const std::vector<unsigned char> binary = loadProgram(this->Key);
  EXPECT_FALSE(binary.empty());
  EXPECT_GT(whole.size(), this->Key.size() + binary.size());
  const std::size_t step = whole.size() / 97 + 1; // header, key and binary
  for (std::size_t place = 0; place < whole.size(); place += place < 64 ? 1 : step)
  {
    std::string damaged = whole;
    damaged[place] = char(damaged[place] ^ 4);
    overwrite(path, damaged);
    EXPECT_TRUE(loadProgram(this->Key).empty()) << place;
  }
  EXPECT_TRUE(this->compiles());
  EXPECT_FALSE(this->compiles());
}

TEST_F(ProgramCache, ATruncatedFileIsNoticedAndRepaired)
{
  EXPECT_TRUE(this->compiles());
  const fs::path path = programFile(this->Key);
  const std::string whole = contents(path);
  for (const std::size_t size : { std::size_t(0),
         std::size_t(1),
         std::size_t(40),
         this->Key.size() + 40,
         whole.size() / 2,
         whole.size() - 1 })
  {
    overwrite(path, whole.substr(0, size));
    EXPECT_TRUE(loadProgram(this->Key).empty()) << size;
  }
  overwrite(path, whole + 'x'); // nor is more the same
  EXPECT_TRUE(loadProgram(this->Key).empty());
  EXPECT_TRUE(this->compiles());
  EXPECT_FALSE(this->compiles());
}

TEST_F(ProgramCache, AFileOfAnotherKeyIsNotTaken)
{
  const std::string other = this->Key + "another source";
  storeProgram(other, { 1, 2, 3 });
  EXPECT_EQ(loadProgram(other), (std::vector<unsigned char>{ 1, 2, 3 }));
  fs::rename(programFile(other), programFile(this->Key));
  EXPECT_TRUE(loadProgram(this->Key).empty());
  EXPECT_TRUE(this->compiles());
  EXPECT_FALSE(this->compiles());
}

TEST_F(ProgramCache, ABinaryThatTheDriverRefusesIsReplaced)
{
  storeProgram(this->Key, std::vector<unsigned char>(1000, 7));
  EXPECT_EQ(loadProgram(this->Key).size(), 1000u);
  EXPECT_TRUE(this->compiles());
  EXPECT_FALSE(this->compiles());
}

TEST_F(ProgramCache, APlaceThatCannotBeWrittenToIsNoError)
{
  const fs::path file = this->Folder / "a file";
  overwrite(file, "in the way");
  this->use(file);
  EXPECT_TRUE(this->compiles());
  EXPECT_TRUE(this->compiles());
  EXPECT_EQ(contents(file), "in the way");
}

TEST_F(ProgramCache, ServesOtherProcesses)
{
  EXPECT_EQ(Probe().answer(), "1: 12 24 36 48\n");
  EXPECT_EQ(Probe().answer(), "0: 12 24 36 48\n");
  fs::remove_all(this->Folder / "oversketch");
  EXPECT_EQ(Probe().answer(), "1: 12 24 36 48\n");
}

// The driver's own cache goes too: processes that fill it at once once made a binary on which PoCL aborted.
TEST_F(ProgramCache, ProcessesAtOnceCompileOnceAndLeaveOneWholeFile)
{
  for (int round = 0; round < 3; ++round)
  {
    for (const auto& entry : fs::directory_iterator(this->Folder))
    {
      fs::remove_all(entry);
    }
    std::array<Probe, 4> probes;
    std::multiset<std::string> answers;
    for (Probe& probe : probes)
    {
      answers.insert(probe.answer());
    }
    EXPECT_EQ(answers.count("1: 12 24 36 48\n"), 1u) << testing::PrintToString(answers);
    EXPECT_EQ(answers.count("0: 12 24 36 48\n"), probes.size() - 1) << testing::PrintToString(answers);
    EXPECT_EQ(this->files(), 1);
    EXPECT_EQ(Probe().answer(), "0: 12 24 36 48\n");
  }
}

TEST_F(ProgramCache, TheDeviceCountsItsCompilations)
{
  const int before = this->ClDevice->compilations();
  const std::string option = "-D COUNTED";
  this->ClDevice->program("device_test", device_test_cl, option);
  EXPECT_EQ(this->ClDevice->compilations(), before + 1);
  this->ClDevice->program("device_test", device_test_cl, option); // kept by the process
  EXPECT_EQ(this->ClDevice->compilations(), before + 1);
  this->ClDevice->program("again", device_test_cl, option); // the same source and options from the cache
  EXPECT_EQ(this->ClDevice->compilations(), before + 1);
}
