// Session files: every bit comes back; what is damaged is refused.
#include "sessions.h"

#include "files.h"
#include "session_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fs = std::filesystem;
using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// A folder for one test, removed afterwards.
struct Folder
{
  Folder()
    : path(fs::temp_directory_path() /
           (std::string("oversketch_session_") +
             testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(::getpid())))
  {
    fs::remove_all(this->path);
    fs::create_directories(this->path);
  }
  ~Folder() { fs::remove_all(this->path); }
  std::string file(const std::string& name) const { return (this->path / name).string(); }

  fs::path path;
};

std::string contentOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

SessionFile dogFile()
{
  SessionFile file;
  file.session = dogSession();
  auto mirrored = std::make_shared<Action>(*file.session.nodes[1].action);
  mirrored->mirror = MirrorPlane{ 2, 0.1 };
  mirrored->parameters.adjustNormals = true;
  mirrored->parameters.remesh = vtkOversketchOneStroke::RemeshAuto;
  file.session.nodes[1].action = mirrored;
  file.session.nodes[1].on = false;
  file.session.nodes[1].name = "tail \"curled\" \xc3\xa4";
  file.session.nodes[0].committed = Section{ { 0.1, 1.0 / 3.0, -2e-300 }, 0.7 };
  file.origin = { "1.2.3", "opencl", "some device", "some processor" };
  file.digest = digestOf(file.session.mesh);
  return file;
}

void expectEqual(const SessionFile& a, const SessionFile& b)
{
  EXPECT_EQ(digestOf(a.session.mesh), digestOf(b.session.mesh));
  EXPECT_EQ(a.session.meshName, b.session.meshName);
  EXPECT_EQ(a.session.backend, b.session.backend);
  EXPECT_EQ(a.digest, b.digest);
  EXPECT_TRUE(differences(a.origin, b.origin).empty());
  ASSERT_EQ(a.session.nodes.size(), b.session.nodes.size());
  for (std::size_t i = 0; i < a.session.nodes.size(); ++i)
  {
    const Node &p = a.session.nodes[i], &q = b.session.nodes[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.on, q.on);
    EXPECT_TRUE(p.action->parameters == q.action->parameters);
    ASSERT_EQ(p.action->mirror.has_value(), q.action->mirror.has_value());
    if (p.action->mirror)
    {
      EXPECT_EQ(p.action->mirror->axis, q.action->mirror->axis);
      EXPECT_EQ(p.action->mirror->offset, q.action->mirror->offset);
    }
    ASSERT_EQ(p.committed.has_value(), q.committed.has_value());
    if (p.committed)
    {
      EXPECT_EQ(p.committed->middle, q.committed->middle);
      EXPECT_EQ(p.committed->length, q.committed->length);
    }
    EXPECT_EQ(largestMove(p.action->stroke, q.action->stroke), 0.0);
    vtkDataArray* view = p.action->stroke->GetCellData()->GetArray("ViewTransform");
    vtkDataArray* again = q.action->stroke->GetCellData()->GetArray("ViewTransform");
    ASSERT_NE(again, nullptr);
    EXPECT_EQ(std::memcmp(view->GetVoidPointer(0), again->GetVoidPointer(0), 16 * sizeof(double)), 0);
  }
}

std::string refusalOf(const std::function<void()>& read)
{
  try
  {
    read();
  }
  catch (const oversketch_files::Failed& failed)
  {
    return failed.what();
  }
  return "";
}

std::string jsonOf(const Package& package)
{
  return *package.at(sessionEntry);
}

Package changed(Package package, const std::string& from, const std::string& to)
{
  std::string json = jsonOf(package);
  const std::size_t at = json.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  json.replace(at, from.size(), to);
  package[sessionEntry] = std::make_shared<std::string>(json);
  return package;
}

} // namespace

TEST(SessionFile, EveryBitComesBackFromAZipFileAndAFolder)
{
  const Folder folder;
  oversketch_files::catchMessages();
  const SessionFile file = dogFile();
  writeSession(folder.file("dog.oversketch"), file);
  expectEqual(readSession(folder.file("dog.oversketch")), file);
  writeFolder(folder.file("autosave"), Encoder().encode(file), sessionEntry);
  expectEqual(readSession(folder.file("autosave")), file);
}

TEST(SessionFile, EqualSessionsGiveEqualFiles)
{
  const Folder folder;
  writeSession(folder.file("a.oversketch"), dogFile());
  writeSession(folder.file("b.oversketch"), dogFile());
  EXPECT_EQ(contentOf(folder.file("a.oversketch")), contentOf(folder.file("b.oversketch")));
}

TEST(SessionFile, AFolderIsWrittenOnceAndKeepsNothingThatIsNotNamed)
{
  const Folder folder;
  SessionFile file = dogFile();
  writeFolder(folder.file("autosave"), Encoder().encode(file), sessionEntry);
  const auto meshOf = [&] { return fs::directory_iterator(folder.path / "autosave" / "mesh")->path(); };
  const auto written = fs::last_write_time(meshOf());
  fs::last_write_time(meshOf(), written - std::chrono::hours(1));
  file.session.nodes.pop_back();
  writeFolder(folder.file("autosave"), Encoder().encode(file), sessionEntry);
  EXPECT_EQ(fs::last_write_time(meshOf()), written - std::chrono::hours(1))
    << "the mesh is not written again";
  const auto strokes = fs::directory_iterator(folder.path / "autosave" / "strokes");
  EXPECT_EQ(std::distance(fs::begin(strokes), fs::end(strokes)), 1);
  expectEqual(readSession(folder.file("autosave")), file);
}

