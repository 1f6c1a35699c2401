// Autosaves survive what kills the program, and only that.
#include "sessions.h"

#include "autosave.h"
#include "files.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;
using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

struct Root
{
  Root()
    : path((fs::temp_directory_path() /
            (std::string("oversketch_autosave_") +
              testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(::getpid())))
             .string())
  {
    fs::remove_all(this->path);
  }
  ~Root() { fs::remove_all(this->path); }

  std::string path;
};

SessionFile fileWith(std::size_t strokes)
{
  SessionFile file;
  file.session = dogSession();
  const Node node = file.session.nodes[0];
  file.session.nodes.assign(strokes, node);
  return file;
}

} // namespace

TEST(Autosave, IsFoundAfterItsProgramOnly)
{
  const Root root;
  oversketch_files::catchMessages();
  EXPECT_TRUE(leftBehind(root.path).empty()) << "a root that is not there";
  {
    Autosave autosave(root.path);
    autosave.keep(fileWith(1));
    autosave.keep(fileWith(3));
    EXPECT_EQ(autosave.wait(), "");
    EXPECT_TRUE(leftBehind(root.path).empty()) << "it is in use";
  }
  const auto left = leftBehind(root.path);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].meshName, "dog.ply");
  EXPECT_EQ(left[0].strokes, 3u);
  const SessionFile read = readSession(left[0].folder);
  EXPECT_EQ(digestOf(read.session.mesh), digestOf(dogSession().mesh));
  removeLeftBehind(left[0]);
  EXPECT_TRUE(leftBehind(root.path).empty());
  EXPECT_TRUE(fs::is_empty(root.path));
}

TEST(Autosave, NamesTheFileThatItIsOf)
{
  const Root root;
  {
    Autosave saved(root.path), changed(root.path);
    saved.keep(fileWith(2), { "/home/a/saved.oversketch", true });
    saved.keep(fileWith(2), { "/home/a/saved.oversketch", false });
    EXPECT_EQ(saved.wait(), "");
    changed.keep(fileWith(2), { "/home/a/my dog.oversketch", false });
    changed.keep(fileWith(2), { "/home/a/my dog.oversketch", true });
    EXPECT_EQ(changed.wait(), "");
  }
  const auto left = leftBehind(root.path);
  ASSERT_EQ(left.size(), 1u) << "what is saved is lost by no crash";
  EXPECT_EQ(left[0].path, "/home/a/my dog.oversketch");
  EXPECT_LT(std::abs(std::difftime(left[0].time, std::time(nullptr))), 600.0);
  removeLeftBehind(left[0]);
  EXPECT_TRUE(fs::is_empty(root.path));
}

TEST(Autosave, ACleanEndLeavesNothing)
{
  const Root root;
  {
    Autosave autosave(root.path);
    autosave.keep(fileWith(1));
    EXPECT_EQ(autosave.wait(), "");
    autosave.discard();
  }
  EXPECT_TRUE(fs::is_empty(root.path));
}

// kill -9 while it writes one session after the other: what is found is a whole session, if a first one was
// whole.
TEST(Autosave, SurvivesBeingKilledAtAnyMoment)
{
  const Root root;
  oversketch_files::catchMessages();
  const SessionFile files[] = { fileWith(1), fileWith(2), fileWith(3) };
  for (int i = 0; i < 30; ++i)
  {
    const bool first = i >= 10; // wait until the first session is on the disk
    int ready[2];
    ASSERT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child == 0)
    {
      Autosave autosave(root.path);
      for (int round = 0;; ++round)
      {
        for (const SessionFile& file : files)
        {
          autosave.keep(file);
          autosave.wait();
        }
        if (round == 0 && ::write(ready[1], "!", 1) != 1)
        {
          ::_exit(1);
        }
      }
    }
    char sign = 0;
    if (first)
    {
      ASSERT_EQ(::read(ready[0], &sign, 1), 1);
    }
    ::usleep(static_cast<useconds_t>(700 * i));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    const auto left = leftBehind(root.path);
    EXPECT_TRUE(left.size() == 1 || (left.empty() && !first)) << "round " << i;
    for (const LeftBehind& one : left)
    {
      EXPECT_GE(one.strokes, 1u);
      EXPECT_LE(one.strokes, 3u);
      EXPECT_EQ(digestOf(readSession(one.folder).session.mesh), digestOf(files[0].session.mesh));
      removeLeftBehind(one);
    }
    EXPECT_TRUE(!fs::exists(root.path) || fs::is_empty(root.path)) << "round " << i;
  }
}

TEST(Autosave, SaysWhyItCannot)
{
  const Root root;
  fs::create_directories(root.path);
  const std::string file = root.path + "/file";
  std::ofstream(file) << "x";
  try
  {
    Autosave autosave(file + "/autosave");
    FAIL() << "a file is no folder";
  }
  catch (const oversketch_files::Failed& failed)
  {
    EXPECT_NE(std::string(failed.what()).find(file), std::string::npos);
  }
  Autosave autosave(root.path);
  std::ofstream(autosave.folder()) << "in the way";
  autosave.keep(fileWith(1));
  EXPECT_NE(autosave.wait(), "");
}
