#include "targets.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"
#include "heights.h"
#include "mesh_file.h"
#include "parts_file.h"
#include "session_file.h"
#include "texture.h"
#include "upright_picture.h"

#include "vtkOversketchAugment.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchInflateDrawing.h"
#include "vtkOversketchOneStroke.h"
#include "vtkOversketchStellarRefine.h"
#include "vtkOversketchStrokeFilter.h"
#include "vtkOversketchTerrain.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <unistd.h>
#include <utility>

namespace fs = std::filesystem;
using namespace oversketch;
using namespace oversketch_files;
using namespace oversketch_session;
using oversketch_test::Ear;

namespace oversketch_fuzz
{

namespace
{

void require(bool good, const std::string& what)
{
  if (!good)
  {
    throw std::logic_error(what);
  }
}

void requireFinite(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    require(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]), "a point that is not finite");
  }
}

// What a run of a system may end in: a mesh, or one message and none. Whether it is the mesh.
template <class System>
bool requireMeshOrMessage(System* system, const Ear& ear)
{
  vtkPolyData* result = system->GetOutput();
  require(ear.errors.size() < 2, "more than one message");
  require((system->GetErrorCode() != 0) == !ear.errors.empty(),
    "an error code and no message, or the other way round");
  if (!ear.errors.empty())
  {
    require(result->GetNumberOfPoints() == 0, "an error and an output");
    const auto unexpected = static_cast<unsigned long>(Failure::Unexpected);
    require(system->GetErrorCode() - 40000 != unexpected, ear.errors[0]);
    return false;
  }
  requireFinite(result);
  require(result->GetNumberOfPolys() > 0, "no polygon and no message");
  return true;
}

