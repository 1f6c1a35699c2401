#include "vtkOversketchDistanceField.h"

#include "Shading/fields.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchShadingTools.h"

#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchDistanceField);

namespace
{

// An array of the mesh's points, `outside` but where the patch has a value.
template <typename Array, typename Value>
vtkSmartPointer<vtkDataArray> meshArray(const char* name,
  vtkIdType points,
  double outside,
  const std::vector<int>& vertices,
  const std::vector<Value>& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfTuples(points);
  array->Fill(outside);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(vertices[i], values[i]);
  }
  return array;
}

void requireSmoothing(double value, const char* name)
{
  if (!(value >= 0.0 && value <= 10.0))
  {
    throw Error(Failure::BadStroke, "{%1} is not within 0 and 10; set another.", name);
  }
}

} // namespace

void vtkOversketchDistanceField::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* reference = vtkPolyData::GetData(inputs[1]);
  requireSmoothing(this->FieldSmoothing, "FieldSmoothing");
  requireSmoothing(this->ParameterSmoothing, "ParameterSmoothing");
  FieldRules rules;
  rules.straight = this->AsPublished || this->Measure == EUCLIDEAN;
  rules.smoothing = this->AsPublished ? 0.0 : this->FieldSmoothing;
  rules.parameterSmoothing = this->AsPublished ? 0.0 : this->ParameterSmoothing;
  const StepKey key({ InsideKey(mesh), ChainsKey(reference) },
    { static_cast<double>(rules.straight), rules.smoothing, rules.parameterSmoothing });
  const auto& arrays = this->Kept<KeptValue<std::vector<vtkSmartPointer<vtkDataArray>>>>().Provide(key,
    [&]
    {
      ++this->FieldCount;
      std::vector<int> chain = VerticesOnce(ReadChain(reference, mesh, "reference curve"));
      const InsidePatch inside = InsideOf(mesh, false);
      for (int& vertex : chain)
      {
        vertex = inside.Numbers[vertex];
      }
      const CurveFields fields = curveFields(inside.Patch, chain, rules, ContextOf(this));
      const vtkIdType points = mesh->GetNumberOfPoints();
      const std::vector<int>& vertices = inside.Vertices;
      return std::vector<vtkSmartPointer<vtkDataArray>>{
        meshArray<vtkDoubleArray>("CurveDistance", points, 1.0, vertices, fields.share),
        meshArray<vtkDoubleArray>("CurveParameter", points, 0.0, vertices, fields.parameter),
        meshArray<vtkIntArray>("CurveSide", points, 0.0, vertices, fields.side)
      };
    });
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->ShallowCopy(mesh);
  for (vtkDataArray* array : arrays)
  {
    output->GetPointData()->AddArray(array);
  }
}

void vtkOversketchDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measure: " << this->Measure << "\n";
  os << indent << "FieldSmoothing: " << this->FieldSmoothing << "\n";
  os << indent << "ParameterSmoothing: " << this->ParameterSmoothing << "\n";
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "FieldCount: " << this->FieldCount << "\n";
}
