// A drawing becomes a model: the path along a picture's edges beside OpenCV's intelligent scissors, distance
// and thickness beside OpenCV's distance transform, the whole, new and after one change, and each outline of
// the acceptance run, new and with a feature more. run.sh writes the outlines into the folder "outlines" of
// OVERSKETCH_BENCHMARKS; without them their rows are left out.
#include "benchmark_frame.h"

#include "vtkOversketchInflate.h"
#include "vtkOversketchInflateDrawing.h"

#include "Raster/distance_maps.h"
#include "Stroke/livewire.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkXMLPolyDataReader.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/segmentation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>

namespace oversketch_bench
{

namespace
{

constexpr double turn = 6.283185307179586;

Polyline ring(double x, double y, double radius, int count, double wobble = 0.0)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = turn * i / count, away = radius + wobble * std::sin(7.0 * angle);
    points.emplace_back(x + away * std::cos(angle), y + away * std::sin(angle));
  }
  return points;
}

// A picture of 1024 x 1024 of discs, a stroke beside the edge of one, and the features as OpenCV takes them.
struct Scene
{
  static constexpr int side = 1024;
  EdgeFeatures features;
  Polyline stroke = ring(512, 512, 300, 600, 4.0);
  std::vector<int> seeds;
  cv::segmentation::IntelligentScissorsMB scissors;

  Scene()
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0.0, side), size(20.0, 80.0), grey(0.0, 255.0);
    std::vector<std::array<double, 4>> discs{ { 512, 512, 300, 200 } };
    for (int i = 0; i < 40; ++i)
    {
      const double x = place(random), y = place(random), radius = size(random);
      discs.push_back({ x, y, radius, grey(random) });
    }
    std::vector<std::uint8_t> values;
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        double value = 30.0;
        for (const auto& disc : discs)
        {
          value = std::hypot(x - disc[0], y - disc[1]) < disc[2] ? disc[3] : value;
        }
        values.push_back(static_cast<std::uint8_t>(value));
      }
    }
    this->features = edgeFeatures(values, side, side);
    for (int i = 0; i < 600; i += 12)
    {
      this->seeds.push_back(i);
    }
    cv::Mat plain(side, side, CV_8UC1), direction(side, side, CV_32FC2), flat(side, side, CV_32FC1);
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        const std::size_t i = static_cast<std::size_t>(y) * side + x;
        const EdgeFeatures& f = this->features;
        const float g = f.magnitude[i];
        plain.at<std::uint8_t>(y, x) = f.edges[i] ? 0 : 1;
        direction.at<cv::Vec2f>(y, x) =
          g > 0.0f ? cv::Vec2f(f.gx[i] / g, f.gy[i] / g) : cv::Vec2f(0.0f, 0.0f);
        flat.at<float>(y, x) = 1.0f - g / f.greatest;
      }
    }
    this->scissors.applyImageFeatures(plain, direction, flat);
  }
};

Scene& scene()
{
  static Scene made;
  return made;
}

// How far points are from the disc's edge on average [px].
double offEdge(const Polyline& points)
{
  double sum = 0.0;
  for (const Vector2& p : points)
  {
    sum += std::abs((p - Vector2(512, 512)).norm() - 300.0);
  }
  return sum / static_cast<double>(points.size());
}

// OpenCV's way round the disc, from seed to seed as ours.
Polyline roundByScissors()
{
  const auto seed = [](std::size_t number)
  {
    const Vector2& p = scene().stroke[static_cast<std::size_t>(scene().seeds[number % scene().seeds.size()])];
    return cv::Point(cvRound(p[0]), cvRound(p[1]));
  };
  Polyline made;
  for (std::size_t i = 0; i < scene().seeds.size(); ++i)
  {
    std::vector<cv::Point> contour;
    scene().scissors.buildMap(seed(i));
    scene().scissors.getContour(seed(i + 1), contour);
    for (const cv::Point& p : contour)
    {
      made.emplace_back(p.x, p.y);
    }
  }
  return made;
}

