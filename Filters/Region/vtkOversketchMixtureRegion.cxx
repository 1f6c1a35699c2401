#include "vtkOversketchMixtureRegion.h"

#include "Mixture/mixture.h"
#include "OpenCL/device.h"
#include "Region/border.h"
#include "Region/grow.h"
#include "vtkOversketchDiametersOnDemand.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchHandleSection.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

using namespace oversketch;

namespace
{

// What the whole mesh's mixture depends on besides the mesh and its diameters: components, samples, seed,
// whether they are even, back end.
using FitKey = std::tuple<int, int, bool, int>;
// What the region depends on besides that: lambda, tolerance, section and end length, shift, what is near,
// amendments.
using GrowthKey = std::tuple<double, double, double, double, double, bool, bool, bool, bool, bool>;

std::vector<double> DiametersOf(vtkDataArray* array)
{
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!std::isfinite(values[i]))
    {
      throw Error(Failure::BadMesh,
        "Array ShapeDiameter of the mesh is not finite at point %1; compute it with "
        "vtkOversketchShapeDiameter.",
        i);
    }
  }
  return values;
}

std::vector<int> AllOf(int count)
{
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Of the mean thickness. On tessellated spheres the rays' deviation is up to 0.6 %, on tori the thickness'
// own 1.7 %; of an egg a seventh longer than wide it is 2.6 %, of what has limbs 20 % and more.
constexpr double noise = 0.02;

// Rings round the region whose diameters are known: those that vtkOversketchRegionBorder may take in, the
// triangles that are remeshed round these, and one to spare.
constexpr int knownRings = 4;

// Points of a mesh whose rays are given back once a region is found: the steps that follow need the memory.
constexpr int manyPoints = 250000;

constexpr int mostSamples = 2048; // for a mixture
// How far from a seed a sample for the mixture of too few seeds may lie, along edges, of half the bounding
// box's diagonal: the paper's tolerance, whose unit is not told.
constexpr double seedTolerance = 0.1;

// The vertices by how far they lie from the middle of their surface: the same order for a turned model.
std::vector<int> Outwards(const Mesh& mesh,
  const std::vector<double>& areas,
  const std::vector<int>& vertices)
{
  Vector3 middle = Vector3::Zero();
  double area = 0.0;
  for (const int v : vertices)
  {
    middle += areas[static_cast<std::size_t>(v)] * mesh.points[static_cast<std::size_t>(v)];
    area += areas[static_cast<std::size_t>(v)];
  }
  middle /= area > 0.0 ? area : 1.0;
  std::vector<std::pair<double, int>> sorted;
  sorted.reserve(vertices.size());
  for (const int v : vertices)
  {
    sorted.emplace_back((mesh.points[static_cast<std::size_t>(v)] - middle).norm(), v);
  }
  // In halves, so that two threads can.
  const auto half = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  ThreadsOnly().each(
    2, [&](int which) { std::sort(which == 0 ? sorted.begin() : half, which == 0 ? half : sorted.end()); });
  std::inplace_merge(sorted.begin(), half, sorted.end());
  std::vector<int> order;
  order.reserve(sorted.size());
  std::transform(
    sorted.begin(), sorted.end(), std::back_inserter(order), [](const auto& one) { return one.second; });
  return order;
}

double MedianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The standard deviation of values, each less by an offset, as a share of their mean.
double DeviationOf(const std::vector<double>& values, double offset)
{
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / count) / (mean + offset);
}

} // namespace

struct vtkOversketchMixtureRegion::Cache
{
  std::shared_ptr<const MeshData> Data, PartsData;
  MeshParts Parts; // of PartsData
  // The whole mesh.
  MeshKey MeshRead;
  FitKey FitRead;
  std::vector<int> PartsRead; // whose vertices it is fitted to, ascending; empty: all
  vtkSmartPointer<vtkOversketchDiametersOnDemand> OnDemand; // where diameters are computed as they are read
  std::vector<double> Diameters;                            // 0 where not asked for yet
  double Low = 0.0, Range = 0.0;                            // of the diameters that the mixture is fitted to
  double Diagonal = 0.0;                                    // of the box of these vertices
  double Deviation = 0.0;                                   // of the samples, as a share of their mean
  Mixture Whole;
  // The region.
  GrowthKey GrowthRead;
  Section SectionRead;
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; // empty: none kept

