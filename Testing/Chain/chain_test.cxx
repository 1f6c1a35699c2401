// Three drawings, each through all four systems in one session: what changes upstream runs what depends and
// tears nothing; the evaluator's mesh, the saved session replayed and four commands are the same to the bit;
// the model as a GLB wears the picture.
#include "Chain/drawn_chain.h"
#include "Harness/bits.h"
#include "Harness/executions.h"
#include "Harness/sequences.h"
#include "Hostile/sound.h"

#include "mesh_file.h"
#include "session_file.h"
#include "texture.h"

#include "vtkFieldData.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

// A folder of this test alone, or one in a folder that OVERSKETCH_CHAIN_FILES names, to be looked at.
struct Folder
{
  explicit Folder(const std::string& name)
    : kept(std::getenv("OVERSKETCH_CHAIN_FILES"))
    , path(this->kept
             ? std::filesystem::path(this->kept) / name
             : std::filesystem::temp_directory_path() / ("oversketch-chain-" + std::to_string(::getpid())))
  {
    std::filesystem::create_directories(this->path);
  }
  ~Folder()
  {
    if (!this->kept)
    {
      std::filesystem::remove_all(this->path);
    }
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (this->path / name).string(); }

  const char* kept;
  std::filesystem::path path;
};

double areaOf(const Mesh& mesh, const Triangle& t)
{
  const Vector3 &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
  return 0.5 * (b - a).cross(c - a).norm();
}

// Whether a texture is the picture, opaque: of its size, and with its colours but where they are led on.
bool isSkinOf(const std::string& bytes, vtkImageData* picture)
{
  const vtkSmartPointer<vtkImageData> skin = oversketch_files::pictureOf(bytes);
  if (!skin || skin->GetNumberOfPoints() != picture->GetNumberOfPoints() ||
      skin->GetDimensions()[0] != picture->GetDimensions()[0] || skin->GetNumberOfScalarComponents() != 3)
  {
    return false;
  }
  vtkDataArray *a = skin->GetPointData()->GetScalars(), *b = picture->GetPointData()->GetScalars();
  vtkIdType same = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    same += a->GetComponent(i, 0) == b->GetComponent(i, 0) && a->GetComponent(i, 2) == b->GetComponent(i, 2);
  }
  return same > a->GetNumberOfTuples() / 4;
}

// What is wrong with a model of one closed surface that wears its picture; empty where nothing is. Texture
// coordinates may be stretched, but not jump: over an edge by four times its length, in the picture's pixels.
std::string faultsOf(vtkPolyData* polyData, vtkImageData* picture)
{
  std::string faults;
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    if (!Vector3(polyData->GetPoint(i)).allFinite())
    {
      return "a point is not finite; ";
    }
  }
  const Mesh mesh = MeshOf(polyData);
  const Topology topology = topologyOf(polyData);
  faults += topology.euler == 2 ? "" : "Euler number " + std::to_string(topology.euler) + "; ";
  faults += topology.borders == 0 ? "" : std::to_string(topology.borders) + " borders; ";
  const auto isDegenerate = [&](const Triangle& t)
  {
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).norm());
    }
    return !(areaOf(mesh, t) > 1e-6 * longest * longest);
  };
  const auto degenerate = std::count_if(mesh.triangles.begin(), mesh.triangles.end(), isDegenerate);
  faults += degenerate == 0 ? "" : std::to_string(degenerate) + " degenerate triangles; ";
  faults += isSkinOf(oversketch_files::textureOf(polyData), picture) ? "" : "not the picture; ";
  const Vector2 size(picture->GetDimensions()[0], picture->GetDimensions()[1]);
  vtkDataArray* texture = polyData->GetPointData()->GetTCoords();
  if (!texture || texture->GetNumberOfTuples() != polyData->GetNumberOfPoints())
  {
    return faults + "no texture coordinates; ";
  }
  const auto at = [&](int v) { return Vector2(texture->GetComponent(v, 0), texture->GetComponent(v, 1)); };
  int outside = 0, jumps = 0;
  double worst = 0.0; // px beyond what is allowed
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    outside += !(at(v).minCoeff() >= 0.0 && at(v).maxCoeff() <= 1.0);
  }
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      const double length = (mesh.points[a] - mesh.points[b]).norm();
      const double beyond = (at(a) - at(b)).cwiseProduct(size).norm() - 4.0 * length - 1.5;
      jumps += !(beyond <= 0.0);
      worst = std::max(worst, beyond);
    }
  }
  faults += outside == 0 ? "" : std::to_string(outside) + " texture coordinates outside the picture; ";
  faults += jumps == 0 ? ""
                       : std::to_string(jumps) + " edges over which the picture jumps, by " +
                           std::to_string(worst) + " px; ";
  return faults;
}

