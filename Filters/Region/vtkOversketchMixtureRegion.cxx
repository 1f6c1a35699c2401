#include "vtkOversketchMixtureRegion.h"

#include "Mixture/device_mixture.h"
#include "Region/grow.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

using namespace oversketch;

namespace
{

// What the whole mesh's mixture depends on besides the mesh and its diameters: components, samples, seed,
// back end.
using FitKey = std::tuple<int, int, int, int>;
// What the region depends on besides that: lambda, tolerance, section and end length, amendments.
using GrowthKey = std::tuple<double, double, double, double, bool, bool, bool, bool>;

std::vector<double> DiametersOf(vtkDataArray* array)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!std::isfinite(values[i]))
    {
      std::ostringstream message;
      message << "Array ShapeDiameter of the mesh is not finite at point " << i
              << "; compute it with vtkOversketchShapeDiameter.";
      throw Error(Failure::BadMesh, message.str());
    }
  }
  return values;
}

double SectionLengthOf(vtkPolyData* handles)
{
  vtkDataArray* array = handles->GetFieldData()->GetArray("SectionLength");
  const double length = array && array->GetNumberOfValues() == 1 ? array->GetComponent(0, 0)
                                                                 : std::numeric_limits<double>::quiet_NaN();
  if (!(length >= 0.0))
  {
    throw Error(Failure::MissingArray,
      "The handles have no field array SectionLength of one value, the length of the matched section: make "
      "them with "
      "vtkOversketchTargets, or turn LimitRunaway and ReachEnds off.");
  }
  return length;
}

// What the region reads of the handles.
struct Section
{
  std::vector<int> seeds; // the vertices that the section's edges end at, ascending
  std::array<std::vector<int>, 2>
    ends; // of each margin those that the stroke moves, and the seeds next to it
};

Section SectionOf(vtkPolyData* handles, int vertexCount, double margin, bool reachEnds)
{
  const vtkIdType count = handles->GetNumberOfPoints();
  if (count == 0)
  {
    throw Error(Failure::BadRegion, "There are no handles to grow a region from; match a stroke first.");
  }
  const std::string remedy = "take them from vtkOversketchTargets";
  vtkPointData* data = handles->GetPointData();
  const std::vector<Binding> bindings = ReadBindings(handles, vertexCount, "handles", remedy);
  vtkDataArray* positions = RequireArray(data, "RelativePosition", 1, count, "handles", remedy);
  std::vector<double> moves(static_cast<std::size_t>(count), 0.0);
  double moving = 0.0;
  if (reachEnds)
  {
    vtkDataArray* targets = RequireArray(data, "UnmergedTarget", 3, count, "handles", remedy);
    for (vtkIdType h = 0; h < count; ++h)
    {
      Vector3 place, target;
      handles->GetPoint(h, place.data());
      targets->GetTuple(h, target.data());
      moves[h] = (target - place).norm();
    }
    // Less is a hand that follows the outline.
    moving = std::max(0.05 * *std::max_element(moves.begin(), moves.end()), 0.001 * SectionLengthOf(handles));
  }
  Section section;
  const auto add = [&](vtkIdType h, std::vector<int>& list)
  {
    const Binding& binding = bindings[static_cast<std::size_t>(h)];
    for (int k = 0; k < 3; ++k)
    {
      if (binding.weights[k] > 0.0)
      {
        list.push_back(binding.vertices[k]);
      }
    }
  };
  vtkIdType first = -1, last = -1; // seeds by position
  for (vtkIdType h = 0; h < count; ++h)
  {
    const double position = positions->GetComponent(h, 0);
    if (position >= margin && position <= 1.0 - margin)
    {
      add(h, section.seeds);
      first = first < 0 || position < positions->GetComponent(first, 0) ? h : first;
      last = last < 0 || position > positions->GetComponent(last, 0) ? h : last;
    }
    else if (moves[h] > moving)
    {
      add(h, section.ends[position < margin ? 0 : 1]);
    }
  }
  if (first >= 0)
  {
    add(first, section.ends[0]);
    add(last, section.ends[1]);
  }
  for (std::vector<int>* list : { &section.seeds, &section.ends[0], &section.ends[1] })
  {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return section;
}

template <typename Array, typename Values>
vtkSmartPointer<vtkDataArray> ArrayOf(const char* name, const Values& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<typename Array::ValueType>(values[i]));
  }
  return array;
}

