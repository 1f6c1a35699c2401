// Random hands: chains of one to six strokes that deform or augment a model, in one session. After each the
// mesh has the topology that it had and, where it is a 4-8 mesh, arrays that can be read; the saved session
// makes the same bits. 40 strokes; OVERSKETCH_STROKES=300 and OVERSKETCH_FIRST_CHAIN=NUMBER ask for others,
// a chain is made of its number.
#include "Harness/data.h"
#include "Harness/shipped.h"
#include "sound.h"

#include "Silhouette/outline.h"
#include "evaluator.h"
#include "mesh_file.h"
#include "session_file.h"
#include "vtkOversketchAugment.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchOneStroke.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
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

  Node node(int id, const Mesh& mesh)
  {
    auto step = std::make_shared<Step>();
    const View seen = this->view(mesh);
    if (this->below(2))
    {
      step->system = "OneStroke";
      step->inputs["Stroke"] = Lines(toStroke(this->along(mesh, seen, 0.05, 0.3), seen));
      step->values["Remesh"] = this->below(3);
    }
    else
    {
      step->system = "Augment";
      const bool sketch = this->below(5) == 0;
      step->inputs["Strokes"] =
        Lines(toStroke(sketch ? this->along(mesh, seen, 0.03, 0.08) : this->across(mesh, seen), seen));
      step->values["SketchMode"] = sketch ? int(vtkOversketchAugment::Silhouette) : 0;
      step->values["Sharpness"] = this->in(0.3, 3.0);
      step->values["Distance"] = this->below(2);
    }
    Node made;
    made.id = id;
    made.step = step;
    made.name = step->system;
    return made;
  }

  std::mt19937 generator;
};

} // namespace

TEST(RandomChains, MeshesStaySoundAndSavedSessionsMakeTheSameBits)
{
  oversketch_files::catchMessages();
  const int strokes = asked("OVERSKETCH_STROKES", 40);
  int drawn = 0, acted = 0, forests = 0;
  for (int chain = asked("OVERSKETCH_FIRST_CHAIN", 0); drawn < strokes; ++chain)
  {
    SCOPED_TRACE("chain " + std::to_string(chain));
    Hand hand(chain);
    Session session;
    session.meshName = "model.ply";
    session.mesh = modelOf(chain);
    session.backend = vtkOversketchSystem::Host;
    const Topology topology = topologyOf(session.mesh);
    Evaluator evaluator;
    std::vector<Outcome> outcomes;
    vtkSmartPointer<vtkPolyData> mesh = session.mesh.Get();
    const int length = 1 + hand.below(6);
    for (int id = 1; id <= length; ++id, ++drawn)
    {
      session.nodes.push_back(hand.node(id, MeshOf(mesh)));
      ASSERT_TRUE(evaluator.run(session, {}, outcomes));
      const Outcome& outcome = outcomes.back();
      EXPECT_EQ(outcome.failure.find("nexpected"), std::string::npos) << outcome.failure;
      acted += outcome.failure.empty();
      mesh = outcome.mesh;
      EXPECT_TRUE(topologyOf(mesh) == topology) << id << " " << session.nodes.back().name;
      if (outcome.failure.empty() && session.nodes.back().name == "Augment")
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
    const auto path = std::filesystem::temp_directory_path() /
                      ("oversketch-chain-" + std::to_string(::getpid()) + ".oversketch");
    writeSession(path.string(), { session, originHere(session.backend), digestOf(mesh) });
    const SessionFile saved = readSession(path.string());
    std::filesystem::remove(path);
    Evaluator again;
    ASSERT_TRUE(again.run(saved.session, {}, outcomes));
    EXPECT_EQ(digestOf(resultOf(saved.session, outcomes)), saved.digest);
  }
  std::cout << drawn << " strokes, " << acted << " acted, " << forests << " meshes read as 4-8 meshes\n";
  EXPECT_GT(acted, drawn / 3);
  EXPECT_GT(forests, drawn / 6);
}
