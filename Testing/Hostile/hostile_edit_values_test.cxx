// One region of each mesh of the shared data under values that nobody should ask for: a sound mesh or one
// message, in bounded time and memory, and nothing of it is left when the region is edited again. A share of
// the values on each mesh; OVERSKETCH_HOSTILE_VALUES=all asks for all of them. Skipped, saying so, where the
// folder is absent.
#include "Harness/shipped.h"
#include "hostile_edit.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <cstring>
#include <fstream>
#include <functional>

using namespace oversketch_test;

namespace
{

constexpr double mostMemory = 3072.0; // [MiB] that an edit may take beyond what was in use, a sanitizer's too

struct HostileEditValues : HostileMesh
{
};

// A mesh under a line in a ring.
struct Asked
{
  vtkSmartPointer<vtkPolyData> mesh;
  View view;
  LineAndRing curves;
  double diagonal;
};

enum class Outcome
{
  Either, // a sound mesh or one message
  Refused
};

struct HostileValue
{
  const char* name;
  Outcome outcome;
  std::function<void(vtkOversketchEdit* system, const Asked& asked)> set;
};

// As a new one, but that it knows the region.
void reset(vtkOversketchEdit* system)
{
  system->SetOperations("");
  system->SetLayers("");
  system->SetLevels(5);
  system->SetProfileAt(0.5);
  system->SetFalloffToSmooth();
  system->UseTextureOff();
  system->SetFeather(0.05);
  system->SetRuleToEdit();
  system->AsPublishedOff();
  for (int port = 3; port < 7; ++port)
  {
    system->SetInputConnection(port, nullptr);
  }
}

// "$" in the text is the model's diagonal, so that "move 0.5 n 1e10$" is 1e10 diagonals.
std::string withLengths(std::string text, double diagonal)
{
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$'))
  {
    std::size_t begin = text.find_last_of(' ', at) + 1;
    std::array<char, 64> length{};
    std::snprintf(length.data(),
      length.size(),
      "%.9g",
      std::strtod(text.substr(begin, at - begin).c_str(), nullptr) * diagonal);
    text.replace(begin, at + 1 - begin, length.data());
  }
  return text;
}

void drag(vtkOversketchEdit* system, const Asked& asked)
{
  system->SetOperations(withLengths("move 0.5 n 0.05$", asked.diagonal).c_str());
}

HostileValue operations(Outcome outcome, const char* text)
{
  return { text, outcome, [text](vtkOversketchEdit* system, const Asked& asked) {
            system->SetOperations(withLengths(text, asked.diagonal).c_str());
          } };
}

HostileValue layers(Outcome outcome, const char* text)
{
  return { text,
    outcome,
    [text](vtkOversketchEdit* system, const Asked& asked)
    {
      drag(system, asked);
      system->SetLayers(text);
    } };
}

using Matrix = std::array<double, 16>; // row by row

vtkSmartPointer<vtkPolyData> handlesOf(const std::vector<std::pair<double, Matrix>>& handles)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> places, matrices;
  places->SetName("CurveT");
  matrices->SetName("Matrix");
  matrices->SetNumberOfComponents(16);
  for (const auto& [place, matrix] : handles)
  {
    points->InsertNextPoint(0.0, 0.0, 0.0);
    places->InsertNextValue(place);
    matrices->InsertNextTuple(matrix.data());
  }
  result->SetPoints(points);
  result->GetPointData()->AddArray(places);
  result->GetPointData()->AddArray(matrices);
  return result;
}

constexpr Matrix scaled(double x, double y, double z)
{
  return { x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1 };
}

HostileValue handles(const char* name, Outcome outcome, std::vector<std::pair<double, Matrix>> given)
{
  return { name, outcome, [given](vtkOversketchEdit* system, const Asked&) {
            system->SetHandlesData(handlesOf(given));
          } };
}

HostileValue profile(
  const char* name,
  Outcome outcome,
  std::vector<Vector2> samples,
  const std::function<void(vtkOversketchEdit*)>& also = [](vtkOversketchEdit*) {})
{
  return { name,
    outcome,
    [samples, also](vtkOversketchEdit* system, const Asked&)
    {
      system->SetProfileData(flatCurve(samples));
      also(system);
    } };
}

HostileValue area(const char* name,
  Outcome outcome,
  std::vector<Vector2> samples,
  const char* text = "area 0 9; handle 0.5 0.2")
{
  return { name,
    outcome,
    [samples, text](vtkOversketchEdit* system, const Asked& asked)
    {
      drag(system, asked);
      system->SetAreasData(flatCurve(samples));
      system->SetLayers(text);
    } };
}