std::vector<double> Pick(const std::vector<double>& values, const std::vector<int>& indices)
{
  std::vector<double> picked;
  picked.reserve(indices.size());
  for (int i : indices)
  {
    picked.push_back(values[static_cast<std::size_t>(i)]);
  }
  return picked;
}

} // namespace

struct vtkOversketchMixtureRegion::Cache
{
  std::shared_ptr<const MeshData> Data, PartsData;
  MeshParts Parts; // of PartsData
  // The whole mesh.
  MeshKey MeshRead;
  FitKey FitRead;
  std::vector<double> Diameters, Scaled;
  Mixture Whole;
  // The region.
  GrowthKey GrowthRead;
  Section SectionRead;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; // empty: none kept

  MixtureFit Fit(vtkOversketchMixtureRegion* self, const std::vector<double>& samples, int components);
};

// On the device where the back end asks for it; should it be missing or fail, on the host, with a warning.
MixtureFit vtkOversketchMixtureRegion::Cache::Fit(vtkOversketchMixtureRegion* self,
  const std::vector<double>& samples,
  int components)
{
  MixtureOptions options;
  options.components = components;
  std::string warning;
  if (const auto device = Device::choose(static_cast<oversketch::Backend>(self->Backend), warning))
  {
    try
    {
      MixtureFit fit = fitMixtureOnDevice(*device, samples, options);
      self->BackendUsed = BACKEND_OPENCL;
      return fit;
    }
    catch (const Error& error)
    {
      warning = std::string(error.what()) + " The host computes instead.";
    }
  }
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(self, << warning);
  }
  self->BackendUsed = BACKEND_HOST;
  return fitMixture(samples, options, ContextOf(self, 0.0, 0.4));
}

vtkStandardNewMacro(vtkOversketchMixtureRegion);

vtkOversketchMixtureRegion::vtkOversketchMixtureRegion()
  : Internals(new Cache)
{
  this->SetNumberOfInputPorts(2);
}

vtkOversketchMixtureRegion::~vtkOversketchMixtureRegion() = default;

void vtkOversketchMixtureRegion::SetHandlesData(vtkPolyData* handles)
{
  this->SetInputData(1, handles);
}

