#include "vtkOversketchCarriedArrays.h"

#include "Mesh/context.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

namespace oversketch
{

namespace
{

bool NamesLabels(const std::string& name)
{
  static const std::string words =
    " id index indice label region part group material segment class classe cluster chart flag mask seed "
    "object kind type face cell vertex vertice point source treatment mark ";
  const auto isOne = [](const std::string& word)
  { return words.find(" " + word + " ") != std::string::npos; };
  std::string word;
  for (std::size_t i = 0; i <= name.size(); ++i)
  {
    const auto c = static_cast<unsigned char>(i < name.size() ? name[i] : ' ');
    // "EditRegion", "RegionID", "region_2"
    const bool begins = std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]));
    if ((begins || !std::isalpha(c)) && !word.empty())
    {
      if (isOne(word) || (word.back() == 's' && isOne(word.substr(0, word.size() - 1))))
      {
        return true;
      }
      word.clear();
    }
    if (std::isalpha(c))
    {
      word += static_cast<char>(std::tolower(c));
    }
  }
  return false;
}

} // namespace

bool IsMixable(vtkAbstractArray* array)
{
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    return false;
  }
  switch (numbers->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return true;
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
    case VTK_INT:
    case VTK_UNSIGNED_INT:
      return numbers->GetNumberOfComponents() > 1 || !numbers->GetName() || !NamesLabels(numbers->GetName());
    default:
      return false;
  }
}

bool IsNamed(vtkAbstractArray* array, const char* name)
{
  return array->GetName() && std::string(array->GetName()) == name;
}

vtkIntArray* PartNumbers(vtkPolyData* mesh)
{
  constexpr int mostParts = 1000000;
  vtkAbstractArray* array = mesh->GetCellData()->GetAbstractArray("PartId");
  auto* numbers = vtkIntArray::SafeDownCast(array);
  if (array && (!numbers || numbers->GetNumberOfComponents() != 1 ||
                 numbers->GetNumberOfTuples() != mesh->GetNumberOfPolys()))
  {
    throw Error(Failure::BadMesh, "Cell array PartId must hold one int a face.");
  }
  for (vtkIdType f = 0; numbers && f < numbers->GetNumberOfTuples(); ++f)
  {
    if (const int number = numbers->GetValue(f); number < 0 || number > mostParts)
    {
      throw Error(Failure::BadMesh, "Cell array PartId holds %1; parts are counted from 0.", number);
    }
  }
  return numbers;
}

// Without the array's GetRange, which writes to it: threads share meshes.
int HighestPart(vtkIntArray* numbers)
{
  int highest = 0;
  for (vtkIdType f = 0; numbers && f < numbers->GetNumberOfTuples(); ++f)
  {
    highest = std::max(highest, numbers->GetValue(f));
  }
  return highest;
}

void TupleMixer::Put(vtkAbstractArray* to, vtkIdType tuple, const Mix& mix, vtkAbstractArray* from)
{
  this->Ids->SetNumberOfIds(static_cast<vtkIdType>(mix.size()));
  this->Weights.clear();
  for (const auto& [id, weight] : mix)
  {
    this->Ids->SetId(static_cast<vtkIdType>(this->Weights.size()), id);
    this->Weights.push_back(weight);
  }
  if (this->Linear)
  {
    to->InterpolateTuple(tuple, this->Ids, from, this->Weights.data());
  }
  else
  {
    const auto nearest = std::max_element(this->Weights.begin(), this->Weights.end());
    to->SetTuple(tuple, this->Ids->GetId(nearest - this->Weights.begin()), from);
  }
  auto* directions = this->Normals ? vtkDataArray::SafeDownCast(to) : nullptr;
  if (directions && directions->GetNumberOfComponents() == 3)
  {
    Vector3 n;
    directions->GetTuple(tuple, n.data());
    if (n.norm() > 0.0)
    {
      n.normalize();
      directions->SetTuple(tuple, n.data());
    }
  }
}