TEST(SessionFile, ATruncatedFileIsRefused)
{
  const Folder folder;
  oversketch_files::catchMessages();
  writeSession(folder.file("dog.oversketch"), dogFile());
  const std::string whole = contentOf(folder.file("dog.oversketch"));
  for (int i = 0; i < 40; ++i)
  {
    const std::string path = folder.file("cut.oversketch");
    std::ofstream(path, std::ios::binary) << whole.substr(0, whole.size() * static_cast<std::size_t>(i) / 40);
    EXPECT_NE(refusalOf([&] { readSession(path); }), "") << i << " fortieths";
  }
}

TEST(SessionFile, DamagedBytesAreRefusedOrChangeNothing)
{
  const Folder folder;
  oversketch_files::catchMessages();
  const SessionFile file = dogFile();
  writeSession(folder.file("dog.oversketch"), file);
  const std::string whole = contentOf(folder.file("dog.oversketch"));
  unsigned state = 1;
  int refused = 0;
  for (int i = 0; i < 60; ++i)
  {
    state = state * 1664525u + 1013904223u;
    std::string damaged = whole;
    damaged[state % damaged.size()] = static_cast<char>(damaged[state % damaged.size()] ^ 0x55);
    const std::string path = folder.file("damaged.oversketch");
    std::ofstream(path, std::ios::binary) << damaged;
    SessionFile read;
    if (!refusalOf([&] { read = readSession(path); }).empty())
    {
      ++refused;
      continue;
    }
    EXPECT_EQ(digestOf(read.session.mesh), file.digest) << "damage at " << state % damaged.size();
  }
  EXPECT_GT(refused, 30); // zip's check sums see what lies in entries
}

TEST(SessionFile, RefusalsNameWhatIsWrong)
{
  oversketch_files::catchMessages();
  const Package good = Encoder().encode(dogFile());
  const auto refusal = [](const Package& package)
  { return refusalOf([&] { decode(package, "x.oversketch"); }); };
  EXPECT_EQ(refusal(good), "");
  const auto expect = [&](const Package& package, const std::string& words)
  {
    const std::string text = refusal(package);
    EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "' lacks '" << words << "'";
    EXPECT_EQ(text.rfind("x.oversketch: ", 0), 0u) << text;
  };
  expect({}, "it is no session");
  expect(changed(good, "\"oversketch-session\"", "\"gimp\""), "is no session");
  expect(changed(good, "\"format_version\" : 1", "\"format_version\" : 2"), "format version 2");
  expect(changed(good, "\"remesh\" : \"off\"", "\"remesh\" : \"maybe\""), "'remesh' is 'maybe'");
  expect(changed(good, "\"on\" : true", "\"on\" : 1"), "'on' is not true or false");
  expect(changed(good, "\"axis\" : 2", "\"axis\" : 3"), "'axis'");
  expect(changed(good, "\"length\" : ", "\"length\" : 1e999, \"x\" : "), "damaged");
  expect(changed(good, "\"mesh_name\"", "\"mesh_nam\""), "lacks 'mesh_name'");
  expect(changed(good, "{", "{{"), "is damaged");
  expect(changed(good, "\"strokes\" : \n", "\"strokes\" : 3, \"old\" :\n"), "'strokes' is not a list");
  Package lacking = good;
  for (auto it = lacking.begin(); it != lacking.end();)
  {
    it = it->first.rfind("strokes/", 0) == 0 ? lacking.erase(it) : std::next(it);
  }
  expect(lacking, "lacks its entry strokes/");
  Package broken = good;
  broken[good.begin()->first] = std::make_shared<std::string>("no mesh");
  expect(broken, "is not an XML PolyData file");
}

TEST(SessionFile, NamesThatLeaveTheFolderAreRefused)
{
  const Folder folder;
  for (const char* name : { "../evil", "/evil", "mesh/../../evil" })
  {
    Package package;
    package[name] = std::make_shared<std::string>("x");
    writeZip(folder.file("evil.oversketch"), package);
    EXPECT_NE(
      refusalOf([&] { readPackage(folder.file("evil.oversketch")); }).find("the name '"), std::string::npos)
      << name;
  }
}

TEST(SessionFile, DifferencesAreTold)
{
  const Origin a{ "1", "opencl", "pocl", "epyc" };
  Origin b = a;
  EXPECT_TRUE(differences(a, b).empty());
  b.version = "2";
  b.backend = "embree";
  b.device = "";
  const auto lines = differences(a, b);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "the version was 1, here it is 2");
  EXPECT_EQ(lines[2], "the device was pocl, here it is none");
  const Origin here = originHere(vtkOversketchOneStroke::Host);
  EXPECT_EQ(here.backend, "embree");
  EXPECT_EQ(here.device, "");
  EXPECT_FALSE(here.processor.empty());
}

TEST(SessionFile, TheDigestSeesEveryBit)
{
  const vtkSmartPointer<vtkPolyData> mesh = shippedModel("dog");
  vtkNew<vtkPolyData> other;
  other->DeepCopy(mesh);
  EXPECT_EQ(digestOf(mesh), digestOf(other));
  double p[3];
  other->GetPoint(7, p);
  p[1] = std::nextafter(static_cast<float>(p[1]), 10.0f);
  other->GetPoints()->SetPoint(7, p);
  EXPECT_NE(digestOf(mesh), digestOf(other));
}
