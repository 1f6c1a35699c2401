// Random hands: chains of one to six steps of all four systems in one session, on a model or on a drawing
// that begins it. After each step the mesh is finite, has no more triangles without area than before, has the
// topology that it had (a drawing adds closed surfaces) and, where it is a 4-8 mesh, arrays that can be read;
// what is refused is told; the saved session makes the same bits. 16 chains, of them 12 by the day;
// OVERSKETCH_CHAINS=300 and OVERSKETCH_FIRST_CHAIN=NUMBER ask for others, a chain is made of its number.
#include "Harness/data.h"
#include "Harness/drawings.h"
#include "Harness/sequences.h"
#include "Harness/shipped.h"
#include "sound.h"

#include "Silhouette/outline.h"
#include "drawing_lines.h"
#include "evaluator.h"
#include "files.h"
#include "mesh_file.h"
#include "session_file.h"
#include "vtkOversketchAugment.h"
#include "vtkOversketchFilterTools.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <unistd.h>

using namespace oversketch_session;
using namespace oversketch_test;

namespace
{

int asked(const char* name, int otherwise)
{
  const char* value = std::getenv(name);
  return value ? std::atoi(value) : otherwise;
}

// Ten models; those of the shared data are left out where they are absent.
vtkSmartPointer<vtkPolyData> modelOf(int number)
{
  const char* shipped[] = { "bear", "dog", "dinosaur", "octopus", "person" };
  const char* shared[] = {
    "spot_5k9.obj", "bunny_5k.obj", "torus.obj", "hand_open_wrist.off", "skull_genus2.off"
  };
  const std::string path = sharedData(std::string("meshes/") + shared[number % 5]);
  if (number % 10 < 5 || path.empty())
  {
    return shippedModel(shipped[number % 5]);
  }
  oversketch_files::Notes notes;
  return oversketch_files::readMesh(path, notes);
}

struct Hand
{
  explicit Hand(int chain)
    : generator(static_cast<unsigned>(chain))
  {
  }
  // In [low, high), the same on every platform.
  double in(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->generator()) / 4294967296.0;
  }
  int below(int count) { return static_cast<int>(this->in(0.0, count)); }

  // The model upright, from anywhere round it.
  View view(const Mesh& mesh)
  {
    Vector3 low = Vector3::Constant(1e300), high = -low;
    for (const Vector3& p : mesh.points)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double size = (high - low).norm(), turn = this->in(0.0, 2.0 * pi);
    const Vector3 from(std::sin(turn), this->in(-0.4, 0.6), std::cos(turn));
    const View at = this->below(2) ? perspectiveView(from.normalized() * 1.7 * size, { 0, 1, 0 }, 40)
                                   : orthographicView(from, { 0, 1, 0 }, 500.0 / size);
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.topRightCorner<3, 1>() = -0.5 * (low + high);
    return View(at.viewTransform() * shift, at.projectionTransform(), at.width(), at.height());
  }

  // A stretch of the outline, bulged.
  std::vector<Vector2> along(const Mesh& mesh, const View& view, double least, double most)
  {
    const std::vector<OutlineLoop> loops = traceOutline(mesh, view, outlineWindow(mesh, view, {}));
    const auto longest = std::max_element(loops.begin(),
      loops.end(),
      [](const OutlineLoop& a, const OutlineLoop& b) { return a.points.size() < b.points.size(); });
    const auto& loop = longest->points;
    const std::size_t count = loop.size();
    const auto first = static_cast<std::size_t>(this->in(0.0, static_cast<double>(count)));
    const auto length = static_cast<std::size_t>(this->in(least, most) * static_cast<double>(count));
    const Vector2 bulge(this->in(-20.0, 20.0), this->in(-20.0, 20.0));
    std::vector<Vector2> samples;
    for (std::size_t i = 0; i < length; i += 3)
    {
      const double s = std::sin(pi * static_cast<double>(i) / static_cast<double>(length));
      samples.emplace_back(loop[(first + i) % count] + s * bulge);
    }
    return samples;
  }

  // A wave from somewhere on the model.
  std::vector<Vector2> across(const Mesh& mesh, const View& view)
  {
    const auto v = static_cast<std::size_t>(this->below(static_cast<int>(mesh.points.size())));
    const Vector2 at = view.toDisplay(mesh.points[v]).head<2>();
    const double turn = this->in(0.0, 2.0 * pi), length = this->in(20.0, 300.0), wave = this->in(0.0, 30.0);
    const Vector2 along(std::cos(turn), std::sin(turn)), aside(-along[1], along[0]);
    std::vector<Vector2> samples;
    for (int i = 0; i <= 60; ++i)
    {
      const double s = i / 60.0;
      samples.emplace_back(at + length * s * along + wave * std::sin(9.0 * s) * aside);
    }
    return samples;
  }

