#include "vtkOversketchMirror.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchMirror);

namespace
{

using Triple = std::array<double, 3>;

Triple tripleOf(vtkDataArray* array, vtkIdType i)
{
  Triple value{};
  array->GetTuple(i, value.data());
  return value;
}

double distance2(const Triple& a, const Triple& b)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  }
  return sum;
}

} // namespace

int vtkOversketchMirror::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* before = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* after = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      const vtkIdType count = before->GetNumberOfPoints();
      if (count == 0 && after->GetNumberOfPoints() == 0)
      {
        return;
      }
      if (after->GetNumberOfPoints() != count)
      {
        throw Error(Failure::BadMesh,
          "The deformed mesh has %1 points, the mesh before %2: deform without remeshing.",
          after->GetNumberOfPoints(),
          count);
      }
      output->ShallowCopy(after);
      const auto axis = static_cast<std::size_t>(this->Axis);
      const double offset = this->Offset;
      const double sign = this->Side == Above ? 1.0 : -1.0;
      const double tolerance = this->Tolerance * before->GetLength();
      const auto reflected = [&](Triple p, double about)
      {
        p[axis] = about == 0.0 ? -p[axis] : 2.0 * about - p[axis];
        return p;
      };
      vtkDataArray* from = before->GetPoints()->GetData();
      vtkDataArray* to = after->GetPoints()->GetData();
      vtkDataArray* normalsBefore = before->GetPointData()->GetNormals();
      vtkDataArray* normalsAfter = normalsBefore ? after->GetPointData()->GetNormals() : nullptr;
      vtkNew<vtkPoints> points;
      points->SetDataType(to->GetDataType());
      points->SetNumberOfPoints(count);
      vtkDataArray* made = points->GetData();
      made->SetName(to->GetName());
      vtkSmartPointer<vtkDataArray> normals;
      if (normalsAfter)
      {
        normals.TakeReference(normalsAfter->NewInstance());
        normals->DeepCopy(normalsAfter);
      }
      // First everything as before on the other side and as after on the chosen one.
      for (vtkIdType i = 0; i < count; ++i)
      {
        const double height = sign * (from->GetComponent(i, this->Axis) - offset);
        const bool other = height < -tolerance;
        made->SetTuple(i, tripleOf(other ? from : to, i).data());
        if (std::abs(height) <= tolerance)
        {
          made->SetComponent(i, this->Axis, from->GetComponent(i, this->Axis));
        }
        if (normals && other)
        {
          normals->SetTuple(i, tripleOf(normalsBefore, i).data());
        }
      }
      const std::vector<char> masked = MaskedPointsOf(before);
      const auto isMasked = [&masked](vtkIdType i)
      { return !masked.empty() && masked[static_cast<std::size_t>(i)] != 0; };
      vtkNew<vtkStaticPointLocator> locator;
      locator->SetDataSet(before);
      locator->BuildLocator();
      vtkNew<vtkIdList> near;
      for (vtkIdType i = 0; i < count; ++i)
      {
        if (i % 4096 == 0 && this->GetAbortExecute())
        {
          throw Error(Failure::Cancelled, "cancelled");
        }
        const Triple old = tripleOf(from, i);
        if (sign * (old[axis] - offset) <= tolerance || old == tripleOf(to, i))
        {
          continue;
        }
        const Triple place = reflected(old, offset);
        locator->FindPointsWithinRadius(tolerance, place.data(), near);
        if (near->GetNumberOfIds() == 0)
        {
          throw Error(Failure::BadMesh,
            "Point %1 moved, but the mesh has no point where the plane %2 = %3 reflects it to: the mesh is "
            "not symmetric there; deform it without symmetry.",
            i,
            "xyz"[axis],
            offset);
        }
        // Several points lie in one place along seams: each is followed by all of its mirrored place, with
        // the normals that are most alike.
        for (vtkIdType k = 0; k < near->GetNumberOfIds(); ++k)
        {
          if (!isMasked(near->GetId(k)))
          {
            made->SetTuple(near->GetId(k), reflected(tripleOf(to, i), offset).data());
          }
        }
        if (normals)
        {
          const Triple wanted = reflected(tripleOf(normalsBefore, i), 0.0);
          vtkIdType best = near->GetId(0);
          double least = std::numeric_limits<double>::infinity();
          std::sort(near->GetPointer(0), near->GetPointer(0) + near->GetNumberOfIds());
          for (vtkIdType k = 0; k < near->GetNumberOfIds(); ++k)
          {
            const double gap = distance2(wanted, tripleOf(normalsBefore, near->GetId(k)));
            if (gap < least)
            {
              least = gap;
              best = near->GetId(k);
            }
          }
          normals->SetTuple(best, reflected(tripleOf(normalsAfter, i), 0.0).data());
        }
      }
      output->SetPoints(points);
      if (normals)
      {
        output->GetPointData()->SetNormals(normals);
      }
    });
}

void vtkOversketchMirror::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Axis: " << this->Axis << '\n'
     << indent << "Offset: " << this->Offset << '\n'
     << indent << "Side: " << (this->Side == Above ? "Above" : "Below") << '\n'
     << indent << "Tolerance: " << this->Tolerance << '\n';
}
