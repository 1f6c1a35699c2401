#include "targets.h"

#include "requirements.h"
#include "system_targets.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"
#include "heights.h"
#include "json_files.h"
#include "mesh_file.h"
#include "session_file.h"
#include "texture.h"
#include "upright_picture.h"

#include "vtkOversketchStrokeFilter.h"
#include "vtkOversketchTerrain.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace oversketch;
using namespace oversketch_files;
using namespace oversketch_session;
using oversketch_test::Ear;

namespace oversketch_fuzz
{

namespace
{

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