  // A closed curve about the canvas's middle that does not cross itself.
  std::vector<Vector2> blob(const Vector2& canvas)
  {
    double share[4], turn[4];
    for (int k = 0; k < 4; ++k)
    {
      share[k] = this->in(0.0, 0.18);
      turn[k] = this->in(0.0, 2.0 * pi);
    }
    std::vector<Vector2> samples;
    for (int i = 0; i < 160; ++i)
    {
      const double a = 2.0 * pi * i / 160.0;
      double r = 0.5;
      for (int k = 0; k < 4; ++k)
      {
        r *= 1.0 + share[k] * std::cos((k + 2) * a + turn[k]);
      }
      samples.emplace_back(0.5 * canvas + 0.4 * r * canvas.minCoeff() * Vector2(std::cos(a), std::sin(a)));
    }
    return samples;
  }

  std::shared_ptr<Step> drawing()
  {
    const char* shipped[] = {
      "fish", "heron", "leaf", "mug", "padlock", "figure_body", "figure_head", "figure_hat"
    };
    auto step = std::make_shared<Step>();
    if (this->below(2))
    {
      const std::string name = shipped[this->below(8)], path = OVERSKETCH_DATA_FOLDER "/Drawings/" + name;
      const auto bytes = std::make_shared<const std::string>(oversketch_files::wholeFile(path + ".png"));
      vtkNew<vtkXMLPolyDataReader> reader;
      reader->SetFileName((path + ".vtp").c_str());
      reader->Update();
      *step = withDrawing(*drawingOver({ name + ".png", bytes }), reader->GetOutput());
    }
    else
    {
      const Vector2 canvas(this->in(200.0, 900.0), this->in(200.0, 900.0));
      const View view =
        viewOver({ 0.0, 0.0 }, canvas, static_cast<int>(canvas[0]), static_cast<int>(canvas[1]));
      const auto line = toStrokes({ { seen(this->blob(canvas), view), view } }, { true });
      const auto blank = drawingOn(canvas[0], canvas[1]);
      *step = withDrawing(*blank, drawingOf(strokesOf(line), linesOf(*blank, strokesInput)));
    }
    const char* profiles[] = { "", "linear", "0 0, 0.3 0.8, 1 1" };
    step->values["Levels"] = 1 + this->below(2);
    step->values["Height"] = this->in(0.4, 1.6);
    step->values["Profile"] = std::string(profiles[this->below(3)]);
    step->values["Poisson"] = this->below(4) == 0;
    return step;
  }

  // Beside the mesh or into it, about as large.
  std::shared_ptr<Step> part(vtkPolyData* mesh)
  {
    const std::shared_ptr<Step> step = this->drawing();
    double box[6];
    mesh->GetBounds(box);
    const double size = this->in(0.2, 0.6) * mesh->GetLength();
    const double x = this->in(box[0], box[1]), y = this->in(box[2], box[3]);
    step->part = PartPlace{ { x - size, y - size, x + size, y + size }, this->in(box[4], box[5]) };
    return step;
  }

  std::shared_ptr<Step> oneStroke(const Mesh& mesh, const View& seen)
  {
    auto step = std::make_shared<Step>();
    step->inputs["Stroke"] = Lines(toStroke(this->along(mesh, seen, 0.05, 0.3), seen));
    step->values["Remesh"] = this->below(3);
    return step;
  }

  std::shared_ptr<Step> augment(const Mesh& mesh, const View& seen)
  {
    auto step = std::make_shared<Step>();
    const bool sketch = this->below(5) == 0;
    step->inputs["Strokes"] =
      Lines(toStroke(sketch ? this->along(mesh, seen, 0.03, 0.08) : this->across(mesh, seen), seen));
    step->values["SketchMode"] = sketch ? int(vtkOversketchAugment::Silhouette) : 0;
    step->values["Sharpness"] = this->in(0.3, 3.0);
    step->values["Distance"] = this->below(2);
    return step;
  }

  std::string operations(double size)
  {
    const char* axes[] = { "t", "w", "n" };
    std::ostringstream text;
    text.precision(17);
    for (int i = this->below(3); i >= 0; --i)
    {
      const double at = this->in(0.0, 1.0);
      const char* axis = axes[this->below(3)];
      switch (this->below(5))
      {
        case 0:
          text << "move " << at << " " << axis << " " << this->in(-0.08, 0.12) * size;
          break;
        case 1:
          text << "rotate " << at << " " << axis << " " << this->in(-60.0, 60.0);
          break;
        case 2:
          text << "scale " << at << " " << axis << " " << this->in(0.4, 2.0);
          break;
        case 3:
          text << "drag " << this->in(-25.0, 25.0) << " " << this->in(-25.0, 25.0);
          break;
        default:
          text << "pin " << at << "; move " << this->in(0.0, 1.0) << " n " << this->in(-0.08, 0.12) * size;
      }
      text << (i > 0 ? "; " : "");
    }
    return text.str();
  }

