#include "vtkOversketchMagneticSnap.h"

#include "vtkOversketchFilterTools.h"

#include "Planar/approximate.h"
#include "Stroke/livewire.h"
#include "Stroke/resample.h"
#include "vtkOversketchCanvasTools.h"
#include "vtkOversketchKept.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

constexpr double usualRadius = 10.0; // px of the picture

// A stroke as it is searched for [px of the picture].
struct Question
{
  Polyline Pixels;
  bool Closed = false;
  std::vector<int> Seeds;
  double Radius = usualRadius;

  bool operator==(const Question& other) const
  {
    return this->Closed == other.Closed && this->Radius == other.Radius && this->Seeds == other.Seeds &&
           this->Pixels == other.Pixels;
  }
};

// Edges of the colours or of the brightness.
template <typename Array, typename Value>
EdgeFeatures edgesOf(vtkDataArray* scalars, const PicturePlace& place, bool colours)
{
  vtkNew<Array> copy;
  auto* values = Array::SafeDownCast(scalars);
  if (!values)
  {
    copy->DeepCopy(scalars);
    values = copy;
  }
  const PictureView<Value> view{
    values->GetPointer(0), place.Columns, place.Rows, scalars->GetNumberOfComponents()
  };
  return colours ? edgeFeatures(shades(view), place.Columns, place.Rows)
                 : edgeFeatures(luminance(view), place.Columns, place.Rows);
}

EdgeFeatures edgesOf(vtkImageData* picture, const PicturePlace& place, bool colours)
{
  vtkDataArray* scalars = picture->GetPointData()->GetScalars();
  if (!scalars)
  {
    throw Error(Failure::MissingArray, "The picture has no scalars: read it from a file, or name them.");
  }
  if (scalars->GetDataType() == VTK_UNSIGNED_CHAR)
  {
    return edgesOf<vtkUnsignedCharArray, std::uint8_t>(scalars, place, colours);
  }
  if (scalars->GetDataType() == VTK_UNSIGNED_SHORT)
  {
    return edgesOf<vtkUnsignedShortArray, std::uint16_t>(scalars, place, colours);
  }
  throw Error(Failure::BadStroke,
    "The picture's scalars are of type %1; give unsigned numbers of 8 or 16 bits.",
    scalars->GetDataTypeAsString());
}

// The seeds of a stroke, numbers of its samples: the approximation is made on even samples, of which each
// lies between two of its own.
std::vector<int> seedsOf(const DrawnLine& line, const Canvas& canvas)
{
  const std::vector<Blend> places = resampled(line.Samples, SampleSpacing(canvas), line.Closed);
  Polyline even;
  for (const Blend& place : places)
  {
    even.push_back(place.of(line.Samples));
  }
  std::vector<int> seeds;
  for (const int vertex : approximateAlone(even, line.Closed, canvas.longest()))
  {
    const Blend& place = places[vertex];
    const int sample = place.t < 0.5 || place.to < place.from ? place.from : place.to;
    if (seeds.empty() || sample > seeds.back())
    {
      seeds.push_back(sample);
    }
  }
  return seeds;
}

SnappedStroke asDrawn(const Polyline& points)
{
  SnappedStroke result{ points, std::vector<std::uint8_t>(points.size(), 0), {} };
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    result.origins.push_back(Blend::point(i));
  }
  return result;
}

vtkDataArray* strokeArray(vtkPolyData* curves, const char* name)
{
  return OptionalArray(curves->GetCellData(),
    name,
    1,
    curves->GetNumberOfCells(),
    "drawing",
    "it is one number for each stroke");
}

// Does the work for a stroke, whose number is put before what it says of it.
template <typename Work>
auto OfStroke(int stroke, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Error& error)
  {
    throw Error(error.failure(), Message::unusable("Stroke", stroke, { "%1.", error.message() }));
  }
}

MeshKey KeyOfScalars(vtkImageData* picture)
{
  vtkNew<vtkPolyData> none; // of which arrays are read
  return MeshKey(none, { picture ? picture->GetPointData()->GetScalars() : nullptr });
}

// Input of one execution.
struct Search
{
  Canvas Rectangle;
  std::vector<DrawnLine> Lines;
  vtkDataArray* Magnetic;
  vtkDataArray* Radii;
  vtkImageData* Picture;
  PicturePlace Place;
  LivewireRules Rules;

  Search(vtkPolyData* curves, vtkImageData* picture)
    : Rectangle(CanvasOf(curves))
    , Lines(ReadStrokes(curves, 1))
    , Magnetic(strokeArray(curves, "Magnetic"))
    , Radii(strokeArray(curves, "SnapRadius"))
    , Picture(picture)
  {
    if (picture)
    {
      this->Place = PlaceOf(picture);
    }
  }
  MeshKey ScalarsKey() const { return KeyOfScalars(this->Picture); }
  bool IsMagnetic(int stroke) const
  {
    return this->Magnetic && this->Magnetic->GetComponent(stroke, 0) != 0.0 &&
           HasLength(this->Lines[stroke].Samples);
  }
  Question Ask(int stroke) const
  {
    if (!this->Picture)
    {
      throw Error(Failure::BadStroke, "it is magnetic, and there is no picture; give one on input 1");
    }
    Question question;
    const DrawnLine& line = this->Lines[stroke];
    for (const Vector2& sample : line.Samples)
    {
      question.Pixels.push_back(this->Place.ToPixels(sample));
    }
    question.Closed = line.Closed;
    question.Radius = this->Radii ? this->Radii->GetComponent(stroke, 0) : usualRadius;
    if (!std::isfinite(question.Radius))
    {
      throw Error(Failure::BadStroke, "its {SnapRadius} is not finite; it is px of the picture");
    }
    question.Seeds = seedsOf(line, this->Rectangle);
    return question;
  }
};

} // namespace

