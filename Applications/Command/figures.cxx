#include "report.h"

#ifdef OVERSKETCH_WITH_AUGMENT
#include "vtkOversketchAugment.h"
#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarDisplace.h"
#endif
#ifdef OVERSKETCH_WITH_EDIT
#include "vtkOversketchEdit.h"
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
#include "vtkOversketchInflateDrawing.h"
#endif
#ifdef OVERSKETCH_WITH_ONESTROKE
#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchOneStroke.h"
#endif

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangle.h"
#include "vtk_jsoncpp.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace oversketch_command
{

namespace
{

Json::Value count(vtkIdType value)
{
  return Json::Value(static_cast<Json::Int64>(value));
}

#ifdef OVERSKETCH_WITH_AUGMENT
template <typename Step>
Step* stepOf(vtkOversketchSystem* system, const char* name)
{
  return Step::SafeDownCast(system->GetStep(name));
}

void addFiguresOf(vtkOversketchAugment* augment, Json::Value& json)
{
  if (auto* base = stepOf<vtkOversketchStellarBase>(augment, "Base"))
  {
    json["base"]["pairs"] = base->GetPairs();
    json["base"]["unpaired"] = base->GetUnpaired();
  }
  for (const char* name : { "Base", "Refine", "Snap", "Smooth", "Displace", "Simplify" })
  {
    vtkPolyData* made = augment->GetInnerOutput(name);
    if (made && made->GetNumberOfPolys() > 0)
    {
      json["faces"][name] = count(made->GetNumberOfPolys());
    }
  }
  for (const auto& [name, word] : { std::pair("Crossings", "crossings"),
         std::pair("Residual", "residual"),
         std::pair("RefusedMoves", "refused_moves"),
         std::pair("FacesAdded", "faces_added"),
         std::pair("FlippedFaces", "flipped_faces"),
         std::pair("IntersectingFaces", "self_intersecting_faces"),
         std::pair("CrestMean", "crest_mean"),
         std::pair("CrestMinimum", "crest_minimum"),
         std::pair("LongestSegment", "longest_curve_segment"),
         std::pair("SmallestAngle", "smallest_angle") })
  {
    json["met"][word] = number(augment->GetFigure(name));
  }
}
#endif

#ifdef OVERSKETCH_WITH_EDIT
void addFiguresOf(vtkOversketchEdit* edit, Json::Value& json)
{
  json["bridges"] = edit->GetBridges();
  json["moved_points"] = edit->GetMovedPoints();
  json["folded_edges"] = edit->GetFoldedEdges();
  json["crossings"] = edit->GetCrossings();
  json["share_seen"] = number(edit->GetShareSeen());
}
#endif

#ifdef OVERSKETCH_WITH_INFLATEDRAWING
// The smallest angle of each face of a flat mesh, ascending [degrees].
std::vector<double> smallestAngles(vtkPolyData* mesh)
{
  std::vector<double> angles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    const vtkIdType count = ids->GetNumberOfIds();
    double least = 180.0;
    for (vtkIdType k = 0; k < count; ++k)
    {
      double here[3], before[3], after[3];
      mesh->GetPoint(ids->GetId(k), here);
      mesh->GetPoint(ids->GetId((k + count - 1) % count), before);
      mesh->GetPoint(ids->GetId((k + 1) % count), after);
      vtkMath::Subtract(before, here, before);
      vtkMath::Subtract(after, here, after);
      least = std::min(least, vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(before, after)));
    }
    angles.push_back(least);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

void addFiguresOf(vtkOversketchInflateDrawing* drawing, Json::Value& json)
{
  vtkPolyData* curves = drawing->GetInnerOutput("Treatment");
  vtkDataArray* roles = curves ? curves->GetCellData()->GetArray("Role") : nullptr;
  const char* const words[] = { "rejected", "unknown", "boundary", "closed feature", "open feature" };
  json["strokes"] = Json::arrayValue;
  for (vtkIdType i = 0; roles && i < roles->GetNumberOfTuples(); ++i)
  {
    json["strokes"].append(words[std::clamp(static_cast<int>(roles->GetComponent(i, 0)), -1, 3) + 1]);
  }
  json["rebuilds"] = drawing->GetRebuilds();
  json["levels"] = drawing->GetLevelsMade();
  for (const char* name : { "CoarseMesh", "QuadMerge", "Refine" })
  {
    vtkPolyData* made = drawing->GetInnerOutput(name);
    if (made && made->GetNumberOfPolys() > 0)
    {
      json["faces"][name] = count(made->GetNumberOfPolys());
    }
  }
  if (vtkPolyData* flat = drawing->GetInnerOutput("Refine"))
  {
    const std::vector<double> angles = smallestAngles(flat);
    if (!angles.empty())
    {
      json["smallest_angle"]["least"] = number(angles.front());
      json["smallest_angle"]["percentile_5"] = number(angles[angles.size() / 20]);
      json["smallest_angle"]["median"] = number(angles[angles.size() / 2]);
    }
  }
}
#endif

#ifdef OVERSKETCH_WITH_ONESTROKE
double fieldOf(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data ? data->GetFieldData()->GetArray(name) : nullptr;
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : std::nan("");
}

vtkIdType pointsOf(vtkPolyData* data)
{
  return data ? data->GetNumberOfPoints() : 0;
}

// Vertices of the region and the share of the area of triangles wholly in it.
Json::Value regionOf(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh ? mesh->GetPointData()->GetArray("Region") : nullptr;
  Json::Value json;
  if (!region)
  {
    return json;
  }
  vtkIdType vertices = 0;
  for (vtkIdType i = 0; i < region->GetNumberOfTuples(); ++i)
  {
    vertices += region->GetComponent(i, 0) != 0.0;
  }
  double inside = 0.0, all = 0.0;
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    double p[3][3];
    bool in = true;
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids[k], p[k]);
      in = in && region->GetComponent(ids[k], 0) != 0.0;
    }
    const double area = vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    all += area;
    inside += in ? area : 0.0;
  }
  json["vertices"] = count(vertices);
  json["of_vertices"] = count(region->GetNumberOfTuples());
  json["area_share"] = number(inside / all);
  return json;
}