  const MeshParts& PartsOf();
  // Makes the diameters of these vertices known, which are returned.
  std::vector<double> Require(const std::vector<int>& vertices, const Context& context);
  double Scaled(double diameter) const
  {
    return this->Range > 0.0 ? (diameter - this->Low) / this->Range : 0.0;
  }
  MixtureFit Fit(vtkOversketchMixtureRegion* self, const std::vector<double>& samples, int components);
  // The parts of the mesh that hold vertices, ascending.
  std::vector<int> PartsWith(const std::vector<int>& vertices);
  // Makes Whole of the diameters, of these parts of the mesh (none: of all).
  void FitWhole(vtkOversketchMixtureRegion* self, vtkDataArray* diameters, const std::vector<int>& parts);
  // Takes the mesh, and gives its diameters.
  vtkDataArray* Take(vtkPolyData* input);
  // The same where it is not there.
  void ProvideWhole(vtkOversketchMixtureRegion* self, vtkPolyData* input, const std::vector<int>& parts);
  // The mixture of what the seeds stand for.
  Mixture Foreground(vtkOversketchMixtureRegion* self, const std::vector<int>& seeds);
  // Whether the thickness is the same everywhere but for noise, which is to say nothing.
  bool IsEven(vtkOversketchMixtureRegion* self) const { return self->IgnoreNoise && this->Deviation < noise; }
  // The ratios where it is: for what is so near to a seed, and against all else.
  std::vector<double> RatiosNear(const std::vector<int>& seeds, double near);
  double LongestEdge(const std::vector<int>& seeds) const; // at one of them
  // Makes Arrays of the section.
  void Grow(vtkOversketchMixtureRegion* self,
    const Section& section,
    double sectionLength,
    double endLength,
    double shift,
    double near);
};

const MeshParts& vtkOversketchMixtureRegion::Cache::PartsOf()
{
  if (this->PartsData != this->Data)
  {
    this->Parts = findParts(this->Data->Surface(), this->Data->Neighbours(), ThreadsOnly());
    this->PartsData = this->Data;
  }
  return this->Parts;
}

// On the device where the back end asks for it; should it be missing or fail, on the host, with a warning.
MixtureFit vtkOversketchMixtureRegion::Cache::Fit(vtkOversketchMixtureRegion* self,
  const std::vector<double>& samples,
  int components)
{
  MixtureOptions options;
  options.components = components;
  Message warning;
  if (const auto device = Device::choose(self->KernelBackend(), warning))
  {
    try
    {
      MixtureFit fit = fitMixtureOnDevice(*device, samples, options);
      self->UsedBackend(Backend::OpenCL);
      return fit;
    }
    catch (const Error& error)
    {
      warning = { "%1 The host computes instead.", error.message() };
    }
  }
  if (!warning.empty())
  {
    Warn(self, warning);
  }
  self->UsedBackend(Backend::Host);
  return fitMixture(samples, options, ContextOf(self, 0.0, 0.4));
}

std::vector<int> vtkOversketchMixtureRegion::Cache::PartsWith(const std::vector<int>& vertices)
{
  const MeshParts& parts = this->PartsOf();
  std::vector<int> held;
  std::transform(vertices.begin(),
    vertices.end(),
    std::back_inserter(held),
    [&parts](int v) { return parts.of[static_cast<std::size_t>(v)]; });
  sortUnique(held);
  return static_cast<int>(held.size()) == parts.count ? std::vector<int>() : held;
}

std::vector<double> vtkOversketchMixtureRegion::Cache::Require(const std::vector<int>& vertices,
  const Context& context)
{
  if (this->OnDemand)
  {
    this->OnDemand->Require(vertices, context);
    for (const int v : vertices)
    {
      this->Diameters[static_cast<std::size_t>(v)] = this->OnDemand->GetValue(v);
    }
  }
  return valuesAt(this->Diameters, vertices);
}