struct vtkOversketchMagneticSnap::Cache
{
  using Answers = std::vector<std::pair<Question, SnappedStroke>>;

  KeptOutput Kept;
  StepKey FeaturesKey, RulesKey;
  std::unique_ptr<const EdgeFeatures> Features;
  Answers Known; // of this and the last run's magnetic strokes

  // The edges of the picture; found anew for another one, which answers have to be, too.
  const EdgeFeatures& Edges(vtkImageData* picture, const PicturePlace& place, bool colours, vtkIdType& count)
  {
    const StepKey key({ KeyOfScalars(picture) },
      { static_cast<double>(place.Columns), static_cast<double>(place.Rows), colours ? 1.0 : 0.0 });
    if (!this->Features || this->FeaturesKey != key)
    {
      this->Features = nullptr;
      this->Known.clear();
      this->Features = std::make_unique<const EdgeFeatures>(edgesOf(picture, place, colours));
      this->FeaturesKey = key;
      ++count;
    }
    return *this->Features;
  }
  const SnappedStroke* Find(const Question& question) const
  {
    const auto found = std::find_if(
      this->Known.begin(), this->Known.end(), [&](const auto& answer) { return answer.first == question; });
    return found == this->Known.end() ? nullptr : &found->second;
  }
};

vtkStandardNewMacro(vtkOversketchMagneticSnap);

vtkOversketchMagneticSnap::vtkOversketchMagneticSnap()
{
  this->SetNumberOfInputPorts(2);
  DeclareInput(this, 1, { Port::Image, Port::Optional });
}

void vtkOversketchMagneticSnap::Prepare()
{
  if (this->GetNumberOfInputConnections(1) == 0)
  {
    return;
  }
  this->GetInputAlgorithm(1, 0)->Update();
  auto* picture = vtkImageData::SafeDownCast(this->GetInputDataObject(1, 0));
  if (!picture || !picture->GetPointData()->GetScalars())
  {
    return;
  }
  try
  {
    this->Kept<Cache>().Edges(picture, PlaceOf(picture), !this->AsPublished, this->EdgeCount);
  }
  catch (const Error&) // whose message the stroke has
  {
  }
}

void vtkOversketchMagneticSnap::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* curves = vtkPolyData::GetData(inputs[0]);
  Search search(curves, vtkImageData::GetData(inputs[1]));
  LivewireRules& rules = search.Rules;
  if (this->AsPublished)
  {
    rules.edgeAngle = vtkMath::Pi();
    rules.sigma = 0.0;
    rules.together = false;
  }
  const double published = this->AsPublished ? 1.0 : 0.0;
  const StepKey rulesKey({}, { published });
  Cache& cache = this->Kept<Cache>();
  if (cache.RulesKey != rulesKey)
  {
    cache.Known.clear();
    cache.RulesKey = rulesKey;
  }
  const auto snap = [&](int stroke, const Context& context)
  {
    Question question = OfStroke(stroke, [&] { return search.Ask(stroke); });
    const EdgeFeatures& edges = cache.Edges(search.Picture, search.Place, rules.together, this->EdgeCount);
    const SnappedStroke* known = cache.Find(question);
    if (!known)
    {
      ++this->SnapCount;
      rules.radius = question.Radius;
      cache.Known.emplace_back(question,
        OfStroke(stroke,
          [&] { return snapped(edges, question.Pixels, question.Closed, question.Seeds, rules, context); }));
      known = &cache.Known.back().second;
    }
    return std::make_pair(std::move(question), *known);
  };
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  const PicturePlace& place = search.Place;
  cache.Kept.Provide(StepKey({ CurvesKey(curves, { "Magnetic", "SnapRadius" }), search.ScalarsKey() },
                       { published,
                         place.Origin[0],
                         place.Origin[1],
                         place.Spacing[0],
                         place.Spacing[1],
                         static_cast<double>(place.Columns),
                         static_cast<double>(place.Rows) }),
    output,
    [&](vtkPolyData* result)
    {
      Cache::Answers answers;
      std::vector<CanvasStroke> written;
      std::vector<std::vector<Blend>> places;
      const auto flags = NewArray<vtkUnsignedCharArray>("Snapped");
      const double share = 1.0 / static_cast<double>(search.Lines.size());
      for (int i = 0; i < static_cast<int>(search.Lines.size()); ++i)
      {
        const Context context = ContextOf(this, share * i, share * (i + 1));
        context.checkpoint(0.0);
        const DrawnLine& line = search.Lines[i];
        SnappedStroke stroke = asDrawn(line.Samples);
        if (search.IsMagnetic(i))
        {
          answers.push_back(snap(i, context));
          stroke = answers.back().second;
        }
        CanvasStroke curve{ {}, line.Closed };
        for (std::size_t k = 0; k < stroke.points.size(); ++k)
        {
          // What was not moved keeps its bits.
          curve.points.push_back(
            stroke.snapped[k] ? place.ToWorld(stroke.points[k]) : stroke.origins[k].of(line.Samples));
          flags->InsertNextValue(stroke.snapped[k]);
        }
        written.push_back(std::move(curve));
        places.push_back(std::move(stroke.origins));
      }
      WriteCurves(written, search.Rectangle, result);
      result->GetPointData()->AddArray(flags);
      CarryPointArrays(curves, search.Lines, places, result);
      cache.Known = std::move(answers);
    });
  PassDrawingArrays(curves, output);
}

void vtkOversketchMagneticSnap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AsPublished: " << this->AsPublished << "\n";
  os << indent << "EdgeCount: " << this->EdgeCount << "\n";
  os << indent << "SnapCount: " << this->SnapCount << "\n";
}
