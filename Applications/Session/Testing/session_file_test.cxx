// Session files: every bit comes back; what is damaged is refused.
#include "sessions.h"
#include "toys.h"

#include "files.h"
#include "mesh_file.h"
#include "session_file.h"

#include "vtkCellArray.h"

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
  file.session.nodes[1] = changed(file.session.nodes[1],
    [](Step& step)
    {
      step.mirror = MirrorPlane{ 2, 0.1 };
      step.values = { { "AdjustNormals", true } };
    });
  file.session.nodes[1].on = false;
  file.session.nodes[1].name = "tail \"curled\" \xc3\xa4";
  file.session.nodes[0].committed = Section{ { 0.1, 1.0 / 3.0, -2e-300 }, 0.7 };
  file.origin = { "1.2.3", "opencl", "some device", "some processor" };
  file.digest = digestOf(file.session.mesh);
  return file;
}

void expectEqual(const Input& a, const Input& b)
{
  ASSERT_EQ(a.index(), b.index());
  if (const auto* lines = std::get_if<Lines>(&a))
  {
    EXPECT_EQ(oversketch_files::bytesOf(lines->own()), oversketch_files::bytesOf(std::get<Lines>(b).own()));
  }
  else if (const auto* image = std::get_if<Image>(&a))
  {
    EXPECT_EQ(image->name, std::get<Image>(b).name);
    EXPECT_EQ(*image->bytes, *std::get<Image>(b).bytes);
  }
  else
  {
    EXPECT_EQ(std::get<StepOutput>(a).step, std::get<StepOutput>(b).step);
    EXPECT_EQ(std::get<StepOutput>(a).port, std::get<StepOutput>(b).port);
  }
}

