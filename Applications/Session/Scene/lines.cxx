#include "lines.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace oversketch_session
{

namespace
{

constexpr std::int32_t endOfArrays = -2; // where the next array's attribute would be, -1 or more

std::array<vtkFieldData*, 3> arraysOf(vtkPolyData* data)
{
  return { data->GetPointData(), data->GetCellData(), data->GetFieldData() };
}

std::size_t bytesOf(vtkDataArray* array)
{
  const auto values = static_cast<std::size_t>(array->GetNumberOfValues());
  return array->GetDataType() == VTK_BIT ? (values + 7) / 8
                                         : values * static_cast<std::size_t>(array->GetDataTypeSize());
}

class Packer
{
public:
  std::string take()
  {
    this->Bytes.shrink_to_fit();
    return std::move(this->Bytes);
  }

  void pack(vtkPolyData* data)
  {
    this->put<char>(data->GetPoints() != nullptr);
    if (data->GetPoints())
    {
      this->array(data->GetPoints()->GetData());
    }
    for (vtkCellArray* cells : { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
    {
      this->cells(cells);
    }
    for (vtkFieldData* arrays : arraysOf(data))
    {
      this->arrays(arrays);
    }
  }

private:
  template <typename T>
  void put(T value)
  {
    this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const char* text)
  {
    const std::size_t length = text ? std::strlen(text) : 0;
    this->put<std::int32_t>(text ? static_cast<std::int32_t>(length) : -1);
    this->Bytes.append(text ? text : "", length);
  }
  void array(vtkAbstractArray* array)
  {
    this->put<std::int32_t>(array->GetDataType());
    this->put<std::int32_t>(array->GetNumberOfComponents());
    this->put<std::int64_t>(array->GetNumberOfTuples());
    this->text(array->GetName());
    this->put<char>(array->HasAComponentName());
    for (int c = 0; array->HasAComponentName() && c < array->GetNumberOfComponents(); ++c)
    {
      this->text(array->GetComponentName(c));
    }
    if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
      {
        this->text(texts->GetValue(i).c_str());
      }
      return;
    }
    vtkSmartPointer<vtkDataArray> numbers = vtkDataArray::SafeDownCast(array);
    if (!numbers->HasStandardMemoryLayout())
    {
      numbers = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
      numbers->DeepCopy(array);
    }
    this->Bytes.append(static_cast<const char*>(numbers->GetVoidPointer(0)), bytesOf(numbers));
  }
  // Ids as they follow on each other, which along a line is mostly by one.
  void cells(vtkCellArray* cells)
  {
    this->put<std::int64_t>(cells->GetNumberOfCells());
    auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(size, ids);
      bool inOrder = true;
      for (vtkIdType k = 1; k < size; ++k)
      {
        inOrder = inOrder && ids[k] == ids[k - 1] + 1;
      }
      this->put<std::int64_t>(size);
      this->put<char>(inOrder);
      for (vtkIdType k = 0; k < (inOrder ? std::min<vtkIdType>(size, 1) : size); ++k)
      {
        this->put<std::int64_t>(ids[k]);
      }
    }
  }
  void arrays(vtkFieldData* arrays)
  {
    auto* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = arrays->GetAbstractArray(i);
      if (vtkDataArray::SafeDownCast(array) || vtkStringArray::SafeDownCast(array))
      {
        this->put<std::int32_t>(attributes ? attributes->IsArrayAnAttribute(i) : -1);
        this->array(array);
      }
    }
    this->put<std::int32_t>(endOfArrays);
  }

  std::string Bytes;
};

class Unpacker
{
public:
  explicit Unpacker(const std::string& bytes)
    : At(bytes.data())
  {
  }

  void unpack(vtkPolyData* data)
  {
    if (this->get<char>())
    {
      vtkNew<vtkPoints> points;
      points->SetData(vtkDataArray::SafeDownCast(this->array()));
      data->SetPoints(points);
    }
    vtkNew<vtkCellArray> verts, lines, polys, strips;
    for (vtkCellArray* cells : { verts.Get(), lines.Get(), polys.Get(), strips.Get() })
    {
      this->cells(cells);
    }
    data->SetVerts(verts);
    data->SetLines(lines);
    data->SetPolys(polys);
    data->SetStrips(strips);
    for (vtkFieldData* arrays : arraysOf(data))
    {
      this->arrays(arrays);
    }
  }

private:
  template <typename T>
  T get()
  {
    T value;
    std::memcpy(&value, this->At, sizeof value);
    this->At += sizeof value;
    return value;
  }
  // With whether it is there at all.
  std::pair<bool, std::string> text()
  {
    const auto length = this->get<std::int32_t>();
    if (length < 0)
    {
      return { false, {} };
    }
    std::string text(this->At, static_cast<std::size_t>(length));
    this->At += length;
    return { true, std::move(text) };
  }
  vtkSmartPointer<vtkAbstractArray> array()
  {
    const auto type = this->get<std::int32_t>();
    auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
    array->SetNumberOfComponents(this->get<std::int32_t>());
    array->SetNumberOfTuples(this->get<std::int64_t>());
    if (const auto [named, name] = this->text(); named)
    {
      array->SetName(name.c_str());
    }
    const bool named = this->get<char>() != 0;
    for (int c = 0; named && c < array->GetNumberOfComponents(); ++c)
    {
      if (const auto [has, name] = this->text(); has)
      {
        array->SetComponentName(c, name.c_str());
      }
    }
    if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
      {
        texts->SetValue(i, this->text().second);
      }
      return array;
    }
    auto* numbers = vtkDataArray::SafeDownCast(array);
    std::memcpy(numbers->GetVoidPointer(0), this->At, bytesOf(numbers));
    this->At += bytesOf(numbers);
    return array;
  }
  void cells(vtkCellArray* cells)
  {
    for (auto left = this->get<std::int64_t>(); left > 0; --left)
    {
      const auto size = static_cast<vtkIdType>(this->get<std::int64_t>());
      const bool inOrder = this->get<char>() != 0;
      cells->InsertNextCell(static_cast<int>(size));
      vtkIdType id = 0;
      for (vtkIdType k = 0; k < size; ++k)
      {
        id = inOrder && k > 0 ? id + 1 : static_cast<vtkIdType>(this->get<std::int64_t>());
        cells->InsertCellPoint(id);
      }
    }
  }
  void arrays(vtkFieldData* arrays)
  {
    auto* attributes = vtkDataSetAttributes::SafeDownCast(arrays);
    for (auto attribute = this->get<std::int32_t>(); attribute != endOfArrays;
         attribute = this->get<std::int32_t>())
    {
      const int index = arrays->AddArray(this->array());
      if (attributes && attribute >= 0)
      {
        attributes->SetActiveAttribute(index, attribute);
      }
    }
  }

  const char* At;
};

} // namespace

Lines::Lines(vtkPolyData* data)
{
  if (data)
  {
    Packer packer;
    packer.pack(data);
    this->Held = std::make_shared<const std::string>(packer.take());
  }
}

vtkSmartPointer<vtkPolyData> Lines::own() const
{
  if (!this->Held)
  {
    return nullptr;
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  Unpacker(*this->Held).unpack(data);
  return data;
}

} // namespace oversketch_session