void vtkOversketchMixtureRegion::Cache::FitWhole(vtkOversketchMixtureRegion* self,
  vtkDataArray* diameters,
  const std::vector<int>& parts)
{
  const Mesh& mesh = this->Data->Surface();
  const int count = mesh.vertexCount();
  this->OnDemand = vtkOversketchDiametersOnDemand::SafeDownCast(diameters);
  this->Diameters =
    this->OnDemand ? std::vector<double>(static_cast<std::size_t>(count), 0.0) : DiametersOf(diameters);
  const auto isOf = [&](int v)
  {
    return parts.empty() ||
           std::binary_search(parts.begin(), parts.end(), this->PartsOf().of[static_cast<std::size_t>(v)]);
  };
  std::vector<int> fitted;
  const std::vector<int> all = AllOf(count);
  std::copy_if(all.begin(), all.end(), std::back_inserter(fitted), isOf);
  Eigen::AlignedBox3d box;
  for (const int v : fitted)
  {
    box.extend(mesh.points[static_cast<std::size_t>(v)]);
  }
  this->Diagonal = box.isEmpty() ? 0.0 : box.diagonal().norm();
  if (self->EvenSamples)
  {
    const std::vector<double>& areas = this->PartsOf().areas;
    fitted = Outwards(mesh, areas, fitted);
    std::vector<int> even = evenItems(valuesAt(areas, fitted), mostSamples);
    std::transform(even.begin(),
      even.end(),
      even.begin(),
      [&](int item) { return fitted[static_cast<std::size_t>(item)]; });
    fitted = even;
  }
  std::vector<double> samples = this->Require(fitted, ContextOf(self, 0.0, 0.3));
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  this->Low = samples.empty() ? 0.0 : *low;
  this->Range = samples.empty() ? 0.0 : *high - *low;
  if (!self->EvenSamples)
  {
    samples = valuesAt(samples, drawWithoutReplacement(count, mostSamples, self->Seed));
  }
  std::transform(
    samples.begin(), samples.end(), samples.begin(), [this](double d) { return this->Scaled(d); });
  ++self->WholeFitCount;
  self->WholeSampleCount = static_cast<vtkIdType>(samples.size());
  this->Deviation = DeviationOf(samples, this->Range > 0.0 ? this->Low / this->Range : 1.0);
  this->Whole = this->Fit(self, samples, self->Components).mixture;
}

Mixture vtkOversketchMixtureRegion::Cache::Foreground(vtkOversketchMixtureRegion* self,
  const std::vector<int>& seeds)
{
  const MeshData& mesh = *this->Data;
  const std::vector<int> around = expandSeeds(mesh.Surface(),
    mesh.Neighbours(),
    seeds,
    3 * static_cast<std::size_t>(self->Components),
    seedTolerance * 0.5 * this->Diagonal);
  std::vector<double> samples = this->Require(around, ThreadsOnly());
  std::transform(
    samples.begin(), samples.end(), samples.begin(), [this](double d) { return this->Scaled(d); });
  samples =
    self->EvenSamples
      ? evenSamples(samples, mostSamples)
      : valuesAt(samples, drawWithoutReplacement(static_cast<int>(samples.size()), mostSamples, self->Seed));
  return this->Fit(self, samples, std::clamp(static_cast<int>(samples.size()) / 3, 1, self->Components))
    .mixture;
}

double vtkOversketchMixtureRegion::Cache::LongestEdge(const std::vector<int>& seeds) const
{
  const std::vector<Vector3>& points = this->Data->Surface().points;
  const Lists& lists = this->Data->Neighbours().vertexVertices;
  double longest = 0.0;
  for (const int seed : seeds)
  {
    for (const int n : lists[seed])
    {
      const auto a = static_cast<std::size_t>(n), b = static_cast<std::size_t>(seed);
      longest = std::max(longest, (points[a] - points[b]).norm());
    }
  }
  return longest;
}

std::vector<double> vtkOversketchMixtureRegion::Cache::RatiosNear(const std::vector<int>& seeds, double near)
{
  constexpr double all = std::numeric_limits<double>::infinity();
  std::vector<double> ratios = edgeDistances(this->Data->Surface(), this->Data->Neighbours(), seeds, near);
  std::transform(ratios.begin(),
    ratios.end(),
    ratios.begin(),
    [](double away) { return std::isfinite(away) ? all : -all; });
  return ratios;
}