Json::Value deformationOf(vtkOversketchLaplacianDeform* step)
{
  Json::Value json;
  if (step)
  {
    json["movable_vertices"] = count(step->GetMovableCount());
    json["active_handles"] = count(step->GetActiveHandleCount());
    json["mean_handle_residual"] = number(step->GetMeanHandleResidual());
    json["maximum_handle_residual"] = number(step->GetMaximumHandleResidual());
  }
  return json;
}

void addFiguresOf(vtkOversketchOneStroke* stroke, Json::Value& json)
{
  vtkPolyData* match = stroke->GetInnerOutput("Match");
  vtkPolyData* targets = stroke->GetInnerOutput("Targets");
  json["remeshed"] = stroke->GetRemeshed();
  json["match"]["distance_px"] = number(fieldOf(match, "Distance"));
  json["match"]["score_px"] = number(fieldOf(match, "Score"));
  json["match"]["points"] = count(pointsOf(match));
  json["targets"]["handles"] = count(pointsOf(targets));
  json["targets"]["section_length"] = number(fieldOf(targets, "SectionLength"));
  json["targets"]["target_length"] = number(fieldOf(targets, "TargetLength"));
  json["region"] = regionOf(stroke->GetInnerOutput("RegionBorder"));
  Json::Value& effect = json["effect"];
  effect["outline_px"] = number(stroke->GetOutlineDistance());
  effect["worst_outline_px"] = number(stroke->GetWorstOutlineDistance());
  effect["outline_back_px"] = number(stroke->GetOutlineBackDistance());
  effect["new_folds"] = stroke->GetNewFolds();
  effect["inside_out"] = number(stroke->GetInsideOut());
  effect["new_crossings"] = stroke->GetNewCrossings();
  effect["stretch"] = number(stroke->GetStretch());
  effect["roughness_before"] = number(stroke->GetRoughnessBefore());
  effect["roughness"] = number(stroke->GetRoughness());
  effect["moved_share"] = number(stroke->GetMovedShare());
  effect["stray_distance_px"] = number(stroke->GetStrayDistance());
  effect["stray_movement_px"] = number(stroke->GetStrayMovement());
  effect["remark"] = stroke->GetRemark();
  json["deformation"] =
    deformationOf(vtkOversketchLaplacianDeform::SafeDownCast(stroke->GetStep(stroke->GetDeformationName())));
}
#endif

} // namespace

void askForFigures([[maybe_unused]] vtkOversketchSystem* system)
{
#ifdef OVERSKETCH_WITH_AUGMENT
  if (auto* displace = stepOf<vtkOversketchStellarDisplace>(system, "Displace"))
  {
    displace->CountIntersectionsOn();
  }
#endif
}

void addFigures([[maybe_unused]] vtkOversketchSystem* system, [[maybe_unused]] Json::Value& json)
{
#ifdef OVERSKETCH_WITH_AUGMENT
  if (auto* augment = vtkOversketchAugment::SafeDownCast(system))
  {
    addFiguresOf(augment, json);
  }
#endif
#ifdef OVERSKETCH_WITH_EDIT
  if (auto* edit = vtkOversketchEdit::SafeDownCast(system))
  {
    addFiguresOf(edit, json["edit"]);
  }
#endif
#ifdef OVERSKETCH_WITH_INFLATEDRAWING
  if (auto* drawing = vtkOversketchInflateDrawing::SafeDownCast(system))
  {
    addFiguresOf(drawing, json);
  }
#endif
#ifdef OVERSKETCH_WITH_ONESTROKE
  if (auto* stroke = vtkOversketchOneStroke::SafeDownCast(system))
  {
    addFiguresOf(stroke, json);
  }
#endif
}

} // namespace oversketch_command