// A folder in memory, where there is one, that goes with the program.
const fs::path& scratch()
{
  struct Folder
  {
    Folder()
    {
      const fs::path memory = "/dev/shm";
      this->path = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
                   ("oversketch-fuzz-" + std::to_string(::getpid()));
      fs::create_directories(this->path);
    }
    ~Folder()
    {
      std::error_code ignored;
      fs::remove_all(this->path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path path;
  };
  static const Folder folder;
  return folder.path;
}

// Writes the bytes to a file, does the work with it, and checks that a refusal names the file.
template <typename Work>
void withFile(const std::string& name, const std::string& bytes, const Work& work)
{
  const std::string path = (scratch() / name).string();
  std::ofstream(path, std::ios::binary) << bytes;
  try
  {
    work(path);
  }
  catch (const Failed& failed)
  {
    require(std::string(failed.what()).find(path) == 0, std::string("no file is named: ") + failed.what());
  }
}

// What could be read can be written in every format and read again, which writeMesh tries.
void writeAgain(vtkPolyData* mesh, const std::string& bytes)
{
  for (vtkIdType i = 0; i < 3 * mesh->GetNumberOfPoints(); ++i)
  {
    if (!(std::abs(mesh->GetPoint(i / 3)[i % 3]) < 1e30))
    {
      return; // no number of single precision
    }
  }
  static const char* const formats[] = { "vtp", "obj", "ply", "stl", "off", "gltf", "glb" };
  const std::string format = formats[std::hash<std::string>()(bytes) % 7];
  const fs::path folder = scratch() / "out";
  fs::create_directories(folder);
  try
  {
    Notes notes;
    writeMesh(mesh, (folder / ("again." + format)).string(), notes);
  }
  catch (const Failed& failed)
  {
    // A mesh all of whose triangles are points in single precision leaves an STL file without any.
    require(format == "stl", failed.what());
  }
  fs::remove_all(folder);
}

Target reader(const std::string& format)
{
  return { format,
    [format](const std::string& bytes)
    {
      withFile("in." + format,
        bytes,
        [&bytes](const std::string& path)
        {
          Notes notes;
          writeAgain(readMesh(path, notes), bytes);
        });
    } };
}

void takeStroke(const std::string& bytes)
{
  withFile("stroke.vtp",
    bytes,
    [](const std::string& path)
    {
      vtkNew<vtkOversketchStrokeFilter> filter;
      const Ear ear(filter);
      filter->SetInputData(readStroke(path));
      filter->Update();
      require((filter->GetErrorCode() != 0) == !ear.errors.empty(),
        "an error code and no message, or the other way round");
      require(ear.errors.size() < 2, "more than one message");
      require(ear.errors.empty() || filter->GetOutput()->GetNumberOfPoints() == 0, "an error and an output");
    });
}

void takePicture(const std::string& bytes)
{
  pictureOf(bytes);
  const std::string upright = uprightPicture(bytes);
  require(
    upright.empty() || upright == bytes || pictureOf(upright), "an upright picture that cannot be read");
}

// A grid of heights, and the terrain of it.
void takeHeights(const std::string& bytes)
{
  try
  {
    const vtkSmartPointer<vtkImageData> image = parseHeights("grid", bytes);
    require(image->GetPointData()->GetScalars() != nullptr, "heights without scalars");
    vtkNew<vtkOversketchTerrain> terrain;
    const Ear ear(terrain);
    terrain->SetInputData(image);
    terrain->SetColumns(8);
    terrain->Update();
    require((terrain->GetErrorCode() != 0) == !ear.errors.empty(),
      "an error code and no message, or the other way round");
    requireFinite(terrain->GetOutput());
  }
  catch (const Failed& failed)
  {
    require(std::string(failed.what()).find("grid: ") == 0, failed.what());
  }
}

// A file of parts that names "mesh.vtp" beside it; where each part goes.
void takeParts(const std::string& bytes)
{
  std::ofstream(scratch() / "mesh.vtp") << "any file";
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(-1.0, 2.0, 0.0);
  corners->InsertNextPoint(3.0, 5.0, 1.0);
  mesh->SetPoints(corners);
  withFile("parts.json",
    bytes,
    [&mesh](const std::string& path)
    {
      const std::vector<oversketch_command::Part> parts = oversketch_command::readParts(path);
      require(!parts.empty(), "no parts and no message");
      for (const oversketch_command::Part& part : parts)
      {
        const Eigen::Matrix4d matrix = oversketch_command::placementOf(part, mesh);
        require(matrix.allFinite() && matrix.determinant() != 0.0, "a placement that is none");
        require(part.source.mesh.empty() != part.source.drawing.empty(), "a part of two things, or of none");
      }
    });
}

// A whole session file.
void takeSession(const std::string& bytes)
{
  withFile("in.oversketch",
    bytes,
    [](const std::string& path)
    {
      const SessionFile file = readSession(path);
      writeSession((scratch() / "again.oversketch").string(), file);
      const SessionFile again = readSession((scratch() / "again.oversketch").string());
      require(again.session.nodes.size() == file.session.nodes.size(), "a session lost steps");
    });
}

// The text of a session alone, beside entries that are sound; what follows a zero byte is one more, "e".
void takeSessionText(const std::string& bytes)
{
  static const auto entry = [](vtkPolyData* data) { return std::make_shared<std::string>(bytesOf(data)); };
  static const View view =
    oversketch_test::orthographicView(Vector3::UnitZ(), Vector3::UnitY(), 100.0, 400, 300);
  static const auto mesh = entry(oversketch_test::toPolyData(oversketch_test::icosphere(0)));
  static const auto stroke =
    entry(oversketch_test::toStroke({ { 100, 100 }, { 200, 150 }, { 300, 100 } }, view));
  const std::size_t cut = std::min(bytes.find('\0'), bytes.size());
  const Package package = { { sessionEntry, std::make_shared<std::string>(bytes.substr(0, cut)) },
    { "m", mesh },
    { "s", stroke },
    { "e", std::make_shared<std::string>(bytes.substr(std::min(cut + 1, bytes.size()))) } };
  try
  {
    const SessionFile file = decode(package, "in");
    require(decode(Encoder().encode(file), "again").session.nodes.size() == file.session.nodes.size(),
      "a session lost steps");
  }
  catch (const Failed& failed)
  {
    require(std::string(failed.what()).find("in") == 0, failed.what());
  }
}

// Numbers from bytes; zeros behind their end.
class Source
{
public:
  explicit Source(const std::string& bytes)
    : Bytes(bytes)
  {
  }
  template <typename T>
  T take()
  {
    T value = 0;
    const std::size_t size = std::min(sizeof value, this->Bytes.size() - this->At);
    std::memcpy(&value, this->Bytes.data() + this->At, size);
    this->At += size;
    return value;
  }
  bool ended() const { return this->At == this->Bytes.size(); }

private:
  const std::string& Bytes;
  std::size_t At = 0;
};

// Tiny meshes of every kind; the first has a limb.
vtkSmartPointer<vtkPolyData> tinyMesh(int which)
{
  Mesh mesh = which == 1   ? oversketch_test::torus(1.0, 0.4, 10, 6)
              : which == 2 ? oversketch_test::cylinder(0.5, 2.0, 8, 6)
                           : oversketch_test::icosphere(which == 0   ? 2
                                                        : which == 3 ? 0
                                                                     : 1);
  for (Vector3& p : mesh.points)
  {
    if (which == 0 && p.x() > 0.6)
    {
      p.x() += 3.0 * (p.x() - 0.6);
    }
    if (which == 4)
    {
      p.z() = 0.0; // two sheets in one plane
    }
  }
  if (which == 5)
  {
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.triangles.push_back({ mesh.triangles[1][0], mesh.triangles[1][0], mesh.triangles[2][0] });
    mesh.points[0] = mesh.points[1];
  }
  return oversketch_test::toPolyData(mesh);
}

View viewFrom(Source& source, int flags)
{
  const auto coordinate = [&source] { return source.take<std::int8_t>() / 32.0; };
  const Vector3 eye(coordinate(), coordinate(), coordinate() + 4.0);
  const int width = 1 + source.take<std::uint16_t>() % 1000, height = 1 + source.take<std::uint16_t>() % 1000;
  return flags & 1 ? oversketch_test::perspectiveView(
                       eye, Vector3::UnitY(), 1.0 + source.take<std::uint8_t>() / 2.0, width, height)
                   : oversketch_test::orthographicView(
                       eye, Vector3::UnitY(), 1.0 + source.take<std::uint8_t>(), width, height);
}

// The same, where the bytes make a view at all: none where the eye is what it looks at.
std::optional<View> anyViewFrom(Source& source, int flags)
{
  try
  {
    return viewFrom(source, flags);
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

// The whole of system A: mesh, options, view and samples from bytes.
void takeOneStroke(const std::string& bytes)
{
  Source source(bytes);
  const auto mesh = tinyMesh(source.take<std::uint8_t>() % 6);
  const int flags = source.take<std::uint8_t>();
  const std::optional<View> view = anyViewFrom(source, flags);
  std::vector<Vector2> samples;
  while (view && !source.ended() && samples.size() < 64)
  {
    samples.emplace_back(source.take<std::int16_t>() / 16.0, source.take<std::int16_t>() / 16.0);
  }
  if (samples.empty())
  {
    return;
  }
  const auto stroke = oversketch_test::toStroke(samples, *view);
  if (flags & 2) // any numbers where the view should be
  {
    vtkDataArray* array =
      stroke->GetCellData()->GetArray(flags & 4 ? "ViewTransform" : "ProjectionTransform");
    double number = 0.0;
    std::memcpy(&number,
      bytes.data() + bytes.size() - std::min<std::size_t>(8, bytes.size()),
      std::min<std::size_t>(8, bytes.size()));
    array->SetComponent(0, flags >> 4, number);
  }
  vtkNew<vtkOversketchOneStroke> system;
  const Ear ear(system);
  system->SetBackendToHost();
  system->SetRemesh(flags & 8 ? vtkOversketchOneStroke::RemeshOff : vtkOversketchOneStroke::RemeshAuto);
  system->SetAsPublished(flags & 128 ? 1 : 0);
  system->SetInputData(0, mesh);
  system->SetStrokeData(stroke);
  system->Update();
  requireMeshOrMessage(system.Get(), ear);
}

// What the bytes say of a length: about the model's size, or any number.
double lengthFrom(Source& source, bool any)
{
  const auto number = source.take<std::int16_t>() / 4096.0;
  return any ? source.take<double>() : number;
}

// Some of a 4-8 mesh's arrays are written over where the bytes say so.
void damage(vtkPolyData* mesh, Source& source, int times)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkFieldData* of : { static_cast<vtkFieldData*>(mesh->GetPointData()),
         static_cast<vtkFieldData*>(mesh->GetCellData()),
         mesh->GetFieldData() })
  {
    for (int i = 0; i < of->GetNumberOfArrays(); ++i)
    {
      arrays.push_back(of->GetArray(i));
    }
  }
  for (; times > 0; --times)
  {
    vtkDataArray* array = arrays[source.take<std::uint8_t>() % arrays.size()];
    const vtkIdType count = array->GetNumberOfTuples();
    if (count > 0)
    {
      array->SetComponent(source.take<std::uint16_t>() % count, 0, source.take<std::int16_t>());
      array->Modified();
    }
  }
}

// The whole of system D: mesh, options, view and strokes from bytes; and once more on a 4-8 mesh that may be
// damaged.
void takeAugment(const std::string& bytes)
{
  Source source(bytes);
  const auto mesh = tinyMesh(source.take<std::uint8_t>() % 6);
  const int flags = source.take<std::uint8_t>(), more = source.take<std::uint8_t>();
  vtkNew<vtkOversketchAugment> system;
  Ear ear(system);
  system->SetBackendToHost();
  system->SetRadius(lengthFrom(source, more & 1));
  system->SetHeight(lengthFrom(source, more & 2));
  system->SetSharpness(lengthFrom(source, more & 4));
  system->SetTargetEdgeLength(lengthFrom(source, more & 8));
  system->SetSketchMode(flags & 2 ? 1 : 0);
  system->SetDistance(flags & 4 ? 1 : 0);
  system->SetOneByOne((flags & 8) != 0);
  system->SetBase(flags & 16 ? 1 : 0);
  system->SetAsPublished((flags & 32) != 0);
  system->SetSimplify((flags & 64) == 0);
  vtkOversketchStellarRefine::SafeDownCast(system->GetStep("Refine"))->SetMaximumFaces(20000);
  const std::optional<View> view = anyViewFrom(source, flags);
  const int faults = more & 128 ? more >> 4 & 7 : 0;
  const std::string faultBytes = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 64));
  vtkNew<vtkAppendPolyData> strokes;
  bool any = false;
  while (view && !source.ended() && strokes->GetNumberOfInputConnections(0) < 4)
  {
    std::vector<Vector2> samples;
    for (int count = source.take<std::uint8_t>() % 32; count > 0 && !source.ended(); --count)
    {
      samples.emplace_back(source.take<std::int16_t>() / 16.0, source.take<std::int16_t>() / 16.0);
    }
    if (!samples.empty())
    {
      strokes->AddInputData(oversketch_test::toStroke(samples, *view));
      any = true;
    }
  }
  if (!any)
  {
    return;
  }
  strokes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  strokes->Update();
  system->SetInputData(0, mesh);
  system->SetInputData(1, strokes->GetOutput());
  for (int round = 0; round < 2; ++round)
  {
    ear.errors.clear();
    system->Modified();
    system->Update();
    if (!requireMeshOrMessage(system.Get(), ear))
    {
      return;
    }
    vtkNew<vtkPolyData> again;
    again->DeepCopy(system->GetOutput());
    Source of(faultBytes);
    damage(again, of, faults);
    system->SetInputData(0, again);
  }
}