  vtkSmartPointer<vtkPolyData> profile()
  {
    auto line = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    const int count = 3 + this->below(4);
    cells->InsertNextCell(count);
    for (int i = 0; i < count; ++i)
    {
      const double height = i == 0 || i == count - 1 ? 0.0 : this->in(-0.2, 0.6);
      cells->InsertCellPoint(points->InsertNextPoint(static_cast<double>(i) / (count - 1), height, 0.0));
    }
    line->SetPoints(points);
    line->SetLines(cells);
    return line;
  }

  // A line somewhere on the model and a ring round it; or both of an earlier edit, 0 where there is none.
  std::shared_ptr<Step> edit(const Mesh& mesh, const View& seen, double size, int earlier)
  {
    auto step = std::make_shared<Step>();
    if (earlier > 0 && this->below(3) == 0)
    {
      step->inputs["Reference"] = StepOutput{ earlier, 1 };
      step->inputs["Boundary"] = StepOutput{ earlier, 2 };
    }
    else
    {
      const auto v = static_cast<std::size_t>(this->below(static_cast<int>(mesh.points.size())));
      const Vector2 at = seen.toDisplay(mesh.points[v]).head<2>();
      const double turn = this->in(0.0, 2.0 * pi), half = this->in(6.0, 50.0), wave = this->in(0.0, 6.0);
      const double reach = this->in(10.0, 50.0);
      const Vector2 along(std::cos(turn), std::sin(turn)), aside(-along[1], along[0]);
      std::vector<Vector2> line, ring;
      for (int i = 0; i <= 40; ++i)
      {
        const double s = i / 20.0 - 1.0;
        line.emplace_back(at + half * s * along + wave * std::sin(4.0 * s) * aside);
      }
      for (int i = 0; i < 100; ++i)
      {
        const double a = 2.0 * pi * i / 100.0;
        ring.emplace_back(
          at + (half + 0.7 * reach) * std::cos(a) * along + (reach + wave) * std::sin(a) * aside);
      }
      step->inputs["Reference"] = Lines(toStroke(line, seen));
      step->inputs["Boundary"] = Lines(toStroke(ring, seen));
    }
    if (this->below(3) == 0)
    {
      step->inputs["Profile"] = Lines(this->profile());
      step->values["ProfileAt"] = this->in(0.0, 1.0);
      step->values["UseTexture"] = this->below(2) == 1;
    }
    else
    {
      step->values["Operations"] = this->operations(size);
    }
    if (this->below(4) == 0)
    {
      step->values["Layers"] =
        "handle " + std::to_string(this->in(0.2, 0.8)) + " " + std::to_string(this->in(0.0, 1.0));
    }
    step->values["Falloff"] = this->below(2);
    step->values["Rule"] = this->below(3);
    step->values["AsPublished"] = this->below(8) == 0;
    return step;
  }

  // mesh: null at the beginning of a chain that begins with a drawing.
  Node node(int id, vtkPolyData* polyData, int earlierEdit)
  {
    std::shared_ptr<Step> step;
    Node made;
    made.id = id;
    if (!polyData)
    {
      made.name = drawingSystem;
      step = this->drawing();
    }
    else if (this->below(10) == 0)
    {
      made.name = drawingSystem;
      step = this->part(polyData);
    }
    else
    {
      const char* systems[] = { "OneStroke", "Augment", "Edit" };
      made.name = systems[this->below(3)];
      const Mesh mesh = MeshOf(polyData);
      const View seen = this->view(mesh);
      step = made.name == "OneStroke" ? this->oneStroke(mesh, seen)
             : made.name == "Augment" ? this->augment(mesh, seen)
                                      : this->edit(mesh, seen, polyData->GetLength(), earlierEdit);
    }
    step->system = made.name;
    made.step = step;
    return made;
  }

  std::mt19937 generator;
};

// Triangles without area.
int flatOnes(vtkPolyData* polyData)
{
  const Mesh mesh = MeshOf(polyData);
  return static_cast<int>(std::count_if(mesh.triangles.begin(),
    mesh.triangles.end(),
    [&](const Triangle& t)
    {
      const Vector3 a = mesh.points[t[1]] - mesh.points[t[0]], b = mesh.points[t[2]] - mesh.points[t[0]];
      return !(a.cross(b).norm() > 1e-12 * (a.squaredNorm() + b.squaredNorm()));
    }));
}