void expectEqual(const SessionFile& a, const SessionFile& b)
{
  ASSERT_EQ(a.session.mesh.Get() == nullptr, b.session.mesh.Get() == nullptr);
  EXPECT_TRUE(!a.session.mesh || digestOf(a.session.mesh) == digestOf(b.session.mesh));
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
    EXPECT_EQ(p.id, q.id);
    EXPECT_EQ(p.step->system, q.step->system);
    EXPECT_EQ(p.step->values, q.step->values);
    ASSERT_EQ(p.step->mirror.has_value(), q.step->mirror.has_value());
    if (p.step->mirror)
    {
      EXPECT_EQ(p.step->mirror->axis, q.step->mirror->axis);
      EXPECT_EQ(p.step->mirror->offset, q.step->mirror->offset);
    }
    ASSERT_EQ(p.committed.has_value(), q.committed.has_value());
    if (p.committed)
    {
      EXPECT_EQ(p.committed->middle, q.committed->middle);
      EXPECT_EQ(p.committed->length, q.committed->length);
    }
    ASSERT_EQ(p.step->inputs.size(), q.step->inputs.size());
    for (const auto& [name, input] : p.step->inputs)
    {
      expectEqual(input, q.step->inputs.at(name));
    }
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

Package edited(Package package, const std::string& from, const std::string& to)
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
  expect(edited(good, "\"oversketch-session\"", "\"gimp\""), "is no session");
  expect(edited(good, "\"format_version\" : 1", "\"format_version\" : 3"), "format version 3");
  expect(edited(good, "\"remesh\" : \"off\"", "\"remesh\" : \"maybe\""), "'remesh' is 'maybe'");
  expect(edited(good, "\"on\" : true", "\"on\" : 1"), "'on' is not true or false");
  expect(edited(good, "\"axis\" : 2", "\"axis\" : 3"), "'axis'");
  expect(edited(good, "\"length\" : ", "\"length\" : 1e999, \"x\" : "), "damaged");
  expect(edited(good, "\"mesh_name\"", "\"mesh_nam\""), "lacks 'mesh_name'");
  expect(edited(good, "{", "{{"), "is damaged");
  expect(edited(good, "\"strokes\" : \n", "\"strokes\" : 3, \"old\" :\n"), "'strokes' is not a list");
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

// Every alternative of values and inputs, a reference, and no mesh.
SessionFile liftedFile()
{
  SessionFile file;
  file.session = liftedBall();
  auto& nodes = file.session.nodes;
  nodes[0] = changed(nodes[0],
    [](Step& step)
    {
      step.values = { { "Label", std::string("\"ball\" \xc3\xa4") } };
      step.inputs["Picture"] = picture();
    });
  nodes[1] = changed(nodes[1],
    [](Step& step)
    {
      step.values = { { "Height", 1.0 / 3.0 },
        { "Times", 4 },
        { "Down", true },
        { "Shift", std::vector<double>{ -0.1, 1e-300 } } };
    });
  nodes[1].id = 17;
  nodes.push_back(dogSession().nodes[0]);
  nodes[2].id = 3;
  nodes[2].committed = Section{ { 0.1, 1.0 / 3.0, -2e-300 }, 0.7 };
  file.origin = { "1.2.3", "embree", "", "some processor" };
  return file;
}

TEST(SessionFile2, EveryBitOfSeveralSystemsComesBack)
{
  const Folder folder;
  oversketch_files::catchMessages();
  const SessionFile file = liftedFile();
  const Package package = Encoder(rowsWithToys()).encode(file);
  EXPECT_NE(jsonOf(package).find("\"format_version\" : 2"), std::string::npos);
  EXPECT_EQ(package.size(), 5u) << "the text, three lines and a picture; no mesh";
  writeZip(folder.file("ball.oversketch"), package);
  const SessionFile read = decode(readPackage(folder.file("ball.oversketch")), "x", rowsWithToys());
  EXPECT_FALSE(read.session.mesh);
  expectEqual(read, file);
  EXPECT_EQ(jsonOf(Encoder(rowsWithToys()).encode(read)), jsonOf(package));
  // What a reference misses is for the evaluator to tell: a session in which it does can be saved.
  SessionFile broken = file;
  broken.session.nodes.erase(broken.session.nodes.begin());
  expectEqual(decode(Encoder(rowsWithToys()).encode(broken), "x", rowsWithToys()), broken);
}

TEST(SessionFile2, IsWrittenOnlyWhereVersion1CannotTellIt)
{
  const auto versionOf = [](const Session& session)
  {
    SessionFile file;
    file.session = session;
    const std::string json = jsonOf(Encoder(rowsWithToys()).encode(file));
    EXPECT_NE(json.find(json.find("\"steps\"") == std::string::npos ? "\"format_version\" : 1"
                                                                    : "\"format_version\" : 2"),
      std::string::npos);
    return json.find("\"steps\"") == std::string::npos ? 1 : 2;
  };
  Session session = dogSession();
  EXPECT_EQ(versionOf(session), 1);
  session.nodes[0] = changed(session.nodes[0], [](Step& step) { step.values["AsPublished"] = true; });
  session.nodes[0].id = 99;
  EXPECT_EQ(versionOf(session), 1);
  Session bare = session;
  bare.mesh = {};
  EXPECT_EQ(versionOf(bare), 2);
  Session referring = session;
  referring.nodes[1] = changed(referring.nodes[1],
    [](Step& step) {
      step.inputs["Mesh"] = StepOutput{ 99, 0 };
    });
  EXPECT_EQ(versionOf(referring), 2);
  Session more = session;
  more.nodes.push_back(liftedBall().nodes[0]);
  EXPECT_EQ(versionOf(more), 2);
}

TEST(SessionFile2, PicturesOfTheSceneComeBack)
{
  oversketch_files::catchMessages();
  SessionFile file;
  file.session = dogSession();
  const Lines stroke = std::get<Lines>(file.session.nodes[0].step->inputs.at("Stroke"));
  vtkNew<vtkPolyData> frame; // two samples of it
  frame->DeepCopy(stroke.own());
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  frame->SetLines(line);
  Picture picture;
  picture.image = oversketch_test::picture();
  picture.frame = Lines(frame);
  picture.opacity = 0.25;
  picture.shown = false;
  picture.locked = true;
  file.session.pictures.push_back(std::make_shared<Picture>(picture));
  const Package package = Encoder().encode(file);
  EXPECT_NE(jsonOf(package).find("\"format_version\" : 2"), std::string::npos);
  const SessionFile read = decode(package, "x");
  ASSERT_EQ(read.session.pictures.size(), 1u);
  const Picture& back = *read.session.pictures[0];
  EXPECT_EQ(back.image.name, picture.image.name);
  EXPECT_EQ(*back.image.bytes, *picture.image.bytes);
  EXPECT_EQ(back.opacity, 0.25);
  EXPECT_FALSE(back.shown);
  EXPECT_TRUE(back.locked);
  EXPECT_EQ(jsonOf(Encoder().encode(read)), jsonOf(package));
  const auto refusal = [&](const std::string& from, const std::string& to)
  { return refusalOf([&] { decode(edited(package, from, to), "x"); }); };
  EXPECT_NE(
    refusal("\"opacity\" : 0.25", "\"opacity\" : 2").find("is not between 0 and 1"), std::string::npos);
  EXPECT_NE(refusal("\"frame\" :", "\"corner\" :").find("lacks 'frame'"), std::string::npos);
  picture.frame = stroke; // of more samples than two
  file.session.pictures = { std::make_shared<Picture>(picture) };
  EXPECT_NE(
    refusalOf([&] { decode(Encoder().encode(file), "x"); }).find("has not two corners"), std::string::npos);
}

TEST(SessionFile2, RefusalsNameWhatIsWrong)
{
  oversketch_files::catchMessages();
  const Package good = Encoder(rowsWithToys()).encode(liftedFile());
  const auto refusal = [](const Package& package)
  { return refusalOf([&] { decode(package, "x.oversketch", rowsWithToys()); }); };
  EXPECT_EQ(refusal(good), "");
  const auto expect = [&](const Package& package, const std::string& words)
  {
    const std::string text = refusal(package);
    EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "' lacks '" << words << "'";
    EXPECT_EQ(text.rfind("x.oversketch: ", 0), 0u) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  };
  const auto change = [&](const std::string& from, const std::string& to) { return edited(good, from, to); };
  expect(change("\"Blow\"", "\"Explode\""),
    "session.json, step 1: 'system' is 'Explode', which this version does not have");
  expect(
    change("\"Height\" :", "\"Depth\" :"), "step 2, values: 'Depth' is no parameter of Lift in this version");
  expect(change("\"Down\" : true", "\"Down\" : 1"), "step 2, values: 'Down' is not true or false");
  expect(change("\"Times\" : 4", "\"Times\" : 4.5"), "'Times' is not a number in its range");
  expect(change("\"Times\" : 4", "\"Times\" : 1e99"), "'Times' is not a number in its range");
  expect(change("\"Height\" : 0.3", "\"Height\" : 1e999, \"x\" : 0.3"), "damaged");
  expect(change("\"Height\" : ", "\"Height\" : null, \"Times\" : 1, \"x\" : "), "damaged");
  expect(change("\"Shift\" : \n", "\"Shift\" : 3, \"Old\" :\n"), "");
  expect(change("\"Remesh\" : \"off\"", "\"Remesh\" : \"maybe\""), "step 3, values: 'Remesh' is 'maybe'");
  expect(change("\"Drawing\" :", "\"Painting\" :"),
    "step 1, inputs: 'Painting' is no input of Blow in this version");
  expect(change("\"Against\" :", "\"Up\" :"), "");
  expect(
    change("\"step\" : 1", "\"step\" : -1"), "step 2, inputs, Against: 'step' is not a number in its range");
  expect(change("\"port\" : 1", "\"port\" : \"b\""), "'port' is not a number in its range");
  expect(change("\"id\" : 17", "\"id\" : 1"), "step 2: 'id' is that of another step");
  expect(change("\"id\" : 17", "\"id\" : 0"), "step 2: 'id' is not a number in its range");
  expect(change("\"id\" : 17", "\"id\" : 4000000000"), "'id' is not a number in its range");
  expect(change("\"inputs\" : \n", "\"inputs\" : [], \"x\" : \n"), "inputs is no object");
  expect(change("\"image\" :", "\"file\" :"), "step 1, inputs, Picture lacks 'image'");
  expect(change("\"steps\" :", "\"stairs\" :"), "lacks 'steps'");
  for (const auto& [name, bytes] : good)
  {
    if (name == sessionEntry)
    {
      continue;
    }
    Package lacking = good, broken = good, torn = good;
    lacking.erase(name);
    expect(lacking, "lacks its entry " + name);
    broken[name] = std::make_shared<std::string>("no such thing");
    expect(broken, name);
    torn[name] = std::make_shared<std::string>(bytes->substr(0, bytes->size() / 2));
    expect(torn, name);
  }
}

// Any byte of the text may be another: the session is refused with one line or reads as one of its kind.
TEST(SessionFile2, HostileTextsAreRefusedOrRead)
{
  oversketch_files::catchMessages();
  const Package good = Encoder(rowsWithToys()).encode(liftedFile());
  const std::string text = jsonOf(good);
  const std::string others = "\"{}[]:,0-9e.tfn\\ \n\xff";
  unsigned state = 1;
  int refused = 0, read = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const auto below = [&](std::size_t n)
    {
      state = state * 1664525u + 1013904223u;
      return static_cast<std::size_t>(state >> 8) % n;
    };
    std::string damaged = text;
    switch (below(3))
    {
      case 0:
        damaged[below(damaged.size())] = others[below(others.size())];
        break;
      case 1:
        damaged.erase(below(damaged.size()), 1 + below(20));
        break;
      default:
        damaged.insert(below(damaged.size()), damaged.substr(below(damaged.size()), 1 + below(40)));
    }
    Package package = good;
    package[sessionEntry] = std::make_shared<std::string>(damaged);
    const std::string refusal = refusalOf([&] { decode(package, "x", rowsWithToys()); });
    (refusal.empty() ? read : refused) += 1;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
  std::cout << refused << " refused, " << read << " read\n";
  EXPECT_GT(refused, 1000);
}

// Sessions of people, saved by version 1: they open, and are saved again as they were.
TEST(SessionFile, SessionsOfVersion1OpenAndAreSavedAgainByteForByte)
{
  oversketch_files::catchMessages();
  const char* data = std::getenv("OVERSKETCH_DATA");
  const fs::path folder = fs::path(data ? data : OVERSKETCH_SHARED_DATA) / "sessions";
  if (!fs::is_directory(folder))
  {
    GTEST_SKIP() << folder << " is not there";
  }
  int count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    const Package package = readPackage(entry.path().string());
    const SessionFile file = decode(package, entry.path().string());
    ASSERT_FALSE(file.session.nodes.empty()) << entry.path();
    const Package again = Encoder().encode(file);
    ASSERT_EQ(again.size(), package.size()) << entry.path();
    for (const auto& [name, bytes] : package)
    {
      ASSERT_EQ(again.count(name), 1u) << entry.path() << ", " << name;
      EXPECT_EQ(*again.at(name), *bytes) << entry.path() << ", " << name;
    }
    ++count;
  }
  EXPECT_GE(count, 5);
  std::cout << count << " sessions\n";
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