std::string faultsOf(vtkPolyData* mesh, const Session& session)
{
  const auto& image = std::get<Image>(session.nodes[0].step->inputs.at("Picture"));
  const auto picture = oversketch_files::pictureOf(*image.bytes);
  return faultsOf(mesh, picture);
}

// The first step's picture is a skin of the session's, which all that follow wear.
std::vector<Outcome> outcomesOf(Evaluator& evaluator, const Session& session)
{
  std::vector<Outcome> outcomes;
  EXPECT_TRUE(evaluator.run(session, {}, outcomes));
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    EXPECT_EQ(outcomes[i].failure, "") << session.nodes[i].name;
    EXPECT_EQ(faultsOf(outcomes[i].mesh, session), "") << session.nodes[i].name;
    EXPECT_FALSE(outcomes[i].elsewhere) << session.nodes[i].name << " takes hold elsewhere";
  }
  return outcomes;
}

Session sessionOf(const DrawnChain& chain)
{
  Evaluator evaluator;
  return chainSession(chain, outcomesOf(evaluator, drawingSession(chain)).back().mesh);
}

// Where each step took hold is kept with it, as a window does.
void commit(Session& session, const std::vector<Outcome>& outcomes)
{
  for (std::size_t i = 0; i < outcomes.size(); ++i)
  {
    session.nodes[i].committed = outcomes[i].section;
  }
}

std::string numbered(double value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

// Runs the command; what it says comes with a failure.
void run(const std::string& arguments, const Folder& folder)
{
  const std::string said = folder.file("said.txt");
  const int code =
    std::system((std::string(OVERSKETCH_COMMAND) + " " + arguments + " > " + said + " 2>&1").c_str());
  EXPECT_EQ(code, 0) << arguments << "\n" << oversketch_files::wholeFile(said);
  EXPECT_EQ(oversketch_files::wholeFile(said).find("bit for bit"), std::string::npos);
}

void write(const Folder& folder, const std::string& name, vtkPolyData* lines)
{
  oversketch_files::writeText(folder.file(name), oversketch_files::bytesOf(lines));
}

vtkSmartPointer<vtkPolyData> meshOf(const std::string& path)
{
  oversketch_files::Notes notes;
  return oversketch_files::readMesh(path, notes);
}

// The session's steps as four commands through files; the last one's file.
std::string byCommands(const Session& session, const DrawnChain& chain, const Folder& folder)
{
  const auto lines = [&](std::size_t node, const char* input)
  {
    const std::string name = std::to_string(node) + input + ".vtp";
    write(folder, name, linesOf(*session.nodes[node].step, input));
    return folder.file(name);
  };
  const auto made = [&](int step) { return folder.file(std::to_string(step) + ".vtp"); };
  const std::string host = " --backend embree -o ";
  run("inflate " + lines(0, "Strokes") + " --image " + drawingPath(chain, ".png") + host + made(1), folder);
  run("one-stroke " + made(1) + " " + lines(1, "Stroke") + host + made(2), folder);
  run("edit " + made(2) + " --reference " + lines(2, "Reference") + " --boundary " + lines(2, "Boundary") +
        " --profile " + lines(2, "Profile") + host + made(3),
    folder);
  run("augment " + made(3) + " " + lines(3, "Strokes") + " --radius " + numbered(chain.radius) +
        " --height " + numbered(chain.height) + host + made(4),
    folder);
  return made(4);
}

} // namespace