HostileValue image(const char* name,
  Outcome outcome,
  const std::function<vtkSmartPointer<vtkImageData>()>& make)
{
  return { name,
    outcome,
    [make](vtkOversketchEdit* system, const Asked& asked)
    {
      drag(system, asked);
      system->SetWeightsData(make());
    } };
}

std::vector<Vector2> arch(double height, double from = 0.0, double to = 1.0)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 60; ++i)
  {
    const double t = from + (to - from) * i / 60.0;
    samples.emplace_back(t, height * std::sin(pi * t));
  }
  return samples;
}

std::vector<Vector2> loop(double radius, int count, const Vector2& at = Vector2::Zero())
{
  std::vector<Vector2> samples;
  for (int i = 0; i < count; ++i)
  {
    const double a = 2.0 * pi * i / count;
    samples.emplace_back(at + radius * Vector2(std::cos(a), std::sin(a)));
  }
  return samples;
}

std::vector<HostileValue> operationValues()
{
  constexpr Outcome refused = Outcome::Refused, either = Outcome::Either;
  return { operations(either, "move 0.5 n 0.05$; move 0.5 n 0.05$"), // two at one place
    operations(either, "rotate 0.5 t 30; move 0.5 n 0.05$; scale 0.5 w 2"),
    operations(either, "move 0 n 0.05$; move 1 n -0.05$"),
    operations(either, "move 0.5 n 0.05$; pin 0.500000000000001"), // as near as numbers go
    operations(refused, "move -1 n 0.05$"),
    operations(refused, "move 2 n 0.05$"),
    operations(refused, "pin 2"),
    operations(refused, "move nan n 0.05$"),
    operations(refused, "scale 0.5 n 0"),
    operations(refused, "scale 0.5 n -1"),
    operations(refused, "scale 0.5 n nan"),
    operations(refused, "scale 0.5 n 1e999"),
    operations(either, "scale 0.5 t 1e5"),
    operations(either, "scale 0.5 w 1e5"),
    operations(either, "scale 0.5 n 1e5"),
    operations(either, "scale 0.5 t 1e-300"),
    operations(either, "scale 0.5 n 1e-300"),
    operations(either, "scale 0.5 n 1e300"),
    operations(refused, "rotate 0.5 t 180"),
    operations(refused, "rotate 0.5 n -180"),
    operations(either, "rotate 0.5 n 179"),
    operations(either, "rotate 0.5 t -179; rotate 0.5 w 179"),
    operations(refused, "rotate 0.5 t 1e6"),
    operations(either, "move 0.5 n 1e10$"),
    operations(either, "move 0.5 t -1e10$"),
    operations(either, "move 0.5 n 1e300"),
    operations(either, "drag 1e9 1e9"),
    operations(refused, "drag nan 0"),
    operations(refused, "drag 1"),
    operations(either, ";;; ;"),
    operations(refused, "lift 0.5 n 0.05$"),
    handles("a singular matrix", refused, { { 0.5, scaled(1, 0, 1) } }),
    handles("a matrix of zeros", refused, { { 0.5, scaled(0, 0, 0) } }),
    handles("a reflection", refused, { { 0.5, scaled(1, 1, -1) } }),
    handles("half a turn", refused, { { 0.5, scaled(-1, -1, 1) } }),
    handles("a perspective", refused, { { 0.5, { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1e-3, 1 } } }),
    handles("a matrix that is not finite", refused, { { 0.5, scaled(1, std::nan(""), 1) } }),
    handles("a huge matrix", either, { { 0.5, scaled(1e200, 1, 1) } }),
    handles("nearly singular", either, { { 0.5, scaled(1, 1e-11, 1) } }),
    handles("a handle at -1", refused, { { -1.0, scaled(1, 1, 2) } }),
    handles("a handle at 2", refused, { { 2.0, scaled(1, 1, 2) } }),
    handles("a handle at no number", refused, { { std::nan(""), scaled(1, 1, 2) } }),
    handles("handles at one place",
      either,
      { { 0.5, scaled(1, 1, 2) }, { 0.5, scaled(1, 2, 1) }, { 0.5, scaled(2, 1, 1) } }),
    { "handles without a matrix",
      refused,
      [](vtkOversketchEdit* system, const Asked&)
      {
        const auto given = handlesOf({ { 0.5, scaled(1, 1, 2) } });
        given->GetPointData()->RemoveArray("Matrix");
        system->SetHandlesData(given);
      } } };
}