// A closed surface, but for tunnels without walls: every edge of two faces, wound against each other.
void requireClosed(vtkPolyData* surface)
{
  std::set<std::pair<vtkIdType, vtkIdType>> ways;
  vtkNew<vtkIdList> face;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    surface->GetCellPoints(i, face);
    const vtkIdType count = face->GetNumberOfIds();
    for (vtkIdType k = 0; k < count; ++k)
    {
      require(
        ways.emplace(face->GetId(k), face->GetId((k + 1) % count)).second, "an edge twice the same way");
    }
  }
  for (const auto& [from, to] : ways)
  {
    require(ways.count({ to, from }) == 1, "an open edge");
  }
}

// The whole of system C: options and strokes from bytes, over a canvas of 256 px.
void takeDrawing(const std::string& bytes)
{
  Source source(bytes);
  const int flags = source.take<std::uint8_t>(), more = source.take<std::uint8_t>();
  static const View view =
    oversketch_test::orthographicView(Vector3::UnitZ(), Vector3::UnitY(), 128.0, 256, 256);
  vtkNew<vtkOversketchInflateDrawing> system;
  const Ear ear(system);
  system->SetExtrudeDepth(flags & 1 ? lengthFrom(source, more & 1) : 0.0);
  system->SetHeight(flags & 2 ? lengthFrom(source, more & 2) : 1.0);
  static const char* const profiles[] = { "", "linear", "step", "0 0, 0.3 0.8, 1 1" };
  system->SetProfile(profiles[more >> 2 & 3]);
  system->SetPoisson((flags & 4) != 0);
  system->SetQuads((flags & 8) != 0);
  system->SetLevels(more >> 4 & 3);
  system->SetArrange((more & 64) != 0);
  system->SetAsPublished((flags & 16) != 0);
  vtkNew<vtkAppendPolyData> strokes;
  bool any = false;
  while (!source.ended() && strokes->GetNumberOfInputConnections(0) < 8)
  {
    const int kind = source.take<std::uint8_t>();
    const bool closed = (kind & 1) != 0;
    std::vector<Vector2> samples;
    for (int count = kind >> 3; count > 0 && !source.ended(); --count)
    {
      samples.emplace_back(source.take<std::uint16_t>() / 256.0, source.take<std::uint16_t>() / 256.0);
    }
    if (samples.empty())
    {
      continue;
    }
    if (closed)
    {
      samples.push_back(samples.front());
    }
    const auto stroke = oversketch_test::toStroke(samples, view);
    vtkNew<vtkIntArray> treatment;
    treatment->SetName("Treatment");
    treatment->InsertNextValue(kind >> 1 & 3);
    stroke->GetCellData()->AddArray(treatment);
    strokes->AddInputData(stroke);
    any = true;
  }
  if (!any)
  {
    return;
  }
  strokes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  strokes->Update();
  system->SetInputData(0, strokes->GetOutput());
  system->Update();
  const bool isMesh = requireMeshOrMessage(system.Get(), ear);
  if (isMesh && !system->GetAsPublished()) // which cuts tunnels without walls, and leaves what turned over
  {
    requireClosed(system->GetOutput());
  }
}

} // namespace

const std::vector<Target>& targets()
{
  static const std::vector<Target> all = []
  {
    catchMessages();
    vtkSMPTools::Initialize(1);
    std::vector<Target> made;
    for (const char* format : { "ply", "obj", "off", "stl", "gltf", "glb", "vtp" })
    {
      made.push_back(reader(format));
    }
    made.push_back({ "stroke", takeStroke });
    made.push_back({ "picture", takePicture });
    made.push_back({ "heights", takeHeights });
    made.push_back({ "parts", takeParts });
    made.push_back({ "session", takeSession });
    made.push_back({ "session_text", takeSessionText });
    made.push_back({ "one_stroke", takeOneStroke });
    made.push_back({ "augment", takeAugment });
    made.push_back({ "drawing", takeDrawing });
    return made;
  }();
  return all;
}

} // namespace oversketch_fuzz
