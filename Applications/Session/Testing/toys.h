// Two small systems beside the real ones, for the tests: one makes a mesh of strokes and, where there is one,
// a picture; one moves a mesh by what is on two other ports.
#ifndef oversketch_applications_session_testing_toys_h
#define oversketch_applications_session_testing_toys_h

#include "parameters.h"
#include "session.h"

#include "vtkOversketchSystem.h"

#include "Harness/polydata.h"
#include "Harness/shapes.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace oversketch_test
{

// Strokes on port 0, a picture on port 1, which may be absent: a ball as large as the strokes have points, a
// tenth larger with a picture, with texture coordinates, and on output 1 the line of its first three points.
class Blow : public vtkOversketchSystem
{
public:
  static Blow* New() { VTK_STANDARD_NEW_BODY(Blow); }
  vtkTypeMacro(Blow, vtkOversketchSystem);
  vtkSetMacro(Label, std::string);
  vtkGetMacro(Label, std::string);

protected:
  Blow()
  {
    this->SetNumberOfInputPorts(2);
    this->SetNumberOfOutputPorts(2);
  }
  int FillInputPortInformation(int port, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const auto count = static_cast<double>(vtkPolyData::GetData(inputs[0])->GetNumberOfPoints());
    const double size = count * (inputs[1]->GetNumberOfInformationObjects() > 0 ? 1.1 : 1.0);
    oversketch::Mesh ball = icosphere(1);
    for (auto& point : ball.points)
    {
      point *= size;
    }
    vtkPolyData* made = vtkPolyData::GetData(outputs, 0);
    made->ShallowCopy(toPolyData(ball));
    vtkNew<vtkFloatArray> places;
    places->SetName("TCoords");
    places->SetNumberOfComponents(2);
    for (const auto& point : ball.points)
    {
      places->InsertNextTuple2(point[0], point[1]);
    }
    made->GetPointData()->SetTCoords(places);
    vtkPolyData* rim = vtkPolyData::GetData(outputs, 1);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1, 2 });
    for (int i = 0; i < 3; ++i)
    {
      points->InsertNextPoint(ball.points[static_cast<std::size_t>(i)].data());
    }
    rim->SetPoints(points);
    rim->SetLines(lines);
    return 1;
  }

private:
  std::string Label;
};

// A mesh on port 0, curves on ports 1 and 2: moves the mesh along z by Height and the number of points of the
// one less that of the other, as often as Times says; Down turns it round; Shift comes on top.
class Lift : public vtkOversketchSystem
{
public:
  static Lift* New() { VTK_STANDARD_NEW_BODY(Lift); }
  vtkTypeMacro(Lift, vtkOversketchSystem);
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  vtkSetClampMacro(Times, int, 1, 10);
  vtkGetMacro(Times, int);
  vtkSetMacro(Down, bool);
  vtkGetMacro(Down, bool);
  void SetShift(const std::vector<double>& shift)
  {
    this->Shift = shift;
    this->Modified();
  }
  const std::vector<double>& GetShift() const { return this->Shift; }

protected:
  Lift() { this->SetNumberOfInputPorts(3); }
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
    const auto up = static_cast<double>(vtkPolyData::GetData(inputs[1])->GetNumberOfPoints() -
                                        vtkPolyData::GetData(inputs[2])->GetNumberOfPoints());
    const double by = this->Times * (this->Height + up) * (this->Down ? -1.0 : 1.0);
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    output->ShallowCopy(mesh);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->DeepCopy(mesh->GetPoints());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      points->SetPoint(i, p[0] + this->Shift[0], p[1] + this->Shift[1], p[2] + by);
    }
    output->SetPoints(points);
    return 1;
  }

private:
  double Height = 1.0;
  int Times = 1;
  bool Down = false;
  std::vector<double> Shift{ 0.0, 0.0 };
};

// The real systems and the two.
inline const std::vector<oversketch_session::SystemRow>& rowsWithToys()
{
  using namespace oversketch_session;
  using Kind = SystemInput::Kind;
  static const std::vector<SystemRow> rows = []
  {
    std::vector<SystemRow> all = systems();
    SystemRow blow;
    blow.name = "Blow";
    blow.verb = "blow";
    blow.make = []() -> vtkSmartPointer<vtkOversketchSystem> { return vtkSmartPointer<Blow>::New(); };
    blow.inputs = { { "Drawing", "drawing", "", Kind::Stroke, 0 },
      { "Picture", "picture", "", Kind::Picture, 1, true } };
    blow.parameters = { parameter<Blow>("Label", &Blow::SetLabel, &Blow::GetLabel, "label", "", "") };
    blow.textureInput = "Picture";
    all.push_back(withDefaults(blow));
    SystemRow lift;
    lift.name = "Lift";
    lift.verb = "lift";
    lift.make = []() -> vtkSmartPointer<vtkOversketchSystem> { return vtkSmartPointer<Lift>::New(); };
    lift.inputs = { { "Mesh", "mesh", "", Kind::Mesh, 0 },
      { "Up", "up", "", Kind::Curves, 1 },
      { "Against", "against", "", Kind::Curves, 2 } };
    lift.parameters = { parameter<Lift>("Height", &Lift::SetHeight, &Lift::GetHeight, "height", "", ""),
      parameter<Lift>("Times", &Lift::SetTimes, &Lift::GetTimes, "times", "", ""),
      parameter<Lift>("Down", &Lift::SetDown, &Lift::GetDown, "down", "", ""),
      parameter<Lift>("Shift", &Lift::SetShift, &Lift::GetShift, "shift", "", "") };
    all.push_back(withDefaults(lift));
    return all;
  }();
  return rows;
}

// A line of so many points.
inline oversketch_session::Lines lineOf(int count)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    lines->InsertCellPoint(points->InsertNextPoint(i, 0.5 * i, 0.0));
  }
  data->SetPoints(points);
  data->SetLines(lines);
  return oversketch_session::Lines(data);
}

inline oversketch_session::Image picture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 36, static_cast<unsigned char>(90));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { "photo.png",
    std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes->GetPointer(0)),
      static_cast<std::size_t>(bytes->GetNumberOfValues())) };
}

inline oversketch_session::Node nodeOf(int id,
  const std::string& system,
  std::map<std::string, oversketch_session::Input> inputs,
  oversketch_session::Values values = {})
{
  auto step = std::make_shared<oversketch_session::Step>();
  step->system = system;
  step->inputs = std::move(inputs);
  step->values = std::move(values);
  oversketch_session::Node node;
  node.id = id;
  node.step = step;
  node.name = system + std::to_string(id);
  return node;
}

// A ball of three points' size, lifted by a line of five against the rim of the ball, which has three.
inline oversketch_session::Session liftedBall()
{
  oversketch_session::Session session;
  session.nodes = { nodeOf(1, "Blow", { { "Drawing", lineOf(3) } }),
    nodeOf(2, "Lift", { { "Up", lineOf(5) }, { "Against", oversketch_session::StepOutput{ 1, 1 } } }) };
  return session;
}

} // namespace oversketch_test
#endif