std::vector<HostileValue> profileValues()
{
  constexpr Outcome refused = Outcome::Refused, either = Outcome::Either;
  const double nan = std::nan("");
  std::vector<Vector2> turning = arch(0.5, 0.0, 0.7), closing = loop(0.3, 40, { 0.5, 0.4 }),
                       spoilt = arch(0.4);
  for (int i = 0; i <= 20; ++i)
  {
    turning.emplace_back(0.7 - 0.025 * i, 0.4 + 0.02 * i);
  }
  for (int i = 0; i <= 30; ++i)
  {
    turning.emplace_back(0.2 + 0.8 * i / 30.0, 0.8 - 0.8 * i / 30.0);
  }
  closing.push_back(closing.front());
  spoilt[9][1] = nan;
  return { profile("a closed profile", either, closing),
    profile("a profile that turns back", either, turning),
    profile("a profile of one point", either, { { 0.5, 0.5 } }),
    profile("a profile of one place", either, { { 0.5, 0.5 }, { 0.5, 0.5 }, { 0.5, 0.5 } }),
    profile("a profile that is not finite", refused, spoilt),
    profile("a profile 1e6 high", either, arch(1e6)),
    profile("a profile far away", either, { { 1e9, 1e9 }, { 2e9, 1e9 } }),
    profile("a profile straight up",
      either,
      { { 0.0, 0.0 }, { 0.5, 0.0 }, { 0.5, 3.0 }, { 0.5, 0.0 }, { 1.0, 0.0 } }),
    profile("a profile the other way", either, arch(0.4, 1.0, 0.0)),
    profile("a profile at the line's end",
      either,
      arch(0.4),
      [](vtkOversketchEdit* system) { system->SetProfileAt(1.0); }),
    profile("a profile at no number",
      refused,
      arch(0.4),
      [](vtkOversketchEdit* system) { system->SetProfileAt(std::nan("")); }),
    profile("a profile and operations",
      refused,
      arch(0.4),
      [](vtkOversketchEdit* system) { system->SetOperations("pin 0.5"); }),
    { "a profile seen from the plane's edge", either, [](vtkOversketchEdit* system, const Asked& asked) {
       system->SetProfileData(toStroke(lineAbout({ 400.0, 300.0 }), asked.view));
     } } };
}

std::vector<HostileValue> shadingValues()
{
  constexpr Outcome refused = Outcome::Refused, either = Outcome::Either;
  const double nan = std::nan("");
  const auto blank = [](double value) { return imageOf(8, 8, VTK_DOUBLE, 1, value); };
  return { layers(refused, "handle 0.4"),
    layers(either, "handle 0.9 0.1"),                 // drawn far in
    layers(either, "handle 0.2 0.9; handle 0.8 0.1"), // across each other
    layers(refused, "handle nan 0.5"),
    layers(refused, "handle 0.5 1e999"),
    layers(refused, "handle 0.5 0.4; handle 0.5 0.3"),
    layers(refused, "handle 2 0.5"),
    layers(either, "handle 0.5 -3"),
    layers(refused, "area 0 9"), // of none
    layers(refused, "level 9"),
    area("a lasso of a pixel", either, { { 0.001, 0.001 }, { 0.002, 0.001 }, { 0.002, 0.002 } }),
    area("a lasso outside the disc", either, loop(0.2, 30, { 3.0, 3.0 })),
    area("a lasso far outside", refused, loop(1e9, 30)),
    area("a lasso round all", either, loop(2.0, 30)),
    area("a lasso of two samples", either, { { -0.5, 0.0 }, { 0.5, 0.0 } }),
    area("a lasso that is not finite", refused, { { 0.0, 0.0 }, { nan, 0.2 }, { 0.3, 0.3 } }),
    area("an area of huge levels", refused, loop(0.5, 30), "area 0 100000000"),
    area("an area of no level", refused, loop(0.5, 30), "area 0 0"),
    { "feathers all over",
      either,
      [](vtkOversketchEdit* system, const Asked& asked)
      {
        drag(system, asked);
        system->SetAreasData(flatCurve(loop(0.7, 30)));
        system->SetLayers("area 0 9; handle 0.5 0.9");
        system->SetFeather(1.0);
      } },
    { "feathers of no number",
      either,
      [](vtkOversketchEdit* system, const Asked& asked)
      {
        drag(system, asked);
        system->SetAreasData(flatCurve(loop(0.7, 30)));
        system->SetLayers("area 0 9; handle 0.5 0.9");
        system->SetFeather(std::nan(""));
      } },
    { "huge levels",
      either,
      [](vtkOversketchEdit* system, const Asked& asked)
      {
        drag(system, asked);
        system->SetLevels(2000000000);
      } },
    image("an image of one texel", either, [] { return imageOf(1, 1, VTK_UNSIGNED_CHAR, 1, 255.0); }),
    image("an image of 16 bits", either, [] { return imageOf(16, 16, VTK_UNSIGNED_SHORT, 1, 40000.0); }),
    image("an image of RGBA", either, [] { return imageOf(16, 16, VTK_UNSIGNED_CHAR, 4, 200.0); }),
    image("an image of one row", either, [] { return imageOf(4096, 1, VTK_UNSIGNED_CHAR, 1, 255.0); }),
    image("an empty image", refused, [] { return vtkSmartPointer<vtkImageData>::New(); }),
    image("an image of five channels", refused, [] { return imageOf(4, 4, VTK_UNSIGNED_CHAR, 5, 255.0); }),
    image("an image of integers", refused, [] { return imageOf(4, 4, VTK_INT, 1, 1.0); }),
    image("an image over white", refused, [blank] { return blank(1.5); }),
    image("an image of no numbers", refused, [blank, nan] { return blank(nan); }),
    image("an image in depth",
      refused,
      []
      {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(4, 4, 4);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
        std::memset(image->GetScalarPointer(), 255, 64);
        return image;
      }) };
}

