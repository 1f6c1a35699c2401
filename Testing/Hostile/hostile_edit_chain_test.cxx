// Edits one after the other on closed models: a sound model stays one, and so the next edit finds a region
// that is a disc, whatever was turned and scaled before. OVERSKETCH_EDITS asks for another number of chains.
#include "hostile_edit.h"

#include "Harness/shipped.h"

#include <random>

using namespace oversketch_test;

namespace
{

constexpr int editsOfAChain = 4;

struct EditedModel
{
  std::string name;
  vtkSmartPointer<vtkPolyData> mesh;
  LineAndRing curves;
};

std::vector<EditedModel> editedModels()
{
  std::vector<EditedModel> models{ { "dinosaur",
    shippedModel("dinosaur"),
    { "crest", shippedStroke("dinosaur_crest"), shippedStroke("dinosaur_crest_ring") } } };
  for (const char* name : { "bear", "hand" })
  {
    const auto mesh = shippedModel(name);
    models.push_back({ name, mesh, hostileCurves(MeshOf(mesh), false).front() });
  }
  return models;
}

// Wild, but of what may be asked.
std::string wildOperations(std::mt19937& random, double diagonal)
{
  const auto between = [&random](double low, double high)
  { return low + (high - low) * static_cast<double>(random() % 10001) / 1e4; };
  std::string all;
  for (unsigned i = 0, count = 1 + random() % 2; i < count; ++i)
  {
    const char axis = "twn"[random() % 3];
    const double t = between(0.1, 0.9);
    std::array<char, 128> text{};
    switch (random() % 3)
    {
      case 0:
        std::snprintf(text.data(), text.size(), "rotate %.3f %c %.2f; ", t, axis, between(-120.0, 120.0));
        break;
      case 1:
        std::snprintf(
          text.data(), text.size(), "move %.3f %c %.6g; ", t, axis, diagonal * between(-0.1, 0.1));
        break;
      default:
        std::snprintf(
          text.data(), text.size(), "scale %.3f %c %.3f; ", t, axis, std::exp(between(-1.5, 1.0)));
    }
    all += text.data();
  }
  return all;
}

} // namespace

TEST(HostileEditChain, EditsOneAfterTheOtherLeaveASoundModel)
{
  const char* asked = std::getenv("OVERSKETCH_EDITS");
  const unsigned chains = asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 2;
  int stood = 0, refused = 0;
  for (const EditedModel& model : editedModels())
  {
    const Topology topology = topologyOf(model.mesh);
    for (unsigned seed = 0; seed < chains; ++seed)
    {
      std::mt19937 random(seed);
      vtkSmartPointer<vtkPolyData> mesh = model.mesh, line = model.curves.line, ring = model.curves.ring;
      for (int edit = 0; edit < editsOfAChain; ++edit)
      {
        const std::string operations = wildOperations(random, model.mesh->GetLength());
        SCOPED_TRACE(model.name + ", chain " + std::to_string(seed) + ", edit " + std::to_string(edit) +
                     ": " + operations);
        vtkNew<vtkOversketchEdit> system;
        system->SetInputData(0, mesh);
        system->SetReferenceData(line);
        system->SetBoundaryData(ring);
        system->SetOperations(operations.c_str());
        if (!soundOrRefused(system, mesh, topology))
        {
          ++refused;
          break;
        }
        ++stood;
        mesh = system->GetOutput();
        // The curves that it put out, or the strokes once more.
        const bool strokes = random() % 3 == 0;
        line = strokes ? model.curves.line.Get() : system->GetReferenceOutput();
        ring = strokes ? model.curves.ring.Get() : system->GetBoundaryOutput();
      }
    }
  }
  std::cout << stood << " edits stand, " << refused << " are refused\n";
  EXPECT_GT(stood, 10 * refused);
}
