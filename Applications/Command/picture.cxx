#include "picture.h"

#include "files.h"
#include "film.h"
#include "terminal.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSystem.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCullerCollection.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImageShrink3D.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

using oversketch::Vector2;
using oversketch::View;

using Colour = std::array<double, 3>;
constexpr Colour red{ 0.85, 0.10, 0.12 };
constexpr Colour yellow{ 0.96, 0.80, 0.10 };
constexpr Colour green{ 0.10, 0.58, 0.22 };
constexpr Colour blue{ 0.13, 0.33, 0.80 };
constexpr Colour orange{ 1.00, 0.66, 0.26 };
constexpr Colour clay{ 0.86, 0.86, 0.87 };
constexpr Colour white{ 1.0, 1.0, 1.0 };

using Place = std::array<float, 3>;

Place placeOf(vtkPolyData* data, vtkIdType point)
{
  double p[3];
  data->GetPoint(point, p);
  return { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) };
}

// The mesh in camera space, so that the lights stand still in the picture whatever the view, without the
// seams of its texture; coloured by whether a point is one of the region's.
vtkSmartPointer<vtkPolyData> modelOf(vtkPolyData* mesh, vtkPolyData* region, const View& view)
{
  std::set<Place> moved;
  for (vtkIdType i = 0; i < region->GetNumberOfPoints(); ++i)
  {
    moved.insert(placeOf(region, i));
  }
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  vtkNew<vtkCleanPolyData> weld;
  weld->SetInputData(bare);
  weld->SetTolerance(0.0);
  weld->Update();
  vtkPolyData* whole = weld->GetOutput();
  vtkNew<vtkPolyData> model;
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    oversketch::Vector3 world;
    whole->GetPoint(i, world.data());
    points->InsertNextPoint((view.viewTransform() * world.homogeneous()).head<3>().eval().data());
    const Colour& colour = moved.count(placeOf(whole, i)) > 0 ? orange : clay;
    for (int c = 0; c < 3; ++c)
    {
      colours->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * colour[c])));
    }
  }
  model->SetPoints(points);
  model->SetPolys(whole->GetPolys());
  model->GetPointData()->SetScalars(colours);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(model);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

// The stroke's camera over geometry given in camera space. Near and far of the stroke's own matrix mean
// nothing: the depth row is made to enclose the model.
void aim(vtkCamera* camera, const View& view, const double bounds[6])
{
  Eigen::Matrix4d projection = view.projectionTransform();
  const double margin = 0.01 * (bounds[5] - bounds[4]) + 1e-9 * std::abs(bounds[4]);
  double nearest = bounds[5] + margin, farthest = bounds[4] - margin;
  if (view.perspective())
  {
    nearest = std::min(nearest, 1e-3 * farthest); // in front of the eye
  }
  const auto w = [&](double z) { return projection(3, 2) * z + projection(3, 3); };
  const double slope = (w(nearest) + w(farthest)) / (farthest - nearest);
  projection.row(2) << 0.0, 0.0, slope, -w(nearest) - slope * nearest;
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 16; ++i)
  {
    matrix->SetElement(i / 4, i % 4, projection(i / 4, i % 4));
  }
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelProjection(!view.perspective());
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
}

void addLamp(vtkRenderer* renderer,
  double x,
  double y,
  double z,
  double r,
  double g,
  double b,
  double intensity)
{
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(x, y, z);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetColor(r, g, b);
  lamp->SetIntensity(intensity);
  renderer->AddLight(lamp);
}

// A polyline in pixels as a flat ribbon with round joints and ends.
vtkSmartPointer<vtkActor> ribbonOf(const std::vector<Vector2>& line,
  double width,
  const Colour& colour,
  double z)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  const auto fan = [&](const std::vector<Vector2>& corners)
  {
    polys->InsertNextCell(static_cast<int>(corners.size()));
    for (const Vector2& corner : corners)
    {
      polys->InsertCellPoint(points->InsertNextPoint(corner[0], corner[1], z));
    }
  };
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    std::vector<Vector2> disc;
    for (int k = 0; k < 20; ++k)
    {
      const double angle = k * 0.31415926535897931;
      disc.push_back(line[i] + 0.5 * width * Vector2(std::cos(angle), std::sin(angle)));
    }
    fan(disc);
    const Vector2 along = i + 1 < line.size() ? Vector2(line[i + 1] - line[i]) : Vector2(0.0, 0.0);
    if (along.norm() > 0.0)
    {
      const Vector2 side = 0.5 * width * Vector2(-along[1], along[0]).normalized();
      fan({ line[i] - side, line[i + 1] - side, line[i + 1] + side, line[i] + side });
    }
  }
  vtkNew<vtkPolyData> ribbon;
  ribbon->SetPoints(points);
  ribbon->SetPolys(polys);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(ribbon);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  return actor;
}

struct Ink
{
  std::vector<Vector2> line; // [px]
  Colour colour;
};