// The same by the published rules, and without new triangles.
std::vector<HostileValue> ruleValues()
{
  const auto ruled = [](const char* name, const char* text, int rule, bool published)
  {
    return HostileValue{ name,
      Outcome::Either,
      [=](vtkOversketchEdit* system, const Asked& asked)
      {
        system->SetOperations(withLengths(text, asked.diagonal).c_str());
        system->SetRule(rule);
        system->SetAsPublished(published);
      } };
  };
  return { ruled("stretched by curvature", "scale 0.5 t 1e5", vtkOversketchEdit::Curvature, false),
    ruled("stretched without new triangles", "scale 0.5 t 1e5", vtkOversketchEdit::Off, false),
    ruled("thrown by curvature", "move 0.5 n 1e10$", vtkOversketchEdit::Curvature, false),
    ruled("thrown without new triangles", "move 0.5 n 1e10$", vtkOversketchEdit::Off, false),
    ruled("flattened without new triangles", "scale 0.5 n 1e-300", vtkOversketchEdit::Off, false),
    ruled("turned as published", "rotate 0.5 n 170", vtkOversketchEdit::Edit, true),
    ruled("stretched as published", "scale 0.5 w 1e5", vtkOversketchEdit::Edit, true) };
}

std::vector<HostileValue> hostileValues()
{
  std::vector<HostileValue> all;
  for (const std::vector<HostileValue>& some :
    { operationValues(), profileValues(), shadingValues(), ruleValues() })
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// MiB of the process at its most since the last call; 0 where the system does not tell.
double peakMemory()
{
  double peak = 0.0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind("VmHWM:", 0) == 0)
    {
      peak = std::stod(line.substr(6)) / 1024.0;
    }
  }
  std::ofstream("/proc/self/clear_refs") << 5;
  return peak;
}

// Every how many values one is asked for on a mesh.
int step()
{
  const char* asked = std::getenv("OVERSKETCH_HOSTILE_VALUES");
  return asked && std::string(asked) == "all" ? 1 : 8;
}

} // namespace

TEST_P(HostileEditValues, OfARegionGiveASoundMeshOrOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const Topology topology = topologyOf(polyData);
  const Asked asked{
    polyData, wholeView(mesh, false), hostileCurves(mesh, false).front(), boundingDiagonal(mesh)
  };
  vtkNew<vtkOversketchEdit> system;
  system->SetInputData(0, polyData);
  system->SetReferenceData(asked.curves.line);
  system->SetBoundaryData(asked.curves.ring);
  drag(system, asked);
  if (!soundOrRefused(system, polyData, topology))
  {
    return; // there is no region
  }
  vtkNew<vtkPolyData> before;
  before->DeepCopy(system->GetOutput());
  const std::vector<HostileValue> values = hostileValues();
  const std::vector<std::string> names = meshNames();
  const auto number =
    static_cast<std::size_t>(std::find(names.begin(), names.end(), GetParam()) - names.begin());
  const auto each = static_cast<std::size_t>(step());
  for (std::size_t i = number % each; i < values.size(); i += each)
  {
    SCOPED_TRACE(values[i].name);
    std::cout << values[i].name << ": ";
    reset(system);
    values[i].set(system, asked);
    const double start = (peakMemory(), peakMemory());
    const bool stands = soundOrRefused(system, polyData, topology);
    EXPECT_LT(peakMemory() - start, mostMemory);
    EXPECT_TRUE(!stands || values[i].outcome == Outcome::Either) << "this stands";
    std::cout << (stands ? "stands\n" : "");
  }
  reset(system);
  drag(system, asked);
  ASSERT_TRUE(soundOrRefused(system, polyData, topology));
  EXPECT_TRUE(identical(system->GetOutput(), before)); // of what was asked nothing is left
}

INSTANTIATE_TEST_SUITE_P(SharedData, HostileEditValues, testing::ValuesIn(meshNames()), meshTestName);