class Chain : public testing::TestWithParam<DrawnChain>
{
};

TEST_P(Chain, WhatDependsRunsAndNothingTears)
{
  const DrawnChain& chain = GetParam();
  Session session = sessionOf(chain);
  Evaluator evaluator;
  std::map<std::string, std::unique_ptr<Executions>> steps;
  for (const Node& node : session.nodes)
  {
    steps[node.name] = std::make_unique<Executions>(evaluator.system(node.name));
  }
  std::vector<Outcome> outcomes = outcomesOf(evaluator, session);
  ASSERT_EQ(evaluator.runs(), 4u);
  commit(session, outcomes);
  std::vector<std::string> digests;
  for (const Outcome& outcome : outcomes)
  {
    digests.push_back(digestOf(outcome.mesh));
    std::cout << outcome.mesh->GetNumberOfPolys() << " ";
  }
  std::cout << "triangles\n";
  EXPECT_EQ(std::set<std::string>(digests.begin(), digests.end()).size(), 4u);
  for (auto& named : steps)
  {
    EXPECT_FALSE(named.second->Ran().empty()) << named.first;
  }

  // Changes one after the other, each on what the one before has left; the first node that is another.
  const auto rerun = [&](std::size_t first)
  {
    const std::size_t before = evaluator.runs();
    outcomes = outcomesOf(evaluator, session);
    EXPECT_EQ(evaluator.runs() - before, session.nodes.size() - first);
    for (std::size_t i = 0; i < outcomes.size(); ++i)
    {
      const std::string digest = digestOf(outcomes[i].mesh);
      EXPECT_EQ(digest == digests[i], i < first) << session.nodes[i].name;
      digests[i] = digest;
    }
    Evaluator fresh;
    EXPECT_EQ(digestOf(outcomesOf(fresh, session).back().mesh), digests.back());
    std::map<std::string, std::set<std::string>> ran;
    for (auto& named : steps)
    {
      ran[named.first] = named.second->Ran();
    }
    return ran;
  };
  const View view = oversketch::ViewOfStroke(linesOf(*session.nodes[0].step, "Strokes"), 0);
  const vtkSmartPointer<vtkPolyData> inflated = outcomes[0].mesh;
  change(session.nodes[0],
    [&](Step& step) { step.inputs["Strokes"] = Lines(withOtherOutline(linesOf(step, "Strokes"), chain)); });
  EXPECT_FALSE(rerun(0)["InflateDrawing"].empty());
  change(session.nodes[1],
    [&](Step& step) { step.inputs["Stroke"] = Lines(toStroke(limbLine(inflated, view, chain, 1.3), view)); });
  auto ran = rerun(1);
  EXPECT_TRUE(ran["InflateDrawing"].empty());
  EXPECT_FALSE(ran["OneStroke"].empty());
  // The profile alone: no curve is laid, no region grown, no field solved.
  change(
    session.nodes[2], [&](Step& step) { step.inputs["Profile"] = Lines(profileLine(1.2 * chain.rise)); });
  ran = rerun(2);
  EXPECT_TRUE(ran["InflateDrawing"].empty());
  EXPECT_TRUE(ran["OneStroke"].empty());
  EXPECT_EQ(ran["Edit"], (std::set<std::string>{ "Redraw", "Bend", "Retriangulate" }));
  EXPECT_FALSE(ran["Augment"].empty());
}