vtkSmartPointer<vtkAbstractArray> CarriedPoints::Array(vtkAbstractArray* array, bool normals) const
{
  const bool labels = !this->Labels.empty() && IsNamed(array, this->Labels.c_str());
  const Mixes& mixes = labels && this->OfLabels ? this->OfLabels : this->Mixed;
  TupleMixer mixer(IsMixable(array) && !labels, normals);
  auto carried = CarriedArray(array, this->Sources);
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    if (this->Sources[i] < 0)
    {
      const auto point = static_cast<vtkIdType>(i);
      mixer.Put(carried, point, mixes(point), array);
    }
  }
  return carried;
}

void CarryArrays(vtkDataSetAttributes* from,
  vtkDataSetAttributes* to,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray* array, bool normals)>& made)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int attribute = from->IsArrayAnAttribute(i);
    const auto carried = attribute == vtkDataSetAttributes::GLOBALIDS
                           ? nullptr
                           : made(from->GetAbstractArray(i), attribute == vtkDataSetAttributes::NORMALS);
    const int index = carried ? to->AddArray(carried) : -1;
    if (carried && attribute >= 0)
    {
      to->SetActiveAttribute(index, attribute);
    }
  }
}

vtkSmartPointer<vtkAbstractArray> KeptArrays::Provide(vtkAbstractArray* array,
  int use,
  const std::function<vtkSmartPointer<vtkAbstractArray>()>& make)
{
  const vtkMTimeType time = array->GetMTime();
  const auto known = std::find_if(this->Known.begin(),
    this->Known.end(),
    [&](const Item& item) { return item.Source == array && item.Time == time && item.Use == use; });
  this->Asked.push_back({ array, time, use, known != this->Known.end() ? known->Result : make() });
  return this->Asked.back().Result;
}

void KeptArrays::EndRun()
{
  this->Known = std::move(this->Asked);
  this->Asked.clear();
}

vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<Triangle>& triangles)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const auto count = static_cast<vtkIdType>(triangles.size());
  cells->AllocateExact(count, 3 * count);
  for (const Triangle& t : triangles)
  {
    cells->InsertNextCell({ t[0], t[1], t[2] });
  }
  return cells;
}

void WriteCarried(const Mesh& mesh,
  const CarriedPoints& points,
  const std::vector<int>& triangleSources,
  vtkPolyData* input,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> places;
  places->SetDataType(input->GetPoints()->GetDataType());
  places->SetNumberOfPoints(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    places->SetPoint(v, mesh.points[v].data());
  }
  output->SetPoints(places);
  output->SetPolys(CellsOf(mesh.triangles));
  CarryArrays(input->GetPointData(),
    output->GetPointData(),
    [&](vtkAbstractArray* array, bool normals) { return points.Array(array, normals); });
  CopyElements(input->GetCellData(), triangleSources, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  DropHierarchy(output);
}

bool IsStellarArray(const char* name)
{
  const auto same = [name](const char* other) { return name && std::string(name) == other; };
  return std::any_of(std::begin(stellarCellArrays), std::end(stellarCellArrays), same) ||
         std::any_of(std::begin(stellarPointArrays), std::end(stellarPointArrays), same) ||
         std::any_of(std::begin(stellarFieldArrays), std::end(stellarFieldArrays), same);
}

void RemoveStellarArrays(vtkPolyData* mesh)
{
  for (const char* name : stellarPointArrays)
  {
    mesh->GetPointData()->RemoveArray(name);
  }
  for (const char* name : stellarCellArrays)
  {
    mesh->GetCellData()->RemoveArray(name);
  }
  for (const char* name : stellarFieldArrays)
  {
    mesh->GetFieldData()->RemoveArray(name);
  }
}

void DropHierarchy(vtkPolyData* mesh)
{
  if (mesh->GetCellData()->HasArray("StellarPath"))
  {
    RemoveStellarArrays(mesh);
  }
}

} // namespace oversketch