bool isFinite(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (!Vector3(mesh->GetPoint(i)).allFinite())
    {
      return false;
    }
  }
  return true;
}

} // namespace

TEST(RandomChains, MeshesStaySoundAndSavedSessionsMakeTheSameBits)
{
  oversketch_files::catchMessages();
  const int first = asked("OVERSKETCH_FIRST_CHAIN", static_cast<int>(oversketch_test::firstOfTheDay(6, 300))),
            count = asked("OVERSKETCH_CHAINS", 0);
  std::vector<int> chains{ 47, 89, 185, 188 }; // had triangles without area
  if (count > 0)
  {
    chains.clear();
  }
  for (int i = 0; i < (count > 0 ? count : 6); ++i)
  {
    chains.push_back(first + i);
  }
  std::map<std::string, int> drawn, acted;
  int forests = 0;
  for (const int chain : chains)
  {
    SCOPED_TRACE("chain " + std::to_string(chain));
    Hand hand(chain);
    Session session;
    session.backend = vtkOversketchSystem::Host;
    if (hand.below(2))
    {
      session.meshName = "model.ply";
      session.mesh = modelOf(chain);
    }
    Topology topology = session.mesh ? topologyOf(session.mesh) : Topology();
    Evaluator evaluator;
    std::vector<Outcome> outcomes;
    vtkSmartPointer<vtkPolyData> mesh = session.mesh.own();
    int flat = mesh ? flatOnes(mesh) : 0, edited = 0;
    const int length = 1 + hand.below(6);
    for (int id = 1; id <= length; ++id)
    {
      session.nodes.push_back(hand.node(id, mesh, edited));
      const std::string& system = session.nodes.back().name;
      ++drawn[system];
      ASSERT_TRUE(evaluator.run(session, {}, outcomes));
      const Outcome& outcome = outcomes.back();
      SCOPED_TRACE(std::to_string(id) + " " + system);
      EXPECT_EQ(outcome.failure.text().find("nexpected"), std::string::npos) << outcome.failure;
      if (!outcome.failure.empty())
      {
        std::cout << "chain " << chain << " step " << id << " " << system << ": " << outcome.failure << "\n";
        EXPECT_EQ(outcome.mesh ? digestOf(outcome.mesh) : "", mesh ? digestOf(mesh) : "");
        if (!mesh)
        {
          break; // nothing to go on with
        }
        continue;
      }
      ++acted[system];
      mesh = outcome.mesh;
      ASSERT_TRUE(isFinite(mesh));
      const Topology now = topologyOf(mesh);
      if (system == drawingSystem)
      {
        EXPECT_EQ(now.borders, topology.borders);
        EXPECT_LE(now.euler, topology.euler + 2);
        EXPECT_EQ((now.euler - topology.euler) % 2, 0);
        topology = now;
        flat = flatOnes(mesh);
        EXPECT_EQ(now.borders > 0 ? 0 : flat, 0);
      }
      EXPECT_TRUE(now == topology) << now.euler << " " << now.borders;
      EXPECT_LE(flatOnes(mesh), flat);
      flat = flatOnes(mesh);
      edited = system == "Edit" ? id : edited;
      if (system == "Augment")
      {
        EXPECT_NE(mesh->GetCellData()->GetArray("StellarPath"), nullptr);
      }
      // With points split along seams only the system itself reads the arrays.
      if (mesh->GetCellData()->GetArray("StellarPath") && !mesh->GetPointData()->GetTCoords())
      {
        ++forests;
        expectForest(mesh);
      }
    }
    const auto path =
      std::filesystem::temp_directory_path() /
      ("oversketch-chain-" + std::to_string(chain) + "-" + std::to_string(::getpid()) + ".oversketch");
    writeSession(path.string(), { session, originHere(session.backend), mesh ? digestOf(mesh) : "" });
    const SessionFile saved = readSession(path.string());
    Evaluator again;
    ASSERT_TRUE(again.run(saved.session, {}, outcomes));
    vtkPolyData* result = resultOf(saved.session, outcomes);
    EXPECT_EQ(result ? digestOf(result) : "", saved.digest);
    if (testing::Test::HasFailure())
    {
      FAIL() << "the chain is in " << path;
    }
    std::filesystem::remove(path);
  }
  int all = 0, did = 0;
  for (const auto& [system, count] : drawn)
  {
    std::cout << count << " of " << system << ", " << acted[system] << " acted; ";
    all += count;
    did += acted[system];
    EXPECT_TRUE(acted[system] > count / 4 || count < 8) << system;
  }
  std::cout << forests << " meshes read as 4-8 meshes\n";
  EXPECT_GT(did, all / 3);
  EXPECT_TRUE(drawn.size() == 4 || chains.size() < 12);
}