void vtkOversketchMixtureRegion::Cache::Grow(vtkOversketchMixtureRegion* self,
  const Section& section,
  double sectionLength,
  double endLength,
  double shift,
  double near)
{
  const MeshData& mesh = *this->Data;
  const int count = mesh.Surface().vertexCount();
  RegionEvidence evidence{ section.seeds,
    std::vector<double>(static_cast<std::size_t>(count), std::numeric_limits<double>::quiet_NaN()),
    this->Diameters,
    sectionLength,
    section.ends,
    endLength };
  const bool even = this->IsEven(self);
  near = even ? std::max(near, this->LongestEdge(section.seeds)) : near;
  if (even)
  {
    evidence.ratio = this->RatiosNear(section.seeds, near);
  }
  const Context growing = ContextOf(self, 0.4, 1.0), quiet = ContextOf(self, 0.4, 0.4);
  const LogDensity ofForeground(
    even || section.seeds.empty() ? this->Whole : this->Foreground(self, section.seeds)),
    ofWhole(this->Whole);
  evidence.require = [&](const std::vector<int>& vertices)
  {
    const std::vector<double> found = this->Require(vertices, quiet);
    ThreadsOnly().each(static_cast<int>(vertices.size()),
      [&](int i)
      {
        const auto v = static_cast<std::size_t>(vertices[static_cast<std::size_t>(i)]);
        evidence.diameter[v] = found[static_cast<std::size_t>(i)];
        const double scaled = this->Scaled(evidence.diameter[v]);
        evidence.ratio[v] =
          std::isnan(evidence.ratio[v]) ? ofForeground(scaled) - ofWhole(scaled) : evidence.ratio[v];
      });
  };
  if (!this->OnDemand)
  {
    evidence.require(AllOf(count));
  }
  const RegionOptions options{ self->Lambda,
    self->FillIslands,
    self->LimitRunaway,
    self->CutAtJunction && !even,
    self->ReachEnds,
    near,
    shift };
  const std::vector<char> region = detectRegion(
    mesh.Surface(), mesh.Neighbours(), mesh.Normals(), this->PartsOf(), evidence, options, growing);
  std::vector<char> isSeed = marksAt(section.seeds, region.size());
  if (this->OnDemand)
  {
    const std::vector<char> known = withinRings(mesh.Neighbours(), marked(region), knownRings);
    const std::vector<int> vertices = marked(known);
    evidence.require(vertices);
    if (count > manyPoints)
    {
      this->OnDemand->Rest();
    }
    std::vector<double> values(known.size(), 0.0);
    for (const int v : vertices)
    {
      values[static_cast<std::size_t>(v)] = evidence.diameter[static_cast<std::size_t>(v)];
    }
    this->Arrays = { ArrayOf<vtkDoubleArray>("ShapeDiameter", values),
      ArrayOf<vtkUnsignedCharArray>("ShapeDiameterKnown", known) };
    for (std::size_t v = 0; v < known.size(); ++v)
    {
      // Vertices beyond, which growing has foreseen, are left out: which they are depends on earlier strokes.
      evidence.ratio[v] = known[v] ? evidence.ratio[v] : -std::numeric_limits<double>::infinity();
    }
  }
  std::vector<double> probability(region.size());
  ContextOf(self).parallelFor(mesh.Surface().vertexCount(),
    [&](int begin, int end)
    {
      std::transform(evidence.ratio.begin() + begin,
        evidence.ratio.begin() + end,
        probability.begin() + begin,
        [](double ratio) { return 1.0 / (1.0 + std::exp(-ratio)); });
    });
  this->Arrays.insert(this->Arrays.end(),
    { ArrayOf<vtkUnsignedCharArray>("Region", region),
      ArrayOf<vtkUnsignedCharArray>("RegionSeed", isSeed),
      ArrayOf<vtkDoubleArray>("RegionProbability", probability) });
}

vtkStandardNewMacro(vtkOversketchMixtureRegion);

vtkDataArray* vtkOversketchMixtureRegion::Cache::Take(vtkPolyData* input)
{
  this->Data = SharedMesh(input);
  return RequireArray(input->GetPointData(),
    "ShapeDiameter",
    1,
    input->GetNumberOfPoints(),
    "mesh",
    "compute it with vtkOversketchShapeDiameter");
}

