#include "vtkOversketchTraceTools.h"

#include "Mesh/context.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <locale>
#include <sstream>
#include <utility>

namespace oversketch
{

std::vector<Vector2> TracedPlaces(const std::string& list)
{
  std::string words = list;
  std::replace_if(
    words.begin(), words.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  std::istringstream stream(words);
  stream.imbue(std::locale::classic());
  const auto number = [](const std::string& word)
  {
    std::istringstream digits(word);
    digits.imbue(std::locale::classic());
    double value = -1.0;
    return digits >> value && digits.eof() ? value : -1.0;
  };
  std::vector<Vector2> places;
  bool isRight = true;
  for (std::string x, y; isRight && stream >> x;)
  {
    const bool isAuto = x == "auto";
    places.emplace_back(number(x), !isAuto && stream >> y ? number(y) : -1.0);
    isRight = isAuto || places.back().minCoeff() >= 0.0;
  }
  if (!isRight || (places.empty() && !list.empty()))
  {
    throw Error(Failure::BadStroke,
      "{Trace} is \"%1\"; give auto, or places in px of the picture, such as \"120,300\".",
      list);
  }
  return places;
}

vtkSmartPointer<vtkPolyData> JoinedDrawings(vtkPolyData* first, vtkPolyData* second)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkPolyData* one : { first, second })
  {
    vtkPolyData* const other = one == first ? second : first;
    vtkNew<vtkPolyData> whole;
    whole->ShallowCopy(one);
    // The meaning of an array that is absent.
    for (const auto& [name, otherwise] : { std::pair("Magnetic", 0.0),
           std::pair("SnapRadius", 10.0),
           std::pair("Treatment", 0.0),
           std::pair("Depth", 0.0),
           std::pair("Height", 0.0),
           std::pair("CrossSection", 0.0),
           std::pair("Closed", -1.0) })
    {
      if (other->GetCellData()->HasArray(name) && !one->GetCellData()->HasArray(name))
      {
        const auto array =
          vtkSmartPointer<vtkDataArray>::Take(other->GetCellData()->GetArray(name)->NewInstance());
        array->SetName(name);
        array->SetNumberOfTuples(one->GetNumberOfCells());
        array->Fill(otherwise);
        whole->GetCellData()->AddArray(array);
      }
    }
    append->AddInputData(whole);
  }
  append->Update();
  return append->GetOutput();
}

} // namespace oversketch