std::vector<Ink> inkOf(vtkPolyData* data, const View* view, const Colour& colour)
{
  std::vector<Ink> lines;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(data->GetLines()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    lines.push_back({ {}, colour });
    for (vtkIdType k = 0; k < size; ++k)
    {
      oversketch::Vector3 p;
      data->GetPoint(ids[k], p.data());
      lines.back().line.push_back((view ? view->toDisplay(p) : p).head<2>());
    }
  }
  return lines;
}

// The model under the lamps of the gallery.
vtkSmartPointer<vtkActor> light(vtkRenderer* scene, vtkPolyData* model)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(model);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPhong();
  property->SetAmbient(0.24);
  property->SetDiffuse(0.80);
  property->SetSpecular(0.10);
  property->SetSpecularPower(25.0);
  // Surfaces that turn away darken a little, which draws the contour as ink would.
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl",
    true,
    "//VTK::Light::Impl\n"
    "  gl_FragData[0].rgb *= mix(0.50, 1.0, smoothstep(0.0, 0.40, abs(normalVCVSOutput.z)));\n",
    false);

  scene->GetCullers()->RemoveAllItems(); // they know nothing of an explicit projection
  scene->SetBackground(0.93, 0.93, 0.92);
  scene->SetBackground2(1.0, 1.0, 1.0);
  scene->GradientBackgroundOn();
  scene->AutomaticLightCreationOff();
  scene->AddActor(actor);
  addLamp(scene, -0.45, 0.80, 0.75, 1.0, 0.98, 0.94, 0.80);
  addLamp(scene, 0.90, 0.10, 0.55, 0.90, 0.94, 1.0, 0.28);
  addLamp(scene, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.24);
  return actor;
}

// A polydata with the strokes alone that share the first one's view, which the picture is taken from.
vtkSmartPointer<vtkPolyData> ofFirstView(vtkPolyData* strokes)
{
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  kept->SetPoints(strokes->GetPoints());
  kept->AllocateEstimate(strokes->GetNumberOfCells(), 2);
  vtkCellData* data = strokes->GetCellData();
  kept->GetCellData()->CopyAllOn();
  kept->GetCellData()->CopyAllocate(data);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < strokes->GetNumberOfCells(); ++cell)
  {
    bool same = true;
    for (const char* name : { "ViewTransform", "ProjectionTransform", "ViewportSize" })
    {
      vtkDataArray* array = data->GetArray(name);
      for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
      {
        same = same && array->GetComponent(cell, c) == array->GetComponent(0, c);
      }
    }
    if (same)
    {
      strokes->GetCellPoints(cell, ids);
      kept->GetCellData()->CopyData(data, cell, kept->InsertNextCell(strokes->GetCellType(cell), ids));
    }
  }
  return kept;
}

// The lines that a picture of a system shows: what it took hold of, and the strokes.
std::vector<Ink> inkOf(const SystemRow& row,
  vtkOversketchSystem* system,
  vtkPolyData* strokes,
  const View& view)
{
  vtkNew<vtkPolyData> hold;
  system->GetHold(hold);
  std::vector<Ink> drawn = inkOf(strokes, nullptr, red);
  if (const Parameter* mode = findParameter(row, "SketchMode")) // of strokes that raise and carve
  {
    vtkDataArray* heights = strokes->GetCellData()->GetArray("Height");
    const double usual = std::get<double>(findParameter(row, "Height")->get(system));
    const bool isOutline = mode->get(system) == Value(1);
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      const double height = heights ? heights->GetComponent(static_cast<vtkIdType>(i), 0) : usual;
      drawn[i].colour = isOutline ? green : height < 0.0 ? yellow : red;
    }
    if (!isOutline)
    {
      return drawn; // curves lie under the strokes, or on the far side
    }
  }
  std::vector<Ink> lines = inkOf(hold, &view, blue);
  lines.insert(lines.end(), drawn.begin(), drawn.end());
  return lines;
}

// The lines over everything, each with a white rim.
void draw(vtkRenderer* ink, const std::vector<Ink>& lines, const View& view)
{
  const double thickness = std::clamp(view.height() / 170.0, 2.0, 8.0);
  double z = 0.0;
  for (const Ink& one : lines)
  {
    ink->AddActor(ribbonOf(one.line, 1.5 * thickness, white, z + 1.0));
    ink->AddActor(ribbonOf(one.line, thickness, one.colour, z + 2.0));
    z += 2.0;
  }
  vtkCamera* page = ink->GetActiveCamera();
  page->ParallelProjectionOn();
  page->SetPosition(0.5 * view.width(), 0.5 * view.height(), z + 100.0);
  page->SetFocalPoint(0.5 * view.width(), 0.5 * view.height(), 0.0);
  page->SetParallelScale(0.5 * view.height());
  page->SetClippingRange(1.0, z + 200.0);
}