void vtkOversketchMixtureRegion::Cache::ProvideWhole(vtkOversketchMixtureRegion* self,
  vtkPolyData* input,
  const std::vector<int>& parts)
{
  vtkDataArray* diameters = this->Take(input);
  const MeshKey meshKey(input, { diameters, input->GetPointData()->GetNormals() });
  const FitKey fitKey(self->Components, self->Seed, self->EvenSamples, self->GetBackend());
  if (this->MeshRead != meshKey || this->FitRead != fitKey || this->PartsRead != parts || this->Whole.empty())
  {
    this->Whole.clear();
    this->Arrays.clear();
    this->FitWhole(self, diameters, parts);
    this->MeshRead = meshKey;
    this->FitRead = fitKey;
    this->PartsRead = parts;
  }
}

void vtkOversketchMixtureRegion::Prepare()
{
  auto* input = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
  Cache& cache = this->Kept<Cache>();
  if (input && input->GetNumberOfPoints() > 0)
  {
    RunFilter(this,
      [&]
      {
        cache.Take(input);
        // Of several parts the section tells which count.
        if (!this->EvenSamples || cache.PartsOf().count == 1)
        {
          cache.ProvideWhole(this, input, {});
        }
      });
  }
}

void vtkOversketchMixtureRegion::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* handles = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  Cache& cache = this->Kept<Cache>();
  cache.Take(input);
  const Section section = SectionOf(
    handles, *cache.Data, this->SeedMargin, this->ReachEnds, this->ReachEnds || this->ConfineToSection);
  const double sectionLength = this->LimitRunaway ? SectionLengthOf(handles) : 0.0;
  // Edge paths are up to half as long again as the way, and a foreshortened end as it looks.
  const double endLength = this->ReachEnds ? 2.0 * this->SeedMargin * SectionLengthOf(handles) : 0.0;
  const double shift = this->Reach != 0.0 ? this->Reach * SectionLengthOf(handles) : 0.0;
  cache.ProvideWhole(this, input, this->EvenSamples ? cache.PartsWith(section.seeds) : std::vector<int>());
  const double diameter = section.seeds.empty() ? 0.0 : MedianOf(cache.Require(section.seeds, ThreadsOnly()));
  const bool near =
    cache.IsEven(this) || (this->ConfineToSection && !OfLimb(section, SectionLengthOf(handles), diameter));
  const double nearness = near ? NearOf(section, SectionLengthOf(handles), diameter) : 0.0;

  const GrowthKey growthKey(this->Lambda,
    sectionLength,
    endLength,
    shift,
    nearness,
    this->FillIslands,
    this->LimitRunaway,
    this->CutAtJunction,
    this->ReachEnds,
    this->IgnoreNoise);
  if (cache.Arrays.empty() || cache.GrowthRead != growthKey || cache.SectionRead.seeds != section.seeds ||
      cache.SectionRead.ends != section.ends)
  {
    cache.Arrays.clear();
    ++this->GrowthCount;
    cache.Grow(this, section, sectionLength, endLength, shift, nearness);
    cache.GrowthRead = growthKey;
    cache.SectionRead = section;
  }
  output->ShallowCopy(input);
  for (const auto& array : cache.Arrays)
  {
    output->GetPointData()->AddArray(array);
  }
}

void vtkOversketchMixtureRegion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lambda: " << this->Lambda << '\n'
     << indent << "SeedMargin: " << this->SeedMargin << '\n'
     << indent << "FillIslands: " << (this->FillIslands ? "On" : "Off") << '\n'
     << indent << "LimitRunaway: " << (this->LimitRunaway ? "On" : "Off") << '\n'
     << indent << "CutAtJunction: " << (this->CutAtJunction ? "On" : "Off") << '\n'
     << indent << "ReachEnds: " << (this->ReachEnds ? "On" : "Off") << '\n'
     << indent << "ConfineToSection: " << (this->ConfineToSection ? "On" : "Off") << '\n'
     << indent << "Reach: " << this->Reach << '\n'
     << indent << "EvenSamples: " << (this->EvenSamples ? "On" : "Off") << '\n'
     << indent << "IgnoreNoise: " << (this->IgnoreNoise ? "On" : "Off") << '\n'
     << indent << "Components: " << this->Components << '\n'
     << indent << "Seed: " << this->Seed << '\n'
     << indent << "WholeFitCount: " << this->WholeFitCount << '\n'
     << indent << "GrowthCount: " << this->GrowthCount << '\n'
     << indent << "WholeSampleCount: " << this->WholeSampleCount << '\n';
}