// A ring of 1028 x 1028 samples with two holes in it.
struct Shape
{
  Frame frame{ Vector2::Zero(), 1.0, 1028, 1028 };
  std::vector<Rim> rims{ { ring(514, 514, 480, 3000, 12.0), 0 },
    { ring(400, 560, 90, 600), 0 },
    { ring(690, 480, 120, 800), 0 } };
  DistanceMaps maps;
  cv::Mat black = cv::Mat(1028, 1028, CV_8UC1), theirs = cv::Mat(1028, 1028, CV_32FC1);

  Shape()
  {
    this->maps = distanceTo(this->frame, this->rims, Context());
    for (int y = 0; y < this->frame.height; ++y)
    {
      for (int x = 0; x < this->frame.width; ++x)
      {
        this->black.at<std::uint8_t>(y, x) = this->maps.distance[this->frame.index(x, y)] > 0.0f ? 1 : 0;
      }
    }
  }
};

Shape& shape()
{
  static Shape made;
  return made;
}

// The shipped fish, whole, with one feature less, and with its outline two px lower over a tenth of it.
struct Drawing
{
  vtkSmartPointer<vtkPolyData> whole, fewer, moved;
  vtkSmartPointer<vtkOversketchInflateDrawing> filter;

  Drawing()
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(OVERSKETCH_DATA_FOLDER "/Drawings/fish.vtp");
    reader->Update();
    this->whole = reader->GetOutput();
    this->fewer = vtkSmartPointer<vtkPolyData>::New();
    const vtkIdType last = this->whole->GetNumberOfCells() - 1;
    this->fewer->SetPoints(this->whole->GetPoints());
    vtkNew<vtkCellArray> lines;
    this->fewer->GetCellData()->CopyAllocate(this->whole->GetCellData());
    for (vtkIdType cell = 0; cell < last; ++cell)
    {
      lines->InsertNextCell(this->whole->GetCell(cell));
      this->fewer->GetCellData()->CopyData(this->whole->GetCellData(), cell, cell);
    }
    this->fewer->SetLines(lines);
    this->fewer->SetFieldData(this->whole->GetFieldData());
    this->moved = vtkSmartPointer<vtkPolyData>::New();
    this->moved->DeepCopy(this->whole);
    vtkPoints* points = this->moved->GetPoints();
    vtkNew<vtkIdList> outline;
    this->moved->GetCellPoints(0, outline);
    const vtkIdType part = outline->GetNumberOfIds() / 10;
    for (vtkIdType i = 0; i < part; ++i)
    {
      double p[3];
      points->GetPoint(outline->GetId(i), p);
      p[1] -= 2.0 * std::sin(0.5 * turn * static_cast<double>(i) / static_cast<double>(part));
      points->SetPoint(outline->GetId(i), p);
    }
  }
  void anew() { this->filter = vtkSmartPointer<vtkOversketchInflateDrawing>::New(); }
  void run(vtkPolyData* drawing)
  {
    this->filter->SetInputData(0, drawing);
    this->filter->Update();
  }
  std::map<std::string, double> figures(double limit) const
  {
    return { { "limit_ms", limit },
      { "triangles", static_cast<double>(this->filter->GetOutput()->GetNumberOfPolys()) } };
  }
};

Drawing& drawing()
{
  static Drawing made;
  return made;
}

// An outline, and with it a stroke across the middle of its thickest part, half as long as that is wide.
struct Outline
{
  vtkSmartPointer<vtkPolyData> alone = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkPolyData> featured = vtkSmartPointer<vtkPolyData>::New();
  vtkSmartPointer<vtkOversketchInflateDrawing> filter;