int vtkOversketchMixtureRegion::RequestData(vtkInformation*,
  vtkInformationVector** inputs,
  vtkInformationVector* outputs)
{
  return RunFilter(this,
    [&]
    {
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      vtkPolyData* handles = vtkPolyData::GetData(inputs[1]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (input->GetNumberOfPoints() == 0)
      {
        return;
      }
      Cache& cache = *this->Internals;
      cache.Data = SharedMesh(input);
      const MeshData& mesh = *cache.Data;
      vtkDataArray* diameters = RequireArray(input->GetPointData(),
        "ShapeDiameter",
        1,
        input->GetNumberOfPoints(),
        "mesh",
        "compute it with vtkOversketchShapeDiameter");
      const Section section =
        SectionOf(handles, mesh.Surface.vertexCount(), this->SeedMargin, this->ReachEnds);
      const std::vector<int>& seeds = section.seeds;
      const double sectionLength = this->LimitRunaway ? SectionLengthOf(handles) : 0.0;
      // Edge paths are up to half as long again as the way, and a foreshortened end as it looks.
      const double endLength = this->ReachEnds ? 2.0 * this->SeedMargin * SectionLengthOf(handles) : 0.0;

      const MeshKey meshKey(input, { diameters, input->GetPointData()->GetNormals() });
      const FitKey fitKey(this->Components, this->MaximumSamples, this->Seed, this->Backend);
      if (cache.MeshRead != meshKey || cache.FitRead != fitKey || cache.Whole.empty())
      {
        cache.Whole.clear();
        cache.Arrays.clear();
        cache.Diameters = DiametersOf(diameters);
        const auto [low, high] = std::minmax_element(cache.Diameters.begin(), cache.Diameters.end());
        const double from = *low, range = *high - *low;
        cache.Scaled.resize(cache.Diameters.size());
        std::transform(cache.Diameters.begin(),
          cache.Diameters.end(),
          cache.Scaled.begin(),
          [&](double d) { return range > 0.0 ? (d - from) / range : 0.0; });
        const std::vector<double> samples = Pick(
          cache.Scaled, drawWithoutReplacement(mesh.Surface.vertexCount(), this->MaximumSamples, this->Seed));
        ++this->WholeFitCount;
        this->WholeSampleCount = static_cast<vtkIdType>(samples.size());
        cache.Whole = cache.Fit(this, samples, this->Components).mixture;
        cache.MeshRead = meshKey;
        cache.FitRead = fitKey;
      }

      const GrowthKey growthKey(this->Lambda,
        this->SeedTolerance,
        sectionLength,
        endLength,
        this->FillIslands,
        this->LimitRunaway,
        this->CutAtJunction,
        this->ReachEnds);
      if (cache.Arrays.empty() || cache.GrowthRead != growthKey || cache.SectionRead.seeds != seeds ||
          cache.SectionRead.ends != section.ends)
      {
        cache.Arrays.clear();
        ++this->GrowthCount;
        RegionEvidence evidence{ seeds, {}, cache.Diameters, sectionLength, section.ends, endLength };
        if (!seeds.empty())
        {
          const std::vector<int> around = expandSeeds(mesh.Surface,
            mesh.Neighbours,
            seeds,
            3 * static_cast<std::size_t>(this->Components),
            this->SeedTolerance * 0.5 * boundingDiagonal(mesh.Surface));
          const std::vector<double> known = Pick(cache.Scaled, around);
          const std::vector<double> samples = Pick(
            known, drawWithoutReplacement(static_cast<int>(known.size()), this->MaximumSamples, this->Seed));
          const Mixture foreground =
            cache.Fit(this, samples, std::clamp(static_cast<int>(samples.size()) / 3, 1, this->Components))
              .mixture;
          evidence.ratio.resize(cache.Scaled.size());
          ContextOf(this).parallelFor(mesh.Surface.vertexCount(),
            [&](int begin, int end)
            {
              for (int v = begin; v < end; ++v)
              {
                evidence.ratio[v] =
                  logDensity(foreground, cache.Scaled[v]) - logDensity(cache.Whole, cache.Scaled[v]);
              }
            });
        }
        const RegionOptions options{
          this->Lambda, this->FillIslands, this->LimitRunaway, this->CutAtJunction, this->ReachEnds
        };
        if (cache.PartsData != cache.Data)
        {
          cache.Parts = findParts(mesh.Surface, mesh.Neighbours);
          cache.PartsData = cache.Data;
        }
        const std::vector<char> region = detectRegion(mesh.Surface,
          mesh.Neighbours,
          mesh.Normals,
          cache.Parts,
          evidence,
          options,
          ContextOf(this, 0.4, 1.0));
        std::vector<char> isSeed(region.size(), 0);
        for (int seed : seeds)
        {
          isSeed[seed] = 1;
        }
        std::vector<double> probability(region.size());
        std::transform(evidence.ratio.begin(),
          evidence.ratio.end(),
          probability.begin(),
          [](double ratio) { return 1.0 / (1.0 + std::exp(-ratio)); });
        cache.Arrays = { ArrayOf<vtkUnsignedCharArray>("Region", region),
          ArrayOf<vtkUnsignedCharArray>("RegionSeed", isSeed),
          ArrayOf<vtkDoubleArray>("RegionProbability", probability) };
        cache.GrowthRead = growthKey;
        cache.SectionRead = section;
      }
      output->ShallowCopy(input);
      for (const auto& array : cache.Arrays)
      {
        output->GetPointData()->AddArray(array);
      }
    });
}

void vtkOversketchMixtureRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lambda: " << this->Lambda << '\n'
     << indent << "SeedTolerance: " << this->SeedTolerance << '\n'
     << indent << "SeedMargin: " << this->SeedMargin << '\n'
     << indent << "FillIslands: " << (this->FillIslands ? "On" : "Off") << '\n'
     << indent << "LimitRunaway: " << (this->LimitRunaway ? "On" : "Off") << '\n'
     << indent << "CutAtJunction: " << (this->CutAtJunction ? "On" : "Off") << '\n'
     << indent << "ReachEnds: " << (this->ReachEnds ? "On" : "Off") << '\n'
     << indent << "Components: " << this->Components << '\n'
     << indent << "MaximumSamples: " << this->MaximumSamples << '\n'
     << indent << "Seed: " << this->Seed << '\n'
     << indent << "Backend: " << this->Backend << '\n'
     << indent << "BackendUsed: " << this->BackendUsed << '\n'
     << indent << "WholeFitCount: " << this->WholeFitCount << '\n'
     << indent << "GrowthCount: " << this->GrowthCount << '\n'
     << indent << "WholeSampleCount: " << this->WholeSampleCount << '\n';
}
