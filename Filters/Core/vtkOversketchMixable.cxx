#include "vtkOversketchMixable.h"

#include "vtkDataArray.h"

#include <cctype>
#include <set>
#include <string>

namespace oversketch
{

namespace
{

bool NamesLabels(const std::string& name)
{
  static const std::set<std::string> words{ "id",
    "index",
    "indice",
    "label",
    "region",
    "part",
    "group",
    "material",
    "segment",
    "class",
    "classe",
    "cluster",
    "chart",
    "flag",
    "mask",
    "seed",
    "object",
    "kind",
    "type",
    "face",
    "cell",
    "vertex",
    "vertice",
    "point",
    "source",
    "treatment",
    "mark" };
  std::string word;
  for (std::size_t i = 0; i <= name.size(); ++i)
  {
    const auto c = static_cast<unsigned char>(i < name.size() ? name[i] : ' ');
    // "EditRegion", "RegionID", "region_2"
    const bool begins = std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]));
    if ((begins || !std::isalpha(c)) && !word.empty())
    {
      if (words.count(word) || (word.back() == 's' && words.count(word.substr(0, word.size() - 1))))
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

} // namespace oversketch