  explicit Outline(const std::string& path)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    this->alone->ShallowCopy(reader->GetOutput());
    this->anew();
    this->run(this->alone);
    double top[3] = { 0.0, 0.0, -1.0 };
    vtkPolyData* model = this->filter->GetOutput();
    for (vtkIdType i = 0; i < model->GetNumberOfPoints(); ++i)
    {
      if (model->GetPoint(i)[2] > top[2])
      {
        model->GetPoint(i, top);
      }
    }
    this->addStroke(top, this->roomAbout(top));
  }
  void anew() { this->filter = vtkSmartPointer<vtkOversketchInflateDrawing>::New(); }
  void run(vtkPolyData* drawing)
  {
    this->filter->SetInputData(0, drawing);
    this->filter->Update();
    if (this->filter->GetOutput()->GetNumberOfPolys() == 0)
    {
      std::exit(1); // the filter has said why
    }
  }
  std::map<std::string, double> figures(double limit) const
  {
    return { { "limit_ms", limit },
      { "triangles", static_cast<double>(this->filter->GetOutput()->GetNumberOfPolys()) } };
  }

private:
  double roomAbout(const double place[3]) const
  {
    double room = 1e9;
    for (vtkIdType i = 0; i < this->alone->GetNumberOfPoints(); ++i)
    {
      const double* p = this->alone->GetPoint(i);
      room = std::min(room, std::hypot(p[0] - place[0], p[1] - place[1]));
    }
    return room;
  }
  void addStroke(const double middle[3], double length)
  {
    constexpr int count = 24;
    this->featured->DeepCopy(this->alone);
    vtkPoints* points = this->featured->GetPoints();
    vtkNew<vtkIdList> stroke;
    for (int i = 0; i < count; ++i)
    {
      const double along = static_cast<double>(i) / (count - 1) - 0.5;
      stroke->InsertNextId(points->InsertNextPoint(middle[0] + along * length, middle[1], 0.0));
    }
    const vtkIdType cell = this->featured->GetLines()->InsertNextCell(stroke);
    vtkCellData* cells = this->featured->GetCellData();
    cells->CopyAllocate(this->alone->GetCellData(), cell + 1);
    for (vtkIdType i = 0; i <= cell; ++i)
    {
      cells->CopyData(this->alone->GetCellData(), i < cell ? i : 0, i);
    }
    for (const char* name : { "Closed", "Treatment" }) // an open line that is what it shows itself to be
    {
      if (vtkDataArray* array = cells->GetArray(name))
      {
        array->SetTuple1(cell, 0.0);
      }
    }
  }
};

Job side(const std::string& job,
  const std::string& size,
  const std::string& who,
  std::function<void()> prepare,
  std::function<void()> run)
{
  Job made;
  made.job = job;
  made.size = size;
  made.who = who;
  made.threads = who == "ours" ? 2 : 1;
  made.prepare = std::move(prepare);
  made.run = std::move(run);
  return made;
}

void pathJobs()
{
  Job ours = side(
    "path along edges",
    "1024",
    "ours",
    [] { scene(); },
    [] { snapped(scene().features, scene().stroke, true, scene().seeds, {}, Context()); });
  ours.threads = 1;
  ours.figures = []
  {
    const SnappedStroke made = snapped(scene().features, scene().stroke, true, scene().seeds, {}, Context());
    return std::map<std::string, double>{ { "off_edge_before_px", offEdge(scene().stroke) },
      { "off_edge_after_px", offEdge(made.points) } };
  };
  add(ours);
  Job theirs = side(
    "path along edges",
    "1024",
    "OpenCV's map",
    [] { scene(); },
    [] { scene().scissors.buildMap(cv::Point(812, 512)); });
  theirs.figures = [] {
    return std::map<std::string, double>{ { "off_edge_after_px", offEdge(roundByScissors()) } };
  };
  add(theirs);
}