TEST_P(Chain, ReplayAndFourCommandsGiveTheSameBitsAndTheGlbWearsThePicture)
{
  const DrawnChain& chain = GetParam();
  const Session session = sessionOf(chain);
  Evaluator evaluator;
  const vtkSmartPointer<vtkPolyData> mesh = outcomesOf(evaluator, session).back().mesh;
  const Folder folder(chain.name);
  const std::string file = folder.file("chain.oversketch");
  writeSession(file, { session, originHere(session.backend), digestOf(mesh) });
  run("replay " + file + " -o " + folder.file("replayed.vtp"), folder);
  const auto replayed = meshOf(folder.file("replayed.vtp"));
  expectSameBits(replayed, mesh);
  EXPECT_EQ(faultsOf(replayed, session), "");
  const auto commanded = meshOf(byCommands(session, chain, folder));
  expectSameBits(commanded, mesh);
  EXPECT_EQ(faultsOf(commanded, session), "");

  run("replay " + file + " -o " + folder.file("chain.glb"), folder);
  const auto glb = meshOf(folder.file("chain.glb"));
  EXPECT_EQ(glb->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(faultsOf(glb, session), "");
  EXPECT_NE(oversketch_files::wholeFile(folder.file("chain.glb")).find(oversketch_files::textureOf(mesh)),
    std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Drawings,
  Chain,
  testing::ValuesIn(drawnChains()),
  [](const auto& which) { return std::string(which.param.name); });

namespace
{

} // namespace

// Every step takes what every other makes, by files: whatever options change the kind of what it makes, each
// step that takes a mesh takes it, and makes one surface of it. Left out are quads of a drawing as published,
// which are folded under this boundary, and lines as published, whose snapping makes triangles without area.
TEST(ChainPairs, EveryStepTakesWhatEveryOtherMakes)
{
  const DrawnChain& chain = drawnChains()[1]; // of its corners quads used to make no surface
  const Session session = sessionOf(chain);
  const Folder folder("pairs");
  const auto lines = [&](std::size_t node, const char* input)
  {
    const std::string name = std::to_string(node) + input + ".vtp";
    write(folder, name, linesOf(*session.nodes[node].step, input));
    return folder.file(name);
  };
  const std::string image = " --image " + drawingPath(chain, ".png"), plain = folder.file("plain.vtp");
  const std::string end = " --backend embree -o ";
  const std::map<std::string, std::string> after = { { "one-stroke", lines(1, "Stroke") },
    { "edit",
      "--reference " + lines(2, "Reference") + " --boundary " + lines(2, "Boundary") + " --profile " +
        lines(2, "Profile") },
    { "augment",
      lines(3, "Strokes") + " --radius " + numbered(chain.radius) + " --height " + numbered(chain.height) } };
  const std::string drawing = lines(0, "Strokes") + image;
  run("inflate " + drawing + end + plain, folder);
  // A drawing as published is left out: its stalk is thinner than what the steps after it draw.
  const std::map<std::string, std::vector<std::string>> kinds = {
    { "inflate " + drawing,
      { "",
        "--quads",
        "--quads --levels 1",
        "--extrude 40",
        "--extrude 40 --quads",
        "--poisson --quads",
        "--profile step",
        "--profile linear --quads",
        "--unstretched-rims off",
        "--levels-from-sketch",
        "--arrange --quads",
        "--back-image " + drawingPath(chain, ".png"),
        "--quads --back-image " + drawingPath(chain, ".png") } },
    { "one-stroke " + plain + " " + after.at("one-stroke"),
      { "", "--remesh off", "--remesh on", "--adjust-normals", "--as-published --allow-torn" } },
    { "edit " + plain + " " + after.at("edit"), { "", "--rule curvature", "--rule off", "--as-published" } },
    { "augment " + plain + " " + after.at("augment"),
      { "", "--base simplified", "--simplify off", "--distance geodesic", "--one-by-one" } }
  };
  int rows = 0, pairs = 0;
  for (const auto& [command, options] : kinds)
  {
    for (const std::string& each : options)
    {
      if (!isOfTheDay(rows++, 6))
      {
        continue;
      }
      // Wavefront's format keeps quads and nothing of our own, the other all. It replaces no picture.
      const bool quads = each.find("--quads") != std::string::npos;
      const std::string made = folder.file("made" + std::to_string(pairs) + (quads ? ".obj" : ".vtp"));
      SCOPED_TRACE(made + ": " + command + " " + each);
      run(command + " " + each + end + made, folder);
      for (const auto& [verb, input] : after)
      {
        const std::string out = folder.file("out.vtp");
        run(verb + " " + made + " " + input + end + out, folder);
        const Topology topology = topologyOf(meshOf(out));
        EXPECT_EQ(topology.euler, 2) << command << " " << each << " | " << verb;
        EXPECT_EQ(topology.borders, 0) << command << " " << each << " | " << verb;
        ++pairs;
      }
    }
  }
  EXPECT_GT(pairs, 0);
  std::cout << pairs << " pairs\n";
}

// What is said of a model is right: each of these is found. A picture belongs to texture coordinates.
TEST(ChainFaults, AreFound)
{
  const DrawnChain& chain = drawnChains().front();
  const Session session = drawingSession(chain);
  Evaluator evaluator;
  const vtkSmartPointer<vtkPolyData> sound = outcomesOf(evaluator, session).back().mesh;
  const auto faults = [&](const auto& spoil)
  {
    const auto mesh = deepCopy(sound);
    spoil(mesh.Get());
    return faultsOf(mesh, session);
  };
  EXPECT_EQ(faults([](vtkPolyData*) {}), "");
  const std::string open = faults(
    [](vtkPolyData* mesh)
    {
      vtkNew<vtkCellArray> fewer;
      vtkNew<vtkIdList> ids;
      for (vtkIdType t = 1; t < mesh->GetNumberOfPolys(); ++t)
      {
        mesh->GetPolys()->GetCellAtId(t, ids);
        fewer->InsertNextCell(ids);
      }
      mesh->SetPolys(fewer);
    });
  EXPECT_EQ(open, "Euler number 1; 1 borders; ");
  const std::string flat = faults(
    [](vtkPolyData* mesh)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetPolys()->GetCellAtId(0, ids);
      const Vector3 a(mesh->GetPoint(ids->GetId(0))), b(mesh->GetPoint(ids->GetId(1)));
      mesh->GetPoints()->SetPoint(ids->GetId(2), Vector3(0.5 * (a + b)).data());
    });
  EXPECT_NE(flat.find("1 degenerate triangles"), std::string::npos) << flat;
  EXPECT_EQ(
    faults([](vtkPolyData* mesh) { oversketch_files::setTexture(mesh, "another"); }), "not the picture; ");
  EXPECT_EQ(faults([](vtkPolyData* mesh) { mesh->GetPointData()->SetTCoords(nullptr); }),
    "not the picture; no texture coordinates; ");
  const std::string jump =
    faults([](vtkPolyData* mesh) { mesh->GetPointData()->GetTCoords()->SetComponent(7, 0, 0.9); });
  EXPECT_NE(jump.find("edges over which the picture jumps"), std::string::npos) << jump;
  const std::string outside =
    faults([](vtkPolyData* mesh) { mesh->GetPointData()->GetTCoords()->SetComponent(7, 0, 1.01); });
  EXPECT_EQ(outside.find("1 texture coordinates outside the picture; "), 0u) << outside;
  EXPECT_EQ(
    faults([](vtkPolyData* mesh) { mesh->GetPoints()->SetPoint(7, NAN, 0, 0); }), "a point is not finite; ");
}

// Bits are compared to the last corner, of quads too.
TEST(ChainFaults, EveryCornerCounts)
{
  const auto quad = [](vtkIdType last)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    for (const auto& [x, y] :
      { std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1), std::pair(0, 2) })
    {
      points->InsertNextPoint(x, y, 0.0);
    }
    vtkNew<vtkCellArray> cells;
    const vtkIdType corners[] = { 0, 1, 2, last };
    cells->InsertNextCell(4, corners);
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    return mesh;
  };
  EXPECT_TRUE(identical(quad(3), quad(3)));
  EXPECT_FALSE(identical(quad(3), quad(4)));
}