// A window off the screen that draws renderers over each other, in a view's viewport size.
class Film
{
public:
  Film(const View& view, const std::vector<vtkRenderer*>& layers, std::string path)
    : Width(view.width())
    , Height(view.height())
    , Path(std::move(path))
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(this->Factor * this->Width, this->Factor * this->Height);
    this->Window->SetNumberOfLayers(static_cast<int>(layers.size()));
    for (vtkRenderer* layer : layers)
    {
      this->Window->AddRenderer(layer);
    }
  }

  // Throws Failed, naming the path.
  vtkSmartPointer<vtkImageData> frame() const
  {
    takeError();
    this->Window->Render();
    // Not vtkWindowToImageFilter: in VTK 9.1 it renders with copies of the cameras that lack the explicit
    // projection.
    const int columns = this->Factor * this->Width, rows = this->Factor * this->Height;
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, columns - 1, rows - 1, 0, pixels);
    vtkNew<vtkImageData> image;
    image->SetDimensions(columns, rows, 1);
    image->GetPointData()->SetScalars(pixels);
    vtkNew<vtkImageShrink3D> smaller;
    smaller->SetInputData(image);
    smaller->SetShrinkFactors(this->Factor, this->Factor, 1);
    smaller->MeanOn();
    smaller->Update();
    if (!takeError().empty())
    {
      throw Failed(this->Path + ": the picture could not be rendered; does the display have OpenGL 3.2?");
    }
    return smaller->GetOutput();
  }

private:
  int Width, Height;
  // Larger and averaged: smooth edges without depending on the driver's multisampling.
  int Factor = std::clamp(4096 / std::max(this->Width, this->Height), 1, 3);
  std::string Path;
  vtkNew<vtkRenderWindow> Window;
};

} // namespace

void requireDisplay()
{
  // VTK ends the program when it cannot open the display, so it is tried first; by hand, because libX11 is
  // VTK's dependency and not ours.
  bool there = false;
  if (void* library = ::dlopen("libX11.so.6", RTLD_LAZY))
  {
    auto open = reinterpret_cast<void* (*)(const char*)>(::dlsym(library, "XOpenDisplay"));
    auto close = reinterpret_cast<int (*)(void*)>(::dlsym(library, "XCloseDisplay"));
    if (void* display = open && close ? open(nullptr) : nullptr)
    {
      there = true;
      close(display);
    }
  }
  if (!there)
  {
    throw Failed(
      "--picture and --turntable need a display to render with, and there is none; run the command under "
      "xvfb-run -a");
  }
}

void writePicture(const SystemRow& row,
  vtkOversketchSystem* system,
  vtkPolyData* strokes,
  const std::string& path,
  NewFiles& files)
{
  const vtkSmartPointer<vtkPolyData> shown = ofFirstView(strokes);
  const View view = oversketch::ViewOf(shown);
  vtkNew<vtkPolyData> region;
  system->GetRegion(region);
  vtkNew<vtkRenderer> scene, ink;
  const vtkSmartPointer<vtkPolyData> model = modelOf(system->GetOutput(), region, view);
  light(scene, model);
  aim(scene->GetActiveCamera(), view, model->GetBounds());
  ink->SetLayer(1);
  draw(ink, inkOf(row, system, shown, view), view);

  writePng(path, Film(view, { scene.Get(), ink.Get() }, path).frame(), files);
}

void writeTurntable(vtkOversketchSystem* system,
  vtkPolyData* strokes,
  const std::string& path,
  NewFiles& files)
{
  const View view = oversketch::ViewOf(ofFirstView(strokes));
  vtkNew<vtkPolyData> region;
  system->GetRegion(region);
  const vtkSmartPointer<vtkPolyData> model = modelOf(system->GetOutput(), region, view);
  // Its camera stands still, so the model is turned: by as much to the other side.
  oversketch::Vector3 middle;
  system->GetOutput()->GetCenter(middle.data());
  middle = (view.viewTransform() * middle.homogeneous()).head<3>().eval();
  const Eigen::Matrix3d turned = view.viewTransform().topLeftCorner<3, 3>();
  const int up = std::abs(turned(1, 1)) >= std::abs(turned(1, 2)) ? 1 : 2;
  const oversketch::Vector3 axis = turned.col(up);
  const double reach = model->GetLength();
  const double swept[6] = { 0.0, 0.0, 0.0, 0.0, middle[2] - reach, middle[2] + reach };
  vtkNew<vtkRenderer> scene;
  const vtkSmartPointer<vtkActor> actor = light(scene, model);
  aim(scene->GetActiveCamera(), view, swept);
  actor->SetOrigin(middle.data());
  const Film film(view, { scene.Get() }, path);
  const auto frame = [&](int number)
  {
    throwIfInterrupted();
    showProgress(double(number) / framesOfTurn, "turntable");
    actor->SetOrientation(0.0, 0.0, 0.0);
    actor->RotateWXYZ(-360.0 * number / framesOfTurn, axis[0], axis[1], axis[2]);
    return film.frame();
  };
  writeFilm(path, framesOfTurn, frame, files);
  clearProgress();
}

} // namespace oversketch_command