void distanceJobs()
{
  Job ours = side(
    "distance in a drawing",
    "1028",
    "ours",
    [] { shape(); },
    [] { shape().maps = distanceTo(shape().frame, shape().rims, Context()); });
  ours.threads = 1;
  ours.figures = []
  {
    Shape& s = shape();
    cv::distanceTransform(s.black, s.theirs, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    double apart = 0.0;
    for (int y = 0; y < s.frame.height; ++y)
    {
      for (int x = 0; x < s.frame.width; ++x)
      {
        apart = std::max(apart,
          std::abs(static_cast<double>(s.theirs.at<float>(y, x)) - s.maps.distance[s.frame.index(x, y)]));
      }
    }
    return std::map<std::string, double>{ { "apart_from_opencv_px", apart } };
  };
  add(ours);
  add(side(
    "distance in a drawing",
    "1028",
    "OpenCV",
    [] { shape(); },
    [] { cv::distanceTransform(shape().black, shape().theirs, cv::DIST_L2, cv::DIST_MASK_PRECISE); }));
  Job thickness = side(
    "local maximum",
    "1028",
    "ours",
    [] { shape().maps = distanceTo(shape().frame, shape().rims, Context()); },
    [] { findThickness(shape().maps, ThicknessMode::Local, Context()); });
  thickness.threads = 1;
  add(thickness);
  add(side(
    "local maximum",
    "1028",
    "the distance",
    [] { shape(); },
    [] { shape().maps = distanceTo(shape().frame, shape().rims, Context()); }));
}

// Each after a run of what was there before it.
void wholeJobs()
{
  const auto job = [](const std::string& name,
                     double limit,
                     const std::function<void(Drawing&)>& before,
                     const std::function<void(Drawing&)>& change)
  {
    Job made = side(
      name,
      "fish",
      "ours",
      [before]
      {
        drawing().anew();
        if (before)
        {
          before(drawing());
        }
      },
      [change] { change(drawing()); });
    made.figures = [limit] { return drawing().figures(limit); };
    add(made);
  };
  job("drawing: new", 400.0, {}, [](Drawing& d) { d.run(d.whole); });
  job(
    "drawing: another feature",
    150.0,
    [](Drawing& d) { d.run(d.fewer); },
    [](Drawing& d) { d.run(d.whole); });
  job(
    "drawing: moved boundary", 400.0, [](Drawing& d) { d.run(d.whole); }, [](Drawing& d) { d.run(d.moved); });
  job(
    "drawing: another height",
    150.0,
    [](Drawing& d) { d.run(d.whole); },
    [](Drawing& d)
    {
      d.filter->SetHeight(1.3);
      d.filter->Update();
    });
  job(
    "drawing: another smoothing",
    150.0,
    [](Drawing& d) { d.run(d.whole); },
    [](Drawing& d)
    {
      vtkOversketchInflate::SafeDownCast(d.filter->GetStep("Inflate"))->SetLocalMaxSmoothing(0.3);
      d.filter->Update();
    });
}

void outlineJobs()
{
  const char* folder = std::getenv("OVERSKETCH_BENCHMARKS");
  std::vector<std::filesystem::path> files;
  std::error_code none; // of the folder
  for (const auto& entry :
    std::filesystem::directory_iterator(std::filesystem::path(folder ? folder : "") / "outlines", none))
  {
    if (entry.path().extension() == ".vtp")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files)
  {
    const auto made = std::make_shared<std::unique_ptr<Outline>>();
    const auto outline = [made, file]() -> Outline&
    {
      if (!*made)
      {
        *made = std::make_unique<Outline>(file.string());
      }
      return **made;
    };
    Job whole = side(
      "drawing: new",
      file.stem().string(),
      "ours",
      [outline] { outline().anew(); },
      [outline] { outline().run(outline().alone); });
    whole.figures = [outline] { return outline().figures(400.0); };
    add(whole);
    Job feature = side(
      "drawing: another feature",
      file.stem().string(),
      "ours",
      [outline]
      {
        outline().anew();
        outline().run(outline().alone);
      },
      [outline] { outline().run(outline().featured); });
    feature.figures = [outline] { return outline().figures(150.0); };
    add(feature);
  }
}

} // namespace

void jobs()
{
  pathJobs();
  distanceJobs();
  wholeJobs();
  outlineJobs();
}

} // namespace oversketch_bench
